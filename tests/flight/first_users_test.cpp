// What first users stumbled on in flights and batches: answers that were wrong or silent.
#include "support.hpp"

namespace physim::test::flight_first_users_test {

bool has_note(const Flight& flight, const std::string& effect, const std::string& part) {
  return std::ranges::any_of(flight.fidelity_in_use().notes, [&](const FidelityNote& note) {
    return note.effect == effect && note.reason.find(part) != std::string::npos;
  });
}

Fidelity with_drift() {
  Fidelity f = Fidelity::simulation();
  f.rotation = RotationModel::spin_drift;
  return f;
}

TEST(FirstUsers, a_batch_steps_as_its_fastest_shot_needs) {
  std::vector<Launch> launches;
  for (const double speed : {30.0, 40.0, 50.0, 900.0, 60.0, 70.0})
    launches.push_back({.position = {0, 2, 0}, .speed = speed, .elevation = 0.02});
  Fidelity f = Fidelity::simulation();
  f.integrator = Integrator::heun;
  const BatchResult batch = fly_batch(bullet_308(), launches, {}, f);
  f.integrator = Integrator::dop853;
  for (std::size_t i = 0; i < launches.size(); ++i) {
    const Vec3d exact = fly(bullet_308(), launches[i], {}, f, {1e-13, 1e-13}).end().position;
    EXPECT_LE(length(batch.shots[i].position - exact), 1e-3) << launches[i].speed << " m/s";
  }
}

TEST(FirstUsers, a_shot_that_goes_nowhere_does_not_choose_the_step_of_a_batch) {
  const Launch thrown{.position = {0, 2, 0}, .speed = 30, .elevation = 0.3};
  Fidelity f = Fidelity::simulation();
  f.integrator = Integrator::rk4;
  const auto steps_beside = [&](const Launch& other) {
    const std::vector<Launch> launches{thrown, other, thrown};
    return fly_batch(bullet_308(), launches, {}, f).shots[0].cost.steps;
  };
  EXPECT_EQ(steps_beside({}), steps_beside(thrown)) << "at rest on the ground";
}

TEST(FirstUsers, a_flight_asked_at_no_time_answers_with_its_start) {
  const Flight flight = fly(bullet_308(), {.position = {0, 2, 0}, .speed = 800});
  const double no_time = std::numeric_limits<double>::quiet_NaN();
  EXPECT_EQ(flight.at(no_time).position, flight.at(0).position);
  EXPECT_EQ(flight.at(no_time).time, 0);
  EXPECT_EQ(flight.accelerations(no_time).total, flight.accelerations(0).total);
  EXPECT_FALSE(flight.departure(no_time));
}

TEST(FirstUsers, a_flight_that_has_landed_at_once_says_why) {
  const Flight flight = fly(bullet_308(), {.speed = 800}, {}, Fidelity::simulation());
  EXPECT_EQ(flight.outcome(), Outcome::landed);
  EXPECT_EQ(flight.duration(), 0);
  EXPECT_TRUE(has_note(flight, "until.ground", "landed at once"));
  const Flight high = fly(bullet_308(), {.position = {0, 1, 0}, .speed = 800}, {}, Fidelity::simulation());
  EXPECT_FALSE(has_note(high, "until.ground", ""));
}

/// What stands level on the ground flies if something lifts it: a golf ball with backspin does.
TEST(FirstUsers, lift_carries_a_level_launch_off_the_ground) {
  const ProjectileDef golf = presets::golf_ball().projectile;
  Launch launch{.speed = 70, .spin = {.backspin = 4000 * 6 * kDegree}};
  const Flight level = fly(golf, launch, {}, Fidelity::simulation());
  launch.elevation = 1e-9;
  const Flight raised = fly(golf, launch, {}, Fidelity::simulation());
  EXPECT_NEAR(level.end().position.x, raised.end().position.x, 1e-3);
  EXPECT_GT(level.end().position.x, 150);
  EXPECT_FALSE(has_note(level, "until.ground", ""));
}

/// A level rail on the ground ends, and with it the flight, where nothing lifts what leaves it.
TEST(FirstUsers, a_level_rail_on_the_ground_ends_in_a_landing) {
  const ProjectileDef ball{.mass = 1, .diameter = 0.05, .drag = {.coefficient = 0.4}};
  for (const Fidelity& fidelity : {Fidelity::game(), Fidelity::small_arms(), Fidelity::simulation()}) {
    const Flight flight = fly(ball, {.speed = 30, .rail_length = 3}, {}, fidelity);
    EXPECT_EQ(flight.outcome(), Outcome::landed);
    EXPECT_NEAR(flight.end().position.x, 3, 1e-6);
    EXPECT_EQ(flight.end().position.y, 0);
  }
}

/// Steps of first order that end below the ground at once land on it, not below.
TEST(FirstUsers, a_hop_within_a_step_lands_on_the_ground) {
  Fidelity fidelity = test::vacuum(Integrator::semi_implicit_euler);
  for (const Integrator integrator : {Integrator::semi_implicit_euler, Integrator::explicit_euler, Integrator::heun})
    for (const auto& [speed, step] : {std::pair{0.2, 0.02}, {3.0, 0.5}, {60.0, 10.0}}) {
      fidelity.integrator = integrator;
      const Flight flight = fly({}, {.speed = speed, .elevation = 30 * kDegree}, {}, fidelity, {.step = step});
      EXPECT_EQ(flight.outcome(), Outcome::landed) << name(integrator) << ' ' << speed;
      EXPECT_NEAR(flight.end().position.y, 0, 1e-9 * speed) << name(integrator) << ' ' << speed;
    }
}

TEST(FirstUsers, a_standard_drag_function_alone_says_whose_mass_and_size_are_flown) {
  ProjectileDef p{.drag = {.table = DragTable::g7}};
  const Launch launch{.position = {0, 1, 0}, .speed = 800};
  EXPECT_TRUE(has_note(fly(p, launch, {}, Fidelity::simulation()), "drag", "1 kg and 0.1 m"));
  p.drag.ballistic_coefficient = 150;
  EXPECT_FALSE(has_note(fly(p, launch, {}, Fidelity::simulation()), "drag", "1 kg"));
  p.drag.ballistic_coefficient = 0;
  p.mass = 0.01;
  EXPECT_FALSE(has_note(fly(p, launch, {}, Fidelity::simulation()), "drag", "1 kg"));
}

TEST(FirstUsers, degrees_taken_for_radians_are_refused) {
  for (const double angle : {30.0, -45.0, 1e300, kNan}) {
    EXPECT_EQ(fly(bullet_308(), {.speed = 800, .elevation = angle}).error()->place, "launch.elevation") << angle;
  }
  EXPECT_FALSE(fly(bullet_308(), {.speed = 800, .elevation = kDegree * 180, .azimuth = 200}).error());
}

TEST(FirstUsers, spin_drift_that_means_nothing_says_so) {
  const Launch launch{.position = {0, 1, 0}, .speed = 800};
  ProjectileDef p = bullet_308();
  EXPECT_FALSE(has_note(fly(p, launch, {}, with_drift()), "rotation", ""));
  EXPECT_NEAR(*stability_factor(p, launch, {}), 1.7, 0.3);
  p.mass = 1;  // forgotten
  EXPECT_TRUE(has_note(fly(p, launch, {}, with_drift()), "rotation", "beyond 10"));
  p = bullet_308();
  p.twist = 0.5;
  EXPECT_TRUE(has_note(fly(p, launch, {}, with_drift()), "rotation", "tumbles"));
  p.twist = 0;
  const Flight smooth = fly(p, launch, {}, with_drift());
  EXPECT_EQ(smooth.fidelity_in_use().fidelity.rotation, RotationModel::none);
  EXPECT_TRUE(has_note(smooth, "rotation", "no twist"));
  EXPECT_FALSE(stability_factor(p, launch, {}));
}

TEST(FirstUsers, models_beyond_where_they_hold_say_so) {
  ProjectileDef ball{.mass = 0.15, .diameter = 0.07, .drag = {.table = DragTable::sphere}};
  const Launch slow{.position = {0, 1, 0}, .speed = 40}, fast{.position = {0, 1, 0}, .speed = 200};
  EXPECT_FALSE(has_note(fly(ball, slow, {}, Fidelity::simulation()), "drag", "Mach"));
  EXPECT_TRUE(has_note(fly(ball, fast, {}, Fidelity::simulation()), "drag", "below Mach 0.3"));
  ProjectileDef rocket = bullet_308();
  rocket.mass = 0.1;
  rocket.motor.thrust = {{0, 10}, {1, 0}};
  rocket.motor.propellant_mass = 0.01;
  Environment windy{.wind = {.velocity = {0, 0, 8}}};
  const Launch up{.speed = 1, .elevation = 1.5, .rail_length = 1};
  EXPECT_TRUE(has_note(fly(rocket, up, windy, Fidelity::simulation()), "rotation", "follows the air at once"));
  EXPECT_FALSE(has_note(fly(rocket, up, {}, Fidelity::simulation()), "rotation", "follows the air at once"));
}

TEST(FirstUsers, an_apex_that_ends_the_flight_is_told_once) {
  for (const Crossing direction : {Crossing::any, Crossing::falling}) {
    const Until until{.events = {{EventKind::apex, 0, direction, true}}};
    const Flight flight = fly(bullet_308(), {.speed = 100, .elevation = 0.5}, {}, Fidelity::simulation(), {}, until);
    EXPECT_EQ(flight.outcome(), Outcome::event);
    EXPECT_EQ(std::ranges::count(flight.events(), EventKind::apex, &Event::kind), 1);
  }
}

TEST(FirstUsers, a_rocket_from_rest_has_a_farthest_range) {
  ProjectileDef rocket{.mass = 0.12,
                       .diameter = 0.025,
                       .drag = {.table = DragTable::constant, .coefficient = 0.6},
                       .motor = {.thrust = {{0, 10}, {0.8, 10}, {0.9, 0}}, .propellant_mass = 0.01}};
  Launch launch{.position = {0, 0.5, 0}, .rail_length = 1};
  const auto far = must(max_range(rocket, launch, {}, Fidelity::simulation(), 0));
  const auto range_at = [&](double elevation) {
    launch.elevation = elevation;
    return fly(rocket, launch, {}, Fidelity::simulation()).end().position.x;
  };
  EXPECT_NEAR(range_at(far.elevation), far.range, 1e-3);
  for (const double by : {-0.1, -0.02, 0.02, 0.1}) EXPECT_LT(range_at(far.elevation + by), far.range) << by;
}

TEST(FirstUsers, two_points_of_thrust_at_one_time_are_a_step) {
  ProjectileDef p{.mass = 1,
                  .diameter = 0.05,
                  .drag = {.table = DragTable::constant, .coefficient = 0},
                  .motor = {.thrust = {{0, 50}, {1, 50}, {1, 20}, {3, 20}}, .propellant_mass = 0}};
  EXPECT_EQ(total_impulse(p.motor), 90);
  const Launch up{.elevation = kDegree * 90, .rail_length = 1e-3};
  Environment space{.gravity = {.model = GravityModel::off}, .atmosphere = {.model = AirModel::vacuum}};
  for (const Integrator integrator : {Integrator::rk4, Integrator::tsit5}) {
    Fidelity f = Fidelity::simulation();
    f.integrator = integrator;
    f.earth = EarthModel::flat;
    const Flight flight = fly(p, up, space, f, {.step = 0.1}, {.time = 3});
    ASSERT_FALSE(flight.error()) << flight.error()->text();
    EXPECT_NEAR(flight.end().velocity.y, 90, 1e-9) << text(integrator);
    EXPECT_NEAR(flight.at(1).velocity.y, 50, 1e-9) << text(integrator);
    EXPECT_NEAR(flight.end().position.y, 25 + 50 * 2 + 0.5 * 20 * 4, 1e-6) << text(integrator);
  }
  p.motor.thrust = {{0, 50}, {1, 50}, {1, 20}, {1, 30}, {3, 20}};
  EXPECT_EQ(fly(p, up, space, Fidelity::simulation()).error()->place, "projectile.motor.thrust[3]");
}

}  // namespace physim::test::flight_first_users_test
