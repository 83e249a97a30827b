// Saves: a world that is loaded goes on as the one that was saved, bit for bit; what is no save is refused.
#include "base/hash.hpp"
#include "world/random_session.hpp"
#include "world/world_support.hpp"

namespace physim::world_save_test {

using Bytes = std::vector<std::byte>;

LoadOptions with_functions(std::size_t count = 1000) {
  LoadOptions options;
  options.custom_forces.assign(count, {[](const ForceBatch& b) {
                                 for (std::size_t i = 0; i < b.id.size(); ++i) b.force[i].y += b.mass[i] * 3;
                               }});
  return options;
}

Bytes save_of(const World& world) { return must(world.save()); }

World load(const Bytes& save, const LoadOptions& options = {}) { return must(World::load(save, options)); }

void expect_same(const World& a, const World& b) {
  ASSERT_EQ(a.hash(), b.hash());
  ASSERT_EQ(a.ids(), b.ids());
  ASSERT_EQ(a.time(), b.time());
  for (const ProjectileId id : a.ids()) {
    ASSERT_EQ(a[id].state(), b[id].state());
    ASSERT_EQ(a[id].previous_position(), b[id].previous_position());
    ASSERT_EQ(a[id].render_position(), b[id].render_position());
    ASSERT_EQ(a[id].orientation(), b[id].orientation());
    ASSERT_EQ(a[id].body(), b[id].body());
    ASSERT_EQ(a[id].kind(), b[id].kind());
    ASSERT_EQ(a[id].status(), b[id].status());
    ASSERT_EQ(a[id].user_data(), b[id].user_data());
    ASSERT_EQ(a[id].accelerations().total, b[id].accelerations().total);
    ASSERT_EQ(a[id].fidelity_in_use().notes.size(), b[id].fidelity_in_use().notes.size());
  }
}

TEST(Save, random_sessions_go_on_from_any_moment) {
  for (unsigned seed = 1; seed <= 8; ++seed) {
    World going = make_world(test::session_world());
    World broken = make_world(test::session_world());
    test::RandomSession first(going, seed, false), second(broken, seed, false);
    for (int part = 0; part < 5; ++part) {
      SCOPED_TRACE(std::to_string(seed) + ", part " + std::to_string(part));
      for (int i = 0; i < 400; ++i) first.act(), second.act();
      const Bytes save = save_of(broken);
      broken = load(save, with_functions());
      expect_same(going, broken);
      if (HasFatalFailure()) return;
      EXPECT_EQ(save_of(broken), save) << "and is saved as it was";
      EXPECT_EQ(going.counters().steps, broken.counters().steps);
    }
    for (int i = 0; i < 100; ++i) {
      going.single_step(), broken.single_step();
      ASSERT_EQ(going.hash(), broken.hash()) << seed;
    }
  }
}

TEST(Save, rockets_go_on_with_what_is_left_of_their_burn) {
  World world = make_world({.ground = {.mode = GroundMode::none}});
  ProjectileDef rocket{.mass = 2,
                       .diameter = 0.1,
                       .length = 1,
                       .motor = {.thrust = {{0, 100}, {0.5, 300}, {1, 100}, {2, 0}}, .propellant_mass = 0.5}};
  for (const double delay : {0.0, 0.35}) {
    rocket.motor.ignition_delay = delay;
    for (const Fidelity& rung : {Fidelity::game(), Fidelity::constant_air(), Fidelity::simulation()}) {
      rocket.fidelity = rung;
      const Launch launch{.speed = 1, .elevation = 1.4, .rail_length = 2};
      ASSERT_TRUE(world.spawn(rocket, launch));
    }
  }
  for (int i = 0; i < 150; ++i) {
    World again = load(save_of(world));
    expect_same(world, again);
    if (HasFatalFailure()) return;
    again.step(1.0 / 60);
    world.step(1.0 / 60);
    ASSERT_EQ(world.hash(), again.hash()) << i;
  }
}

TEST(Save, tables_lie_where_they_lay_whatever_was_let_go) {
  World world;
  ProjectileDef p = bullet();
  p.fidelity = Fidelity::constant_air();
  for (int i = 0; i < 1200; ++i) {  // kinds with curves of their own come and go
    p.drag = {.table = DragTable::custom, .curve = {{0, 0.1 + 1e-3 * (i % 40)}, {1, 0.5}, {3, 0.4}}};
    p.mass = 0.01 + 1e-6 * i;
    if (i % 3 == 0) p.drag = {.table = DragTable::g1};
    world[*world.spawn(p, {.position = {0, 9, 0}, .speed = 300})].despawn();
  }
  p.drag = {.table = DragTable::g7};
  ASSERT_TRUE(world.spawn(p, {.position = {0, 50, 0}, .speed = 300}));
  World again = load(save_of(world));
  for (int i = 0; i < 30; ++i) {
    ASSERT_EQ(world.hash(), again.hash());
    world.step(0.01), again.step(0.01);
  }
}

TEST(Save, what_the_next_step_retires_goes_along) {
  World world;
  ProjectileDef p = stone();
  p.fidelity = Fidelity::classic();
  p.fidelity.motion = Motion::force;
  p.fidelity.precision = Precision::float32;
  p.mass = 1e-9;
  ASSERT_TRUE(world.spawn(p, {.position = {0, 5, 0}}));
  ASSERT_TRUE(world.add_force({ConstantForce{{1e35, 0, 0}}, ForceTarget::everything()}));
  for (int step = 0; step < 4; ++step) {
    expect_same(world, load(save_of(world)));
    world.step(1.0 / 64);
  }
  EXPECT_EQ(world.size(), 0U) << "an acceleration beyond float32 retires it";
}

TEST(Save, a_place_of_before_that_its_rung_cannot_hold_is_cut) {
  World world;
  ProjectileDef p = stone();
  p.fidelity.integrator = Integrator::semi_implicit_euler;  // one multiplication, exact for powers of two
  const ProjectileId id =
      *world.spawn(p, {.position = {-std::ldexp(1, 997), 5, 0}, .velocity = Vec3d{std::ldexp(1, 1003), 0, 0}});
  world.step(1.0 / 64);
  ASSERT_EQ(world[id].position().x, 0);
  ASSERT_TRUE(world[id].set_velocity({}));
  ASSERT_TRUE(world[id].set_fidelity(Fidelity::game()));
  EXPECT_TRUE(std::isfinite(world[id].previous_position().x));
  expect_same(world, load(save_of(world)));
}

TEST(Save, functions_are_handed_in_again) {
  World world;
  const ProjectileId id = *world.spawn(stone(), {.position = {0, 90, 0}});
  ASSERT_TRUE(world.add_force(
      {.law = CustomForce{[](const ForceBatch& b) { b.force[0].x = 5; }}, .target = ForceTarget::everything()}));
  world.step(0.01);
  const Bytes save = save_of(world);
  const auto refused = World::load(save);
  ASSERT_FALSE(refused);
  EXPECT_EQ(refused.error().place, "custom_forces");
  LoadOptions options;
  options.custom_forces = {{[](const ForceBatch& b) { b.force[0].x = 5; }}};
  World again = load(save, options);
  world.step(0.01), again.step(0.01);
  EXPECT_EQ(world[id].velocity(), again[id].velocity());
  EXPECT_EQ(world.hash(), again.hash());
}

TEST(Save, a_recording_may_begin_at_one) {
  for (const bool loaded : {false, true}) {
    World world = make_world(test::session_world());
    test::RandomSession session(world, 3, false);
    for (int i = 0; i < 500; ++i) session.act();
    if (loaded) world = load(save_of(world), with_functions());
    Bytes bytes;
    EXPECT_FALSE(world.record(record_into(bytes))) << "not without a word";
    ASSERT_TRUE(world.record(record_into(bytes), {.from_now = true}));
    for (int i = 0; i < 500; ++i) session.act();
    const std::uint64_t hash = world.hash();
    ASSERT_TRUE(world.stop_recording());
    Replay player = must(Replay::open(bytes, with_functions()));
    while (player.next()) continue;
    ASSERT_FALSE(player.report().difference)
        << player.report().difference->call << ": " << player.report().difference->what;
    EXPECT_TRUE(player.report().complete);
    EXPECT_EQ(player.world().hash(), hash);
  }
}

TEST(Save, what_is_no_save_is_refused) {
  World world;
  ASSERT_TRUE(world.spawn(stone(), {.position = {0, 9, 0}}));
  const Bytes save = save_of(world);
  ASSERT_TRUE(World::load(save));
  EXPECT_FALSE(World::load({}));
  for (std::size_t size = 0; size < save.size(); size += 7)
    EXPECT_FALSE(World::load(std::span(save).first(size))) << size;
  for (std::size_t i = 0; i < save.size(); i += 3) {
    Bytes damaged = save;
    damaged[i] ^= std::byte{0x10};
    const auto loaded = World::load(damaged);
    ASSERT_FALSE(loaded) << i;
    EXPECT_EQ(loaded.error().place, "save");
  }
  Bytes longer = save;
  longer.push_back({});
  EXPECT_FALSE(World::load(longer));
}

/// A save with other bytes and the check sum that goes with them.
Bytes with_sum(Bytes save) {
  constexpr std::size_t kHead = 20;
  Hash hash;
  hash.add(std::span(save).subspan(kHead, save.size() - kHead - 8));
  for (unsigned i = 0; i < 8; ++i) save[save.size() - 8 + i] = static_cast<std::byte>(hash.value() >> (8 * i));
  return save;
}

constexpr std::size_t kVersionPlace = 24;  // behind the head and the length of the version

TEST(Save, of_another_format_is_refused_with_the_version_that_wrote_it) {
  Bytes save = save_of(World());
  save[kVersionPlace] = std::byte{'7'};
  save[8] = std::byte{99};
  const Error error = World::load(save).error();
  const std::string version = "7" + std::string(kVersion).substr(1);
  EXPECT_EQ(error.message, "the save is of format 99, written by PhySim " + version + "; this is PhySim " + kVersion +
                               ", which reads format " + std::to_string(kSaveFormat));
  EXPECT_EQ(error.place, "save");
  EXPECT_EQ(error.hint, "read it with the version that wrote it");
  save[kVersionPlace] = std::byte{0xff};
  EXPECT_NE(World::load(save).error().message.find("written by a newer version of PhySim;"), std::string::npos);
  save[8] = std::byte{1};
  EXPECT_NE(World::load(save).error().message.find("written by an older version of PhySim;"), std::string::npos);
}

TEST(Save, of_another_version_is_read_and_named_where_it_makes_no_sense) {
  World world;
  ASSERT_TRUE(world.spawn(stone(), {.position = {0, 9, 0}}));
  Bytes save = save_of(world);
  save[kVersionPlace] = std::byte{'7'};
  const auto loaded = must(World::load(with_sum(save)));
  expect_same(loaded, world);
  save[save.size() - 9] = std::byte{0xff};  // the last of its content: a list that is longer than what follows
  const std::string why = ": PhySim 7" + std::string(kVersion).substr(1) + " wrote it, and this is PhySim " + kVersion;
  EXPECT_EQ(World::load(with_sum(save)).error().message, "its bytes make no sense" + why);
}

TEST(Save, a_clock_that_never_was_is_refused) {
  World world;
  for (int i = 0; i < 3; ++i) ASSERT_TRUE(world.step(0.01));
  ASSERT_TRUE(world.step(0.02));  // steps of this length began at 0.03 s: the number is in the save
  const double start = 3 * 0.01;
  Bytes number(8);
  std::memcpy(number.data(), &start, 8);
  Bytes save = save_of(world);
  ASSERT_TRUE(World::load(with_sum(save)));
  const auto at = std::search(save.begin(), save.end(), number.begin(), number.end());
  ASSERT_NE(at, save.end());
  at[7] ^= std::byte{0x80};
  EXPECT_FALSE(World::load(with_sum(save))) << "a time below 0";
  at[7] = std::byte{0x7f}, at[6] = std::byte{0xf0};
  EXPECT_FALSE(World::load(with_sum(save))) << "no finite time";
}

TEST(Save, a_fall_that_has_not_the_horizontal_velocity_of_its_launch_is_refused) {
  constexpr double kSpeed = 123.5;
  Bytes number(8);
  std::memcpy(number.data(), &kSpeed, 8);
  for (const Vec3d& velocity : {Vec3d{kSpeed, 0, 1}, Vec3d{1, 0, kSpeed}}) {
    World world;
    ProjectileDef def = stone();
    def.fidelity = Fidelity::arcade();
    ASSERT_TRUE(world.spawn(def, {.position = {0, 1e4, 0}, .velocity = velocity}));
    ASSERT_TRUE(world.step(0.01));
    const Bytes save = save_of(world);
    ASSERT_TRUE(World::load(with_sum(save)));
    int found = 0;
    for (auto at = save.begin(); (at = std::search(at, save.end(), number.begin(), number.end())) != save.end(); ++at) {
      ++found;
      Bytes other = save;
      other[static_cast<std::size_t>(at - save.begin()) + 5] ^= std::byte{1} << 4;
      EXPECT_FALSE(World::load(with_sum(other))) << found;
    }
    EXPECT_EQ(found, 2) << "that of the launch, and that of now";
  }
}

TEST(Save, fuzzed_ones_are_refused_or_make_a_sound_world) {
  World world = make_world(test::session_world());
  test::RandomSession session(world, 11, false);
  for (int i = 0; i < 300; ++i) session.act();
  const Bytes save = save_of(world);
  std::mt19937 random(5);
  int made = 0;
  for (int i = 0; i < 1500; ++i) {
    Bytes fuzzed = save;
    for (unsigned k = 0; k <= random() % 3; ++k) {
      const std::size_t at = 20 + random() % (save.size() - 28);
      fuzzed[at] = random() % 2 == 0 ? fuzzed[at] ^ static_cast<std::byte>(1u << random() % 8)
                                     : static_cast<std::byte>(random());
    }
    auto loaded = World::load(with_sum(fuzzed), with_functions());
    if (!loaded) continue;
    ++made;
    for (int step = 0; step < 2; ++step) loaded->single_step();
    static_cast<void>(loaded->spawn(stone(), {.position = {0, 9, 0}}));  // pools may be full
    for (const ProjectileId id : loaded->ids()) EXPECT_TRUE(loaded.value()[id].despawn());
    EXPECT_EQ(loaded->size(), 0u);
  }
  EXPECT_GT(made, 100);
}

}  // namespace physim::world_save_test
