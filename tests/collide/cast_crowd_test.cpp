// Many segments at once in trees of boxes: the same answers as alone, whatever the kernel and however many boxes each
// of them meets.
#include "collide/clear_batch.hpp"
#include "collide/crowd_support.hpp"
#include "collide/scene_by_motion.hpp"
#include "support.hpp"

namespace physim::collide_cast_crowd_test {

using namespace test;
using namespace test_crowd;

/// So many triangles through one place: whoever comes there meets the boxes of all.
MeshShape heap(Random& r, std::uint32_t triangles, double size) {
  MeshShape mesh;
  for (std::uint32_t i = 0; i < 3 * triangles; i += 3) {
    const Vec3d a = r.vector(size), b = r.vector(size);
    mesh.vertices.insert(mesh.vertices.end(), {a, b, (a + b) * -1 + r.vector(1)});
    mesh.triangles.push_back({i, i + 1, i + 2});
  }
  return mesh;
}

/// Triangles each of which is half as large as the one before: the deepest tree there is.
MeshShape series() {
  MeshShape mesh;
  double size = 1e12;
  for (std::uint32_t i = 0; i < 3 * 120; i += 3, size /= 2) {
    mesh.vertices.insert(mesh.vertices.end(), {{size, 0, 0}, {size, size, 0}, {size, 0, size}});
    mesh.triangles.push_back({i, i + 1, i + 2});
  }
  return mesh;
}

void expect_each_as_alone(const Scene& scene, const std::vector<SceneSegment>& segments) {
  std::vector<SceneHit> hits(segments.size());
  for (const std::string& kernel : kernels()) {
    ASSERT_TRUE(use_kernel(kernel));
    scene.first_hits(segments, hits);
    for (std::size_t i = 0; i < segments.size(); ++i) expect_same(hits[i], scene.first_hit(segments[i]), i);
  }
  use_kernel("");
}

TEST(CastCrowd, segments_that_meet_thousands_of_boxes_are_as_alone) {
  Random r(51);
  Scene scene;
  const ShapeId mesh = *scene.add_shape(heap(r, 4000, 5));
  for (int i = 0; i < 40; ++i) ASSERT_TRUE(scene.add({.shape = mesh, .transform = random_transform(r, 1)}));
  std::vector<SceneSegment> segments;
  for (int i = 0; i < 150; ++i) segments.push_back({r.vector(6), r.vector(6), r.one_in(8) ? 0.01 : 0.0});
  expect_each_as_alone(scene, segments);
}

TEST(CastCrowd, the_deepest_tree_has_room) {
  Random r(52);
  Scene scene;
  add_thing(scene, series());
  std::vector<SceneSegment> segments;
  for (int i = 0; i < 400; ++i) {
    const double far = std::ldexp(1.0, static_cast<int>(r.below(40)));
    segments.push_back({{-1, r.in(0, 1e-3), r.in(0, 1e-3)}, {far, far * r.in(0, 0.5), far * r.in(0, 0.4)}});
  }
  expect_each_as_alone(scene, segments);
}

TEST(CastCrowd, every_kernel_finds_the_same) {
  Random r(53);
  const Scene scene = crowd(r);
  std::vector<SceneSegment> segments;
  for (int i = 0; i < 1500; ++i) {
    const Vec3d from{r.in(-9, kSide), r.in(-4, 12), r.in(-9, kSide)};
    SceneSegment s{from, from + r.vector(r.one_in(20) ? 300 : 9), r.one_in(3) ? r.in(0, 1) : 0.0};
    for (double* to : {&s.to.x, &s.to.y, &s.to.z})
      if (r.one_in(8)) *to = from[static_cast<std::size_t>(to - &s.to.x)];
    segments.push_back(s);
  }
  expect_each_as_alone(scene, segments);
}

/// A clear part is not shorter for what a sphere beside a triangle would touch if that had no corners.
TEST(CastCrowd, a_clear_part_reaches_the_box_of_a_triangle) {
  Scene scene;
  MeshShape needle{.vertices = {{10, 0, 0}, {30, 0, 0.05}, {30, 0, -0.05}}, .triangles = {{0, 1, 2}}};
  add_thing(scene, needle);
  const SceneSegment towards{
      {0, 0, 0}, {20, 0, 0}, 0.5};  // its tip is at 10, the prism about its sides begins before 0
  EXPECT_GT(scene.clear_part(towards), 0.474);
  EXPECT_LT(scene.clear_part(towards), 0.476);
  const SceneByMotion parts(scene);
  std::vector<collide::ClearQuery> queries(9, {towards, 0xffffffff, 0});
  parts.clear_parts(queries);
  for (const collide::ClearQuery& query : queries) EXPECT_EQ(query.part, parts.clear_part(towards, {}));
}

}  // namespace physim::collide_cast_crowd_test
