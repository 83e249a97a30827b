// Every format through every command that writes results: what the table of formats says is what the program does.
#include "cli/program.hpp"
#include "report/format.hpp"

namespace physim::testing_cli::cli_format_cli_test {

using namespace report;

constexpr const char* kRoundShot =
    "physim = 1\n[[shot]]\nname = \"ball\"\nmass = \"1 kg\"\ndiameter = \"5 cm\"\nspeed = \"100 m/s\"\n"
    "elevation = \"20 deg\"\nfidelity = { preset = \"simulation\", earth = \"ellipsoid\" }\n";
constexpr const char* kWorld =
    "physim = 1\n[world]\nduration = \"1 s\"\n[[shot]]\nname = \"ball\"\nmass = \"1 kg\"\ndiameter = \"5 cm\"\n"
    "speed = \"10 m/s\"\nfidelity = { preset = \"game\", earth = \"ellipsoid\" }\n";

std::string option_of(const Format& format) { return "--" + std::string(format.name); }
std::string file_of(const Format& format) { return "out" + std::string(format.ending); }

/// Where the command has the option, it writes the file; else it refuses.
void expect_written(const std::string& command, const std::string& input, Subject subject, const Folder& folder) {
  const std::string help = run_program(PHYSIM_CLI, {command, "--help"}).out;
  for (const Format& format : formats()) {
    const std::string where = command + " " + option_of(format);
    const std::string path = folder / (command + file_of(format));
    std::filesystem::remove(path);
    const Ran ran = run_program(PHYSIM_CLI, {command, input, option_of(format), path});
    if (can_write(format, subject)) {
      EXPECT_NE(help.find(option_of(format) + " FILE"), std::string::npos) << where;
      EXPECT_EQ(ran.code, 0) << where << ": " << ran.err;
      EXPECT_GT(read(path).size(), 20U) << where;
    } else {
      EXPECT_EQ(ran.code, 2) << where;
      EXPECT_NE(ran.err.find(option_of(format)), std::string::npos) << ran.err;
      EXPECT_FALSE(std::filesystem::exists(path)) << where;
    }
  }
}

TEST(FormatOptions, WriteWhatTheTableSays) {
  const Folder folder;
  const std::string shot = folder.write("shot.toml", kRoundShot), world = folder.write("world.toml", kWorld);
  const std::string recording = folder / "world.rec";
  ASSERT_EQ(run_program(PHYSIM_CLI, {"run", world, "--record", recording}).code, 0);
  expect_written("run", shot, Subject::flights, folder);
  expect_written("run", world, Subject::world, folder);
  expect_written("replay", recording, Subject::replay, folder);
}

TEST(FormatOptions, CompareWritesWhatTheTableSays) {
  const Folder folder;
  expect_written("compare", folder.write("shot.toml", kRoundShot), Subject::ladder, folder);
}

TEST(FormatOptions, AFolderGetsAFileOfEachFormat) {
  const Folder folder;
  const std::string input[] = {folder.write("shot.toml", kRoundShot), folder.write("world.toml", kWorld)};
  const Subject subjects[] = {Subject::flights, Subject::world};
  for (int i = 0; i < 2; ++i) {
    ASSERT_EQ(run_program(PHYSIM_CLI, {"run", input[i], "--out", folder / "all"}).code, 0);
    for (const Format& format : formats()) {
      const std::string stem = i == 0 ? "shot" : "world";
      const std::string path = folder / ("all/" + stem + std::string(format.ending));
      const bool has_it = format.scenario_has == nullptr;  // neither has a scene
      EXPECT_EQ(std::filesystem::exists(path), can_write(format, subjects[i]) && has_it) << path;
    }
  }
}

TEST(FormatOptions, RangeCardsAreWrittenInEveryFormatOfRecords) {
  const File shot("shot.toml", kRoundShot);
  for (const Format& format : formats()) {
    const Ran ran = run_program(PHYSIM_CLI, {"table", shot, "--format", std::string(format.name)});
    EXPECT_EQ(ran.code, can_write(format, Subject::records) ? 0 : 2) << format.name << ran.err;
    EXPECT_EQ(ran.out.size() > 100, can_write(format, Subject::records)) << format.name;
  }
}

}  // namespace physim::testing_cli::cli_format_cli_test
