// Files that another version of the program wrote, through every command that reads them: each is refused with exit
// code 2 in one line that names the file and the version.
#include "cli/program.hpp"
#include "cli/throw_study.hpp"
#include "physim/result.hpp"

#ifdef PHYSIM_CLI

namespace physim::testing_cli::cli_other_version_test {

/// A copy of a file that says another format, and version 7 of the program. Its check sums are wrong now: what they
/// should be is a matter of the other format.
std::string of_another_version(const Folder& folder, const std::string& path, std::size_t format) {
  std::string bytes = read(path);
  EXPECT_GT(bytes.size(), format);
  bytes[format] = 99;
  const std::size_t at = bytes.find(kVersion);
  EXPECT_LT(at, 60u) << "the version stands in the head";
  if (at != std::string::npos) bytes.replace(at, std::string(kVersion).size(), "7" + std::string(kVersion).substr(1));
  return folder.write("other", bytes);
}

void expect_named(const Ran& ran, const std::string& file) {
  EXPECT_EQ(ran.code, 2) << ran.err;
  EXPECT_EQ(ran.out, "");
  EXPECT_TRUE(has(ran.err, file)) << ran.err;
  EXPECT_TRUE(has(ran.err, "is of format 99, written by PhySim 7" + std::string(kVersion).substr(1) +
                               "; this is PhySim " + kVersion + ", which reads format "))
      << ran.err;
  EXPECT_EQ(std::ranges::count(ran.err, '\n'), 1) << ran.err;
}

TEST(CliOtherVersion, ofARunAndARecordingIsNamed) {
  const Folder folder;
  const std::string file = folder.write("w.toml", R"(
physim = 1
[[shot]]
name = "stone"
speed = "20 m/s"
elevation = "40 deg"
[world]
duration = "3 s"
)");
  ASSERT_EQ(physim({"run", file, "--save", folder / "w.save", "--save-at", "1 s", "--record", folder / "w.rec"}).code,
            0);
  const std::string save = of_another_version(folder, folder / "w.save", 8);
  expect_named(physim({"run", file, "--load", save}), save);
  const std::string recording = of_another_version(folder, folder / "w.rec", 8);
  expect_named(physim({"replay", recording}), recording);
}

TEST(CliOtherVersion, ofAPartOfAStudyIsNamed) {
  const Folder folder;
  const std::string file = folder.write("throw.toml", throw_study(4096));
  ASSERT_EQ(physim({"study", file, "--shards", "1/1", "--resume", folder / "part"}).code, 0);
  const std::string part = of_another_version(folder, folder / "part", 21);
  const std::string before = read(part);
  expect_named(physim({"study", file, "--merge", part}), part);
  expect_named(physim({"study", file, "--resume", part}), part);
  EXPECT_EQ(read(part), before) << "it stays as it was";
}

}  // namespace physim::testing_cli::cli_other_version_test
#endif
