// Rows that strike the ground side by side do what rows that are settled one by one do: the same bits, the same events.
// A world that tells apexes settles each row by itself; what it tells beside them is what others tell.
#include <cmath>
#include <random>

#include "physim/names.hpp"
#include "world/known_rungs.hpp"
#include "world/step/kernels.hpp"
#include "world/world_support.hpp"

namespace physim::test {
namespace world_struck_rows_test {

struct Crowd {
  WorldDef def;
  Fidelity rung;
  double dt;
  bool rules;  // some are despawned where they are low, slow or asleep
};

/// Bodies of several kinds: dead, springy, smooth and rough ones.
BodyDef body(int i, bool rules) {
  BodyDef b;
  b.restitution = i % 5 == 0 ? 0 : i % 5 == 1 ? 1 : 0.3 * (i % 4);
  b.friction = 0.4 * (i % 3);
  b.rolling_resistance = 0.05 * (i % 2);
  b.can_sleep = i % 4 != 0;
  if (rules && i % 3 == 0) b.despawn.slower = 1.5;
  if (rules && i % 3 == 1) b.despawn.below = 0.01;
  return b;
}

/// Close above the ground and on their way to it, on it, below it and climbing, fast and slow.
World filled(const Crowd& crowd, bool apexes) {
  WorldDef def = crowd.def;
  def.apex_events = apexes;
  World world = make_world(def);
  std::mt19937 random(7);
  const auto drawn = [&](double low, double high) { return low + (high - low) * (random() / 4294967296.0); };
  std::vector<KindId> kinds;
  for (int i = 0; i < 12; ++i) {
    ProjectileDef p = bullet();
    p.drag.ballistic_coefficient = 100 + 40 * i;
    p.drag.k2 = 1e-5 * (1 + i);
    p.fidelity = crowd.rung;
    kinds.push_back(*world.add_kind(p, body(i, crowd.rules)));
  }
  for (int i = 0; i < 230; ++i) {
    Launch launch;
    launch.position = {drawn(-50, 50), def.ground.height + drawn(i % 10 == 0 ? -0.05 : 0, i % 2 == 0 ? 0.3 : 4),
                       2.0 * i};
    launch.velocity = Vec3d{drawn(-80, 80), drawn(-15, 4), drawn(-3, 3)};
    if (i % 17 == 0) launch.velocity = Vec3d{drawn(-1, 1), 0, 0};
    if (i % 29 == 0) launch.position.y = def.ground.height;
    EXPECT_TRUE(world.spawn(kinds[static_cast<std::size_t>(i) % kinds.size()], launch));
  }
  return world;
}

bool same(const Event& a, const Event& b) {
  return a.kind == b.kind && a.reason == b.reason && a.id == b.id && same_bits(a.time, b.time) &&
         same_bits(a.position, b.position) && same_bits(a.velocity, b.velocity) && same_bits(a.value, b.value) &&
         same_bits(a.normal, b.normal) && same_bits(a.energy, b.energy) && a.instance == b.instance;
}

/// Emitters look at the events of a step, so an idle one has strikes told another way.
World watched(const Crowd& crowd) {
  World world = filled(crowd, false);
  EXPECT_TRUE(world.add_emitter({.kind = *world.add_kind(bullet()), .cycle = {.plays = false}}));
  return world;
}

/// Returns how many of them struck the ground.
std::size_t compare(const Crowd& crowd, int steps, World other) {
  World world = filled(crowd, false);
  const std::vector<ProjectileId> ids = world.ids();
  EXPECT_EQ(ids, other.ids());
  std::size_t strikes = 0;
  for (int step = 0; step < steps; ++step) {
    EXPECT_TRUE(world.step(crowd.dt));
    EXPECT_TRUE(other.step(crowd.dt));
    std::vector<Event> expected(other.events().begin(), other.events().end());
    std::erase_if(expected, [](const Event& e) { return e.kind == EventKind::apex; });
    const std::vector<Event> told(world.events().begin(), world.events().end());
    if (told.size() != expected.size()) return ADD_FAILURE() << "events of step " << step, 0;
    for (std::size_t i = 0; i < told.size(); ++i) {
      if (!same(told[i], expected[i])) return ADD_FAILURE() << "event " << i << " of step " << step, 0;
      strikes += told[i].kind == EventKind::bounced || told[i].kind == EventKind::landed;
    }
    for (const ProjectileId id : ids) {
      const bool alive = world[id].is_alive();
      if (alive != other[id].is_alive() || world[id].status() != other[id].status())
        return ADD_FAILURE() << "status of " << id.index << " in step " << step, 0;
      if (!alive) continue;
      const BodyState a = world[id].state(), b = other[id].state();
      if (!same_bits(a.position, b.position) || !same_bits(a.velocity, b.velocity))
        return ADD_FAILURE() << "state of " << id.index << " in step " << step, 0;
    }
  }
  return strikes;
}

std::size_t compare(const Crowd& crowd, int steps) { return compare(crowd, steps, filled(crowd, true)); }

TEST(StruckRows, DoWhatRowsDoOneByOne) {
  for (const GroundMode mode : {GroundMode::bounce, GroundMode::land, GroundMode::stick})
    for (const Fidelity& rung : known_rungs())
      for (const double dt : {1.0 / 240, 1.0 / 50, 1.0 / 20}) {
        const auto is = [](std::string_view part) { return std::string(part) + " "; };
        SCOPED_TRACE(is(name(mode)) + is(name(rung.drag)) + is(name(rung.wind)) + is(name(rung.precision)) +
                     std::to_string(dt));
        Crowd crowd{{}, rung, dt, dt < 0.01};
        crowd.def.ground.mode = mode;
        crowd.def.ground.height = dt < 0.03 ? 0 : -3.7;
        crowd.def.ground.restitution = 0.9;
        crowd.def.environment.wind.velocity = {5, 0, 2};
        EXPECT_GT(compare(crowd, static_cast<int>(1.5 / dt)), mode == GroundMode::bounce ? 300u : 100u);
      }
}

TEST(StruckRows, AreToldAlikeWhereEmittersWatch) {
  for (const GroundMode mode : {GroundMode::bounce, GroundMode::land})
    for (const Precision precision : {Precision::float32, Precision::float64}) {
      Crowd crowd{{}, Fidelity::game(), 1.0 / 50, false};
      crowd.rung.precision = precision;
      crowd.def.ground.mode = mode;
      EXPECT_GT(compare(crowd, 75, watched(crowd)), 100u) << name(mode) << ' ' << name(precision);
    }
}

struct Start {
  double height, climb, along = 3;
};

/// Which rows without drag over the ground at 0 strike it, and do nothing else.
template <class S>
unsigned plain_of(const std::vector<Start>& start, bool bounces) {
  Fidelity f = Fidelity::game();
  f.integrator = Integrator::semi_implicit_euler;
  f.drag = DragModel::off;
  f.precision = sizeof(S) == 4 ? Precision::float32 : Precision::float64;
  const Prepared p(bullet(), {}, constant_gravity(), f);
  WatchList watch{};
  watch.count = 1;
  watch.item[0] = {{EventKind::ground, 0, Crossing::falling, true}, Outcome::landed};
  const Course<S> course = p.cohort.course<S>(Tolerance{}, 0.01, watch);
  StrikeJob<S> job{};
  S x[3][StrikeJob<S>::kRows]{}, v[3][StrikeJob<S>::kRows]{};
  for (const Start& lane : start) {
    x[1][job.count] = static_cast<S>(lane.height);
    v[0][job.count] = static_cast<S>(lane.along);
    v[1][job.count++] = static_cast<S>(lane.climb);
  }
  for (int axis = 0; axis < 3; ++axis)
    job.rows.columns.position[axis] = x[axis], job.rows.columns.velocity[axis] = v[axis];
  job.rows.course = &course;
  job.rows.h = S(0.01);
  job.dt = job.frame = 0.01;
  job.bounces = bounces;
  job.below = -1, job.slowest = 0.5;
  job.restitution.fill(0.5), job.friction.fill(0);
  strike_rows_with(world_kernel(), job);
  return job.plain;
}

TEST(StruckRows, AreThoseThatStrikeOnce) {
  const std::vector<Start> start = {
      {0.05, -9},          // bounces
      {0.5, -9},           // stays above
      {0, -9},             // starts on the ground
      {0.05, 9},           // rises
      {0.0009, -5},        // bounces early
      {0.0003, -0.01},     // too slowly: it rolls
      {0.005, -0.8, 0},    // is slower than its rule after it
      {0.08, -8.01},       // bounces at the end
      {-0.01, 3},          // comes up from below
      {std::nan(""), -9},  // is nowhere
      {0.09, -9.3},        // bounces
  };
  EXPECT_EQ(plain_of<float>(start, true), 0b10010010001u);
  EXPECT_EQ(plain_of<double>(start, true), 0b10010010001u);
  EXPECT_EQ(plain_of<float>(start, false), 0b10011110001u);
  EXPECT_EQ(plain_of<double>(start, false), 0b10011110001u);
}

/// The lower end of the standard atmosphere lies a little above the ground: what comes to both in a step has left.
TEST(StruckRows, AreNoneWhereTheAirEndsFirst) {
  Crowd crowd{{}, Fidelity::game(), 1.0 / 100, false};
  crowd.rung.drag = DragModel::equation;
  crowd.rung.air = AirModel::isa;
  crowd.def.environment.altitude = -4999;
  crowd.def.ground.height = -1.02;
  for (const GroundMode mode : {GroundMode::bounce, GroundMode::land}) {
    crowd.def.ground.mode = mode;
    World world = filled(crowd, false);
    std::size_t left = 0;
    for (const Event& e : run_for(world, 1.5, crowd.dt)) left += e.reason == Reason::left_domain;
    EXPECT_GT(left, 100u);
    EXPECT_GT(compare(crowd, 150), 0u);  // of those that start below that end
  }
}

TEST(StruckRows, DoSoInPacksOfAllWidths) {
  Crowd crowd{{}, Fidelity::game(), 1.0 / 100, true};
  crowd.def.ground.mode = GroundMode::bounce;
  for (const std::string& kernel : kernels()) {
    ASSERT_TRUE(use_kernel(kernel));
    for (const Precision precision : {Precision::float32, Precision::float64}) {
      crowd.rung.precision = precision;
      EXPECT_GT(compare(crowd, 200), 300u) << kernel;
    }
  }
  use_kernel("");
}

}  // namespace world_struck_rows_test
}  // namespace physim::test
