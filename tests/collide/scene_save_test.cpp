// Saves of scenes: the same bytes, ids and answers come back, and what is no save is refused.
#include <cstring>

#include "base/archive.hpp"
#include "collide/scene_support.hpp"
#include "support.hpp"

namespace physim::collide_scene_save_test {

using namespace test;

/// Some of everything, after some came and went.
Scene lived_in() {
  Random r(61);
  Scene scene;
  const MaterialId oak = scene.add_material({.name = "oak", .restitution = 0.3, .friction = 0.6}).value();
  MeshShape mesh = ball(5, 0.1);
  mesh.triangles.insert(mesh.triangles.begin() + 3, {7, 7, 8});
  mesh.triangles.push_back({1, 2, 2});
  mesh.materials.assign(mesh.triangles.size(), oak);
  HeightFieldShape field{.columns = 5, .rows = 4, .spacing_x = 0.5, .heights = {}};
  for (int i = 0; i < 20; ++i) field.heights.push_back(r.in(-0.5, 0.5));
  ConvexHullShape hull;
  for (int i = 0; i < 12; ++i) hull.points.push_back(r.vector(1));
  const ShapeId gone = scene.add_shape(SphereShape{3}).value();
  std::vector<ShapeId> shapes;
  for (const ShapeDef& def :
       std::initializer_list<ShapeDef>{PlaneShape{}, SphereShape{0.5}, BoxShape{{0.3, 0.6, 0.2}},
                                       CapsuleShape{0.2, 0.5}, CylinderShape{0.4, 0.5}, mesh, field, hull})
    shapes.push_back(scene.add_shape(def).value());
  shapes.push_back(scene.add_shape(CompoundShape{{{shapes[2], random_transform(r, 1)}, {shapes[5], {}}}}).value());
  std::vector<InstanceId> things;
  for (int i = 0; i < 40; ++i) {
    InstanceDef def{.shape = shapes[static_cast<std::size_t>(i % 9)],
                    .transform = random_transform(r, 10),
                    .material = oak,
                    .layers = 1u + static_cast<std::uint32_t>(i % 3),
                    .sensor = i % 7 == 0,
                    .user_data = 1000u + static_cast<std::uint64_t>(i),
                    .name = "thing " + std::to_string(i)};
    if (i % 4 == 1) def.motion = SteadyMotion{0.5, r.vector(3), r.vector(2)};
    if (i % 4 == 2)
      def.motion = KeyedMotion{{{0, r.vector(9), {}, r.vector(1)}, {1, r.vector(9), {1, 2, 3, 4}, r.vector(1)}},
                               i % 8 == 2 ? MotionCurve::smooth : MotionCurve::straight};
    if (i % 9 == 0) def.transform.position.y = -20;
    things.push_back(scene.add(def).value());
  }
  for (std::size_t i = 3; i < 40; i += 5) EXPECT_TRUE(scene.remove(things[i]));
  EXPECT_TRUE(scene.remove_shape(gone));
  EXPECT_TRUE(scene.cover(0, 0.5));
  return scene;
}

TEST(SceneSave, gives_back_the_same_scene) {
  Scene scene = lived_in();
  const std::vector<std::byte> save = scene.save();
  auto loaded = must(Scene::load(save));
  EXPECT_EQ(loaded.save(), save);
  EXPECT_EQ(loaded.hash(), scene.hash());
  EXPECT_EQ(loaded.size(), scene.size());
  EXPECT_EQ(loaded.changes(), scene.changes());
  Random r(63);
  int hits = 0;
  for (int i = 0; i < 2000; ++i) {
    SceneSegment s = random_segment(r, {}, 8);
    s.radius = r.one_in(2) ? 0 : 0.1;
    s.time = r.in(-0.2, 1);
    s.duration = r.in(0, 0.1);
    const SceneHit a = scene.first_hit(s), b = loaded.first_hit(s);
    hits += a ? 1 : 0;
    ASSERT_EQ(a.instance, b.instance) << i;
    ASSERT_EQ(a.part, b.part) << i;
    ASSERT_EQ(a.normal, b.normal) << i;
    ASSERT_EQ(a.primitive, b.primitive) << i;
    ASSERT_EQ(a.material, b.material) << i;
    ASSERT_EQ(scene.clearance(s.from, 10, {}, s.time, s.time + 0.1),
              loaded.clearance(s.from, 10, {}, s.time, s.time + 0.1));
  }
  EXPECT_GT(hits, 500);
  EXPECT_EQ(scene.instance({2, 1})->name, loaded.instance({2, 1})->name);
  for (int i = 0; i < 12; ++i) {
    const auto a = scene.add_shape(SphereShape{}), b = loaded.add_shape(SphereShape{});
    EXPECT_EQ(*a, *b);
    EXPECT_EQ(scene.add({.shape = *a}).value(), loaded.add({.shape = *b}).value()) << "ids of what comes later";
  }
  EXPECT_EQ(loaded.hash(), scene.hash());
  EXPECT_TRUE(Scene::load(Scene().save()));
}

TEST(SceneSave, hashes_tell_what_is_there) {
  Scene scene = lived_in();
  std::uint64_t before = scene.hash();
  const auto changed = [&](const char* what) {
    EXPECT_NE(scene.hash(), before) << what;
    before = scene.hash();
  };
  const ShapeId shape = scene.add_shape(SphereShape{}).value();
  changed("a shape");
  const InstanceId thing = scene.add({.shape = shape}).value();
  changed("a thing");
  ASSERT_TRUE(scene.move(thing, {.position = {0, 1, 0}}));
  changed("its place");
  ASSERT_TRUE(scene.set_motion(thing, SteadyMotion{}));
  changed("its motion");
  ASSERT_TRUE(scene.set_layers(thing, 8));
  changed("its layers");
  ASSERT_TRUE(scene.add_material({.name = "tin"}));
  changed("a material");
  ASSERT_TRUE(scene.cover(0, 9));
  EXPECT_EQ(scene.hash(), before) << "what is covered is no content";
}

TEST(SceneSave, a_shape_is_held_once) {
  Scene scene;
  const ShapeId shape = scene.add_shape(ball(30, 0.1)).value();
  ASSERT_TRUE(scene.add({.shape = shape}));
  const std::size_t one = scene.save().size();
  for (int i = 0; i < 99; ++i) ASSERT_TRUE(scene.add({.shape = shape}));
  EXPECT_LT(scene.save().size(), one + 100 * 200);
  EXPECT_GT(one, 60000u) << "the mesh itself";
}

std::vector<std::byte> with_a_good_sum(std::vector<std::byte> save) {
  constexpr std::size_t kHead = 20, kSum = 8;
  Hash hash;
  hash.add(std::span(save).subspan(kHead, save.size() - kHead - kSum));
  for (std::size_t i = 0; i < kSum; ++i) save[save.size() - kSum + i] = static_cast<std::byte>(hash.value() >> (8 * i));
  return save;
}

TEST(SceneSave, of_another_version_is_read_or_refused_by_name) {
  constexpr std::size_t kFormat = 8, kContent = 12, kVersionPlace = 24;
  const Scene scene = lived_in();
  std::vector<std::byte> save = scene.save();
  save[kVersionPlace] = std::byte{'7'};
  ASSERT_TRUE(Scene::load(with_a_good_sum(save)));
  save[kFormat] = std::byte{99};
  const std::string now = std::string("; this is PhySim ") + kVersion + ", which reads format 5";
  EXPECT_EQ(Scene::load(save).error().message,
            "the save is of format 99, written by PhySim 7" + std::string(kVersion).substr(1) + now);
  // Format 3 has no version; it is read, too.
  const std::size_t length = std::strlen(kVersion);
  save.erase(save.begin() + 20, save.begin() + kVersionPlace + static_cast<long>(length));
  save[kFormat] = std::byte{3};
  for (unsigned i = 0; i < 8; ++i) save[kContent + i] = static_cast<std::byte>((save.size() - 28) >> (8 * i));
  const auto loaded = must(Scene::load(with_a_good_sum(save)));
  EXPECT_EQ(loaded.hash(), scene.hash());
  save[kFormat] = std::byte{2};
  EXPECT_EQ(Scene::load(save).error().message, "the save is of format 2, written by an older version of PhySim" + now);
}

TEST(SceneSave, what_is_no_save_is_refused) {
  const std::vector<std::byte> save = lived_in().save();
  EXPECT_EQ(with_a_good_sum(save), save);
  for (std::size_t length = 0; length < save.size(); length += 1 + save.size() / 300) {
    const auto cut = Scene::load(std::span(save).first(length));
    ASSERT_FALSE(cut) << length;
    EXPECT_EQ(cut.error().place, "save");
  }
  Random r(65);
  int loaded = 0;
  for (int i = 0; i < 1500; ++i) {
    std::vector<std::byte> damaged = save;
    const auto place = static_cast<std::size_t>(r.below(static_cast<int>(save.size())));
    damaged[place] ^= static_cast<std::byte>(1 << r.below(8));
    ASSERT_FALSE(Scene::load(damaged)) << place;
    if (place < 20) continue;
    // Whoever mends the sum gets an error, or a scene that answers and can be saved.
    const auto scene = Scene::load(with_a_good_sum(damaged));
    if (!scene) continue;
    ++loaded;
    static_cast<void>(scene->first_hit({{-20, 3, 1}, {20, 1, 0}, 0.1, 0, 0.1}));
    EXPECT_FALSE(scene->save().empty());
  }
  EXPECT_GT(loaded, 500);
  auto later = save;
  later[8] = std::byte{99};
  EXPECT_NE(Scene::load(later).error().text().find("format 99"), std::string::npos);
}

}  // namespace physim::collide_scene_save_test
