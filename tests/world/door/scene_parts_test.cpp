// Compounds whose parts are of different materials: against closed forms, and against things of their own.
#include <map>

#include "collide/scene_support.hpp"
#include "world/thing_support.hpp"

namespace physim::world_scene_parts_test {

using test::Random;
using namespace test_things;

constexpr double kG = 9.80665;
constexpr double kStep = 1.0 / 120;
constexpr double kSpeed = 780;  // [m/s]

Material plate(const std::string& name, double limit) {
  return {.name = name, .penetration = BallisticLimitDef{.speed = limit, .a = 1, .p = 2}};
}
const Material kWood = plate("wood", 300), kSteel = plate("steel", 1200), kTin = plate("tin", 400);
/// Recht and Ipson, without a plug; `limit` over the cosine of the obliquity.
double behind(double speed, double limit) { return std::sqrt(speed * speed - limit * limit); }

World world_with(const Scene& scene, double g = 0) {
  WorldDef def = nothing_but_things();
  def.environment.gravity = {.model = GravityModel::constant, .acceleration = g};
  if (g == 0) def.environment.gravity.model = GravityModel::off;
  return make_world(def, scene);
}

/// A box from one corner to the opposite one, and what it is made of; none: the thing's.
struct Block {
  Vec3d low, high;
  const Material* material = nullptr;
};

/// A scene of one compound of blocks, turned, scaled and moved as a whole; the thing is of tin.
Scene of_parts(const std::vector<Block>& blocks, const Transform& at = {}, const SceneMotion& motion = {}) {
  Scene scene;
  const MaterialId tin = *scene.add_material(kTin);
  std::map<const Material*, MaterialId> materials;
  CompoundShape shape;
  for (const Block& b : blocks) {
    shape.parts.push_back({*scene.add_shape(BoxShape{(b.high - b.low) * 0.5}), {.position = (b.low + b.high) * 0.5}});
    if (!b.material) continue;
    if (!materials.contains(b.material)) materials[b.material] = *scene.add_material(*b.material);
    shape.parts.back().material = materials[b.material];
  }
  const auto compound = must(scene.add_shape(shape));
  EXPECT_TRUE(scene.add({.shape = compound, .transform = at, .material = tin, .motion = motion}));
  return scene;
}
/// Each block a thing of its own, at the same places.
Scene of_things(const std::vector<Block>& blocks, const Transform& at = {}) {
  Scene scene;
  for (const Block& b : blocks) {
    const ShapeId shape = *scene.add_shape(BoxShape{(b.high - b.low) * 0.5});
    const Vec3d middle = at.position + rotate(normalized(at.rotation), (b.low + b.high) * (0.5 * at.scale));
    const MaterialId material = *scene.add_material(b.material ? *b.material : kTin);
    EXPECT_TRUE(scene.add({.shape = shape, .transform = {middle, at.rotation, at.scale}, .material = material}));
  }
  return scene;
}

struct Told {
  EventKind kind;
  double time;
  Vec3d position, velocity, normal;
  std::string material;
  double depth;
};
std::vector<Told> flown(const Scene& scene, const Launch& launch, const BodyDef& body, double seconds = 0.3,
                        Precision precision = Precision::float64) {
  World world = world_with(scene);
  EXPECT_TRUE(world.spawn(shot(precision), launch, body));
  // Of what is told at one time hits come first: each stands here before what became of it.
  std::vector<Told> hits, outcomes, told;
  for (const Event& e : run_for(world, seconds, kStep)) {
    EXPECT_NE(e.reason, Reason::inside);
    if (e.instance)
      (e.kind == EventKind::hit ? hits : outcomes)
          .push_back({e.kind, e.time, e.position, e.velocity, e.normal, scene.material(e.material).name, e.value});
  }
  EXPECT_EQ(hits.size(), outcomes.size());
  for (std::size_t i = 0; i < std::min(hits.size(), outcomes.size()); ++i)
    told.insert(told.end(), {hits[i], outcomes[i]});
  return told;
}

void expect_same(const std::vector<Told>& a, const std::vector<Told>& b, double near = 1e-9) {
  ASSERT_EQ(a.size(), b.size());
  for (std::size_t i = 0; i < a.size(); ++i) {
    EXPECT_EQ(a[i].kind, b[i].kind) << i;
    EXPECT_EQ(a[i].material, b[i].material) << i;
    EXPECT_NEAR(a[i].time, b[i].time, near) << i;
    EXPECT_NEAR(a[i].depth, b[i].depth, near) << i;
    EXPECT_LT(length(a[i].position - b[i].position), near) << i;
    EXPECT_LT(length(a[i].velocity - b[i].velocity), near * kSpeed) << i;
    EXPECT_LT(length(a[i].normal - b[i].normal), near) << i;
  }
}

// --------------------------------------------------------------------------------------------- side by side
/// A wall of wood with a door of steel beside it, and a lintel that is the thing's own.
const std::vector<Block> kWall = {
    {{50, 0, -2}, {50.1, 2, 0}, &kWood}, {{50, 0, 0}, {50.1, 2, 2}, &kSteel}, {{50, 2, -2}, {50.1, 3, 2}, nullptr}};

TEST(SceneParts, each_lets_through_what_its_material_does) {
  const Scene scene = of_parts(kWall);
  for (const Precision precision : {Precision::float64, Precision::float32})
    for (const double radius : {0.0, 0.003}) {
      const BodyDef body = body_that(OnHit::impact, radius);
      const auto shot_at = [&](double y, double z) {
        return flown(scene, launched({0, y, z}, {kSpeed, 0, 0}), body, 0.3, precision);
      };
      const double near = precision == Precision::float32 ? 1e-3 : 1e-9;
      const auto wood = shot_at(1, -1), steel = shot_at(1, 1), lintel = shot_at(2.5, 0.5);
      ASSERT_EQ(wood.size(), 2u) << radius;
      EXPECT_EQ(wood[1].kind, EventKind::penetrated);
      EXPECT_EQ(wood[1].material, "wood");
      EXPECT_NEAR(wood[1].velocity.x, behind(kSpeed, 300), near);
      EXPECT_NEAR(wood[1].depth, 0.1, near);
      ASSERT_EQ(steel.size(), 2u) << radius;
      EXPECT_EQ(steel[0].material, "steel");
      EXPECT_EQ(steel[1].kind, EventKind::stopped);
      EXPECT_NEAR(steel[1].depth, 0.1 * kSpeed * kSpeed / (1200.0 * 1200), near);
      ASSERT_EQ(lintel.size(), 2u) << radius;
      EXPECT_EQ(lintel[1].material, "tin") << "a part without a material is of the thing's";
      EXPECT_NEAR(lintel[1].velocity.x, behind(kSpeed, 400), near);
    }
}

TEST(SceneParts, each_throws_back_by_its_own_restitution) {
  const Material dull{.name = "dull", .restitution = 0.25, .friction = 0},
      lively{.name = "lively", .restitution = 0.75, .friction = 0};
  const Scene scene = of_parts({{{-2, -1, -1}, {0, 0, 1}, &dull}, {{0, -1, -1}, {2, 0, 1}, &lively}});
  for (const double radius : {0.0, 0.05})
    for (const double x : {-1.0, 1.0}) {
      const auto told = flown(scene, launched({x, 1, 0}, {0, -20, 0}), body_that(OnHit::bounce, radius));
      ASSERT_EQ(told.size(), 2u) << x;
      EXPECT_EQ(told[1].kind, EventKind::bounced);
      EXPECT_EQ(told[1].material, x < 0 ? "dull" : "lively");
      EXPECT_NEAR(told[1].velocity.y, 20 * (x < 0 ? 0.25 : 0.75), 1e-12) << x;
    }
}

/// On ice a ball slides as it came; on what is rough it slides until it rolls, at 5/7 of its speed.
TEST(SceneParts, a_ball_slides_and_rolls_as_the_part_lets_it_that_it_is_on) {
  const Material ice{.name = "ice", .restitution = 0, .friction = 0},
      rough{.name = "rough", .restitution = 0, .friction = 0.5};
  const Scene scene = of_parts({{{-5, -1, -1}, {0, 0, 1}, &ice}, {{0, -1, -1}, {5, 0, 1}, &rough}});
  World world = world_with(scene, kG);
  const double speed = 4, step = 1.0 / 1000, radius = 0.05, friction = 0.5;
  const Launch launch = launched({-3, radius + 1e-6, 0}, {speed, 0, 0});
  const ProjectileId id = *world.spawn(shot(), launch, body_that(OnHit::bounce, radius));
  static_cast<void>(run_for(world, 0.7, step));
  EXPECT_NEAR(world[id].velocity().x, speed, 1e-9) << "on ice";
  static_cast<void>(run_for(world, 1.3, step));
  EXPECT_NEAR(world[id].velocity().x, 5.0 / 7 * speed, 1e-6);
  const double until_it_rolls = 2 * speed / (7 * friction * kG);
  const double slid = 12 * speed * speed / (49 * friction * kG), on_rough = 2.0 - 3 / speed;
  EXPECT_NEAR(world[id].position().x, slid + 5.0 / 7 * speed * (on_rough - until_it_rolls), speed * step)
      << "but for the step over the seam";
}

// --------------------------------------------------------------------------------------------- one behind another
/// Wood, steel that lets through, wood: what each is in a compound it is as a thing, turned and scaled, met aslant.
TEST(SceneParts, one_behind_another_are_what_things_are) {
  Random r(17);
  const Material steel = plate("steel", 350), fir = materials::fir();
  const std::vector<Block> row = {{{0, -9, -9}, {0.1, 9, 9}, &kWood},
                                  {{0.1, -9, -9}, {0.13, 9, 9}, &steel},
                                  {{0.13, -9, -9}, {0.2, 9, 9}, &fir},
                                  {{0.5, -9, -9}, {0.6, 9, 9}, &kWood}};
  std::size_t through = 0;
  for (int i = 0; i < 60; ++i) {
    Transform at = test::random_transform(r, 3);
    at.position.x += 60;
    at.rotation = {1, r.in(-0.2, 0.2), r.in(-0.2, 0.2), r.in(-0.2, 0.2)};
    const Launch launch = launched({0, r.in(-1, 1), r.in(-1, 1)}, {kSpeed, r.in(-30, 30), r.in(-30, 30)});
    for (const double radius : {0.0, 0.003}) {
      const BodyDef body = body_that(OnHit::impact, radius);
      // As they are listed is of no account: they do not overlap.
      auto mixed = row;
      std::swap(mixed[0], mixed[2]);
      const auto things = flown(of_things(row, at), launch, body);
      expect_same(flown(of_parts(row, at), launch, body), things);
      expect_same(flown(of_parts(mixed, at), launch, body), things);
      through += static_cast<std::size_t>(std::ranges::count(things, EventKind::penetrated, &Told::kind));
      if (testing::Test::HasFailure()) FAIL() << i << " " << radius;
    }
  }
  EXPECT_GT(through, 300u);
}

TEST(SceneParts, of_one_material_they_are_as_thick_as_they_are_together) {
  const Scene scene = of_parts({{{50, -1, -1}, {50.1, 1, 1}, &kWood},
                                {{50.1, -1, -1}, {50.15, 1, 1}, &kWood},
                                {{50.14, -1, -1}, {50.2, 1, 1}, &kWood}});
  const auto told = flown(scene, launched({0, 0, 0}, {kSpeed, 0, 0}), body_that(OnHit::impact));
  ASSERT_EQ(told.size(), 2u);
  EXPECT_NEAR(told[1].depth, 0.2, 1e-9);
}

TEST(SceneParts, a_wall_that_comes_towards_a_bullet_is_met_in_its_own_frame) {
  const Scene scene = of_parts({{{100, -5, -5}, {100.1, 5, 5}, &kWood}, {{100.1, -5, -5}, {100.2, 5, 5}, nullptr}}, {},
                               SteadyMotion{.velocity = {-120, 0, 0}});
  const auto told = flown(scene, launched({0, 0, 0}, {kSpeed, 0, 0}), body_that(OnHit::impact));
  ASSERT_EQ(told.size(), 4u);
  const double wood = behind(kSpeed + 120, 300), tin = behind(wood, 400);
  EXPECT_NEAR(told[1].velocity.x, wood - 120, 1e-9);
  EXPECT_NEAR(told[3].velocity.x, tin - 120, 1e-9);
}

// --------------------------------------------------------------------------------------------- overlapping
/// A core of steel in a block of wood: it is there where it is named before the wood.
TEST(SceneParts, the_first_of_parts_that_overlap_is_there) {
  const Material steel = plate("steel", 500);
  const Block wood{{50, -1, -1}, {50.3, 1, 1}, &kWood}, core{{50.1, -0.5, -0.5}, {50.2, 0.5, 0.5}, &steel};
  for (const double radius : {0.0, 0.002}) {
    const BodyDef body = body_that(OnHit::impact, radius);
    const Launch launch = launched({0, 0.1, 0.2}, {kSpeed, 0, 0});
    const auto cored = flown(of_parts({core, wood}), launch, body);
    ASSERT_EQ(cored.size(), 6u) << radius;
    const double first = behind(kSpeed, 300), second = behind(first, 500), third = behind(second, 300);
    const double speeds[] = {first, second, third};
    for (std::size_t i = 0; i < 3; ++i) {
      EXPECT_EQ(cored[2 * i].kind, EventKind::hit);
      EXPECT_EQ(cored[2 * i + 1].kind, EventKind::penetrated);
      EXPECT_EQ(cored[2 * i + 1].material, i == 1 ? "steel" : "wood");
      EXPECT_NEAR(cored[2 * i + 1].velocity.x, speeds[i], 1e-9);
    }
    EXPECT_NEAR(cored[1].depth, 0.1, 1e-9);
    EXPECT_NEAR(cored[3].depth, 0.1, 1e-9);
    EXPECT_NEAR(cored[5].depth, 0.1 - 2 * radius, 1e-9) << "what lies ahead of a ball's front";
    EXPECT_NEAR(cored[2].normal.x, -1, 1e-12);
    const auto whole = flown(of_parts({wood, core}), launch, body);
    ASSERT_EQ(whole.size(), 2u) << radius;
    EXPECT_NEAR(whole[1].depth, 0.3, 1e-9);
  }
}

/// What is thinner than a ball's radius is met behind another part, and behind another thing.
TEST(SceneParts, a_ball_meets_what_is_thin_behind_what_is_thick) {
  const std::vector<Block> row = {{{50, -1, -1}, {50.1, 1, 1}, &kWood}, {{50.1, -1, -1}, {50.101, 1, 1}, nullptr}};
  const Launch launch = launched({0, 0.1, 0.2}, {kSpeed, 0, 0});
  for (const Scene& scene : {of_parts(row), of_things(row)}) {
    const auto told = flown(scene, launch, body_that(OnHit::impact, 0.01));
    ASSERT_EQ(told.size(), 4u);
    EXPECT_NEAR(told[3].velocity.x, behind(behind(kSpeed, 300), 400), 1e-9);
    EXPECT_NEAR(told[3].depth, 0.001, 1e-9);
  }
}

/// A door as thick as the wall that it is set into, turned anyhow: rounding makes neither of both faces the first.
TEST(SceneParts, a_door_that_is_flush_is_met_alone) {
  Random r(23);
  const Material steel = plate("steel", 500);
  const Block wall{{-0.05, -3, -3}, {0.05, 3, 3}, &kWood}, door{{-0.05, -1, -1}, {0.05, 1, 1}, &steel};
  for (int i = 0; i < 100; ++i) {
    const Transform at{{60, 0, 0}, {1, r.in(-0.3, 0.3), r.in(-0.3, 0.3), r.in(-0.3, 0.3)}, 1};
    const Scene scene = of_parts({door, wall}, at);
    for (const double radius : {0.0, 0.003}) {
      const auto told = flown(scene, launched({0, r.in(-0.5, 0.5), r.in(-0.5, 0.5)}, {kSpeed, 0, 0}),
                              body_that(OnHit::impact, radius));
      ASSERT_EQ(told.size(), 2u) << i << " " << radius;
      EXPECT_EQ(told[0].material, "steel") << i;
      const double cosine = -told[0].normal.x;
      EXPECT_NEAR(told[1].velocity.x, behind(kSpeed, 500 / cosine), 1e-9) << i;
      EXPECT_NEAR(told[1].depth, 0.1 / cosine, 1e-9) << i;
    }
  }
}

// --------------------------------------------------------------------------------------------- meshes as parts
/// A closed cube of triangles, of which those that look along -x are of a material of their own.
MeshShape cube(const std::vector<MaterialId>& of_sides) {
  MeshShape m;
  for (unsigned i = 0; i < 8; ++i) m.vertices.push_back({i & 1 ? 1.0 : -1.0, i & 2 ? 1.0 : -1.0, i & 4 ? 1.0 : -1.0});
  m.triangles = {{0, 4, 6}, {0, 6, 2}, {1, 3, 7}, {1, 7, 5}, {0, 1, 5}, {0, 5, 4},
                 {2, 6, 7}, {2, 7, 3}, {0, 2, 3}, {0, 3, 1}, {4, 5, 7}, {4, 7, 6}};
  if (of_sides.empty()) return m;
  m.materials.assign(m.triangles.size(), of_sides[1]);
  m.materials[0] = m.materials[1] = of_sides[0];
  return m;
}

TEST(SceneParts, meshes_keep_the_materials_of_their_triangles) {
  Scene scene;
  const MaterialId wood = *scene.add_material(kWood), tin = *scene.add_material(kTin),
                   steel = *scene.add_material(plate("steel", 500));
  const ShapeId painted = *scene.add_shape(cube({wood, tin})), plain = *scene.add_shape(cube({}));
  const Transform first{.position = {50, 0, 0}, .scale = 0.05}, second{.position = {50.1, 0, 0}, .scale = 0.05};
  const ShapeId both = *scene.add_shape(CompoundShape{{{painted, first, steel}, {plain, second, steel}}});
  ASSERT_TRUE(scene.add({.shape = both, .material = tin}));
  for (const double radius : {0.0, 0.002}) {
    const auto told = flown(scene, launched({0, 0.01, 0.02}, {kSpeed, 0, 0}), body_that(OnHit::impact, radius));
    ASSERT_EQ(told.size(), 4u) << radius;
    EXPECT_EQ(told[0].material, "wood") << "the side that it goes in by";
    EXPECT_NEAR(told[1].velocity.x, behind(kSpeed, 300), 1e-9);
    EXPECT_NEAR(told[1].depth, 0.1, 1e-9);
    EXPECT_EQ(told[2].material, "steel") << "that of the part, where triangles have none";
    EXPECT_NEAR(told[3].velocity.x, behind(behind(kSpeed, 300), 500), 1e-9);
  }
  const auto from_behind = flown(scene, launched({100, 0.01, 0.02}, {-kSpeed, 0, 0}), body_that(OnHit::impact));
  ASSERT_EQ(from_behind.size(), 4u);
  EXPECT_EQ(from_behind[2].material, "tin");
}

// --------------------------------------------------------------------------------------------- doors
TEST(SceneParts, who_asks_is_told_the_part_and_how_thick_it_is) {
  const Scene scene = of_parts({{{50, -1, -1}, {50.1, 1, 1}, &kWood}, {{50.1, -1, -1}, {50.13, 1, 1}, &kSteel}});
  World world = world_with(scene);
  std::vector<HitQuestion> asked;
  ASSERT_TRUE(world.set_hit_function([&](const HitBatch& batch) {
    asked.insert(asked.end(), batch.questions.begin(), batch.questions.end());
    for (HitAnswer& answer : batch.answers) answer.then = OnHit::pass;
  }));
  ASSERT_TRUE(world.spawn(shot(), launched({0, 0, 0}, {kSpeed, 0, 0}), body_that(OnHit::ask)));
  static_cast<void>(run_for(world, 0.2, kStep));
  ASSERT_EQ(asked.size(), 2u);
  EXPECT_EQ(scene.material(asked[0].material).name, "wood");
  EXPECT_NEAR(asked[0].thickness, 0.1, 1e-9);
  EXPECT_EQ(asked[1].primitive, 1u);
  EXPECT_EQ(scene.material(asked[1].material).name, "steel");
  EXPECT_NEAR(asked[1].thickness, 0.03, 1e-9);
}

TEST(SceneParts, flights_meet_them_as_worlds_do) {
  const Scene scene = of_parts({{{50, -1, -1}, {50.1, 1, 1}, &kWood}, {{50.1, -1, -1}, {50.2, 1, 1}, nullptr}});
  const WorldDef def = nothing_but_things();
  Until until{
      .ground = std::nullopt, .time = 0.3, .scene = &scene, .contact = {.collision = {.on_hit = OnHit::impact}}};
  const ProjectileDef def_of_shot = shot();
  const Flight flight =
      fly(def_of_shot, launched({0, 0, 0}, {kSpeed, 0, 0}), def.environment, def_of_shot.fidelity, {}, until);
  std::vector<std::string> met;
  for (const Event& e : flight.events())
    if (e.kind == EventKind::penetrated) met.push_back(scene.material(e.material).name);
  EXPECT_EQ(met, (std::vector<std::string>{"wood", "tin"}));
  EXPECT_NEAR(flight.end().velocity.x, behind(behind(kSpeed, 300), 400), 1e-9);
}

/// Saved in the middle, taken back, and replayed: by bits.
TEST(SceneParts, are_held_by_saves_snapshots_and_recordings) {
  const auto made = [] {
    World world = world_with(of_parts(kWall, {{0, 0.5, 0}, {1, 0.1, 0.05, 0}, 1}), kG);
    for (int i = 0; i < 40; ++i)
      EXPECT_TRUE(world.spawn(shot(), launched({0, 1 + 0.05 * i, 0.1 * i - 2}, {kSpeed - i, 0, 0}),
                              body_that(i % 2 == 0 ? OnHit::impact : OnHit::bounce, i % 3 == 0 ? 0.003 : 0)));
    return world;
  };
  World whole = made(), other = made();
  std::vector<std::byte> recording;
  ASSERT_TRUE(other.record(record_into(recording), {.from_now = true}));
  static_cast<void>(run_for(whole, 0.4, kStep));
  static_cast<void>(run_for(other, 0.1, kStep));
  const std::vector<std::byte> save = other.save().value();
  const auto snapshot = other.snapshot();
  static_cast<void>(run_for(other, 0.3, kStep));
  EXPECT_EQ(other.hash(), whole.hash());
  ASSERT_TRUE(other.stop_recording());
  const auto report = must(replay(recording));
  EXPECT_TRUE(report.complete && !report.difference);
  auto loaded = must(World::load(save));
  static_cast<void>(run_for(loaded, 0.3, kStep));
  EXPECT_EQ(loaded.hash(), whole.hash());
  ASSERT_TRUE(other.restore(snapshot));
  static_cast<void>(run_for(other, 0.3, kStep));
  EXPECT_EQ(other.hash(), whole.hash());
}

}  // namespace physim::world_scene_parts_test
