// Every row of an emitter's definition that a world alone sees: when it plays, where it is, rain, triangles, limits,
// trails and sub-emitters. The others are in emit/emission_test.cpp.
#include <functional>

#include "base/hash.hpp"
#include "math/quat.hpp"
#include "world/emitter_support.hpp"

namespace physim::world_emitter_rows_test {

/// What a show is made of, before it begins: an emitter in front of a wall, and one that fires where something happens
/// to its particles.
struct Stage {
  World world = *World::create({.apex_events = true});
  KindId kind = kind_of(world, spark(), {.restitution = 0.5, .collision = {.on_hit = OnHit::bounce}});
  ProjectileId carrier{};
  EmitterDef heir{};
  EmitterDef def{};
  SubEmitter sub{};

  Stage() {
    Scene scene;
    add_thing(scene, BoxShape{{0.5, 9, 9}}, {.transform = {.position = {5, 9, 0}}});
    EXPECT_TRUE(world.set_scene(scene));
    const auto thrown = must(world.spawn(kind, {.position = {0, 2, 0}, .velocity = Vec3d{0.5, 6, 1}}));
    carrier = thrown;
    heir = spray(kind, 0, 0.2);
    heir.cycle.plays = false;
    def = spray(kind, 20, 0.9);
    def.rotation = {};
    def.position = {0, 2, 0};
    def.start.speed = {7, 9.0};
    sub.on = SubEvent::hit;
  }
};

/// All that can be seen of it in a second and a half.
std::uint64_t what_comes_of(Stage& stage) {
  World& world = stage.world;
  const EmitterId heir = added(world, stage.heir);
  if (!stage.sub.emitter) stage.sub.emitter = heir;
  stage.def.subs = {stage.sub};
  const EmitterId id = added(world, stage.def);
  Hash hash;
  const auto add = [&hash](const Vec3d& v) { hash.add(v.x), hash.add(v.y), hash.add(v.z); };
  for (int frame = 0; frame < 45; ++frame) {
    EXPECT_TRUE(world.step(1.0 / 30));
    hash.add(std::uint64_t{world.emitters().size()});
    for (const EmitterId each : {heir, id}) {
      const std::size_t count = world.particles(each, {});
      std::vector<Vec3d> position(count), velocity(count), size(count);
      std::vector<std::uint32_t> colour(count);
      world.particles(each, {.position = position, .velocity = velocity, .size = size, .colour = colour});
      for (std::size_t i = 0; i < count; ++i) add(position[i]), add(velocity[i]), add(size[i]), hash.add(colour[i], 0u);
      const EmitterCounts counts = world.emitter_counts(each);
      for (const std::uint64_t n : {counts.born, counts.refused, counts.replaced, counts.aged}) hash.add(n);
    }
    std::vector<Vec3d> places(world.trails(id, {}).places);
    world.trails(id, {.position = places});
    for (const Vec3d& place : places) add(place);
  }
  return hash.value();
}

using Change = std::function<void(Stage&)>;
struct Row {
  const char* name;
  Change change;
  Change before = [](Stage&) {};  // what else is so, without the row and with it
};
void PrintTo(const Row& row, std::ostream* out) { *out << row.name; }

class EmitterWorldRow : public testing::TestWithParam<Row> {};

TEST_P(EmitterWorldRow, counts) {
  std::uint64_t hash[3];
  for (int i = 0; i < 3; ++i) {
    Stage stage;
    GetParam().before(stage);
    if (i == 2) GetParam().change(stage);
    hash[i] = what_comes_of(stage);
  }
  EXPECT_EQ(hash[0], hash[1]);
  EXPECT_NE(hash[0], hash[2]);
}

void moves(Stage& s) { s.def.motion = SteadyMotion{.velocity = {0, 1, 3}}; }
void is_full(Stage& s) { s.def.maximum = 9; }
void plays_once(Stage& s) { s.def.cycle = {.duration = 0.3, .looping = false}; }
void rains(Stage& s) {
  s.def.per_second = {0};
  s.def.rotation = quat_from_axis_angle(Vec3d{0, 0, 1}, -1.5707963267948966);
  s.def.rain = {.density = 0.2, .size = {8, 8, 8}};
}
void has_trails(Stage& s) { s.def.trail = {.points = 20}; }
void has_mesh(Stage& s) {
  MeshShape tent{{{0, 0, 0}, {1, 0, 0}, {0.5, 1, 0.5}, {0, 0, 1}}, {{0, 2, 1}, {0, 3, 2}, {1, 2, 3}}, {}};
  s.def.from = {.shape = EmitShape::mesh, .surface = {.shape = *SharedShape::make(tent)}};
}
void has_terrain(Stage& s) {
  const HeightFieldShape hill{3, 3, 1, 1, {0, 0, 0, 0, 1, 0, 0, 0, 0}};
  s.def.from = {.shape = EmitShape::terrain, .surface = {.shape = *SharedShape::make(hill)}};
}
void fires_aged(Stage& s) { s.sub = {.on = SubEvent::age, .age = 0.2}; }
void has_looks(Stage& s) { s.def.start.size = {2}, s.def.start.colour = {0x808080ff}; }

const Row kPlaying[] = {
    {"kind", [](Stage& s) { s.def.kind = kind_of(s.world, spark(), {.gravity_scale = 0.5}); }},
    {"launch_rail_length", [](Stage& s) { s.def.launch.rail_length = 0.3; },
     [](Stage& s) { s.def.kind = kind_of(s.world, spark(Motion::force)); }},
    {"cycle_prewarm", [](Stage& s) { s.def.cycle.prewarm = true; }, [](Stage& s) { s.def.cycle.duration = 0.6; }},
    {"cycle_rate", [](Stage& s) { s.def.cycle.rate = 2; }},
    {"cycle_plays", [](Stage& s) { s.def.cycle.plays = false; }},
    {"cycle_stop", [](Stage& s) { s.def.cycle.stop = StopAction::remove; }, plays_once},
    {"seed", [](Stage& s) { s.def.seed = 8; }},
    {"position", [](Stage& s) { s.def.position.y = 3; }},
    {"rotation",
     [](Stage& s) {
       s.def.rotation = {1, 0, 0.1, 0};
     }},
    {"motion", [](Stage& s) { moves(s); }},
    {"follows", [](Stage& s) { s.def.follows = s.carrier; }},
    {"inherit_velocity", [](Stage& s) { s.def.inherit_velocity = 0.5; }, moves},
    {"per_metre", [](Stage& s) { s.def.per_metre = 2; }, moves},
    {"maximum", [](Stage& s) { s.def.maximum = 10; }, is_full},
    {"when_full", [](Stage& s) { s.def.when_full = WhenFull::replace_oldest; }, is_full},
};
const Row kPlaces[] = {
    {"rain_density", [](Stage& s) { s.def.rain.density = 0.3; }, rains},
    {"rain_size", [](Stage& s) { s.def.rain.size.x = 9; }, rains},
    {"rain_drift", [](Stage& s) { s.def.rain.drift.x = 2; }, rains},
    {"rain_shelter", [](Stage& s) { s.def.rain.shelter = 20; },
     [](Stage& s) {
       rains(s), s.def.position = {5, 9, 0};
     }},
    {"from_surface_shape", [](Stage& s) { has_mesh(s); },
     [](Stage& s) {
       has_mesh(s);
       s.def.from.surface.shape = *SharedShape::make(MeshShape{{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}, {{0, 1, 2}}, {}});
     }},
    {"from_surface_scale", [](Stage& s) { s.def.from.surface.scale = 2; }, has_mesh},
    {"from_surface_along", [](Stage& s) { s.def.from.surface.along = EmitAlong::smooth; }, has_mesh},
    {"from_surface_low_x", [](Stage& s) { s.def.from.surface.low_x = 0.5; }, has_terrain},
    {"from_surface_high_x", [](Stage& s) { s.def.from.surface.high_x = 1.5; }, has_terrain},
    {"from_surface_low_z", [](Stage& s) { s.def.from.surface.low_z = 0.5; }, has_terrain},
    {"from_surface_high_z", [](Stage& s) { s.def.from.surface.high_z = 1.5; }, has_terrain},
    {"trail_points", [](Stage& s) { s.def.trail.points = 3; }, has_trails},
    {"trail_time", [](Stage& s) { s.def.trail.time = 0.1; }, has_trails},
    {"trail_distance", [](Stage& s) { s.def.trail.distance = 0.7; }, has_trails},
};
const Row kSubs[] = {
    {"sub_on_birth", [](Stage& s) { s.sub.on = SubEvent::birth; }},
    {"sub_on_bounce", [](Stage& s) { s.sub.on = SubEvent::bounce; }},  // after the hit: faster along the wall
    {"sub_on_landing", [](Stage& s) { s.sub.on = SubEvent::landing; }},
    {"sub_on_apex", [](Stage& s) { s.sub.on = SubEvent::apex; }},
    {"sub_on_death", [](Stage& s) { s.sub.on = SubEvent::death; }},
    {"sub_on_age", [](Stage& s) { s.sub.on = SubEvent::age; }, [](Stage& s) { s.sub.age = 0.2; }},
    {"sub_emitter",
     [](Stage& s) {
       EmitterDef other = s.heir;
       other.start.speed = {1};
       s.sub.emitter = added(s.world, other);
     }},
    {"sub_age", [](Stage& s) { s.sub.age = 0.3; }, fires_aged},
    {"sub_axis", [](Stage& s) { s.sub.axis = SubAxis::normal; }},
    {"sub_axis_velocity", [](Stage& s) { s.sub.axis = SubAxis::velocity; }},
    {"sub_inherit_velocity", [](Stage& s) { s.sub.inherit_velocity = 0.5; }},
    {"sub_inherit_colour", [](Stage& s) { s.sub.inherit_colour = true; }, has_looks},
    {"sub_inherit_size", [](Stage& s) { s.sub.inherit_size = true; }, has_looks},
};

std::string row_name(const testing::TestParamInfo<Row>& info) { return info.param.name; }
INSTANTIATE_TEST_SUITE_P(Playing, EmitterWorldRow, testing::ValuesIn(kPlaying), row_name);
INSTANTIATE_TEST_SUITE_P(Places, EmitterWorldRow, testing::ValuesIn(kPlaces), row_name);
INSTANTIATE_TEST_SUITE_P(Subs, EmitterWorldRow, testing::ValuesIn(kSubs), row_name);

}  // namespace physim::world_emitter_rows_test
