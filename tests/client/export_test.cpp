// What the client writes replaces nothing that its session reads; only a scenario is saved over itself.
#include "named_files.hpp"
#include "simclient/core/client.hpp"

namespace physim::client {
namespace {

namespace fs = std::filesystem;
using testing_cli::Folder;
using testing_cli::has;
using testing_cli::read;

/// A scenario and what it names.
std::string write_scenario(const Folder& folder) {
  const std::string shapes = test::write_named_files(folder);
  return folder.write("s.toml", "physim = 1\n[world]\nduration = \"10 ms\"\n[[shot]]\nname = \"rocket\"\n" +
                                    std::string(test::kRocketLines) + shapes +
                                    "[study]\ninputs = [\"shot.speed = column speed of speeds.csv\"]\n");
}

void expect_kept(const std::string& file, const Status& status, const std::string& content) {
  EXPECT_FALSE(status.ok()) << file;
  if (status.ok()) return;
  EXPECT_TRUE(has(status.error().message, "this session reads or records")) << status.error().text();
  EXPECT_EQ(read(file), content) << file;
}

TEST(ClientExport, replaces_nothing_that_the_session_reads) {
  const Folder folder;
  const std::string file = write_scenario(folder);
  Client client = open_client(file, {}).value();
  for (const char* name : {"s.toml", "motor.eng", "hills.pgm", "speeds.csv"}) {
    if (!fs::exists(folder / name)) continue;  // a file of a kind that this build does not read
    const std::string input = folder / name, link = folder / "link.csv", content = read(input);
    fs::create_symlink(input, link);
    expect_kept(input, client.save_flights(link), content);
    expect_kept(input, client.record(input), content);
    expect_kept(input, client.export_file(input, report::as_text("a picture")), content);
    if (input != file) expect_kept(input, client.save(input), content);
    fs::remove(link);
  }
  EXPECT_TRUE(client.save_flights(folder / "flights.csv").ok());
  EXPECT_TRUE(client.save_flights(folder / "flights.csv").ok()) << "which it only wrote";
}

TEST(ClientExport, knows_files_that_are_set_later) {
  const Folder folder;
  Client client = open_client(write_scenario(folder), {}).value();
  const std::string motor = folder.write("other.eng", read(folder / "motor.eng")), content = read(motor);
  ASSERT_TRUE(client.set("shot.motor.file=other.eng").ok());
  expect_kept(motor, client.export_file(motor, report::as_text("")), content);
}

TEST(ClientExport, a_scenario_is_saved_over_itself) {
  const Folder folder;
  const std::string file = write_scenario(folder);
  fs::create_symlink(file, folder / "link.toml");
  Client client = open_client(file, {}).value();
  ASSERT_TRUE(client.set("shot.speed=20 m/s").ok());
  EXPECT_TRUE(client.save("").ok());
  EXPECT_TRUE(has(read(file), "20")) << read(file);
  ASSERT_TRUE(client.set("shot.speed=30 m/s").ok());
  EXPECT_TRUE(client.save(folder / "link.toml").ok());
  EXPECT_TRUE(has(read(file), "30")) << read(file);
  EXPECT_TRUE(client.save(folder / "t.toml").ok());
  EXPECT_TRUE(client.save(file).ok()) << "back to where it came from";
}

TEST(ClientExport, replaces_no_recording_that_it_makes_or_plays) {
  const Folder folder;
  const std::string file = write_scenario(folder), content = read(file);
  Client client = open_client(file, {}).value();
  const std::string recording = folder / "a.rec";
  ASSERT_TRUE(client.record(recording).ok());
  expect_kept(recording + ".part", client.export_file(recording + ".part", report::as_text("")),
              read(recording + ".part"));
  EXPECT_FALSE(client.export_file(recording, report::as_text("")).ok());
  ASSERT_TRUE(client.record("").ok());
  ASSERT_TRUE(client.replay().ok());
  expect_kept(recording, client.export_file(recording, report::as_text("")), read(recording));
  expect_kept(file, client.export_file(file, report::as_text("")), content);
  ASSERT_TRUE(client.replay().ok());
  EXPECT_TRUE(client.record(recording).ok()) << "which is no longer played";
  const std::string part = folder.write("b.toml.part", content);
  Client other = open_client(part, {}).value();
  expect_kept(part, other.record(folder / "b.toml"), content);
}

}  // namespace
}  // namespace physim::client
