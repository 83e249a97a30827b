// `physim replay`, as a user runs it.
#include "cli/program.hpp"
#include "physim/scenario.hpp"
#include "world/recording_bytes.hpp"

#ifdef PHYSIM_CLI

namespace physim::testing_cli::cli_replay_test {

Ran replay(std::vector<std::string> arguments) {
  arguments.insert(arguments.begin(), "replay");
  return run_program(PHYSIM_CLI, arguments);
}

/// Two seconds of a few balls, some of it taken back.
std::string recorded(const std::string& path, int steps = 120, bool stop = true) {
  World world;
  EXPECT_TRUE(record_to_file(world, path));
  const ProjectileDef ball{.mass = 0.5, .diameter = 0.1};
  for (int i = 0; i < 5; ++i)
    world.spawn(ball, {.position = {0, 1.0 + i, 0}, .speed = 5.0 * i, .elevation = 0.3}, {}, 0.1 * i);
  const Snapshot start = world.snapshot();
  for (int i = 0; i < 10; ++i) world.step(1.0 / 60);
  world.restore(start);
  for (int i = 0; i < steps; ++i) world.step(1.0 / 60);
  if (!stop) std::filesystem::copy_file(path + ".part", path + ".crashed");
  EXPECT_TRUE(world.stop_recording());
  return path;
}

TEST(CliReplay, SaysThatAllHashesAreEqual) {
  const Folder folder;
  const Ran ran = replay({recorded(folder / "a.rec")});
  EXPECT_EQ(ran.code, 0) << ran.err;
  EXPECT_EQ(ran.err, "");
  for (const char* part :
       {"recorded by  physim 0.", "calls        137", "steps        130, to 2.0000 s, with 1 restore",
        "projectiles  5 spawned, ", "hashes       all 130 equal"})
    EXPECT_TRUE(has(ran.out, part)) << part << "\n" << ran.out;
  EXPECT_EQ(replay({folder / "a.rec", "--threads", "7"}).out, ran.out);
}

TEST(CliReplay, WritesRowsAndJson) {
  const Folder folder;
  const std::string file = recorded(folder / "a.rec");
  const Ran csv = replay({file, "--csv", "-"});
  EXPECT_EQ(csv.code, 0) << csv.err;
  EXPECT_EQ(std::count(csv.out.begin(), csv.out.end(), '\n'), 131);
  EXPECT_TRUE(csv.out.starts_with("step,time [s],projectiles,events,hash\n1,0.016666666666666666,5,")) << csv.out;
  const Ran json = replay({file, "--json", "-", "--csv", folder / "a.csv"});
  EXPECT_EQ(json.code, 0) << json.err;
  const auto out = nlohmann::json::parse(json.out);
  EXPECT_EQ(out["equal"], true);
  EXPECT_EQ(out["steps"], 130);
  EXPECT_EQ(out["difference"], nullptr);
  EXPECT_TRUE(csv.out.ends_with("," + out["hash"].get<std::string>() + "\n")) << out["hash"];
  EXPECT_EQ(read(folder / "a.csv"), csv.out);
}

TEST(CliReplay, TellsTheFirstDifference) {
  const Folder folder;
  test::Bytes bytes = *load_recording(recorded(folder / "a.rec"));
  const test::Places places = test::places_of(bytes);
  const auto last_step = std::find(places.call.rbegin(), places.call.rend(), Call::step);
  const std::size_t place = places.frame[static_cast<std::size_t>(places.call.rend() - last_step - 1)];
  bytes[place + kFrameHead + 6] ^= std::byte{1};  // of dt
  test::sign(bytes);
  ASSERT_TRUE(save_recording(folder / "b.rec", bytes));
  const Ran ran = replay({folder / "b.rec"});
  EXPECT_EQ(ran.code, 1) << ran.err;
  EXPECT_TRUE(has(ran.out, "hashes       129 equal, then a difference")) << ran.out;
  EXPECT_TRUE(has(ran.out, "differs      in step 130 at ")) << ran.out;
  EXPECT_TRUE(has(ran.out, " s, in step(): the hash is 0x")) << ran.out;
  const auto out = nlohmann::json::parse(replay({folder / "b.rec", "--json", "-"}).out);
  EXPECT_EQ(out["equal"], false);
  EXPECT_EQ(out["difference"]["step"], 130);
}

TEST(CliReplay, RefusesWhatIsDamaged) {
  const Folder folder;
  std::string bytes = read(recorded(folder / "a.rec"));
  bytes[bytes.size() / 2] ^= 1;
  const Ran damaged = replay({folder.write("b.rec", bytes)});
  EXPECT_EQ(damaged.code, 2);
  EXPECT_EQ(damaged.out, "");
  EXPECT_TRUE(has(damaged.err, "b.rec: byte ")) << damaged.err;
  EXPECT_TRUE(has(damaged.err, "error: the recording is damaged here; ")) << damaged.err;
}

TEST(CliReplay, PlaysWhatACrashLeftBehind) {
  const Folder folder;
  recorded(folder / "a.rec", 50, false);
  const Ran ran = replay({folder / "a.rec.crashed"});
  EXPECT_EQ(ran.code, 0) << ran.err;
  EXPECT_TRUE(has(ran.err, "warning: the recording was cut at byte ")) << ran.err;
  EXPECT_TRUE(has(ran.out, "steps        60")) << ran.out;
  EXPECT_TRUE(has(ran.out, "all 60 equal")) << ran.out;
}

TEST(CliReplay, RefusesWhatIsNoRecording) {
  const Folder folder;
  const auto complains = [&](const std::vector<std::string>& arguments, const std::string& part) {
    const Ran ran = replay(arguments);
    EXPECT_EQ(ran.code, 2) << ran.out;
    EXPECT_EQ(ran.out, "");
    EXPECT_TRUE(has(ran.err, part)) << ran.err;
    EXPECT_EQ(std::count(ran.err.begin(), ran.err.end(), '\n'), 1) << ran.err;
  };
  complains({folder / "no.rec"}, "no.rec: error: there is no such file");
  complains({folder.write("empty.rec", "")}, "empty.rec: byte 0: error: this is not a recording");
  complains({folder.write("a.toml", "physim = 1")}, "a.toml: byte 0: error: this is not a recording");
  complains({folder / "."}, "this is a folder");
  complains({recorded(folder / "a.rec"), "--csv", folder / "a.rec"}, "it is the recording itself");
  complains({}, "FILE is required");
}

// ------------------------------------------------------------------------------------------------------------ files
TEST(RecordingFile, IsThereWhenItIsComplete) {
  const Folder folder;
  const std::string path = folder.write("a.rec", "what stood there before");
  World world;
  ASSERT_TRUE(record_to_file(world, path));
  world.step(0.1);
  EXPECT_EQ(read(path), "what stood there before");
  EXPECT_GT(read(path + ".part").size(), 100u);
  ASSERT_TRUE(world.stop_recording());
  EXPECT_EQ(folder.names(), (std::vector<std::string>{"a.rec"}));
  EXPECT_TRUE(physim::replay(*load_recording(path))->complete);
}

TEST(RecordingFile, NamesWhatItCannotDo) {
  const Folder folder;
  World world;
  EXPECT_EQ(record_to_file(world, "").error().message, "the name of the recording is empty");
  EXPECT_TRUE(has(record_to_file(world, folder / "no/a.rec").error().text(), "No such file"));
  EXPECT_TRUE(has(record_to_file(world, folder / ".").error().text(), "it is a folder"));
  world.step(0.1);
  EXPECT_TRUE(has(record_to_file(world, folder / "a.rec").error().text(), "something was done"));
  EXPECT_TRUE(folder.names().empty());  // nothing is left behind
  World full;
  EXPECT_TRUE(has(record_to_file(full, "/dev/full").error().text(), "cannot write: No space left on device"));
}

TEST(RecordingFile, SavesWhatIsInMemory) {
  const Folder folder;
  std::vector<std::byte> bytes;
  World world;
  ASSERT_TRUE(world.record(record_into(bytes)));
  world.step(0.1);
  ASSERT_TRUE(world.stop_recording());
  ASSERT_TRUE(save_recording(folder / "a.rec", bytes));
  EXPECT_EQ(*load_recording(folder / "a.rec"), bytes);
  EXPECT_EQ(folder.names().size(), 1u);
}

}  // namespace physim::testing_cli::cli_replay_test
#endif
