// `physim study`: ranges that shots do not reach, and correlations of inputs that options add.
#include "cli/program.hpp"
#include "cli/throw_study.hpp"

#ifdef PHYSIM_CLI

namespace physim::testing_cli::cli_study_ranges_test {

/// The throw of 30 m/s at 45 degrees in 10 m/s^2 ends at 90 m.
TEST(StudyRanges, those_that_are_not_reached_are_told_behind_the_others) {
  const Folder folder;
  const std::string file = folder.write("throw.toml", throw_study(4096)), csv = folder / "a.csv";
  const Ran ran = physim({"study", file, "--ranges", "40 m .. 160 m step 40 m", "--csv", csv});
  EXPECT_EQ(ran.code, 1) << ran.err;
  for (const char* row :
       {"\n         40  ", "\n         80  ", "\n        120  not reached\n", "\n        160  not reached\n"})
    EXPECT_TRUE(has(ran.out, row)) << ran.out;
  EXPECT_TRUE(has(read(csv), "\n120,,,")) << read(csv);
  EXPECT_EQ(physim({"study", file, "--ranges", "40 m"}).code, 0);
}

TEST(StudyRanges, a_range_that_no_zero_gets_to_is_not_reached) {
  const Folder folder;
  const std::string file = folder.write("throw.toml", throw_study(4096));
  const Ran ran = physim({"study", file, "--ranges", "[\"50 m\", \"5 km\"]", "--set", "shot.elevation=0 deg", "--set",
                          "shot.sight.zero_range=50 m", "--set", "study.targets=[]", "--set", "until.ground=off"});
  EXPECT_EQ(ran.code, 1) << ran.err;
  EXPECT_TRUE(has(ran.out, "\n           5  not reached\n")) << ran.out;
}

TEST(StudyRanges, none_that_is_reached_is_an_error_that_names_the_range) {
  const Folder folder;
  const Ran ran = physim({"study", folder.write("throw.toml", throw_study(4096)), "--ranges", "5 km"});
  EXPECT_EQ(ran.code, 2);
  EXPECT_TRUE(has(ran.err, "--ranges: error: 5000 m: of 1024 shots 0 arrived")) << ran.err;
}

TEST(StudyCorrelated, names_inputs_of_options_too) {
  const Folder folder;
  const std::string file =
      folder.write("throw.toml", throw_study(4096) + "correlated = [\"shot.speed with shot.elevation = 0.5\"]\n");
  const Ran ran = physim({"study", file, "--vary", "shot.elevation = +- 1 deg"});
  EXPECT_EQ(ran.code, 0) << ran.err;
  const Ran missing = physim({"study", file, "--vary", "shot.azimuth = +- 1 deg"});
  EXPECT_EQ(missing.code, 2);
  EXPECT_TRUE(has(missing.err, file + ":") && has(missing.err, "shot.elevation is none of the study's inputs"))
      << missing.err;
  EXPECT_EQ(physim({"study", file}).code, 2);
}

TEST(StudyText, plain_numbers_have_no_unit) {
  const Folder folder;
  const Ran ran =
      physim({"study", folder.write("throw.toml", throw_study(4096)), "--vary", "shot.drag.coefficient = +- 0.01"});
  EXPECT_TRUE(has(ran.out, "shot.drag.coefficient += ")) << ran.out;
  EXPECT_FALSE(has(ran.out, " -\n") || has(ran.out, "[-]")) << ran.out;
}

}  // namespace physim::testing_cli::cli_study_ranges_test
#endif
