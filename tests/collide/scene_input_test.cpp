// Scenes and bad input: what is refused, and that whatever is taken is answered with numbers.
#include "collide/scene_support.hpp"
#include "math/vec3.hpp"
#include "support.hpp"

namespace physim::collide_scene_input_test {

using namespace test;

TEST(Scene, bad_input_is_refused_with_its_place) {
  Scene scene;
  const auto refusal = [&](const ShapeDef& shape) {
    const auto id = scene.add_shape(shape);
    return id ? std::string("none") : id.error().place;
  };
  EXPECT_EQ(refusal(SphereShape{0}), "shape.radius");
  EXPECT_EQ(refusal(SphereShape{kNan}), "shape.radius");
  EXPECT_EQ(refusal(BoxShape{{1, -1, 1}}), "shape.half");
  EXPECT_EQ(refusal(CapsuleShape{1, -1}), "shape.half_height");
  EXPECT_EQ(refusal(CylinderShape{1, 0}), "shape.half_height");
  EXPECT_EQ(refusal(CompoundShape{}), "shape.parts");
  EXPECT_EQ(refusal(CompoundShape{{{ShapeId{7, 1}, {}}}}), "shape.parts[0].shape");
  MeshShape mesh = ball(4, 0);
  mesh.vertices[3].y = kNan;
  EXPECT_EQ(refusal(mesh), "shape.vertices[3]");
  mesh = ball(4, 0);
  mesh.triangles[5][1] = 10000;
  EXPECT_EQ(refusal(mesh), "shape.triangles[5]");
  mesh = ball(4, 0);
  for (auto& t : mesh.triangles) std::swap(t[0], t[1]);
  EXPECT_EQ(refusal(mesh), "shape.triangles") << "inside out";
  mesh = ball(4, 0);
  mesh.materials = {MaterialId{}};
  EXPECT_EQ(refusal(mesh), "shape.materials");
  EXPECT_EQ(refusal(MeshShape{}), "shape.triangles");
  mesh = ball(4, 0);
  mesh.triangles.push_back({0, 1, 1});
  mesh.triangles.insert(mesh.triangles.begin(), {2, 2, 2});
  const auto kept = must(scene.add_shape(mesh));
  EXPECT_EQ(scene.info(kept)->degenerate, 2u);
  ASSERT_TRUE(scene.add({.shape = kept}));
  EXPECT_GE(scene.first_hit({{0, 3, 0.1}, {0, 0, 0.1}}).primitive, 1u) << "numbers are those that were given";
  HeightFieldShape field{.columns = 2, .rows = 2, .heights = {0, 0, 0}};
  EXPECT_EQ(refusal(field), "shape.heights");
  field.heights = {0, 0, kNan, 0};
  EXPECT_EQ(refusal(field), "shape.heights[2]");
  field.columns = 1;
  EXPECT_EQ(refusal(field), "shape.columns");

  const auto sphere = scene.add_shape(SphereShape{});
  const auto place_of = [&](const InstanceDef& def) {
    const auto id = scene.add(def);
    return id ? std::string("none") : id.error().place;
  };
  EXPECT_EQ(place_of({}), "instance.shape");
  EXPECT_EQ(place_of({.shape = *sphere, .transform = {.scale = 0}}), "instance.transform.scale");
  EXPECT_EQ(place_of({.shape = *sphere, .transform = {.rotation = {0, 0, 0, 0}}}), "instance.transform.rotation");
  EXPECT_EQ(place_of({.shape = *sphere, .transform = {.position = {kNan, 0, 0}}}), "instance.transform.position");
  EXPECT_EQ(place_of({.shape = *sphere, .material = {9}}), "instance.material");
  EXPECT_FALSE(scene.add_material({.restitution = 1.1}));
  EXPECT_FALSE(scene.add_material({.friction = -1}));
  EXPECT_FALSE(scene.first_hit({{kNan, 0, 0}, {1, 0, 0}}));
  EXPECT_FALSE(scene.first_hit({{0, 9, 0}, {0, -9, 0}, -1})) << "a negative radius";
  for (const double radius : {0.0, 0.6}) {
    const ShapeId box = scene.add_shape(BoxShape{}).value();
    const auto thing = must(scene.add({.shape = box, .transform = {.position = {20, 0, 0}}}));
    const SceneHit hit = scene.first_hit({{20, 0.3, 0}, {20, 0.3, 0}, radius});
    EXPECT_TRUE(hit.starts_inside) << "no way at all, but it touches";
    EXPECT_EQ(hit.normal, Vec3d{}) << "there is no way to be against";
    EXPECT_TRUE(scene.remove(thing));
  }
  Scene moved = std::move(scene);
  EXPECT_EQ(scene.size(), 0u) << "what it was moved from is empty";
  EXPECT_EQ(moved.size(), 1u);
}

/// Numbers that no scene has: whatever is taken is answered with numbers.
TEST(Scene, odd_numbers_do_no_harm) {
  Random r(23);
  const double odd[] = {0,     -0.0, 1,     -1,     1e-9, 1e-12,     5e-324,     1e-300, 1e9, 1e15,
                        -1e15, 1e16, 1e300, -1e300, kNan, kInfinity, -kInfinity, 0.5,    2,   1e-5};
  int rarity = 3;
  const auto number = [&] { return r.one_in(rarity) ? odd[static_cast<std::size_t>(r.in(0, 19.99))] : r.in(-3, 3); };
  const auto vector = [&] { return Vec3d{number(), number(), number()}; };
  int hits = 0, taken = 0;
  for (int round = 0; round < 4000; ++round) {
    rarity = round % 2 == 0 ? 3 : 15;
    Scene scene;
    MeshShape mesh;
    for (int i = 0; i < 5; ++i) mesh.vertices.push_back(vector());
    mesh.triangles = {{0, 1, 2}, {1, 2, 3}, {2, 3, 4}, {0, 0, 1}};
    HeightFieldShape field{.columns = 2, .rows = 3, .spacing_x = number(), .spacing_z = number(), .heights = {}};
    for (int i = 0; i < 6; ++i) field.heights.push_back(number());
    std::vector<ShapeId> shapes;
    for (const ShapeDef& def : std::initializer_list<ShapeDef>{
             PlaneShape{}, SphereShape{number()}, BoxShape{vector()}, CapsuleShape{number(), number()},
             CylinderShape{number(), number()}, mesh, field, ConvexHullShape{mesh.vertices}})
      if (const auto shape = scene.add_shape(def)) shapes.push_back(*shape);
    CompoundShape compound;
    for (const ShapeId shape : shapes)
      compound.parts.push_back(
          {shape, {.position = vector(), .rotation = {number(), number(), number(), 1}, .scale = number()}});
    if (const auto shape = scene.add_shape(compound)) shapes.push_back(*shape);
    for (const ShapeId shape : shapes)
      if (scene.add(
              {.shape = shape,
               .transform = {
                   .position = vector(), .rotation = {number(), number(), number(), number()}, .scale = number()}}))
        ++taken;
    for (int i = 0; i < 6; ++i) {
      const SceneSegment s{vector(), vector(), r.one_in(2) ? 0 : number()};
      const SceneHit hit = scene.first_hit(s);
      hits += hit ? 1 : 0;
      EXPECT_EQ(scene.any_hit(s), static_cast<bool>(hit));
      EXPECT_TRUE(!hit || (hit.part >= 0 && hit.part <= 1 && std::isfinite(hit.position.x))) << round;
      EXPECT_TRUE(std::isfinite(length(hit.normal))) << round;
      for (const SceneHit& each : scene.all_hits(s)) EXPECT_TRUE(each.part >= 0 && each.part <= 1) << round;
      EXPECT_FALSE(std::isnan(scene.nearest(s.from).distance)) << round;
      static_cast<void>(scene.overlaps(s.from, s.radius));
    }
  }
  EXPECT_GT(taken, 3000);
  EXPECT_GT(hits, 3000);
}

TEST(Scene, odd_motions_and_times_do_no_harm) {
  Random r(29);
  const double odd[] = {0, -0.0, 1, -1e-9, 5e-324, 1e6, -1e6, 1e9, -1e9, 1e10, kNan, kInfinity, -kInfinity, 1e-300};
  const auto number = [&] { return r.one_in(9) ? odd[r.below(14)] : r.in(-3, 3); };
  const auto vector = [&] { return Vec3d{number(), number(), number()}; };
  int taken = 0, hits = 0;
  for (int round = 0; round < 500; ++round) {
    Scene scene;
    const ShapeId shapes[] = {scene.add_shape(BoxShape{}).value(), scene.add_shape(ball(3, 0)).value(),
                              scene.add_shape(PlaneShape{}).value()};
    for (int i = 0; i < 4; ++i) {
      SceneMotion motion = SteadyMotion{number(), vector(), vector()};
      if (r.one_in(2)) {
        KeyedMotion keyed{{}, r.one_in(2) ? MotionCurve::smooth : MotionCurve::straight};
        for (int k = r.below(4); k >= 0; --k)
          keyed.keys.push_back({number(), vector(), {number(), number(), number(), 1}, vector()});
        std::ranges::sort(keyed.keys, {}, &MotionKey::time);
        motion = keyed;
      }
      taken += scene.add({.shape = shapes[r.below(3)], .motion = motion}) ? 1 : 0;
    }
    if (r.one_in(2)) static_cast<void>(scene.cover(number(), number()));
    const SceneSegment s{vector(), vector(), r.one_in(2) ? 0 : number(), number(),
                         std::abs(r.one_in(9) ? number() : 0.1)};
    const SceneHit hit = scene.first_hit(s);
    hits += hit ? 1 : 0;
    EXPECT_TRUE(!hit || (hit.part >= 0 && hit.part <= 1 && std::isfinite(length(hit.velocity)))) << round;
    EXPECT_TRUE(std::isfinite(length(hit.normal))) << round;
    EXPECT_EQ(scene.any_hit(s), static_cast<bool>(hit)) << round;
    for (const SceneHit& each : scene.all_hits(s)) EXPECT_TRUE(each.part >= 0 && each.part <= 1) << round;
    const double bound = scene.clearance(s.from, number(), {}, s.time, s.time + s.duration);
    EXPECT_GE(bound, 0) << round;
    EXPECT_LE(bound, std::max(scene.nearest(s.from, kInfinity, {}, s.time).distance, 0.0)) << round;
  }
  EXPECT_GT(taken, 300);
  EXPECT_GT(hits, 60);
}

}  // namespace physim::collide_scene_input_test
