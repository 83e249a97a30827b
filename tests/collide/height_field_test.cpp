// Height fields, held to meshes of the same triangles: a point meets both at the same place, bit for bit.
#include <gtest/gtest.h>

#include "collide/scene_support.hpp"

namespace physim {
namespace {

using namespace test;

MeshShape mesh_of(const HeightFieldShape& field) {
  MeshShape mesh;
  for (std::uint32_t row = 0; row < field.rows; ++row)
    for (std::uint32_t column = 0; column < field.columns; ++column) {
      const std::uint32_t a = row * field.columns + column, b = a + field.columns;
      mesh.vertices.push_back({column * field.spacing_x, field.heights[a], row * field.spacing_z});
      if (row + 1 == field.rows || column + 1 == field.columns) continue;
      mesh.triangles.push_back({a, b, a + 1});
      mesh.triangles.push_back({a + 1, b, b + 1});
    }
  return mesh;
}

/// Through the place about the field, some along its lines, through its points, straight down, or without a way.
SceneSegment across(Random& r, const HeightFieldShape& field, double high) {
  const double width = (field.columns - 1) * field.spacing_x, depth = (field.rows - 1) * field.spacing_z;
  const auto place = [&](double beyond) {
    return Vec3d{r.in(-beyond, 1 + beyond) * width, r.in(-1.5, 1.5) * high, r.in(-beyond, 1 + beyond) * depth};
  };
  SceneSegment s{place(0.1), place(0.1)};
  if (r.one_in(3)) s.to = s.from + (s.to - s.from) * (8 / (8.0 + field.columns));  // over few cells
  if (r.one_in(6)) s = {place(20), place(0)};
  if (r.one_in(6)) s.from.x = r.below(static_cast<int>(field.columns)) * field.spacing_x;
  if (r.one_in(6)) s.from.z = r.below(static_cast<int>(field.rows)) * field.spacing_z;
  if (r.one_in(5)) s.to.x = s.from.x;
  if (r.one_in(5)) s.to.z = s.from.z;
  if (r.one_in(8)) s.to.y = s.from.y;
  if (r.one_in(20)) s.to.x = s.from.x + 1e-300;
  return s;
}

TEST(HeightField, points_meet_it_where_they_meet_a_mesh_of_its_triangles) {
  Random r(41);
  int some = 0;
  for (int i = 0; i < 60; ++i) {
    HeightFieldShape field{.columns = 2 + static_cast<std::uint32_t>(r.below(r.one_in(3) ? 60 : 9)),
                           .rows = 2 + static_cast<std::uint32_t>(r.below(r.one_in(3) ? 60 : 9)),
                           .spacing_x = r.one_in(4) ? 1e-3 : r.in(0.1, 5),
                           .spacing_z = r.one_in(4) ? 300 : r.in(0.1, 5),
                           .heights = {}};
    const double above = r.one_in(3) ? 8e3 : 0, high = r.one_in(3) ? 50 : 1;
    for (std::uint32_t k = 0; k < field.columns * field.rows; ++k)
      field.heights.push_back(above + (r.one_in(4) ? 0 : r.in(-high, high)));
    Scene scene, meshes;
    ASSERT_TRUE(scene.add({.shape = scene.add_shape(field).value()}));
    ASSERT_TRUE(meshes.add({.shape = meshes.add_shape(mesh_of(field)).value()}));
    for (int k = 0; k < 400; ++k) {
      SceneSegment s = across(r, field, high);
      s.from.y += above, s.to.y += above;
      const SceneHit hit = scene.first_hit(s), other = meshes.first_hit(s);
      ASSERT_EQ(static_cast<bool>(hit), static_cast<bool>(other)) << i << ", cast " << k;
      ASSERT_EQ(hit.part, other.part) << i << ", cast " << k;
      ASSERT_EQ(hit.normal, other.normal) << i << ", cast " << k;
      ASSERT_EQ(hit.primitive, other.primitive) << i << ", cast " << k;
      ASSERT_EQ(scene.all_hits(s).size(), meshes.all_hits(s).size()) << i << ", cast " << k;
      some += hit ? 1 : 0;
    }
  }
  EXPECT_GT(some, 6000);
}

}  // namespace
}  // namespace physim
