// Worlds compute in a mode of their own (base/ieee_mode.hpp), on the caller's thread and on lent ones.
#include "processor_mode.hpp"

#include <thread>

#include "world/world_support.hpp"

namespace physim::world_processor_mode_test {

using test::Bits;

/// An engine's threads: each task on a thread of its own, which is set to some mode.
class EnginesThreads final : public TaskRunner {
 public:
  void run(std::size_t count, void (*task)(void*, std::size_t), void* context) override {
    for (std::size_t i = 0; i < count; ++i) {
      std::thread thread([=] {
        const test::InMode mode(test::kCallersModes[i % 3]);
        task(context, i);
      });
      thread.join();
    }
  }
  [[nodiscard]] unsigned threads() const override { return 2; }
};

/// What a player reads of a projectile.
void add(Bits& bits, const World& world, ProjectileId id) {
  const ProjectileView one = world[id];
  const Accelerations a = one.accelerations();
  for (const Vec3d& v : {one.position(), one.velocity(), one.state().position, one.previous_position(),
                         one.render_position(), one.angular_velocity(), one.resultant_force(), a.total, a.drag})
    bits << v;
  for (const double& x : {one.age(), one.mach(), one.mass(), one.inverse_mass()}) bits << x;
  bits << one.orientation();
}

void play(Bits& bits, TaskRunner* lent) {
  WorldDef def{.environment = {.wind = {.velocity = {0.3, 0, -2}}},
               .ground = {.mode = GroundMode::bounce},
               .time_scale = 0.7,
               .apex_events = true};
  if (lent != nullptr) def.threading = {2, 1};
  World world = make_world(def);
  world.set_task_runner(lent);
  std::vector<ProjectileId> ids;
  const Fidelity rungs[] = {Fidelity::game(), Fidelity::arcade(), Fidelity::simulation(), Fidelity::classic()};
  for (const Fidelity& rung : rungs) {
    ProjectileDef p = bullet();
    p.fidelity = rung;
    Launch launch{.position = {0, 1, 1e-310}, .speed = 61.7, .elevation = 0.3, .azimuth = 0.1};
    ids.push_back(*world.spawn(p, launch, {.gravity_scale = 0.9}));
    launch.sight.zero_range = 20;
    launch.elevation = 0;
    ids.push_back(*world.spawn(p, launch, {.angular_velocity = {1, 2, 3}}, 0.05));
    ids.push_back(*world.spawn(p, launch, {.cheapest_within = 0.5, .within_time = 0.5}));
  }
  std::ignore =
      world.add_force({.law = AnchoredSpring{{1, 2, 3}, 0.01, 2, 0.001}, .target = {.ids = {ids[0], ids[6]}}});
  for (int i = 0; i < 60; ++i) {
    std::ignore = world.advance(0.031);
    if (i == 20) std::ignore = world[ids[0]].apply_impulse({0.01, 0.02, 0.003});
    if (i == 25) std::ignore = world[ids[3]].set_fidelity(Fidelity::constant_air());
    if (i == 30) std::ignore = world[ids[6]].set_gravity_scale(0.3);
    for (const Event& e : world.events()) bits << e.time << e.position << e.velocity;
    if (i % 10 == 0)
      for (const ProjectileId id : ids) add(bits, world, id);
  }
  std::vector<Segment> segments;
  world.segments(segments);
  for (const Segment& segment : segments) bits << segment.from << segment.to;
  bits << world.time() << world.fraction() << world.hash() << world.snapshot().time();
}

TEST(ProcessorMode, OfTheCallerChangesNoWorld) {
  test::expect_own_mode({{"World", [](Bits& bits) { play(bits, nullptr); }}});
}

TEST(ProcessorMode, OfLentThreadsChangesNoWorld) {
  EnginesThreads engine;
  Bits alone, lent;
  play(alone, nullptr);
  play(lent, &engine);
  EXPECT_EQ(alone.value(), lent.value());
}

TEST(ProcessorMode, OfTheCallerChangesNoReplay) {
  std::vector<std::byte> recording;
  {
    World world;
    ASSERT_TRUE(world.record(record_into(recording)));
    std::ignore = world.spawn(bullet(), {.position = {0, 50, 0}, .speed = 200.1, .elevation = 0.1});
    for (int i = 0; i < 100; ++i) std::ignore = world.step(0.017);
    ASSERT_TRUE(world.stop_recording());
  }
  test::expect_own_mode({{"replay", [&](Bits& bits) {
                            const auto report = replay(recording);
                            bits << report->hashes << std::uint64_t{report->difference.has_value()};
                          }}});
}

}  // namespace physim::world_processor_mode_test
