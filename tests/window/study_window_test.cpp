// Studies in a window: begun, paused and gone on with by keys, while frames go on; places that are typed.
#include "window/x_client.hpp"

namespace physim::testing_window {
namespace {

std::vector<std::string> study_308(const char* shots) {
  return {"--size", "1280x720", PHYSIM_SOURCE_DIR "/scenarios/study_308.toml", "--set", shots};
}

TEST(Study, IsBegunAndPausedByAKeyAndComesToTheFiguresOfThePage) {
  const Screen screen;
  RunningClient client(screen, study_308("study.shots=30000"));
  ASSERT_TRUE(client.has_window());
  client.key("z");
  client.wait_for([](const Json& s) { return s.contains("study") && s["study"].contains("shots"); });
  client.key("z");
  const Json paused = client.wait_for([](const Json& s) { return s["study"]["state"] != "running"; });
  EXPECT_LE(paused["study"]["shots"].get<std::uint64_t>(), 32768U);
  if (paused["study"]["state"] == "paused") client.key("z");
  const Json done = client.wait_for([](const Json& s) { return s["study"]["state"] == "done"; });
  ASSERT_EQ(done["study"]["state"], "done");
  EXPECT_EQ(done["study"]["shots"], 32768U);
  EXPECT_NEAR(done["study"]["hits"][0]["probability"].get<double>(), 60521.0 / 102400, 0.01);
  if (paused["study"]["state"] == "paused") {
    EXPECT_GT(done["frame"].get<std::uint64_t>(), paused["frame"].get<std::uint64_t>());
  }
}

TEST(Study, APlaceIsTypedMendedAndChosen) {
  const Screen screen;
  RunningClient client(screen, study_308("study.shots=4096"));
  ASSERT_TRUE(client.has_window());
  for (const char* key : {"F2", "F3", "y"}) client.key(key);  // the whole width is the study's
  client.click(600, 556);
  for (const char* key : {"a", "p", "x", "Return"}) client.key(key);
  const Json refused = client.wait_for([](const Json& s) { return s.contains("message"); });
  EXPECT_NE(refused["message"].get<std::string>().find("did you mean \"apex\""), std::string::npos);
  client.click(640, 556);  // beside the last click: a double one there would take the word
  for (const char* key : {"BackSpace", "e", "x", "Return", "z"}) client.key(key);
  const Json told = client.wait_for([](const Json& s) { return s.contains("study") && s["study"].contains("at"); });
  ASSERT_EQ(told["study"]["at"].size(), 1U);
  EXPECT_EQ(told["study"]["at"][0]["place"], "apex");
  EXPECT_EQ(told["study"]["shown"], "end");
  client.click(600, 291);
  client.click(560, 335);
  EXPECT_EQ(client.wait_for([](const Json& s) { return s["study"]["shown"] != "end"; })["study"]["shown"], "apex");
}

}  // namespace
}  // namespace physim::testing_window
