// A projectile with a delay flies from its own moment on, wherever that lies in a step.
#include "world/world_support.hpp"

namespace physim::world_launch_inside_test {

using test::text;

constexpr double kStep = 1.0 / 30;
constexpr double kG = 9.80665;
constexpr double kDelays[] = {0.011, kStep, 0.0501, 0.2, 0.3331, 1.0 - 1e-4};
const Launch kUp{.position = {1, 2, 3}, .velocity = Vec3d{30, 40, 5}};

Environment still_air() { return {.gravity = {.model = GravityModel::constant}}; }
WorldDef without_ground() {
  return {.environment = still_air(), .ground = {.mode = GroundMode::none}, .step = kStep, .max_steps = 1000};
}
ProjectileDef damped() {
  ProjectileDef p = stone();
  p.fidelity.motion = Motion::closed_form;
  p.fidelity.drag = DragModel::damping;
  p.drag.damping = 0.8;
  return p;
}
ProjectileDef with(Integrator integrator) {
  ProjectileDef p = stone();
  p.fidelity.motion = Motion::force;
  p.fidelity.integrator = integrator;
  return p;
}

TEST(LaunchInside, closed_forms_are_those_of_a_flight_from_that_moment) {
  const ProjectileDef p = damped();
  const Flight flight = fly(p, kUp, still_air(), p.fidelity, {}, {.ground = {}, .time = 5});
  World world = make_world(without_ground());
  std::vector<ProjectileId> ids;
  for (const double delay : kDelays) ids.push_back(*world.spawn(p, kUp, {}, delay));
  for (int i = 1; i <= 60; ++i) {
    world.single_step();
    for (std::size_t k = 0; k < ids.size(); ++k) {
      const double age = world.time() - kDelays[k];
      if (age < -1e-12) {
        EXPECT_EQ(world[ids[k]].status(), LifeStatus::pending);
        continue;
      }
      ASSERT_EQ(world[ids[k]].status(), LifeStatus::in_flight) << i << ' ' << k;
      const Sample s = flight.at(std::max(age, 0.0));
      EXPECT_LT(length(world[ids[k]].position() - s.position), 1e-12) << i << ' ' << k;
      EXPECT_LT(length(world[ids[k]].velocity() - s.velocity), 1e-12) << i << ' ' << k;
    }
  }
}

TEST(LaunchInside, integrators_that_are_exact_on_parabolas_are_on_them) {
  for (const Integrator integrator : {Integrator::heun, Integrator::rk4, Integrator::tsit5}) {
    World world = make_world(without_ground());
    std::vector<ProjectileId> ids;
    for (const double delay : kDelays) ids.push_back(*world.spawn(with(integrator), kUp, {}, delay));
    for (int i = 0; i < 60; ++i) world.single_step();
    for (std::size_t k = 0; k < ids.size(); ++k) {
      const double t = world.time() - kDelays[k];
      const Vec3d g{0, -kG, 0}, v = *kUp.velocity;
      EXPECT_LT(length(world[ids[k]].position() - (kUp.position + v * t + g * (0.5 * t * t))), 1e-11)
          << text(integrator);
    }
  }
}

TEST(LaunchInside, one_in_the_last_step_comes_and_is_told_at_its_moment) {
  World world = make_world(without_ground());
  const ProjectileId id = *world.spawn(damped(), kUp, {}, 0.011);
  world.single_step();
  const auto spawned = events_of(world, EventKind::spawned);
  ASSERT_EQ(spawned.size(), 1u);
  EXPECT_EQ(spawned[0].id, id);
  EXPECT_EQ(spawned[0].time, 0.011);
  EXPECT_EQ(spawned[0].position, kUp.position);
  EXPECT_GT(length(world[id].position() - kUp.position), 0.5);
}

TEST(LaunchInside, it_meets_the_ground_on_its_way_there) {
  WorldDef def = without_ground();
  def.ground.mode = GroundMode::land;
  def.ground.height = 2;
  World world = make_world(def);
  const Launch down{.position = {0, 2.1, 0}, .velocity = Vec3d{0, -50, 0}};
  ASSERT_TRUE(world.spawn(with(Integrator::rk4), down, {}, 0.011));
  world.single_step();
  const auto landed = events_of(world, EventKind::landed);
  ASSERT_EQ(landed.size(), 1u);
  const double falls = (std::sqrt(50 * 50 + 2 * kG * 0.1) - 50) / kG;
  EXPECT_NEAR(landed[0].time, 0.011 + falls, 1e-9);
}

/// The same bits by single steps, by many at once, through a save between them, and on several threads.
TEST(LaunchInside, moments_threads_and_saves_change_no_bit) {
  for (const ProjectileDef& p : {damped(), with(Integrator::rk4), with(Integrator::semi_implicit_euler), bullet()}) {
    WorldDef def = without_ground();
    def.threading = {.threads = 1, .rows_per_thread = 1};
    World alone = make_world(def), broken = make_world(def);
    def.threading.threads = 2;
    World threads = make_world(def), at_once = make_world(def);
    for (World* world : {&alone, &broken, &threads, &at_once})
      for (int i = 0; i < 50; ++i) ASSERT_TRUE(world->spawn(p, kUp, {}, 0.0123 * i));
    for (int i = 0; i < 30; ++i) {
      alone.single_step(), broken.single_step(), threads.single_step();
      broken = std::move(*World::load(*broken.save()));
      ASSERT_EQ(alone.hash(), broken.hash()) << i;
      ASSERT_EQ(alone.hash(), threads.hash()) << i;
    }
    EXPECT_EQ(at_once.advance(30.5 * kStep), 30);
    for (const ProjectileId id : alone.ids()) ASSERT_EQ(at_once[id].state(), alone[id].state());
  }
}

/// What follows it stands until it flies: one particle for each metre of its way and no other.
TEST(LaunchInside, an_emitter_that_follows_it_begins_with_it) {
  World world = make_world(without_ground());
  ProjectileDef p = with(Integrator::rk4);
  p.gravity_scale = 0;
  const ProjectileId id = *world.spawn(p, {.velocity = Vec3d{100, 0, 0}}, {}, 0.0501);
  EmitterDef smoke{.kind = *world.add_kind(stone()), .follows = id, .per_second = {0}, .per_metre = 1};
  const auto emitter = must(world.add_emitter(smoke));
  for (int i = 0; i < 6; ++i) world.single_step();
  EXPECT_EQ(world.emitter_counts(emitter).born, 14u);  // (0.2 - 0.0501) 100 m
  for (const Event& e : events_of(world, EventKind::spawned)) EXPECT_NEAR(e.position.x, 100 * (e.time - 0.0501), 1e-9);
}

}  // namespace physim::world_launch_inside_test
