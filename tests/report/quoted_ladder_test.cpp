// README's table of three shots: its errors are those of today's library, as flights and as steps of a world.
#include <array>
#include <fstream>
#include <map>
#include <regex>
#include <sstream>

#include "report/ladder.hpp"
#include "report/world_steps.hpp"
#include "support.hpp"

namespace physim::report::report_quoted_ladder_test {

constexpr std::array kShots = {"308_168gr_g7", "golf_drive", "105mm_m1_six_dof"};

/// A quoted error, "1.7 m" or "33 nm", in m, and half of its last digit.
struct Quoted {
  double value = 0, half = 0;
};
Quoted read(const std::string& text) {
  static const std::regex kNumber(R"(([0-9.]+) ?(m|mm|um|nm)?$)");
  std::smatch parts;
  EXPECT_TRUE(std::regex_search(text, parts, kNumber)) << text;
  const std::map<std::string, double> units = {{"", 1}, {"m", 1}, {"mm", 1e-3}, {"um", 1e-6}, {"nm", 1e-9}};
  const std::string number = parts[1];
  const std::size_t point = number.find('.');
  double last = point == std::string::npos ? 1 : std::pow(10, -static_cast<double>(number.size() - point - 1));
  for (std::size_t i = number.size(); point == std::string::npos && i > 1 && number[i - 1] == '0'; --i) last *= 10;
  const double unit = units.at(parts[2]);
  return {std::stod(number) * unit, 0.5 * last * unit};
}

/// The rows of the table: the preset, and six figures "cost, error".
std::map<std::string, std::vector<std::string>> rows() {
  std::ifstream file(PHYSIM_SOURCE_DIR "/README.md");
  std::map<std::string, std::vector<std::string>> rows;
  bool inside = false;
  for (std::string line; std::getline(file, line);) {
    inside = line.starts_with("| preset | .308") || (inside && line.starts_with("|"));
    if (!inside || !line.starts_with("| `")) continue;
    std::istringstream cells(line.substr(1));
    std::vector<std::string> words;
    for (std::string cell; std::getline(cells, cell, '|');) words.push_back(cell.substr(1, cell.find_last_not_of(' ')));
    const std::string name = words[0].substr(1, words[0].size() - 2);
    rows[name] = {words.begin() + 1, words.end()};
  }
  return rows;
}

void expect_quoted(const std::string& text, double error, const std::string& what) {
  const Quoted quoted = read(text);
  EXPECT_NEAR(quoted.value, error, 1.01 * quoted.half + 1e-11) << what << ": " << text;
}

TEST(QuotedLadder, errors_of_three_shots_are_todays_as_flights_and_as_steps) {
  const auto quoted = rows();
  EXPECT_EQ(quoted.size(), 7U);
  for (std::size_t i = 0; i < kShots.size(); ++i) {
    const auto scenario = must(load_scenario(PHYSIM_SOURCE_DIR "/scenarios/" + std::string(kShots[i]) + ".toml"));
    const auto ladder = must(climb_presets(scenario, scenario.shots.front()));
    WorldDef def = scenario.world.def;
    def.environment = scenario.environment;
    ScenarioShot shot = scenario.shots.front();
    const auto compared = must(compare(shot.projectile, shot.launch, scenario.environment, {},
                                       reference_setting(scenario, shot), scenario.until));
    shot.launch = compared.launch;  // along the bore of the reference, as all rows
    const Flight& reference = compared.reference;
    for (const RungResult& result : ladder.rungs) {
      const std::string name = result.rung.name(), what = std::string(kShots[i]) + ", " + name;
      ASSERT_TRUE(quoted.contains(name)) << name;
      ASSERT_EQ(quoted.at(name).size(), 6U) << name;
      expect_quoted(quoted.at(name)[i], result.error, what + ", flight");
      shot.projectile.fidelity = result.rung.setting.fidelity;
      const auto steps = must(error_of_steps(def, shot, kGameFrame, reference), what);
      expect_quoted(quoted.at(name)[3 + i], steps, what + ", steps of a world");
    }
  }
}

}  // namespace physim::report::report_quoted_ladder_test
