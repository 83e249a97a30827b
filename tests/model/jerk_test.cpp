// Jerk, against closed forms, and against how the acceleration changes along paths that were flown.
#include "model/jerk.hpp"

#include "rigid.hpp"

namespace physim::model_jerk_test {

using test::near;

Fidelity exact(DragModel drag) {
  Fidelity f = Fidelity::reference();
  f.gravity = GravityModel::constant;
  f.drag = drag;
  f.wind = WindModel::off;
  f.earth = EarthModel::flat;
  f.rotation = RotationModel::none;
  f.aerodynamic_jump = false;
  return f;
}

constexpr Launch kUp{.position = {0, 100, 0}, .velocity = Vec3d{0, 30, 0}};
const Until kOneSecond{.ground = std::nullopt, .time = 1};

TEST(Jerk, of_constant_gravity_is_zero) {
  for (Fidelity f : {exact(DragModel::off), Fidelity::classic(), Fidelity::arcade()}) {
    const Flight flight = fly({}, {.velocity = Vec3d{30, 20, 5}}, {}, f, {}, kOneSecond);
    for (const double t : {0.0, 0.3, 1.0}) EXPECT_LT(length(flight.jerk(t)), 1e-9) << t;
  }
}

/// a = g - k v: j = -k a, in each axis.
TEST(Jerk, of_linear_drag_and_of_damping) {
  const double k = 0.7;
  const ProjectileDef linear{.mass = 2, .drag = {.k1 = 2 * k}};
  const ProjectileDef damped{.mass = 2, .drag = {.damping = std::exp(-k)}};
  for (const auto& [projectile, drag] :
       {std::pair(linear, DragModel::linear_quadratic), std::pair(damped, DragModel::damping)})
    for (const Motion motion : {Motion::force, Motion::closed_form, Motion::velocity}) {
      if (motion == Motion::velocity && drag == DragModel::linear_quadratic) continue;
      Fidelity f = exact(drag);
      f.motion = motion;
      const Flight flight = fly(projectile, {.velocity = Vec3d{30, 20, 5}}, {}, f, {}, kOneSecond);
      for (const double t : {0.0, 0.25, 0.99}) {
        const double decayed = std::exp(-k * t);
        const Vec3d v = Vec3d{30, 20, 5} * decayed + Vec3d{0, -9.80665, 0} * ((1 - decayed) / k);
        const Vec3d a = Vec3d{0, -9.80665, 0} - v * k;
        EXPECT_TRUE(near(flight.jerk(t), a * -k, 1e-6)) << t << name(motion) << name(drag);
      }
    }
}

/// Straight up: a = -g - b v^2, v = w tan(c - g t / w), w = sqrt(g / b); j = -2 b v a.
TEST(Jerk, of_quadratic_drag_on_a_vertical_flight) {
  const double b = 0.02, g = 9.80665, w = std::sqrt(g / b), c = std::atan(30 / w);
  const Flight flight =
      fly({.mass = 5, .drag = {.k2 = 5 * b}}, kUp, {}, exact(DragModel::linear_quadratic), {}, kOneSecond);
  for (const double t : {0.0, 0.2, 0.5, 0.9}) {
    const double v = w * std::tan(c - g * t / w), a = -g - b * v * v;
    EXPECT_TRUE(near(flight.jerk(t), {0, -2 * b * v * a, 0}, 1e-6)) << t;
  }
}

/// An applied force that ends: constant on both sides, and no peak between.
TEST(Jerk, has_no_peak_where_a_force_ends) {
  const Flight flight =
      fly({.mass = 2, .force = {20, 0, 0}, .force_duration = 0.5}, kUp, {}, exact(DragModel::off), {}, kOneSecond);
  for (const double t : {0.4999, 0.49999999, 0.5, 0.5001}) EXPECT_LT(length(flight.jerk(t)), 1e-9) << t;
}

/// Along the path as it was flown: differences of what accelerations() tells.
void expect_slope(const Flight& flight, double relative) {
  ASSERT_FALSE(flight.error());
  const double h = 1e-3;
  for (const double part : {0.11, 0.37, 0.52, 0.83}) {
    const double t = part * flight.duration();
    const auto slope = [&](double s) {
      return (flight.accelerations(t + s).total - flight.accelerations(t - s).total) * (0.5 / s);
    };
    const Vec3d wanted = (slope(h / 2) * 4 - slope(h)) * (1.0 / 3);
    EXPECT_TRUE(near(flight.jerk(t), wanted, relative, 1e-5)) << t;
  }
}

TEST(Jerk, is_the_slope_of_the_acceleration_of_a_bullet_and_a_ball) {
  Fidelity f = Fidelity::reference();
  expect_slope(fly(presets::rifle_bullet().projectile, {.speed = 823, .elevation = 0.01}, {}, f, {}, {.time = 1.2}),
               1e-3);
  f.rotation = RotationModel::magnus;
  expect_slope(fly(presets::golf_ball().projectile, {.speed = 70, .elevation = 0.2, .spin = {.backspin = 260}}, {}, f,
                   {}, {.time = 3}),
               1e-3);
}

TEST(Jerk, is_the_slope_of_the_acceleration_of_a_rocket_while_it_burns) {
  ProjectileDef rocket{.mass = 1, .diameter = 0.05, .drag = {.coefficient = 0.6}};
  rocket.motor = {.thrust = {{0, 50}, {2, 20}, {2.5, 0}}, .propellant_mass = 0.3};
  expect_slope(fly(rocket, {.speed = 20, .elevation = 1.3}, {}, exact(DragModel::equation), {}, {.time = 1.9}), 1e-4);
}

TEST(Jerk, of_worlds_is_that_of_flights) {
  ProjectileDef ball{.mass = 2, .drag = {.k1 = 0.3, .k2 = 0.1}, .fidelity = exact(DragModel::linear_quadratic)};
  const Launch launch{.position = {0, 50, 0}, .velocity = Vec3d{20, 10, 3}};
  const Flight flight = fly(ball, launch, {}, ball.fidelity, {}, kOneSecond);
  World world;
  const ProjectileId id = *world.spawn(ball, launch);
  for (int i = 0; i < 30; ++i) {
    EXPECT_TRUE(near(world[id].jerk(), flight.jerk(i / 60.0), 1e-6, 1e-9)) << i;
    world.step(1.0 / 60);
  }
}

/// Drag by a generator, and a spring: j = -(k1 + 2 k2 |v|) a / m along the path, and -(k / m) v.
TEST(Jerk, counts_generators_by_place_and_velocity) {
  Fidelity f = exact(DragModel::off);
  f.gravity = GravityModel::off;
  ProjectileDef ball{.mass = 2, .fidelity = f};
  World world;
  const ProjectileId dragged = *world.spawn(ball, {.position = {0, 50, 0}, .velocity = Vec3d{20, 0, 0}});
  const ProjectileId sprung = *world.spawn(ball, {.position = {3, 50, 0}, .velocity = Vec3d{0, 4, 0}});
  ASSERT_TRUE(world[dragged].add_force(LinearQuadraticDragForce{.k1 = 0.5, .k2 = 0.1}).ok());
  ASSERT_TRUE(world[sprung].add_force(AnchoredSpring{.anchor = {0, 50, 0}, .stiffness = 8}).ok());
  world.step(1.0 / 600);
  const double v = world[dragged].velocity().x, a = -(0.5 * v + 0.1 * v * v) / 2;
  EXPECT_TRUE(near(world[dragged].jerk(), {-(0.5 + 0.2 * v) * a / 2, 0, 0}, 1e-6));
  EXPECT_TRUE(near(world[sprung].jerk(), world[sprung].velocity() * -4.0, 1e-6));
}

TEST(Jerk, of_what_is_not_there_is_zero) {
  World world;
  EXPECT_EQ(world[ProjectileId{}].jerk(), Vec3d{});
  EXPECT_EQ(fly({.mass = -1}, kUp).jerk(0), Vec3d{});
}

}  // namespace physim::model_jerk_test
