// What flights do where they meet things: each way to meet them, spin, rest, limits, bad input, and random scenes.
#include "random_shots.hpp"
#include "scene_support.hpp"

namespace physim::flight_scene_meeting_test {

using namespace test_scene;

TEST(MeetingFlight, flights_do_what_collision_says) {
  Scene scene;
  const MaterialId steel = *scene.add_material({.name = "steel"});
  const InstanceId wall =
      add_thing(scene, BoxShape{{0.01, 5, 5}}, {.transform = {.position = {10, 0, 0}}, .material = steel, .layers = 2});
  const InstanceId gate =
      add_thing(scene, BoxShape{{0.5, 5, 5}}, {.transform = {.position = {5, 0, 0}}, .sensor = true});
  const auto fired = [&](const CollisionDef& collision) {
    Until until = meeting(scene);
    until.contact.collision = collision;
    until.time = 0.5;
    return fly(stone(), {.speed = 100}, vacuum_of(0), rung(Integrator::tsit5), {}, until);
  };
  const Flight stops = fired({.on_hit = OnHit::stop}), sticks = fired({.on_hit = OnHit::stick}),
               bounces = fired({.on_hit = OnHit::bounce}), passes = fired({.on_hit = OnHit::pass}),
               others = fired({.layers = 4});
  EXPECT_EQ(stops.outcome(), Outcome::hit);
  EXPECT_NEAR(stops.end().speed, 100, 1e-9);
  EXPECT_EQ(sticks.outcome(), Outcome::hit);
  EXPECT_EQ(sticks.end().speed, 0);
  EXPECT_NEAR(sticks.end().position.x, 9.99, 1e-9);
  EXPECT_EQ(bounces.outcome(), Outcome::time_limit);
  EXPECT_NEAR(bounces.end().velocity.x, -100 * 0.5 * scene.material(steel).restitution, 1e-9);
  EXPECT_EQ(others.outcome(), Outcome::time_limit);
  EXPECT_TRUE(of_kind(others, EventKind::hit).empty() && of_kind(others, EventKind::sensed).empty());
  for (const Flight* flight : {&stops, &sticks, &bounces}) {
    const auto hits = of_kind(*flight, EventKind::hit);
    ASSERT_EQ(hits.size(), 1u);
    EXPECT_EQ(hits[0].instance, wall);
    EXPECT_EQ(hits[0].material, steel);
    EXPECT_NEAR(hits[0].time, 0.0999, 1e-9);
    EXPECT_EQ(hits[0].normal, (Vec3d{-1, 0, 0}));
    EXPECT_NEAR(hits[0].velocity.x, 100, 1e-9);
    ASSERT_GE(of_kind(*flight, EventKind::sensed).size(), 1u);
    EXPECT_EQ(of_kind(*flight, EventKind::sensed)[0].instance, gate);
    EXPECT_NEAR(of_kind(*flight, EventKind::sensed)[0].time, 0.045, 1e-9);
    EXPECT_NEAR(of_kind(*flight, EventKind::left)[0].time, 0.055, 1e-9);
  }
  ASSERT_EQ(of_kind(passes, EventKind::entered).size(), 1u);
  EXPECT_NEAR(of_kind(passes, EventKind::entered)[0].time, 0.0999, 1e-9);
  EXPECT_NEAR(of_kind(passes, EventKind::left)[1].time, 0.1001, 1e-9);
  EXPECT_NEAR(passes.end().position.x, 50, 1e-9);
}

TEST(MeetingFlight, a_bullet_goes_through_a_plank_and_into_a_wall_as_impact_says) {
  Scene scene;
  const MaterialId fir = *scene.add_material(materials::fir()),
                   concrete = *scene.add_material(materials::concrete(30e6));
  put(scene, BoxShape{{0.009, 1, 1}}, {50, 0, 0}, fir);
  put(scene, BoxShape{{0.15, 2, 3}}, {60, 0, 0}, concrete);
  ProjectileDef p = stone();
  p.mass = 0.0109;
  p.diameter = 0.00782;
  const Flight flight =
      fly(p, {.speed = 780}, vacuum_of(0), rung(Integrator::dop853), {}, meeting(scene, OnHit::impact));
  ASSERT_EQ(flight.outcome(), Outcome::hit);
  const auto through = of_kind(flight, EventKind::penetrated), stuck = of_kind(flight, EventKind::stopped);
  ASSERT_EQ(through.size(), 1u);
  ASSERT_EQ(stuck.size(), 1u);
  Impact asked{.mass = p.mass,
               .diameter = p.diameter,
               .length = p.length,
               .velocity = {780, 0, 0},
               .normal = {-1, 0, 0},
               .thickness = 0.018};
  const ImpactResult plank = *impact(asked, materials::fir());
  EXPECT_NEAR(through[0].velocity.x, plank.velocity.x, 1e-6);
  EXPECT_NEAR(through[0].energy, plank.energy, 1e-6);
  EXPECT_NEAR(through[0].position.x, 50.009, 1e-8);
  asked.velocity = plank.velocity;
  asked.thickness = 0.3;
  const ImpactResult wall = *impact(asked, materials::concrete(30e6));
  EXPECT_NEAR(stuck[0].value, wall.depth, 1e-9);
  EXPECT_NEAR(flight.end().position.x, 59.85 + wall.depth, 1e-8);
  EXPECT_EQ(flight.end().speed, 0);
  EXPECT_NEAR(flight.at(flight.duration() - 1e-6).velocity.x, plank.velocity.x, 1e-6);
}

TEST(MeetingFlight, a_ball_slides_then_rolls_down_a_slope_and_rests_on_a_floor) {
  constexpr double kSlope = 30 * test::kDegree;
  Scene slope;
  const MaterialId rough = *slope.add_material({.restitution = 0, .friction = 1});
  add_thing(slope, PlaneShape{},
            {.transform = {.rotation = {std::cos(kSlope / 2), 0, 0, -std::sin(kSlope / 2)}}, .material = rough});
  for (const Fidelity& fidelity : {closed(), rung(Integrator::tsit5), rung(Integrator::rk4)}) {
    Until until = meeting(slope, OnHit::bounce, 0.1);
    until.contact.restitution = 0;
    until.contact.rolling_resistance = 0;
    until.contact.friction = 1;
    until.time = 2;
    const Vec3d normal{std::sin(kSlope), std::cos(kSlope), 0};
    const Flight flight =
        fly(stone(), {.position = normal * (0.1 + 1e-9)}, vacuum_of(kG), fidelity, {.step = 1.0 / 60}, until);
    ASSERT_EQ(flight.outcome(), Outcome::time_limit);
    const double a = kG * std::sin(kSlope) / 1.4;  // a solid ball rolls
    for (const double t : {0.5, 1.0, 2.0}) {
      EXPECT_NEAR(length(flight.at(t).position - normal * 0.1), 0.5 * a * t * t, 1e-3) << t;
      EXPECT_NEAR(flight.at(t).speed, a * t, 1e-3) << t;
      EXPECT_NEAR(dot(flight.at(t).position, normal), 0.1, 1e-6);
    }
    EXPECT_LE(of_kind(flight, EventKind::hit).size(), 2u);  // what goes on is no new hit
  }
  Scene floor;
  put(floor, PlaneShape{}, {}, *floor.add_material({.restitution = 1, .friction = 1}));
  for (const Fidelity& fidelity : {closed(), rung(Integrator::dop853), rung(Integrator::rk4)}) {
    const Flight flight = fly(stone(), {.position = {0, 1, 0}, .speed = 1}, vacuum_of(kG), fidelity, {.step = 1.0 / 60},
                              meeting(floor, OnHit::bounce));
    EXPECT_EQ(flight.outcome(), Outcome::hit);  // at rest
    EXPECT_EQ(flight.end().speed, 0);
    EXPECT_LT(flight.duration(), 10);
    EXPECT_NEAR(flight.end().position.y, 0, 1e-8);
  }
}

TEST(MeetingFlight, what_slides_past_a_range_ends_there) {
  Scene floor;
  put(floor, PlaneShape{}, {}, *floor.add_material({.restitution = 0, .friction = 0}));
  Until until = meeting(floor, OnHit::bounce);
  until.contact.rolling_resistance = 0;
  until.range = 12;
  for (const Fidelity& fidelity : {closed(), rung(Integrator::tsit5), rung(Integrator::rk4)}) {
    const Flight flight =
        fly(stone(), {.position = {0, 1e-6, 0}, .speed = 5}, vacuum_of(kG), fidelity, {.step = 1.0 / 60}, until);
    EXPECT_EQ(flight.outcome(), Outcome::reached_range);
    EXPECT_NEAR(flight.duration(), 2.4, 1e-6);
    EXPECT_NEAR(flight.end().position.x, 12, 1e-6);
  }
}

TEST(MeetingFlight, moving_things_are_met_where_they_are_at_the_time) {
  Scene scene;
  const InstanceId wall = add_thing(scene, BoxShape{{0.1, 5, 5}}, {.transform = {.position = {100, 0, 0}}});
  ASSERT_TRUE(scene.set_motion(wall, SteadyMotion{.velocity = {-20, 0, 0}}));
  for (const double begins : {0.0, 2.0}) {
    Until until = meeting(scene);
    until.contact.scene_time = begins;
    const Flight flight = fly(stone(), {.speed = 30}, vacuum_of(0), rung(Integrator::tsit5), {}, until);
    ASSERT_EQ(flight.outcome(), Outcome::hit);
    EXPECT_NEAR(flight.duration(), (99.9 - 20 * begins) / 50, 1e-8);
  }
}

TEST(MeetingFlight, spin_of_a_bounce_bends_the_path_that_follows) {
  Scene floor;
  put(floor, PlaneShape{}, {}, *floor.add_material({.restitution = 0.8, .friction = 1}));
  ProjectileDef p = presets::tennis_ball().projectile;
  Fidelity fidelity = Fidelity::constant_air();
  fidelity.precision = Precision::float64;
  fidelity.rotation = RotationModel::magnus;
  Until until = meeting(floor, OnHit::bounce, 0.033);
  until.contact.restitution = 1;
  until.contact.friction = 1;
  until.time = 1.2;
  Launch launch{.position = {0, 2, 0}, .speed = 30};
  launch.spin.backspin = 1e-6;  // without any the rung that flies it would not be granted
  const Flight flight = fly(p, launch, {}, fidelity, {}, until);
  const auto bounce = of_kind(flight, EventKind::bounced);
  ASSERT_GE(bounce.size(), 1u);
  // It had as good as no spin before, so nothing lifted it; a ball that grips the floor leaves with topspin, which
  // pulls it down.
  EXPECT_LT(length(flight.accelerations(0.9 * bounce[0].time).lift), 1e-6);
  EXPECT_LT(flight.accelerations(bounce[0].time + 0.01).lift.y, -0.1);
}

TEST(MeetingFlight, rockets_and_spin_drift_meet_things_where_they_fly_without) {
  Scene roof;
  const InstanceId ceiling = put(roof, BoxShape{{500, 1, 500}}, {0, 81, 0});
  ProjectileDef rocket = stone();
  rocket.mass = 1;
  rocket.motor.thrust = {{0, 60}, {0.8, 40}, {1, 0}};
  rocket.motor.propellant_mass = 0.2;
  Launch pad{.elevation = 1.4, .rail_length = 2};
  for (const Integrator integrator : {Integrator::rk4, Integrator::tsit5}) {
    const Tolerance fine{.step = 1.0 / 500};
    Until until{.ground = std::nullopt, .time = 8};
    const Flight free = fly(rocket, pad, vacuum_of(kG), rung(integrator), fine, until);
    ASSERT_FALSE(free.error()) << free.error()->text();
    const auto there = must(free.at_height(80));
    until.scene = &roof;
    const Flight stopped = fly(rocket, pad, vacuum_of(kG), rung(integrator), fine, until);
    ASSERT_EQ(stopped.outcome(), Outcome::hit);
    EXPECT_NEAR(stopped.duration(), there.time, 1e-9);
    EXPECT_EQ(of_kind(stopped, EventKind::hit)[0].instance, ceiling);
    EXPECT_EQ(of_kind(stopped, EventKind::rail_exit).size(), 1u);
    until.contact.collision.on_hit = OnHit::bounce;
    const Flight bounced = fly(rocket, pad, vacuum_of(kG), rung(integrator), fine, until);
    EXPECT_EQ(bounced.outcome(), Outcome::time_limit);
    EXPECT_NEAR(bounced.at(7).mass, 0.8, 1e-9);
    EXPECT_LT(bounced.end().position.y, 80);
  }
  Scene wall;
  put(wall, BoxShape{{0.1, 50, 50}}, {700.1, 0, 0});
  ProjectileDef bullet = test::bullet_308();
  bullet.twist = 0.3;
  Fidelity drifting = Fidelity::small_arms();
  drifting.rotation = RotationModel::spin_drift;
  Until until{.ground = std::nullopt, .time = 5};
  const Flight free = fly(bullet, {.speed = 800}, {}, drifting, {}, until);
  until.scene = &wall;
  const Flight met = fly(bullet, {.speed = 800}, {}, drifting, {}, until);
  ASSERT_EQ(met.outcome(), Outcome::hit);
  EXPECT_GT(met.end().windage, 0.05);
  EXPECT_LT(length(met.end().position - free.at(met.duration()).position), 1e-7);
  EXPECT_NEAR(met.end().position.x, 700, 1e-9);
}

TEST(MeetingFlight, a_world_goes_on_with_a_flight_that_has_bounced) {
  Scene floor;
  put(floor, PlaneShape{}, {}, *floor.add_material({.restitution = 1, .friction = 0}));
  for (const Fidelity& fidelity : {closed(), rung(Integrator::rk4)}) {
    Until until = meeting(floor, OnHit::bounce);
    until.contact.restitution = 0.9;
    until.time = 3;
    ProjectileDef p = stone();
    const Flight flight =
        fly(p, {.position = {0, 2, 0}, .speed = 4}, vacuum_of(kG), fidelity, {.step = 1.0 / 64}, until);
    World world = make_world({.environment = vacuum_of(kG), .ground = {.mode = GroundMode::none}}, floor);
    const auto id = must(world.spawn(flight, 1.0, {.restitution = 0.9, .collision = {.on_hit = OnHit::bounce}}));
    for (int i = 1; i <= 120; ++i) {
      world.step(1.0 / 64);
      ASSERT_LT(length(world[id].position() - flight.at(1 + i / 64.0).position), 1e-6) << i;
    }
  }
}

TEST(MeetingFlight, limits_starts_inside_and_bad_input) {
  const Scene box = room({1, 1, 1}, {.restitution = 1, .friction = 0});
  Until until = meeting(box, OnHit::bounce);
  until.contact.restitution = 1;
  const Launch launch{.velocity = Vec3d{70, 40, 30}};
  for (const Integrator integrator : {Integrator::tsit5, Integrator::rk4}) {
    const Flight flight =
        fly(stone(), launch, vacuum_of(0), rung(integrator), {.step = 1.0 / 60, .max_steps = 50}, until);
    EXPECT_EQ(flight.outcome(), Outcome::step_limit);
    EXPECT_LE(flight.cost().steps, integrator == Integrator::rk4 ? 50 * 1000 : 51);
  }
  Scene solid;
  put(solid, BoxShape{{1, 1, 1}}, {});
  const Flight inside = fly(stone(), launch, vacuum_of(0), rung(Integrator::tsit5), {}, meeting(solid, OnHit::bounce));
  EXPECT_EQ(inside.outcome(), Outcome::hit);
  ASSERT_EQ(inside.events().size(), 1u);
  EXPECT_EQ(inside.events()[0].reason, Reason::inside);
  EXPECT_EQ(inside.duration(), 0);
  EXPECT_EQ(inside.end().position, (Vec3d{}));
  const auto refused = [&](auto change) {
    Until bad = meeting(solid);
    change(bad.contact);
    const Flight flight = fly(stone(), launch, {}, rung(Integrator::tsit5), {}, bad);
    EXPECT_EQ(flight.outcome(), Outcome::refused);
    return flight.error() ? flight.error()->place : "";
  };
  EXPECT_EQ(refused([](ContactDef& c) { c.collision.radius = -1; }), "until.contact.collision.radius");
  EXPECT_EQ(refused([](ContactDef& c) { c.collision.inertia = 0; }), "until.contact.collision.inertia");
  EXPECT_EQ(refused([](ContactDef& c) { c.collision.on_hit = static_cast<OnHit>(9); }),
            "until.contact.collision.on_hit");
  EXPECT_EQ(refused([](ContactDef& c) { c.restitution = 1.1; }), "until.contact.restitution");
  EXPECT_EQ(refused([](ContactDef& c) { c.friction = test::kNan; }), "until.contact.friction");
  EXPECT_EQ(refused([](ContactDef& c) { c.rolling_resistance = -1; }), "until.contact.rolling_resistance");
  EXPECT_EQ(refused([](ContactDef& c) { c.scene_time = kInfinity; }), "until.contact.scene_time");
}

TEST(MeetingFlight, an_automatic_step_is_found_up_to_the_first_contact) {
  Scene floor;
  put(floor, PlaneShape{}, {}, *floor.add_material({.restitution = 0.8, .friction = 0.5}));
  Until until = meeting(floor, OnHit::bounce, 0.03);
  until.time = 3600;  // without the floor it would fall for an hour
  Fidelity fixed = Fidelity::constant_air();
  fixed.integrator = Integrator::heun;
  const ProjectileDef ball = presets::tennis_ball().projectile;
  const Launch launch{.position = {0, 2, 0}, .speed = 25, .elevation = 0.3};
  const Flight flight = fly(ball, launch, {}, fixed, {}, until);
  ASSERT_EQ(flight.outcome(), Outcome::hit);
  EXPECT_GT(flight.step(), 1e-4);
  Fidelity exact = fixed;
  exact.integrator = Integrator::dop853;
  exact.precision = Precision::float64;
  const Flight reference = fly(ball, launch, {}, exact, {}, until);
  EXPECT_LT(length(of_kind(flight, EventKind::hit)[0].position - of_kind(reference, EventKind::hit)[0].position), 2e-3);
}

TEST(MeetingFlight, batches_refuse_a_scene) {
  Scene scene;
  put(scene, PlaneShape{}, {});
  const Launch launches[] = {{.speed = 10}, {.speed = 20}};
  const BatchResult batch = fly_batch(stone(), launches, {}, Fidelity::game(), {}, meeting(scene));
  ASSERT_TRUE(batch.error);
  EXPECT_EQ(batch.error->place, "until.scene");
  EXPECT_EQ(batch.shots[1].outcome, Outcome::refused);
  const double speeds[] = {10, 20, 30};
  LaunchColumns columns{.speed = speeds};
  EXPECT_EQ(fly_columns(stone(), columns, {}, Fidelity::game(), {}, meeting(scene), {}).refused, 3u);
}

/// A room with things in it, at rest.
Scene cluttered(test::Random& r) {
  Scene scene = room({30, 15, 30}, {.restitution = r.in(0, 1), .friction = r.in(0, 1)});
  const MaterialId soft = *scene.add_material(materials::fir());
  for (int i = 0; i < 8; ++i) {
    const Vec3d place{r.in(3, 28), r.in(-14, 14), r.in(-28, 28)};
    const Quatd turned = quat_from_yaw_pitch_roll(r.in(-3, 3), r.in(-1, 1), r.in(-3, 3));
    const ShapeDef shapes[] = {BoxShape{{0.5, 1, 2}}, SphereShape{1.5}, CapsuleShape{1, 0.5}};
    add_thing(scene, shapes[i % 3],
              {.transform = {.position = place, .rotation = turned}, .material = i % 2 ? soft : MaterialId{}});
  }
  return scene;
}

/// Whatever flies, and whatever it meets: a path without holes, in order, outside of what is solid, without energy from
/// nowhere.
TEST(MeetingFlight, random_flights_keep_what_is_promised) {
  test::Random r(23);
  int contacts = 0;
  for (int run = 0; run < 300; ++run) {
    SCOPED_TRACE(run);
    const Scene scene = cluttered(r);
    Fidelity f = run % 3 ? Fidelity::constant_air() : Fidelity::small_arms();
    f.integrator = test::kIntegrators[run % 8];
    if (run % 5 == 0) f.rotation = RotationModel::magnus;
    if (run % 7 == 0) f.motion = Motion::closed_form;
    f.precision = r.one_in(3) ? Precision::float32 : Precision::float64;
    ProjectileDef p = run % 3 ? presets::tennis_ball().projectile : test::bullet_308();
    Launch launch{.position = {r.in(-20, -5), r.in(-10, 10), r.in(-10, 10)},
                  .speed = r.in(1, 100),
                  .elevation = r.in(-0.7, 0.7),
                  .azimuth = r.in(-0.7, 0.7)};
    if (run % 3) launch.spin = {.backspin = r.in(-300, 300), .sidespin = r.in(-100, 100)};
    const double radius = r.one_in(2) ? 0 : 0.05;
    Until until = meeting(scene, r.one_in(2) ? OnHit::bounce : OnHit::impact, radius);
    until.time = 4;
    until.events = {{EventKind::height, 0}, {EventKind::speed, 5}};
    const Flight flight = fly(p, launch, {}, f, {.step = f.integrator == Integrator::dop853 ? 0 : 1.0 / 100}, until);
    ASSERT_FALSE(flight.error()) << flight.error()->text();
    ASSERT_TRUE(flight.outcome() == Outcome::time_limit || flight.outcome() == Outcome::hit) << name(flight.outcome());
    const bool narrow = flight.fidelity_in_use().fidelity.precision == Precision::float32;
    contacts += static_cast<int>(of_kind(flight, EventKind::hit).size());
    double jump = 0;  // of what goes through things
    for (std::size_t i = 0; i < flight.events().size(); ++i) {
      const Event& e = flight.events()[i];
      ASSERT_TRUE(e.time >= 0 && e.time <= flight.duration() + 1e-5);
      ASSERT_LE(flight.events()[i > 0 ? i - 1 : 0].time, e.time);
      if (e.kind == EventKind::penetrated || e.kind == EventKind::stopped) jump = std::max(jump, e.value + 4 * radius);
    }
    Sample before = flight.at(0);
    double fastest = before.speed;
    constexpr int kSamples = 2000;
    for (int i = 1; i <= kSamples; ++i) {
      const Sample now = flight.at(flight.duration() * i / kSamples);
      ASSERT_TRUE(std::isfinite(now.position.x + now.velocity.y + now.speed)) << now.time;
      const double gap = narrow ? 1e-4 : 1e-6;
      fastest = std::max({fastest, now.speed, before.speed});
      ASSERT_LE(length(now.position - before.position), 1.5 * fastest * (now.time - before.time) + jump + gap);
      const SceneHit inside = scene.first_hit({now.position, now.position + now.velocity * 1e-9, 0, 0, 0});
      const bool stuck = now.time == flight.duration() && flight.outcome() == Outcome::hit;
      const bool may_be_inside = jump > 0 || stuck || narrow;
      ASSERT_TRUE(may_be_inside || !inside || !inside.starts_inside) << now.time;
      // Above what it had, by no more than it fell; sharp models gain a little where they are integrated coarsely.
      const double most = flight.at(0).speed * flight.at(0).speed + 2 * kG * (flight.at(0).position.y + 15);
      ASSERT_LE(now.speed * now.speed + 2 * kG * (now.position.y + 15), 1.02 * most + 0.2);
      before = now;
    }
    if (HasFatalFailure()) return;
  }
  EXPECT_GT(contacts, 500);
}

}  // namespace physim::flight_scene_meeting_test
