#include "simclient/core/original_tests.hpp"

#include <filesystem>
#include <vector>

#include "scenario/suggest.hpp"
#include "simclient/core/client.hpp"

namespace physim::client {
namespace {

constexpr OriginalTest kTests[] = {
    {"1", "test 1: a bullet, constants", "original_test_1.toml"},
    {"2", "test 2: a level bullet, constants", "original_test_2.toml"},
    {"3", "test 3: a bullet from rest, forces", "original_test_3.toml"},
    {"3-drag", "test 3 as it was meant, with drag", "original_test_3_drag.toml"},
    {"4", "test 4: a laser", "original_test_4.toml"},
    {"5", "test 5: an artillery shell, constants", "original_test_5.toml"},
    {"6", "test 6: a shell from rest, forces", "original_test_6.toml"},
    {"6-drag", "test 6 as it was meant, with drag", "original_test_6_drag.toml"},
};

}  // namespace

std::span<const OriginalTest> original_tests() { return kTests; }

std::string shipped_scenario(std::string_view file) {
  for (const char* folder : {"scenarios/", PHYSIM_SOURCE_DIR "/scenarios/"}) {
    const std::string path = folder + std::string(file);
    if (std::filesystem::exists(path)) return path;
  }
  return "scenarios/" + std::string(file);
}

Status open_original_test(Client& client, std::string_view name) {
  std::vector<std::string_view> names;
  for (const OriginalTest& test : kTests) {
    names.push_back(test.name);
    if (test.name != name) continue;
    if (Status status = client.open(shipped_scenario(test.file)); !status) return status;
    if (Status status = client.fire_scenario(); !status) return status;
    client.plots = *parse_plots("z y vz vy");  // z is downrange there
    client.bottom = BottomPanel::plots;
    return {};
  }
  return Error{"there is no test " + in_quotes(name), "test", suggestion(name, names, "tests")};
}

}  // namespace physim::client
