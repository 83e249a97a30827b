// Materials of parts of compounds: what questions tell of them, what is refused, what saves hold.
#include <optional>

#include "base/archive.hpp"
#include "collide/scene_support.hpp"
#include "support.hpp"

namespace physim::collide_part_material_test {

using namespace test;

/// Parts of all kinds, some with a material, some without; each also as a thing, in a scene of its own.
struct Twins {
  Scene compound, things;
  std::size_t parts = 0;
};
Twins twins(Random& r) {
  Twins twins;
  std::vector<MaterialId> materials;
  for (const char* name : {"own", "wood", "steel", "glass"}) {
    materials.push_back(*twins.compound.add_material({.name = name}));
    EXPECT_EQ(*twins.things.add_material({.name = name}), materials.back());
  }
  MeshShape painted = ball(5, 0.1);
  for (std::size_t i = 0; i < painted.triangles.size(); ++i) painted.materials.push_back(materials[i % 3]);
  const ShapeDef shapes[] = {BoxShape{{0.5, 1, 0.7}}, SphereShape{0.6}, painted, ball(4, 0), CylinderShape{0.4, 0.9}};
  const Transform at = random_transform(r, 5);
  const Quatd turn = normalized(at.rotation);
  CompoundShape compound;
  for (int i = 0; i < 10; ++i) {
    const ShapeDef& shape = shapes[i % 5];
    const Transform own = random_transform(r, 6);
    const auto material = i % 3 == 0 ? std::nullopt : std::optional(materials[static_cast<std::size_t>(i) % 4]);
    compound.parts.push_back({*twins.compound.add_shape(shape), own, material});
    const Transform placed{at.position + rotate(turn, own.position) * at.scale, turn * normalized(own.rotation),
                           at.scale * own.scale};
    const MaterialId of = material.value_or(materials[0]);
    EXPECT_TRUE(twins.things.add({.shape = *twins.things.add_shape(shape), .transform = placed, .material = of}));
  }
  twins.parts = compound.parts.size();
  const InstanceDef thing{.shape = *twins.compound.add_shape(compound), .transform = at, .material = materials[0]};
  const auto added = must(twins.compound.add(thing));
  EXPECT_EQ(twins.compound.parts(added), 10u);
  return twins;
}

/// What is told of a part is what is told of a thing in its place.
TEST(PartMaterials, are_told_as_those_of_things_in_their_places) {
  Random r(71);
  std::size_t met = 0, all = 0;
  for (int round = 0; round < 20; ++round) {
    const Twins t = twins(r);
    for (int i = 0; i < 700; ++i) {
      SceneSegment s = random_segment(r, t.compound.state({1, 1})->position, 6);
      s.radius = r.one_in(2) ? 0 : 0.05;
      const SceneHit a = t.compound.first_hit(s), b = t.things.first_hit(s);
      ASSERT_EQ(bool(a), bool(b));
      if (a && !a.starts_inside) {
        ++met;
        ASSERT_NEAR(a.part, b.part, 1e-9);
        EXPECT_EQ(a.primitive + 1, b.instance.index);
        // At an edge of two triangles a ball touches both, and rounding says which of them is the nearer one.
        if (s.radius == 0 || a.primitive % 5 != 2) {
          EXPECT_EQ(a.material, b.material) << a.primitive;
        }
      }
      const auto one = t.compound.all_hits(s), other = t.things.all_hits(s);
      ASSERT_EQ(one.size(), other.size());
      for (std::size_t k = 0; k < one.size(); ++k) {
        if (k > 0 && one[k].part - one[k - 1].part < 1e-9) continue;
        if (k + 1 < one.size() && one[k + 1].part - one[k].part < 1e-9) continue;
        ++all;
        EXPECT_EQ(one[k].entering, other[k].entering);
        EXPECT_EQ(one[k].material, other[k].material) << one[k].primitive;
      }
    }
  }
  EXPECT_GT(met, 1000u);
  EXPECT_GT(all, 4000u);
}

/// Wood and steel face to face: the way into one begins where that out of the other ends.
TEST(PartMaterials, thicknesses_are_those_of_each) {
  Scene scene;
  const MaterialId wood = *scene.add_material({.name = "wood"}), steel = *scene.add_material({.name = "steel"});
  const ShapeId box = *scene.add_shape(BoxShape{{0.5, 1, 1}});
  const ShapeId both = *scene.add_shape(
      CompoundShape{{{box, {.position = {1.5, 0, 0}}, steel}, {box, {.position = {0.5, 0, 0}}, wood}}});
  const Transform at{{3, -2, 1}, {1, 0.2, -0.4, 0.3}, 2};
  ASSERT_TRUE(scene.add({.shape = both, .transform = at}));
  const auto place = [&](double x) {
    return at.position + rotate(normalized(at.rotation), Vec3d{x, 0.1, 0.2}) * at.scale;
  };
  const auto hits = scene.all_hits({place(-1), place(3)});
  ASSERT_EQ(hits.size(), 4u);
  double in[2] = {}, out[2] = {};
  for (const SceneHit& hit : hits) {
    const std::size_t i = hit.material == wood ? 0 : 1;
    EXPECT_EQ(hit.primitive, 1 - i);
    (hit.entering ? in : out)[i] = hit.part * 4 - 1;
  }
  EXPECT_NEAR(in[0], 0, 1e-12);
  EXPECT_NEAR(out[0], 1, 1e-12);
  EXPECT_NEAR(in[1], 1, 1e-12);
  EXPECT_NEAR(out[1], 2, 1e-12);
}

/// Through an edge of two triangles of a part that are of two materials the one of the lower number is told, whatever
/// the tree looks like.
TEST(PartMaterials, at_an_edge_the_first_triangle_is_told) {
  for (const bool swapped : {false, true}) {
    Scene scene;
    const MaterialId one = *scene.add_material({.name = "one"}), two = *scene.add_material({.name = "two"});
    MeshShape sheet{{{0, -1, -1}, {0, 1, -1}, {0, 1, 1}, {0, -1, 1}}, {{0, 2, 1}, {0, 3, 2}}, {one, two}};
    if (swapped) std::swap(sheet.triangles[0], sheet.triangles[1]), std::swap(sheet.materials[0], sheet.materials[1]);
    const ShapeId part = *scene.add_shape(sheet);
    add_thing(scene, CompoundShape{{{part, {}}}});
    const SceneSegment s{{-1, 0.25, 0.25}, {1, 0.25, 0.25}};
    EXPECT_EQ(scene.first_hit(s).material, swapped ? two : one);
    ASSERT_EQ(scene.all_hits(s).size(), 1u);
    EXPECT_EQ(scene.all_hits(s)[0].material, swapped ? two : one);
  }
}

TEST(PartMaterials, of_no_scene_are_refused) {
  Scene scene;
  const ShapeId box = *scene.add_shape(BoxShape{});
  const MaterialId last = *scene.add_material({.name = "last"});
  EXPECT_TRUE(scene.add_shape(CompoundShape{{{box, {}, last}}}));
  const auto refused = scene.add_shape(CompoundShape{{{box, {}, last}, {box, {}, MaterialId{last.index + 1}}}});
  ASSERT_FALSE(refused);
  EXPECT_EQ(refused.error().text(),
            "shape.parts[1].material: error: is no material of this scene; add_material() gives them");
}

Scene small_scene(MaterialId of = {2}) {
  Scene scene;
  static_cast<void>(scene.add_material({.name = "wood"}));
  static_cast<void>(scene.add_material({.name = "steel"}));
  const ShapeId box = *scene.add_shape(BoxShape{});
  add_thing(scene, CompoundShape{{{box, {}}, {box, {{3, 0, 0}, {}, 1}, of}}});
  return scene;
}

TEST(PartMaterials, are_saved_and_told_apart_by_hashes) {
  const Scene scene = small_scene();
  const auto loaded = must(Scene::load(scene.save()));
  EXPECT_EQ(loaded.hash(), scene.hash());
  EXPECT_EQ(loaded.save(), scene.save());
  const SceneSegment s{{3, 5, 0}, {3, -5, 0}};
  EXPECT_EQ(loaded.material(loaded.first_hit(s).material).name, "steel");
  EXPECT_NE(small_scene({1}).hash(), scene.hash());
  EXPECT_NE(small_scene({0}).hash(), scene.hash());
}

/// A save whose bytes name a material that is not there makes no scene; nor does one of an earlier format.
TEST(PartMaterials, that_are_damaged_in_a_save_are_refused) {
  constexpr std::size_t kHead = 20, kSum = 8;
  const auto two = small_scene({2}).save(), one = small_scene({1}).save();
  ASSERT_EQ(one.size(), two.size());
  std::size_t place = kHead, differ = 0;
  for (std::size_t i = kHead; i + kSum < one.size(); ++i)
    if (one[i] != two[i]) place = i, ++differ;
  ASSERT_EQ(differ, 1u);
  auto damaged = one;
  damaged[place] = std::byte{3};
  Hash hash;
  hash.add(std::span(damaged).subspan(kHead, damaged.size() - kHead - kSum));
  for (std::size_t i = 0; i < kSum; ++i)
    damaged[damaged.size() - kSum + i] = static_cast<std::byte>(hash.value() >> (8 * i));
  const auto loaded = Scene::load(damaged);
  ASSERT_FALSE(loaded);
  EXPECT_EQ(loaded.error().place, "shape.parts[1].material");
}

TEST(PartMaterials, are_drawn) {
  struct Sheet : SceneCanvas {
    std::vector<std::pair<MaterialId, int>> of;  // with the triangles of each
    void material(MaterialId next) override { of.emplace_back(next, 0); }
    void line(const Vec3d&, const Vec3d&, SceneInk) override {}
    void triangle(const Vec3d&, const Vec3d&, const Vec3d&, SceneInk) override { ++of.back().second; }
    void text(const Vec3d&, std::string_view) override {}
  } sheet;
  Scene scene;
  const MaterialId own = *scene.add_material({.name = "own"}), wood = *scene.add_material({.name = "wood"}),
                   steel = *scene.add_material({.name = "steel"});
  const ShapeId box = *scene.add_shape(BoxShape{});
  const ShapeId painted =
      *scene.add_shape(MeshShape{{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}}, {{0, 1, 2}, {0, 1, 3}}, {steel, steel}});
  const ShapeId all = *scene.add_shape(CompoundShape{{{box, {}, wood}, {painted, {}, wood}, {box, {}}}});
  ASSERT_TRUE(scene.add({.shape = all, .material = own}));
  scene.draw(sheet, {});
  std::erase_if(sheet.of, [](const auto& each) { return each.second == 0; });
  EXPECT_EQ(sheet.of, (std::vector<std::pair<MaterialId, int>>{{wood, 12}, {steel, 2}, {own, 12}}));
}

}  // namespace physim::collide_part_material_test
