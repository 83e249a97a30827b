// Trails of particles, and emitters that seek a time: against closed forms and against waiting.
#include "scene_support.hpp"
#include "world/emitter_support.hpp"

namespace physim::world_emitter_trail_test {

World airless() { return make_world({.ground = {.mode = GroundMode::none}}); }

struct Trail {
  ProjectileId id;
  std::vector<Vec3d> position;
  std::vector<double> time;
};
std::vector<Trail> trails_of(const World& world, EmitterId emitter) {
  const TrailCounts counts = world.trails(emitter, {});
  std::vector<ProjectileId> id(counts.particles);
  std::vector<std::uint32_t> first(counts.particles), count(counts.particles);
  std::vector<Vec3d> position(counts.places);
  std::vector<double> time(counts.places);
  world.trails(emitter, {.id = id, .first = first, .count = count, .position = position, .time = time});
  std::vector<Trail> all;
  for (std::size_t i = 0; i < id.size(); ++i) {
    const auto at = [&](const auto& list) { return list.begin() + first[i]; };
    all.push_back({id[i], {at(position), at(position) + count[i]}, {at(time), at(time) + count[i]}});
  }
  return all;
}

/// Sparks that fly straight at 10 m/s.
EmitterDef straight(KindId kind, const TrailDef& trail) {
  return {.kind = kind, .per_second = {20}, .start = {.lifetime = {2}, .speed = {10}, .gravity = {0}}, .trail = trail};
}

TEST(EmitterTrail, tells_where_each_particle_has_been) {
  World world = airless();
  const EmitterId id = added(world, straight(kind_of(world, spark()), {.points = 1000}));
  step_to(world, 1.5, 50);
  const auto trails = trails_of(world, id);
  const auto all = alive(world, id);
  ASSERT_EQ(trails.size(), all.size());
  for (const Trail& trail : trails) {
    const Projectile p = world[trail.id];
    EXPECT_EQ(trail.position.front(), Vec3d{});  // where it was born
    EXPECT_EQ(trail.position.back(), p.position());
    EXPECT_NEAR(trail.time.back(), world.time(), 1e-12);
    for (std::size_t i = 0; i < trail.time.size(); ++i) {
      EXPECT_NEAR(trail.position[i].x, 10 * (trail.time[i] - trail.time.front()), 1e-9);
      EXPECT_TRUE(i == 0 || trail.time[i] > trail.time[i - 1]);
    }
    EXPECT_NEAR(double(trail.time.size()), 50 * (world.time() - trail.time.front()) + 1.5, 1.01);
  }
}

TEST(EmitterTrail, the_oldest_places_go_first) {
  World world = airless();
  const EmitterId id = added(world, straight(kind_of(world, spark()), {.points = 6}));
  step_to(world, 1.5, 50);
  for (const Trail& trail : trails_of(world, id)) {
    EXPECT_LE(trail.time.size(), 6u);
    const double flown = world.time() - trail.time.front();
    EXPECT_NEAR(trail.position.back().x - trail.position[0].x, std::min(10 * flown, 1.0), 1e-9);
  }
}

TEST(EmitterTrail, places_have_a_distance_and_an_age) {
  World world = airless();
  const KindId kind = kind_of(world, spark());
  const EmitterId far = added(world, straight(kind, {.points = 100, .distance = 1.05}));
  const EmitterId young = added(world, straight(kind, {.points = 100, .time = 0.25}));
  step_to(world, 1.5, 50);
  for (const Trail& trail : trails_of(world, far))
    for (std::size_t i = 1; i + 1 < trail.position.size(); ++i) {
      const double apart = trail.position[i].x - trail.position[i - 1].x;
      EXPECT_TRUE(apart >= 1.05 - 1e-9 && apart < 1.3) << apart;  // the first step that is far enough
    }
  std::size_t most = 0;
  for (const Trail& trail : trails_of(world, young)) {
    EXPECT_GE(trail.time.front(), world.time() - 0.25 - 1e-9);
    most = std::max(most, trail.time.size());
  }
  EXPECT_NEAR(double(most), 13, 1);
}

TEST(EmitterTrail, goes_with_its_particle_and_nobody_pays_who_asks_for_none) {
  World world = airless();
  const KindId kind = kind_of(world, spark());
  EmitterDef def = straight(kind, {.points = 50});
  def.start.lifetime = {0.1, 0.4};
  const EmitterId id = added(world, def), none = added(world, straight(kind, {}));
  for (int i = 0; i < 500; ++i) {
    ASSERT_TRUE(world.step(0.02));
    for (const Trail& trail : trails_of(world, id)) {
      // Slots are used again: none has the places of one before.
      EXPECT_LE(world.time() - trail.time.front(), 0.42);
      EXPECT_NEAR(trail.position.back().x, 10 * (world.time() - trail.time.front()), 1e-9);
    }
  }
  const TrailCounts nothing = world.trails(none, {});
  EXPECT_TRUE(nothing.particles == 0 && nothing.places == 0);
  const TrailCounts gone = world.trails({}, {});
  EXPECT_TRUE(gone.particles == 0 && gone.places == 0);
}

TEST(EmitterTrail, shorter_columns_get_what_comes_first) {
  World world = airless();
  const EmitterId id = added(world, straight(kind_of(world, spark()), {.points = 9}));
  step_to(world, 1, 50);
  std::vector<Vec3d> few(5), all(world.trails(id, {}).places);
  world.trails(id, {.position = all});
  world.trails(id, {.position = few});
  EXPECT_TRUE(std::ranges::equal(few, std::span(all).first(5)));
}

TEST(EmitterTrail, belongs_to_snapshots_and_saves_but_not_to_the_hash) {
  const auto show = [](std::uint32_t points) {
    World world = airless();
    EmitterDef def = straight(kind_of(world, spark()), {.points = points});
    def.start.lifetime = {0.3, 1};
    added(world, def);
    return world;
  };
  World world = show(20);
  const EmitterId id = world.emitters()[0];
  step_to(world, 1, 50);
  const Snapshot snapshot = world.snapshot();
  auto loaded = reloaded(world);
  const auto same = [id](const World& a, const World& b) {
    const auto one = trails_of(a, id), other = trails_of(b, id);
    ASSERT_EQ(one.size(), other.size());
    for (std::size_t i = 0; i < one.size(); ++i)
      EXPECT_TRUE(one[i].position == other[i].position && one[i].time == other[i].time) << i;
  };
  same(world, loaded);
  step_to(world, 1.6, 50);
  step_to(loaded, 1.6, 50);
  same(world, loaded);
  EXPECT_EQ(world.save().value(), loaded.save().value());
  // One that leaves by a call between two steps takes its trail along.
  const ProjectileId gone = trails_of(world, id)[0].id;
  for (World* each : {&world, &loaded}) {
    ASSERT_TRUE((*each)[gone].despawn());
    ASSERT_TRUE(World::load(each->save().value()));
  }
  same(world, loaded);
  ASSERT_TRUE(world.restore(snapshot));
  step_to(world, 1.6, 50);
  ASSERT_TRUE(world[gone].despawn());
  same(world, loaded);
}

TEST(EmitterTrail, what_makes_no_sense_is_refused) {
  World world = airless();
  const KindId kind = kind_of(world, spark());
  const auto place = [&](const TrailDef& trail) { return world.add_emitter(straight(kind, trail)).error().place; };
  EXPECT_EQ(place({.points = 2'000'000}), "emitter.trail.points");
  EXPECT_EQ(place({.points = 2, .time = 0}), "emitter.trail.time");
  EXPECT_EQ(place({.points = 2, .distance = -1}), "emitter.trail.distance");
}

// ------------------------------------------------------------------------------------------------- seeking
/// Everything that fires by itself, drawn in all ways.
EmitterDef many_ways(KindId kind) {
  EmitterDef def = spray(kind, 40, 1.5);
  def.seed.reset();
  def.cycle = {.duration = 2, .delay = {0.3, 0.6}};
  def.per_second = {20, 60, {{0, 1}, {1, 0.2}}};
  def.bursts = {{.time = 0.4, .count = {5, 20}, .cycles = 3, .interval = 0.3, .probability = 0.6}};
  def.gun = {.rounds_per_minute = 300, .burst_rounds = 4, .burst_pause = 0.7, .dispersion = 0.05};
  def.start.lifetime = {0.5, 2};
  return def;
}

void expect_alike(const World& one, const World& other, EmitterId id) {
  const auto a = alive(one, id), b = alive(other, id);
  ASSERT_EQ(a.size(), b.size());
  for (const auto& [number, at] : a) {
    ASSERT_EQ(b.count(number), 1u) << number;
    EXPECT_TRUE(test::near(at.position, b.at(number).position, 1e-9, 1e-9)) << number;
  }
}

TEST(EmitterSeek, gives_what_waiting_gives) {
  for (const double time : {0.2, 0.9, 7.3, 1234.5}) {
    World waits = airless(), seeks = airless();
    const EmitterId id = added(waits, many_ways(kind_of(waits, spark())));
    added(seeks, many_ways(kind_of(seeks, spark())));
    if (time < 100) step_to(waits, time, 0);
    ASSERT_TRUE(seeks.seek_emitter(id, time));
    if (time < 100) expect_alike(waits, seeks, id);
    // It goes on as the other one does.
    if (time < 100) step_to(waits, time + 1, 0);
    step_to(seeks, 1, 0);
    if (time < 100) expect_alike(waits, seeks, id);
    EXPECT_GT(seeks.particles(id, {}), time < 0.3 ? 10u : 30u);
  }
}

TEST(EmitterSeek, goes_back_and_forth) {
  World waits = airless(), seeks = airless();
  const EmitterId id = added(waits, many_ways(kind_of(waits, spark())));
  added(seeks, many_ways(kind_of(seeks, spark())));
  step_to(waits, 3, 0);
  step_to(seeks, 1.7, 60);
  for (const double time : {9.0, 0.1, 3.0}) ASSERT_TRUE(seeks.seek_emitter(id, time));
  expect_alike(waits, seeks, id);
  EXPECT_EQ(seeks.emitter_counts(id).alive, seeks.particles(id, {}));
}

TEST(EmitterSeek, a_second_play_is_found_again) {
  World waits = airless(), seeks = airless();
  const EmitterId id = added(waits, many_ways(kind_of(waits, spark())));
  added(seeks, many_ways(kind_of(seeks, spark())));
  for (World* world : {&waits, &seeks}) {
    step_to(*world, 1, 60);
    ASSERT_TRUE(world->play_emitter(id));
  }
  step_to(waits, 5, 60);
  step_to(seeks, 1.3, 60);
  ASSERT_TRUE(seeks.seek_emitter(id, 4));
  // Those of the first play are gone by now in one, and were taken in the other one.
  expect_alike(waits, seeks, id);
}

TEST(EmitterSeek, what_is_over_plays_no_more) {
  World world = airless();
  EmitterDef def = spray(kind_of(world, spark()), 50, 0.5);
  def.cycle = {.duration = 1, .looping = false};
  const EmitterId id = added(world, def);
  ASSERT_TRUE(world.seek_emitter(id, 0.5));
  EXPECT_TRUE(world.is_playing(id));
  EXPECT_EQ(world.particles(id, {}), 25u);
  ASSERT_TRUE(world.seek_emitter(id, 1.25));
  EXPECT_FALSE(world.is_playing(id));
  EXPECT_EQ(world.particles(id, {}), 13u);  // those born at 0.76 s and later
  ASSERT_TRUE(world.seek_emitter(id, 0.25));
  EXPECT_TRUE(world.is_playing(id));
  step_to(world, 1, 60);
  EXPECT_FALSE(world.is_playing(id));
}

TEST(EmitterSeek, sub_emitters_fire_in_the_past) {
  World waits = airless(), seeks = airless();
  for (World* world : {&waits, &seeks}) {
    const KindId kind = kind_of(*world, spark());
    EmitterDef sparks = spray(kind, 0, 0.4);
    sparks.cycle.plays = false;
    const EmitterId stars = added(*world, sparks);
    EmitterDef shells = spray(kind, 3, 1);
    shells.subs = {{.on = SubEvent::death, .emitter = stars, .count = {7}, .inherit_velocity = 1}};
    added(*world, shells);
  }
  step_to(waits, 2.9, 60);
  ASSERT_TRUE(seeks.seek_emitter(seeks.emitters()[1], 2.9));
  for (const EmitterId id : waits.emitters()) expect_alike(waits, seeks, id);
}

TEST(EmitterSeek, stepped_flights_come_as_near_as_their_rung) {
  World waits = make_world({.ground = {.mode = GroundMode::land}, .step = 1.0 / 240}), seeks = make_world(waits.def());
  ProjectileDef drop = spark(Motion::force, Integrator::rk4);
  const EmitterId id = added(waits, spray(kind_of(waits, drop), 100, 3));
  added(seeks, spray(kind_of(seeks, drop), 100, 3));
  for (int i = 0; i < 1000; ++i) waits.single_step();
  ASSERT_TRUE(seeks.seek_emitter(id, waits.time()));
  const auto a = alive(waits, id), b = alive(seeks, id);
  ASSERT_EQ(a.size(), b.size());
  for (const auto& [number, at] : a) EXPECT_TRUE(test::near(at.position, b.at(number).position, 1e-6, 1e-6));
}

TEST(EmitterSeek, is_recorded_and_saved) {
  std::vector<std::byte> bytes;
  World world = airless();
  ASSERT_TRUE(world.record(record_into(bytes), {.hash_every = 1}));
  const EmitterId id = added(world, many_ways(kind_of(world, spark())));
  step_to(world, 0.5, 60);
  ASSERT_TRUE(world.play_emitter(id));
  ASSERT_TRUE(world.seek_emitter(id, 5));
  auto loaded = reloaded(world);
  for (World* each : {&world, &loaded}) {
    step_to(*each, 0.8, 60);
    ASSERT_TRUE(each->seek_emitter(id, 1));
    step_to(*each, 1, 60);
  }
  EXPECT_EQ(loaded.hash(), world.hash());
  replayed(world, bytes);
}

TEST(EmitterSeek, times_that_are_none_are_refused) {
  World world = airless();
  const EmitterId id = added(world, spray(kind_of(world, spark()), 10, 1));
  for (const double time : {-1.0, std::nan(""), kInfinity, 2e9})
    EXPECT_EQ(world.seek_emitter(id, time).error().place, "time") << time;
  EXPECT_EQ(world.seek_emitter({}, 1).error().place, "emitter");
}

}  // namespace physim::world_emitter_trail_test
