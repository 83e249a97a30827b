// Piles rest, sleep and wake as a whole; what falls as one gains nothing.
#include <array>

#include "world/joints_support.hpp"

namespace physim::world_piles_test {

using test_joints::falling;
using test_pairs::ball;
using test_pairs::put;

constexpr double kRadius = 0.05, kHz = 60;

ProjectileDef ball_on(const Fidelity& fidelity) { return {.mass = 1, .diameter = 2 * kRadius, .fidelity = fidelity}; }
ProjectileDef ball_on(Integrator integrator) { return ball_on(test::vacuum(integrator)); }
ProjectileDef wooden() { return ball_on(Integrator::semi_implicit_euler); }

/// Every rung that gravity moves, in both precisions.
std::vector<Fidelity> rungs() {
  std::vector<Fidelity> all;
  for (const Integrator integrator : test::kIntegrators) all.push_back(test::vacuum(integrator));
  all.push_back(test::vacuum());
  all.back().motion = Motion::closed_form;
  const std::size_t count = all.size();
  for (std::size_t i = 0; i < count; ++i) {
    all[i].precision = Precision::float64;
    all.push_back(all[i]);
    all.back().precision = Precision::float32;
  }
  return all;
}

bool is_of_first_order(const Fidelity& f) {
  constexpr std::array kFirst = {Integrator::classic, Integrator::explicit_euler, Integrator::semi_implicit_euler};
  return f.motion != Motion::closed_form && std::ranges::find(kFirst, f.integrator) != kFirst.end();
}

BodyDef sleepy() {
  BodyDef body = ball(kRadius, 0.5, 0.5);
  body.gravity_scale = 1;
  body.can_sleep = true;
  return body;
}

Scene floor_of_wood(const ConveyorDef& belt = {}) {
  Scene scene;
  const MaterialId wood = *scene.add_material({.restitution = 0.5, .friction = 1});
  add_thing(scene, PlaneShape{}, {.material = wood, .conveyor = belt});
  return scene;
}
World world_with(const ConveyorDef& belt = {}) { return make_world(falling(), floor_of_wood(belt)); }

/// Balls on top of each other.
std::vector<ProjectileId> stack(World& world, int count, const ProjectileDef& p = wooden(),
                                const BodyDef& body = sleepy()) {
  std::vector<ProjectileId> all;
  for (int i = 0; i < count; ++i) all.push_back(put(world, p, body, {0, kRadius + 2 * kRadius * i, 0}));
  return all;
}
std::size_t asleep(const World& world, const std::vector<ProjectileId>& ids) {
  std::size_t count = 0;
  for (const ProjectileId id : ids) count += world[id].is_alive() && world[id].is_asleep();
  return count;
}

std::string what_of(const Fidelity& rung, int count) {
  return std::string(name(rung.motion)) + " " + std::string(name(rung.integrator)) + " " +
         std::string(name(rung.precision)) + " " + std::to_string(count);
}

TEST(Piles, at_rest_sleep_in_one_step_and_stay_where_they_are) {
  for (const Fidelity& rung : rungs())
    for (int count = 2; count <= 10; ++count) {
      const std::string what = what_of(rung, count);
      World world = world_with();
      const std::vector<ProjectileId> pile = stack(world, count, ball_on(rung));
      const auto slept = test::of_kind(run_for(world, 2, 1 / kHz), EventKind::slept);
      ASSERT_EQ(slept.size(), pile.size()) << what;
      for (const Event& e : slept) EXPECT_EQ(e.time, slept.front().time) << what;
      EXPECT_NEAR(slept.front().time, sleepy().sleep_time, 3 / kHz) << what;
      EXPECT_EQ(asleep(world, pile), pile.size());
      const std::vector<Event> later = run_for(world, 1, 1 / kHz);
      EXPECT_TRUE(later.empty()) << what;
      for (int i = 0; i < count; ++i) {
        const Vec3d x = world[pile[static_cast<std::size_t>(i)]].position();
        EXPECT_NEAR(x.y, kRadius + 2 * kRadius * i, 1e-5) << what << " " << i;
        EXPECT_NEAR(x.x, 0, 1e-5);
      }
    }
}

TEST(Piles, that_are_hit_wake_and_sleep_again) {
  for (const Fidelity& rung : rungs())
    for (int count = 2; count <= 10; ++count) {
      const std::string what = what_of(rung, count);
      const std::size_t all = static_cast<std::size_t>(count);
      const ProjectileDef p = ball_on(rung);
      World world = world_with();
      std::vector<ProjectileId> pile = stack(world, count, p);
      run_for(world, 1, 1 / kHz);
      ASSERT_EQ(asleep(world, pile), all) << what;
      pile.push_back(put(world, p, sleepy(), {0, 2 * kRadius * count + 0.7, 0}));
      const auto events = run_for(world, 1, 1 / kHz);
      EXPECT_EQ(test::of_kind(events, EventKind::woke).size(), all) << what;
      run_for(world, 4, 1 / kHz);
      EXPECT_EQ(asleep(world, pile), all + 1) << what;
      for (std::size_t i = 0; i < pile.size(); ++i)
        EXPECT_NEAR(world[pile[i]].position().y, kRadius + 2 * kRadius * static_cast<double>(i), 1e-4) << what;
    }
}

/// Whatever happens to the ball below, what lay on it falls.
TEST(Piles, fall_where_the_lowest_goes_moves_or_wakes) {
  for (const int way : {0, 1, 2, 3, 4}) {
    World world = world_with();
    const std::vector<ProjectileId> pile = stack(world, 4);
    run_for(world, 1, 1 / kHz);
    ASSERT_EQ(asleep(world, pile), 4u);
    const ProjectileId low = pile.front();
    if (way == 0) {
      ASSERT_TRUE(world[low].despawn());
    }
    if (way == 1) {
      ASSERT_TRUE(world[low].set_position({5, kRadius, 0}));
    }
    if (way == 2) {
      ASSERT_TRUE(world[low].wake());
    }
    if (way == 3) {
      ASSERT_TRUE(world[low].set_velocity({3, 0, 0}));
    }
    if (way == 4) {  // shot away
      put(world, wooden(), sleepy(), {-1, kRadius, 0}, {20, 0, 0});
      run_for(world, 0.2, 1 / kHz);
    }
    EXPECT_EQ(asleep(world, pile), 0u) << way;
    run_for(world, 0.2, 1 / kHz);
    const double lies = kRadius + 2 * kRadius;  // of the second in the pile
    if (way == 2)
      EXPECT_NEAR(world[pile[1]].position().y, lies, 1e-5);
    else
      EXPECT_LT(world[pile[1]].position().y, lies - 0.01) << way;
  }
}

/// Three that touch fall on a floor beside a fourth: their blows are less than 1e-9 s apart.
TEST(Piles, gain_no_energy_where_they_fall) {
  for (const Integrator integrator : {Integrator::explicit_euler, Integrator::semi_implicit_euler, Integrator::rk4}) {
    World world = world_with();
    BodyDef awake = sleepy();
    awake.can_sleep = false;
    const std::vector<ProjectileId> pile = stack(world, 4, ball_on(integrator), awake);
    run_for(world, 1, 1 / kHz);
    ASSERT_TRUE(world[pile.front()].set_velocity({3, 0, 0}));
    for (int i = 0; i < 60; ++i) {
      world.step(1 / kHz);
      for (const ProjectileId id : pile) ASSERT_LE(length(world[id].velocity()), 3) << static_cast<int>(integrator);
    }
  }
}

/// One that falls slower below another one carries it as far as its mass allows.
TEST(Piles, that_fall_press_on_each_other_by_their_masses) {
  for (const Fidelity& rung : rungs())
    for (const double below : {0.01, 1.0, 100.0})
      for (const double scale : {0.0, 0.5, 1.0}) {
        if (rung.motion == Motion::closed_form) continue;  // of one gravity
        const std::string what = what_of(rung, 2) + " " + std::to_string(below) + " " + std::to_string(scale);
        World world = make_world(falling());
        BodyDef body = sleepy();
        const ProjectileId high = put(world, ball_on(rung), body, {0, kRadius, 0}, {1, 2, 0});
        ProjectileDef p = ball_on(rung);
        p.mass = below;
        body.gravity_scale = scale;
        const ProjectileId low = put(world, p, body, {0, -kRadius, 0}, {1, 2, 0});
        run_for(world, 0.5, 1 / kHz);
        const double g = test_joints::kGravity * (1 + below * scale) / (1 + below);
        // Rungs of the first order are off by as much as a step's fall, the others by rounding of float32.
        const double near = is_of_first_order(rung) ? 1.001 * g / kHz : 1e-4;
        for (const ProjectileId id : {high, low}) {
          EXPECT_NEAR(world[id].velocity().y, 2 - 0.5 * g, near) << what;
          EXPECT_NEAR(world[id].velocity().x, 1, 1e-5) << what;
        }
        EXPECT_NEAR(length(world[high].position() - world[low].position()), 2 * kRadius, 1e-5) << what;
      }
}

/// Two that only met on their ways hold each other up by nothing.
TEST(Piles, of_two_that_met_in_flight_fly_on_as_their_centre_does) {
  for (const Fidelity& rung : rungs())
    for (const double mass : {1e-3, 1.0, 1e3}) {
      // The original's loop begins to fall a step late, and after a meeting once more.
      if (rung.integrator == Integrator::classic && rung.motion == Motion::force) continue;
      World world = make_world(falling());
      BodyDef body = sleepy();
      body.restitution = 0, body.friction = 0;
      const Vec3d apart = Vec3d{0.6, 0.8, 0} * (2 * kRadius);
      const Vec3d v{1, 5, 0}, u{-8, 6 + 3, 0};
      // Met a third of the way through the second step.
      const double met = 4 / (3 * kHz);
      const ProjectileId high = put(world, ball_on(rung), body, apart - v * met, v);
      ProjectileDef p = ball_on(rung);
      p.mass = mass;
      const ProjectileId low = put(world, p, body, -u * met, u);
      const double before = test_joints::energy(world, std::array{high, low});
      const Vec3d all = test_joints::momentum(world, std::array{high, low});
      const auto events = run_for(world, 3 / kHz, 1 / kHz);
      const std::string what = what_of(rung, 2) + " " + std::to_string(mass);
      ASSERT_EQ(test::of_kind(events, EventKind::hit).size(), 2u) << what;
      const Vec3d now = test_joints::momentum(world, std::array{high, low});
      const double size = (1 + mass) * (rung.precision == Precision::float32 ? 1e-5 : 1e-11);
      EXPECT_NEAR(now.x, all.x, size) << what;
      EXPECT_NEAR(now.y, all.y - (1 + mass) * test_joints::kGravity * (3 / kHz), size) << what;
      if (is_of_first_order(rung)) continue;
      EXPECT_LE(test_joints::energy(world, std::array{high, low}), before + 10 * size) << what;
    }
}

TEST(Piles, do_not_sleep_where_one_may_not_or_the_floor_runs) {
  {
    World world = world_with();
    std::vector<ProjectileId> pile = stack(world, 2);
    BodyDef awake = sleepy();
    awake.can_sleep = false;
    pile.push_back(put(world, wooden(), awake, {0, 5 * kRadius, 0}));
    run_for(world, 2, 1 / kHz);
    EXPECT_EQ(asleep(world, pile), 0u);
  }
  World world = world_with({.velocity = {0.01, 0, 0}});
  const std::vector<ProjectileId> pile = stack(world, 2);
  run_for(world, 2, 1 / kHz);
  EXPECT_EQ(asleep(world, pile), 0u);
}

TEST(Piles, are_the_same_straight_on_loaded_rolled_back_and_replayed) {
  std::vector<std::byte> recording;
  World world = make_world(falling());
  ASSERT_TRUE(world.record(record_into(recording)));
  ASSERT_TRUE(world.set_scene(floor_of_wood()));
  stack(world, 3);
  run_for(world, 0.4, 1 / kHz);  // some rest is counted
  Result<World> loaded = World::load(*world.save());
  ASSERT_TRUE(loaded) << loaded.error().text();
  const Snapshot before = world.snapshot();
  run_for(world, 0.5, 1 / kHz), run_for(*loaded, 0.5, 1 / kHz);
  ASSERT_EQ(asleep(world, world.ids()), 3u);
  EXPECT_EQ(loaded->hash(), world.hash());
  const std::uint64_t slept = world.hash();
  loaded = World::load(*world.save());  // asleep
  ASSERT_TRUE(loaded) << loaded.error().text();
  for (World* each : {&world, &*loaded}) {
    ASSERT_TRUE((*each)[each->ids().front()].despawn());
    run_for(*each, 0.5, 1 / kHz);
  }
  EXPECT_EQ(loaded->hash(), world.hash());
  ASSERT_TRUE(world.restore(before));
  run_for(world, 0.5, 1 / kHz);
  EXPECT_EQ(world.hash(), slept);
  replayed(world, recording);
}

}  // namespace physim::world_piles_test
