// Tables of studies are in the units of the file and of the options.
#include <gtest/gtest.h>

#include "cli/program.hpp"

#ifdef PHYSIM_CLI

namespace physim::testing_cli {
namespace cli_cases_units_test {

constexpr const char* kRifle = R"(physim = 1
[[shot]]
mass = "140 gr"
diameter = "0.264 in"
drag = { table = "g7", ballistic_coefficient = "0.315 lb/in^2" }
speed = "2710 ft/s"
sight = { height = "1.5 in", zero_range = "100 yd" }
fidelity = "small_arms"
[until]
ground = "off"
range = "800 yd"
[study]
inputs = [
  "shot.speed = +- 10 ft/s",
  "shot.azimuth = +- 0.1 mrad",
  "environment.atmosphere.temperature = 59 degF +- 9 degF",
]
targets = ["plate: rectangle 45 cm x 75 cm"]
shots = 4096
)";

/// Ranges in yards are told in yards, and what lies beside them in inches: 0.1 mrad at 600 yd are 2.16 in.
TEST(CasesOfUnits, a_study_over_ranges_tells_them_in_their_unit) {
  const Folder folder;
  const std::string file = folder.write("r.toml", kRifle);
  const Ran yards = physim({"study", file, "--ranges", "600 yd .. 800 yd step 200 yd"});
  ASSERT_EQ(yards.code, 0) << yards.err;
  EXPECT_TRUE(has(yards.out, "range [yd]  right +- [in]")) << yards.out;
  const std::size_t row = yards.out.find("\n         600 ");
  ASSERT_NE(row, std::string::npos) << yards.out;
  EXPECT_NEAR(std::stod(yards.out.substr(row + 13)), 2.16, 0.1) << yards.out;
  const Ran metres = physim({"study", file, "--ranges", "600 m"});
  EXPECT_TRUE(has(metres.out, "range [m]  right +- [m]")) << metres.out;
}

/// The table of inputs has what the file says, with its unit: 10 ft/s, 0.1 mrad, 9 degF.
TEST(CasesOfUnits, inputs_of_a_study_are_told_in_the_units_of_the_file) {
  const Folder folder;
  const Ran ran = physim({"study", folder.write("r.toml", kRifle)});
  ASSERT_EQ(ran.code, 0) << ran.err;
  for (const auto& [input, deviation] : {std::pair{"shot.speed [ft/s]", " 10 "},
                                         {"shot.azimuth [mrad]", " 0.1 "},
                                         {"environment.atmosphere.temperature [degF]", " 9 "}}) {
    const std::size_t at = ran.out.find(input);
    ASSERT_NE(at, std::string::npos) << input << ran.out;
    EXPECT_TRUE(has(ran.out.substr(at, ran.out.find('\n', at) - at).substr(0, 60), deviation)) << ran.out;
  }
  EXPECT_TRUE(has(ran.out, "with shot.speed += ") && has(ran.out, " ft/s, shot.azimuth += ")) << ran.out;
}

}  // namespace cli_cases_units_test
}  // namespace physim::testing_cli

#endif
