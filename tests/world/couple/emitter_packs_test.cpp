// What is done for many particles at a time, or on a way of its own, gives what each alone and settling give.
#include "random_emitters.hpp"
#include "world/emitter_support.hpp"

namespace physim::world_emitter_packs_test {

constexpr double kFrame = 1.0 / 64;
constexpr Precision kPrecisions[] = {Precision::float32, Precision::float64};

struct Seen {
  Vec3d position, previous, velocity;
  double age;
  bool operator==(const Seen&) const = default;
};
std::map<std::uint64_t, Seen> seen(const World& world, EmitterId id) {
  const std::size_t count = world.particles(id, {});
  std::vector<Vec3d> position(count), previous(count), velocity(count);
  std::vector<double> age(count);
  std::vector<std::uint64_t> number(count);
  world.particles(id, {.position = position, .previous = previous, .velocity = velocity, .age = age, .number = number});
  std::map<std::uint64_t, Seen> all;
  for (std::size_t i = 0; i < count; ++i) all[number[i]] = {position[i], previous[i], velocity[i], age[i]};
  return all;
}

Fidelity rung(DragModel drag, Precision precision) {
  Fidelity f = Fidelity::game();
  f.drag = drag;
  f.air = AirModel::isa;
  f.wind = WindModel::constant;
  f.precision = precision;
  return f;
}

struct Told {
  std::map<std::uint64_t, Seen> alive;
  std::vector<std::tuple<double, Vec3d, Vec3d>> ends;  // of lives
  std::uint64_t by_subs = 0;
  bool operator==(const Told&) const = default;
};
/// A second of a spray whose particles set off others at an age. Where apexes are told every row is settled.
Told second_of(const Fidelity& fidelity, bool settled, double wind, const ParticleFlight& flight = {}) {
  WorldDef def{.ground = {.mode = GroundMode::none}, .apex_events = settled};
  if (wind != 0) def.environment.wind.velocity = {wind, 0, 0};
  World world = make_world(def);
  ProjectileDef p = spark(Motion::force);
  p.drag = {.table = DragTable::g1, .ballistic_coefficient = 10, .damping = 0.7, .k1 = 1e-4, .k2 = 2e-5};
  p.fidelity = fidelity;
  const KindId kind = kind_of(world, p);
  EmitterDef small = spray(kind, 0, 0.03);
  small.flight = flight;
  small.cycle.plays = false;
  const EmitterId sub = added(world, small);
  EmitterDef spraying = spray(kind, 700, 0.3);
  spraying.flight = flight;
  spraying.start.lifetime = {0.002, 0.3};
  spraying.subs = {{.on = SubEvent::age, .emitter = sub, .age = 0.011}};
  const EmitterId id = added(world, spraying);
  std::vector<Event> events;
  step_to(world, 1, 64, &events);
  Told told{seen(world, id), {}, world.emitter_counts(sub).born};
  for (const Event& e : events)
    if (e.kind == EventKind::expired) told.ends.emplace_back(e.time, e.position, e.velocity);
  return told;
}

TEST(EmitterPacks, births_and_deaths_on_known_rungs_are_as_settled) {
  for (const DragModel drag : {DragModel::off, DragModel::damping, DragModel::linear_quadratic, DragModel::equation})
    for (const Precision precision : {Precision::float32, Precision::float64})
      for (const double wind : {0.0, 7.0}) {
        const Told known = second_of(rung(drag, precision), false, wind);
        EXPECT_GT(known.alive.size(), 60u);
        EXPECT_GT(known.ends.size(), 400u);
        EXPECT_GT(known.by_subs, 400u);
        EXPECT_EQ(known, second_of(rung(drag, precision), true, wind)) << static_cast<int>(drag) << ' ' << wind;
      }
}

TEST(EmitterPacks, births_and_deaths_on_other_rungs_of_one_stage_are_as_settled) {
  for (const DragModel drag : {DragModel::off, DragModel::damping, DragModel::linear_quadratic, DragModel::equation})
    for (const Integrator integrator : {Integrator::semi_implicit_euler, Integrator::explicit_euler})
      for (const GravityModel gravity : {GravityModel::constant, GravityModel::inverse_square})
        for (const Precision precision : kPrecisions) {
          Fidelity f = rung(drag, precision);
          f.integrator = integrator, f.gravity = gravity;
          const Told known = second_of(f, false, 7);
          EXPECT_GT(known.alive.size(), 60u);
          EXPECT_GT(known.ends.size(), 400u);
          EXPECT_GT(known.by_subs, 400u);
          EXPECT_EQ(known, second_of(f, true, 7)) << static_cast<int>(drag) << ' ' << static_cast<int>(integrator);
        }
}

TEST(EmitterPacks, births_and_deaths_of_what_emitters_push_are_as_settled) {
  test::Random r(5);
  for (int round = 0; round < 12; ++round) {
    ParticleFlight flight{.drag = {1, 4, {{0, 1}, {1, 0}}}};
    if (round % 2 == 1) flight = test::random_flight(r);
    const Fidelity fidelity = rung(static_cast<DragModel>(round % 4), kPrecisions[round / 4 % 2]);
    const Told known = second_of(fidelity, false, round % 3, flight);
    EXPECT_GT(known.alive.size(), 60u);
    EXPECT_GT(known.ends.size(), 400u);
    EXPECT_GT(known.by_subs, 400u);
    EXPECT_EQ(known, second_of(fidelity, true, round % 3, flight)) << round;
  }
}

TEST(EmitterPacks, births_and_deaths_of_closed_forms_are_as_settled) {
  for (const Precision precision : {Precision::float32, Precision::float64}) {
    Fidelity arcade = Fidelity::arcade();
    arcade.precision = precision;
    const Told known = second_of(arcade, false, 0);
    EXPECT_GT(known.alive.size(), 60u);
    EXPECT_GT(known.ends.size(), 400u);
    EXPECT_GT(known.by_subs, 400u);
    EXPECT_EQ(known, second_of(arcade, true, 0));
  }
}

/// Two emitters of one kind, each with a law of its own, in a world in which slots and rows change hands all the time.
class Churn : public ::testing::Test {
 protected:
  Churn() { ids_ = {add(0), add(1)}; }

  EmitterId add(int which) {
    EmitterDef def = spray(kind_, which == 0 ? 900 : 1700, 0.2);
    def.start.lifetime = {0.05, 0.4};
    if (which == 0)
      def.flight.drag = {1, 4, {{0, 1}, {1, 0}}};
    else
      def.flight.gravity = {0.2}, def.flight.force_x = {0.001, 0.003}, def.flight.limit = {5}, def.flight.noise = {2};
    return added(world_, def);
  }
  /// Steps, and looks whether all that stay go where predictions, which ask for each alone, say.
  void step() {
    const std::vector<ProjectileId> ids = world_.ids();
    std::vector<Flight> flights;
    for (const ProjectileId id : ids) flights.push_back(world_.predict(id, kFrame, kFrame));
    ASSERT_TRUE(world_.step(kFrame));
    for (std::size_t i = 0; i < ids.size(); ++i) {
      if (!world_[ids[i]].is_alive()) continue;
      ASSERT_EQ(world_[ids[i]].position(), flights[i].at(kFrame).position) << i << " of " << ids.size();
      ++compared_;
    }
  }
  void steps(int count) {
    for (int i = 0; i < count; ++i) step();
  }
  void despawn_some() {
    const auto ids = world_.ids();
    for (std::size_t i = 0; i < ids.size(); i += 3) world_[ids[i]].despawn();
  }

  World world_ = make_world({.ground = {.mode = GroundMode::none}});
  KindId kind_ = kind_of(world_, spark(Motion::force));
  std::vector<EmitterId> ids_;
  std::size_t compared_ = 0;
};

TEST_F(Churn, all_go_where_each_alone_would) {
  steps(12);
  despawn_some();
  steps(3);
  const Snapshot snapshot = world_.snapshot();
  steps(5);
  despawn_some();
  ASSERT_TRUE(world_.restore(snapshot));
  steps(3);
  ASSERT_TRUE(world_.remove_emitter(ids_[0]));  // its particles fly on, nobody's
  for (int i = 0; i < 40; ++i) world_.spawn(kind_, {.velocity = Vec3d{1, 2, 3}});
  steps(3);
  add(0);  // in the place of the one that went
  steps(6);
  world_ = reloaded(world_);
  steps(3);
  EXPECT_GT(compared_, 5000u);
}

TEST_F(Churn, a_generator_that_comes_and_goes_changes_nothing_else) {
  steps(5);
  const ForceId wind =
      *world_.add_force({.law = PointAttractor{{0, 50, 0}, 50, 2}, .target = ForceTarget::everything()});
  steps(4);
  despawn_some();
  ASSERT_TRUE(world_.remove_force(wind));
  steps(4);
  EXPECT_GT(compared_, 2000u);
}

TEST_F(Churn, those_that_share_a_slot_one_after_the_other_have_laws_of_their_own) {
  world_ = make_world({.ground = {.mode = GroundMode::none}});
  kind_ = kind_of(world_, spark(Motion::force));
  EmitterDef def = spray(kind_, 0, 9);
  def.flight.drag = {1, 30};
  const EmitterId id = added(world_, def);
  ASSERT_TRUE(world_.add_force({.law = PointAttractor{{0, 50, 0}, 50, 2}, .target = ForceTarget::everything()}));
  for (int i = 0; i < 20; ++i) {
    if (i % 4 == 3)
      world_.spawn(kind_, {.velocity = Vec3d{1, 2, 3}});  // nobody's
    else
      ASSERT_TRUE(world_.emit(id, 1));
    steps(2);
    EXPECT_EQ(world_.ids()[0].index, 1u);
    world_[world_.ids()[0]].despawn();
  }
  EXPECT_EQ(compared_, 40u);
}

}  // namespace physim::world_emitter_packs_test
