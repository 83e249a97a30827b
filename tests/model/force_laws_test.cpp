// The laws of forces against closed forms and conserved quantities, moved by a Runge-Kutta loop of this file's own.
#include "model/force_laws.hpp"

#include <functional>
#include <numbers>

#include "support.hpp"

namespace physim::model_force_laws_test {

using test::kInfinity;
using test::kNan;
using test::near;

constexpr double kPi = std::numbers::pi;
constexpr Vec3d kUp{0, 1, 0};

using Force = std::function<Vec3d(double t, const State<double>&)>;  // [N]

/// A point mass pushed by a force, from state s for a time, in n steps of the classic fourth-order method.
State<double> move(State<double> s, double mass, double time, int n, const Force& force) {
  const double h = time / n;
  const auto slope = [&](double t, const State<double>& at) { return State<double>{at.v, force(t, at) * (1 / mass)}; };
  const auto ahead = [&](const State<double>& k, double dt) { return State<double>{s.x + k.x * dt, s.v + k.v * dt}; };
  for (int i = 0; i < n; ++i) {
    const double t = i * h;
    const State<double> a = slope(t, s), b = slope(t + h / 2, ahead(a, h / 2)), c = slope(t + h / 2, ahead(b, h / 2)),
                        d = slope(t + h, ahead(c, h));
    s.x += (a.x + 2.0 * b.x + 2.0 * c.x + d.x) * (h / 6);
    s.v += (a.v + 2.0 * b.v + 2.0 * c.v + d.v) * (h / 6);
  }
  return s;
}

// ------------------------------------------------------------------------------------------------------------- drag
// Fall from rest with quadratic drag: v = vt tanh(g t / vt), y = -vt^2/g ln cosh(g t / vt), vt^2 = m g / k2.
TEST(ForceLaws, quadratic_drag_falls_towards_terminal_velocity) {
  const double m = 2, g = 9.81, k2 = 0.05, t = 4;
  const LinearQuadraticDragForce law{.k2 = k2};
  const State<double> end =
      move({}, m, t, 400, [&](double, const State<double>& s) { return kUp * (-m * g) + drag_force(law, s.v); });
  const double terminal = std::sqrt(m * g / k2);
  EXPECT_TRUE(near(end.v.y, -terminal * std::tanh(g * t / terminal), 1e-9));
  EXPECT_TRUE(near(end.x.y, -terminal * terminal / g * std::log(std::cosh(g * t / terminal)), 1e-9));
}

// With linear drag the velocity decays towards that of the wind: v = w + (v0 - w) exp(-k1 t / m).
TEST(ForceLaws, linear_drag_decays_towards_the_wind) {
  const LinearQuadraticDragForce law{.k1 = 0.3, .wind = {1, -2, 3}};
  const Vec3d v0{10, 5, -4};
  const State<double> end =
      move({{}, v0}, 0.5, 2, 200, [&](double, const State<double>& s) { return drag_force(law, s.v); });
  EXPECT_TRUE(near(end.v, law.wind + (v0 - law.wind) * std::exp(-0.3 * 2 / 0.5), 1e-9));
  EXPECT_EQ(drag_force(law, law.wind), (Vec3d{})) << "no wind is felt when drifting along";
}

// ---------------------------------------------------------------------------------------------------- springs, ropes
TEST(ForceLaws, spring_conserves_energy) {
  const AnchoredSpring law{.anchor = {1, 2, 3}, .stiffness = 40, .rest_length = 0.7};
  const double m = 0.3;
  const State<double> start{{2.5, 2, 2}, {0, 3, -1}};
  const auto energy = [&](const State<double>& s) {
    const double stretch = length(s.x - law.anchor) - law.rest_length;
    return m * length_squared(s.v) / 2 + law.stiffness * stretch * stretch / 2;
  };
  const State<double> end = move(
      start, m, 10, 20000, [&](double, const State<double>& s) { return spring_force(law, s.x - law.anchor, s.v); });
  EXPECT_TRUE(near(energy(end), energy(start), 1e-9));
  EXPECT_TRUE(near(cross(end.x - law.anchor, end.v), cross(start.x - law.anchor, start.v), 1e-9)) << "swing";
}

// Along its axis a damped spring is the textbook's oscillator: exp(-c t / 2m) (cos w t + c / (2 m w) sin w t).
TEST(ForceLaws, damped_spring_rings_down_as_in_the_textbook) {
  const double m = 1.5, k = 30, c = 2, t = 1.7, stretch = 0.4;
  const AnchoredSpring law{.anchor = {0, 5, 0}, .stiffness = k, .rest_length = 2, .damping = c};
  const State<double> end = move({{0, 3 - stretch, 0}, {}}, m, t, 2000, [&](double, const State<double>& s) {
    return spring_force(law, s.x - law.anchor, s.v);
  });
  const double rate = c / (2 * m), w = std::sqrt(k / m - rate * rate);
  const double expected = stretch * std::exp(-rate * t) * (std::cos(w * t) + rate / w * std::sin(w * t));
  EXPECT_TRUE(near(3 - end.x.y, expected, 1e-9));
}

TEST(ForceLaws, spring_damps_only_along_its_axis) {
  const AnchoredSpring law{.stiffness = 10, .rest_length = 2, .damping = 3};
  EXPECT_EQ(spring_force(law, {2, 0, 0}, {0, 5, 7}), (Vec3d{})) << "at rest length, moving across";
  EXPECT_TRUE(near(spring_force(law, {2, 0, 0}, {4, 5, 7}), {-12, 0, 0}, 1e-15));
  EXPECT_TRUE(near(spring_force(law, {0, 0, 1}, {}), {0, 0, 10}, 1e-15)) << "compressed, it pushes";
}

TEST(ForceLaws, spring_of_no_length_has_no_direction_and_no_force) {
  EXPECT_EQ(spring_force(AnchoredSpring{.stiffness = 10, .rest_length = 2, .damping = 3}, {}, {1, 2, 3}), (Vec3d{}));
  EXPECT_EQ(bungee_force(Bungee{.stiffness = 10, .damping = 3}, {}, {1, 2, 3}), (Vec3d{}));
  const double tiny = 1e-200;  // its square is no number any more
  EXPECT_TRUE(std::isfinite(length(spring_force(AnchoredSpring{.rest_length = 1}, {tiny, 0, 0}, {}))));
}

TEST(ForceLaws, bungee_only_pulls) {
  const Bungee law{.stiffness = 10, .rest_length = 2, .damping = 3};
  EXPECT_EQ(bungee_force(law, {0, -1.9, 0}, {0, -9, 0}), (Vec3d{})) << "slack";
  EXPECT_EQ(bungee_force(law, {0, -2, 0}, {0, -9, 0}), (Vec3d{})) << "straight";
  EXPECT_TRUE(near(bungee_force(law, {0, -3, 0}, {0, -2, 0}), {0, 16, 0}, 1e-15)) << "stretched, and further";
  EXPECT_TRUE(near(bungee_force(law, {0, -3, 0}, {0, 2, 0}), {0, 4, 0}, 1e-15)) << "coming back";
  EXPECT_EQ(bungee_force(law, {0, -3, 0}, {0, 20, 0}), (Vec3d{})) << "a damper cannot push through a rope";
  EXPECT_TRUE(std::isnan(bungee_force(law, {kNan, 0, 0}, {}).x)) << "nothing is hidden";
}

// A bungee jump: all the height becomes stretch, m g (l + e) = k e^2 / 2.
TEST(ForceLaws, bungee_jump_ends_where_energy_says) {
  const double m = 70, g = 9.81;
  const Bungee law{.stiffness = 80, .rest_length = 20};
  double lowest = 0;
  State<double> s{{0, -1e-9, 0}, {}};
  for (int i = 0; i < 6000; ++i) {
    s = move(s, m, 0.001, 1,
             [&](double, const State<double>& at) { return kUp * (-m * g) + bungee_force(law, at.x, at.v); });
    lowest = std::min(lowest, s.x.y);
  }
  const double stretch = (m * g + std::sqrt(m * g * (m * g + 2 * law.stiffness * law.rest_length))) / law.stiffness;
  EXPECT_TRUE(near(lowest, -(law.rest_length + stretch), 0, 1e-3));
}

// ------------------------------------------------------------------------------------------------------------ liquid
/// Volume of a ball's part under a level, as a sum of discs [m^3].
double discs_under(double level, double radius) {
  const int n = 200000;
  double volume = 0;
  for (int i = 0; i < n; ++i) {
    const double y = -radius + (i + 0.5) * 2 * radius / n;
    if (y < level) volume += kPi * (radius * radius - y * y) * 2 * radius / n;
  }
  return volume;
}

TEST(ForceLaws, lift_of_a_sphere_is_the_weight_of_the_liquid_it_displaces) {
  const double radius = 0.35;
  const Buoyancy water{.surface = 4};
  for (const double below : {-0.3, -0.2, -0.05, 0.0, 0.1, 0.25, 0.34}) {
    const Vec3d lift = buoyancy_force(water, 2 * radius, {{7, 4 - below, 9}, {}});
    EXPECT_TRUE(near(lift, kUp * (1000 * 9.80665 * discs_under(below, radius)), 1e-4, 1e-3)) << below;
  }
  const double whole = 1000 * 9.80665 * 4 / 3 * kPi * radius * radius * radius;
  EXPECT_EQ(buoyancy_force(water, 2 * radius, {{0, 4.36, 0}, {}}), (Vec3d{}));
  EXPECT_TRUE(near(buoyancy_force(water, 2 * radius, {{0, 3.6, 0}, {}}), kUp * whole, 1e-14));
  EXPECT_TRUE(near(buoyancy_force(water, 2 * radius, {{0, -100, 0}, {}}), kUp * whole, 1e-14)) << "no deeper, no more";
}

TEST(ForceLaws, a_liquid_lifts_a_body_that_is_too_small_to_halve) {
  const double least = std::numeric_limits<double>::denorm_min();
  const Buoyancy law{.surface = 1, .volume = 0.001, .damping = 0};
  const Vec3d whole = kUp * (1000 * 9.80665 * 0.001);
  EXPECT_EQ(buoyancy_force(law, least, {{0, 1.5, 0}, {}}), (Vec3d{}));
  EXPECT_TRUE(near(buoyancy_force(law, least, {{0, 0.5, 0}, {}}), whole, 1e-12));
  EXPECT_TRUE(near(buoyancy_force(law, least, {{0, 1, 0}, {}}), whole, 1e-12));
  EXPECT_TRUE(std::isnan(submerged_box(std::nan(""), 0)));
}

// A ball of part p of the water's density floats where q^2 (3 - 2 q) = p: q = 1/2 - sin(asin(1 - 2 p) / 3).
TEST(ForceLaws, sphere_comes_to_rest_at_its_floating_depth) {
  const double diameter = 0.3, volume = kPi / 6 * diameter * diameter * diameter;
  const Buoyancy water{.damping = 40};
  for (const double part : {0.1, 0.5, 0.9}) {
    const double mass = part * 1000 * volume;
    const State<double> end = move({{0, 0.2, 0}, {}}, mass, 30, 30000, [&](double, const State<double>& s) {
      return kUp * (-mass * 9.80665) + buoyancy_force(water, diameter, s);
    });
    const double under = diameter * (0.5 - std::sin(std::asin(1 - 2 * part) / 3));
    EXPECT_TRUE(near(diameter / 2 - end.x.y, under, 1e-6)) << part;
  }
}

// A floating box bobs with w^2 = rho g A / m, its area A = V / (2 depth).
TEST(ForceLaws, box_bobs_at_the_frequency_of_its_waterline) {
  const Buoyancy law{.surface = 1, .volume = 0.06, .depth = 0.2, .density = 1025, .gravity = 3.7};
  const double mass = 0.4 * law.density * law.volume, swing = 0.05, t = 2.3;
  const double rest = law.surface + law.depth * (1 - 2 * 0.4);
  const State<double> end = move({{0, rest + swing, 0}, {}}, mass, t, 2000, [&](double, const State<double>& s) {
    return kUp * (-mass * law.gravity) + buoyancy_force(law, 9, s);
  });
  const double w = std::sqrt(law.density * law.gravity * law.volume / (2 * law.depth) / mass);
  EXPECT_TRUE(near(end.x.y - rest, swing * std::cos(w * t), 1e-8));
}

TEST(ForceLaws, liquid_resists_with_the_part_under_it) {
  const Buoyancy law{.surface = 0, .volume = 1, .depth = 1, .damping = 6, .gravity = 0};
  EXPECT_TRUE(near(buoyancy_force(law, 1, {{0, 0.5, 0}, {2, 0, -4}}), {-3, 0, 6}, 1e-15)) << "a quarter";
  EXPECT_EQ(buoyancy_force(law, 1, {{0, 1.5, 0}, {2, 0, -4}}), (Vec3d{}));
}

// --------------------------------------------------------------------------------------------------------- attractor
// Kepler: an ellipse of half axis a closes after 2 pi sqrt(a^3 / mu), whatever the mass; half way it is at a (1 + e).
TEST(ForceLaws, attractor_holds_kepler_orbits) {
  const PointAttractor sun{.centre = {3, -2, 5}, .strength = 8};
  const double a = 2, e = 0.4, mass = 0.7;
  const Vec3d axis = normalized(Vec3d{1, 2, 2}), across = normalized(Vec3d{2, -1, 0});
  const State<double> start{sun.centre + axis * (a * (1 - e)),
                            across * std::sqrt(sun.strength / a * (1 + e) / (1 - e))};
  const Force pull = [&](double, const State<double>& s) { return attractor_force(sun, mass, s.x); };
  const double period = 2 * kPi * std::sqrt(a * a * a / sun.strength);
  EXPECT_TRUE(near(move(start, mass, period / 2, 5000, pull).x, sun.centre - axis * (a * (1 + e)), 1e-9));
  const State<double> end = move(start, mass, period, 10000, pull);
  EXPECT_TRUE(near(end.x, start.x, 1e-9));
  EXPECT_TRUE(near(end.v, start.v, 1e-9));
}

TEST(ForceLaws, softened_attractor_conserves_energy_through_its_centre) {
  const PointAttractor law{.strength = 3, .softening = 0.2};
  const auto energy = [&](const State<double>& s) {
    return length_squared(s.v) / 2 - law.strength / std::sqrt(length_squared(s.x) + 0.04);
  };
  const State<double> start{{1, 0, 0}, {0, 0.02, 0}};
  const State<double> end =
      move(start, 5, 20, 200000, [&](double, const State<double>& s) { return attractor_force(law, 5, s.x); });
  EXPECT_TRUE(near(energy(end), energy(start), 1e-9));
  EXPECT_EQ(attractor_force(law, 5, {}), (Vec3d{}));
}

TEST(ForceLaws, attractor_at_its_very_centre_gives_nothing_and_repels_where_negative) {
  EXPECT_EQ(attractor_force({.centre = {1, 2, 3}}, 1, {1, 2, 3}), (Vec3d{}));
  EXPECT_TRUE(near(attractor_force({.strength = -8}, 3, {0, 2, 0}), {0, 6, 0}, 1e-15));
  EXPECT_TRUE(near(attractor_force({.strength = 8}, 3, {0, 2, 0}), {0, -6, 0}, 1e-15));
}

// -------------------------------------------------------------------------------------------------------- wind zones
TEST(ForceLaws, borders_belong_to_a_zone) {
  const WindZone zone{.low = {-1, 0, 2}, .high = {1, 5, kInfinity}};
  EXPECT_TRUE(is_inside(zone, {0, 1, 3}));
  EXPECT_TRUE(is_inside(zone, zone.low));
  EXPECT_TRUE(is_inside(zone, {1, 5, 1e300}));
  for (const Vec3d& outside : {Vec3d{1.01, 1, 3}, {-1.01, 1, 3}, {0, -0.1, 3}, {0, 5.1, 3}, {0, 1, 1.9}, {kNan, 1, 3}})
    EXPECT_FALSE(is_inside(zone, outside)) << outside.x << ' ' << outside.y << ' ' << outside.z;
}

// ------------------------------------------------------------------------------------------------------------- blast
TEST(ForceLaws, blast_falls_linearly_to_its_radius) {
  const Explosion law{.centre = {1, 1, 1}, .force = 100, .radius = 4};
  EXPECT_TRUE(near(explosion_force(law, {1, 2, 1}), {0, 75, 0}, 1e-15));
  EXPECT_TRUE(near(explosion_force(law, {1, 1, -1}), {0, 0, -50}, 1e-15));
  EXPECT_EQ(explosion_force(law, {5, 1, 1}), (Vec3d{}));
  EXPECT_EQ(explosion_force(law, {900, 1, 1}), (Vec3d{}));
  EXPECT_TRUE(near(length(explosion_force(law, {1 + 1e-9, 1, 1})), 100, 1e-9)) << "the whole force next to the centre";
  EXPECT_EQ(explosion_force(law, law.centre), (Vec3d{}));
  EXPECT_TRUE(std::isfinite(length(explosion_force(law, {1 + 1e-200, 1, 1}))));
}

// The work from r to the radius, F0 (R - r)^2 / (2 R), becomes kinetic energy.
TEST(ForceLaws, blast_does_the_work_under_its_line) {
  const Explosion law{.force = 50, .radius = 3};
  const State<double> end = move({{0.5, 0, 0}, {}}, 0.2, 2, 200000,
                                 [&](double, const State<double>& s) { return explosion_force(law, s.x); });
  EXPECT_GT(end.x.x, law.radius);
  EXPECT_TRUE(near(0.2 * length_squared(end.v) / 2, 50 * 2.5 * 2.5 / 6, 1e-9));
}

// ------------------------------------------------------------------------------------------------------------ thrust
const std::vector<Thrust::Point> kMotor{{0.25, 10}, {0.5, 40}, {1.5, 30}, {2, 0}};

TEST(ForceLaws, thrust_follows_its_table_and_is_over_at_its_last_point) {
  const struct {
    double time, force;
  } rows[] = {{0, 0}, {0.24, 0}, {0.25, 10}, {0.375, 25}, {0.5, 40}, {1, 35}, {1.5, 30}, {1.75, 15}, {2, 0}, {9, 0}};
  for (const auto& row : rows) EXPECT_TRUE(near(thrust_at(kMotor, row.time), row.force, 1e-14)) << row.time;
  const std::vector<Thrust::Point> steady{{0, 5}, {2, 5}};
  EXPECT_EQ(thrust_at(steady, 0), 5);
  EXPECT_EQ(thrust_at(steady, 2), 0);
  EXPECT_EQ(thrust_at({}, 1), 0);
  EXPECT_EQ(thrust_at(steady, kNan), 0);
}

// m dv is the area under the table: 6.25 + 35 + 7.5 N s. Steps that end on the points integrate straight lines exactly.
TEST(ForceLaws, impulse_of_a_thrust_is_the_area_under_its_table) {
  const Thrust law{.curve = kMotor, .direction = {0, 3, 4}};
  const State<double> end = move({}, 2, 3, 120000, [&](double t, const State<double>& s) {
    return thrust_direction(law, s.v) * thrust_at(law.curve, t);
  });
  EXPECT_TRUE(near(end.v * 2.0, Vec3d{0, 0.6, 0.8} * 48.75, 1e-5));
}

TEST(ForceLaws, thrust_points_along_its_direction_or_along_the_velocity) {
  EXPECT_TRUE(near(thrust_direction({.direction = {0, 0, -9}}, {1, 2, 3}), {0, 0, -1}, 1e-15));
  EXPECT_TRUE(near(thrust_direction({}, {0, 3, -4}), {0, 0.6, -0.8}, 1e-15));
  EXPECT_EQ(thrust_direction({}, {}), (Vec3d{})) << "at rest";
}

}  // namespace physim::model_force_laws_test
