// Plates: the balance of Recht and Ipson, Lambert's rods in the units they were published in, de Marre's examples.
#include "model/de_marre.hpp"
#include "model/lambert_jonas.hpp"
#include "model/recht_ipson.hpp"
#include "support.hpp"

namespace physim::model_armour_test {

using test::near;

// What the plate takes is the same at all speeds: the energy that came, less that of shot and plug behind, less what an
// inelastic blow between them takes.
TEST(RechtIpson, the_plate_takes_a_constant_energy_beside_that_of_the_blow) {
  const double mass = 0.197, plug = 0.031, limit = 184;
  const double a = plug_share(mass, plug);
  const auto taken = [&](double speed) {
    const double behind = residual_speed(speed, limit, a, 2);
    const double blow = 0.5 * speed * speed * mass * plug / (mass + plug);
    return 0.5 * mass * speed * speed - 0.5 * (mass + plug) * behind * behind - blow;
  };
  for (const double speed : {184.0, 185.0, 250.0, 900.0}) EXPECT_TRUE(near(taken(speed), taken(limit), 1e-9)) << speed;
}

TEST(RechtIpson, sharp_noses_lose_a_constant_energy) {
  EXPECT_DOUBLE_EQ(residual_speed(500, 300, 1, 2), 400);
  EXPECT_EQ(residual_speed(300, 300, 1, 2), 0);
  EXPECT_EQ(residual_speed(500, 0, 0.9, 3), 450);
}

TEST(RechtIpson, the_form_of_lambert_and_jonas_has_its_limits) {
  for (const double p : {1.0, 2.0, 2.5, 6.0}) {
    EXPECT_TRUE(
        near(residual_speed(700, 400, 0.8, p), 0.8 * std::pow(std::pow(700, p) - std::pow(400, p), 1 / p), 1e-13));
    EXPECT_TRUE(near(residual_speed(4e6, 400, 0.8, p), 0.8 * 4e6, 1.1e-4)) << "far above the limit: a v";
  }
}

// v_l = 4000 (L / D)^0.15 sqrt(f(z) D^3 / M) with D in cm and M in g.
TEST(LambertJonas, the_limit_is_that_of_centimetres_and_grams) {
  const double diameter_cm = 0.9, length_cm = 9, mass_g = 98, thickness_cm = 2.54, obliquity = 0.7;
  const double z = thickness_cm * std::pow(1 / std::cos(obliquity), 0.75) / diameter_cm;
  const double expected = 4000 * std::pow(length_cm / diameter_cm, 0.15) *
                          std::sqrt((z + std::exp(-z) - 1) * std::pow(diameter_cm, 3) / mass_g);
  const LongRod rod{mass_g * 1e-3, diameter_cm * 1e-2, length_cm * 1e-2};
  const double way = thickness_cm * 1e-2 / std::cos(obliquity);
  EXPECT_TRUE(near(lambert_z(way, rod.diameter, std::cos(obliquity)), z, 1e-14));
  EXPECT_TRUE(near(lambert_limit(4000, rod, z), expected, 1e-13));
}

TEST(LambertJonas, thin_plates_take_a_speed_by_their_thickness_and_thick_ones_by_its_root) {
  const LongRod rod{0.1, 0.01, 0.1};
  EXPECT_TRUE(near(lambert_limit(4000, rod, 2e-6) / lambert_limit(4000, rod, 1e-6), 2, 1e-6));
  EXPECT_TRUE(near(lambert_limit(4000, rod, 2e-4) / lambert_limit(4000, rod, 1e-4), 2, 1e-4));
  EXPECT_TRUE(near(lambert_limit(4000, rod, 401) / lambert_limit(4000, rod, 101), 2, 1e-12));
}

TEST(LambertJonas, plates_are_found_back_from_speeds) {
  const LongRod rod{0.1, 0.01, 0.1};
  for (const double z : {1e-6, 1e-3, 0.5, 1.0, 3.0, 50.0})
    EXPECT_TRUE(near(lambert_passed(1750, rod, lambert_limit(1750, rod, z)), z, 1e-9)) << z;
}

TEST(LambertJonas, a_third_of_the_plug_is_carried) {
  const LongRod rod{0.065, 0.0078, 0.078};
  const double z = 3.3, plug = 7850 * (3.14159265358979323846 / 4) * std::pow(0.0078, 3) * z;
  const LambertResidual residual = lambert_residual(rod, 7850, z);
  EXPECT_TRUE(near(residual.a, 0.065 / (0.065 + plug / 3), 1e-14));
  EXPECT_TRUE(near(residual.p, 2 + 1.1, 1e-14));
}

constexpr double kInch = 0.0254, kPound = 0.45359237, kFoot = 0.3048;

// Naval Ordnance (1937), problem II: a shot of 10 inches and 500 pounds just goes through 15.77 inches of nickel steel
// at 1772 ft/s. Problem IV: one of 6 inches and 105 pounds that needs 1836 ft/s for 7 inches tells of a quality
// of 1.23.
TEST(DeMarre, the_examples_of_the_textbook) {
  EXPECT_NEAR(de_marre_limit(1, 10 * kInch, 500 * kPound, 15.77 * kInch, 1) / kFoot, 1772, 0.5);
  EXPECT_NEAR(de_marre_thickness(1, 10 * kInch, 500 * kPound, 1772 * kFoot, 1) / kInch, 15.77, 0.005);
  EXPECT_NEAR(1836 * kFoot / de_marre_limit(1, 6 * kInch, 105 * kPound, 7 * kInch, 1), 1.23, 0.005);
}

// MIL-DTL-12560K, tables A-V and A-VI: the limit of the 90 mm M82 shot at 45 degrees is 1.30 times that at 30 degrees.
TEST(DeMarre, obliquity_is_met_by_a_first_guess) {
  const auto limit = [](double degrees) { return de_marre_limit(1, 0.09, 11, 0.1, std::cos(degrees * test::kDegree)); };
  EXPECT_NEAR(limit(45) / limit(30), 1.30, 0.08);
}

TEST(DeMarre, the_constant_is_that_of_feet_inches_and_pounds) {
  // log v = 3.00945 + 0.75 log d + 0.70 log T - 0.5 log w
  for (const double d : {3.0, 16.0})
    for (const double t : {2.0, 12.0}) {
      const double w = 0.5 * d * d * d,
                   feet = std::pow(10, 3.00945) * std::pow(d, 0.75) * std::pow(t, 0.7) / std::sqrt(w);
      EXPECT_TRUE(near(de_marre_limit(1, d * kInch, w * kPound, t * kInch, 1), feet * kFoot, 1e-13));
    }
}

TEST(DeMarre, a_plate_of_a_given_quality_is_met_aslant) {
  const double straight = de_marre_limit(1, 0.1, 10, 0.1, 1);
  EXPECT_TRUE(near(de_marre_limit(1.2, 0.1, 10, 0.1, 0.5), 2.4 * straight, 1e-14));
  EXPECT_TRUE(near(de_marre_thickness(1.2, 0.1, 10, 2.4 * straight, 0.5), 0.1, 1e-13));
  EXPECT_EQ(de_marre_thickness(1, 0.1, 10, 0, 1), 0);
}

}  // namespace physim::model_armour_test
