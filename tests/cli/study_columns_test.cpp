// `physim study --hdf5`: each shot, as the library itself gives it again.
#include <cmath>

#include "cli/program.hpp"
#include "cli/throw_study.hpp"
#include "scenario/libraries.hpp"
#include "scenario/scenario.hpp"

#if PHYSIM_HAS_HDF5
#include <hdf5.h>
#endif

#ifdef PHYSIM_CLI

namespace physim::testing_cli::cli_study_columns_test {

#if PHYSIM_HAS_HDF5

std::vector<double> column(const std::string& file, const char* name) {
  const hid_t in = H5Fopen(file.c_str(), H5F_ACC_RDONLY, H5P_DEFAULT), data = H5Dopen2(in, name, H5P_DEFAULT);
  const hid_t space = H5Dget_space(data);
  std::vector<double> numbers(static_cast<std::size_t>(H5Sget_simple_extent_npoints(space)));
  EXPECT_GE(H5Dread(data, H5T_NATIVE_DOUBLE, H5S_ALL, H5S_ALL, H5P_DEFAULT, numbers.data()), 0) << name;
  H5Sclose(space), H5Dclose(data), H5Fclose(in);
  return numbers;
}

TEST(StudyColumns, are_the_shots) {
  const Folder folder;
  const std::string text = throw_study(10000, ", \"shot.speed = added -1 m/s .. 1 m/s\""), out = folder / "shots.h5";
  const std::string file = folder.write("throw.toml", text);
  const Ran ran = physim({"study", file, "--hdf5", out, "--threads", "2"});
  ASSERT_EQ(ran.code, 0) << ran.err;
  const Scenario scenario = parse_scenario(text, "t.toml").value();
  const StudyPlan plan = plan_study(study_of(scenario, scenario.shots[0]).value()).value();
  const auto speeds = column(out, "/inputs/shot.speed"), more = column(out, "/inputs/shot.speed (2)");
  const auto along = column(out, "/quantities/along"), hits = column(out, "/hits/near");
  ASSERT_EQ(speeds.size(), 3 * 4096U);
  for (const std::uint64_t shot : {0U, 4095U, 4096U, 12287U}) {
    EXPECT_EQ(speeds[shot], draws_of(plan, shot)[0]);
    EXPECT_EQ(more[shot], draws_of(plan, shot)[1]);
    EXPECT_EQ(along[shot], fly_shot_of(plan, shot)[1]);
    EXPECT_EQ(hits[shot], std::abs(along[shot] - 90) < 1.8 ? 1 : 0);
  }
  EXPECT_EQ(folder.names().size(), 2U) << "nothing else is left behind";
}

TEST(StudyColumns, of_places_are_in_groups_of_theirs) {
  const Folder folder;
  const std::string text = throw_study(5000), out = folder / "shots.h5";
  const Ran ran = physim({"study", folder.write("throw.toml", text), "--at", "apex: y", "--at", "45 m", "--at",
                          "speed 25 m/s", "--hdf5", out});
  ASSERT_EQ(ran.code, 0) << ran.err;
  const auto speeds = column(out, "/inputs/shot.speed"), apex = column(out, "/at/apex/quantities/y");
  const auto up = column(out, "/at/45 m/quantities/up");
  EXPECT_EQ(column(out, "/at/speed 25 m_s/quantities/along").size(), apex.size());
  ASSERT_EQ(apex.size(), 2 * 4096U);
  for (const std::size_t shot : {0U, 4095U, 8191U}) {
    const double v = 30 + speeds[shot], t = 45 / (v * std::sqrt(0.5));
    EXPECT_NEAR(apex[shot], v * v / 40, 1e-8);
    EXPECT_NEAR(up[shot], v * std::sqrt(0.5) * t - 5 * t * t, 1e-8);
  }
}

/// A disk that is full: told, and what was there before stays.
TEST(StudyColumns, are_there_whole_or_not_at_all) {
  const Folder folder;
  const std::string file = folder.write("throw.toml", throw_study(100000)), out = folder.write("shots.h5", "before");
  const std::string program = "trap '' XFSZ; ulimit -f 200; exec \"$0\" \"$@\"";
  const Ran full = run_program("/bin/sh", {"-c", program, PHYSIM_CLI, "study", file, "--hdf5", out});
  EXPECT_EQ(full.code, 2) << full.out;
  EXPECT_TRUE(has(full.err, "cannot write") && has(full.err, "room for 102400 shots")) << full.err;
  EXPECT_EQ(read(out), "before");
  EXPECT_EQ(folder.names().size(), 2U) << "nothing else is left behind";
}

TEST(StudyColumns, bad_input) {
  const Folder folder;
  const std::string file = folder.write("throw.toml", throw_study(4096));
  const Ran stream = physim({"study", file, "--hdf5", "-"});
  EXPECT_EQ(stream.code, 2);
  EXPECT_TRUE(has(stream.err, "not into a stream")) << stream.err;
  const Ran nowhere = physim({"study", file, "--hdf5", folder / "no/shots.h5"});
  EXPECT_TRUE(has(nowhere.err, "no such directory")) << nowhere.err;
  const Ran ranges = physim({"study", file, "--hdf5", folder / "a.h5", "--ranges", "20 m"});
  EXPECT_TRUE(has(ranges.err, "--ranges")) << ranges.err;
}

#else

TEST(StudyColumns, are_refused_with_the_package_that_has_them) {
  const Folder folder;
  const Ran ran = physim({"study", folder.write("throw.toml", throw_study(4096)), "--hdf5", folder / "a.h5"});
  EXPECT_EQ(ran.code, 2);
  EXPECT_TRUE(has(ran.err, "libhdf5-dev")) << ran.err;
}

TEST(StudyColumns, need_hdf5) { GTEST_SKIP() << "built without HDF5: no file of shots was written"; }

#endif

}  // namespace physim::testing_cli::cli_study_columns_test
#endif
