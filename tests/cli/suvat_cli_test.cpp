// `physim suvat`, as a user runs it.
#include <cmath>

#include "cli/program.hpp"

#ifdef PHYSIM_CLI

namespace physim::testing_cli::cli_suvat_cli_test {

TEST(SuvatCli, shows_both_motions) {
  const Ran ran = physim({"suvat", "u=30m/s", "a=-9.81m/s^2", "s=20m"});
  EXPECT_EQ(ran.code, 0) << ran.err;
  const auto lines = lines_of(ran.out);
  ASSERT_EQ(lines.size(), 3U) << ran.out;
  EXPECT_TRUE(has(lines[0], "s [m]") && has(lines[0], "t [s]")) << ran.out;
  EXPECT_TRUE(has(lines[1], "22.53") && has(lines[1], "0.76147")) << ran.out;
  EXPECT_TRUE(has(lines[2], "-22.53") && has(lines[2], "5.35474")) << ran.out;
  EXPECT_TRUE(has(physim({"suvat", "s=-20", "u=30", "a=-9.81"}).out, "t < 0: before the start"));
}

TEST(SuvatCli, reads_units_as_scenarios_do) {
  const Ran ran = physim({"suvat", "u = 0", "v=100 km/h", "t=200 ms", "--json"});
  ASSERT_EQ(ran.code, 0) << ran.err;
  const auto json = nlohmann::json::parse(ran.out);
  EXPECT_EQ(json.at("given").size(), 3U);
  ASSERT_EQ(json.at("motions").size(), 1U);
  EXPECT_NEAR(json.at("motions")[0].at("a [m/s^2]").get<double>(), 100 / 3.6 / 0.2, 1e-12);
  EXPECT_NEAR(json.at("motions")[0].at("s [m]").get<double>(), 100 / 3.6 * 0.1, 1e-14);
}

TEST(SuvatCli, bad_input_is_named_with_a_hint) {
  const struct {
    std::vector<std::string> arguments;
    const char* message;
  } bad[] = {{{}, "suvat: error: nothing is given; give exactly three"},
             {{"u=30", "a=-9.81"}, "suvat: error: 2 are given: u, a; give exactly three"},
             {{"u=30", "a=-9.81", "s=1", "t=1"}, "suvat: error: 4 are given: s, u, a, t"},
             {{"u=30", "u=31", "s=1"}, "suvat: error: u is given twice"},
             {{"w=30", "a=1", "s=1"}, "suvat: error: there is no quantity \"w\"; s displacement"},
             {{"30", "a=1", "s=1"}, "suvat: error: \"30\" is no NAME=VALUE; as in u=30m/s"},
             {{"u=30 kg", "a=1", "s=1"}, "u: error: \"30 kg\""},
             {{"u=fast", "a=1", "s=1"}, "u: error: \"fast\" is not a number"},
             {{"u=", "a=1", "s=1"}, "u: error: nothing stands behind the ="},
             {{"u=inf", "a=1", "s=1"}, "u: error: must be a finite number"},
             {{"u=30", "a=-9.81", "s=46"}, "suvat: error: no motion has these"},
             {{"u=3", "v=3", "a=0"}, "suvat: error: any number of motions has these"}};
  for (const auto& [arguments, message] : bad) {
    std::vector<std::string> words = {"suvat"};
    words.insert(words.end(), arguments.begin(), arguments.end());
    const Ran ran = physim(words);
    EXPECT_EQ(ran.code, 2) << message;
    EXPECT_EQ(ran.out, "");
    EXPECT_TRUE(has(ran.err, message)) << ran.err;
  }
}

}  // namespace physim::testing_cli::cli_suvat_cli_test
#endif  // PHYSIM_CLI
