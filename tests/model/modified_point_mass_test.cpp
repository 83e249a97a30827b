// Shells in their yaw of repose: against the balance that defines it, and against six degrees of freedom.
#include "rigid.hpp"

namespace physim::model_modified_point_mass_test {

using namespace test;

constexpr double kArea = 0.25 * 3.14159265358979323846 * 0.1048 * 0.1048;

/// The 105 mm shell M1 with coefficients of low speed, all constant (R. L. McCoy, Modern Exterior Ballistics (1999),
/// ch. 9).
ProjectileDef shell() {
  return {.mass = 14.97,
          .diameter = 0.1048,
          .twist = 18 * 0.1048,
          .drag = {.coefficient = 0.124},
          .inertia = {.moments = {0.02326, 0.23118, 0.23118}},
          .aero = {.drag_yaw = {{0, 0, 3.2}},
                   .lift = {{0, 0, 1.63}},
                   .pitching = {{0, 0, 3.55}},
                   .pitch_damping = {{0, 0, -3.15}},
                   .roll_damping = {{0, 0, -0.0149}}}};
}
Launch launch(double elevation = 0.5) { return {.speed = 250, .elevation = elevation}; }

Fidelity with(RotationModel rotation) {
  Fidelity f = Fidelity::simulation();
  f.integrator = Integrator::dop853;
  f.earth = EarthModel::flat;
  f.rotation = rotation;
  return f;
}
Flight flown(const ProjectileDef& p, const Launch& l, RotationModel rotation = RotationModel::modified_point_mass,
             const Environment& e = {}) {
  return fly(p, l, e, with(rotation), {1e-11, 1e-11});
}

/// What the overturning moment lacks to turn the angular momentum with the path, over the moment [-].
double imbalance(const Flight& flight, const ProjectileDef& p, double time, double pitching, double pitching_cubic = 0,
                 const Vec3d& omega = {}) {
  const Sample s = flight.at(time);
  const Vec3d& u = s.velocity;
  const double speed = length(u);
  const Vec3d axis = rotate(s.orientation, Vec3d{1, 0, 0});
  const double sine_squared = length_squared(cross(u, axis)) / (speed * speed);
  const double density = air_at({}, s.position.y)->density;
  const Vec3d moment =
      cross(u, axis) * (0.5 * density * kArea * p.diameter * speed * (pitching + pitching_cubic * sine_squared));
  const Vec3d path_turns = cross(u, s.acceleration + cross(omega, u)) * (1 / (speed * speed));
  const Vec3d momentum = u * (p.inertia.moments.x * s.angular_velocity.x / speed);
  return length(moment - cross(path_turns, momentum)) / length(moment);
}

TEST(ModifiedPointMass, the_overturning_moment_turns_the_spin_with_the_path) {
  const ProjectileDef p = shell();
  const Flight flight = flown(p, launch());
  for (double t = 0; t < flight.duration(); t += 2) {
    EXPECT_LT(imbalance(flight, p, t, 3.55), 1e-9) << t;
    EXPECT_GT(flight.at(t).angle_of_attack, 1e-4) << t;
  }
}

TEST(ModifiedPointMass, every_force_of_the_yaw_counts_in_the_balance) {
  ProjectileDef p = shell();
  p.aero.magnus_force = {{0, 0, -0.6}};
  const Flight flight = flown(p, launch(1.2));
  for (double t = 0; t < flight.duration(); t += 2) EXPECT_LT(imbalance(flight, p, t, 3.55), 1e-9) << t;
}

// The cubic parts use the yaw that constant coefficients give: an error of second order in alpha^2.
TEST(ModifiedPointMass, coefficients_that_change_with_the_yaw_are_followed) {
  ProjectileDef p = shell();
  p.aero.lift_cubic = {{0, 0, 3}};
  p.aero.pitching_cubic = {{0, 0, -2.9}};
  p.aero.magnus_force = {{0, 0, -0.3}, {0, 0.1, -0.9}};
  const Flight flight = flown(p, launch(1.1));
  double largest = 0;
  for (double t = 0; t < flight.duration(); t += 1) {
    const double yaw = flight.at(t).angle_of_attack;
    largest = std::max(largest, yaw);
    EXPECT_LT(imbalance(flight, p, t, 3.55, -2.9), 2 * yaw * yaw * yaw * yaw + 1e-9) << t;
  }
  EXPECT_GT(largest, 0.05);
}

TEST(ModifiedPointMass, a_turning_earth_turns_under_the_axis) {
  Environment e{.earth = {.latitude = 0.9, .azimuth = 1}};
  Fidelity f = with(RotationModel::modified_point_mass);
  f.earth = EarthModel::flat_coriolis;
  const Flight flight = fly(shell(), launch(), e, f, {1e-11, 1e-11});
  const double rate = 7.292115e-5;
  // North is at the angle -azimuth from downrange, towards the right; up is up.
  const Vec3d omega{rate * std::cos(0.9) * std::cos(1.0), rate * std::sin(0.9), -rate * std::cos(0.9) * std::sin(1.0)};
  EXPECT_LT(imbalance(flight, shell(), 8, 3.55, 0, omega), 1e-6);
  EXPECT_GT(imbalance(flight, shell(), 8, 3.55), 1e-4);
}

TEST(ModifiedPointMass, flies_as_six_degrees_of_freedom_do) {
  for (const double elevation : {0.2, 0.5, 0.8}) {
    const Flight fast = flown(shell(), launch(elevation));
    Launch settled = launch(elevation);  // points and turns as the yaw of repose asks for: nothing swings
    const Sample start = fast.at(0);
    const Vec3d axis = rotate(start.orientation, Vec3d{1, 0, 0});
    const double yaw = std::atan2(axis.z, axis.x), pitch = std::asin(axis.y);
    const Vec3d turns = cross(start.velocity, start.acceleration) * (1 / length_squared(start.velocity));
    settled.attitude = {.frame = AttitudeFrame::world, .yaw = yaw, .pitch = pitch};
    settled.attitude.rates = rotate(conjugate(quat_from_yaw_pitch_roll(yaw, pitch, 0.0)), turns);
    const Flight full = flown(shell(), settled, RotationModel::rigid_body);
    const Flight point = flown(shell(), launch(elevation), RotationModel::none);
    const Sample a = fast.end(), b = full.end();
    EXPECT_NEAR(a.range, b.range, 2e-4 * b.range) << elevation;
    EXPECT_NEAR(a.windage, b.windage, 0.01 * b.windage) << elevation;
    EXPECT_NEAR(a.angular_velocity.x, b.angular_velocity.x, 1e-4 * b.angular_velocity.x) << elevation;
    EXPECT_GT(b.windage, 5) << elevation;
    EXPECT_EQ(point.end().windage, 0);
    EXPECT_LT(fast.cost().steps * 20, full.cost().steps);
  }
}

TEST(ModifiedPointMass, left_handed_spin_drifts_to_the_left) {
  ProjectileDef left = shell();
  left.twist = -left.twist;
  const Sample a = flown(shell(), launch()).end(), b = flown(left, launch()).end();
  EXPECT_GT(a.windage, 1);
  EXPECT_NEAR(a.windage, -b.windage, 1e-9 * a.windage);
  EXPECT_NEAR(a.range, b.range, 1e-9 * a.range);
}

TEST(ModifiedPointMass, without_spin_it_is_a_point_mass) {
  ProjectileDef p = shell();
  p.twist = 0;
  const Flight shells = flown(p, launch()), points = flown(p, launch(), RotationModel::none);
  EXPECT_TRUE(near(shells.end().position, points.end().position, 1e-9));
  EXPECT_LT(shells.at(3).angle_of_attack, 1e-15);
}

// p' = rho V S d^2 / 2 Clp p / Ix: in air of one density the spin falls with the way flown through it.
TEST(ModifiedPointMass, spin_dies_away_with_the_way_flown) {
  Environment e{.gravity = {.acceleration = 0}, .atmosphere = {.model = AirModel::constant, .density = 1.2}};
  const Flight flight = flown(shell(), launch(0.1), RotationModel::modified_point_mass, e);
  const double first = flight.at(0).angular_velocity.x;
  EXPECT_NEAR(first, 2 * 3.14159265358979323846 * 250 / (18 * 0.1048), 1e-9 * first);
  const Flight until =
      fly(shell(), launch(0.1), e, with(RotationModel::modified_point_mass), {1e-11, 1e-11}, {.ground = {}, .time = 5});
  const double way = length(until.end().position);
  const double decay = 1.2 * kArea * 0.1048 * 0.1048 / 2 * 0.0149 / 0.02326;
  EXPECT_NEAR(until.end().angular_velocity.x, first * std::exp(-decay * way), 1e-9 * first);
}

TEST(ModifiedPointMass, integrators_have_their_order) {
  const auto end = [&](Integrator integrator, int steps) {
    Fidelity f = with(RotationModel::modified_point_mass);
    f.integrator = integrator;
    const Flight flight = fly(shell(), launch(), {}, f, {.step = 8.0 / steps}, {.ground = {}, .time = 8});
    return flight.end().position;
  };
  const Vec3d exact =
      fly(shell(), launch(), {}, with(RotationModel::modified_point_mass), {1e-13, 1e-13}, {.ground = {}, .time = 8})
          .end()
          .position;
  const std::pair<Integrator, double> orders[] = {
      {Integrator::semi_implicit_euler, 1}, {Integrator::heun, 2}, {Integrator::rk4, 4}};
  for (const auto& [integrator, order] : orders) {
    const double coarse = length(end(integrator, 32) - exact), fine = length(end(integrator, 64) - exact);
    EXPECT_NEAR(std::log2(coarse / fine), order, 0.15) << static_cast<int>(integrator);
  }
}

TEST(ModifiedPointMass, a_rail_holds_it_and_the_motor_pushes_along_the_axis) {
  ProjectileDef p = shell();
  p.motor.thrust = {{0, 4000}, {3, 4000}, {3.1, 0}};
  p.motor.propellant_mass = 3;
  Launch l = launch(0.6);
  l.speed = 80;
  l.rail_length = 4;
  l.attitude.rates = {600, 0, 0};
  p.twist = 0;
  const Flight flight = flown(p, l);
  EXPECT_LT(flight.at(0.02).angle_of_attack, 1e-15);
  EXPECT_NEAR(flight.at(0.02).angular_velocity.x, 600, 1);
  const Accelerations a = flight.accelerations(2);
  const Sample s = flight.at(2);
  EXPECT_TRUE(near(a.thrust * (1 / length(a.thrust)), rotate(s.orientation, Vec3d{1, 0, 0}), 1e-12));
  EXPECT_TRUE(near(a.total, a.gravity + a.drag + a.body + a.thrust, 1e-12));
  EXPECT_GT(s.angle_of_attack, 1e-4);
}

TEST(ModifiedPointMass, what_has_no_yaw_of_repose_is_granted_less_with_a_reason) {
  const auto reason = [](const ProjectileDef& p, const Fidelity& f, const Environment& e = {}) {
    const FidelityInUse in_use = grant(f, p, e);
    EXPECT_EQ(in_use.fidelity.rotation, RotationModel::none);
    for (const FidelityNote& note : in_use.notes)
      if (note.effect == "rotation") return std::string(note.reason);
    return std::string("no note");
  };
  const Fidelity f = with(RotationModel::modified_point_mass);
  ProjectileDef p = shell();
  EXPECT_EQ(grant(f, p, {}).fidelity.rotation, RotationModel::modified_point_mass);
  p.inertia = {};
  EXPECT_NE(reason(p, f).find("moments of inertia"), std::string::npos);
  p = shell();
  p.inertia.moments.y *= 1.01;
  EXPECT_NE(reason(p, f).find("symmetric"), std::string::npos);
  p = shell();
  p.aero.pitching.clear();
  EXPECT_NE(reason(p, f).find("aero.pitching"), std::string::npos);
  Fidelity other = f;
  other.planar = true;
  EXPECT_NE(reason(shell(), other).find("planar"), std::string::npos);
  other = f;
  other.drag = DragModel::linear_quadratic;
  EXPECT_NE(reason(shell(), other).find("drag equation"), std::string::npos);
  other = f;
  other.integrator = Integrator::classic;
  EXPECT_NE(reason(shell(), other), "no note");
  Environment empty{.atmosphere = {.model = AirModel::vacuum}};
  EXPECT_NE(reason(shell(), f, empty).find("no air"), std::string::npos);
}

// At a summit in thin, slow air the quasi-steady yaw would have no bounds.
TEST(ModifiedPointMass, a_yaw_beyond_thirty_degrees_is_held_there) {
  ProjectileDef p = shell();
  const Flight flight = flown(p, launch(1.55));
  EXPECT_EQ(flight.outcome(), Outcome::landed);
  double largest = 0;
  for (double t = 0; t < flight.duration(); t += 0.1) largest = std::max(largest, flight.at(t).angle_of_attack);
  EXPECT_GT(largest, 0.3);
  EXPECT_LT(largest, 0.5236);
}

}  // namespace physim::model_modified_point_mass_test
