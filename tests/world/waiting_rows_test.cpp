// Rows of closed forms that wait until somebody reads them: worlds in lock step with worlds in which none waits.
#include "world/waiting_rows.hpp"

#include <cfenv>
#include <cmath>
#include <thread>

#include "physim/recording.hpp"
#include "world/random_session.hpp"
#include "world/world_support.hpp"

namespace physim {
namespace world_waiting_rows_test {

/// Runs f for a world whose rows wait, or never do.
template <class F>
auto with_waiting(bool may, const F& f) {
  let_rows_wait(may);
  struct Back {
    ~Back() { let_rows_wait(true); }
  } back;
  return f();
}

void expect_equal_events(const World& a, const World& b) {
  ASSERT_EQ(a.events().size(), b.events().size());
  for (std::size_t i = 0; i < a.events().size(); ++i) {
    const Event &x = a.events()[i], &y = b.events()[i];
    ASSERT_EQ(x.kind, y.kind);
    ASSERT_EQ(x.id, y.id);
    ASSERT_EQ(x.time, y.time);
    ASSERT_EQ(x.position, y.position);
    ASSERT_EQ(x.velocity, y.velocity);
    ASSERT_EQ(x.reason, y.reason);
  }
}

void expect_equal_reads(const World& a, const World& b, ProjectileId id) {
  ASSERT_EQ(a[id].previous_position(), b[id].previous_position());
  ASSERT_EQ(a[id].state(), b[id].state());
  ASSERT_EQ(a[id].render_position(), b[id].render_position());
  ASSERT_EQ(a[id].accelerations().total, b[id].accelerations().total);
  ASSERT_EQ(a[id].status(), b[id].status());
}

void expect_equal_segments(const World& a, const World& b) {
  std::vector<Segment> x, y;
  a.segments(x), b.segments(y);
  ASSERT_EQ(x.size(), y.size());
  for (std::size_t i = 0; i < x.size(); ++i) {
    ASSERT_EQ(x[i].id, y[i].id);
    ASSERT_EQ(x[i].from, y[i].from);
    ASSERT_EQ(x[i].to, y[i].to);
  }
}

/// Looks at one thing or another, or at nothing.
void compare_somehow(const World& a, const World& b, std::mt19937& random) {
  ASSERT_NO_FATAL_FAILURE(expect_equal_events(a, b));
  const std::vector<ProjectileId> ids = a.ids();
  ASSERT_EQ(ids, b.ids());
  switch (random() % 12) {
    case 0: ASSERT_EQ(a.hash(), b.hash()); return;
    case 1: return expect_equal_segments(a, b);
    case 2:
      for (const ProjectileId id : ids) ASSERT_NO_FATAL_FAILURE(expect_equal_reads(a, b, id));
      return;
    case 3: ASSERT_EQ(a.save().value(), b.save().value()); return;
    default:
      if (!ids.empty()) expect_equal_reads(a, b, ids[random() % ids.size()]);
  }
}

TEST(WaitingRows, random_sessions_go_on_as_where_none_waits) {
  for (unsigned seed = 1; seed <= 12; ++seed) {
    SCOPED_TRACE(seed);
    WorldDef def = test::session_world();
    def.apex_events = seed % 2 == 0;
    if (seed % 3 == 0) def.detail = {};
    if (seed % 3 != 1) def.ground.mode = GroundMode::none;  // who lies on it keeps its neighbours from waiting
    World waits = make_world(def), steps = make_world(def);
    test::RandomSession one(waits, seed), other(steps, seed);
    for (test::RandomSession* session : {&one, &other}) {
      session->meet_others = false;
      session->closed = true;
      session->emitters = seed % 4 == 0;
      session->joints = seed % 4 == 1;
    }
    std::mt19937 random(seed);
    for (int act = 0; act < 1200; ++act) {
      one.act();
      with_waiting(false, [&] { return other.act(); });
      const int quiet = random() % 6 == 0 ? 40 : 0;  // now and then nobody does anything
      for (int i = 0; i < quiet; ++i) {
        waits.single_step();
        with_waiting(false, [&] { return steps.single_step(); });
        ASSERT_NO_FATAL_FAILURE(expect_equal_events(waits, steps)) << act;
      }
      ASSERT_NO_FATAL_FAILURE(compare_somehow(waits, steps, random)) << act;
    }
    EXPECT_EQ(waits.hash(), steps.hash());
  }
}

/// One rule, event or law at a time, over whole flights of many.
void expect_equal_flights(const WorldDef& def, const BodyDef& body, const Launch& from, const Vec3d& spread) {
  for (const Precision precision : {Precision::float32, Precision::float64}) {
    for (const DragModel drag : {DragModel::off, DragModel::damping, DragModel::linear_quadratic}) {
      ProjectileDef p = bullet();
      p.drag.k2 = 0;
      p.fidelity = Fidelity::arcade();
      p.fidelity.motion = Motion::closed_form;
      p.fidelity.precision = precision;
      p.fidelity.drag = drag;
      p.fidelity.wind = WindModel::constant;
      World waits = make_world(def), steps = make_world(def);
      for (int i = 0; i < 100; ++i) {
        Launch launch = from;
        launch.velocity = *from.velocity + spread * (i / 100.0);
        ASSERT_EQ(*waits.spawn(p, launch, body), *steps.spawn(p, launch, body));
      }
      std::size_t events = 0;
      for (int i = 0; i < 1500; ++i) {
        waits.step(1.0 / 128);
        with_waiting(false, [&] { return steps.step(1.0 / 128); });
        ASSERT_NO_FATAL_FAILURE(expect_equal_events(waits, steps)) << i;
        events += waits.events().size();
      }
      EXPECT_EQ(waits.hash(), steps.hash());
      EXPECT_GT(events, 50u);
    }
  }
}

const Launch kUp{.position = {3, 20, -4}, .velocity = Vec3d{60, 30, 1}};

TEST(WaitingRows, land_when_they_do) {
  WorldDef def;
  def.environment.wind.velocity = {3, 0, -2};
  for (const GroundMode mode : {GroundMode::land, GroundMode::stick, GroundMode::bounce}) {
    def.ground.mode = mode;
    expect_equal_flights(def, {.restitution = 0.8}, kUp, {5, 20, 3});
  }
}

TEST(WaitingRows, are_noticed_by_every_rule) {
  WorldDef def;
  def.ground.mode = GroundMode::none;
  def.environment.wind.velocity = {-8, 2, 4};
  const DespawnRules rules[] = {{.below = -30},
                                {.farther = 90},
                                {.slower = 45},
                                {.older = 2.5},
                                {.outside_box = true, .box_low = {-20, -50, -60}, .box_high = {200, 60, 70}}};
  for (const DespawnRules& rule : rules) {
    BodyDef body;
    body.despawn = rule;
    expect_equal_flights(def, body, kUp, {-90, 25, 9});
  }
}

TEST(WaitingRows, tell_their_apex_in_its_step) {
  WorldDef def;
  def.ground.mode = GroundMode::none;
  def.apex_events = true;
  expect_equal_flights(def, {}, kUp, {5, 60, 0});
}

/// Two worlds that are told the same, and of which only one waits.
struct Twins {
  World waits, steps;
  explicit Twins(const WorldDef& def) : waits(make_world(def)), steps(make_world(def)) {}

  template <class F>
  void both(const F& f) {
    f(waits);
    with_waiting(false, [&] { f(steps); });
  }
  void run(int count) {
    for (int i = 0; i < count; ++i) {
      both([](World& w) { w.step(1.0 / 64); });
      ASSERT_NO_FATAL_FAILURE(expect_equal_events(waits, steps)) << i;
    }
  }
};

/// A row that takes the place of one that left has its own time to land.
TEST(WaitingRows, know_who_took_a_place) {
  WorldDef def;
  def.ground.mode = GroundMode::land;
  Twins twins(def);
  ProjectileDef p = stone();
  p.fidelity.motion = Motion::closed_form;
  std::vector<ProjectileId> ids;
  for (int i = 0; i < 128; ++i)  // the last ones land after 6 s, the others after a minute
    twins.both([&](World& w) {
      ids.push_back(
          *w.spawn(p, {.position = {double(i), 1, 0}, .velocity = Vec3d{1, i < 96 ? 300.0 : 30 - 0.1 * i, 0}}));
    });
  twins.run(100);
  for (std::size_t i = 0; i < 40; ++i) twins.both([&](World& w) { EXPECT_TRUE(w[ids[4 * i]].despawn()); });
  twins.run(400);
  EXPECT_EQ(twins.waits.size(), 56u);
  EXPECT_EQ(twins.waits.hash(), twins.steps.hash());
}

/// After a long wait anything may be asked of a world, in its midst and without a look before.
TEST(WaitingRows, are_right_whatever_is_called_after_a_wait) {
  WorldDef def;
  def.ground.mode = GroundMode::none;
  Twins twins(def);
  ProjectileDef p = bullet();
  p.drag.k2 = 0;
  p.fidelity = Fidelity::arcade();
  p.fidelity.motion = Motion::closed_form;
  p.fidelity.wind = WindModel::constant;
  std::vector<ProjectileId> ids;
  for (int i = 0; i < 200; ++i) {
    p.fidelity.drag = i % 3 == 0 ? DragModel::damping : i % 3 == 1 ? DragModel::linear_quadratic : DragModel::off;
    p.fidelity.precision = i % 2 == 0 ? Precision::float32 : Precision::float64;
    const Launch launch{.position = {double(i), 900, 2}, .velocity = Vec3d{0.5 * i, 20, -3}};
    ids.push_back(*twins.waits.spawn(p, launch));
    ASSERT_EQ(*twins.steps.spawn(p, launch), ids.back());
  }
  std::vector<Snapshot> moments[2];
  std::mt19937 random(5);
  for (int round = 0; round < 400; ++round) {
    const auto bits = static_cast<unsigned>(random());
    const ProjectileId id = ids[bits / 64 % ids.size()];
    const double some = 1 + bits % 1000 / 100.0;
    Environment place;
    place.gravity.acceleration = some;
    place.wind.velocity = {some, 0, 3 - some};
    Fidelity rung = p.fidelity;
    rung.drag = static_cast<DragModel>(bits % 3);
    rung.precision = bits % 5 < 2 ? Precision::float32 : Precision::float64;
    rung.gravity = bits % 7 == 0 ? GravityModel::off : GravityModel::constant;
    int which = 0;
    twins.both([&](World& w) {
      std::vector<Snapshot>& its = moments[which++];
      switch (round % 16) {
        case 0: return void(w.set_environment(0, place));
        case 1: return void(w[id].set_fidelity(rung));
        case 2: return void(w.set_fidelity(std::span(ids).first(70), rung));
        case 3: return void(w[id].set_gravity_scale(some));
        case 4: return void(w[id].set_velocity({some, 30, 1}));
        case 5: return void(w[id].set_frozen(Axes::x, {}));
        case 6: return void(w[id].sleep());
        case 7: return void(w[id].wake());
        case 8: return void(w[id].set_kinematic(bits % 2 == 0));
        case 9:
          return void(w.spawn(p, {.position = {some, 800, 0}, .velocity = Vec3d{some, 9, 0}}, {}, bits % 2 * 0.1));
        case 10: return void(bits % 4 == 0 && w[id].despawn().ok());
        case 11: return its.push_back(w.snapshot());
        case 12: return void(!its.empty() && w.restore(its[bits / 8 % its.size()]).ok());
        case 13: return void(w.set_detail(bits % 2 == 0 ? DetailRule{{{rung, 300}, {p.fidelity}}} : DetailRule{}));
        case 14: return void(w.step(1.0 / 50));
        default: w = std::move(World::load(w.save().value()).value()), its.clear();
      }
    });
    ASSERT_NO_FATAL_FAILURE(expect_equal_events(twins.waits, twins.steps)) << round;
    if (bits % 4 == 0) expect_equal_reads(twins.waits, twins.steps, id);
    if (bits % 16 == 1) {
      EXPECT_EQ(twins.waits.hash(), twins.steps.hash());
    } else if (bits % 16 == 2) {
      expect_equal_segments(twins.waits, twins.steps);
    } else if (bits % 16 == 3) {
      EXPECT_EQ(twins.waits.predict(id, 2.0).end().position, twins.steps.predict(id, 2.0).end().position);
    }
    ASSERT_FALSE(HasFailure()) << round;
    ASSERT_NO_FATAL_FAILURE(twins.run(static_cast<int>(bits % 60)));
  }
  EXPECT_EQ(twins.waits.hash(), twins.steps.hash());
}

/// Chunks of one cohort are stepped by several threads, and several read it.
TEST(WaitingRows, are_stepped_and_read_by_threads) {
  WorldDef def;
  def.threading = {.threads = 3, .rows_per_thread = 1000};
  Twins twins(def);
  ProjectileDef p = bullet();
  p.fidelity = Fidelity::arcade();
  std::vector<ProjectileId> ids;
  for (int i = 0; i < 13000; ++i) {
    const Launch launch{.position = {double(i), 20, 2}, .velocity = Vec3d{90, 0.001 * i, -3}};
    ids.push_back(*twins.waits.spawn(p, launch));
    ASSERT_EQ(*twins.steps.spawn(p, launch), ids.back());
  }
  twins.run(150);
  std::vector<Vec3d> places[3];
  {
    std::vector<std::jthread> readers;
    for (std::vector<Vec3d>& its : places)
      readers.emplace_back([&] {
        for (const ProjectileId id : ids) its.push_back(twins.waits[id].position());
      });
  }
  for (std::size_t i = 0; i < ids.size(); ++i)
    for (const std::vector<Vec3d>& its : places) ASSERT_EQ(its[i], twins.steps[ids[i]].position()) << i;
  twins.run(200);
  EXPECT_LT(twins.waits.size(), ids.size() / 2);
  EXPECT_EQ(twins.waits.hash(), twins.steps.hash());
}

/// Whatever mode its thread is in.
TEST(WaitingRows, are_read_in_any_mode_of_the_processor) {
  WorldDef def;
  def.ground.mode = GroundMode::none;
  Twins twins(def);
  ProjectileDef p = bullet();
  p.fidelity = Fidelity::arcade();
  p.fidelity.motion = Motion::closed_form;
  p.fidelity.drag = DragModel::damping;
  std::vector<ProjectileId> ids;
  for (int i = 0; i < 100; ++i)
    twins.both([&](World& w) { ids.push_back(*w.spawn(p, {.velocity = Vec3d{700.0 + i / 3.0, 90, -3}})); });
  twins.run(100);
  std::fesetround(FE_UPWARD);
  std::vector<ProjectileId> all = twins.waits.ids();
  std::vector<BodyState> states(all.size());
  twins.waits.states(all, states);
  std::fesetround(FE_TONEAREST);
  for (std::size_t i = 0; i < all.size(); ++i) EXPECT_EQ(states[i], twins.steps[all[i]].state());
}

/// Who reads one of them brings its neighbours along, and nobody else.
TEST(WaitingRows, are_read_one_by_one_at_any_time) {
  WorldDef def;
  def.ground.mode = GroundMode::none;
  World waits = make_world(def), steps = make_world(def);
  ProjectileDef p = stone();
  p.fidelity.motion = Motion::closed_form;
  std::vector<ProjectileId> ids;
  for (int i = 0; i < 200; ++i) {
    const Launch launch{.position = {double(i), 1, 2}, .velocity = Vec3d{1.5 * i, 20, -3}};
    ids.push_back(*waits.spawn(p, launch));
    steps.spawn(p, launch);
  }
  std::mt19937 random(5);
  for (int i = 0; i < 3000; ++i) {
    const double dt = i % 700 == 699 ? 1.0 / 50 : 1.0 / 64;
    waits.step(dt);
    with_waiting(false, [&] { return steps.step(dt); });
    if (random() % 3 == 0) expect_equal_reads(waits, steps, ids[random() % ids.size()]);
  }
  EXPECT_EQ(waits.hash(), steps.hash());
}

}  // namespace world_waiting_rows_test
}  // namespace physim
