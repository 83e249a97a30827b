// Looks of particles in columns: those of each particle by what can be known of it from outside, for emitters whose
// looks depend on draws, on the cycle, on age and on what was inherited, and through saves and snapshots.
#include "emit/emission.hpp"
#include "world/emitter_support.hpp"

namespace physim::world_emitter_looks_test {

constexpr double kDuration = 0.5, kRate = 200, kLife = 0.8;

struct Looks {
  std::vector<Vec3d> size;
  std::vector<std::uint32_t> colour;
  std::vector<double> age;
  std::vector<std::uint64_t> number;
  explicit Looks(std::size_t count) : size(count), colour(count), age(count), number(count) {}
  bool operator==(const Looks&) const = default;
};
Looks looks_of(const World& world, EmitterId emitter) {
  Looks looks(world.particles(emitter, {}));
  world.particles(emitter, {.size = looks.size, .colour = looks.colour, .age = looks.age, .number = looks.number});
  return looks;
}

/// Sizes and colours are drawn, and follow age.
EmitterDef drawing(KindId kind) {
  EmitterDef def = spray(kind, kRate, kLife);
  def.cycle.duration = kDuration;
  def.start.size = {0.5, 1.5};
  def.start.colour.to = 0x00ff80ff;
  def.life.size = {1, {}, {{0, 1}, {1, 0.25}}};
  def.life.colour.gradient = {{0, 0xfff0a0ff}, {0.4, 0xff804080}, {1, 0xff280000}};
  return def;
}
/// Sizes follow the cycle, too.
EmitterDef cycling(KindId kind) {
  EmitterDef def = drawing(kind);
  def.start.size = {1, {}, {{0, 1}, {1, 3}}};
  return def;
}

/// But for the rounding of what is known of a particle from outside.
void expect_near(std::uint32_t colour, std::uint32_t wanted) {
  for (int shift = 0; shift < 32; shift += 8)
    EXPECT_LE(std::abs(static_cast<int>(colour >> shift & 0xff) - static_cast<int>(wanted >> shift & 0xff)), 1);
}

double phase_of(double birth) { return std::fmod(birth, kDuration) / kDuration; }

void expect_looks(const Looks& looks, const EmitterDef& def) {
  const Emission emission(def, *def.seed);
  const bool cycles = !def.start.size.curve.empty();
  EXPECT_GT(looks.size.size(), 100u);
  for (std::size_t i = 0; i < looks.size.size() && !testing::Test::HasFailure(); ++i) {
    const double birth = static_cast<double>(looks.number[i] + 1) / kRate;
    const Look alone = emission.look(looks.number[i], cycles ? phase_of(birth) : 0.75, kLife, looks.age[i], 0);
    EXPECT_NEAR(looks.size[i].x, alone.size.x, 1e-9) << looks.number[i];
    EXPECT_NEAR(looks.size[i].z, alone.size.z, 1e-9);
    expect_near(looks.colour[i], alone.colour);
  }
}

/// Two emitters, and one of half the size and of another colour whose particles come of those of the first.
struct Fireworks {
  World world = make_world({.ground = {.mode = GroundMode::none}});
  KindId kind = kind_of(world, spark());
  EmitterDef first = cycling(kind), second = drawing(kind), heir = drawing(kind);
  EmitterId heir_id, first_id, second_id;
  Fireworks() {
    heir.seed = 9;
    heir.cycle.plays = false;
    heir_id = added(world, heir);
    first.subs = {{.on = SubEvent::birth, .emitter = heir_id, .inherit_colour = true, .inherit_size = true}};
    first_id = added(world, first);
    second_id = added(world, second);
  }
  [[nodiscard]] std::vector<Looks> all() const {
    return {looks_of(world, first_id), looks_of(world, second_id), looks_of(world, heir_id)};
  }
};

TEST(EmitterLooks, columns_have_the_looks_of_each_particle) {
  Fireworks f;
  for (const double time : {0.7, 1.3}) {
    step_to(f.world, time, 60);
    expect_looks(looks_of(f.world, f.first_id), f.first);
    expect_looks(looks_of(f.world, f.second_id), f.second);
  }
}

TEST(EmitterLooks, what_is_inherited_counts_for_those_who_inherit_alone) {
  Fireworks f;
  step_to(f.world, 0.7, 60);
  const Looks looks = looks_of(f.world, f.heir_id);
  const Emission emission(f.heir, *f.heir.seed), parents(f.first, *f.first.seed);
  ASSERT_GT(looks.size.size(), 100u);
  for (std::size_t i = 0; i < looks.size.size(); ++i) {
    const double birth = static_cast<double>(looks.number[i] + 1) / kRate;
    const Look own = emission.look(looks.number[i], 0, kLife, looks.age[i], 0);
    const Look parent = parents.look(looks.number[i], phase_of(birth), kLife, 0, 0);  // each has one heir
    EXPECT_NEAR(looks.size[i].x, own.size.x * parent.size.x, 1e-9);
    expect_near(looks.colour[i], times(own.colour, parent.colour));
  }
}

TEST(EmitterLooks, go_through_saves_and_snapshots) {
  Fireworks f;
  step_to(f.world, 0.7, 60);
  const std::vector<Looks> before = f.all();
  const Snapshot snapshot = f.world.snapshot();
  const auto saved = must(f.world.save());
  step_to(f.world, 1, 60);
  EXPECT_NE(f.all(), before);
  const std::vector<Looks> after = f.all();
  ASSERT_TRUE(f.world.restore(snapshot));
  EXPECT_EQ(f.all(), before);
  f.world = must(World::load(saved));
  EXPECT_EQ(f.all(), before);
  step_to(f.world, 1, 60);
  EXPECT_EQ(f.all(), after);
}

/// A vertex as a renderer might have it.
struct Sprite {
  float fade = 1;
  Vec3d position{};
  std::uint32_t colour = 0;
  std::uint64_t number = 0;
};

TEST(EmitterLooks, go_into_members_of_structs) {
  Fireworks f;
  step_to(f.world, 0.7, 60);
  const std::size_t count = f.world.particles(f.first_id, {});
  ASSERT_GT(count, 40u);
  std::vector<Vec3d> position(count);
  std::vector<std::uint32_t> colour(count);
  std::vector<std::uint64_t> number(count);
  f.world.particles(f.first_id, {.position = position, .colour = colour, .number = number});
  for (const std::size_t room : {count + 7, count, count - 5, std::size_t{1}, std::size_t{0}}) {
    std::vector<Sprite> sprites(room);
    const Column<Vec3d> places{sprites, &Sprite::position};
    EXPECT_EQ(f.world.particles(
                  f.first_id,
                  {.position = places, .colour = {sprites, &Sprite::colour}, .number = {sprites, &Sprite::number}}),
              count);
    for (std::size_t i = 0; i < room; ++i) {
      EXPECT_EQ(sprites[i].fade, 1) << i;
      EXPECT_EQ(sprites[i].position, i < count ? position[i] : Vec3d{}) << i;
      EXPECT_EQ(sprites[i].colour, i < count ? colour[i] : 0) << i;
      EXPECT_EQ(sprites[i].number, i < count ? number[i] : 0) << i;
    }
  }
  std::vector<double> mixed(3 * count, -1);  // every third number
  std::vector<double> age(count);
  f.world.particles(f.first_id, {.age = age});
  f.world.particles(f.first_id, {.age = {mixed.data() + 1, count, 3 * sizeof(double)}});
  for (std::size_t i = 0; i < count; ++i) {
    EXPECT_EQ(mixed[3 * i + 1], age[i]);
    EXPECT_EQ(mixed[3 * i + 2], -1);
  }
}

TEST(EmitterLooks, come_from_far_to_near_of_an_eye) {
  Fireworks f;
  step_to(f.world, 0.7, 60);
  const std::size_t count = f.world.particles(f.first_id, {});
  std::vector<ProjectileId> by_index(count), id(count);
  std::vector<Vec3d> position(count), of_index(count);
  std::vector<std::uint32_t> colour(count), colour_of_index(count);
  f.world.particles(f.first_id, {.id = by_index, .position = of_index, .colour = colour_of_index});
  const Vec3d eye{3, 1, -2};
  EXPECT_EQ(f.world.particles(f.first_id, {.id = id, .position = position, .colour = colour, .eye = eye}), count);
  for (std::size_t i = 0; i < count; ++i) {
    if (i > 0) {
      const double before = length(position[i - 1] - eye), now = length(position[i] - eye);
      EXPECT_TRUE(before > now || (before == now && id[i - 1].index < id[i].index)) << i;
    }
    const auto at = std::ranges::find(by_index, id[i]);
    ASSERT_NE(at, by_index.end());
    EXPECT_EQ(position[i], of_index[static_cast<std::size_t>(at - by_index.begin())]);
    EXPECT_EQ(colour[i], colour_of_index[static_cast<std::size_t>(at - by_index.begin())]);
  }
  EXPECT_NE(id, by_index);
  std::vector<ProjectileId> farthest(3);
  f.world.particles(f.first_id, {.id = farthest, .eye = eye});
  EXPECT_TRUE(std::ranges::equal(farthest, std::span(id).first(3)));
  f.world.particles(f.first_id, {.id = id, .eye = Vec3d{test::kNan, 0, 0}});
  EXPECT_EQ(id, by_index) << "all are equally far from nowhere";
}

TEST(EmitterLooks, slots_of_an_emitter_that_is_gone_are_used_again) {
  Fireworks f;
  step_to(f.world, 0.7, 60);
  ASSERT_TRUE(f.world.remove_emitter(f.heir_id));
  ASSERT_TRUE(f.world.remove_emitter(f.first_id));
  EXPECT_EQ(f.world.particles(f.first_id, {}), 0u);
  EmitterDef next = drawing(f.kind);
  next.seed = 21;
  const double began = f.world.time();
  const EmitterId id = added(f.world, next);  // in the place of one that bequeathed
  step_to(f.world, began + 1.2, 60);
  expect_looks(looks_of(f.world, id), next);
  expect_looks(looks_of(f.world, f.second_id), f.second);
}

}  // namespace physim::world_emitter_looks_test
