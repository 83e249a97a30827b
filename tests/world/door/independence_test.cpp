// A projectile's numbers depend on nothing but itself: not on threads, kernels, neighbours, the order of spawning, or a
// detour through a snapshot.
#include <map>
#include <random>

#include "model/ladder.hpp"
#include "world/world_support.hpp"

namespace physim::world_independence_test {

std::vector<Fidelity> rungs() {
  Fidelity float_isa = Fidelity::artillery();
  float_isa.precision = Precision::float32;
  float_isa.integrator = Integrator::semi_implicit_euler;
  return {Fidelity::game(),    Fidelity::arcade(),     Fidelity::constant_air(),
          Fidelity::classic(), Fidelity::simulation(), float_isa};
}

struct Scene {
  WorldDef def;
  std::vector<ProjectileDef> projectiles;
  std::vector<Launch> launches;
};

Scene scene(int count) {
  Scene s;
  s.def.environment.wind.velocity = {1, 0, -3};
  s.def.ground.mode = GroundMode::bounce;
  s.def.apex_events = true;
  s.def.threading.rows_per_thread = 1;
  std::mt19937 random(11);
  std::uniform_real_distribution<double> u(-1, 1);
  const auto all = rungs();
  for (int i = 0; i < count; ++i) {
    ProjectileDef p = bullet();
    p.fidelity = all[static_cast<std::size_t>(i) % all.size()];
    s.projectiles.push_back(p);
    s.launches.push_back({.position = {u(random), 2 + u(random), u(random)},
                          .velocity = Vec3d{20 * u(random), 20 * u(random), 20 * u(random)}});
  }
  return s;
}

struct Done {
  std::vector<BodyState> states;  // by number of the shot
  std::multimap<std::size_t, std::pair<double, Vec3d>> events;
  std::uint64_t hash;
};

/// Runs a scene, spawning in the order given.
Done run(const Scene& scene, const std::vector<std::size_t>& order, int steps, bool detour = false) {
  World world = make_world(scene.def);
  std::vector<ProjectileId> ids(scene.launches.size());
  std::map<std::uint32_t, std::size_t> shot;
  for (const std::size_t i : order) {
    ids[i] = *world.spawn(scene.projectiles[i], scene.launches[i]);
    shot[ids[i].index] = i;
  }
  Done done;
  for (int n = 0; n < steps; ++n) {
    if (detour && n == steps / 3) {
      const Snapshot here = world.snapshot();
      const std::uint64_t hash = world.hash();
      for (int k = 0; k < 10; ++k) world.step(1.0 / 50);
      world[ids[3]].despawn();
      EXPECT_NE(world.hash(), hash);
      EXPECT_TRUE(world.restore(here));
      EXPECT_EQ(world.hash(), hash);
    }
    world.step(1.0 / 64);
    for (const Event& e : world.events())
      if (e.kind != EventKind::spawned) done.events.insert({shot[e.id.index], {e.time, e.position}});
  }
  for (const ProjectileId id : ids) done.states.push_back(world[id].state());
  done.hash = world.hash();
  return done;
}

std::vector<std::size_t> in_order(std::size_t count) {
  std::vector<std::size_t> order(count);
  for (std::size_t i = 0; i < count; ++i) order[i] = i;
  return order;
}

void expect_same(const Done& a, const Done& b) {
  EXPECT_EQ(a.states, b.states);
  EXPECT_EQ(a.events, b.events);
}

TEST(Independence, of_threads) {
  Scene s = scene(20000);
  const auto order = in_order(s.launches.size());
  s.def.threading.threads = 1;
  const Done one = run(s, order, 40);
  EXPECT_GT(one.events.size(), 1000u);
  for (const unsigned threads : {2u, 7u}) {
    s.def.threading.threads = threads;
    const Done many = run(s, order, 40);
    expect_same(one, many);
    EXPECT_EQ(one.hash, many.hash);
  }
}

TEST(Independence, of_the_kernel) {
  const Scene s = scene(500);
  const auto order = in_order(s.launches.size());
  const Done best = run(s, order, 60);
  for (const std::string& kernel : kernels()) {
    ASSERT_TRUE(use_kernel(kernel));
    const Done other = run(s, order, 60);
    expect_same(best, other);
    EXPECT_EQ(best.hash, other.hash) << kernel;
  }
  use_kernel("");
}

TEST(Independence, of_the_order_of_spawning) {
  const Scene s = scene(500);
  auto order = in_order(s.launches.size());
  const Done first = run(s, order, 60);
  std::shuffle(order.begin(), order.end(), std::mt19937(5));
  expect_same(first, run(s, order, 60));
}

TEST(Independence, of_a_detour_through_a_snapshot) {
  const Scene s = scene(300);
  const auto order = in_order(s.launches.size());
  const Done straight = run(s, order, 60);
  const Done detour = run(s, order, 60, true);
  expect_same(straight, detour);
  EXPECT_EQ(straight.hash, detour.hash);
}

TEST(Independence, of_neighbours_that_overflow) {
  Scene s = scene(300);
  const auto order = in_order(s.launches.size());
  const Done sound = run(s, order, 30);
  for (const std::size_t i : {std::size_t(6), std::size_t(103), std::size_t(251)})
    s.launches[i].velocity = Vec3d{3e38, 3e38, -3e38};
  WorldDef def = s.def;
  World world = make_world(def);
  std::vector<ProjectileId> ids;
  for (const std::size_t i : order) ids.push_back(*world.spawn(s.projectiles[i], s.launches[i]));
  const auto events = run_for(world, 30.0 / 64);
  for (std::size_t i = 0; i < ids.size(); ++i) {
    if (i == 6 || i == 103 || i == 251) {
      EXPECT_EQ(world[ids[i]].status(), LifeStatus::retired) << i;
    } else {
      EXPECT_EQ(world[ids[i]].state(), sound.states[i]) << i;
    }
  }
  EXPECT_EQ(world.counters().retired, 3u);
}

TEST(Independence, numbers_too_large_for_float_are_refused_at_the_door) {
  World world;
  ProjectileDef p = stone();
  const Launch launch{.position = {0, 5, 0}, .velocity = Vec3d{1e300, 0, 0}};
  const ProjectileId id = *world.spawn(p, launch);
  ASSERT_TRUE(id);
  const Status coarser = world[id].set_fidelity(Fidelity::game());
  ASSERT_FALSE(coarser);
  EXPECT_EQ(coarser.error().place, "velocity");
  EXPECT_EQ(world[id].velocity().x, 1e300);
  p.fidelity.precision = Precision::float32;
  EXPECT_FALSE(world.spawn(p, launch));
  const ProjectileId small = *world.spawn(p, {.position = {0, 5, 0}});
  const Status far_away = world[small].set_position({1e300, 0, 0});
  ASSERT_FALSE(far_away);
  EXPECT_EQ(far_away.error().place, "position");
}

TEST(Independence, fidelity_moves_keep_the_state) {
  World world;
  const ProjectileId id = *world.spawn(bullet(), {.position = {0, 100, 0}, .speed = 300});
  double x = 0;
  for (const Fidelity& f : rungs()) {
    ASSERT_TRUE(world[id].set_fidelity(f));
    const Vec3d before = world[id].position();
    EXPECT_NEAR(before.x, x, 1e-4);
    world.step(1.0 / 64);
    x = world[id].position().x;
    EXPECT_GT(x, before.x + 2);
  }
  EXPECT_EQ(events_of(world, EventKind::fidelity_changed).size(), 0u);  // told before the last step
  world[id].set_fidelity(Fidelity::game());
  EXPECT_EQ(events_of(world, EventKind::fidelity_changed).size(), 1u);
  EXPECT_EQ(world[id].fidelity_in_use().fidelity.integrator, Integrator::semi_implicit_euler);
}

TEST(Independence, worlds_say_that_they_show_no_spin_drift) {
  World world;
  ProjectileDef p = bullet();
  p.length = 0.03;
  p.twist = 0.3;
  p.fidelity = Fidelity::small_arms();
  const FidelityInUse in_use = world[*world.spawn(p, {.position = {0, 9, 0}, .speed = 800})].fidelity_in_use();
  EXPECT_EQ(in_use.fidelity.rotation, RotationModel::none);
  ASSERT_FALSE(in_use.notes.empty());
  EXPECT_EQ(in_use.notes.back().effect, "rotation");
}

TEST(Independence, adaptive_integrators_keep_their_tolerance_inside_a_frame) {
  for (const Integrator integrator : test::kAdaptive) {
    WorldDef def{.ground = {.mode = GroundMode::none}, .tolerance = {.relative = 1e-10}};
    World world = make_world(def);
    ProjectileDef p = bullet();
    p.fidelity = Fidelity::simulation();
    p.fidelity.integrator = integrator;
    const Launch launch{.position = {0, 10, 0}, .speed = 800, .elevation = 0.1};
    const ProjectileId id = *world.spawn(p, launch);
    for (int i = 0; i < 8; ++i) world.step(0.25);  // far too long for one step of these
    Tolerance exact{.relative = 1e-13};
    Until until;
    until.ground.reset();
    until.time = 2;
    const Flight truth = fly(p, launch, def.environment, Fidelity::reference(), exact, until);
    EXPECT_LT(length(world[id].position() - truth.at(2).position), 1e-5);
  }
}

TEST(AutoFidelityInWorlds, chooses_the_cheapest_rung_and_says_why) {
  WorldDef def{.ground = {.mode = GroundMode::none}};
  const Launch launch{.position = {0, 100, 0}, .speed = 800, .elevation = 0.02};
  const auto error_after = [&](double allowed, FidelityInUse& in_use) {
    World world = make_world(def);
    const ProjectileId id = *world.spawn(bullet(), launch, {.cheapest_within = allowed, .within_time = 1});
    in_use = world[id].fidelity_in_use();
    for (int i = 0; i < 60; ++i) world.step(def.step);
    Until until;
    until.ground.reset();
    until.time = 2;
    return length(world[id].position() -
                  fly(bullet(), launch, def.environment, Fidelity::reference(), {}, until).at(1).position);
  };
  FidelityInUse coarse;
  FidelityInUse fine;
  EXPECT_LT(error_after(10, coarse), 10);
  EXPECT_LT(error_after(0.001, fine), 0.001);
  EXPECT_LT(level(coarse.fidelity.integrator), level(fine.fidelity.integrator));
  ASSERT_FALSE(fine.notes.empty());
  EXPECT_NE(fine.notes.back().reason.find("cheapest"), std::string::npos);
  World world = make_world(def);
  BodyDef body{.cheapest_within = 1e-15};
  EXPECT_FALSE(world.spawn(bullet(), launch, body));
}

TEST(Detail, moves_between_rungs_with_hysteresis) {
  WorldDef def{.ground = {.mode = GroundMode::none}, .step = 1.0 / 64};
  ProjectileDef p = bullet();
  p.fidelity = Fidelity::constant_air();
  def.detail.rungs = {{Fidelity::constant_air(), 100}, {Fidelity::game(), 400}, {Fidelity::arcade()}};
  def.detail.hysteresis = 0.1;
  World world = make_world(def);
  const ProjectileId id = *world.spawn(p, {.position = {0, 1, 0}, .velocity = Vec3d{200, 50, 0}});
  std::vector<double> where;
  double last = 0;
  for (int i = 0; i < 300; ++i) {
    world.step(1.0 / 64);
    const Vec3d x = world[id].position();
    EXPECT_LT(x.x - last, 4);  // no jump
    last = x.x;
    if (!events_of(world, EventKind::fidelity_changed).empty()) where.push_back(length(x));
  }
  ASSERT_EQ(where.size(), 2u);
  EXPECT_GT(where[0], 110);
  EXPECT_LT(where[0], 110 + 9 * 4);
  EXPECT_GT(where[1], 440);
  EXPECT_EQ(world[id].fidelity_in_use().fidelity.motion, Motion::closed_form);
  world.set_observer(world[id].position());
  for (int i = 0; i < 9; ++i) world.step(1.0 / 64);
  EXPECT_EQ(world[id].fidelity_in_use().fidelity.integrator, Integrator::rk43);
}

}  // namespace physim::world_independence_test
