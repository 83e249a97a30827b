// `mpirun -n 4 physim study`: ranks of a job fly one study, with the bits of threads, and end in clear words.
#include <csignal>
#include <cstdio>
#include <thread>

#include "cli/program.hpp"
#include "scenario/libraries.hpp"

#ifdef PHYSIM_CLI

namespace physim::testing_cli::cli_study_ranks_test {

constexpr const char* kRifle = R"(physim = 1
title = "A rifle"
[[shot]]
name = "308"
mass = "168 gr"
diameter = "0.308 in"
drag = { table = "g7", ballistic_coefficient = "0.218 lb/in^2" }
speed = "800 m/s"
fidelity = "small_arms"
[until]
range = "300 m"
ground = "off"
[study]
inputs = ["shot.speed = +- 3 m/s", "shot.azimuth = +- 1 mrad", "environment.wind.velocity.z = 0 m/s +- 2 m/s"]
targets = ["plate: circle 30 cm at 0 m, -0.8 m"]
shots = 100000
)";

/// Without MPI a job is refused: each rank would fly the whole study.
TEST(StudyRanks, a_job_is_told_apart_from_a_run_alone) {
  const File file("rifle.toml", kRifle);
  EXPECT_EQ(physim({"study", file, "--shots", "4096"}).code, 0);
#if !PHYSIM_HAS_MPI
  const Ran ran = physim({"study", file}, {"PMI_SIZE=4", "PATH=/usr/bin"});
  EXPECT_EQ(ran.code, 2);
  EXPECT_TRUE(has(ran.err, "without MPI") && has(ran.err, "--shards")) << ran.err;
#endif
}

#if PHYSIM_HAS_MPI

/// Runs so many ranks of a program on this machine, without a shell of others, on however few cores, and as whoever
/// runs the tests.
Ran mpirun(int ranks, const std::vector<std::string>& program) {
  std::vector<std::string> words = {"--oversubscribe",    "--allow-run-as-root", "--mca", "plm", "isolated", "-n",
                                    std::to_string(ranks)};
  words.insert(words.end(), program.begin(), program.end());
  // Open MPI leaks some memory. Its hwloc looks for graphics cards on display :0, and ends with the screen in memory of
  // a test that runs beside this one.
  return run_program(PHYSIM_MPIRUN, words, "", {"ASAN_OPTIONS=detect_leaks=0", "HWLOC_COMPONENTS=-gl"});
}
Ran job(int ranks, std::vector<std::string> arguments) {
  arguments.insert(arguments.begin(), PHYSIM_CLI);
  return mpirun(ranks, arguments);
}

TEST(StudyRanks, have_the_bits_of_threads) {
  const Folder folder;
  const std::string file = folder.write("rifle.toml", kRifle), csv = folder / "threads.csv", part = folder / "threads";
  ASSERT_EQ(physim({"study", file, "--threads", "2", "--csv", csv, "--resume", part}).code, 0);
  for (int ranks = 1; ranks <= 4; ++ranks) {
    const std::string by_ranks = folder / ("csv" + std::to_string(ranks)),
                      kept = folder / ("part" + std::to_string(ranks));
    const Ran ran = job(ranks, {"study", file, "--csv", by_ranks, "--resume", kept});
    ASSERT_EQ(ran.code, 0) << ran.err;
    EXPECT_EQ(read(by_ranks), read(csv)) << ranks;
    EXPECT_EQ(read(kept), read(part)) << ranks;
    EXPECT_EQ(ran.out.find("A rifle"), ran.out.rfind("A rifle")) << "the first rank alone prints";
  }
}

TEST(StudyRanks, have_the_bits_of_threads_at_places_too) {
  const Folder folder;
  const std::string file = folder.write("rifle.toml", kRifle), kept = folder / "kept", part = folder / "part";
  const std::vector<std::string> study = {
      "study", file, "--at", "100 m", "--at", "200 m: up, time", "--set", "study.sampling=latin_hypercube",
      "--csv", "-"};
  const auto into = [&](const std::string& to) {
    std::vector<std::string> words = study;
    words.insert(words.end(), {"--resume", to});
    return words;
  };
  const Ran threads = physim(into(kept)), ranks = job(3, into(part));
  ASSERT_EQ(ranks.code, 0) << ranks.err;
  EXPECT_TRUE(has(threads.out, "at.200 m.up.mean [m]")) << threads.out;
  EXPECT_EQ(ranks.out, threads.out);
  EXPECT_EQ(read(part), read(kept));
}

TEST(StudyRanks, stop_at_a_width_where_threads_do) {
  const File file("rifle.toml", kRifle);
  const std::vector<std::string> command = {"study", file, "--shots", "400000", "--until-width", "1 %", "--csv", "-"};
  const Ran threads = physim(command), ranks = job(3, command);
  ASSERT_EQ(ranks.code, 0) << ranks.err;
  EXPECT_EQ(ranks.out, threads.out);
}

TEST(StudyRanks, end_when_their_time_is_up) {
  const Folder folder;
  const std::string file = folder.write("rifle.toml", kRifle), csv = folder / "a.csv", again = folder / "b.csv";
  const Ran ran = job(3, {"study", file, "--until-time", "1 s", "--csv", csv});
  ASSERT_EQ(ran.code, 0) << ran.err;
  const std::size_t at = ran.out.find("--shots ");
  ASSERT_NE(at, std::string::npos) << ran.out;
  const std::string shots = std::to_string(std::stoull(ran.out.substr(at + 8)));
  ASSERT_EQ(physim({"study", file, "--shots", shots, "--csv", again}).code, 0);
  EXPECT_EQ(read(again), read(csv));
}

TEST(StudyRanks, say_what_is_wrong) {
  const Folder folder;
  const std::string file = folder.write("rifle.toml", kRifle);
  const Ran ranges = job(2, {"study", file, "--ranges", "100 m, 200 m"});
  EXPECT_NE(ranges.code, 0);
  EXPECT_TRUE(has(ranges.err, "ranks of a job fly one study")) << ranges.err;
  const Ran parts = job(2, {"study", file, "--shards", "1/2", "--resume", folder / "x"});
  EXPECT_TRUE(has(parts.err, "leave it out")) << parts.err;
  const Ran input = job(3, {"study", file, "--vary", "shot.sped = +- 1 m/s"});
  EXPECT_NE(input.code, 0);
  EXPECT_TRUE(has(input.err, "shot.sped")) << input.err;
}

/// A rank that kills itself in the middle: what was flown is in the file, and going on gives the bits of one run.
TEST(StudyRanks, lose_nothing_when_one_dies) {
  const Folder folder;
  const std::string file = folder.write("rifle.toml", kRifle), kept = folder / "kept", csv = folder / "whole.csv";
  const std::vector<std::string> more = {"--shots", "1500000"};
  const auto study = [&](std::vector<std::string> words) {
    words.insert(words.begin(), {"study", file});
    words.insert(words.end(), more.begin(), more.end());
    return words;
  };
  ASSERT_EQ(physim(study({"--csv", csv})).code, 0);
  const std::string rank = folder.write("rank.sh",
                                        "#!/bin/sh\n"
                                        "[ \"$OMPI_COMM_WORLD_RANK\" = 2 ] && (sleep 1.5; kill -9 $$) &\n"
                                        "exec \"$@\"\n");
  std::vector<std::string> words = {"/bin/sh", rank, PHYSIM_CLI};
  const std::vector<std::string> flown = study({"--resume", kept});
  words.insert(words.end(), flown.begin(), flown.end());
  const Ran died = mpirun(3, words);
  if (died.code == 0) GTEST_SKIP() << "it was over before the rank died";
  EXPECT_TRUE(has(died.err, "should one die, go on with --resume " + kept)) << died.err;
  EXPECT_TRUE(has(died.err, "rank 2")) << "mpirun says who: " << died.err;
  EXPECT_GT(read(kept).size(), 10'000U);
  const Ran on = job(2, study({"--resume", kept, "--csv", folder / "on.csv"}));
  ASSERT_EQ(on.code, 0) << on.err;
  EXPECT_EQ(read(folder / "on.csv"), read(csv));
}

#else

TEST(StudyRanks, need_mpi) { GTEST_SKIP() << "built without MPI: no job of ranks was run"; }

#endif

}  // namespace physim::testing_cli::cli_study_ranks_test
#endif
