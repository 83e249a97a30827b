// Every shipped scenario through every command that takes it: as a flight, compared, as a table, in every format, as a
// world, recorded and replayed.
#include <regex>

#include "cli/program.hpp"
#include "shipped.hpp"

#ifdef PHYSIM_CLI

namespace physim::testing_cli::cli_every_scenario_test {

/// Why a command refuses a shipped scenario, or is left out here; empty where it goes through.
struct Exception {
  const char* scenario;
  const char* command;
  const char* words;  // of the error; "" where it would only take long
};
constexpr Exception kExceptions[] = {
    // Straight up and down, to and fro, or around the Earth, there is no range.
    {"cannonball_galileo", "table", "no range to show"},
    {"low_orbit", "table", "no range to show"},
    {"nesc_case01", "table", "no range to show"},
    {"nesc_case02", "table", "no range to show"},
    {"nesc_case03", "table", "no range to show"},
    {"nesc_case04", "table", "no range to show"},
    {"nesc_case05", "table", "no range to show"},
    {"nesc_case06", "table", "no range to show"},
    {"nesc_case07", "table", "no range to show"},
    {"nesc_case08", "table", "no range to show"},
    {"use_firework", "table", "no range to show"},
    {"use_hail", "table", "no range to show"},
    {"study_hail", "table", "no range to show"},
    {"world_bouncing_balls", "table", "no range to show"},
    // Where and how fast they start is said by their emitters alone.
    {"emit_embers", "table", "no range to show"},
    {"emit_fireworks", "table", "no range to show"},
    {"emit_fountain", "table", "no range to show"},
    {"emit_machine_gun", "table", "no range to show"},
    {"emit_rain", "table", "no range to show"},
    {"emit_shotgun", "table", "no range to show"},
    {"emit_spiral", "table", "no range to show"},
    {"emit_volcano", "table", "no range to show"},
    // Its ships start at rest, under forces of their world.
    {"arcade_space", "table", "no range to show"},
    // What joints hold does not fly without its world.
    {"joint_pendulums", "table", "no range to show"},
    // Thousands of nutations on a dozen rungs take half a minute; 308_168gr_six_dof shows that it works.
    {"105mm_m1_six_dof", "compare", ""},
};

const Exception* exception_of(const std::string& scenario, const std::string& command) {
  const auto* const found = std::ranges::find_if(
      kExceptions, [&](const Exception& e) { return e.scenario == scenario && e.command == command; });
  return found == std::end(kExceptions) ? nullptr : found;
}

std::string file_of(const std::string& name) { return PHYSIM_SOURCE_DIR "/scenarios/" + name + ".toml"; }
bool is_world(const std::string& text) { return text.find("\n[world]") != std::string::npos; }

/// Goes through, or is refused for the reason that is written down. A missed [[expect]] of a run cut short is no fault.
Ran expect_through(const std::string& scenario, const std::string& command, const std::vector<std::string>& arguments) {
  const Ran ran = run_program(PHYSIM_CLI, arguments);
  const Exception* exception = exception_of(scenario, command);
  if (exception == nullptr) {
    EXPECT_LT(ran.code, 2) << command << ": " << ran.err;
    EXPECT_FALSE(ran.out.empty()) << command;
  } else {
    EXPECT_EQ(ran.code, 2) << command;
    EXPECT_NE(ran.err.find(exception->words), std::string::npos) << ran.err;
  }
  return ran;
}

void expect_json(const std::string& path) { EXPECT_TRUE(nlohmann::json::accept(read(path))) << path << " is no JSON"; }

class EveryScenario : public testing::TestWithParam<std::string> {};

TEST_P(EveryScenario, GoesThroughEveryCommand) {
  const std::string name = GetParam(), file = file_of(name);
  const Folder folder;
  expect_through(name, "table", {"table", file});
  if (is_world(read(file))) {
    expect_through(name, "run",
                   {"run", file, "--steps", "20", "--json", folder / "a.json", "--csv", folder / "a.csv", "--record",
                    folder / "a.rec"});
    expect_through(name, "replay", {"replay", folder / "a.rec", "--json", folder / "b.json"});
    expect_json(folder / "a.json");
    expect_json(folder / "b.json");
    return;
  }
  const Ran ran = run_program(PHYSIM_CLI, {"run", file, "--json", folder / "a.json", "--csv", folder / "a.csv"});
  EXPECT_EQ(ran.code, 0) << ran.err;
  expect_json(folder / "a.json");
  EXPECT_GT(std::ranges::count(read(folder / "a.csv"), '\n'), 2);
  const Exception* exception = exception_of(name, "compare");
  if (exception != nullptr && *exception->words == '\0') return;
  expect_through(name, "compare", {"compare", file, "--json", folder / "c.json"});
  if (exception == nullptr) expect_json(folder / "c.json");
}

/// The shots of a flight launched in a world, for a second.
std::string as_world(const std::string& name) {
  std::string text = read(file_of(name));
  if (const auto at = text.find("\n[[expect]]"); at != std::string::npos) text.resize(at + 1);  // they come last
  text = std::regex_replace(text, std::regex("\\n\\[(until|output)\\][^\\n]*(\\n[^\\n\\[]+[^\\n]*)*"),
                            "\n");  // worlds end by duration
  text = std::regex_replace(text, std::regex("file = \"motors/"), "file = \"" PHYSIM_SOURCE_DIR "/scenarios/motors/");
  return text + "\n[world]\nduration = \"1 s\"\n";
}

class EveryFlight : public testing::TestWithParam<std::string> {};

TEST_P(EveryFlight, FliesInAWorldThatIsRecordedAndReplayed) {
  const std::string name = GetParam();
  const Folder folder;
  const std::string file = folder.write(name + ".toml", as_world(name));
  const Ran ran =
      expect_through(name, "world", {"run", file, "--json", folder / "a.json", "--record", folder / "a.rec"});
  expect_json(folder / "a.json");
  EXPECT_EQ(ran.err.find("were refused"), std::string::npos) << ran.err;
  expect_through(name, "replay", {"replay", folder / "a.rec"});
}

std::vector<std::string> flights() {
  std::vector<std::string> names = test::shipped_scenarios();
  std::erase_if(names, [](const std::string& name) { return is_world(read(file_of(name))); });
  return names;
}

std::string name_of(const testing::TestParamInfo<std::string>& given) { return given.param; }

INSTANTIATE_TEST_SUITE_P(Shipped, EveryScenario, testing::ValuesIn(test::shipped_scenarios()), name_of);
INSTANTIATE_TEST_SUITE_P(Shipped, EveryFlight, testing::ValuesIn(flights()), name_of);

}  // namespace physim::testing_cli::cli_every_scenario_test
#endif
