// Scenarios written as text: what is read back is what was written, setting by setting.
#include <gtest/gtest.h>

#include <filesystem>

#include "physim/scenario.hpp"

namespace physim {
namespace {

class WrittenScenario : public testing::TestWithParam<std::string> {};

TEST_P(WrittenScenario, ReadsBackAsItWas) {
  const std::string file = PHYSIM_SOURCE_DIR "/scenarios/" + GetParam() + ".toml";
  const Result<Scenario> before = load_scenario(file);
  ASSERT_TRUE(before) << before.error().text();
  const std::string text = scenario_text(*before);
  const Result<Scenario> after = parse_scenario(text, "written.toml");
  ASSERT_TRUE(after) << after.error().text() << "\n" << text;
  EXPECT_EQ(effective_settings(*after), effective_settings(*before));
  EXPECT_EQ(scenario_text(*after), text);
  EXPECT_EQ(after->expect.size(), before->expect.size());
}

std::vector<std::string> shipped() {
  std::vector<std::string> names;
  for (const auto& entry : std::filesystem::directory_iterator(PHYSIM_SOURCE_DIR "/scenarios"))
    if (entry.path().extension() == ".toml") names.push_back(entry.path().stem().string());
  std::sort(names.begin(), names.end());
  return names;
}

INSTANTIATE_TEST_SUITE_P(Shipped, WrittenScenario, testing::ValuesIn(shipped()), [](const auto& scenario) {
  std::string name = scenario.param;
  std::replace_if(
      name.begin(), name.end(), [](char c) { return c == '-' || c == '.'; }, '_');
  return name;
});

TEST(ScenarioText, KeepsTextThatNeedsQuotes) {
  Scenario scenario;
  scenario.title = "a \"quoted\" title\nof two lines";
  scenario.shots.resize(1);
  scenario.shots[0].projectile.name = "one.two";
  const Result<Scenario> after = parse_scenario(scenario_text(scenario), "written.toml");
  ASSERT_TRUE(after) << after.error().text();
  EXPECT_EQ(after->title, scenario.title);
  EXPECT_EQ(after->shots[0].projectile.name, "one.two");
}

}  // namespace
}  // namespace physim
