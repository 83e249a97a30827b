// What is refused when a shot flies has the place of the setting that it is about.

#include "must.hpp"
#include "report/flown.hpp"

namespace physim::report_refusal_place_test {

constexpr const char* kFile =
    "physim = 1\n[[shot]]\nname = \"a.b\"\nspeed = \"800 m/s\"\nsight = { height = \"5 cm\", zero_range = \"90 km\" "
    "}\n";

Error told(const Error& error, const std::vector<std::string>& overrides = {}) {
  const auto scenario = must(parse_scenario(kFile, "f.toml", overrides));
  return report::about(scenario, scenario.shots[0], error);
}

TEST(RefusalPlace, is_that_of_the_setting) {
  const Error zero = told({"is out of reach", "launch.sight.zero_range", "shorten it"});
  EXPECT_EQ(zero.text(), "f.toml:5:41: error: shot \"a.b\": shot.sight.zero_range: is out of reach; shorten it");
  EXPECT_EQ(told({"is bad", "launch.speed[2].x", ""}).place, "f.toml:4:9");
  EXPECT_EQ(told({"is bad", "launch.speed", ""}, {"shot.speed=900 m/s"}).place, "--set shot.speed=900 m/s");
}

TEST(RefusalPlace, of_what_no_file_says_is_the_shot) {
  EXPECT_EQ(told({"is bad", "launch.elevation", ""}).place, "f.toml: shot \"a.b\": shot.elevation");
  for (const char* all : {"", "launch", "projectile"})
    EXPECT_EQ(told({"is bad", all, ""}).place, "f.toml: shot \"a.b\"") << all;
}

}  // namespace physim::report_refusal_place_test
