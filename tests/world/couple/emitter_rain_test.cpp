// Rain about a viewer: as dense everywhere in its box as it should be, while the viewer stands, moves and jumps.
#include "emit/statistics.hpp"
#include "random_shots.hpp"
#include "scene_support.hpp"
#include "world/emitter_support.hpp"

namespace physim::world_emitter_rain_test {

constexpr Vec3d kBox{20, 12, 16};  // [m]
constexpr double kDensity = 1;     // [1/m^3]

/// Drops that keep their velocity: down, with some wind.
EmitterDef rain(KindId kind) {
  return {.kind = kind,
          .seed = 3,
          .rotation = quat_from_axis_angle(Vec3d{0, 0, 1}, -1.5707963267948966),
          .per_second = {0},
          .rain = {.density = kDensity, .size = kBox, .drift = {2, 0, -1}},
          .start = {.lifetime = {kInfinity}, .speed = {7, 11}, .gravity = {0}},
          .maximum = 1u << 20};
}
World empty_world() { return make_world({.ground = {.mode = GroundMode::none}}); }

/// How often a box about the viewer, cut into cells, had a particle in each.
class Cells {
 public:
  void count(const World& world, EmitterId id, const Vec3d& viewer) {
    for (const auto& [number, at] : alive(world, id)) {
      std::size_t cell = 0;
      for (std::size_t k = 0; k < 3; ++k) {
        const double part = (at.position[k] - viewer[k]) / kBox[k] + 0.5;
        ASSERT_TRUE(part > -1e-6 && part < 1 + 1e-6) << number << " " << k;
        cell = cell * kSide + std::min(std::size_t(std::max(part, 0.0) * kSide), kSide - 1);
      }
      ++counts_[cell];
    }
    ++times_;
  }
  /// Against the density that it should be, not the mean of what there is.
  [[nodiscard]] testing::AssertionResult are_even() const {
    const double volume = kBox.x * kBox.y * kBox.z / double(counts_.size());
    return test::as_expected(counts_, std::vector<double>(counts_.size(), kDensity * volume * times_));
  }

 private:
  static constexpr std::size_t kSide = 5;
  std::vector<double> counts_ = std::vector<double>(kSide * kSide * kSide);
  int times_ = 0;
};

TEST(EmitterRain, is_even_about_a_viewer_that_stands) {
  World world = empty_world();
  const EmitterId id = added(world, rain(kind_of(world, spark())));
  Cells cells;
  ASSERT_TRUE(world.step(1e-6));
  cells.count(world, id, {});  // at once
  for (int i = 0; i < 30; ++i) {
    for (int frame = 0; frame < 40; ++frame) ASSERT_TRUE(world.step(0.05));  // all of them are others
    cells.count(world, id, {});
  }
  EXPECT_TRUE(cells.are_even());
}

TEST(EmitterRain, is_even_about_a_viewer_that_moves) {
  World world = empty_world();
  const EmitterId id = added(world, rain(kind_of(world, spark())));
  Cells cells;
  Vec3d viewer, velocity{30, 0, 0};
  for (int i = 0; i < 60; ++i) {
    // Another way every second.
    velocity = rotate(quat_from_axis_angle(Vec3d{0.6, 0.8, 0}, 0.7), velocity);
    for (int frame = 0; frame < 20; ++frame) {
      viewer += velocity * 0.05;
      ASSERT_TRUE(world.move_emitter(id, {viewer, rain({}).rotation}));
      ASSERT_TRUE(world.step(0.05));
    }
    cells.count(world, id, viewer);
  }
  EXPECT_TRUE(cells.are_even());
}

TEST(EmitterRain, is_even_about_a_viewer_that_jumps) {
  World world = empty_world();
  const EmitterId id = added(world, rain(kind_of(world, spark())));
  Cells cells;
  test::Random r(5);
  Vec3d viewer;
  for (int i = 0; i < 60; ++i) {
    viewer = i % 3 == 0 ? r.vector(1000) : viewer + r.vector(8);
    ASSERT_TRUE(world.jump_emitter(id, {viewer, rain({}).rotation}));
    ASSERT_TRUE(world.step(1e-3));
    if (i % 3 == 2) cells.count(world, id, viewer);  // after a jump far away and two into the box as it is
  }
  EXPECT_TRUE(cells.are_even());
}

TEST(EmitterRain, does_not_depend_on_frames_where_the_viewers_path_does_not) {
  const Vec3d corners[] = {{0, 0, 0}, {15, 0, 0}, {15, 3, 9}, {0, 1, 0}, {2, 0, 0}};
  std::map<std::uint64_t, BodyState> first;
  for (const int rate : {10, 24, 60, 144, 1000}) {
    World world = empty_world();
    const EmitterId id = added(world, rain(kind_of(world, spark())));
    const int frames = rate / 2;  // from corner to corner, in half a second
    for (std::size_t leg = 0; leg + 1 < std::size(corners); ++leg)
      for (int frame = 1; frame <= frames; ++frame) {
        const double part = double(frame) / frames;
        const Vec3d to = corners[leg] + (corners[leg + 1] - corners[leg]) * part;
        ASSERT_TRUE(world.move_emitter(id, {frame == frames ? corners[leg + 1] : to, rain({}).rotation}));
        ASSERT_TRUE(world.step(1.0 / rate));
      }
    const auto all = alive(world, id);
    if (first.empty()) first = all;
    ASSERT_EQ(all.size(), first.size()) << rate;
    for (const auto& [number, at] : all) {
      ASSERT_EQ(first.count(number), 1u) << rate;
      ASSERT_TRUE(test::near(at.position, first.at(number).position, 1e-9, 1e-9)) << rate;
    }
  }
}

TEST(EmitterRain, births_have_moments_of_their_own) {
  World world = empty_world();
  const EmitterId id = added(world, rain(kind_of(world, spark())));
  std::vector<Event> events;
  step_to(world, 0.5, 10, &events);
  const auto births = told(events, EventKind::spawned, 0.5);
  std::size_t at_faces = 0;
  for (const Event& e : births) {
    if (e.time == 0) continue;  // those that filled the box
    ++at_faces;
    double farthest = 0;
    for (std::size_t k = 0; k < 3; ++k) farthest = std::max(farthest, std::abs(e.position[k]) / (kBox[k] / 2));
    ASSERT_NEAR(farthest, 1, 1e-12);
    ASSERT_NE(e.time, 0.1);
  }
  // What comes in through top and sides: 9 m/s on 320 m2, 2 m/s on 192 m2 and 1 m/s on 240 m2, in half a second.
  const double expected = 0.5 * (9 * 320 + 2 * 192 + 240);
  EXPECT_NEAR(double(at_faces), expected, 4 * std::sqrt(expected));
  EXPECT_EQ(world.emitter_counts(id).born, births.size());
  EXPECT_EQ(world.emitter_counts(id).expired + world.emitter_counts(id).alive, births.size());
}

TEST(EmitterRain, comes_from_all_sides_where_directions_differ) {
  World world = empty_world();
  EmitterDef def = rain(kind_of(world, spark()));
  def.from = {.shape = EmitShape::sphere};
  def.rain.drift = {};
  def.start.speed = {2, 5};
  const EmitterId id = added(world, def);
  Cells cells;
  for (int i = 0; i < 10; ++i) {
    for (int frame = 0; frame < 80; ++frame) ASSERT_TRUE(world.step(0.1));
    cells.count(world, id, {});
  }
  EXPECT_TRUE(cells.are_even());
}

TEST(EmitterRain, keeps_out_from_below_roofs_and_the_ground) {
  World world = make_world({.ground = {.mode = GroundMode::land, .height = -4}});
  Scene scene;
  const ShapeId roof = scene.add_shape(BoxShape{{4, 0.1, 4}}).value();
  ASSERT_TRUE(scene.add({.shape = roof, .transform = {.position = {0, 3, 0}}}));
  ASSERT_TRUE(world.set_scene(scene));
  EmitterDef def = rain(kind_of(world, spark(), {.collision = {.on_hit = OnHit::stop}}));
  def.rain.drift = {};
  def.rain.shelter = 30;
  const EmitterId id = added(world, def);
  for (const double jump : {0.0, 0.0, 3.0, -2.0}) {
    ASSERT_TRUE(world.jump_emitter(id, {{jump, 0, 0}, def.rotation}));
    for (int frame = 0; frame < 60; ++frame) ASSERT_TRUE(world.step(1.0 / 60));
    std::size_t open = 0;
    for (const auto& [number, at] : alive(world, id)) {
      const Vec3d& p = at.position;
      EXPECT_GE(p.y, -4 - 1e-9);
      EXPECT_FALSE(p.y < 2.8 && std::abs(p.x) < 3.9 && std::abs(p.z) < 3.9) << p.x << " " << p.y << " " << p.z;
      open += std::abs(p.z) > 4.1 && p.y > -4;
    }
    const double expected = kDensity * 20 * 10 * (16 - 8.2);
    EXPECT_NEAR(double(open), expected, 5 * std::sqrt(expected));
  }
}

TEST(EmitterRain, ends_with_its_emitter_and_may_begin_again) {
  World world = empty_world();
  EmitterDef def = rain(kind_of(world, spark()));
  def.start.lifetime = {1};
  def.cycle.delay = {0.25};
  const EmitterId id = added(world, def);
  step_to(world, 0.2, 10);
  EXPECT_EQ(world.particles(id, {}), 0u);
  step_to(world, 0.3, 10);
  EXPECT_NEAR(double(world.particles(id, {})), kBox.x * kBox.y * kBox.z * kDensity, 200);
  ASSERT_TRUE(world.stop_emitter(id));
  step_to(world, 1.5, 10);
  EXPECT_EQ(world.particles(id, {}), 0u);
  ASSERT_TRUE(world.play_emitter(id));
  step_to(world, 1.8, 10);
  EXPECT_NEAR(double(world.particles(id, {})), kBox.x * kBox.y * kBox.z * kDensity, 200);
}

TEST(EmitterRain, saves_snapshots_and_recordings_go_on_bit_for_bit) {
  std::vector<std::byte> bytes;
  World world = empty_world();
  ASSERT_TRUE(world.record(record_into(bytes), {.hash_every = 1}));
  const EmitterId id = added(world, rain(kind_of(world, spark())));
  const auto go = [id](World& w, double from) {
    for (int frame = 0; frame < 20; ++frame) {
      ASSERT_TRUE(w.move_emitter(id, {{from + frame, 0, 0.5 * frame}, {1, 0, 0, 0}}));
      const bool jumps = frame == 10;
      ASSERT_TRUE(!jumps || w.jump_emitter(id, {{3, 2, 1}, {1, 0, 0, 0}}));
      ASSERT_TRUE(w.step(0.04));
    }
  };
  go(world, 0);
  auto loaded = reloaded(world);
  const Snapshot snapshot = world.snapshot();
  EXPECT_EQ(loaded.hash(), world.hash());
  go(world, 20);
  go(loaded, 20);
  const std::uint64_t then = world.hash();
  EXPECT_EQ(loaded.hash(), then);
  ASSERT_TRUE(world.restore(snapshot));
  go(world, 20);
  EXPECT_EQ(world.hash(), then);
  replayed(world, bytes);
}

TEST(EmitterRain, what_makes_no_sense_is_refused) {
  World world = empty_world();
  const KindId kind = kind_of(world, spark());
  const auto place = [&](const auto& change) {
    EmitterDef def = rain(kind);
    change(def);
    const auto id = world.add_emitter(def);
    return id ? std::string("none") : id.error().place;
  };
  EXPECT_EQ(place([](EmitterDef& d) { d.rain.density = -1; }), "emitter.rain.density");
  EXPECT_EQ(place([](EmitterDef& d) { d.rain.density = 1e6; }), "emitter.rain.density");
  EXPECT_EQ(place([](EmitterDef& d) { d.rain.size.y = 0; }), "emitter.rain.size");
  EXPECT_EQ(place([](EmitterDef& d) { d.rain.drift.x = std::nan(""); }), "emitter.rain.drift");
  EXPECT_EQ(place([](EmitterDef& d) { d.rain.shelter = -1; }), "emitter.rain.shelter");
  EXPECT_EQ(place([](EmitterDef& d) { d.inherit_velocity = 1; }), "emitter.inherit_velocity");
  EmitterDef moving = rain(kind);
  moving.motion = SteadyMotion{.velocity = {1, 0, 0}};
  const EmitterId id = added(world, moving);
  EXPECT_EQ(world.jump_emitter(id, {}).error().place, "emitter");
  EXPECT_EQ(world.jump_emitter({}, {}).error().place, "emitter");
  const EmitterId stands = added(world, rain(kind));
  EXPECT_EQ(world.jump_emitter(stands, {.position = {std::nan(""), 0, 0}}).error().place, "to");
}

}  // namespace physim::world_emitter_rain_test
