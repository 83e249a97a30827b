// Recordings: what was done is done again, bit for bit; what is broken is refused or told.
#include "world/world_support.hpp"

#include <map>
#include <set>

#include "physim/scenario.hpp"
#include "world/random_session.hpp"
#include "world/recording_bytes.hpp"

namespace physim::world_recording_test {

using test::Bytes;
using test::Places;
using test::places_of;
using test::sign;

World made(const WorldDef& def) { return std::move(World::create(def).value()); }

/// The function of every custom force of random sessions.
ReplayOptions with_functions(std::size_t count = 1000) {
  ReplayOptions options;
  options.custom_forces.assign(count, {[](const ForceBatch& b) {
                                 for (std::size_t i = 0; i < b.id.size(); ++i) b.force[i].y += b.mass[i] * 3;
                               }});
  return options;
}

/// `all`: with what sessions have only where they are asked for it.
Bytes random_recording(unsigned seed, int calls, std::uint64_t* hash = nullptr, bool all = false) {
  Bytes bytes;
  World world = made(test::session_world());
  EXPECT_TRUE(world.record(record_into(bytes)));
  test::RandomSession session(world, seed);
  session.joints = session.asks = all;
  for (int i = 0; i < calls; ++i) session.act();
  if (hash) *hash = world.hash();
  EXPECT_TRUE(world.is_recording());
  EXPECT_TRUE(world.stop_recording());
  return bytes;
}

/// The small recording that tests of damage share: a few calls of each kind of frame.
Bytes small_recording() {
  Bytes bytes;
  World world = made({});
  EXPECT_TRUE(world.record(record_into(bytes)));
  const ProjectileId id = *world.spawn(ProjectileDef{.name = "ball"}, Launch{.position = {0, 2, 0}, .speed = 10});
  world[id].set_colour(0xff0000ff);
  const Snapshot start = world.snapshot();
  world.advance(0.04);
  world.restore(start);
  world[id].set_velocity({3, 3, 0});
  world.step(0.02);
  EXPECT_TRUE(world.stop_recording());
  return bytes;
}

// ------------------------------------------------------------------------------------------------------ it agrees
TEST(Recording, random_sessions_replay_with_equal_hashes) {
  for (unsigned seed = 1; seed <= 12; ++seed) {
    std::uint64_t hash = 0;
    const Bytes bytes = random_recording(seed, 3000, &hash);
    Replay player = must(Replay::open(bytes, with_functions()));
    while (player.next()) continue;
    const ReplayReport& report = player.report();
    ASSERT_FALSE(report.difference) << "seed " << seed << ": " << report.difference->call << " in step "
                                    << report.difference->step << ": " << report.difference->what;
    EXPECT_TRUE(report.complete);
    EXPECT_EQ(report.bytes, bytes.size());
    EXPECT_EQ(report.made_by, kVersion);
    EXPECT_GT(report.calls, 2500u);
    EXPECT_GT(report.steps, 200u);
    EXPECT_EQ(report.hashes, report.steps);
    EXPECT_GT(report.restores, 5u);
    EXPECT_EQ(player.world().hash(), hash);
  }
}

TEST(Recording, the_list_of_calls_is_complete) {
  std::set<Call> seen;
  for (unsigned seed = 1; seed <= 12; ++seed)
    for (const Call call : places_of(random_recording(seed, 3000, nullptr, true)).call) seen.insert(call);
  for (std::size_t i = 0; i < kCalls; ++i)
    EXPECT_TRUE(seen.contains(static_cast<Call>(i))) << name(static_cast<Call>(i)) << " was never recorded";
}

TEST(Recording, replays_on_every_kernel_and_number_of_threads) {
  const Bytes bytes = random_recording(77, 2000);
  for (const std::string& kernel : kernels()) {
    ASSERT_TRUE(use_kernel(kernel));
    for (const unsigned threads : {1u, 2u, 7u}) {
      ReplayOptions options = with_functions();
      options.threading = {threads, 1};  // one row is enough for a thread
      const auto report = must(replay(bytes, options));
      EXPECT_FALSE(report.difference) << kernel << " " << threads << ": " << report.difference->call << " "
                                      << report.difference->what;
    }
  }
  use_kernel(kernels().front());
}

TEST(Recording, recording_changes_nothing) {
  std::uint64_t recorded = 0;
  random_recording(5, 1500, &recorded);
  World world = made(test::session_world());
  test::RandomSession session(world, 5);
  for (int i = 0; i < 1500; ++i) session.act();
  EXPECT_EQ(world.hash(), recorded);
}

TEST(Recording, a_replay_is_looked_at_frame_by_frame) {
  Replay player = std::move(Replay::open(small_recording()).value());
  std::vector<double> times;
  std::vector<std::size_t> hashes;
  while (player.next_frame()) times.push_back(player.world().time()), hashes.push_back(player.hashes().size());
  EXPECT_EQ(times, (std::vector<double>{2.0 / 60, 0.02}));
  EXPECT_EQ(hashes, (std::vector<std::size_t>{2, 1}));
  EXPECT_EQ(player.report().spawned, 1u);
  EXPECT_EQ(player.report().steps, 3u);
  EXPECT_FALSE(player.next());
  EXPECT_FALSE(player.report().difference);
}

/// Hashes behind each call that took steps, by steps, and those of random seeks in between, which must be them.
void expect_seeks_to_same_worlds(const Bytes& bytes, unsigned seed) {
  Replay straight = std::move(Replay::open(bytes, with_functions()).value());
  std::map<std::uint64_t, std::uint64_t> hashes{{0, straight.world().hash()}};
  while (straight.next_frame()) hashes[straight.report().steps] = straight.world().hash();
  const std::uint64_t last = hashes.rbegin()->first;
  Replay player = std::move(Replay::open(bytes, with_functions()).value());
  std::mt19937 random(seed);
  for (int i = 0; i < 25; ++i) {
    const std::uint64_t steps = random() % (last + 1);
    ASSERT_TRUE(player.seek(steps)) << steps;
    const auto expected = hashes.lower_bound(steps);  // behind the call that took it
    EXPECT_EQ(player.report().steps, expected->first);
    ASSERT_EQ(player.world().hash(), expected->second) << "seed " << seed << ", step " << steps;
  }
  ASSERT_TRUE(player.seek(0));
  EXPECT_EQ(player.report().calls, 0u);
  EXPECT_EQ(player.world().hash(), hashes[0]);
  EXPECT_FALSE(player.seek(last + 1));
  EXPECT_TRUE(player.report().complete);
  EXPECT_FALSE(player.report().difference);
  EXPECT_EQ(player.report().calls, straight.report().calls);
  EXPECT_EQ(player.report().hashes, straight.report().hashes);
  EXPECT_EQ(player.world().hash(), straight.world().hash());
}

TEST(Recording, seeks_back_and_forwards_to_the_same_worlds) {
  // With functions and snapshots, which are played again from the beginning.
  for (unsigned seed = 1; seed <= 3; ++seed) expect_seeks_to_same_worlds(random_recording(seed, 800), seed);
  expect_seeks_to_same_worlds(small_recording(), 1);
  // Without, from worlds that were kept on the way: kinds, forces and a scene come late.
  Bytes bytes;
  World world = made({.ground = {.mode = GroundMode::bounce}});
  ASSERT_TRUE(world.record(record_into(bytes)));
  for (int i = 0; i < 700; ++i) {
    if (i % 100 == 50) {
      Scene scene = world.scene() ? *world.scene() : Scene();
      const ShapeId box = scene.add_shape(BoxShape{{0.2, 3, 3}}).value();
      ASSERT_TRUE(scene.add({.shape = box, .transform = {.position = {10.0 + i / 50.0, 3, 0}}}));
      ASSERT_TRUE(world.set_scene(scene));
      const auto lift = world.add_force({.law = ConstantForce{.force = {0, 0.1 + 0.01 * i, 0}},
                                         .target = ForceTarget::everything(),
                                         .duration = 0.3});
      ASSERT_TRUE(lift) << lift.error().text();
    }
    BodyDef body{.collision = {.on_hit = OnHit::bounce}, .despawn = {.older = 1.0 + i % 3}};
    ProjectileDef p{.mass = 1.0 + i % 5};
    if (i % 7 == 0) world.spawn(world.add_kind(p, body).value(), Launch{.speed = 40.0 + i % 10, .elevation = 0.2});
    world.step(1.0 / 60);
  }
  ASSERT_TRUE(world.stop_recording());
  for (unsigned seed = 1; seed <= 3; ++seed) expect_seeks_to_same_worlds(bytes, seed);
}

TEST(Recording, hashes_may_be_rare_or_none) {
  for (const std::uint32_t every : {0u, 1u, 7u}) {
    Bytes bytes;
    World world = made({});
    ASSERT_TRUE(world.record(record_into(bytes), {every}));
    world.spawn(ProjectileDef{}, Launch{.position = {0, 90, 0}});
    for (int i = 0; i < 70; ++i) world.step(0.01);
    const ReplayReport report = replayed(world, bytes);
    EXPECT_EQ(report.steps, 70u);
    EXPECT_EQ(report.hashes, every == 0 ? 0u : 70u / every);
  }
}

TEST(Recording, a_difference_is_told_with_its_step_and_hashes) {
  Bytes bytes = small_recording();
  const Places places = places_of(bytes);
  const auto at = [&](Call call) {
    return places.frame[static_cast<std::size_t>(std::ranges::find(places.call, call) - places.call.begin())];
  };
  // Another velocity than the one that was played.
  bytes[at(Call::set_velocity) + kFrameHead + 8] ^= std::byte{1};
  sign(bytes);
  const auto report = must(replay(bytes));
  ASSERT_TRUE(report.difference);
  EXPECT_EQ(report.difference->step, 3u);
  EXPECT_EQ(report.difference->time, 0.02);
  EXPECT_EQ(report.difference->call, "step");
  EXPECT_GT(report.difference->place, at(Call::set_velocity)) << "where in the recording";
  EXPECT_LT(report.difference->place, bytes.size());
  EXPECT_NE(std::ranges::find(places.frame, report.difference->place), places.frame.end()) << "a frame begins there";
  EXPECT_NE(report.difference->recorded_hash, report.difference->replayed_hash);
  EXPECT_EQ(report.hashes, 2u);
  EXPECT_NE(report.difference->what.find("was recorded"), std::string::npos);
}

// ------------------------------------------------------------------------------------------------------ it is damaged
TEST(Recording, every_truncation_is_refused_or_played_as_far_as_it_goes) {
  const Bytes bytes = small_recording();
  const std::vector<std::size_t> frames = places_of(bytes).frame;
  std::uint64_t calls = 0;
  for (std::size_t size = 0; size < bytes.size(); ++size) {
    const auto report = replay(std::span(bytes).first(size));
    if (size < frames[1]) {
      ASSERT_FALSE(report) << size;
      EXPECT_NE(report.error().place.find("byte "), std::string::npos);
      continue;
    }
    ASSERT_TRUE(report) << report.error().text();
    EXPECT_FALSE(report->difference) << size << ": " << report->difference->what;
    EXPECT_FALSE(report->complete);
    const auto next = std::ranges::upper_bound(frames, size);
    EXPECT_EQ(report->bytes, next == frames.end() ? frames.back() : *std::prev(next)) << size;
    EXPECT_GE(report->calls, calls);
    calls = report->calls;
  }
  EXPECT_EQ(calls, 7u);
}

TEST(Recording, every_flipped_byte_is_noticed) {
  const Bytes bytes = small_recording();
  std::mt19937 random(3);
  for (std::size_t at = 0; at < bytes.size(); ++at) {
    Bytes flipped = bytes;
    flipped[at] ^= static_cast<std::byte>(1u << (random() % 8));
    const auto report = replay(flipped);
    ASSERT_FALSE(report) << at << ": a length that became longer is no recording that was cut";
    EXPECT_FALSE(report.error().message.empty()) << at;
  }
}

TEST(Recording, bytes_that_make_no_sense_crash_nothing) {
  const Bytes bytes = small_recording();
  std::mt19937 random(4);
  int refused = 0, differed = 0;
  for (int i = 0; i < 3000; ++i) {
    Bytes flipped = bytes;
    const std::size_t at = 12 + random() % (bytes.size() - 12);
    flipped[at] = static_cast<std::byte>(random());
    sign(flipped);
    const auto report = replay(flipped);
    if (!report) ++refused;
    if (report && report->difference) ++differed;
  }
  EXPECT_GT(refused, 50);
  EXPECT_GT(differed, 50);
}

TEST(Recording, lists_longer_than_the_file_take_no_memory) {
  Bytes bytes = small_recording();
  const std::size_t name_length = places_of(bytes).frame[1] + kFrameHead;  // of the projectile's name
  for (std::size_t i = 0; i < 4; ++i) bytes[name_length + i] = std::byte{0xff};
  sign(bytes);
  const auto report = replay(bytes);
  ASSERT_FALSE(report);
  EXPECT_EQ(report.error().place, "byte " + std::to_string(places_of(bytes).frame[1]));
}

TEST(Recording, other_files_and_formats_are_refused) {
  const auto error_of = [](const Bytes& bytes) {
    const auto report = replay(bytes);
    return report ? std::string("none") : report.error().text();
  };
  Bytes bytes = small_recording();
  EXPECT_NE(error_of({}).find("byte 0: error: this is not a recording"), std::string::npos);
  EXPECT_NE(error_of(Bytes(100)).find("this is not a recording"), std::string::npos);
  bytes[8] = std::byte{99};
  const std::string known = "; this is PhySim " + std::string(kVersion) + ", which reads format " +
                            std::to_string(kRecordingFormat) + "; read it with the version that wrote it";
  constexpr std::size_t kVersionPlace = 21;  // behind the heads of the file and of its first frame, and a length
  bytes[kVersionPlace] = std::byte{'7'};
  EXPECT_EQ(error_of(bytes), "byte 8: error: the recording is of format 99, written by PhySim 7" +
                                 std::string(kVersion).substr(1) + known);
  bytes[8] = std::byte{1};
  bytes[kVersionPlace] = std::byte{0};
  const std::string older = "byte 8: error: the recording is of format 1, written by an older version of PhySim";
  EXPECT_EQ(error_of(bytes), older + known);
  bytes.resize(12);
  EXPECT_EQ(error_of(bytes), older + known);
  bytes = small_recording();
  bytes.push_back({});
  EXPECT_NE(error_of(bytes).find("something follows"), std::string::npos);
}

TEST(Recording, a_call_that_it_cannot_hold_is_refused_whole) {
  Bytes bytes;
  World world = made({});
  ASSERT_TRUE(world.record(record_into(bytes)));
  Launch bad{.position = {0, 90, 0}, .attitude = {.frame = static_cast<AttitudeFrame>(77)}};
  const auto refused = world.spawn(ProjectileDef{.mass = 3}, bad);  // would leave its kind behind
  ASSERT_FALSE(refused);
  EXPECT_NE(refused.error().message.find("enumerator"), std::string::npos) << refused.error().text();
  ASSERT_TRUE(world.spawn(ProjectileDef{.mass = 2}, Launch{.position = {0, 90, 0}}));
  ASSERT_TRUE(world.add_kind(ProjectileDef{.mass = 5}));
  world.step(0.01);
  replayed(world, bytes);
}

TEST(Recording, custom_forces_need_their_functions) {
  Bytes bytes;
  World world = made({});
  ASSERT_TRUE(world.record(record_into(bytes)));
  const ProjectileId id = *world.spawn(ProjectileDef{}, Launch{.position = {0, 90, 0}});
  world[id].add_force(with_functions(1).custom_forces[0]);
  world.step(0.01);
  ASSERT_TRUE(world.stop_recording());
  const auto refused = replay(bytes);
  ASSERT_FALSE(refused);
  EXPECT_EQ(refused.error().place, "custom_forces");
  const auto report = must(replay(bytes, with_functions(1)));
  EXPECT_FALSE(report.difference);
  ReplayOptions another;
  another.custom_forces = {{[](const ForceBatch&) {}}};
  EXPECT_TRUE(replay(bytes, another)->difference);
}

// ------------------------------------------------------------------------------------------------------ recording
TEST(Recording, begins_with_the_world_and_once) {
  Bytes bytes;
  World world = made({});
  EXPECT_FALSE(world.record(nullptr));
  EXPECT_FALSE(world.stop_recording());
  ASSERT_TRUE(world.record(record_into(bytes)));
  EXPECT_FALSE(world.record(record_into(bytes)));
  ASSERT_TRUE(world.stop_recording());
  EXPECT_FALSE(world.is_recording());
  EXPECT_TRUE(world.record(record_into(bytes)));  // still untouched
  World moved = std::move(world);
  EXPECT_TRUE(moved.is_recording());
  for (const auto& change : std::vector<std::function<void(World&)>>{
           [](World& w) { w.step(0.1); }, [](World& w) { w.add_kind({}); }, [](World& w) { w.set_paused(true); },
           [](World& w) { (void)w.add_environment({}); },
           [](World& w) {
             w.set_observer({1, 0, 0});
           },
           [](World& w) { w[*w.spawn(ProjectileDef{}, Launch{})].despawn(); }}) {
    World touched = made({});
    change(touched);
    const Status refused = touched.record(record_into(bytes));
    ASSERT_FALSE(refused);
    EXPECT_NE(refused.error().hint.find("create()"), std::string::npos);
  }
}

TEST(Recording, a_world_that_ends_completes_it_if_it_is_asked_to) {
  Bytes bytes;
  {
    World world = made({});
    ASSERT_TRUE(world.record(record_into(bytes), {.complete_at_end = true}));
    world.step(0.1);
  }
  EXPECT_TRUE(replay(bytes)->complete);
}

/// What a sink refers to may end before its world: members are destroyed in the reverse of their order.
TEST(Recording, a_world_that_ends_does_not_call_its_sink) {
  Bytes bytes;
  bool is_gone = false;
  int calls = 0;
  {
    World world = made({});
    ASSERT_TRUE(world.record([&](std::span<const std::byte> piece) -> Status {
      EXPECT_FALSE(is_gone);
      ++calls;
      bytes.insert(bytes.end(), piece.begin(), piece.end());
      return {};
    }));
    for (int i = 0; i < 3; ++i) world.step(0.1);
    world = made({});  // so does one that another takes the place of
    is_gone = true;
  }
  EXPECT_GT(calls, 3);
  const auto report = must(replay(bytes));
  EXPECT_FALSE(report.complete);
  EXPECT_EQ(report.steps, 3u);
  EXPECT_EQ(report.hashes, 3u) << "all of the last step was handed over when it ended";
}

TEST(Recording, a_call_is_handed_over_before_it_steps) {
  Bytes bytes;
  World world = made({});
  ASSERT_TRUE(world.record(record_into(bytes)));
  std::size_t before_last = 0;
  for (int i = 0; i < 5; ++i) before_last = bytes.size(), world.step(0.1);
  EXPECT_GT(bytes.size(), before_last);
  const auto report = must(replay(bytes));
  // as if the program had died behind its fifth step
  EXPECT_FALSE(report.complete);
  EXPECT_EQ(report.steps, 5u);
  EXPECT_EQ(report.hashes, 5u);
  EXPECT_FALSE(report.difference);
}

TEST(Recording, a_sink_that_fails_ends_it_and_not_the_world) {
  int left = 3;
  World world = made({});
  ASSERT_TRUE(world.record([&](std::span<const std::byte>) -> Status {
    return --left > 0 ? Status() : Status(Error{"the disk is full", "", ""});
  }));
  for (int i = 0; i < 20; ++i) world.step(0.1);
  EXPECT_FALSE(world.is_recording());
  EXPECT_EQ(world.counters().steps, 20u);
  const Status status = world.stop_recording();
  ASSERT_FALSE(status);
  EXPECT_EQ(status.error().message, "the disk is full");

  World other = made({});
  EXPECT_FALSE(other.record([](std::span<const std::byte>) -> Status { throw 1; }));
  EXPECT_TRUE(other.step(0.1));
}

TEST(Recording, a_snapshot_from_before_ends_it) {
  Bytes bytes;
  World world = made({});
  const Snapshot before = world.snapshot();
  ASSERT_TRUE(world.record(record_into(bytes)));
  const Snapshot after = world.snapshot();
  EXPECT_TRUE(world.restore(after));
  EXPECT_TRUE(world.is_recording());
  EXPECT_TRUE(world.restore(before));
  EXPECT_FALSE(world.is_recording());
  EXPECT_FALSE(world.stop_recording());
}

}  // namespace physim::world_recording_test
