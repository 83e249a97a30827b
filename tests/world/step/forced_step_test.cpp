// The step of forced rows: what follows from a meeting inside of it, and that nothing of it is kept for the next one.
#include "world/step/forced_step.hpp"

#include <gtest/gtest.h>

#include <functional>

#include "world/force_support.hpp"

namespace physim {
namespace world_forced_step_test {

constexpr double kMass = 0.3, kRadius = 0.25, kStiffness = 20;

BodyDef bouncing() {
  BodyDef body;
  body.gravity_scale = 0, body.restitution = 1, body.friction = 0;
  body.collision = {.on_hit = OnHit::bounce, .radius = kRadius, .others = 1};
  return body;
}

/// Two balls on springs from one anchor high above them meet within a step: Hooke's law pulls them on to its end.
TEST(ForcedStep, the_rest_of_a_step_behind_a_meeting_feels_forces_as_they_are_there) {
  const double dt = 1.0 / 60, per_second_squared = kStiffness / kMass;
  const Vec3d anchor{0, 3, 0};
  for (const Integrator integrator :
       {Integrator::semi_implicit_euler, Integrator::heun, Integrator::rk4, Integrator::tsit5}) {
    World world = make(empty_space());
    ASSERT_TRUE(world.add_force(force(AnchoredSpring{anchor, kStiffness, 0, 0}, ForceTarget::everything())));
    const auto spawn = [&](double side) {
      return *world.spawn(ball(rung(integrator), kMass), at({side * 0.33, 0, 0}, {side * -8, 0, 0}), bouncing());
    };
    const ProjectileId id = spawn(1);
    spawn(-1);
    ASSERT_TRUE(world.step(dt));
    const std::vector<Event> parted = test::of_kind(world.events(), EventKind::bounced);
    ASSERT_EQ(parted.size(), 2U);
    const double rest = dt - parted[0].time;
    ASSERT_GT(rest, 0.3 * dt);
    const Vec3d pulled = (anchor - parted[0].position) * (per_second_squared * rest);
    // Velocities of semi-implicit steps are half a step behind those of the motion, which meetings give.
    const double behind = integrator == Integrator::semi_implicit_euler ? 0.5 * dt : 0;
    const Vec3d moves = world[id].velocity() + (anchor - parted[0].position) * (per_second_squared * behind);
    // On the way it changes by so much.
    EXPECT_LT(length(moves - parted[0].velocity - pulled), per_second_squared * 8 * rest * rest) << name(integrator);
  }
}

/// What makes two balls meet that feel a force which depends on place.
struct Meeting {
  const char* name;
  std::function<void(World&)> begin;
};

std::vector<Meeting> meetings() {
  const auto spring = [](World& w) {
    BodyDef body = bouncing();
    body.gravity_scale = 1, body.restitution = 0.9;
    for (const double side : {-1., 1.})
      ASSERT_TRUE(w.spawn(ball(Fidelity::game(), kMass), at({1.4 * side, 2, 0}, {-8 * side, 0, 0}), body));
    ASSERT_TRUE(w.add_force(force(AnchoredSpring{{0, 3, 0}, kStiffness, 1, 0.1}, ForceTarget::everything())));
  };
  const auto spray = [](World& w) {
    const KindId kind = *w.add_kind(ball(rung(Integrator::semi_implicit_euler), kMass), bouncing());
    EmitterDef def{.kind = kind, .seed = 7, .per_second = {40}};
    def.from = {.shape = EmitShape::sphere, .radius = 3};
    def.start.speed = {-4};
    def.flight.noise = {30}, def.flight.noise_size = 0.7;
    def.cycle.prewarm = true, def.cycle.duration = 0.4;
    ASSERT_TRUE(w.add_emitter(def));
  };
  return {{"a spring", spring}, {"an emitter that acts on its particles", spray}};
}

/// What a detour left in memory that steps use again is not read: going on is as if there had been none.
TEST(ForcedStep, a_detour_leaves_nothing_behind) {
  for (const Meeting& meeting : meetings()) {
    const auto run = [&](int detour, bool load) {
      World w = make({.ground = {.mode = GroundMode::bounce, .height = -1}});
      meeting.begin(w);
      for (int i = 0; i < 3; ++i) w.single_step();
      const Snapshot moment = w.snapshot();
      for (int i = 0; i < detour; ++i) w.single_step();
      EXPECT_TRUE(w.restore(moment));
      if (load) w = std::move(World::load(*w.save()).value());
      for (int i = 0; i < 9; ++i) w.single_step();
      return w.hash();
    };
    const std::uint64_t straight = run(0, false);
    EXPECT_EQ(run(0, true), straight) << meeting.name << ", loaded";
    for (int detour = 1; detour <= 24; ++detour)
      EXPECT_EQ(run(detour, false), straight) << meeting.name << ", back from " << detour << " steps";
  }
}

}  // namespace world_forced_step_test
}  // namespace physim
