// The doors of a world: what it is asked for at odd times, with odd values, or when it is not there.
#include <cstdint>

#include "world/world_support.hpp"

namespace physim::world_doors_test {

// ------------------------------------------------------------------------------------------- events that are kept
TEST(Doors, events_stay_readable_while_the_world_is_changed) {
  World world = volley(100);
  const Snapshot before = world.snapshot();
  ASSERT_TRUE(world.step(1.0 / 64));
  int landed = 0;
  for (const Event& event : world.events()) {
    if (event.kind != EventKind::landed) continue;
    EXPECT_EQ(event.position.x, landed++);
    for (int i = 0; i < 50; ++i) {  // debris; it outgrows every list of events
      const auto piece = must(world.spawn(stone(), {.position = event.position + Vec3d{0, 1, 0}}));
      world[piece].despawn();
    }
  }
  EXPECT_EQ(landed, 100);
  EXPECT_EQ(world.events().size(), 100u + 2 * 100 * 50);
  const auto first = world.events();
  ASSERT_TRUE(world.restore(before));
  EXPECT_EQ(first[0].kind, EventKind::landed) << "a restore is a change too";
}

TEST(Doors, events_that_nobody_reads_do_not_pile_up) {
  WorldDef def{.pools = {{"one", 1, WhenFull::replace_oldest}}};
  World world = make_world(def);
  const KindId kind = *world.add_kind(stone());
  for (int i = 0; i < 500'000; ++i) ASSERT_TRUE(world.spawn(kind, {.position = {0, 9, 0}}));
  EXPECT_EQ(world.events().size(), kMostEventsOfCalls);
  EXPECT_EQ(world.counters().dropped_events, 2u * 500'000 - 1 - kMostEventsOfCalls);
  EXPECT_LT(world.memory(), 40u << 20);
  world.forget_events();
  EXPECT_TRUE(world.events().empty());
  ASSERT_TRUE(world.spawn(kind, {.position = {0, 9, 0}}));
  EXPECT_EQ(world.events().size(), 2u);
}

TEST(Doors, as_many_events_as_projectiles_are_kept) {
  World world;
  const KindId kind = *world.add_kind(stone());
  const std::size_t many = kMostEventsOfCalls + 1000;
  const std::vector<Launch> launches(many, Launch{.position = {0, 9, 0}});
  EXPECT_EQ(world.spawn(kind, launches, {}), many);
  EXPECT_EQ(world.events().size(), many);
  EXPECT_EQ(world.counters().dropped_events, 0u);
}

// ------------------------------------------------------------------------------------------- enumerators
template <class Enum>
Enum odd() {
  return static_cast<Enum>(200);
}
bool names_its_place(const Status& status) { return !status && !status.error().place.empty(); }

TEST(Doors, enumerators_out_of_range_are_refused) {
  for (auto change : std::vector<void (*)(WorldDef&)>{
           [](WorldDef& d) { d.ground.mode = odd<GroundMode>(); },
           [](WorldDef& d) {
             d.pools = {{"pool", 3, odd<WhenFull>()}};
           },
           [](WorldDef& d) { d.detail.rungs.resize(2), d.detail.rungs[1].fidelity.drag = odd<DragModel>(); },
           [](WorldDef& d) { d.environment.gravity.model = odd<GravityModel>(); },
           [](WorldDef& d) { d.environment.wind.by = odd<WindAxis>(); }}) {
    WorldDef def;
    change(def);
    const auto made = World::create(def);
    ASSERT_FALSE(made);
    EXPECT_FALSE(made.error().place.empty());
  }
  World world;
  for (auto change : std::vector<void (*)(BodyDef&)>{[](BodyDef& b) { b.frozen = odd<Axes>(); },
                                                     [](BodyDef& b) { b.frozen_rotation = odd<Axes>(); },
                                                     [](BodyDef& b) { b.smoothing = odd<Smoothing>(); }}) {
    BodyDef body;
    change(body);
    EXPECT_FALSE(world.add_kind(stone(), body));
    EXPECT_FALSE(world.spawn(stone(), {}, body));
  }
  const ProjectileId id = *world.spawn(stone(), {.position = {0, 9, 0}});
  Fidelity wild = Fidelity::game();
  wild.integrator = odd<Integrator>();
  EXPECT_TRUE(names_its_place(world[id].set_fidelity(wild)));
  EXPECT_EQ(world.set_fidelity(std::vector{id}, wild), 0u);
  EXPECT_TRUE(names_its_place(world[id].set_smoothing(odd<Smoothing>())));
  EXPECT_TRUE(names_its_place(world[id].set_frozen(odd<Axes>(), Axes::none)));
  EXPECT_TRUE(names_its_place(world[id].set_frozen(Axes::none, odd<Axes>())));
  DetailRule rule;
  rule.rungs.resize(2);
  rule.rungs[0].fidelity.precision = odd<Precision>();
  EXPECT_TRUE(names_its_place(world.set_detail(rule)));
  Environment environment{.atmosphere = {.model = odd<AirModel>()}};
  EXPECT_TRUE(names_its_place(world.set_environment(0, environment)));
  EXPECT_FALSE(world.add_environment(environment));
  EXPECT_TRUE(world.step(0.01));
  EXPECT_EQ(world[id].fidelity_in_use().fidelity.integrator, Integrator::semi_implicit_euler);
}

TEST(Doors, a_name_of_no_value_is_a_question_mark) {
  EXPECT_EQ(name(odd<GroundMode>()), "?");
  EXPECT_EQ(name(odd<Reason>()), "?");
  EXPECT_EQ(name(odd<Integrator>()), "?");
  EXPECT_EQ(name(static_cast<GroundMode>(-1)), "?");
  EXPECT_EQ(name(EventKind::landed), "landed");
}

TEST(Doors, a_refused_value_leaves_the_recording_whole) {
  std::vector<std::byte> bytes;
  World world;
  ASSERT_TRUE(world.record(record_into(bytes)));
  const ProjectileId id = *world.spawn(stone(), {.position = {0, 9, 0}});
  EXPECT_FALSE(world[id].set_smoothing(odd<Smoothing>()));
  ProjectileDef wild = stone();
  wild.fidelity.drag = odd<DragModel>();
  EXPECT_FALSE(world.spawn(wild, {}));
  EXPECT_TRUE(world.step(0.01));
  const ReplayReport report = replayed(world, bytes);
  EXPECT_EQ(report.spawned, 1u);
}

// ------------------------------------------------------------------------------------------- re-entry
struct Tried {
  int calls = 0;
  int refused = 0;
  void operator()(bool was_refused) { ++calls, refused += was_refused ? 1 : 0; }
};

/// Everything that changes a world, from inside.
void try_all(World& world, ProjectileId id, const Snapshot& snapshot, Tried& tried) {
  const auto says_so = [&](const auto& result) {
    tried(!result && result.error().message.find("inside") != std::string::npos);
  };
  says_so(world.step(0.01));
  tried(world.advance(1) == 0);
  world.single_step(), world.clear(), world.set_paused(true), world.forget_events();
  says_so(world.restore(snapshot));
  tried(!world.snapshot());
  says_so(world.save());
  says_so(world.spawn(stone(), {}));
  says_so(world.spawn(KindId{1}, {}));
  tried(world.spawn(KindId{1}, std::vector<Launch>(3), {}) == 0);
  says_so(world.reserve(KindId{1}, 1000));
  says_so(world.add_kind(stone()));
  says_so(world.add_environment({}));
  says_so(world.set_environment(0, {}));
  tried(world.despawn(std::vector{id}) == 0);
  tried(world.set_fidelity(std::vector{id}, Fidelity::reference()) == 0);
  says_so(world.set_detail({}));
  says_so(world.set_observer({}));
  says_so(world.add_force({.law = ConstantForce{}, .target = ForceTarget::everything()}));
  says_so(world.remove_force({1, 1}));
  says_so(world.set_time_scale(2));
  says_so(world.record([](auto) { return Status(); }));
  says_so(world.stop_recording());
  Projectile p = world[id];
  for (const Status& status : {p.despawn(),
                               p.set_position({}),
                               p.set_velocity({}),
                               p.set_state({}),
                               p.apply_impulse({}),
                               p.set_angular_velocity({}),
                               p.set_fidelity(Fidelity::game()),
                               p.set_body({}),
                               p.set_gravity_scale(1),
                               p.set_use_gravity(true),
                               p.set_kinematic(true),
                               p.set_frozen(Axes::x, Axes::none),
                               p.set_can_sleep(true),
                               p.sleep(),
                               p.wake(),
                               p.set_smoothing(Smoothing::none),
                               p.set_user_data(1),
                               p.set_layers(1),
                               p.set_colour(1),
                               p.set_label("a"),
                               p.remove_force({1, 1})})
    says_so(status);
  says_so(p.add_force(ConstantForce{}));
}

TEST(Doors, a_force_that_changes_its_world_is_refused) {
  WorldDef def{.ground = {.mode = GroundMode::none}};
  World world = make_world(def);
  World calm = make_world(def);
  ProjectileDef p = stone();
  p.fidelity.integrator = Integrator::rk4;
  const ProjectileId id = *world.spawn(p, {.velocity = Vec3d{3, 4, 0}});
  const ProjectileId same = *calm.spawn(p, {.velocity = Vec3d{3, 4, 0}});
  const Snapshot snapshot = world.snapshot();
  Tried tried;
  Vec3d felt;
  int reads = 0;
  const auto force = [&](const ForceBatch& batch) {
    try_all(world, id, snapshot, tried);
    felt = world[id].accelerations().applied;  // would ask this function again
    reads += world.ids().size() == 1 && world[id].is_alive() && world.hash() != 0 ? 1 : 0;
    batch.force[0].x += 2;
  };
  ASSERT_TRUE(world.add_force({.law = CustomForce{force}, .target = ForceTarget::everything()}));
  ASSERT_TRUE(calm.add_force({.law = ConstantForce{{2, 0, 0}}, .target = ForceTarget::everything()}));
  for (int i = 0; i < 5; ++i) {
    ASSERT_TRUE(world.step(0.02));
    ASSERT_TRUE(calm.step(0.02));
  }
  EXPECT_GT(tried.calls, 4 * 5 * 40);
  EXPECT_EQ(tried.refused, tried.calls);
  EXPECT_EQ(felt, Vec3d{});
  EXPECT_EQ(reads, tried.calls > 0 ? 20 : 0) << "four stages in each of five steps";
  EXPECT_EQ(world[id].position(), calm[same].position()) << "and the step goes on";
  const int before = tried.calls;
  EXPECT_NE(world[id].accelerations().applied.x, 0) << "outside of a step it is asked";
  EXPECT_GT(tried.calls, before);
  EXPECT_EQ(tried.refused, tried.calls) << "and may change nothing either";
}

TEST(Doors, a_world_that_is_destroyed_by_its_force_ends_its_step_first) {
  for (const bool recorded : {false, true}) {
    std::vector<std::byte> bytes;
    auto world = std::make_unique<World>();
    if (recorded) {
      ASSERT_TRUE(world->record(record_into(bytes)));
    }
    ASSERT_TRUE(world->spawn(stone(), {.position = {0, 50, 0}}));
    ASSERT_TRUE(world->add_force(
        {.law = CustomForce{[&](const ForceBatch&) { world.reset(); }}, .target = ForceTarget::everything()}));
    World* const there = world.get();
    EXPECT_TRUE(there->step(0.01));
    EXPECT_EQ(world, nullptr);
    if (recorded) {
      ReplayOptions options;
      options.custom_forces = {{[](const ForceBatch&) {}}};
      const auto report = must(replay(bytes, options));
      EXPECT_EQ(report.steps, 1u) << "its end was handed over";
    }
  }
}

TEST(Doors, a_world_that_is_moved_over_by_its_force_ends_its_step_first) {
  World world;
  ASSERT_TRUE(world.spawn(stone(), {.position = {0, 50, 0}}));
  ASSERT_TRUE(world.add_force(
      {.law = CustomForce{[&](const ForceBatch&) { world = World(); }}, .target = ForceTarget::everything()}));
  EXPECT_TRUE(world.step(0.01));
  EXPECT_EQ(world.size(), 0u);
  EXPECT_EQ(world.advance(1), 8);
}

TEST(Doors, a_force_that_throws_is_not_felt) {
  World world;
  const ProjectileId id = *world.spawn(stone(), {.position = {0, 50, 0}});
  const auto thrower = [](const ForceBatch& batch) {
    batch.force[0].x = 1e9;
    throw 3;
  };
  ASSERT_TRUE(world.add_force({.law = CustomForce{thrower}, .target = ForceTarget::everything()}));
  EXPECT_TRUE(world.step(0.01));
  EXPECT_EQ(world[id].velocity().x, 0);
  EXPECT_TRUE(world.step(0.01)) << "it is not taken for a call from inside";
}

TEST(Doors, a_sink_that_changes_its_world_is_refused) {
  World world;
  const ProjectileId nobody{1, 1};
  const Snapshot snapshot = world.snapshot();
  Tried tried;
  std::vector<std::byte> bytes;
  const auto sink = [&](std::span<const std::byte> more) -> Status {
    bytes.insert(bytes.end(), more.begin(), more.end());
    try_all(world, nobody, snapshot, tried);
    return {};
  };
  ASSERT_TRUE(world.record(sink));
  ASSERT_TRUE(world.spawn(stone(), {.position = {0, 50, 0}}));
  for (int i = 0; i < 3; ++i) ASSERT_TRUE(world.step(0.01));
  ASSERT_TRUE(world.stop_recording());
  EXPECT_GT(tried.calls, 4 * 40);
  EXPECT_EQ(tried.refused, tried.calls);
  const auto report = must(replay(bytes));
  EXPECT_FALSE(report.difference);
  EXPECT_EQ(report.spawned, 1u);
}

TEST(Doors, a_world_that_is_destroyed_by_its_sink_ends_its_call_first) {
  auto world = std::make_unique<World>();
  bool armed = false;
  ASSERT_TRUE(world->record([&](std::span<const std::byte>) -> Status {
    if (armed) world.reset();
    return {};
  }));
  ASSERT_TRUE(world->spawn(stone(), {.position = {0, 50, 0}}));
  armed = true;
  World* const there = world.get();
  EXPECT_TRUE(there->step(0.01));
  EXPECT_EQ(world, nullptr);
}

/// Changes its world between two pieces of work.
class Meddler final : public TaskRunner {
 public:
  explicit Meddler(World& world) : world_(world) {}
  void run(std::size_t count, void (*task)(void*, std::size_t), void* context) override {
    for (std::size_t i = 0; i < count; ++i) {
      task(context, i);
      refused += world_.spawn(stone(), {}).ok() ? 0 : 1;
    }
  }
  [[nodiscard]] unsigned threads() const override { return 2; }
  int refused = 0;

 private:
  World& world_;
};

TEST(Doors, a_task_runner_that_changes_its_world_is_refused) {
  World world = make_world({.threading = {2, 1}});
  Meddler meddler(world);
  world.set_task_runner(&meddler);
  for (int i = 0; i < 10; ++i) ASSERT_TRUE(world.spawn(stone(), {.position = {0, 50, 0}}));
  EXPECT_TRUE(world.step(0.01));
  EXPECT_GT(meddler.refused, 0);
  EXPECT_EQ(world.size(), 10u);
}

// ------------------------------------------------------------------------------------------- nothing throws
TEST(Doors, room_for_more_than_there_can_be_is_refused) {
  World world;
  const KindId kind = *world.add_kind(stone());
  for (const std::size_t count : {SIZE_MAX, SIZE_MAX - 1, SIZE_MAX / 2, SIZE_MAX / 100, std::size_t{1} << 32}) {
    const Status status = world.reserve(kind, count);
    ASSERT_FALSE(status) << count;
    EXPECT_EQ(status.error().place, "count");
  }
  EXPECT_TRUE(world.reserve(kind, 1000));
  EXPECT_TRUE(world.spawn(kind, {.position = {0, 1, 0}}));
}

TEST(Doors, room_that_was_reserved_is_enough) {
  World world;
  const KindId kind = *world.add_kind(stone());
  ASSERT_TRUE(world.reserve(kind, 5000));
  const std::size_t reserved = world.memory();
  for (int i = 0; i < 5000; ++i) ASSERT_TRUE(world.spawn(kind, {.position = {0, 1.0 + i, 0}}));
  EXPECT_EQ(world.memory(), reserved);
}

TEST(Doors, a_pool_of_more_threads_than_there_can_be_has_fewer) {
  const auto pool = make_thread_pool(200'000);
  ASSERT_TRUE(pool);
  EXPECT_GE(pool->threads(), 1u);
  EXPECT_LE(pool->threads(), kMostThreads);
  std::vector<int> done(1000);
  pool->run(
      done.size(), [](void* list, std::size_t i) { ++(*static_cast<std::vector<int>*>(list))[i]; }, &done);
  EXPECT_EQ(std::ranges::count(done, 1), 1000);
}

TEST(Doors, a_world_that_was_moved_away_is_empty) {
  World world = volley(3);
  const ProjectileId id = world.ids().front();
  World other = std::move(world);
  EXPECT_EQ(other.size(), 3u);
  const World& read = world;  // NOLINT: that is what is tested
  EXPECT_EQ(read.size(), 0u);
  EXPECT_EQ(read.hash(), World().hash());
  EXPECT_FALSE(read[id].is_alive());
  EXPECT_EQ(read[id].position(), Vec3d{});
  EXPECT_TRUE(read.events().empty());
  EXPECT_FALSE(world[id].despawn());
  EXPECT_TRUE(world.step(0.01));
  EXPECT_TRUE(world.spawn(stone(), {.position = {0, 5, 0}}));
  EXPECT_EQ(world.size(), 1u);
  World third;
  third = std::move(world);
  EXPECT_EQ(world.time(), 0);
  EXPECT_FALSE(world.snapshot().time() != 0);
  EXPECT_FALSE(world.is_recording());
}

TEST(Doors, a_flight_that_was_moved_away_is_a_refused_one) {
  Flight flight = fly(stone(), {.position = {0, 5, 0}});
  const Flight other = std::move(flight);
  EXPECT_EQ(other.outcome(), Outcome::landed);
  EXPECT_EQ(flight.outcome(), Outcome::refused);  // NOLINT: that is what is tested
  ASSERT_TRUE(flight.error());
  EXPECT_EQ(flight.at(1).position, Vec3d{});
  EXPECT_FALSE(flight.at_range(3));
  EXPECT_EQ(flight.duration(), 0);
  EXPECT_TRUE(flight.events().empty());
  Flight third = other;
  flight = std::move(third);
  EXPECT_EQ(flight.outcome(), Outcome::landed);
  EXPECT_EQ(third.outcome(), Outcome::refused);
}

}  // namespace physim::world_doors_test
