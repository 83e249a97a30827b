// Motors and launch rails in a world: the numbers of flights, whatever else happens to the projectile.
#include "base/event_table.hpp"
#include "world/world_support.hpp"

namespace physim::world_motor_world_test {

using namespace test;

constexpr double kStep = 1.0 / 64;

ProjectileDef rocket(const Fidelity& fidelity) {
  return {
      .mass = 0.1,
      .diameter = 0.03,
      .drag = {.coefficient = 0.5},
      .motor = {.thrust =
                    {{0, 0}, {0.0317, 0.4}, {0.2371, 28.1}, {0.3113, 14.3}, {0.7173, 9.7}, {1.5791, 10.1}, {1.8937, 0}},
                .propellant_mass = 0.0108,
                .ignition_delay = 0.055,
                .drag_curve = {{0, 0.4}, {0.5, 0.45}, {1, 0.8}}},
      .fidelity = fidelity};
}

Fidelity rung(Integrator integrator, Precision precision = Precision::float64) {
  Fidelity f = Fidelity::simulation();
  f.rotation = RotationModel::none;
  f.integrator = integrator;
  f.precision = precision;
  return f;
}

Launch from_rail(double elevation = 1.4) { return {.elevation = elevation, .rail_length = 0.9}; }

std::vector<Event> stops_of(std::span<const Event> events) {
  std::vector<Event> stops;
  for (const Event& e : events)
    if (is_of_motor_or_rail(e.kind)) stops.push_back(e);
  return stops;
}

/// A pack of one rocket has lanes that hold nobody. The first motor of the world is no business of theirs.
TEST(WorldMotor, lanes_that_hold_nobody_take_no_motor) {
  ProjectileDef other = rocket(rung(Integrator::tsit5));
  other.motor.drag_curve.clear();
  other.drag = {.table = DragTable::custom, .curve = {{0, 0.4}, {0.5317, 0.45}, {1.0173, 0.8}}};  // of no equal cells
  ProjectileDef own = rocket(rung(Integrator::tsit5));
  own.motor.drag_curve.clear();
  World beside, alone;
  ASSERT_TRUE(beside.spawn(other, from_rail()));
  const ProjectileId id = *beside.spawn(own, from_rail()), same = *alone.spawn(own, from_rail());
  for (int i = 0; i < 200; ++i) {
    beside.step(kStep), alone.step(kStep);
    ASSERT_EQ(beside[id].position(), alone[same].position()) << i;
  }
}

TEST(WorldMotor, flies_the_bits_of_a_flight) {
  Environment windy{.wind = {.velocity = {3, 0.5, -2}}};
  for (const Integrator integrator :
       {Integrator::explicit_euler, Integrator::semi_implicit_euler, Integrator::heun, Integrator::rk4})
    for (const Precision precision : {Precision::float32, Precision::float64}) {
      SCOPED_TRACE(text(integrator) + " " + std::string(name(precision)));
      World world = make_world({.environment = windy});
      const ProjectileDef p = rocket(rung(integrator, precision));
      const ProjectileId id = *world.spawn(p, from_rail());
      const ProjectileId other = *world.spawn(p, from_rail(1.1));
      ASSERT_TRUE(id && other);
      const Flight flight = fly(p, from_rail(), windy, p.fidelity, {1e-9, 1e-9, kStep}, {.time = 30});
      std::vector<Event> events;
      for (int i = 1; i < 500 && i * kStep < flight.duration(); ++i) {
        world.step(kStep);
        for (const Event& e : world.events())
          if (e.id == id) events.push_back(e);
        const Sample s = flight.at(i * kStep);
        ASSERT_TRUE(same_bits(world[id].position(), s.position)) << i;
        ASSERT_TRUE(same_bits(world[id].velocity(), s.velocity)) << i;
        ASSERT_TRUE(near(world[id].mass(), s.mass, 1e-6)) << i;
        const double rounding = precision == Precision::float64 ? 1e-12 : 1e-3;
        ASSERT_TRUE(near(world[id].accelerations().total, s.acceleration, rounding, rounding)) << i;
      }
      const auto of_flight = stops_of(flight.events());
      const auto of_world = stops_of(events);
      ASSERT_EQ(of_flight.size(), 3u);
      ASSERT_EQ(of_world.size(), 3u);
      for (std::size_t i = 0; i < 3; ++i) {
        EXPECT_EQ(of_flight[i].kind, of_world[i].kind);
        EXPECT_NEAR(of_flight[i].time, of_world[i].time, 1e-12);
        EXPECT_TRUE(same_bits(of_flight[i].position, of_world[i].position));
      }
    }
}

TEST(WorldMotor, adaptive_integrators_follow_the_flight) {
  for (const Integrator integrator : kAdaptive) {
    World world = make_world({});
    const ProjectileDef p = rocket(rung(integrator));
    const ProjectileId id = *world.spawn(p, from_rail());
    const Flight flight = fly(p, from_rail(), {}, p.fidelity, {1e-11, 1e-11});
    run_for(world, 3, kStep);
    EXPECT_TRUE(near(world[id].position(), flight.at(world.time()).position, 1e-6));
  }
}

TEST(WorldMotor, a_launch_without_delay_ignites_at_once) {
  World world = make_world({});
  ProjectileDef p = rocket(rung(Integrator::rk4));
  p.motor.ignition_delay = 0;
  const ProjectileId now = *world.spawn(p, from_rail());
  EXPECT_EQ(events_of(world, EventKind::ignition).size(), 1u);
  const ProjectileId later = *world.spawn(p, from_rail(), {}, 0.5);
  const auto events = run_for(world, 2.6, kStep);
  std::vector<double> ignitions, burnouts, exits;
  for (const Event& e : events) {
    if (e.id == later && e.kind == EventKind::ignition) ignitions.push_back(e.time);
    if (e.id == later && e.kind == EventKind::burnout) burnouts.push_back(e.time);
    if (e.kind == EventKind::rail_exit) exits.push_back(e.time);
  }
  ASSERT_EQ(ignitions.size(), 1u);
  ASSERT_EQ(burnouts.size(), 1u);
  ASSERT_EQ(exits.size(), 2u);
  EXPECT_EQ(ignitions[0], 0.5);
  EXPECT_NEAR(burnouts[0], 0.5 + 1.8937, 1e-12);
  EXPECT_NEAR(exits[1] - exits[0], 0.5, 1e-12);
  EXPECT_TRUE(world[now].is_alive());
}

TEST(WorldMotor, goes_on_when_the_projectile_changes_its_rung_or_switches) {
  const ProjectileDef p = rocket(rung(Integrator::rk4));
  const Flight flight = fly(p, from_rail(), {}, p.fidelity, {1e-9, 1e-9, kStep});
  for (const double at : {0.04, 0.1, 0.16, 0.3, 1.0}) {
    SCOPED_TRACE(at);
    World world = make_world({});
    const ProjectileId id = *world.spawn(p, from_rail());
    run_for(world, at, kStep);
    Fidelity other = p.fidelity;
    other.interpolation = Interpolation::linear;
    other.planar = true;
    ASSERT_TRUE(world[id].set_fidelity(other));
    ASSERT_TRUE(world[id].set_can_sleep(false));
    run_for(world, 0.1, kStep);
    ASSERT_TRUE(world[id].set_gravity_scale(0.5));
    ASSERT_TRUE(world[id].set_gravity_scale(1));
    ASSERT_TRUE(world[id].set_fidelity(p.fidelity));
    run_for(world, 2 - world.time(), kStep);
    EXPECT_TRUE(near(world[id].position(), flight.at(2).position, 1e-3));
    EXPECT_TRUE(near(world[id].mass(), flight.at(2).mass, 1e-12));
  }
}

TEST(WorldMotor, generators_push_the_mass_that_is_left) {
  World world = make_world({.environment = {.gravity = {.model = GravityModel::constant}}});
  ProjectileDef p = rocket(vacuum(Integrator::rk4));
  p.mass = 0.02;  // more than half of it burns
  const ProjectileId id = *world.spawn(p, {.elevation = 90 * kDegree, .rail_length = 0.9});
  run_for(world, 2.5, kStep);
  const Vec3d before = world[id].velocity();
  ForceDef push{.law = ConstantForce{{0.1, 0, 0}}, .target = {.ids = {id}}};
  ASSERT_TRUE(world.add_force(push));
  run_for(world, 1, kStep);
  EXPECT_NEAR(world[id].velocity().x - before.x, 0.1 / (0.02 - 0.0108), 1e-9);
  EXPECT_NEAR(world[id].velocity().y - before.y, -9.80665, 1e-9);
}

TEST(WorldMotor, burns_under_generators_too) {
  World world = make_world({});
  const ProjectileDef p = rocket(rung(Integrator::rk4));
  const ProjectileId id = *world.spawn(p, from_rail());
  ForceDef nothing{.law = ConstantForce{}, .target = {.ids = {id}}};
  ASSERT_TRUE(world.add_force(nothing));
  run_for(world, 3, 1.0 / 1000);
  const Flight flight = fly(p, from_rail(), {}, p.fidelity, {1e-9, 1e-9, kStep});
  EXPECT_TRUE(near(world[id].position(), flight.at(3).position, 2e-3));  // pieces change with its steps
  EXPECT_TRUE(near(world[id].mass(), flight.at(3).mass, 1e-12));
}

TEST(WorldMotor, waits_on_its_rail_without_falling_asleep) {
  World world = make_world({.ground = {.mode = GroundMode::bounce}});
  ProjectileDef p = rocket(rung(Integrator::rk4));
  p.motor.ignition_delay = 5;
  const ProjectileId id = *world.spawn(p, from_rail(), {.can_sleep = true, .sleep_speed = 0.1, .sleep_time = 0.5});
  const auto events = run_for(world, 8, kStep);
  EXPECT_TRUE(std::none_of(events.begin(), events.end(), [](const Event& e) { return e.kind == EventKind::slept; }));
  EXPECT_GT(world[id].position().y, 100);
}

TEST(WorldMotor, snapshots_hold_it) {
  World world = make_world({});
  const ProjectileId id = *world.spawn(rocket(rung(Integrator::rk4)), from_rail());
  run_for(world, 0.1, kStep);
  const Snapshot now = world.snapshot();
  run_for(world, 1, kStep);
  const Vec3d there = world[id].position();
  world.restore(now);
  run_for(world, 1, kStep);
  EXPECT_TRUE(same_bits(world[id].position(), there));
}

TEST(WorldMotor, a_rocket_at_rest_without_a_rail_is_refused) {
  World world = make_world({});
  const auto id = world.spawn(rocket(rung(Integrator::rk4)), {.elevation = 1});
  ASSERT_FALSE(id);
  EXPECT_EQ(id.error().place, "launch.rail_length");
}

}  // namespace physim::world_motor_world_test
