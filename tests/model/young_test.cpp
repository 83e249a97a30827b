// Young's equations: as printed, in both systems of units, and back from depths to speeds.
#include "model/young.hpp"

#include "model/nose.hpp"
#include "support.hpp"

namespace physim::model_young_test {

using test::near;

TEST(Young, depths_are_those_of_the_printed_equations) {
  const double mass = 300, area = 0.07, s = 5, nose = 0.18 * 2 + 0.56;
  const double reach = young_reach(s, 2, mass, area, false);
  const double factor = s * nose * std::pow(mass / area, 0.7);
  EXPECT_TRUE(near(young_depth(reach, 250), 0.000018 * factor * (250 - 30.5), 1e-14));
  EXPECT_TRUE(near(young_depth(reach, 40), 0.0008 * factor * std::log(1 + 2.15e-4 * 40 * 40), 1e-13));
}

// D [ft] = 0.00178 S N (W / A)^0.7 (V - 100), with W [lb], A [in^2] and V [ft/s]: rounded constants.
TEST(Young, the_equation_in_feet_and_pounds_agrees) {
  const double pounds = 500, square_inches = 60, feet_per_second = 800, s = 6;
  const double feet = 0.00178 * s * 0.56 * std::pow(pounds / square_inches, 0.7) * (feet_per_second - 100);
  const double reach = young_reach(s, 0, pounds * 0.45359237, square_inches * 0.0254 * 0.0254, false);
  EXPECT_TRUE(near(young_depth(reach, feet_per_second * 0.3048), feet * 0.3048, 0.01));
}

TEST(Young, light_penetrators_go_less_deep) {
  const auto correction = [](double mass, bool hard) {
    return young_reach(1, 0, mass, 0.01, hard) / (0.56 * std::pow(mass / 0.01, 0.7));
  };
  EXPECT_NEAR(correction(5, false), 0.27 * std::pow(5, 0.4), 1e-14);
  EXPECT_NEAR(correction(50, true), 0.46 * std::pow(50, 0.15), 1e-14);
  EXPECT_NEAR(correction(27, false), 1, 1e-14);
  EXPECT_NEAR(correction(182, true), 1, 1e-14);
  // The corrections were made to end where they reach 1.
  EXPECT_NEAR(correction(26.999, false), 1, 0.011);
  EXPECT_NEAR(correction(181.999, true), 1, 0.011);
}

TEST(Young, the_branches_meet_as_well_as_they_were_published) {
  EXPECT_NEAR(young_depth(1, 61) / young_depth(1, 61 - 1e-9), 1.167, 0.001);
}

TEST(Young, speeds_are_found_back_from_depths) {
  const double reach = young_reach(5, 1.5, 20, 0.01, false);
  for (const double speed : {1e-3, 1.0, 30.0, 60.9, 61.0, 100.0, 1000.0})
    EXPECT_TRUE(near(young_speed(reach, young_depth(reach, speed)), speed, 1e-12)) << speed;
  EXPECT_EQ(young_speed(reach, 0), 0);
  // Between the branches there is one speed.
  EXPECT_EQ(young_speed(reach, 0.95 * young_depth(reach, 61)), 61);
}

}  // namespace physim::model_young_test
