// Landing, bouncing, rolling and sleeping, against closed forms.
#include "world/world_support.hpp"

namespace physim::world_ground_test {

constexpr double kG = 9.80665;

WorldDef on_ground(GroundMode mode) { return {.ground = {.mode = mode}}; }

TEST(Ground, landing_has_the_exact_time_and_place_of_a_flight) {
  WorldDef def = on_ground(GroundMode::land);
  def.environment.wind.velocity = {3, 0, 1};
  for (const Integrator integrator : {Integrator::semi_implicit_euler, Integrator::heun, Integrator::rk4}) {
    for (const Precision precision : {Precision::float32, Precision::float64}) {
      World world = make_world(def);
      ProjectileDef p = bullet();
      p.fidelity = Fidelity::constant_air();
      p.fidelity.integrator = integrator;
      p.fidelity.precision = precision;
      const Launch launch{.position = {0, 1.5, 0}, .speed = 100, .elevation = 0.05};
      const ProjectileId id = *world.spawn(p, launch);
      const auto events = run_for(world, 3);
      const auto landed =
          std::find_if(events.begin(), events.end(), [](const auto& e) { return e.kind == EventKind::landed; });
      ASSERT_NE(landed, events.end());
      const Flight flight = fly(p, launch, def.environment, p.fidelity, {.step = 1.0 / 64});
      // Positions come from the same interpolant; times are added in another order.
      EXPECT_NEAR(landed->time, flight.duration(), 1e-7);
      EXPECT_NEAR(landed->position.x, flight.end().position.x, 1e-6 * flight.end().position.x);
      EXPECT_NEAR(landed->position.y, 0, 1e-5);
      EXPECT_EQ(landed->id, id);
      EXPECT_FALSE(world[id].is_alive());
      EXPECT_EQ(world[id].status(), LifeStatus::landed);
      EXPECT_EQ(world.size(), 0u);
    }
  }
}

/// The clock of a float32 row is rounded, so what it finds in a step's last microsecond may lie behind the step.
TEST(Ground, nothing_happens_later_than_its_step) {
  WorldDef def = on_ground(GroundMode::bounce);
  World world = make_world(def);
  ProjectileDef p = stone();
  p.fidelity.precision = Precision::float32;
  p.fidelity.integrator = Integrator::rk4;  // exact for parabolas: they bounce on and on
  BodyDef body{.can_sleep = false, .restitution = 1, .friction = 0};
  for (int i = 0; i < 400; ++i) ASSERT_TRUE(world.spawn(p, {.position = {0.0, 1 + 1e-3 * i, 1.0 * i}}, body));
  std::uint64_t bounces = 0;
  for (int i = 0; i < 64 * 60; ++i) {
    world.step(1.0 / 64);
    for (const Event& e : world.events()) {
      EXPECT_LE(e.time, world.time());
      ++bounces;
    }
  }
  EXPECT_GT(bounces, 10000U);
}

TEST(Ground, a_bouncing_ball_follows_the_closed_form) {
  WorldDef def = on_ground(GroundMode::bounce);
  BodyDef body{.restitution = 0.8};
  ProjectileDef p = stone();
  p.fidelity.integrator = Integrator::rk4;  // exact for parabolas
  World world = make_world(def);
  world.spawn(p, {.position = {0, 2, 0}}, body);
  const auto events = run_for(world, 4);
  double time = std::sqrt(2 * 2 / kG);
  double speed = kG * time;
  int bounces = 0;
  for (const Event& e : events) {
    if (e.kind != EventKind::bounced) continue;
    speed *= 0.8;
    EXPECT_NEAR(e.time, time, 1e-9);
    EXPECT_NEAR(e.velocity.y, speed, 1e-9);
    EXPECT_NEAR(e.position.y, 0, 1e-12);
    time += 2 * speed / kG;
    ++bounces;
  }
  EXPECT_EQ(bounces, 5);
}

TEST(Ground, closed_forms_bounce_too) {
  BodyDef body{.restitution = 0.5};
  ProjectileDef p = stone();
  p.fidelity.motion = Motion::closed_form;
  World world = make_world(on_ground(GroundMode::bounce));
  const ProjectileId id = *world.spawn(p, {.position = {0, 2, 0}, .velocity = Vec3d{3, 0, 0}}, body);
  const auto events = run_for(world, 1);
  const double fall = std::sqrt(2 * 2 / kG);
  ASSERT_FALSE(events.empty());
  const auto bounce =
      std::find_if(events.begin(), events.end(), [](const auto& e) { return e.kind == EventKind::bounced; });
  ASSERT_NE(bounce, events.end());
  EXPECT_NEAR(bounce->time, fall, 1e-9);
  const double after = 1 - fall;
  const double up = 0.5 * kG * fall;
  EXPECT_NEAR(world[id].position().y, up * after - 0.5 * kG * after * after, 1e-9);
}

/// What slides without friction loses its speed to the air alone.
TEST(Ground, closed_forms_feel_their_drag_while_they_lie_on_it) {
  constexpr double kRate = 0.5, kStep = 1.0 / 1024;
  for (const DragModel drag : {DragModel::damping, DragModel::linear_quadratic}) {
    BodyDef body{.can_sleep = false, .restitution = 0, .friction = 0, .rolling_resistance = 0};
    ProjectileDef p = stone();
    p.mass = 3;
    p.drag.damping = std::exp(-kRate);
    p.drag.k1 = kRate * p.mass;
    p.fidelity.motion = Motion::closed_form;
    p.fidelity.drag = drag;
    World world = make_world(on_ground(GroundMode::bounce));
    const ProjectileId id = *world.spawn(p, {.position = {0, 0, 0}, .velocity = Vec3d{10, 0, 0}}, body);
    run_for(world, 1, kStep);
    EXPECT_NEAR(world[id].velocity().x, 10 * std::exp(-kRate), 10 * kRate * kRate * kStep);
    EXPECT_NEAR(world[id].position().y, 0, 1e-12);
  }
}

TEST(Ground, friction_slows_a_bounce_as_coulomb_says) {
  BodyDef body{.restitution = 0.5, .friction = 0.3};
  World world = make_world(on_ground(GroundMode::bounce));
  world.spawn(stone(), {.position = {0, 1, 0}, .velocity = Vec3d{10, -4, 0}}, body);
  const auto events = run_for(world, 0.5);
  const auto bounce =
      std::find_if(events.begin(), events.end(), [](const auto& e) { return e.kind == EventKind::bounced; });
  ASSERT_NE(bounce, events.end());
  const double down = bounce->velocity.y / 0.5;
  EXPECT_NEAR(bounce->velocity.x, 10 - 0.3 * 1.5 * down, 1e-9);
}

TEST(Ground, a_ball_rolls_to_rest_and_sleeps_where_resistance_stops_it) {
  BodyDef body{.sleep_time = 0.25, .restitution = 0, .friction = 0, .rolling_resistance = 0.1};
  World world = make_world(on_ground(GroundMode::bounce));
  const ProjectileId id = *world.spawn(stone(), {.velocity = Vec3d{5, 0, 0}}, body);
  const auto events = run_for(world, 8);
  EXPECT_TRUE(world[id].is_asleep());
  EXPECT_EQ(world[id].position().y, 0);
  EXPECT_EQ(world[id].velocity(), Vec3d{});
  EXPECT_NEAR(world[id].position().x, 25 / (2 * 0.1 * kG), 1e-3);
  const auto slept =
      std::find_if(events.begin(), events.end(), [](const auto& e) { return e.kind == EventKind::slept; });
  ASSERT_NE(slept, events.end());
  EXPECT_NEAR(slept->time, (5 - 0.05) / (0.1 * kG) + 0.25, 0.05);
}

TEST(Ground, a_dead_impact_is_told_once) {
  BodyDef body{.restitution = 0};
  World world = make_world(on_ground(GroundMode::bounce));
  world.spawn(stone(), {.position = {0, 3, 0}, .velocity = Vec3d{1, 0, 0}}, body);
  const auto events = run_for(world, 3);
  std::vector<Event> impacts;
  for (const Event& e : events)
    if (e.kind == EventKind::bounced) impacts.push_back(e);
  ASSERT_EQ(impacts.size(), 1u);
  EXPECT_NEAR(impacts[0].time, std::sqrt(2 * 3 / kG), 0.02);
  EXPECT_EQ(impacts[0].velocity.y, 0);
}

TEST(Ground, an_impulse_wakes_a_sleeper) {
  BodyDef body{.sleep_time = 0.1};
  World world = make_world(on_ground(GroundMode::bounce));
  const ProjectileId id = *world.spawn(stone(), {}, body);
  run_for(world, 1);
  ASSERT_TRUE(world[id].is_asleep());
  EXPECT_TRUE(world[id].apply_impulse({0, 3, 0}));
  EXPECT_FALSE(world[id].is_asleep());
  EXPECT_EQ(events_of(world, EventKind::woke).size(), 1u);
  world.step(1.0 / 64);
  EXPECT_GT(world[id].position().y, 0);
}

TEST(Ground, stuck_arrows_stay_where_they_struck) {
  World world = make_world(on_ground(GroundMode::stick));
  const ProjectileId id = *world.spawn(stone(), {.position = {0, 1, 0}, .velocity = Vec3d{30, 0, 0}});
  run_for(world, 2);
  ASSERT_TRUE(world[id].is_alive());
  EXPECT_EQ(world[id].status(), LifeStatus::landed);
  EXPECT_NEAR(world[id].position().y, 0, 1e-9);
  EXPECT_EQ(world[id].velocity(), Vec3d{});
  const Vec3d there = world[id].position();
  run_for(world, 1);
  EXPECT_EQ(world[id].position(), there);
}

TEST(Ground, spawned_in_the_ground_and_falling_lands_at_once) {
  World world = make_world(on_ground(GroundMode::land));
  const ProjectileId id = *world.spawn(stone(), {.position = {0, -1, 0}, .velocity = Vec3d{0, -1, 0}});
  world.step(1.0 / 64);
  EXPECT_EQ(world[id].status(), LifeStatus::landed);
  const ProjectileId rising = *world.spawn(stone(), {.position = {0, -1, 0}, .velocity = Vec3d{0, 10, 0}});
  run_for(world, 0.5);
  EXPECT_TRUE(world[rising].is_alive());
  EXPECT_GT(world[rising].position().y, 0);
}

TEST(Ground, apex_is_told_where_it_is) {
  WorldDef def = on_ground(GroundMode::land);
  def.apex_events = true;
  World world = make_world(def);
  ProjectileDef p = stone();
  p.fidelity.integrator = Integrator::rk4;
  world.spawn(p, {.velocity = Vec3d{2, 10, 0}});
  const auto events = run_for(world, 1.5);
  const auto apex = std::find_if(events.begin(), events.end(), [](const auto& e) { return e.kind == EventKind::apex; });
  ASSERT_NE(apex, events.end());
  EXPECT_NEAR(apex->time, 10 / kG, 1e-9);
  EXPECT_NEAR(apex->position.y, 50 / kG, 1e-9);
}

// Found by a soak of 10^9 steps: made kinematic at that moment, it would have stayed for ever.
TEST(Ground, a_roll_that_overflows_ends_in_the_same_step) {
  World world = std::move(World::create({.ground = {.mode = GroundMode::bounce}}).value());
  ProjectileDef p;
  p.fidelity = Fidelity::game();
  p.fidelity.drag = DragModel::off;
  const ProjectileId id = *world.spawn(p, Launch{.position = {2e38, 0, 0}, .velocity = Vec3d{1e38, 0, 0}});
  const ProjectileId other = *world.spawn(p, Launch{.position = {0, 10, 0}, .speed = 5});
  ASSERT_TRUE(id);
  ASSERT_TRUE(world.step(3));
  EXPECT_FALSE(world[id].is_alive());
  EXPECT_TRUE(world[other].is_alive());
}

/// How often a ball bounces until it sleeps, and where it lies then.
struct Rested {
  int bounces = 0;
  double last = 0;
  Vec3d place;
  bool asleep = false;
};
Rested bounced_to_rest(ProjectileDef p, double dt) {
  BodyDef body{.restitution = 0.5, .friction = 0.1};
  World world = make_world(on_ground(GroundMode::bounce));
  const ProjectileId id = *world.spawn(p, {.position = {0, 5, 0}, .velocity = Vec3d{2, 0, 1}}, body);
  Rested rested;
  for (const Event& e : run_for(world, 60, dt))
    if (e.kind == EventKind::bounced) ++rested.bounces, rested.last = e.time;
  rested.place = world[id].position();
  rested.asleep = world[id].is_asleep();
  return rested;
}

TEST(Ground, bounces_are_those_of_short_frames_at_any_step) {
  for (const Fidelity& rung :
       {Fidelity::game(), Fidelity::constant_air(), Fidelity::simulation(), Fidelity::arcade()}) {
    ProjectileDef p{.mass = 0.5, .diameter = 0.1, .fidelity = rung};
    const Rested fine = bounced_to_rest(p, 1.0 / 30);
    ASSERT_GE(fine.bounces, 4);
    for (const double dt : {0.05, 0.1, 0.11, 0.25, 0.5, 1.0, 7.0, 60.0}) {
      SCOPED_TRACE(std::to_string(dt) + " " + std::to_string(int(rung.motion)));
      const Rested coarse = bounced_to_rest(p, dt);
      const bool in_parts = dt > 0.1;  // others fly to the first contact in one step
      EXPECT_NEAR(coarse.bounces, fine.bounces, 1);
      EXPECT_NEAR(coarse.last, fine.last, in_parts ? 0.25 : 0.5);
      EXPECT_NEAR(coarse.place.x, fine.place.x, 0.1 * fine.place.x);
      EXPECT_NEAR(coarse.place.z, fine.place.z, 0.1 * fine.place.z);
      EXPECT_NEAR(coarse.place.y, 0, 1e-6);
      EXPECT_TRUE(coarse.asleep);
    }
  }
}

TEST(Ground, a_step_of_minutes_keeps_light_things_where_they_fall) {
  World world = make_world(on_ground(GroundMode::bounce));
  ProjectileDef feather = bullet();
  feather.mass = 5e-3;
  feather.diameter = 0.05;
  feather.drag = {.table = DragTable::constant, .coefficient = 1};
  feather.fidelity = Fidelity::constant_air();
  const ProjectileId id = *world.spawn(feather, {.position = {0, 100, 0}, .speed = 30});
  ASSERT_TRUE(world.step(60));
  ASSERT_TRUE(world.step(60));
  EXPECT_LT(length(world[id].position()), 200);
  EXPECT_GE(world[id].position().y, 0);
}

/// A spring from high above pulls a ball up the more the farther it rolls, and in some step from its start to its end:
/// whether it lies on the ground is looked at there whether something else asks for a look or not.
TEST(Ground, who_is_lifted_within_a_step_still_begins_it_on_the_ground) {
  WorldDef def = on_ground(GroundMode::bounce);
  def.environment.atmosphere.model = AirModel::vacuum;
  World plain = make_world(def), looked_at = make_world(def);
  ProjectileDef p = stone();
  p.fidelity.integrator = Integrator::rk4;
  Scene far_away;
  const ShapeId sphere = *far_away.add_shape(SphereShape{1});
  ASSERT_TRUE(far_away.add({.shape = sphere, .transform = {.position = {0, -1000, 0}}}));
  const BodyDef body{.friction = 0, .rolling_resistance = 0, .collision = {.on_hit = OnHit::bounce}};
  for (World* w : {&plain, &looked_at}) {
    ASSERT_TRUE(w->set_scene(far_away));
    for (const double speed : {8.0, 8.5, 9.0, 9.5, 10.0, 10.5})
      ASSERT_TRUE(w->spawn(p, {.velocity = Vec3d{speed, 0, 0}}, body));
    ASSERT_TRUE(
        w->add_force({.law = AnchoredSpring{{0, 4, 0}, 60 * p.mass, 4, 0}, .target = ForceTarget::everything()}));
  }
  bool rose = false;
  for (int i = 0; i < 60; ++i) {
    // Nobody knows what is clear about one that was put somewhere: it is looked at.
    for (const ProjectileId id : plain.ids()) ASSERT_TRUE(looked_at[id].set_position(looked_at[id].position()));
    plain.step(1.0 / 60), looked_at.step(1.0 / 60);
    for (const ProjectileId id : plain.ids()) {
      ASSERT_EQ(plain[id].state(), looked_at[id].state()) << "step " << i;
      rose = rose || plain[id].position().y > 0;
    }
  }
  EXPECT_TRUE(rose);
}

}  // namespace physim::world_ground_test
