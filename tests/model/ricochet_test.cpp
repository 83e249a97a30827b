// Ricochet off liquids: Birkhoff's pressure summed over a sphere that is followed through its ricochet, and the angle
// of Johnson and Reid.
#include "model/ricochet.hpp"

#include "support.hpp"

namespace physim::model_ricochet_test {

using test::kDegree;
using test::near;

/// Pressure 1/2 (n . x)^2 summed over the wetted front of a sphere of radius 1 that moves along x: lift and drag, over
/// density and the square of its speed. `depth` is that of its lowest point.
std::pair<double, double> summed_force(double depth) {
  constexpr int kRings = 200, kAround = 24;
  const double edge = std::acos(1 - depth), half_pi = 90 * kDegree;
  double lift = 0, drag = 0;
  for (int i = 0; i < kRings; ++i)
    for (int j = 0; j < kAround; ++j) {
      const double polar = edge * (i + 0.5) / kRings, about = half_pi * (j + 0.5) / kAround;
      const double x = std::sin(polar) * std::cos(about), down = std::cos(polar);
      const double area = 2 * std::sin(polar) * (edge / kRings) * (half_pi / kAround);  // on both sides of the middle
      lift += 0.5 * x * x * down * area;
      drag += 0.5 * x * x * x * area;
    }
  return {lift, drag};
}

/// The same, between depths that were summed once.
std::pair<double, double> force_of(double depth) {
  constexpr int kDepths = 400;
  static const std::vector<std::pair<double, double>> table = [] {
    std::vector<std::pair<double, double>> forces;
    for (int i = 0; i <= kDepths; ++i) forces.push_back(summed_force(2.0 * i / kDepths));
    return forces;
  }();
  const double at = std::clamp(depth / 2, 0.0, 1.0) * kDepths;
  const auto low = std::min(static_cast<std::size_t>(at), table.size() - 2);
  const double part = at - static_cast<double>(low);
  return {std::lerp(table[low].first, table[low + 1].first, part),
          std::lerp(table[low].second, table[low + 1].second, part)};
}

struct Course {
  bool out;
  double kept;  // of the speed
};

/// A sphere followed through the liquid: its speed along the surface taken as constant for the lift, as the theory has
/// it, while the drag is summed up.
Course follow(double specific_gravity, double angle) {
  const double mass = specific_gravity * 4 * 3.14159265358979323846 / 3, step = 0.02;
  double depth = 0, rate = angle, lost = 0;  // rate: of depth over way
  while (true) {
    const double middle_rate = rate - 0.5 * step * force_of(depth).first / mass, middle = depth + 0.5 * step * rate;
    const auto [lift, drag] = force_of(middle);
    depth += step * middle_rate;
    rate -= step * lift / mass;
    lost += step * drag / mass;
    if (depth >= 2) return {false, 0};
    if (depth <= 0) return {true, std::exp(-lost)};
  }
}

TEST(Ricochet, critical_angle_off_water_is_that_of_johnson_and_reid) {
  for (const double s : {1.2, 2.7, 7.8, 11.3})
    EXPECT_TRUE(near(liquid_critical_angle(s) / kDegree, 18 / std::sqrt(s), 0.01)) << s;
}

TEST(Ricochet, a_sphere_followed_through_the_liquid_comes_out_below_the_critical_angle_alone) {
  for (const double s : {2.7, 7.8}) {
    const double critical = liquid_critical_angle(s);
    EXPECT_TRUE(follow(s, 0.99 * critical).out) << s;
    EXPECT_FALSE(follow(s, 1.01 * critical).out) << s;
  }
}

TEST(Ricochet, a_sphere_followed_through_the_liquid_loses_the_speed_that_is_told) {
  for (const double s : {2.7, 7.8})
    for (const double part : {0.2, 0.5, 0.8, 0.95}) {
      const double angle = part * liquid_critical_angle(s);
      EXPECT_NEAR(liquid_speed_kept(s, angle), follow(s, angle).kept, 0.002) << s << ' ' << part;
    }
}

// Where the sphere hardly dips in, sin b = b = sqrt(2 z): J = 2^(5/2) / 5 z_m^2 sqrt(4/5) B(7/6, 1/2) / 3.
TEST(Ricochet, flat_angles_lose_speed_by_the_closed_form_of_shallow_dips) {
  const double beta = std::tgamma(7.0 / 6) * std::tgamma(0.5) / std::tgamma(5.0 / 3);
  for (const double s : {1.0, 7.8}) {
    const double x = 1e-8, deepest = std::cbrt(0.8 * x);
    const double integral = std::pow(2, 2.5) / 5 * deepest * deepest * std::sqrt(0.8) * beta / 3;
    const double lost = std::sqrt(10 / s) / 3.14159265358979323846 * integral;
    EXPECT_TRUE(near(-std::log(liquid_speed_kept(s, 1e-4 * liquid_critical_angle(s))), lost, 0.003)) << s;
  }
}

TEST(Ricochet, the_flatter_the_more_speed_is_kept) {
  const double critical = liquid_critical_angle(7.8);
  double before = 1;
  EXPECT_EQ(liquid_speed_kept(7.8, 0), 1);
  for (int i = 1; i < 1000; ++i) {
    const double kept = liquid_speed_kept(7.8, critical * i / 1000);
    EXPECT_LT(kept, before);
    EXPECT_GT(kept, 0);
    before = kept;
  }
}

}  // namespace physim::model_ricochet_test
