// What `physim run` writes of many shots goes to the file as it is made: no room for all of it, and no half of it.
#include "cli/program.hpp"

#if defined(PHYSIM_CLI) && !defined(__SANITIZE_ADDRESS__) && !defined(__SANITIZE_THREAD__)

namespace physim::testing_cli::cli_large_output_test {

constexpr const char* kMany = R"(physim = 1
[[shot]]
name = "round"
mass = "1 kg"
diameter = "5 cm"
speed = "10 m/s"
elevation = "30 deg"
fidelity = "game"
[[volley]]
shot = "round"
count = 50_000
rate = "50000 Hz"
spread = { horizontal = "1 mrad", vertical = "1 mrad", speed = "1 m/s" }
[world]
duration = "4 s"
threads = 1
)";

/// Under a limit of the shell: "-v" for memory, "-f" for files, as numbers of 1024 bytes.
Ran limited(const std::string& limit, const std::vector<std::string>& arguments) {
  std::vector<std::string> words = {"-c", "trap '' XFSZ; ulimit " + limit + "; exec \"$0\" \"$@\"", PHYSIM_CLI};
  words.insert(words.end(), arguments.begin(), arguments.end());
  return run_program("/bin/bash", words);
}

/// Address space that the program takes before it does anything, its code and the libraries that it is linked with, to
/// a quarter of a megabyte above [1024 bytes].
int room_of_program() {
  int too_little = 0, enough = 1'000'000;
  while (enough - too_little > 250) {
    const int some = (too_little + enough) / 2;
    (limited("-v " + std::to_string(some), {"--version"}).code == 0 ? enough : too_little) = some;
  }
  return enough;
}

TEST(CliLarge, OutputNeedsNoMemoryOfItsOwn) {
  const Folder folder;
  const std::string file = folder.write("many.toml", kMany);
  // Less than the JSON alone would take as a tree.
  const std::string limit = "-v " + std::to_string(room_of_program() + 23'000);
  const Ran ran =
      limited(limit, {"run", file, "--interval", "4 s", "--json", folder / "a.json", "--events", folder / "e.csv"});
  ASSERT_EQ(ran.code, 0) << ran.err;
  EXPECT_GT(std::filesystem::file_size(folder / "a.json"), 25'000'000u);
  const Ran printed = limited(limit, {"run", file, "--interval", "4 s", "--steps", "30", "--json", "-"});
  EXPECT_EQ(printed.code, 0) << printed.err;
  EXPECT_TRUE(nlohmann::json::accept(printed.out));
}

TEST(CliLarge, AFileThatFindsNoRoomLeavesNothing) {
  const Folder folder;
  const std::string file = folder.write("many.toml", kMany), old = folder.write("a.json", "old");
  const Ran ran = limited("-f 1000", {"run", file, "--interval", "4 s", "--steps", "20", "--json", old});
  EXPECT_EQ(ran.code, 2);
  EXPECT_TRUE(has(ran.err, "cannot write: File too large")) << ran.err;
  EXPECT_EQ(read(old), "old");
  EXPECT_EQ(folder.names().size(), 2u);
  EXPECT_EQ(physim({"run", file, "--interval", "4 s", "--steps", "20", "--json", "/dev/full"}).code, 2);
  EXPECT_EQ(physim({"run", file, "--interval", "4 s", "--steps", "20", "--events", "/dev/full"}).code, 2);
}

/// A flight that stalls at once: with another default it would take a million steps.
TEST(CliLarge, WhatWasAssumedIsFoundByShortFlights) {
  const Ran ran = limited("-t 15", {"run", PHYSIM_SOURCE_DIR "/scenarios/nesc_case05.toml", "--json", "-", "--set",
                                    "shot.sphere.inertia.moments=[\"4.880944613993042 kg m^2\", \"7.51e-40 kg m^2\", "
                                    "\"4.880944613993042 kg m^2\"]"});
  const auto json = nlohmann::json::parse(ran.out);
  EXPECT_EQ(json.at("shots").at(0).at("outcome"), "stalled");
  EXPECT_FALSE(json.at("shots").at(0).at("assumed").empty());
}

}  // namespace physim::testing_cli::cli_large_output_test
#endif
