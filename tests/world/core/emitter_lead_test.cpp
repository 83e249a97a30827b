// World::lead_emitter(): what is born on legs does not depend on the steps that cut them.
#include "world/emitter_support.hpp"

namespace physim::world_emitter_lead_test {

constexpr double kEnd = 1.6;
const MotionKey kCorners[] = {{.time = 0, .position = {1, 2, 3}},      {.time = 0.13, .position = {3, 2, 3}},
                              {.time = 0.4, .position = {3, 5, -1}},   {.time = 0.41, .position = {3.5, 5, -1}},
                              {.time = 0.7, .position = {3.5, 5, -1}},  // it waits here
                              {.time = 1.1, .position = {-40, 6, 9}},  {.time = 1.37, .position = {-40, 0, 0}}};

/// Where the polyline is at a time, and how far from its beginning.
struct OnLine {
  Vec3d position, velocity;
  double way = 0;
};
OnLine line(double time) {
  OnLine at{kCorners[0].position, {}, 0};
  for (std::size_t i = 1; i < std::size(kCorners); ++i) {
    const MotionKey &a = kCorners[i - 1], &b = kCorners[i];
    const Vec3d all = b.position - a.position;
    const double part = std::min((time - a.time) / (b.time - a.time), 1.0);
    at.position = a.position + all * part;
    at.velocity = all * (1 / (b.time - a.time));
    at.way += length(all) * part;
    if (time <= b.time) return at;
  }
  at.velocity = {};
  return at;
}

EmitterDef led(World& world) {
  return {.kind = kind_of(world, spark(), {.use_gravity = false}),
          .seed = 5,
          .position = kCorners[0].position,
          .inherit_velocity = 1,
          .per_second = {311},
          .per_metre = 3.7,
          .start = {.speed = {0}},
          .maximum = 1u << 30};
}

/// Tells the legs that begin up to `ahead` from now.
class Guide {
 public:
  Guide(EmitterId id, double ahead) : id_(id), ahead_(ahead) {}
  void operator()(World& world) {
    for (; next_ < std::size(kCorners) && kCorners[next_ - 1].time < world.time() + ahead_; ++next_) {
      const Status led = world.lead_emitter(id_, {.position = kCorners[next_].position}, kCorners[next_].time);
      ASSERT_TRUE(led) << led.error().text();
    }
  }

 private:
  EmitterId id_;
  double ahead_;
  std::size_t next_ = 1;
};

/// Steps of a frame rate, or of irregular lengths for 0; `between` is called before each.
template <class Between>
std::vector<Event> births(World& world, int rate, Between&& between) {
  std::vector<Event> events;
  unsigned random = 4711;
  while (world.time() < kEnd) {
    random = random * 1664525u + 1013904223u;
    between(world);
    EXPECT_TRUE(world.step(rate > 0 ? 1.0 / rate : 0.001 + 0.06 * (random >> 8) / 16777216.0));
    events.insert(events.end(), world.events().begin(), world.events().end());
  }
  return told(events, EventKind::spawned, kEnd);
}

void expect_same(const std::vector<Event>& a, const std::vector<Event>& b, int rate) {
  ASSERT_EQ(a.size(), b.size()) << rate;
  for (std::size_t i = 0; i < a.size(); ++i) {
    ASSERT_EQ(a[i].time, b[i].time) << rate;
    ASSERT_EQ(a[i].position, b[i].position) << rate << ' ' << a[i].time;
    ASSERT_EQ(a[i].velocity, b[i].velocity) << rate << ' ' << a[i].time;
  }
}

World open_world() { return make_world({.ground = {.mode = GroundMode::none}}); }

TEST(EmitterLead, births_on_a_polyline_are_equal_to_the_bit_at_any_frame_rate) {
  std::vector<Event> first;
  for (const int rate : kFrameRates) {
    World world = open_world();
    Guide guide(added(world, led(world)), rate == 24 ? 10 : 0.2);  // at once, or on its way
    const std::vector<Event> born = births(world, rate, guide);
    if (first.empty()) first = born;
    expect_same(born, first, rate);
  }
  ASSERT_GT(first.size(), 600u);
  for (const Event& e : first) {
    const OnLine at = line(e.time);
    EXPECT_LT(length(e.position - at.position), 1e-11) << e.time;
    EXPECT_LT(length(e.velocity - at.velocity), 1e-9) << e.time;
  }
}

TEST(EmitterLead, leaves_one_every_so_many_metres_over_all_corners) {
  for (const int rate : kFrameRates) {
    World world = open_world();
    EmitterDef def = led(world);
    def.per_second = {0};
    const std::vector<Event> born = births(world, rate, Guide(added(world, def), 0.2));
    ASSERT_EQ(born.size(), static_cast<std::size_t>(line(kEnd).way * def.per_metre));
    for (std::size_t i = 0; i < born.size(); ++i)
      EXPECT_NEAR(line(born[i].time).way, static_cast<double>(i + 1) / def.per_metre, 1e-11) << rate;
  }
}

TEST(EmitterLead, turns_at_a_steady_rate) {
  World world = open_world();
  EmitterDef def = led(world);
  def.start.speed = {10};
  def.from = {};
  def.inherit_velocity = 0;
  const EmitterId id = added(world, def);
  ASSERT_TRUE(world.lead_emitter(id, {.position = def.position, .rotation = {0, 0, 1, 0}}, 1));  // half a turn about y
  const std::vector<Event> born = births(world, 60, [](World&) {});
  for (const Event& e : born) {
    const double angle = 3.14159265358979 * std::min(e.time, 1.0);
    EXPECT_LT(length(e.velocity - Vec3d{10 * std::cos(angle), 0, -10 * std::sin(angle)}), 1e-9) << e.time;
  }
}

TEST(EmitterLead, saves_snapshots_and_recordings_go_on_bit_for_bit) {
  World straight = open_world();
  const std::vector<Event> whole = births(straight, 60, Guide(added(straight, led(straight)), 0.2));
  World world = open_world();
  std::vector<std::byte> bytes;
  Guide guide(added(world, led(world)), 0.2);
  const std::vector<Event> born = births(world, 60, [&](World& w) {
    const Snapshot snapshot = w.snapshot();
    const std::uint64_t hash = w.hash();
    for (int i = 0; i < 3; ++i) w.step(0.01);
    ASSERT_NE(w.hash(), hash);
    ASSERT_TRUE(w.restore(snapshot));
    auto loaded = reloaded(w);
    ASSERT_EQ(loaded.hash(), hash);
    w = std::move(loaded);
    guide(w);
  });
  expect_same(born, whole, 60);

  World recorded = open_world();
  ASSERT_TRUE(recorded.record([&](std::span<const std::byte> piece) -> Status {
    bytes.insert(bytes.end(), piece.begin(), piece.end());
    return {};
  }));
  expect_same(births(recorded, 60, Guide(added(recorded, led(recorded)), 0.2)), whole, 60);
  replayed(recorded, bytes);
}

TEST(EmitterLead, a_move_or_a_jump_ends_the_way_where_it_is) {
  for (const bool jumps : {false, true}) {
    World world = open_world();
    EmitterDef def = led(world);
    def.per_second = {0};
    def.per_metre = 10;
    def.position = {};
    const EmitterId id = added(world, def);
    ASSERT_TRUE(world.lead_emitter(id, {.position = {10, 0, 0}}, 1));
    ASSERT_TRUE(world.lead_emitter(id, {.position = {10, 10, 0}}, 2));
    step_to(world, 0.5, 8);
    EXPECT_EQ(world.emitter_counts(id).born, 50u);
    ASSERT_TRUE(jumps ? world.jump_emitter(id, {.position = {0, 0, 5}})
                      : world.move_emitter(id, {.position = {5, 0, 4.95}}));
    step_to(world, 3, 8);
    EXPECT_EQ(world.emitter_counts(id).born, jumps ? 50u : 99u);
    ASSERT_TRUE(world.lead_emitter(id, {.position = {0, 0, 6}}, 4));  // from where it is, at any time later
    step_to(world, 5, 8);
    EXPECT_EQ(world.emitter_counts(id).born, jumps ? 60u : 99u + 51u);
  }
}

TEST(EmitterLead, what_lies_behind_when_it_begins_to_play_does_not_count) {
  for (const int how : {0, 1, 2}) {
    World world = open_world();
    EmitterDef def = led(world);
    def.per_second = {0};
    def.per_metre = 10;
    def.start.lifetime = {100};
    const EmitterId id = added(world, def);
    ASSERT_TRUE(world.lead_emitter(id, {.position = def.position + Vec3d{10, 0, 0}}, 1));
    step_to(world, 0.5, 8);
    ASSERT_EQ(world.emitter_counts(id).born, 50u);
    const Status done = how == 0   ? world.play_emitter(id)
                        : how == 1 ? world.seek_emitter(id, 0.25)
                                   : world.stop_emitter(id);
    ASSERT_TRUE(done);
    const std::uint64_t before = world.emitter_counts(id).born;
    std::vector<Event> events;
    step_to(world, 2, 8, &events);
    EXPECT_EQ(world.emitter_counts(id).born - before, how == 2 ? 0u : 50u) << how;
    for (const Event& e : told(events, EventKind::spawned, 2)) EXPECT_GT(e.time, 0.505) << how;
  }
}

TEST(EmitterLead, bad_input_is_refused_with_its_place) {
  World world = open_world();
  EmitterDef def = led(world);
  const EmitterId id = added(world, def);
  def.motion = SteadyMotion{.velocity = {1, 0, 0}};
  const EmitterId moves = added(world, def);
  step_to(world, 0.5, 8);
  constexpr double kNone = std::numeric_limits<double>::quiet_NaN();
  const auto refused = [&](EmitterId emitter, const Transform& to, double time) {
    const std::uint64_t hash = world.hash();
    const Status status = world.lead_emitter(emitter, to, time);
    EXPECT_EQ(world.hash(), hash);
    return status ? "taken" : status.error().place;
  };
  for (const double time : {kNone, -1.0, 0.25, 0.5, 0.5 + 1e-7, 1e10, kInfinity, -kInfinity})
    EXPECT_EQ(refused(id, {}, time), "time") << time;
  EXPECT_EQ(refused(id, {.position = {1e14, 0, 0}}, 1), "time");  // too fast
  EXPECT_EQ(refused(id, {.position = {kNone, 0, 0}}, 1), "to");
  EXPECT_EQ(refused(id, {.rotation = {0, 0, 0, 0}}, 1), "to");
  EXPECT_EQ(refused(moves, {}, 1), "emitter");
  EXPECT_EQ(refused({}, {}, 1), "emitter");
  ASSERT_TRUE(world.lead_emitter(id, {}, 1));
  EXPECT_EQ(refused(id, {}, 0.9), "time");  // before the leg that it follows is done
  EXPECT_EQ(refused(id, {}, 1), "time");
  EXPECT_TRUE(world.lead_emitter(id, {}, 1.5));
}

}  // namespace physim::world_emitter_lead_test
