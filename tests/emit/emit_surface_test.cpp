// Meshes and terrain that particles come out of: a million samples each, against areas, lengths and counts.
#include "emit/emit_surface.hpp"
#include "emit/statistics.hpp"
#include "random_shots.hpp"
#include "scene_support.hpp"

namespace physim::emit_emit_surface_test {

using test::as_expected;
using test::evenly;
using test::evenly_together;
using test::kSamples;
using test::near;
using test::newborns;
using test::Random;
using Pairs = std::vector<std::array<double, 2>>;

EmitterDef from(EmitShape shape, const ShapeDef& of, EmitAlong along = EmitAlong::normal) {
  return {.from = {.shape = shape, .surface = {.shape = SharedShape::make(of).value(), .along = along}}};
}

/// Triangles of many sizes above each other, so that a height tells which one a place lies in; some have no area.
MeshShape soup() {
  Random r(3);
  MeshShape mesh;
  for (std::uint32_t i = 0; i < 40; ++i) {
    const double size = r.in(0.2, 4);
    for (int k = 0; k < 3; ++k) mesh.vertices.push_back({r.in(-size, size), 10.0 * i + r.in(-1, 1), r.in(-size, size)});
    mesh.triangles.push_back({3 * i, 3 * i + 1, 3 * i + 2});
    if (i % 7 == 0) mesh.triangles.push_back({3 * i, 3 * i + 1, 3 * i});
  }
  return mesh;
}

/// Edges of one, its corner at the origin.
MeshShape cube() {
  MeshShape mesh;
  for (int i = 0; i < 8; ++i) mesh.vertices.push_back({double(i & 1), double(i >> 1 & 1), double(i >> 2 & 1)});
  mesh.triangles = {{0, 2, 3}, {0, 3, 1}, {4, 5, 7}, {4, 7, 6}, {0, 1, 5}, {0, 5, 4},
                    {2, 6, 7}, {2, 7, 3}, {0, 4, 6}, {0, 6, 2}, {1, 3, 7}, {1, 7, 5}};
  return mesh;
}
bool is_unit(const Vec3d& v) { return near(length(v), 1, 1e-14); }

TEST(EmitSurface, a_mesh_is_even_by_area) {
  const MeshShape mesh = soup();
  std::vector<double> counts(40), areas(40);
  Pairs in_triangles;
  double sum = 0;
  for (std::size_t i = 0; i < 40; ++i) {
    const Vec3d &a = mesh.vertices[3 * i], &b = mesh.vertices[3 * i + 1], &c = mesh.vertices[3 * i + 2];
    sum += areas[i] = length(cross(b - a, c - a)) / 2;
  }
  for (const Newborn& n : newborns(from(EmitShape::mesh, mesh))) {
    const auto i = static_cast<std::size_t>((n.place.y + 5) / 10);
    const Vec3d &a = mesh.vertices[3 * i], &b = mesh.vertices[3 * i + 1], &c = mesh.vertices[3 * i + 2];
    ++counts[i];
    const Vec3d normal = normalized(cross(b - a, c - a));
    ASSERT_TRUE(near(n.direction, normal, 1e-12));
    ASSERT_NEAR(dot(n.place - a, normal), 0, 1e-9);
    // Parts of b and c, by areas: even by the square of their sum, and by what of it is c.
    const double of_b = dot(cross(n.place - a, c - a), normal) / (2 * areas[i]);
    const double of_c = dot(cross(b - a, n.place - a), normal) / (2 * areas[i]);
    in_triangles.push_back({(of_b + of_c) * (of_b + of_c), std::clamp(of_c / (of_b + of_c), 0.0, 1.0)});
  }
  for (double& area : areas) area *= double(kSamples) / sum;
  EXPECT_TRUE(as_expected(counts, areas));
  EXPECT_TRUE(evenly_together(in_triangles));
}

TEST(EmitSurface, the_edges_of_a_mesh_are_even_by_length) {
  // 12 edges of a cube, and 6 diagonals; the normals of those lie across their faces.
  double diagonals = 0;
  std::vector<double> along;
  for (const Newborn& n : newborns(from(EmitShape::mesh_edges, cube()))) {
    ASSERT_TRUE(is_unit(n.direction));
    int between = 0;
    for (std::size_t k = 0; k < 3; ++k) between += n.place[k] > 0 && n.place[k] < 1;
    ASSERT_TRUE(between == 1 || between == 2) << n.place.x << " " << n.place.y << " " << n.place.z;
    if (between == 2) {
      ++diagonals;
      ASSERT_TRUE(
          near(std::max({std::abs(n.direction.x), std::abs(n.direction.y), std::abs(n.direction.z)}), 1, 1e-14));
      continue;
    }
    for (std::size_t k = 0; k < 3; ++k) {
      if (n.place[k] > 0 && n.place[k] < 1) {
        along.push_back(n.place[k]);
        ASSERT_NEAR(n.direction[k], 0, 1e-15);
      } else {
        ASSERT_NEAR(n.direction[k], (n.place[k] - 0.5) * std::sqrt(2.0), 1e-14);
      }
    }
  }
  const double of_diagonals = 6 * std::sqrt(2.0), whole = of_diagonals + 12, n = double(kSamples);
  EXPECT_TRUE(as_expected({diagonals, n - diagonals}, {n * of_diagonals / whole, n * 12 / whole}));
  EXPECT_TRUE(evenly(along));
}

TEST(EmitSurface, edges_of_many_lengths_are_chosen_by_them) {
  const MeshShape mesh = soup();
  std::vector<double> counts(120), lengths(120);
  double sum = 0;
  for (std::size_t i = 0; i < 120; ++i) {
    const std::size_t next = i % 3 == 2 ? i - 2 : i + 1;
    sum += lengths[i] = length(mesh.vertices[next] - mesh.vertices[i]);
  }
  for (const Newborn& n : newborns(from(EmitShape::mesh_edges, mesh))) {
    const auto first = 3 * static_cast<std::size_t>((n.place.y + 5) / 10);
    const auto off = [&](std::size_t i) {
      const std::size_t next = i % 3 == 2 ? i - 2 : i + 1;
      return length(n.place - mesh.vertices[i]) + length(n.place - mesh.vertices[next]) - lengths[i];
    };
    std::size_t at = first;
    for (const std::size_t i : {first + 1, first + 2})
      if (off(i) < off(at)) at = i;
    ASSERT_NEAR(off(at), 0, 1e-9);
    ++counts[at];
  }
  for (double& each : lengths) each *= double(kSamples) / sum;
  EXPECT_TRUE(as_expected(counts, lengths));
}

TEST(EmitSurface, the_vertices_of_a_mesh_come_as_often_as_each_other) {
  std::vector<double> counts(8);
  for (const Newborn& n : newborns(from(EmitShape::mesh_vertices, cube()))) {
    const auto corner = std::size_t(n.place.x) + 2 * std::size_t(n.place.y) + 4 * std::size_t(n.place.z);
    ++counts[corner];
    // By angles: however the faces are cut into triangles.
    ASSERT_TRUE(near(n.direction, (n.place - Vec3d{0.5, 0.5, 0.5}) * (2 / std::sqrt(3.0)), 1e-14));
  }
  EXPECT_TRUE(as_expected(counts, std::vector<double>(8, double(kSamples) / 8)));
}

TEST(EmitSurface, directions_are_those_of_triangles_corners_or_the_axis) {
  for (const EmitShape shape : {EmitShape::mesh, EmitShape::mesh_edges, EmitShape::mesh_vertices})
    for (const Newborn& n : newborns(from(shape, cube(), EmitAlong::axis), 100))
      EXPECT_EQ(n.direction, (Vec3d{1, 0, 0}));
  const Vec3d middle{0.5, 0.5, 0.5};
  for (const Newborn& n : newborns(from(EmitShape::mesh, cube(), EmitAlong::smooth), 10000)) {
    // Corners point away from the middle, so what is mixed from them does, too.
    ASSERT_TRUE(near(n.direction, normalized(n.place - middle), 1e-13));
  }
  EmitterDef off = from(EmitShape::mesh, cube());
  off.from.randomise = 1;
  Vec3d sum;
  for (const Newborn& n : newborns(off, 10000)) sum += n.direction;
  EXPECT_LT(length(sum), 3 * 100);
}

TEST(EmitSurface, a_sheet_that_is_folded_flat_has_normals) {
  const MeshShape folded{{{0, 0, 0}, {1, 0, 0}, {0, 0, 1}}, {{0, 1, 2}, {0, 2, 1}}, {}};
  for (const EmitShape shape : {EmitShape::mesh_edges, EmitShape::mesh_vertices})
    for (const Newborn& n : newborns(from(shape, folded), 1000)) ASSERT_NEAR(std::abs(n.direction.y), 1, 1e-14);
}

TEST(EmitSurface, a_mesh_may_be_scaled) {
  EmitterDef def = from(EmitShape::mesh, cube());
  const auto one = newborns(def, 100);
  def.from.surface.scale = 3;
  const auto three = newborns(def, 100);
  for (std::size_t i = 0; i < 100; ++i) {
    EXPECT_EQ(three[i].place, one[i].place * 3);
    EXPECT_EQ(three[i].direction, one[i].direction);
  }
}

// ------------------------------------------------------------------------------------------------- terrain
HeightFieldShape hills() {
  HeightFieldShape field{7, 5, 2.0, 3.0, {}};
  Random r(8);
  for (int i = 0; i < 35; ++i) field.heights.push_back(r.in(0, 6));
  return field;
}
/// Height and area above a square metre, of the half of a cell that a place lies in.
std::pair<double, double> hill_at(const HeightFieldShape& f, double x, double z) {
  const auto column = std::min(std::size_t(x / f.spacing_x), std::size_t{f.columns - 2});
  const auto row = std::min(std::size_t(z / f.spacing_z), std::size_t{f.rows - 2});
  const double u = x / f.spacing_x - double(column), v = z / f.spacing_z - double(row);
  const auto h = [&](std::size_t i, std::size_t j) { return f.heights[(row + j) * f.columns + column + i]; };
  const bool near_side = u + v <= 1;
  const double by_u = near_side ? h(1, 0) - h(0, 0) : h(1, 1) - h(0, 1);
  const double by_v = near_side ? h(0, 1) - h(0, 0) : h(1, 1) - h(1, 0);
  const double height = near_side ? h(0, 0) + by_u * u + by_v * v : h(1, 1) - by_u * (1 - u) - by_v * (1 - v);
  return {height, std::sqrt(1 + by_u * by_u / 4 + by_v * by_v / 9)};
}

TEST(EmitSurface, a_rectangle_of_terrain_is_even_by_area) {
  const HeightFieldShape field = hills();
  for (const bool is_part : {false, true}) {
    EmitterDef def = from(EmitShape::terrain, field);
    const double low_x = is_part ? 1.3 : 0, high_x = is_part ? 8.9 : 12, low_z = is_part ? 4.1 : 0,
                 high_z = is_part ? 5.2 : 12;
    if (is_part) {
      EmitSurface& s = def.from.surface;
      s.low_x = low_x, s.high_x = high_x, s.low_z = low_z, s.high_z = high_z;
    }
    constexpr std::size_t kBins = 12, kSub = 200;
    std::vector<double> counts(kBins * kBins), areas(kBins * kBins);
    double sum = 0;
    for (std::size_t i = 0; i < kBins * kSub; ++i)
      for (std::size_t j = 0; j < kBins * kSub; ++j) {
        const double x = low_x + (high_x - low_x) * (double(i) + 0.5) / double(kBins * kSub);
        const double z = low_z + (high_z - low_z) * (double(j) + 0.5) / double(kBins * kSub);
        const double area = hill_at(field, x, z).second;
        areas[i / kSub * kBins + j / kSub] += area, sum += area;
      }
    for (const Newborn& n : newborns(def)) {
      ASSERT_TRUE(n.place.x >= low_x && n.place.x <= high_x && n.place.z >= low_z && n.place.z <= high_z);
      ASSERT_NEAR(n.place.y, hill_at(field, n.place.x, n.place.z).first, 1e-9);
      const auto bin = [](double at, double low, double high) {
        return std::min(std::size_t((at - low) / (high - low) * double(kBins)), kBins - 1);
      };
      ++counts[bin(n.place.x, low_x, high_x) * kBins + bin(n.place.z, low_z, high_z)];
    }
    for (double& area : areas) area *= double(kSamples) / sum;
    EXPECT_TRUE(as_expected(counts, areas)) << is_part;
  }
}

TEST(EmitSurface, terrain_lets_out_along_its_normals) {
  HeightFieldShape slope{3, 3, 1, 1, {}};
  for (int i = 0; i < 9; ++i) slope.heights.push_back(0.75 * (i % 3));
  for (const EmitAlong along : {EmitAlong::normal, EmitAlong::smooth})
    for (const Newborn& n : newborns(from(EmitShape::terrain, slope, along), 1000))
      ASSERT_TRUE(near(n.direction, Vec3d{-0.6, 0.8, 0}, 1e-14));
  // Between the points of a parabola the smooth normal is that of its slope at the points.
  HeightFieldShape bowl{41, 41, 0.1, 0.1, {}};
  for (int row = 0; row < 41; ++row)
    for (int column = 0; column < 41; ++column)
      bowl.heights.push_back(0.01 * ((column - 20) * (column - 20) + (row - 20) * (row - 20)));
  EmitterDef def = from(EmitShape::terrain, bowl, EmitAlong::smooth);
  EmitSurface& s = def.from.surface;
  s.low_x = s.low_z = 0.5, s.high_x = s.high_z = 3.5;
  for (const Newborn& n : newborns(def, 1000))
    ASSERT_TRUE(near(n.direction, normalized(Vec3d{-2 * (n.place.x - 2), 1, -2 * (n.place.z - 2)}), 2e-2));
}

// ------------------------------------------------------------------------------------------------- sharing
TEST(EmitSurface, a_shape_of_a_scene_is_shared_with_it) {
  Scene scene;
  const ShapeId mesh = scene.add_shape(cube()).value(), ball = scene.add_shape(SphereShape{}).value();
  const SharedShape shared = SharedShape::of(scene, mesh).value();
  EXPECT_EQ(shared, SharedShape::make(cube()).value());
  EXPECT_EQ(shared.hash(), SharedShape::make(cube()).value().hash());
  EXPECT_FALSE(shared == SharedShape::make(soup()).value());
  EXPECT_FALSE(SharedShape::of(scene, ball));
  EXPECT_FALSE(SharedShape::of(scene, {}));
  EXPECT_EQ(SharedShape::load(shared.save()).value(), shared);
  EXPECT_FALSE(SharedShape::load({}));
}

TEST(EmitSurface, what_is_no_surface_is_refused) {
  EXPECT_FALSE(SharedShape::make(SphereShape{}));
  EXPECT_EQ(SharedShape::make(MeshShape{}).error().place, "shape.triangles");
  EXPECT_EQ(SharedShape::make(MeshShape{{{0, 0, 0}, {1, 0, 0}}, {{0, 1, 0}}, {}}).error().message,
            "has no triangle with an area");
  const auto place = [](const EmitterDef& def) { return check(def).error().place; };
  EmitterDef none{.from = {.shape = EmitShape::mesh}};
  EXPECT_EQ(place(none), "emitter.from.surface.shape");
  EXPECT_EQ(place(from(EmitShape::terrain, cube())), "emitter.from.surface.shape");
  EXPECT_EQ(place(from(EmitShape::mesh_edges, hills())), "emitter.from.surface.shape");
  EXPECT_EQ(place(from(EmitShape::box, cube())), "emitter.from.surface.shape");
  EmitterDef def = from(EmitShape::terrain, hills());
  EXPECT_TRUE(check(def));
  def.from.surface.scale = 0;
  EXPECT_EQ(place(def), "emitter.from.surface.scale");
  def.from.surface.scale = 1;
  def.from.surface.low_x = 12;
  EXPECT_EQ(place(def), "emitter.from.surface.low_x");
  def.from.surface.low_x = std::nan("");
  EXPECT_EQ(place(def), "emitter.from.surface.low_x");
  def.from.surface.low_x = 0;
  def.from.surface.low_z = 3, def.from.surface.high_z = 2;
  EXPECT_EQ(place(def), "emitter.from.surface.low_z");
}

}  // namespace physim::emit_emit_surface_test
