// Force generators in a world: order of every integrator, Newton's third law, times, targets, sleep, landings.
#include "solve/take_step.hpp"
#include "world/force_support.hpp"

namespace physim::world_forces_test {

using test::kInfinity;
using test::kNan;
using test::near;

// --------------------------------------------------------------------------------------------------- order
/// Distance from the exact place of a mass on a spring after a second.
double spring_error(Integrator integrator, int count) {
  constexpr double kOmega = 3;
  const Vec3d x0{1, 0.5, 0};
  const Vec3d v0{0, 1, -2};
  World world = make(empty_space());
  const ProjectileId id = *world.spawn(ball(rung(integrator), 2), at(x0, v0));
  world[id].add_force(spring_to_origin(2 * kOmega * kOmega));
  steps(world, count, 1.0 / count);
  const Vec3d exact = x0 * std::cos(kOmega) + v0 * (std::sin(kOmega) / kOmega);
  return length(world[id].position() - exact);
}

TEST(WorldForces, every_integrator_keeps_its_order) {
  const struct {
    Integrator integrator;
    int count;
    double order;
  } cases[] = {{Integrator::classic, 512, 1},
               {Integrator::explicit_euler, 512, 1},
               {Integrator::semi_implicit_euler, 512, 1},
               {Integrator::heun, 128, 2},
               {Integrator::rk4, 64, 4},
               {Integrator::rk43, 64, 4},
               {Integrator::tsit5, 32, 5},
               {Integrator::dop853, 6, 8}};
  for (const auto& c : cases) {
    const double coarse = spring_error(c.integrator, c.count);
    const double fine = spring_error(c.integrator, 2 * c.count);
    EXPECT_GT(std::log2(coarse / fine), c.order - 0.25) << test::text(c.integrator) << " " << coarse << " " << fine;
    EXPECT_LT(std::log2(coarse / fine), c.order + 1) << test::text(c.integrator);
  }
}

TEST(WorldForces, a_constant_force_is_the_force_of_the_projectile) {
  const Vec3d push{3, -0.4, 1};
  for (const Integrator i : {Integrator::classic, Integrator::explicit_euler, Integrator::semi_implicit_euler,
                             Integrator::heun, Integrator::rk4}) {
    for (const Precision p : {Precision::float32, Precision::float64}) {
      World world = make(empty_space(true));
      ProjectileDef carried = ball(rung(i, p), 0.7);
      carried.fidelity.drag = DragModel::linear_quadratic;
      carried.drag.k2 = 0.03;
      const ProjectileDef pushed = carried;
      carried.force = push;
      const ProjectileId a = *world.spawn(carried, at({1, 2, 3}, {5, 6, 7}));
      const ProjectileId b = *world.spawn(pushed, at({1, 2, 3}, {5, 6, 7}));
      world[b].add_force(ConstantForce{push});
      steps(world, 50, 1.0 / 60);
      EXPECT_EQ(world[a].state(), world[b].state()) << test::text(i);
      // A force of its own and a generator add up.
      ASSERT_TRUE(world[a].add_force(ConstantForce{push * -1.0}));
      EXPECT_TRUE(near(world[a].accelerations().applied, {}, 0, 1e-6));
    }
  }
}

// --------------------------------------------------------------------------------------------------- springs
struct Pair {
  World world = make(empty_space());
  ProjectileId a, b;
  ForceId spring;

  Pair(const Fidelity& fa, const Fidelity& fb) {
    a = *world.spawn(ball(fa, 1), at({0, 0, 0}, {0, 1, 0}));
    b = *world.spawn(ball(fb, 3), at({2, 0, 0}, {0, 0, 0.5}));
    Spring law{.other = b, .stiffness = 10, .rest_length = 1.5};
    spring = *world[a].add_force(law);
  }
  [[nodiscard]] Vec3d momentum() const { return world[a].velocity() * 1.0 + world[b].velocity() * 3.0; }
  [[nodiscard]] double energy() const {
    const double stretch = length(world[a].position() - world[b].position()) - 1.5;
    return 0.5 * length_squared(world[a].velocity()) + 1.5 * length_squared(world[b].velocity()) +
           5 * stretch * stretch;
  }
};

TEST(WorldForces, a_spring_between_two_keeps_momentum_and_energy) {
  Pair pair(rung(Integrator::rk4), rung(Integrator::rk4));
  const double energy = pair.energy();
  steps(pair.world, 2000, 1.0 / 200);
  EXPECT_TRUE(near(pair.momentum(), {0, 1, 1.5}, 0, 1e-12));
  EXPECT_TRUE(near(pair.energy(), energy, 1e-6));
}

TEST(WorldForces, rungs_and_precisions_of_one_integrator_push_each_other) {
  Fidelity other = rung(Integrator::rk4, Precision::float32);
  other.drag = DragModel::linear_quadratic;
  Pair mixed(rung(Integrator::rk4), other);
  Pair same(rung(Integrator::rk4), rung(Integrator::rk4));
  steps(mixed.world, 500, 1.0 / 200);
  steps(same.world, 500, 1.0 / 200);
  EXPECT_TRUE(near(mixed.momentum(), {0, 1, 1.5}, 0, 1e-5));
  EXPECT_TRUE(near(mixed.world[mixed.a].position(), same.world[same.a].position(), 0, 1e-4));
  EXPECT_EQ(mixed.world.cohorts().size(), 2u);
}

TEST(WorldForces, under_two_integrators_both_ends_feel_a_spring) {
  Pair mixed(rung(Integrator::rk4), rung(Integrator::semi_implicit_euler));
  Pair same(rung(Integrator::rk4), rung(Integrator::rk4));
  steps(mixed.world, 2000, 1.0 / 2000);
  steps(same.world, 2000, 1.0 / 2000);
  EXPECT_TRUE(near(mixed.world[mixed.a].position(), same.world[same.a].position(), 0, 5e-3));
  EXPECT_TRUE(near(mixed.world[mixed.b].position(), same.world[same.b].position(), 0, 5e-3));
}

TEST(WorldForces, what_nothing_moves_pulls_and_is_not_pulled) {
  World world = make(empty_space());
  const ProjectileId rock = *world.spawn(ball(rung(Integrator::rk4)), at({0, 0, 0}), {.infinite_mass = true});
  const ProjectileId a = *world.spawn(ball(rung(Integrator::rk4)), at({1, 0, 0}));
  const ProjectileId b = *world.spawn(ball(rung(Integrator::rk4)), at({1, 0, 0}));
  Spring law{.other = rock, .stiffness = 4};
  world[a].add_force(law);  // from the free end
  law.other = b;
  world[rock].add_force(law);  // and from the fixed one
  steps(world, 100, 1.0 / 100);
  EXPECT_EQ(world[rock].position(), Vec3d{});
  EXPECT_EQ(world[a].state(), world[b].state());
  EXPECT_TRUE(near(world[a].position().x, std::cos(2.0), 0, 1e-7));
  EXPECT_EQ(world[rock].resultant_force(), Vec3d{});
}

TEST(WorldForces, frozen_axes_and_parts_of_gravity_hold) {
  World world = make(empty_space(true));
  BodyDef body{.gravity_scale = 0.5, .frozen = Axes::x | Axes::z};
  const ProjectileId id = *world.spawn(ball(rung(Integrator::rk4), 2), at({0, 0, 0}, {1, 1, 1}), body);
  world[id].add_force(ConstantForce{{4, 4, 4}});
  steps(world, 100, 1.0 / 100);
  EXPECT_EQ(world[id].position().x, 0);
  EXPECT_TRUE(near(world[id].position().y, 1 + 0.5 * (2 - 0.5 * 9.80665), 1e-9));
}

// --------------------------------------------------------------------------------------------------- times
TEST(WorldForces, a_push_over_whole_steps_has_its_exact_impulse) {
  for (const Integrator i : test::kIntegrators) {
    World world = make(empty_space());
    const ProjectileId id = *world.spawn(ball(rung(i), 2), at({}));
    ForceDef push = force(ConstantForce{{6, 0, 0}}, {.ids = {id}, .kind = {}});
    push.delay = 0.1;
    push.duration = 0.4;
    const ForceId f = *world.add_force(push);
    steps(world, 6, 1.0 / 60);
    EXPECT_EQ(world[id].velocity().x, 0) << test::text(i);
    steps(world, 23, 1.0 / 60);
    EXPECT_TRUE(world.is_active(f));
    steps(world, 1, 1.0 / 60);
    EXPECT_FALSE(world.is_active(f)) << "its duration is over";
    steps(world, 3, 1.0 / 60);  // the original loop feels it one frame late
    EXPECT_TRUE(near(world[id].velocity().x, 3 * 0.4, 1e-12)) << test::text(i);
    EXPECT_FALSE(world.cohorts()[0].forced && world.force_count() > 0);
  }
}

TEST(WorldForces, stay_until_removed_from_one_or_all) {
  World world = make(empty_space());
  const ProjectileId a = *world.spawn(ball(rung(Integrator::rk4)), at({}));
  const ProjectileId b = *world.spawn(ball(rung(Integrator::rk4)), at({}));
  const ForceId f = *world.add_force(force(ConstantForce{{1, 0, 0}}, {.ids = {b, a, b}, .kind = {}}));
  steps(world, 60, 1.0 / 60);
  EXPECT_TRUE(near(world[a].velocity().x, 1, 1e-12));
  EXPECT_TRUE(near(world[b].velocity().x, 1, 1e-12)) << "named twice, pushed once";
  EXPECT_TRUE(world[a].remove_force(f));
  EXPECT_FALSE(world[a].remove_force(f));
  steps(world, 60, 1.0 / 60);
  EXPECT_TRUE(near(world[a].velocity().x, 1, 1e-12));
  EXPECT_TRUE(near(world[b].velocity().x, 2, 1e-12));
  EXPECT_TRUE(world.remove_force(f));
  EXPECT_FALSE(world.remove_force(f));
  EXPECT_FALSE(world.is_active(f));
  EXPECT_EQ(world.force_count(), 0u);
  steps(world, 60, 1.0 / 60);
  EXPECT_TRUE(near(world[b].velocity().x, 2, 1e-12));
  const ForceId next = *world[a].add_force(ConstantForce{{1, 0, 0}});
  EXPECT_EQ(next.index, f.index);
  EXPECT_FALSE(world.is_active(f)) << "its place was used again";
  EXPECT_TRUE(world[a].despawn());
  steps(world, 1, 1.0 / 60);
  EXPECT_FALSE(world.is_active(next)) << "its only target is gone";
}

// --------------------------------------------------------------------------------------------------- targets
TEST(WorldForces, act_on_kinds_and_layers_now_and_later) {
  World world = make(empty_space());
  BodyDef in_layer_2{.layers = 2};
  const KindId one = *world.add_kind(ball(rung(Integrator::rk4)));
  const KindId two = *world.add_kind(ball(rung(Integrator::rk4)), in_layer_2);
  std::vector<ProjectileId> ids{*world.spawn(one, at({})), *world.spawn(two, at({}))};
  const ForceId x = *world.add_force(force(ConstantAcceleration{{1, 0, 0}}, {.ids = {}, .kind = one}));
  const ForceId y = *world.add_force(force(ConstantAcceleration{{0, 1, 0}}, {.ids = {}, .kind = {}, .layers = 2}));
  const ForceId z = *world.add_force(force(ConstantAcceleration{{0, 0, 1}}, ForceTarget::everything()));
  ids.push_back(*world.spawn(one, at({})));
  ids.push_back(*world.spawn(two, at({})));
  ids.push_back(*world.spawn(one, at({})));
  EXPECT_TRUE(world[ids[4]].set_layers(2));
  const Vec3d expected[] = {{1, 0, 1}, {0, 1, 1}, {1, 0, 1}, {0, 1, 1}, {1, 1, 1}};
  for (std::size_t i = 0; i < ids.size(); ++i) EXPECT_EQ(world[ids[i]].accelerations().applied, expected[i]) << i;
  steps(world, 64, 1.0 / 64);
  for (std::size_t i = 0; i < ids.size(); ++i) EXPECT_TRUE(near(world[ids[i]].velocity(), expected[i], 1e-12)) << i;
  EXPECT_TRUE(world[ids[4]].set_layers(1));
  EXPECT_TRUE(world[ids[0]].remove_force(z));
  EXPECT_TRUE(world.remove_force(x));
  steps(world, 64, 1.0 / 64);
  const Vec3d later[] = {{1, 0, 1}, {0, 2, 2}, {1, 0, 2}, {0, 2, 2}, {1, 1, 2}};
  for (std::size_t i = 0; i < ids.size(); ++i) EXPECT_TRUE(near(world[ids[i]].velocity(), later[i], 1e-12)) << i;
  world.clear();
  steps(world, 1, 1.0 / 64);
  EXPECT_TRUE(world.is_active(y)) << "groups wait for those to come";
}

TEST(WorldForces, only_motion_force_feels_them_and_notes_say_so) {
  World world = make(empty_space(true));
  Fidelity velocity = rung(Integrator::rk4);
  velocity.motion = Motion::velocity;
  const ProjectileId a = *world.spawn(ball(velocity), at({}));
  const ProjectileId b = *world.spawn(ball(rung(Integrator::tsit5)), at({}));
  EXPECT_TRUE(world[b].fidelity_in_use().notes.empty());
  world.add_force(force(ConstantForce{{1, 0, 0}}, ForceTarget::everything()));
  steps(world, 10, 0.1);
  EXPECT_EQ(world[a].velocity().x, 0);
  EXPECT_TRUE(near(world[b].velocity().x, 1, 1e-12));
  ASSERT_EQ(world[a].fidelity_in_use().notes.size(), 1u);
  EXPECT_EQ(world[a].fidelity_in_use().notes[0].effect, "motion");
  ASSERT_EQ(world[b].fidelity_in_use().notes.size(), 1u);
  EXPECT_EQ(world[b].fidelity_in_use().notes[0].effect, "integrator");
  EXPECT_TRUE(world[a].set_fidelity(rung(Integrator::rk4)));
  steps(world, 10, 0.1);
  EXPECT_TRUE(near(world[a].velocity().x, 1, 1e-12));
}

TEST(WorldForces, user_functions_see_all_at_once_in_every_stage) {
  for (const Integrator i : test::kIntegrators) {
    World world = make(empty_space());
    int calls = 0;
    std::vector<ProjectileId> seen;
    CustomForce wind{[&](const ForceBatch& batch) {
      ++calls;
      seen.assign(batch.id.begin(), batch.id.end());
      for (std::size_t k = 0; k < batch.force.size(); ++k) batch.force[k] = Vec3d{1, 0, 0} * batch.mass[k];
    }};
    std::vector<ProjectileId> ids;
    for (int k = 0; k < 70; ++k) {
      const Precision p = k % 3 == 0 ? Precision::float32 : Precision::float64;
      ids.push_back(*world.spawn(ball(rung(i, p), 1 + k), at({1.0 * k, 0, 0})));
    }
    for (const std::size_t gone : {5u, 17u, 20u}) world[ids[gone]].despawn();
    world.add_force(force(wind, ForceTarget::everything()));
    world.step(0.5);
    EXPECT_EQ(calls, end_slope(i)) << test::text(i);
    EXPECT_EQ(seen, world.ids()) << "by slot, whatever the rows";
    if (i == Integrator::classic) continue;  // a frame late
    for (const ProjectileId id : seen) EXPECT_TRUE(near(world[id].velocity().x, 0.5, 1e-6));
  }
}

TEST(WorldForces, zones_thrust_and_the_rest_reach_the_world) {
  WorldDef def = empty_space();
  def.environment.atmosphere.model = AirModel::constant;
  World world = make(def);
  ProjectileDef p = ball(rung(Integrator::rk4));
  p.fidelity.air = AirModel::constant;
  p.drag.coefficient = 0.5;
  const KindId kind = *world.add_kind(p);
  WindZone zone{
      .velocity = {0, 0, 10}, .low = {-kInfinity, -kInfinity, -kInfinity}, .high = {kInfinity, kInfinity, kInfinity}};
  world.add_force(force(zone, ForceTarget::everything()));
  Thrust thrust{.curve = {{0, 5}, {1, 5}}, .direction = {1, 0, 0}};
  world.add_force(force(thrust, {.ids = {}, .kind = kind}));
  steps(world, 60, 1.0 / 60);
  const ProjectileId late = *world.spawn(kind, at({}));
  EXPECT_GT(world[late].accelerations().applied.z, 0.1);
  EXPECT_TRUE(near(world[late].accelerations().applied.x, 5, 1e-3));
  steps(world, 90, 1.0 / 60);
  EXPECT_LT(world[late].velocity().x, 5);
  EXPECT_GT(world[late].velocity().x, 4.5);
}

// --------------------------------------------------------------------------------------------------- sleep
TEST(WorldForces, wake_sleepers_when_they_come_and_when_they_go) {
  World world = make(empty_space());
  const ProjectileId id = *world.spawn(ball(rung(Integrator::semi_implicit_euler)), at({1, 0, 0}));
  AnchoredSpring law{.rest_length = 1};
  steps(world, 60, 1.0 / 60);
  ASSERT_TRUE(world[id].is_asleep());
  const ForceId f = *world[id].add_force(law);
  EXPECT_FALSE(world[id].is_asleep());
  EXPECT_EQ(kinds(world).back(), EventKind::woke);
  steps(world, 60, 1.0 / 60);
  EXPECT_TRUE(world[id].is_asleep()) << "at rest under a spring it may sleep";
  ForceDef later = force(ConstantForce{{1, 0, 0}}, {.ids = {id}, .kind = {}});
  later.delay = 0.5;
  world.add_force(later);
  steps(world, 29, 1.0 / 60);
  EXPECT_TRUE(world[id].is_asleep()) << "a push to come does not wake it yet";
  steps(world, 2, 1.0 / 60);
  EXPECT_FALSE(world[id].is_asleep());
  EXPECT_GT(world[id].velocity().x, 0);
  world[id].sleep();
  EXPECT_TRUE(world.remove_force(f));
  EXPECT_FALSE(world[id].is_asleep());
}

// --------------------------------------------------------------------------------------------------- ground
TEST(WorldForces, landings_lie_on_the_real_step) {
  for (const Integrator i :
       {Integrator::heun, Integrator::rk4, Integrator::rk43, Integrator::tsit5, Integrator::dop853}) {
    WorldDef def = empty_space();
    def.ground.mode = GroundMode::land;
    World world = make(def);
    // y = cos(3 t) - 0.2 comes down to the ground; the spring is anchored below it.
    const ProjectileId id = *world.spawn(ball(rung(i)), at({0, 0.8, 0}, {2, 0, 0}));
    AnchoredSpring law = spring_to_origin(9);
    law.anchor = {0, -0.2, 0};
    world[id].add_force(law);
    const double exact = std::acos(0.2) / 3;
    for (int k = 0; k < 60 && world[id].is_alive(); ++k) world.step(1.0 / 60);
    ASSERT_EQ(world[id].status(), LifeStatus::landed);
    ASSERT_EQ(world.events().size(), 1u);
    const double tolerance = i == Integrator::heun ? 1e-3 : 2e-7;
    EXPECT_TRUE(near(world.events()[0].time, exact, 0, tolerance)) << test::text(i);
    EXPECT_TRUE(near(world.events()[0].position, {2.0 / 3 * std::sin(3 * exact), 0, 0}, 0, 2 * tolerance));
  }
}

/// What lies on ice feels the mean of a push over a step: with that of the step's start the energy of a spring grew
/// eight times in ten seconds, and drag that is strong for the step threw a puck away.
TEST(WorldForces, what_lies_on_ice_swings_at_a_spring_and_is_stopped_by_drag) {
  WorldDef def = empty_space(true);
  def.ground.mode = GroundMode::bounce;
  BodyDef puck{.restitution = 0, .friction = 0, .rolling_resistance = 0};
  puck.can_sleep = false;
  for (const Precision p : {Precision::float32, Precision::float64})
    for (const Integrator i : {Integrator::semi_implicit_euler, Integrator::rk4})
      for (const double dt : {1.0 / 240, 1.0 / 60, 0.1}) {
        World world = make(def);
        const ProjectileId id = *world.spawn(ball(rung(i, p)), at({1, 0, 0}), puck);
        AnchoredSpring law = spring_to_origin(25);
        world[id].add_force(law);
        double least = 1e9, most = 0;
        for (int k = 0; k * dt < 10; ++k) {
          ASSERT_TRUE(world.step(dt));
          const double x = world[id].position().x, v = world[id].velocity().x, energy = 25 * x * x + v * v;
          least = std::min(least, energy), most = std::max(most, energy);
        }
        EXPECT_LT(most, 25 * 1.1) << test::text(i) << dt;
        EXPECT_GT(least, dt < 0.1 ? 25 * 0.9 : 0) << test::text(i) << dt;

        World thick = make(def);
        const ProjectileId slow = *thick.spawn(ball(rung(i, p)), at({0, 0, 0}, {3, 0, 0}), puck);
        thick[slow].add_force(LinearQuadraticDragForce{.k1 = 2 / dt});
        for (int k = 0; k < 100; ++k) {
          ASSERT_TRUE(thick.step(dt));
          ASSERT_LE(std::abs(thick[slow].velocity().x), 3.1);
        }
        EXPECT_LT(std::abs(thick[slow].velocity().x), 0.1) << test::text(i) << dt;
      }
}

TEST(WorldForces, bounces_and_rest_under_a_gravity_generator) {
  for (const Precision p : {Precision::float32, Precision::float64}) {
    WorldDef with = empty_space(true);
    with.ground.mode = GroundMode::bounce;
    WorldDef without = with;
    without.environment.gravity.model = GravityModel::off;
    World natural = make(with);
    World pushed = make(without);
    const ProjectileId a = *natural.spawn(ball(rung(Integrator::rk4, p)), at({0, 3, 0}, {1, 0, 0}));
    const ProjectileId b = *pushed.spawn(ball(rung(Integrator::rk4, p)), at({0, 3, 0}, {1, 0, 0}));
    pushed.add_force(force(GravityForce{}, ForceTarget::everything()));
    for (int k = 0; k < 600; ++k) {
      natural.step(1.0 / 60);
      pushed.step(1.0 / 60);
      ASSERT_EQ(kinds(natural), kinds(pushed)) << k;
      ASSERT_TRUE(near(pushed[b].position(), natural[a].position(), 0, 1e-4)) << k;
    }
    EXPECT_TRUE(pushed[b].is_asleep());
    pushed[b].add_force(ConstantForce{{0, 20, 0}}, 0.5);
    pushed.step(1.0 / 60);
    EXPECT_GT(pushed[b].velocity().y, 0) << "something lifts it off the ground";
  }
}

TEST(WorldForces, rules_and_apexes_are_seen) {
  WorldDef def = empty_space();
  def.apex_events = true;
  World world = make(def);
  BodyDef body{.despawn = {.farther = 50}};
  const ProjectileId id = *world.spawn(ball(rung(Integrator::rk4)), at({0, 0, 0}, {1, 10, 0}), body);
  world[id].add_force(GravityForce{{0, -10, 0}});
  std::vector<Event> events;
  for (int k = 0; k < 600; ++k) {
    world.step(1.0 / 60);
    events.insert(events.end(), world.events().begin(), world.events().end());
  }
  ASSERT_EQ(events.size(), 2u);
  EXPECT_EQ(events[0].kind, EventKind::apex);
  EXPECT_TRUE(near(events[0].time, 1, 1e-9));
  EXPECT_TRUE(near(events[0].position, {1, 5, 0}, 1e-9));
  EXPECT_EQ(events[1].reason, Reason::farther);
}

}  // namespace physim::world_forces_test
