// Predictions: flights from where projectiles are, bit for bit what the world then does; and worlds that go on with
// what was on its way in a flight.
#include <map>

#include "world/random_session.hpp"
#include "world/world_support.hpp"

namespace physim::world_predict_test {

/// Drag in constant air by steps that are the world's frames.
Fidelity in_frames() {
  Fidelity f = Fidelity::constant_air();
  f.integrator = Integrator::rk4;
  return f;
}

using test::near;

constexpr double kStep = 1.0 / 60;

Until for_steps(int steps, std::optional<double> ground = 0.0) { return {.ground = ground, .time = steps * kStep}; }

bool leaves_out_springs(const Flight& flight) {
  return std::ranges::any_of(flight.fidelity_in_use().notes,
                             [](const FidelityNote& note) { return note.effect == "forces"; });
}

/// Steps the world and compares each projectile with its prediction, as far as that goes. How many places were equal.
int compare_steps(World& world, const std::map<ProjectileId, Flight>& flights, int steps) {
  int compared = 0;
  for (int i = 1; i <= steps; ++i) {
    world.step(kStep);
    for (const auto& [id, flight] : flights) {
      const double time = i * kStep;
      if (!world[id].is_alive() || world[id].is_asleep() || flight.duration() < time) continue;
      if (flight.outcome() != Outcome::time_limit && flight.duration() <= time) continue;
      const Sample sample = flight.at(time);
      EXPECT_EQ(sample.position, world[id].position()) << "step " << i << ", " << id.index;
      EXPECT_EQ(sample.velocity, world[id].velocity()) << "step " << i << ", " << id.index;
      if (testing::Test::HasFailure()) return compared;
      ++compared;
    }
  }
  return compared;
}

TEST(Predict, random_sessions_go_as_predicted_to_the_bit) {
  int compared = 0;
  for (unsigned seed = 1; seed <= 12; ++seed) {
    SCOPED_TRACE(seed);
    World world = make_world(test::session_world());
    test::RandomSession session(world, seed);
    session.meet_others = false;  // predictions see nobody else
    session.emitters = false;
    for (int part = 0; part < 6; ++part) {
      for (int i = 0; i < 150; ++i) session.act();
      world.set_detail({});
      const std::uint64_t before = world.hash();
      std::map<ProjectileId, Flight> flights;
      for (const ProjectileId id : world.ids()) {
        const Flight flight = world.predict(id, for_steps(12), kStep);
        if (flight.outcome() != Outcome::refused && !leaves_out_springs(flight)) flights.emplace(id, flight);
      }
      ASSERT_EQ(world.hash(), before) << "looking ahead changes nothing";
      compared += compare_steps(world, flights, 12);
      if (HasFailure()) return;
    }
  }
  EXPECT_GT(compared, 5000);
}

ProjectileDef rocket() {
  return {.mass = 2,
          .diameter = 0.1,
          .length = 1,
          .inertia = {.moments = {0.01, 0.2, 0.2}},
          .motor = {.thrust = {{0, 100}, {0.5, 300}, {1, 100}, {2, 0}}, .propellant_mass = 0.5}};
}

TEST(Predict, rockets_go_on_with_what_is_left_of_their_burn) {
  World world = make_world({.ground = {.mode = GroundMode::none}, .step = kStep});
  for (const double delay : {0.0, 0.35})
    for (const Fidelity& rung : {Fidelity::game(), in_frames(), Fidelity::simulation()}) {
      ProjectileDef p = rocket();
      p.motor.ignition_delay = delay;
      p.fidelity = rung;
      ASSERT_TRUE(world.spawn(p, {.speed = 1, .elevation = 1.4, .rail_length = 2}));
    }
  for (int part = 0; part < 12; ++part) {  // on the rail, under thrust, after burnout
    std::map<ProjectileId, Flight> flights;
    for (const ProjectileId id : world.ids()) {
      flights.emplace(id, world.predict(id, for_steps(150 - 12 * part, std::nullopt)));
      EXPECT_NEAR(flights.at(id).at(0).mass, world[id].mass(), 1e-12);
      EXPECT_TRUE(near(flights.at(id).accelerations(0).total, world[id].accelerations().total, 1e-12, 1e-12));
    }
    compare_steps(world, flights, 12);
    if (HasFailure()) return;
    for (const auto& [id, flight] : flights) {  // a clock in float32 counts frames of its own length
      const bool is_float = flight.fidelity_in_use().fidelity.precision == Precision::float32;
      EXPECT_NEAR(flight.at(12 * kStep).mass, world[id].mass(), is_float ? 1e-7 : 1e-12);
    }
  }
}

TEST(Predict, is_the_flight_of_what_was_just_launched) {
  for (const Fidelity& rung : {Fidelity::arcade(), Fidelity::game(), in_frames()}) {
    World world;
    ProjectileDef p = bullet();
    p.fidelity = rung;
    const Launch launch{.position = {0, 2, 0}, .speed = 300, .elevation = 0.1};
    const Flight predicted = world.predict(*world.spawn(p, launch), 60);
    const Flight flown = fly(p, launch, {}, rung, {.step = world.def().step});
    EXPECT_EQ(predicted.outcome(), Outcome::landed);
    EXPECT_TRUE(near(predicted.duration(), flown.duration(), 1e-6));
    EXPECT_TRUE(near(predicted.end().position, flown.end().position, 1e-5));
    EXPECT_TRUE(near(predicted.end().range, flown.end().range, 1e-5));
  }
}

TEST(Predict, sees_generators_that_come_and_go) {
  World world = make_world({.ground = {.mode = GroundMode::none}, .step = kStep});
  ProjectileDef p = stone();
  p.mass = 2;
  const ProjectileId id = *world.spawn(p, {.speed = 10, .elevation = 0.5});
  world.add_force({.law = ConstantForce{{0, 0, 6}}, .target = ForceTarget::everything(), .delay = 0.5, .duration = 1});
  world.add_force({.law = AnchoredSpring{{0, 5, 0}, 3, 0, 0.1}, .target = {.ids = {id}}});
  const Flight flight = world.predict(id, for_steps(120, std::nullopt));
  const double drift = 0.5 * 3 * 1 + 3 * 1 * 0.5;  // 3 m/s^2 for 1 s, then on; the spring pulls it back a little
  EXPECT_GT(flight.at(2).position.z, 0.1 * drift);
  EXPECT_NEAR(flight.accelerations(0).applied.y, world[id].accelerations().applied.y, 1e-12);
  EXPECT_EQ(compare_steps(world, {{id, flight}}, 120), 120);
  EXPECT_TRUE(near(flight.at(2).acceleration, world[id].accelerations().total, 1e-9, 1e-9));
}

TEST(Predict, springs_to_others_are_told_to_be_missing) {
  World world;
  const ProjectileId a = *world.spawn(stone(), {.position = {0, 50, 0}}), b = *world.spawn(stone(), {});
  EXPECT_FALSE(leaves_out_springs(world.predict(a, 1)));
  world.add_force({.law = Spring{b, 10, 1, 0}, .target = {.ids = {a}}});
  EXPECT_TRUE(leaves_out_springs(world.predict(a, 1)));
  EXPECT_TRUE(leaves_out_springs(world.predict(b, 1)));
}

TEST(Predict, other_steps_and_long_frames_of_bouncing_worlds) {
  WorldDef def = test::session_world();
  def.detail = {};
  World world = make_world(def);
  std::map<ProjectileId, Flight> flights;
  for (const char* preset : {"arcade", "game", "constant_air", "small_arms"}) {
    ProjectileDef p = bullet();
    p.fidelity = *fidelity_preset(preset);
    ASSERT_TRUE(world.spawn(p, {.position = {0, 90, 0}, .speed = 90, .elevation = 0.7}));
  }
  for (int i = 0; i < 7; ++i) world.step(kStep);
  for (const double step : {0.011, 0.25}) {  // 0.25: flown in parts
    for (const ProjectileId id : world.ids()) {
      const Flight flight = world.predict(id, for_steps(60), step);
      flights.insert_or_assign(id, flight);
    }
    for (int i = 1; i <= 3; ++i) {
      world.step(step);
      for (const auto& [id, flight] : flights) EXPECT_EQ(flight.at(i * step).position, world[id].position()) << step;
    }
  }
}

TEST(Predict, many_at_once_end_as_one_by_one) {
  World world;
  std::vector<ProjectileId> ids;
  for (int i = 0; i < 50; ++i) ids.push_back(*world.spawn(bullet(), {.position = {0, 1, 0}, .speed = 50.0 + i}));
  for (int i = 0; i < 9; ++i) world.step(kStep);
  ids.push_back({});
  std::vector<ShotResult> ends(ids.size());
  EXPECT_EQ(world.predict(ids, Until{}, ends), 50u);
  for (std::size_t i = 0; i < 50; ++i) {
    const Flight alone = world.predict(ids[i], Until{});
    EXPECT_EQ(ends[i].outcome, Outcome::landed);
    EXPECT_EQ(ends[i].time, alone.duration());
    EXPECT_EQ(ends[i].position, alone.end().position);
  }
  EXPECT_EQ(ends.back().outcome, Outcome::refused);
}

TEST(Predict, ranges_and_events_count_from_where_it_is) {
  World world;
  ProjectileDef p = bullet();
  for (const Fidelity& rung : {Fidelity::arcade(), in_frames()}) {
    p.fidelity = rung;
    const ProjectileId id = *world.spawn(p, {.position = {0, 20, 0}, .speed = 100});
    for (int i = 0; i < 12; ++i) world.step(kStep);
    const Flight flight = world.predict(id, {.range = 40, .events = {{.kind = EventKind::range, .value = 25}}});
    EXPECT_EQ(flight.outcome(), Outcome::reached_range);
    EXPECT_NEAR(flight.end().range, 40, 1e-5) << "float32";
    EXPECT_NEAR(flight.end().position.x - world[id].position().x, 40, 1e-5);
    ASSERT_EQ(flight.events().size(), 2u);
    EXPECT_NEAR(flight.events()[0].value, 25, 1e-12);
    EXPECT_NEAR(flight.at(flight.events()[0].time).range, 25, 1e-5);
  }
}

TEST(Predict, refuses_what_has_no_flight) {
  World world = make_world({.ground = {.mode = GroundMode::none}});
  const auto place = [&](ProjectileId id, const Until& until = {}, double step = 0) {
    const Flight flight = world.predict(id, until, step);
    EXPECT_EQ(flight.outcome(), Outcome::refused);
    return flight.error() ? flight.error()->place : "";
  };
  const ProjectileId flying = *world.spawn(stone(), {.position = {0, 9, 0}});
  EXPECT_EQ(place({}), "id");
  EXPECT_EQ(place(*world.spawn(stone(), {}, {}, 5.0)), "id");
  EXPECT_EQ(place(*world.spawn(stone(), {}, {.kinematic = true})), "id");
  EXPECT_EQ(place(flying, {}, -1), "step");
  EXPECT_EQ(place(flying, {}, NAN), "step");
  Until bad{.time = NAN};
  EXPECT_EQ(place(flying, bad), "until.time");
  Until by_time{.events = {{.kind = EventKind::time, .value = 1}}};
  EXPECT_EQ(place(flying, by_time), "until.events");
  world[flying].sleep();
  EXPECT_EQ(place(flying), "id");
  world[flying].wake();
  world[flying].despawn();
  EXPECT_EQ(place(flying), "id");
  EXPECT_EQ(World().predict(flying, 1).outcome(), Outcome::refused);
}

// ------------------------------------------------------------------------------------------- from flights
TEST(SpawnFlight, goes_on_as_the_flight_does) {
  WorldDef def{.step = kStep};
  Tolerance fixed{.step = kStep};
  ProjectileDef ball = bullet();
  ball.diameter = 0.04;
  ball.mass = 0.05;
  ball.magnus.lift = 0.2;
  ProjectileDef shell = bullet();
  shell.length = 0.03;
  shell.twist = 0.3;
  shell.inertia.moments = {7e-8, 6e-7, 6e-7};
  Fidelity game = Fidelity::game();
  game.precision = Precision::float64;  // in float32 a flight's steps have another length than 1/60 s
  Fidelity magnus = in_frames();
  magnus.rotation = RotationModel::magnus;
  Fidelity rigid = Fidelity::simulation();
  rigid.rotation = RotationModel::rigid_body;
  rigid.integrator = Integrator::rk4;
  const std::pair<ProjectileDef, Fidelity> cases[] = {
      {bullet(), game}, {ball, magnus}, {rocket(), in_frames()}, {shell, rigid}};
  for (const auto& [p, rung] : cases) {
    SCOPED_TRACE(name(rung.rotation));
    const Launch launch{
        .position = {0, 5, 0}, .speed = 70, .elevation = 0.6, .spin = {.backspin = 300, .sidespin = 40}};
    const double step = rung.rotation == RotationModel::rigid_body ? 1e-4 : kStep;
    fixed.step = def.step = step;
    const Flight flight = fly(p, launch, {}, rung, fixed);
    ASSERT_EQ(flight.outcome(), Outcome::landed);
    const double start = 30 * step;
    World world = make_world(def);
    const auto id = must(world.spawn(flight, start));
    EXPECT_EQ(world[id].fidelity_in_use().fidelity.rotation, flight.fidelity_in_use().fidelity.rotation);
    EXPECT_NEAR(world[id].age(), start, 1e-12);
    for (int i = 1; i <= 60; ++i) {
      world.step(step);
      const Sample there = flight.at(start + i * step);
      ASSERT_TRUE(near(world[id].position(), there.position, 1e-12, 1e-10)) << i;
      ASSERT_NEAR(world[id].mass(), there.mass, 1e-12) << i;
    }
  }
}

TEST(SpawnFlight, and_back_again) {
  World world;
  const ProjectileId id = *world.spawn(bullet(), {.position = {0, 5, 0}, .speed = 200, .elevation = 0.2});
  for (int i = 0; i < 20; ++i) world.step(kStep);
  const Flight flight = world.predict(id, 60, kStep);
  World other;
  const auto there = must(other.spawn(flight, 0));
  for (int i = 0; i < 30; ++i) {
    world.step(kStep), other.step(kStep);
    ASSERT_EQ(world[id].position(), other[there].position());
  }
}

TEST(SpawnFlight, is_recorded) {
  std::vector<std::byte> bytes;
  World world;
  ASSERT_TRUE(world.record([&](std::span<const std::byte> part) {
    bytes.insert(bytes.end(), part.begin(), part.end());
    return Status{};
  }));
  ProjectileDef p = rocket();
  p.fidelity = in_frames();
  const Flight flight = fly(p, {.speed = 20, .elevation = 1.2});
  ASSERT_TRUE(world.spawn(flight, 0.7));
  EXPECT_FALSE(world.spawn_departed(p, Departure{.age = -1}));
  for (int i = 0; i < 40; ++i) world.step(kStep);
  ASSERT_TRUE(world.stop_recording());
  auto again = must(Replay::open(bytes));
  while (again.next()) {
  }
  EXPECT_EQ(again.world().hash(), world.hash());
}

TEST(SpawnFlight, refuses_what_is_not_on_its_way) {
  World world;
  ProjectileDef p = rocket();
  p.fidelity = in_frames();
  const Flight flight = fly(p, {.elevation = 1.2, .rail_length = 3});
  const auto place = [&](const Result<ProjectileId>& id) { return id ? "" : id.error().place; };
  EXPECT_EQ(place(world.spawn(flight, 0.01)), "time") << "on its rail";
  EXPECT_EQ(place(world.spawn(flight, -1)), "time");
  EXPECT_EQ(place(world.spawn(flight, NAN)), "time");
  EXPECT_EQ(place(world.spawn(flight, 1e9)), "time");
  EXPECT_NE(place(world.spawn(fly(p, {.speed = NAN}), 0)), "");
  EXPECT_EQ(place(world.spawn_departed(p, Departure{.position = {NAN, 0, 0}})), "departure.position");
  EXPECT_EQ(place(world.spawn_departed(p, Departure{.age = -1})), "departure.age");
  EXPECT_EQ(place(world.spawn_departed(p, Departure{.attitude = FlownAttitude{.orientation = {2, 0, 0, 0}}})),
            "departure.attitude.orientation");
  EXPECT_EQ(world.size(), 0u);
  EXPECT_EQ(world.counters().refused, 3u);
}

}  // namespace physim::world_predict_test
