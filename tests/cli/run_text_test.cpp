// What the text of `physim run` says of a flight: elevation, events, motor, energies, times.
#include <cmath>

#include "cli/program.hpp"

#ifdef PHYSIM_CLI

namespace physim::testing_cli::cli_run_text_test {

constexpr const char* kVacuum =
    "physim = 1\n[environment]\natmosphere = \"vacuum\"\ngravity = { model = \"constant\", acceleration = \"10 m/s^2\" "
    "}\n";

/// A launch by its velocity, 45 degrees up: it crosses 20 ft after (30 - sqrt(900 - 20 * 6.096)) / 10 = 0.2105 s.
std::string thrown(const std::string& more) {
  return kVacuum + std::string("[[shot]]\nname = \"s\"\nvelocity = [\"30 m/s\", \"30 m/s\", \"0 m/s\"]\n") + more;
}

TEST(RunText, the_elevation_of_a_velocity_is_its_own) {
  const File file(
      "s.toml",
      thrown("[[expect]]\nat = \"end\"\nquantity = \"elevation\"\nequals = \"45 deg\"\nwithin = \"1e-9 deg\"\n"
             "source = \"geometry\"\n"));
  const Ran ran = physim({"run", file});
  EXPECT_EQ(ran.code, 0) << ran.out << ran.err;
  EXPECT_TRUE(has(ran.out, "elevation      45.0000 deg")) << ran.out;
}

TEST(RunText, events_that_are_asked_for_have_a_line_each) {
  const File file("s.toml",
                  thrown("[until]\nevents = [{ kind = \"height\", value = \"20 ft\", direction = \"rising\" }, "
                         "{ kind = \"time\", value = \"1 s\", terminal = true }]\n"));
  const Ran ran = physim({"run", file});
  EXPECT_TRUE(has(ran.out, "height         6.096 m rising at 0.2106 s: 6.31")) << ran.out;
  EXPECT_TRUE(has(ran.out, "time           1 s rising at 1.0000 s: 30.0000 m downrange, height 25.000 m")) << ran.out;
  EXPECT_FALSE(has(physim({"run", file, "--set", "until.events=[]"}).out, "height   "));
}

TEST(RunText, a_motor_without_propellant_has_no_specific_impulse) {
  const File file("s.toml", thrown("motor = { thrust = [[\"0 s\", \"5 N\"], [\"2 s\", \"5 N\"]] }\n"));
  const Ran ran = physim({"run", file});
  EXPECT_TRUE(has(ran.out, "10.00 N s in 2.000 s, without propellant: the mass stays")) << ran.out;
  const Ran burns = physim({"run", file, "--set", "shot.motor.propellant_mass=10 g"});
  EXPECT_TRUE(has(burns.out, "specific impulse 102.0 s")) << burns.out;  // 10 N s / (0.01 kg g0)
}

/// 1e-9 kg at sqrt(2) 30 m/s have 9e-7 J, and 1e9 kg have 9e11 J.
TEST(RunText, energies_of_all_sizes_have_their_digits) {
  const File file("s.toml", thrown("fidelity = \"arcade\"\n"));
  for (const auto& [mass, energy] : {std::pair("1e-9 kg", "e-07"), std::pair("1e9 kg", "e+11")})
    for (const char* command : {"run", "table"}) {
      std::vector<std::string> words = {command, file, "--set", std::string("shot.mass=") + mass};
      words.insert(words.end(), {"--set", "output.ranges=20 m"});
      EXPECT_TRUE(has(physim(words).out, energy)) << physim(words).out;
    }
}

TEST(RunText, times_of_columns_are_decimal_multiples) {
  const File file("s.toml", thrown(""));
  const Ran ran = physim({"run", file, "--csv", "-", "--interval", "0.7 s"});
  for (const char* time : {"\ns,0.7,", "\ns,1.4,", "\ns,2.1,", "\ns,4.2,", "\ns,4.9,", "\ns,5.6,"})
    EXPECT_TRUE(has(ran.out, time)) << ran.out;
}

}  // namespace physim::testing_cli::cli_run_text_test
#endif
