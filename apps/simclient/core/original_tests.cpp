#include "simclient/core/original_tests.hpp"

#include <filesystem>
#include <vector>

#include "scenario/suggest.hpp"
#include "simclient/core/client.hpp"

namespace physim::client {
namespace {

// z is downrange there. Gravity is what accelerates in constants mode, and the push above all in force mode.
constexpr std::string_view kConstants = "z y vz vy ay speed", kForces = "z y vz vy az speed";

constexpr OriginalTest kTests[] = {
    {"1", "test 1: a bullet, constants", "original_test_1.toml", kConstants},
    {"2", "test 2: a level bullet, constants", "original_test_2.toml", kConstants},
    {"3", "test 3: a bullet from rest, forces", "original_test_3.toml", kForces},
    {"3-drag", "test 3 as it was meant, with drag", "original_test_3_drag.toml", kForces},
    {"4", "test 4: a laser", "original_test_4.toml", kConstants},
    {"5", "test 5: an artillery shell, constants", "original_test_5.toml", kConstants},
    {"6", "test 6: a shell from rest, forces", "original_test_6.toml", kForces},
    {"6-drag", "test 6 as it was meant, with drag", "original_test_6_drag.toml", kForces},
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
    client.plots = *parse_plots(test.plots);
    client.bottom = BottomPanel::plots;
    return {};
  }
  return Error{"there is no test " + in_quotes(name), "test", suggestion(name, names, "tests")};
}

}  // namespace physim::client
