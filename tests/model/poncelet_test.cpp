// Poncelet's law: beside its equation of motion integrated step by step, a shot of Forrestal's, and the woods of Metz.
#include "model/poncelet.hpp"

#include "model/nose.hpp"
#include "support.hpp"

namespace physim::model_poncelet_test {

using test::near;

constexpr double kArea = 3.14159265358979323846 / 4;  // of a circle of diameter 1

/// v^2 at a depth, or the depth where it is 0, by Runge-Kutta steps in depth.
struct Marched {
  double depth, speed;
};
Marched march(const Bore& b, double speed, double end) {
  double factor = 1;  // of the resistance at the crater's depth: by its speed there, found by bisection
  const auto slope = [&](double x, double v_2) {
    const double grown = b.crater > 0 && x < b.crater ? factor * x / b.crater : b.strength + b.inertia * v_2;
    return -2 * b.area / b.mass * grown;
  };
  const auto run = [&](double until) {
    constexpr int kSteps = 20000;
    double x = 0, v_2 = speed * speed;
    const double h = until / kSteps;
    for (int i = 0; i < kSteps; ++i) {
      const double k1 = slope(x, v_2), k2 = slope(x + h / 2, v_2 + h / 2 * k1), k3 = slope(x + h / 2, v_2 + h / 2 * k2),
                   k4 = slope(x + h, v_2 + h * k3);
      const double next = v_2 + h / 6 * (k1 + 2 * k2 + 2 * k3 + k4);
      if (next <= 0) return std::pair(x + h * v_2 / (v_2 - next), 0.0);
      x += h, v_2 = next;
    }
    return std::pair(x, v_2);
  };
  if (b.crater > 0) {
    // The slope in the crater must end as the tunnel begins: its force F fulfils F = R + q v_1^2(F).
    double low = 0, high = 2 * (b.strength + b.inertia * speed * speed);
    for (int i = 0; i < 60; ++i) {
      factor = 0.5 * (low + high);
      const double v_1 = speed * speed - factor * b.area * b.crater / b.mass;
      (factor > b.strength + b.inertia * v_1 ? high : low) = factor;
    }
  }
  const auto [x, v_2] = run(end);
  return {x, std::sqrt(v_2)};
}

TEST(Poncelet, speeds_and_depths_are_those_of_the_equation_of_motion) {
  for (const double inertia : {0.0, 200.0, 1200.0})
    for (const double crater : {0.0, 0.05}) {
      const Bore bore{.mass = 0.9, .area = 6e-4, .strength = 4e8, .inertia = inertia, .crater = crater};
      for (const double speed : {60.0, 200.0, 600.0}) {
        const double depth = poncelet_depth(bore, speed);
        EXPECT_TRUE(near(march(bore, speed, depth * 1.2).depth, depth, 1e-3))
            << inertia << ' ' << crater << ' ' << speed;
        for (const double part : {0.1, 0.5, 0.9})
          EXPECT_TRUE(near(poncelet_speed(bore, speed, part * depth), march(bore, speed, part * depth).speed, 1e-6))
              << inertia << ' ' << crater << ' ' << speed << ' ' << part;
        EXPECT_NEAR(poncelet_speed(bore, speed, depth) / speed, 0, 1e-6);
      }
    }
}

// Forrestal et al. 1994, table 3, shot 14, as in Li and Chen 2003, table 2: steel of 0.906 kg and 26.9 mm, an ogive of
// calibre radius 2, 277 m/s, concrete of 35.2 MPa with S = 12: X/d = 6.21 by their formula, 6.43 (173 mm) in the test.
TEST(Poncelet, a_shot_into_concrete_goes_as_deep_as_forrestals) {
  const double diameter = 0.0269, nose = std::sqrt(2 - 0.25);
  EXPECT_NEAR(nose_factor(nose), 0.156, 0.0005);
  Bore bore{.mass = 0.906,
            .area = kArea * diameter * diameter,
            .strength = 12 * 35.2e6,
            .inertia = nose_factor(nose) * 2370,
            .crater = 2 * diameter};
  EXPECT_NEAR(poncelet_depth(bore, 277) / diameter, 6.21, 0.01);
  bore.strength = concrete_strength(35.2e6);
  EXPECT_TRUE(near(bore.strength, 12 * 35.2e6, 0.01));
  EXPECT_TRUE(near(poncelet_depth(bore, 277), 0.173, 0.04));
}

TEST(Poncelet, noses_are_as_sharp_as_those_of_li_and_chen) {
  EXPECT_EQ(nose_factor(0), 1);
  EXPECT_DOUBLE_EQ(nose_factor(0.5), 0.5);
  EXPECT_NEAR(nose_factor(0.5 + 1e-9), 0.5, 1e-8);
  EXPECT_NEAR(nose_factor(std::sqrt(3 - 0.25)), 0.106, 0.001);
  for (double length = 0; length < 5; length += 0.01) EXPECT_GT(nose_factor(length), nose_factor(length + 0.01));
}

// A nose's factor is the mean of the squared cosine between its normal and its way, over its cross section.
TEST(Poncelet, the_factor_of_a_nose_is_the_integral_over_its_profile) {
  for (const double length : {0.1, 0.3, 0.5, 0.8, 1.5, 3.0}) {
    // Profile of a tangent ogive or of a spherical cap of a diameter of 1.
    const double psi = length > 0.5 ? length * length + 0.25 : (length * length + 0.25) / (2 * length);
    double sum = 0;
    constexpr int kRings = 200000;
    for (int i = 0; i < kRings; ++i) {
      const double radius = 0.5 * (i + 0.5) / kRings;
      // Sine of the angle between the way and the profile's tangent.
      const double along = length > 0.5 ? (radius + psi - 0.5) / psi : 0;
      const double cosine = length > 0.5 ? std::sqrt(1 - along * along) : std::sqrt(1 - radius * radius / (psi * psi));
      sum += cosine * cosine * 8 * radius * (0.5 / kRings);
    }
    EXPECT_NEAR(nose_factor(length), sum, 1e-6) << length;
  }
}

// Piobert and Morin, Comptes rendus 1 (1835) 14: the ratio of m v^2 to the volume of the impression is 3 940 000
// kgf/m^2 in fir and 6 020 000 in oak.
TEST(Poncelet, woods_take_the_energy_that_was_measured_at_metz) {
  for (const auto& [material, ratio] : {std::pair(materials::fir(), 3.94e6), std::pair(materials::oak(), 6.02e6)}) {
    const double diameter = 0.1486, mass = 12;  // a shot of 24 pounds
    const auto hit = impact({.mass = mass, .diameter = diameter, .velocity = {0, -300, 0}}, material);
    ASSERT_TRUE(hit && hit->kind == ImpactKind::stopped);
    const double volume = kArea * diameter * diameter * hit->depth;
    EXPECT_TRUE(near(mass * 300 * 300 / volume / 9.80665, ratio, 1e-12)) << material.name;
  }
}

TEST(Poncelet, a_way_is_the_sum_of_its_parts) {
  const Bore bore{.mass = 0.01, .area = 5e-5, .strength = 2e7, .inertia = 100, .crater = 0};
  const double middle = poncelet_speed(bore, 800, 0.1);
  EXPECT_TRUE(near(poncelet_speed(bore, middle, 0.2), poncelet_speed(bore, 800, 0.3), 1e-14));
  EXPECT_TRUE(near(poncelet_depth(bore, middle), poncelet_depth(bore, 800) - 0.1, 1e-13));
}

TEST(Poncelet, in_a_liquid_the_speed_falls_exponentially) {
  const Bore bore{.mass = 0.5, .area = 2e-3, .strength = 0, .inertia = 250, .crater = 0};
  EXPECT_EQ(poncelet_depth(bore, 100), kInfinity);
  for (const double depth : {0.1, 1.0, 5.0})
    EXPECT_TRUE(near(poncelet_speed(bore, 100, depth), 100 * std::exp(-2e-3 * 250 * depth / 0.5), 1e-11));
}

TEST(Poncelet, little_inertia_comes_to_the_limit_of_none) {
  Bore bore{.mass = 0.01, .area = 5e-5, .strength = 2e7, .inertia = 0, .crater = 0.01};
  const double depth = poncelet_depth(bore, 500), speed = poncelet_speed(bore, 500, 0.5 * depth);
  bore.inertia = 1e-9;
  EXPECT_TRUE(near(poncelet_depth(bore, 500), depth, 1e-10));
  EXPECT_TRUE(near(poncelet_speed(bore, 500, 0.5 * depth), speed, 1e-10));
}

}  // namespace physim::model_poncelet_test
