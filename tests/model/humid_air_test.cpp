// Moist air against published figures and another formula.
#include "model/humid_air.hpp"

#include "support.hpp"

namespace physim::model_humid_air_test {

using test::near;

double celsius(double t) { return t + 273.15; }
constexpr double kMillimetreOfMercury = 133.322387415;

// NIST SOP 2 (2019), appendix B, examples 1 and 3, by the formula of Jones (1978). CIPM-2007 lies 1e-4 higher since it
// counts more argon (Picard et al. 2008, sec. 2), so the two formulas must agree to 3e-4.
TEST(HumidAir, agrees_with_the_examples_of_nist_sop_2) {
  EXPECT_TRUE(near(moist_air_density(celsius(22.3), 748.1 * kMillimetreOfMercury, 0.37), 1.17194, 3e-4));
  EXPECT_TRUE(near(moist_air_density(celsius(23.4), 612.3 * kMillimetreOfMercury, 0.23), 0.95632, 3e-4));
}

// CIPM-2007 as computed by the package masscor (C. Gonzalez, CRAN): 10 degC, 730 mmHg, 40 %: 1.1957 kg/m3.
TEST(HumidAir, agrees_with_another_program_for_cipm_2007) {
  EXPECT_NEAR(moist_air_density(celsius(10), 730 * kMillimetreOfMercury, 0.4), 1.1957, 0.00006);
}

// The simplified exponential formula of the CIPM (OIML R 111-1 (2004), eq. E.3-1), good to 2e-4 between 900 and 1100
// hPa, 10 and 30 degC, below 80 % humidity.
TEST(HumidAir, agrees_with_the_simplified_formula_of_the_cipm) {
  for (const double t : {10.0, 15.0, 20.0, 25.0, 30.0})
    for (const double hpa : {900.0, 1000.0, 1100.0})
      for (const double humidity : {0.0, 40.0, 80.0}) {
        const double simple = (0.34848 * hpa - 0.009 * humidity * std::exp(0.061 * t)) / (273.15 + t);
        EXPECT_TRUE(near(moist_air_density(celsius(t), hpa * 100, humidity / 100), simple, 3e-4)) << t << ' ' << hpa;
      }
}

TEST(HumidAir, dry_air_holds_no_vapour_and_saturated_air_what_steam_tables_say) {
  EXPECT_EQ(vapour_fraction(celsius(20), 101325, 0), 0);
  // Saturation pressure of water at 20 degC: 2339.3 Pa (IAPWS), times the enhancement factor 1.004.
  EXPECT_TRUE(near(vapour_fraction(celsius(20), 101325, 1), 2339.3 * 1.004 / 101325, 1e-3));
  EXPECT_TRUE(near(vapour_fraction(celsius(30), 101325, 1), 4246.9 * 1.0043 / 101325, 1e-3));
}

TEST(HumidAir, moist_air_is_lighter_and_faster) {
  EXPECT_LT(moist_air_density(celsius(30), 101325, 1), moist_air_density(celsius(30), 101325, 0));
  EXPECT_GT(moist_air_sound_speed(celsius(30), 101325, 1), moist_air_sound_speed(celsius(30), 101325, 0));
}

/// Packs of dry air alone take a short way, which lanes of dry air beside others do not.
TEST(HumidAir, is_that_of_one_number_in_each_lane) {
  using Four = Pack<double, 4>;
  const double humidity[] = {0, 0.3, 0, 1};
  const Four t(celsius(25)), p(98765.0), dry(0.0), moist = Four::load(humidity);
  for (int lane = 0; lane < 4; ++lane) {
    EXPECT_EQ(moist_density(t, p, moist)[lane], moist_air_density(celsius(25), 98765, humidity[lane]));
    EXPECT_EQ(moist_sound_speed(t, p, moist)[lane], moist_air_sound_speed(celsius(25), 98765, humidity[lane]));
    EXPECT_EQ(moist_density(t, p, dry)[lane], moist_air_density(celsius(25), 98765, 0));
    EXPECT_EQ(moist_sound_speed(t, p, dry)[lane], moist_air_sound_speed(celsius(25), 98765, 0));
  }
  EXPECT_EQ(sound_over_dry(dry)[0], 1);
}

TEST(HumidAir, sound_speed_of_dry_air_is_the_standards) {
  // sqrt(1.4 * 8.31432 * 288.15 / 0.0289644), U.S. Standard Atmosphere 1976 at sea level.
  EXPECT_TRUE(near(moist_air_sound_speed(288.15, 101325, 0), 340.29410778693532873, 1e-13));
}

// O. Cramer, "The variation of the specific heat ratio and the speed of sound in air with temperature, pressure,
// humidity, and CO2 concentration", J. Acoust. Soc. Am. 93 (1993) 2510-2516, eq. 15, with 314 ppm CO2.
double cramer(double t, double p, double x_w) {
  const double x_c = 0.000314;
  return 331.5024 + 0.603055 * t - 0.000528 * t * t + (51.471935 + 0.1495874 * t - 0.000782 * t * t) * x_w +
         (-1.82e-7 + 3.73e-8 * t - 2.93e-10 * t * t) * p + (-85.20931 - 0.228525 * t + 5.91e-5 * t * t) * x_c -
         2.835149 * x_w * x_w - 2.15e-13 * p * p + 29.179762 * x_c * x_c + 0.000486 * x_w * p * x_c;
}

TEST(HumidAir, sound_speed_agrees_with_cramers_within_the_real_gas_effects_left_out) {
  for (const double t : {0.0, 10.0, 20.0, 30.0})
    for (const double p : {75000.0, 101325.0})
      for (const double humidity : {0.0, 0.5, 1.0}) {
        const double x = vapour_fraction(celsius(t), p, humidity);
        EXPECT_TRUE(near(moist_air_sound_speed(celsius(t), p, humidity), cramer(t, p, x), 1e-3)) << t << ' ' << p;
        const double gain = moist_air_sound_speed(celsius(t), p, humidity) / moist_air_sound_speed(celsius(t), p, 0);
        EXPECT_NEAR(gain, cramer(t, p, x) / cramer(t, p, 0), 2e-4) << t << ' ' << p << ' ' << humidity;
      }
}

}  // namespace physim::model_humid_air_test
