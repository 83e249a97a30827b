// How particles start and are shown, what sub-emitters fire, and that every row of a definition counts.
#include "emit/emission.hpp"

#include <functional>

#include "base/hash.hpp"
#include "emit/flight_law.hpp"
#include "emit/looks.hpp"
#include "emit/newborn_pack.hpp"
#include "emit/statistics.hpp"
#include "emit/timeline.hpp"
#include "random_emitters.hpp"
#include "support.hpp"

namespace physim::emit_emission_test {

using test::kInfinity;
using test::near;
using test::parabola;

TEST(Emission, equal_definitions_and_seeds_give_equal_bits) {
  EmitterDef def{.from = {.shape = EmitShape::sphere, .randomise = 0.4},
                 .start = {.speed = {1, 9.0}, .size = {1, 2.0, parabola()}}};
  const Emission a(def, 99), b(def, 99), other(def, 100);
  int differ = 0;
  for (std::uint64_t i = 10'000; i-- > 0;) {  // in another order, too
    const Newborn x = a.newborn({.number = i}), y = b.newborn({.number = i}), z = other.newborn({.number = i});
    ASSERT_TRUE(test::same_bits(x.place, y.place) && test::same_bits(x.direction, y.direction) && x.speed == y.speed);
    ASSERT_EQ(a.look(i, 0.2, 5, 1, 0).size, b.look(i, 0.2, 5, 1, 0).size);
    differ += x.speed != z.speed && x.place != z.place;
  }
  EXPECT_EQ(differ, 10'000);
}

TEST(Emission, everything_is_drawn_by_itself) {
  EmitterDef def;
  const DrawnNumber drawn{0, 1.0};
  ParticleStart& s = def.start;
  s.speed = s.gravity = s.rotation = s.rotation_y = s.rotation_z = drawn;
  s.lifetime = s.size = s.size_y = s.size_z = {1, 2.0};
  s.colour = {0x00000000, 0xffffffff};
  def.from = {.shape = EmitShape::sphere, .randomise = 0};
  const Emission emission(def, 3);
  constexpr std::size_t kNumbers = 12, kCount = 100'000;
  double mean[kNumbers] = {}, product[kNumbers][kNumbers] = {};
  for (std::uint64_t i = 0; i < kCount; ++i) {
    const Newborn n = emission.newborn({.number = i});
    const Look l = emission.look(i, 0, 1, 0, 0);
    const double r = length(n.place), x[kNumbers] = {n.speed,
                                                     n.gravity,
                                                     n.lifetime - 1,
                                                     l.rotation.x,
                                                     l.rotation.y,
                                                     l.rotation.z,
                                                     l.size.x - 1,
                                                     l.size.y / l.size.x - 1,
                                                     l.size.z / l.size.x - 1,
                                                     (l.colour & 0xff) / 255.0,
                                                     r * r * r,
                                                     0.5 + 0.5 * n.direction.x};
    for (std::size_t a = 0; a < kNumbers; ++a) {
      mean[a] += x[a] / kCount;
      for (std::size_t b = 0; b < a; ++b) product[a][b] += (x[a] - 0.5) * (x[b] - 0.5) * 12 / kCount;
    }
  }
  for (std::size_t a = 0; a < kNumbers; ++a) {
    EXPECT_NEAR(mean[a], 0.5, 4.5 * std::sqrt(1.0 / 12 / kCount)) << a;
    for (std::size_t b = 0; b < a; ++b) EXPECT_NEAR(product[a][b], 0, 4.5 / std::sqrt(double(kCount))) << a << b;
  }
}

TEST(Emission, start_values_follow_the_cycle) {
  EmitterDef def{.start = {.lifetime = {2, {}, {{0, 1}, {1, 3}}},
                           .speed = {-6, {}, parabola()},
                           .gravity = {0.5, {}, {{0, 2}, {1, 0}}}}};
  const Newborn n = Emission(def, 1).newborn({.phase = 0.25});
  EXPECT_DOUBLE_EQ(n.lifetime, 3);
  EXPECT_DOUBLE_EQ(n.speed, -4.5);
  EXPECT_DOUBLE_EQ(n.gravity, 0.75);
  def.start.lifetime = {kInfinity};
  EXPECT_EQ(Emission(def, 1).newborn({}).lifetime, kInfinity);
}

TEST(Emission, sizes_are_products) {
  EmitterDef def{.start = {.size = {2, {}, {{0, 1}, {1, 3}}}, .size_y = {0.5}, .size_z = {0.25}},
                 .life = {.size = {1, {}, {{0, 1}, {1, 0}}}, .fast = 10, .size_by_speed = {{0, 1}, {1, 5}}}};
  const Emission emission(def, 1);
  // 2 * 2 at half of the cycle, 3/4 at a quarter of its life, 3 at half of the speed.
  EXPECT_TRUE(near(emission.look(0, 0.5, 8, 2, 5).size, {9, 4.5, 2.25}, 1e-15));
  EXPECT_TRUE(near(emission.look(0, 0.5, 8, 2, 500).size, {15, 7.5, 3.75}, 1e-15));
  EXPECT_EQ(emission.look(0, 0.5, 8, 8, 0).size, Vec3d{});
  EXPECT_EQ(emission.look(0, 0.5, kInfinity, 1, 0).size, Vec3d{});  // over 1 s where there is no end
  EXPECT_TRUE(near(emission.look(0, 0.5, kInfinity, 0.25, 5).size, {9, 4.5, 2.25}, 1e-15));
}

TEST(Emission, turn_is_integrated_over_the_age) {
  EmitterDef def{.start = {.rotation = {0.5}, .rotation_y = {-1}, .rotation_z = {2}},
                 .life = {.turn = {3, {}, parabola()}}};
  const Emission emission(def, 1);
  for (const double age : {0.0, 1.0, 3.7, 8.0})
    EXPECT_TRUE(
        near(emission.look(0, 0, 8, age, 0).rotation, {0.5 + 3 * 8 * test::under_parabola(age / 8), -1, 2}, 1e-14));
  def.life.turn = {3, {}, {{0, 0}, {1, 1}}};  // to 3 rad/s in the first second, and on
  EXPECT_NEAR(Emission(def, 1).look(0, 0, kInfinity, 11, 0).rotation.x, 0.5 + 1.5 + 30, 1e-13);
  def.life.turn = {3, 5.0};  // a rate of each particle's own
  const Emission drawn(def, 1);
  for (std::uint64_t i = 0; i < 100; ++i) {
    const double one = drawn.look(i, 0, 8, 1, 0).rotation.x - 0.5, four = drawn.look(i, 0, 8, 4, 0).rotation.x - 0.5;
    EXPECT_TRUE(one > 3 && one < 5);
    EXPECT_NEAR(four, 4 * one, 1e-13);
  }
}

TEST(Emission, flipped_ones_turn_the_other_way) {
  const Emission emission({.start = {.rotation = {0.5}, .rotation_y = {1}, .flipped = 0.2}, .life = {.turn = {2}}}, 1);
  int flipped = 0;
  const int n = 100'000;
  for (int i = 0; i < n; ++i) {
    const Vec3d r = emission.look(std::uint64_t(i), 0, 5, 1, 0).rotation;
    ASSERT_TRUE(r == (Vec3d{2.5, 1, 0}) || r == (Vec3d{-2.5, -1, 0}));
    flipped += r.x < 0;
  }
  EXPECT_NEAR(flipped, 0.2 * n, 4 * std::sqrt(0.16 * n));
}

TEST(Emission, colours_are_multiplied) {
  EmitterDef def{.start = {.colour = {0xff8040ff, {}, {{0, 0xffffffff}, {1, 0x00ffffff}}}},
                 .life = {.colour = {0xffffffff, {}, {{0, 0xffffffff}, {1, 0xffffff00}}},
                          .fast = 20,
                          .colour_by_speed = {{0, 0xffffffff}, {1, 0xff00ffff}}}};
  const Emission emission(def, 1);
  EXPECT_EQ(emission.look(0, 0, 4, 0, 0).colour, 0xff8040ffu);
  EXPECT_EQ(emission.look(0, 0.5, 4, 0, 0).colour, 0x808040ffu);
  EXPECT_EQ(emission.look(0, 0, 4, 2, 0).colour, 0xff804080u);
  EXPECT_EQ(emission.look(0, 0, 4, 0, 10).colour, 0xff4040ffu);
  EXPECT_EQ(emission.look(0, 0, 4, 0, 1000).colour, 0xff0040ffu);
  EXPECT_EQ(Emission({}, 1).look(0, 0, 4, 1, 3).colour, 0xffffffffu);
}

TEST(Emission, sub_emitters_fire_by_their_probability_and_count) {
  const Emission emission({.subs = {{.count = {2, 4.0}, .probability = 0.25}, {.count = {3}}, {.probability = 0}}}, 6);
  const double n = 400'000;
  std::vector<double> counts(5);
  double both = 0;
  for (std::uint64_t i = 0; i < 200'000; ++i) {
    const std::uint32_t first = emission.fired_by(0, i, 0), second = emission.fired_by(0, i, 1);
    ++counts[first], ++counts[second];
    both += first > 0 && second > 0;
    ASSERT_EQ(emission.fired_by(1, i, 0), 3u);
    ASSERT_EQ(emission.fired_by(2, i, 0), 0u);
  }
  EXPECT_EQ(counts[1], 0);
  EXPECT_TRUE(test::as_expected({counts[0], counts[2], counts[3], counts[4]}, {0.75 * n, n / 16, n / 8, n / 16}));
  EXPECT_NEAR(both, 200'000 / 16.0, 4 * std::sqrt(200'000 / 16.0));  // each event draws for itself
}

// ------------------------------------------------------------------------------------------------- every row
/// Something of everything, so that a row that changes finds what it acts on.
EmitterDef of_everything() {
  EmitterDef def;
  def.cycle = {.duration = 2, .looping = false};
  def.per_second = {20};
  def.bursts = {{.time = 0.1, .count = {3}, .cycles = 3, .interval = 0.2}};
  def.gun = {.rounds_per_minute = 600, .burst_rounds = 3, .burst_pause = 0.1, .magazine = 6, .reload = 0.5};
  def.gun.barrels = {{{0, 1, 0}}, {{0, -1, 0}}};
  def.gun.recoil_up = {{0, 1}};
  def.gun.recoil = 0.05;
  def.from = {.shape = EmitShape::cone};
  def.start.rotation = {1};
  def.life.fast = 3;
  def.life.size_by_speed = {{0, 1}, {1, 2}};
  def.flight = {.drag = {0.3}, .fast = 9, .drag_by_speed = {{0, 0.5}, {1, 1}}, .limit = {4}, .noise = {1}};
  def.flight.noise_octaves = 2;
  def.subs = {{}};
  return def;
}

/// All that comes of a definition.
std::uint64_t what_comes_of(const EmitterDef& def) {
  EXPECT_TRUE(check(def)) << check(def).error().text();
  const Emission emission(def, 5);
  const Timeline timeline(emission);
  TimelineState state = timeline.begin(0);
  Hash hash;
  const auto add = [&hash](const Vec3d& v) { hash.add(v.x), hash.add(v.y), hash.add(v.z); };
  std::uint64_t number = 0;
  for (auto next = timeline.next(state); next && number < 300; next = timeline.next(state)) {
    for (std::uint32_t i = 0; i < next->count; ++i, ++number) {
      const Birth birth{number, next->time, next->phase, i, next->count, next->is_round, next->round};
      const Newborn n = emission.newborn(birth);
      const Look look = emission.look(number, next->phase, n.lifetime, 0.3, 2);
      hash.add(next->time), hash.add(next->phase), hash.add(n.tracer ? 1.0 : 0.0);
      const InFlight particle{number, 0, n.lifetime};
      add(emission.flight().acceleration(particle, 0.3, {n.place, n.direction * n.speed, {0, -9, 0}, 0.1}));
      add(emission.flight().added_velocity(particle, 0.3));
      add(n.place), add(n.direction), add(look.size), add(look.rotation);
      hash.add(n.speed), hash.add(n.lifetime), hash.add(n.gravity), hash.add(next->count, look.colour);
      for (std::size_t sub = 0; sub < def.subs.size(); ++sub) hash.add(emission.fired_by(sub, number, 0), 0u);
    }
    timeline.take(state);
  }
  return hash.value();
}

struct Row {
  const char* name;
  std::function<void(EmitterDef&)> change;
};
void PrintTo(const Row& row, std::ostream* out) { *out << row.name; }

class EmitterRow : public testing::TestWithParam<Row> {};

TEST_P(EmitterRow, counts) {
  EmitterDef def = of_everything();
  const std::uint64_t before = what_comes_of(def);
  EXPECT_EQ(before, what_comes_of(of_everything()));
  GetParam().change(def);
  EXPECT_NE(before, what_comes_of(def));
}

/// A row about a shape, on that shape.
auto on(EmitShape shape, const std::function<void(EmitFrom&)>& change, ArcMode mode = ArcMode::random) {
  return [shape, change, mode](EmitterDef& def) {
    def.from = {.shape = shape, .thickness = 0.5, .arc_mode = mode};
    const std::uint64_t before = what_comes_of(def);
    change(def.from);
    EXPECT_NE(before, what_comes_of(def));
  };
}

const Row kWhen[] = {
    {"cycle_duration", [](EmitterDef& d) { d.cycle.duration = 1.5; }},
    {"cycle_looping", [](EmitterDef& d) { d.cycle.looping = true; }},
    {"cycle_delay", [](EmitterDef& d) { d.cycle.delay = {0.5}; }},
    {"per_second", [](EmitterDef& d) { d.per_second = {21}; }},
    {"per_second_to", [](EmitterDef& d) { d.per_second.to = 30; }},
    {"per_second_curve", [](EmitterDef& d) { d.per_second.curve = parabola(); }},
    {"burst_time", [](EmitterDef& d) { d.bursts[0].time = 0.2; }},
    {"burst_count", [](EmitterDef& d) { d.bursts[0].count = {4}; }},
    {"burst_cycles", [](EmitterDef& d) { d.bursts[0].cycles = 4; }},
    {"burst_interval", [](EmitterDef& d) { d.bursts[0].interval = 0.3; }},
    {"burst_probability", [](EmitterDef& d) { d.bursts[0].probability = 0.1; }},
    {"gun_rounds_per_minute", [](EmitterDef& d) { d.gun.rounds_per_minute = 700; }},
    {"gun_burst_rounds", [](EmitterDef& d) { d.gun.burst_rounds = 2; }},
    {"gun_burst_pause", [](EmitterDef& d) { d.gun.burst_pause = 0.2; }},
    {"gun_magazine", [](EmitterDef& d) { d.gun.magazine = 4; }},
    {"gun_reload", [](EmitterDef& d) { d.gun.reload = 0.7; }},
    {"gun_magazines", [](EmitterDef& d) { d.gun.magazines = 1; }},
};
const Row kWhere[] = {
    {"gun_dispersion", [](EmitterDef& d) { d.gun.dispersion = 0.01; }},
    {"gun_tracer_every", [](EmitterDef& d) { d.gun.tracer_every = 3; }},
    {"gun_barrels", [](EmitterDef& d) { d.gun.barrels.pop_back(); }},
    {"gun_convergence", [](EmitterDef& d) { d.gun.convergence = 100; }},
    {"gun_recoil", [](EmitterDef& d) { d.gun.recoil = 0.1; }},
    {"gun_recoil_up", [](EmitterDef& d) { d.gun.recoil_up[0].value = 2; }},
    {"gun_recoil_right",
     [](EmitterDef& d) {
       d.gun.recoil_right = {{0, 1}};
     }},
    {"from_shape", [](EmitterDef& d) { d.from.shape = EmitShape::circle; }},
    {"from_radius", on(EmitShape::sphere, [](EmitFrom& f) { f.radius = 2; })},
    {"from_angle", on(EmitShape::cone, [](EmitFrom& f) { f.angle = 0.3; })},
    {"from_tube", on(EmitShape::ring, [](EmitFrom& f) { f.tube = 0.3; })},
    {"from_size", on(EmitShape::box, [](EmitFrom& f) { f.size.y = 3; })},
    {"from_length", on(EmitShape::line, [](EmitFrom& f) { f.length = 3; })},
    {"from_thickness", on(EmitShape::hemisphere, [](EmitFrom& f) { f.thickness = 0; })},
    {"from_arc", on(EmitShape::circle, [](EmitFrom& f) { f.arc = 3; })},
    {"from_arc_mode", on(EmitShape::circle, [](EmitFrom& f) { f.arc_mode = ArcMode::loop; })},
    {"from_arc_speed", on(
                           EmitShape::circle, [](EmitFrom& f) { f.arc_speed = 3; }, ArcMode::ping_pong)},
    {"from_randomise", [](EmitterDef& d) { d.from.randomise = 0.1; }},
};
const Row kWhat[] = {
    {"start_lifetime", [](EmitterDef& d) { d.start.lifetime = {6}; }},
    {"start_speed", [](EmitterDef& d) { d.start.speed = {6}; }},
    {"start_size", [](EmitterDef& d) { d.start.size = {6}; }},
    {"start_size_y", [](EmitterDef& d) { d.start.size_y = {6}; }},
    {"start_size_z", [](EmitterDef& d) { d.start.size_z = {6}; }},
    {"start_rotation", [](EmitterDef& d) { d.start.rotation = {6}; }},
    {"start_rotation_y", [](EmitterDef& d) { d.start.rotation_y = {6}; }},
    {"start_rotation_z", [](EmitterDef& d) { d.start.rotation_z = {6}; }},
    {"start_flipped", [](EmitterDef& d) { d.start.flipped = 0.5; }},
    {"start_colour", [](EmitterDef& d) { d.start.colour = {0x123456ff}; }},
    {"start_gravity", [](EmitterDef& d) { d.start.gravity = {6}; }},
    {"life_size", [](EmitterDef& d) { d.life.size = {6}; }},
    {"life_turn", [](EmitterDef& d) { d.life.turn = {6}; }},
    {"life_colour", [](EmitterDef& d) { d.life.colour = {0x123456ff}; }},
    {"life_fast", [](EmitterDef& d) { d.life.fast = 9; }},
    {"life_size_by_speed",
     [](EmitterDef& d) {
       d.life.size_by_speed = {{0, 2}};
     }},
    {"life_colour_by_speed",
     [](EmitterDef& d) {
       d.life.colour_by_speed = {{0, 0x123456ff}};
     }},
    {"sub_count", [](EmitterDef& d) { d.subs[0].count = {2}; }},
    {"sub_probability", [](EmitterDef& d) { d.subs[0].probability = 0.5; }},
};

const Row kFlight[] = {
    {"flight_drag", [](EmitterDef& d) { d.flight.drag = {1}; }},
    {"flight_fast", [](EmitterDef& d) { d.flight.fast = 6; }},
    {"flight_drag_by_speed", [](EmitterDef& d) { d.flight.drag_by_speed[1].value = 2; }},
    {"flight_gravity", [](EmitterDef& d) { d.flight.gravity = {0.5}; }},
    {"flight_velocity_x", [](EmitterDef& d) { d.flight.velocity_x = {1}; }},
    {"flight_velocity_y", [](EmitterDef& d) { d.flight.velocity_y = {1}; }},
    {"flight_velocity_z", [](EmitterDef& d) { d.flight.velocity_z = {1}; }},
    {"flight_force_x", [](EmitterDef& d) { d.flight.force_x = {1}; }},
    {"flight_force_y", [](EmitterDef& d) { d.flight.force_y = {1}; }},
    {"flight_force_z", [](EmitterDef& d) { d.flight.force_z = {1}; }},
    {"flight_limit", [](EmitterDef& d) { d.flight.limit = {3}; }},
    {"flight_limit_rate", [](EmitterDef& d) { d.flight.limit_rate = 5; }},
    {"flight_noise", [](EmitterDef& d) { d.flight.noise = {2}; }},
    {"flight_noise_size", [](EmitterDef& d) { d.flight.noise_size = 2; }},
    {"flight_noise_rate", [](EmitterDef& d) { d.flight.noise_rate = 2; }},
    {"flight_noise_octaves", [](EmitterDef& d) { d.flight.noise_octaves = 3; }},
    {"flight_noise_gain", [](EmitterDef& d) { d.flight.noise_gain = 0.7; }},
};

std::string row_name(const testing::TestParamInfo<Row>& info) { return info.param.name; }
INSTANTIATE_TEST_SUITE_P(When, EmitterRow, testing::ValuesIn(kWhen), row_name);
INSTANTIATE_TEST_SUITE_P(Where, EmitterRow, testing::ValuesIn(kWhere), row_name);
INSTANTIATE_TEST_SUITE_P(What, EmitterRow, testing::ValuesIn(kWhat), row_name);
INSTANTIATE_TEST_SUITE_P(Flight, EmitterRow, testing::ValuesIn(kFlight), row_name);

TEST(Emission, looks_of_a_pack_are_those_of_each) {
  constexpr std::size_t kPack = Looks::kPack;
  test::Random r(4);
  for (int round = 0; round < 50; ++round) {
    const Emission emission(test::random_emitter(r, {}, {}), 9);
    LookPack<kPack> pack{};
    pack.time = r.in(0, 100);
    for (std::size_t i = 0; i < kPack; ++i) {
      pack.number[i] = 1000 * static_cast<std::uint64_t>(r.below(5)) + i;
      pack.phase[i] = r.in(0, 1), pack.lifetime[i] = r.one_in(9) ? kInfinity : r.in(1, 4);
      pack.birth[i] = pack.time - r.in(-0.1, 1), pack.speed[i] = r.in(0, 60);
    }
    Looks(emission).put(pack, {});
    for (std::size_t i = 0; i < kPack; ++i) {
      const double age = std::max(pack.time - pack.birth[i], 0.0);
      const Look alone = emission.look(pack.number[i], pack.phase[i], pack.lifetime[i], age, pack.speed[i]);
      EXPECT_EQ((Vec3d{pack.size[0][i], pack.size[1][i], pack.size[2][i]}), alone.size);
      EXPECT_EQ((Vec3d{pack.rotation[0][i], pack.rotation[1][i], pack.rotation[2][i]}), alone.rotation);
      EXPECT_EQ(pack.colour[i], alone.colour);
    }
  }
}

TEST(Emission, newborns_of_a_pack_are_those_of_each) {
  constexpr std::size_t kPack = NewbornPack::kLanes;
  test::Random r(11);
  std::size_t compared = 0;
  const std::vector<std::string> names = kernels();
  for (int round = 0; round < 400; ++round) {
    ASSERT_TRUE(use_kernel(names[static_cast<std::size_t>(round) % names.size()]));
    EmitterDef def = test::random_emitter(r, {}, {});
    def.start.gravity = {1};
    if (r.one_in(3)) def.from.size = r.vector(3), def.from.size = {std::abs(def.from.size.x), 0, 2};
    if (r.one_in(4)) def.from.radius = 0, def.from.tube = 0;
    const Emission emission(def, 9);
    ASSERT_TRUE(emission.leaves_gravity());
    NewbornPack pack{};
    for (std::size_t i = 0; i < kPack; ++i) {
      pack.number[i] = 1000 * static_cast<std::uint64_t>(r.below(5)) + i;
      pack.time[i] = r.in(0, 1e4), pack.phase[i] = r.in(0, 1);
      pack.moment[i] = static_cast<std::uint32_t>(1 + r.below(9));
      pack.of_moment[i] = static_cast<std::uint32_t>(r.below(static_cast<int>(pack.moment[i])));
    }
    if (r.one_in(2)) pack.count = static_cast<std::size_t>(1 + r.below(kPack));
    emission.newborns(pack);
    for (std::size_t i = 0; i < pack.count; ++i) {
      const Newborn alone = emission.newborn(pack.birth(i));
      ASSERT_TRUE(test::same_bits(Vec3d{pack.place[0][i], pack.place[1][i], pack.place[2][i]}, alone.place));
      ASSERT_TRUE(
          test::same_bits(Vec3d{pack.direction[0][i], pack.direction[1][i], pack.direction[2][i]}, alone.direction));
      ASSERT_EQ(pack.speed[i], alone.speed);
      ASSERT_EQ(pack.lifetime[i], alone.lifetime);
      ++compared;
    }
  }
  use_kernel("");
  EXPECT_GT(compared, 250 * kPack);
}

}  // namespace physim::emit_emission_test
