// Height fields, held to meshes of the same triangles: a point meets both at the same place, bit for bit.
#include <gtest/gtest.h>

#include "collide/height_field.hpp"
#include "collide/scene_by_motion.hpp"
#include "collide/scene_support.hpp"

namespace physim::collide_height_field_test {

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

HeightFieldShape rough_field(Random& r, std::uint32_t most) {
  HeightFieldShape field{.columns = 2 + static_cast<std::uint32_t>(r.below(static_cast<int>(most))),
                         .rows = 2 + static_cast<std::uint32_t>(r.below(static_cast<int>(most))),
                         .spacing_x = r.in(0.5, 2),
                         .spacing_z = r.in(0.5, 2),
                         .heights = {}};
  for (std::uint32_t k = 0; k < field.columns * field.rows; ++k) field.heights.push_back(r.in(-3, 3));
  return field;
}

TEST(HeightField, no_triangle_that_is_met_is_left_out_and_none_comes_twice) {
  Random r(6);
  long met = 0;
  for (int i = 0; i < 40; ++i) {
    const HeightFieldShape shape = rough_field(r, 30);
    const collide::HeightField field = std::move(collide::HeightField::make(shape).value());
    for (int k = 0; k < 60; ++k) {
      collide::Segment s{{r.in(-3, 40), r.in(-6, 6), r.in(-3, 40)}, {r.in(-3, 3), r.in(-3, 3), r.in(-3, 3)}, 0, 1};
      if (r.one_in(3)) s.along = s.along * 6;
      if (r.one_in(4)) s.along.x = 0;
      if (r.one_in(4)) s.along.z = 0;
      if (r.one_in(2)) s.radius = r.in(0, r.one_in(2) ? 10 : 1);
      if (r.one_in(4)) s.reach = 0;  // what begins inside of something is met there by all that it is near
      std::vector<int> seen(field.info().triangles);
      collide::Segment asked = s;
      field.triangles_along(asked, [&](const collide::Triangle&, std::uint32_t number) { ++seen[number]; });
      const collide::Shear shear(s);
      for (std::uint32_t number = 0; number < seen.size(); ++number) {
        ASSERT_LE(seen[number], 1) << i << ", cast " << k << ", triangle " << number;
        const std::uint32_t cell = number / 2, columns = field.columns() - 1;
        if (!collide::meets(s, shear, field.triangle(cell % columns, cell / columns, number % 2))) continue;
        ++met;
        ASSERT_EQ(seen[number], 1) << i << ", cast " << k << ", triangle " << number;
      }
    }
  }
  EXPECT_GT(met, 10000);
}

/// How many ways were clear, and how many not.
struct ClearWays {
  int clear = 0, touched = 0;
};

/// Holds what is said of ways to what each triangle says by itself, and to where they meet something.
void check_clear_parts(const HeightFieldShape& shape, std::vector<collide::ClearQuery> queries, ClearWays& ways) {
  const collide::HeightField field = std::move(collide::HeightField::make(shape).value());
  Scene scene;
  ASSERT_TRUE(scene.add({.shape = scene.add_shape(shape).value(), .layers = 2}));
  for (const std::string& kernel : kernels()) {
    ASSERT_TRUE(use_kernel(kernel));
    std::vector<collide::ClearQuery> asked = queries;
    SceneByMotion(scene).clear_parts(asked);
    for (std::size_t k = 0; k < asked.size(); ++k) {
      const SceneSegment& s = asked[k].segment;
      const collide::Segment whole{s.from, s.to - s.from, s.radius, 1};
      double least = 1;  // what any of its triangles allows
      for (std::uint32_t number = 0; number < field.info().triangles && asked[k].layers != 1; ++number) {
        const std::uint32_t cell = number / 2, columns = field.columns() - 1;
        const auto part = collide::clear_part(whole, field.triangle(cell % columns, cell / columns, number % 2));
        least = std::min(least, part.value_or(1));
      }
      ASSERT_GE(asked[k].part, std::max(0.0, least - 1e-9)) << kernel << ", cast " << k;
      const SceneHit hit = scene.first_hit(s, {.layers = asked[k].layers});
      ASSERT_LE(asked[k].part, hit ? hit.part : 1) << kernel << ", cast " << k;
      if (queries[k].part == 0) queries[k].part = asked[k].part;
      ASSERT_EQ(asked[k].part, queries[k].part) << kernel << ", cast " << k;
      (asked[k].part == 1 ? ways.clear : ways.touched) += 1;
    }
  }
  ASSERT_TRUE(use_kernel(""));
}

TEST(HeightField, a_way_is_clear_up_to_what_it_may_touch_whatever_the_kernel) {
  Random r(8);
  ClearWays ways;
  for (int i = 0; i < 15; ++i) {
    const HeightFieldShape shape = rough_field(r, i % 2 == 0 ? 60 : 8);
    std::vector<collide::ClearQuery> queries;
    for (int k = 0; k < 60; ++k) {
      queries.push_back({across(r, shape, 4), r.one_in(9) ? 1u : 3u});
      queries.back().segment.radius = r.one_in(3) ? 0 : r.in(0, r.one_in(8) ? 9 : 0.5);
      if (r.one_in(2)) queries.back().segment.from.y = r.in(3, 5);
    }
    SCOPED_TRACE(i);
    ASSERT_NO_FATAL_FAILURE(check_clear_parts(shape, queries, ways));
  }
  EXPECT_GT(ways.clear, 100);
  EXPECT_GT(ways.touched, 100);
}

/// Hills, rough by so much, and higher than all of them by so much.
struct Hills {
  HeightFieldShape shape;
  double rough, above;

  Hills(Random& r, std::uint32_t columns, std::uint32_t rows)
      : shape{.columns = columns, .rows = rows, .spacing_x = r.in(0.2, 5), .spacing_z = r.in(0.2, 5), .heights = {}},
        rough(r.one_in(2) ? 0 : 0.2),
        above(r.one_in(3) ? 1e4 : 0) {
    for (std::uint32_t row = 0; row < rows; ++row)
      for (std::uint32_t column = 0; column < columns; ++column)
        shape.heights.push_back(height(column, row) + r.in(-rough, rough));
  }
  [[nodiscard]] double height(double column, double row) const {
    return above + 9 * std::sin(0.17 * column) * std::cos(0.13 * row) + 0.2 * column;
  }
  /// A way over many cells that begins and ends near the ground, or above or below it.
  [[nodiscard]] SceneSegment low_way(Random& r) const {
    const auto place = [&] {
      const double column = r.in(-1, shape.columns), row = r.in(-1, shape.rows);
      const double over = r.one_in(5) ? -r.in(0, 9) : r.one_in(2) ? r.in(0, 2) : r.in(2, 20);
      return Vec3d{column * shape.spacing_x, height(column, row) + over, row * shape.spacing_z};
    };
    SceneSegment s{place(), place()};
    if (r.one_in(4)) s.to.x = s.from.x;
    if (r.one_in(4)) s.to.z = s.from.z;
    s.radius = r.one_in(4) ? 0 : r.in(0, r.one_in(6) ? 12 : 0.5);
    return s;
  }
};

TEST(HeightField, a_way_low_over_hills_is_clear_up_to_what_it_may_touch) {
  Random r(31);
  ClearWays ways;
  for (int i = 0; i < 24; ++i) {
    const auto side = [&] { return 2 + static_cast<std::uint32_t>(r.below(r.one_in(3) ? 7 : 70)); };
    const Hills hills(r, side(), side());
    std::vector<collide::ClearQuery> queries;
    for (int k = 0; k < 60; ++k) queries.push_back({hills.low_way(r), 3});
    SCOPED_TRACE(i);
    ASSERT_NO_FATAL_FAILURE(check_clear_parts(hills.shape, queries, ways));
  }
  EXPECT_GT(ways.clear, 200);
  EXPECT_GT(ways.touched, 200);
}

TEST(HeightField, ways_low_over_hills_meet_them_where_they_meet_a_mesh_of_their_triangles) {
  Random r(32);
  int some = 0;
  for (int i = 0; i < 12; ++i) {
    const Hills hills(r, 90, 3 + static_cast<std::uint32_t>(r.below(80)));
    Scene scene, meshes;
    ASSERT_TRUE(scene.add({.shape = scene.add_shape(hills.shape).value()}));
    ASSERT_TRUE(meshes.add({.shape = meshes.add_shape(mesh_of(hills.shape)).value()}));
    for (int k = 0; k < 300; ++k) {
      const SceneSegment s = hills.low_way(r);
      const SceneHit hit = scene.first_hit(s), expected = meshes.first_hit(s);
      ASSERT_EQ(bool(hit), bool(expected)) << i << ", cast " << k;
      ASSERT_EQ(scene.any_hit(s), bool(expected)) << i << ", cast " << k;
      if (!hit) continue;
      ++some;
      ASSERT_EQ(hit.part, expected.part) << i << ", cast " << k;
      ASSERT_EQ(hit.primitive, expected.primitive) << i << ", cast " << k;
    }
  }
  EXPECT_GT(some, 1000);
}

/// Near a field that stands somewhere; a few make no sense.
std::vector<SceneSegment> casts_near(Random& r, const HeightFieldShape& field, const Vec3d& at, double scale) {
  std::vector<SceneSegment> segments;
  for (int k = 0; k < 700; ++k) {
    SceneSegment s = across(r, field, 4);
    s.from = at + s.from * scale, s.to = at + s.to * scale;
    if (r.one_in(4)) s.radius = r.in(0, 2) * scale;
    if (r.one_in(50)) s.to.y = std::numeric_limits<double>::quiet_NaN();
    if (r.one_in(50)) s.radius = -1;
    segments.push_back(s);
  }
  return segments;
}

TEST(HeightField, many_segments_meet_it_where_each_does_alone_whatever_the_kernel) {
  Random r(7);
  int some = 0;
  for (int i = 0; i < 12; ++i) {
    const HeightFieldShape field = rough_field(r, 50);
    const double far = i % 3 == 0 ? 0 : 1e5, scale = i % 2 == 0 ? 1 : 3;
    InstanceDef def{.transform = {.position = {r.in(-far, far), r.in(-far, far), r.in(-far, far)}, .scale = scale}};
    Scene scene;
    def.shape = scene.add_shape(field).value();
    def.layers = 2;
    const InstanceId id = scene.add(def).value();
    const std::vector<SceneSegment> segments = casts_near(r, field, def.transform.position, scale);
    std::vector<SceneHit> alone;
    for (const SceneSegment& s : segments) alone.push_back(scene.first_hit(s));
    std::vector<SceneHit> hits(segments.size());
    const auto expect_alone = [&](const std::string& what) {
      for (std::size_t k = 0; k < segments.size(); ++k) {
        ASSERT_EQ(hits[k].instance, alone[k].instance) << what << ", cast " << k;
        ASSERT_EQ(hits[k].part, alone[k].part) << what << ", cast " << k;
        ASSERT_EQ(hits[k].position, alone[k].position) << what << ", cast " << k;
        ASSERT_EQ(hits[k].normal, alone[k].normal) << what << ", cast " << k;
        ASSERT_EQ(hits[k].primitive, alone[k].primitive) << what << ", cast " << k;
        ASSERT_EQ(hits[k].starts_inside, alone[k].starts_inside) << what << ", cast " << k;
      }
    };
    for (const std::string& kernel : kernels()) {
      ASSERT_TRUE(use_kernel(kernel));
      scene.first_hits(segments, hits);
      expect_alone(kernel);
    }
    ASSERT_TRUE(use_kernel(""));
    for (const SceneHit& hit : hits) some += hit ? 1 : 0;
    scene.first_hits(segments, hits, {.layers = 1});
    for (const SceneHit& hit : hits) ASSERT_FALSE(hit);
    // Beside something else, and where it went.
    const InstanceId ball = scene
                                .add({.shape = scene.add_shape(SphereShape{0.01}).value(),
                                      .transform = {.position = def.transform.position + Vec3d{0, 1e6, 0}}})
                                .value();
    scene.first_hits(segments, hits);
    expect_alone("beside a ball");
    ASSERT_TRUE(scene.remove(ball));
    ASSERT_TRUE(scene.remove(id));
    scene.first_hits(segments, hits);
    for (const SceneHit& hit : hits) ASSERT_FALSE(hit);
  }
  EXPECT_GT(some, 2000);
}

}  // namespace physim::collide_height_field_test
