// Scenes: what segments and spheres meet, beside a reference that is other code; and how things come, go and move.
#include <set>

#include "collide/reference.hpp"
#include "collide/scene_support.hpp"
#include "math/quat.hpp"
#include "support.hpp"

namespace physim::collide_scene_test {

using namespace test;

template <class Shape>
void expect_casts_of(const Shape& shape, const std::string& what, int casts) {
  Random r(17);
  const SignedDistance distance = distance_of(shape);
  for (const double far : {0.0, 10.0, 1e6}) {
    Scene scene;
    Transform at = far == 0 ? Transform{} : random_transform(r, far);
    const auto added = must(scene.add_shape(shape));
    const auto thing = must(scene.add({.shape = added, .transform = at}));
    for (int i = 0; i < casts && !testing::Test::HasFailure(); ++i) {
      SceneSegment s = random_segment(r, at.position, at.scale);
      s.radius = r.one_in(2) ? 0 : r.in(0.01, 1);
      const Point from = into_frame(at, point(s.from)), along = into_frame(at, point(s.to)) - from;
      const auto gap = [&](Real t) { return distance(from + along * t) * Real(at.scale) - Real(s.radius); };
      const Met met = first_zero(gap, norm(along) * Real(at.scale));
      const SceneHit hit = scene.first_hit(s);
      EXPECT_EQ(unlike(hit, s, met, gap), "") << what << " at " << far << ", cast " << i;
      EXPECT_EQ(scene.any_hit(s), static_cast<bool>(hit)) << what;
      if (!hit) continue;
      EXPECT_EQ(hit.instance, thing);
      EXPECT_NEAR(length(hit.normal), 1, 1e-12);
      EXPECT_LE(dot(hit.normal, s.to - s.from), 0) << what << ": against the way";
    }
  }
}

TEST(Scene, casts_agree_with_signed_distances) {
  const int casts = 1500;
  expect_casts_of(SphereShape{0.8}, "sphere", casts);
  expect_casts_of(CapsuleShape{0.3, 0.9}, "capsule", casts);
  expect_casts_of(CapsuleShape{0.7, 0}, "capsule without a middle", casts);
  expect_casts_of(BoxShape{{0.2, 0.5, 1.1}}, "box", casts);
  expect_casts_of(BoxShape{{1, 0.0005, 1}}, "sheet", casts);
  expect_casts_of(CylinderShape{0.6, 0.4}, "cylinder", casts);
  expect_casts_of(PlaneShape{}, "plane", casts);
}

Met of_triangles(const std::vector<SignedDistance>& triangles, const Point& from, const Point& along, Real radius,
                 SignedDistance& who) {
  Met best;
  best.least = 1e30L;
  for (const SignedDistance& distance : triangles) {
    const auto gap = [&](Real t) { return distance(from + along * t) - radius; };
    const Met met = first_zero(gap, norm(along));
    const bool first = met.hit ? !best.hit || met.part < best.part : !best.hit && met.least < best.least;
    if (first) best = met, who = distance;
  }
  return best;
}

MeshShape triangles_of(const HeightFieldShape& field) {
  MeshShape mesh;
  for (std::uint32_t row = 0; row < field.rows; ++row)
    for (std::uint32_t column = 0; column < field.columns; ++column)
      mesh.vertices.push_back(
          {column * field.spacing_x, field.heights[row * field.columns + column], row * field.spacing_z});
  for (std::uint32_t row = 0; row + 1 < field.rows; ++row)
    for (std::uint32_t column = 0; column + 1 < field.columns; ++column) {
      const std::uint32_t a = row * field.columns + column, b = a + field.columns;
      mesh.triangles.push_back({a, b, a + 1});
      mesh.triangles.push_back({a + 1, b, b + 1});
    }
  return mesh;
}

TEST(Scene, what_is_nearest_of_a_field_is_that_of_its_triangles) {
  Random r(21);
  HeightFieldShape field{.columns = 6, .rows = 5, .spacing_x = 0.5, .spacing_z = 0.8, .heights = {}};
  for (int i = 0; i < 30; ++i) field.heights.push_back(r.in(-1, 1));
  const MeshShape mesh = triangles_of(field);
  Scene scene, other;
  ASSERT_TRUE(scene.add({.shape = scene.add_shape(field).value()}));
  ASSERT_TRUE(other.add({.shape = other.add_shape(mesh).value()}));
  for (int i = 0; i < 5000; ++i) {
    Vec3d p{r.in(-1, 3.5), r.in(-2, 2), r.in(-1, 4.2)};
    if (r.one_in(3)) p = mesh.vertices[r.below(mesh.vertices.size())];  // in the corner of up to six triangles
    if (r.one_in(3)) p += Vec3d{r.in(-1, 1), r.in(-1, 1), r.in(-1, 1)} * std::pow(10, r.in(-10, -1));
    const double within = r.one_in(2) ? kInfinity : std::pow(10, r.in(-10, 1));
    const SceneNearest near = scene.nearest(p, within), expected = other.nearest(p, within);
    ASSERT_EQ(static_cast<bool>(near), static_cast<bool>(expected)) << i;
    if (!near) continue;
    ASSERT_NEAR(near.distance, expected.distance, 1e-14) << i;
  }
}

TEST(Scene, spheres_meet_meshes_and_fields_where_the_nearest_triangle_says) {
  Random r(3);
  const MeshShape mesh = ball(4, 0.2);
  HeightFieldShape field{.columns = 4, .rows = 5, .spacing_x = 0.5, .spacing_z = 0.4, .heights = {}};
  for (int i = 0; i < 20; ++i) field.heights.push_back(r.in(-0.3, 0.3));
  const MeshShape as_mesh = triangles_of(field);
  const auto expect = [&](const ShapeDef& shape, const MeshShape& triangles, const std::string& what) {
    std::vector<SignedDistance> all;
    for (const auto& t : triangles.triangles)
      all.push_back(distance_of_triangle(point(triangles.vertices[t[0]]), point(triangles.vertices[t[1]]),
                                         point(triangles.vertices[t[2]])));
    Scene scene;
    const auto thing = scene.add({.shape = scene.add_shape(shape).value()});
    ASSERT_TRUE(thing);
    for (int i = 0; i < 150 && !testing::Test::HasFailure(); ++i) {
      SceneSegment s = random_segment(r, {0.5, 0, 0.5}, 0.7);
      s.radius = r.in(0.02, 0.5);
      SignedDistance who;
      const Met met = of_triangles(all, point(s.from), point(s.to - s.from), s.radius, who);
      if (met.hit && met.part == 0) continue;
      const auto gap = [&](Real t) { return who(point(s.from) + point(s.to - s.from) * t) - Real(s.radius); };
      EXPECT_EQ(unlike(scene.first_hit(s), s, met, gap), "") << what << ", cast " << i;
    }
  };
  expect(mesh, mesh, "mesh");
  expect(field, as_mesh, "height field");
}

/// Moeller and Trumbore's test in long double, over all triangles.
Met by_all_triangles(const MeshShape& mesh, const SceneSegment& s) {
  Met best;
  const Point from = point(s.from), along = point(s.to) - from;
  for (const auto& t : mesh.triangles) {
    const Point a = point(mesh.vertices[t[0]]), ab = point(mesh.vertices[t[1]]) - a,
                ac = point(mesh.vertices[t[2]]) - a;
    const Point across = outer(along, ac);
    const Real det = inner(ab, across);
    if (det == 0) continue;
    const Point reach = from - a;
    const Real u = inner(reach, across) / det;
    const Point other = outer(reach, ab);
    const Real v = inner(along, other) / det, part = inner(ac, other) / det;
    if (u < 0 || v < 0 || u + v > 1 || part < 0 || part > 1) continue;
    if (!best.hit || part < best.part) best = {true, part, 0, det / (norm(along) * norm(outer(ab, ac)))};
  }
  return best;
}

TEST(Scene, points_meet_meshes_where_a_test_of_all_triangles_says) {
  Random r(5);
  const MeshShape mesh = ball(12, 0.15);
  Scene scene;
  const auto shape = must(scene.add_shape(mesh));
  EXPECT_TRUE(scene.info(shape)->closed);
  ASSERT_TRUE(scene.add({.shape = shape}));
  int hits = 0;
  for (int i = 0; i < 20000 && !HasFailure(); ++i) {
    const SceneSegment s = random_segment(r, {}, 1);
    const Met met = by_all_triangles(mesh, s);
    const SceneHit hit = scene.first_hit(s);
    ASSERT_EQ(static_cast<bool>(hit), met.hit) << i;
    if (!met.hit) continue;
    ++hits;
    const double slope = std::max(1e-9, std::fabs(static_cast<double>(met.slope)));
    EXPECT_LT(std::fabs(static_cast<double>(met.part) - hit.part) * length(s.to - s.from), 1e-13 * largest(s) / slope)
        << i;
    EXPECT_EQ(hit.entering, dot(hit.normal, s.to - s.from) < 0) << i;
  }
  EXPECT_GT(hits, 5000);
}

/// Out of a closed body there is no way that meets nothing: through faces, edges and vertices.
TEST(Scene, closed_meshes_do_not_leak) {
  Random r(6);
  const MeshShape mesh = ball(10, 0.1);
  for (const double far : {0.0, 1e6}) {
    Scene scene;
    const Vec3d middle{far, -far, 0.5 * far};
    ASSERT_TRUE(scene.add({.shape = scene.add_shape(mesh).value(), .transform = {.position = middle}}));
    for (int i = 0; i < 60000; ++i) {
      const Vec3d from = middle + random_vector(r, 0.3);
      const auto& t = mesh.triangles[static_cast<std::size_t>(r.in(0, double(mesh.triangles.size()) - 1e-9))];
      const Vec3d a = middle + mesh.vertices[t[0]], b = middle + mesh.vertices[t[1]];
      const Vec3d aim = i % 3 == 0 ? a : i % 3 == 1 ? a + (b - a) * r.in(0, 1) : middle + random_vector(r, 3);
      const Vec3d to = from + (aim - from) * (5 / std::max(1e-3, length(aim - from)));
      const SceneHit hit = scene.first_hit({from, to});
      ASSERT_TRUE(hit) << i << " at " << far;
      ASSERT_FALSE(hit.entering);
      ASSERT_TRUE(scene.first_hit({to, from}));
    }
  }
}

/// Entries and exits in order: their differences are thicknesses.
TEST(Scene, all_hits_tell_thicknesses) {
  Scene scene;
  const auto plank = scene.add_shape(BoxShape{{0.01, 1, 1}}), sphere = scene.add_shape(SphereShape{0.5});
  const auto shell = scene.add_shape(ball(8, 0));
  const auto first = scene.add({.shape = *plank, .transform = {.position = {10, 0, 0}}});
  const auto second = scene.add({.shape = *sphere, .transform = {.position = {20, 0.3, 0}}, .sensor = true});
  const auto third = scene.add({.shape = *shell, .transform = {.position = {30, 0, 0}}});
  ASSERT_TRUE(first && second && third);
  const auto hits = scene.all_hits({{0, 0, 0}, {100, 0, 0}});
  ASSERT_EQ(hits.size(), 6u);
  for (std::size_t i = 0; i < 6; ++i) {
    EXPECT_EQ(hits[i].entering, i % 2 == 0) << i;
    EXPECT_EQ(hits[i].instance, i < 2 ? *first : i < 4 ? *second : *third) << i;
  }
  EXPECT_NEAR(hits[1].position.x - hits[0].position.x, 0.02, 1e-13);
  EXPECT_NEAR(hits[3].position.x - hits[2].position.x, 0.8, 1e-13) << "a chord 0.3 beside the middle of a sphere";
  EXPECT_NEAR(hits[5].position.x - hits[4].position.x, 2, 0.2);
  EXPECT_EQ(hits[0].normal, (Vec3d{-1, 0, 0}));
  EXPECT_EQ(hits[1].normal, (Vec3d{1, 0, 0}));
  EXPECT_EQ(scene.all_hits({{0, 0, 0}, {100, 0, 0}}, {.sensors = false}).size(), 4u);
  EXPECT_EQ(scene.all_hits({{10, 0, 0}, {100, 0, 0}}).size(), 6u) << "it starts inside of the plank";
  EXPECT_TRUE(scene.first_hit({{10, 0, 0}, {100, 0, 0}}).starts_inside);
}

/// Parts that share a face are entered there once each: who counts entries and exits finds where all of it ends.
TEST(Scene, parts_of_a_compound_that_share_a_face_are_told_each) {
  Scene scene;
  const ShapeId thin = *scene.add_shape(BoxShape{{0.1, 1, 1}}), thick = *scene.add_shape(BoxShape{{0.3, 1, 1}});
  const ShapeId both =
      *scene.add_shape(CompoundShape{{{thin, {.position = {0.1, 0, 0}}}, {thick, {.position = {0.3, 0, 0}}}}});
  ASSERT_TRUE(scene.add({.shape = both}));
  const auto hits = scene.all_hits({{-1, 0.2, 0.3}, {4, 0.2, 0.3}});
  ASSERT_EQ(hits.size(), 4u);
  for (std::size_t i = 0; i < 4; ++i) {
    EXPECT_EQ(hits[i].entering, i < 2);
    EXPECT_NEAR(hits[i].position.x, i < 2 ? 0 : i == 2 ? 0.2 : 0.6, 1e-12);
  }
}

/// A shape whose surface is the plane y = 0 about the origin, everything else below it.
std::vector<ShapeDef> shapes_below_the_origin() {
  ConvexHullShape hull;
  for (const double x : {-5.0, 5.0})
    for (const double z : {-5.0, 5.0}) hull.points.insert(hull.points.end(), {{x, 0, z}, {x, -3, z}});
  return {PlaneShape{}, hull, MeshShape{{{-5, 0, -5}, {-5, 0, 5}, {5, 0, 5}, {5, 0, -5}}, {{0, 1, 2}, {0, 2, 3}}, {}},
          HeightFieldShape{3, 3, 4, 4, std::vector<double>(9, 0.0)}};
}

TEST(Scene, what_leaves_from_a_surface_does_not_meet_it) {
  const auto expect = [](const ShapeDef& shape, const Vec3d& at) {
    Scene scene;
    add_thing(scene, shape, {.transform = {.position = at}});
    const Vec3d from{0.5, 0, 0.25};
    for (const Vec3d& way : {Vec3d{0, 1, 0}, Vec3d{1, 1e-3, 0}, Vec3d{-1, 2, 0.5}, Vec3d{1, 0, 0.5}}) {
      EXPECT_FALSE(scene.first_hit({from, from + way})) << shape.index() << ": " << way.y;
      EXPECT_TRUE(scene.all_hits({from, from + way}).empty()) << shape.index();
    }
    const SceneHit hit = scene.first_hit({from, {0.5, -1, 0.5}});
    EXPECT_TRUE(hit && hit.part == 0 && hit.entering && !hit.starts_inside) << shape.index();
    EXPECT_EQ(hit.normal, (Vec3d{0, 1, 0}));
  };
  for (const ShapeDef& shape : shapes_below_the_origin())
    expect(shape, std::holds_alternative<HeightFieldShape>(shape) ? Vec3d{-4, 0, -4} : Vec3d{});
  expect(BoxShape{{5, 1, 5}}, {0, -1, 0});
  expect(CylinderShape{5, 1}, {0, -1, 0});
  Scene scene;
  add_thing(scene, CylinderShape{1, 1});
  EXPECT_FALSE(scene.first_hit({{1, -0.5, 0}, {1, 0.5, 0}})) << "along its side";
}

/// Heights that are numbers, but none that a float could tell apart or invert.
TEST(Scene, meshes_whose_triangles_nearly_agree_in_a_coordinate_are_met) {
  for (const double tiny : {1e-300, 1e-40, 3e-39, 1e-37}) {
    MeshShape hill;
    constexpr int kSide = 40;
    for (int i = 0; i <= kSide; ++i)
      for (int j = 0; j <= kSide; ++j) hill.vertices.push_back({i - 20.0, (i * j) % 7 == 0 ? -tiny : 0, j - 20.0});
    for (std::uint32_t i = 0; i < kSide; ++i)
      for (std::uint32_t j = 0; j < kSide; ++j) {
        const std::uint32_t a = i * (kSide + 1) + j;
        hill.triangles.push_back({a, a + 1, a + kSide + 1});
        hill.triangles.push_back({a + 1, a + kSide + 2, a + kSide + 1});
      }
    Scene scene;
    const auto shape = must(scene.add_shape(hill));
    ASSERT_TRUE(scene.add({.shape = shape}));
    Random r(3);
    for (int i = 0; i < 100; ++i) {
      const Vec3d at{r.in(-19, 19), 0, r.in(-19, 19)};
      const SceneHit hit = scene.first_hit({at + Vec3d{0, 1, 0}, at - Vec3d{0, 1, 0}});
      ASSERT_TRUE(hit) << tiny;
      EXPECT_NEAR(hit.part, 0.5, 1e-12);
    }
  }
}

/// A scene of many things says what each of them alone says, whatever came, went and moved before.
TEST(Scene, things_come_go_and_move) {
  Random r(9);
  Scene scene;
  const ShapeId shapes[] = {*scene.add_shape(SphereShape{0.5}), *scene.add_shape(BoxShape{{0.3, 0.6, 0.2}}),
                            *scene.add_shape(CapsuleShape{0.2, 0.5}), *scene.add_shape(ball(3, 0))};
  std::vector<std::pair<InstanceId, InstanceDef>> there;
  for (int round = 0; round < 1200; ++round) {
    if (there.size() < 40 || r.one_in(2)) {
      InstanceDef def{.shape = shapes[round % 4], .transform = random_transform(r, 20), .layers = 1u << (round % 3)};
      def.sensor = r.one_in(5);
      there.emplace_back(*scene.add(def), def);
    } else {
      const auto i = static_cast<std::size_t>(r.in(0, double(there.size()) - 1e-9));
      if (r.one_in(2)) {
        there[i].second.transform = random_transform(r, 20);
        EXPECT_TRUE(scene.move(there[i].first, there[i].second.transform));
      } else {
        EXPECT_TRUE(scene.remove(there[i].first));
        EXPECT_FALSE(scene.remove(there[i].first)) << "it is gone";
        EXPECT_FALSE(scene.instance(there[i].first));
        there.erase(there.begin() + static_cast<std::ptrdiff_t>(i));
      }
    }
    if (round % 120 != 119) continue;
    ASSERT_EQ(scene.size(), there.size());
    for (int cast = 0; cast < 8; ++cast) {
      SceneSegment s = random_segment(r, {}, 10);
      s.radius = r.one_in(2) ? 0 : 0.1;
      const SceneFilter filter{.layers = r.one_in(2) ? 1u : ~0u, .sensors = r.one_in(2)};
      SceneHit best;
      std::set<InstanceId> near;
      double distance = kInfinity;
      for (const auto& [id, def] : there) {
        Scene alone;
        const ShapeId own[] = {*alone.add_shape(SphereShape{0.5}), *alone.add_shape(BoxShape{{0.3, 0.6, 0.2}}),
                               *alone.add_shape(CapsuleShape{0.2, 0.5}), *alone.add_shape(ball(3, 0))};
        InstanceDef copy = def;
        copy.shape = own[std::ranges::find(shapes, def.shape) - shapes];
        ASSERT_TRUE(alone.add(copy));
        SceneHit hit = alone.first_hit(s, filter);
        hit.instance = hit ? id : InstanceId{};
        if (hit && (!best || hit.part < best.part || (hit.part == best.part && id.index < best.instance.index)))
          best = hit;
        if (!alone.overlaps(s.from, 2, filter).empty()) near.insert(id);
        distance = std::min(distance, alone.nearest(s.from, kInfinity, filter).distance);
      }
      const SceneHit hit = scene.first_hit(s, filter);
      ASSERT_EQ(hit.instance, best.instance);
      EXPECT_EQ(hit.part, best.part);
      EXPECT_EQ(scene.nearest(s.from, kInfinity, filter).distance, distance);
      const auto overlaps = scene.overlaps(s.from, 2, filter);
      EXPECT_EQ(std::set<InstanceId>(overlaps.begin(), overlaps.end()), near);
    }
  }
}

TEST(Scene, many_at_once_are_as_one_by_one) {
  Random r(12);
  Scene scene;
  const auto shape = scene.add_shape(ball(6, 0.1));
  for (int i = 0; i < 30; ++i) ASSERT_TRUE(scene.add({.shape = *shape, .transform = random_transform(r, 15)}));
  std::vector<SceneSegment> segments;
  for (int i = 0; i < 3000; ++i) segments.push_back(random_segment(r, {}, 10));
  std::vector<SceneHit> hits(segments.size()), lent(segments.size());
  scene.first_hits(segments, hits);
  const auto pool = make_thread_pool(3);
  scene.first_hits(segments, lent, {}, pool.get());
  for (std::size_t i = 0; i < segments.size(); ++i) {
    const SceneHit one = scene.first_hit(segments[i]);
    EXPECT_EQ(hits[i].instance, one.instance);
    EXPECT_EQ(hits[i].part, one.part);
    EXPECT_EQ(lent[i].instance, one.instance);
    EXPECT_EQ(lent[i].part, one.part);
    EXPECT_EQ(lent[i].primitive, one.primitive);
  }
}

TEST(Scene, compounds_are_their_parts) {
  Random r(14);
  Scene scene, parts;
  const auto box = scene.add_shape(BoxShape{{0.5, 0.1, 0.5}}), leg = scene.add_shape(CylinderShape{0.05, 0.4});
  const Transform top{.position = {0, 0.8, 0}}, foot{.position = {0.3, 0.4, 0.3}, .rotation = {1, 0.1, 0, 0}};
  const auto table = must(scene.add_shape(CompoundShape{{{*box, top}, {*leg, foot}}}));
  ASSERT_TRUE(scene.add({.shape = table}));
  ASSERT_TRUE(parts.add({.shape = parts.add_shape(BoxShape{{0.5, 0.1, 0.5}}).value(), .transform = top}));
  ASSERT_TRUE(parts.add({.shape = parts.add_shape(CylinderShape{0.05, 0.4}).value(), .transform = foot}));
  for (int i = 0; i < 3000; ++i) {
    SceneSegment s = random_segment(r, {0, 0.5, 0}, 0.8);
    s.radius = r.one_in(2) ? 0 : 0.07;
    const SceneHit hit = scene.first_hit(s), part = parts.first_hit(s);
    ASSERT_EQ(static_cast<bool>(hit), static_cast<bool>(part)) << i;
    if (!hit) continue;
    EXPECT_NEAR(hit.part, part.part, 1e-14) << i;
    EXPECT_EQ(hit.primitive + 1, part.instance.index) << i;
    EXPECT_NEAR(scene.nearest(s.from).distance, parts.nearest(s.from).distance, 1e-14);
  }
  EXPECT_FALSE(scene.remove_shape(*box)) << "the table has it";
  EXPECT_TRUE(scene.remove_shape(scene.add_shape(SphereShape{}).value()));
}

TEST(Scene, materials_are_those_of_triangles_or_of_the_thing) {
  Scene scene;
  const auto steel = scene.add_material({.name = "steel"}), wood = scene.add_material({.name = "wood"});
  MeshShape two{.vertices = {{0, 0, 0}, {0, 1, 0}, {0, 0, 1}, {0, 1, 1}},
                .triangles = {{0, 1, 2}, {2, 1, 3}},
                .materials = {*steel, MaterialId{}}};
  ASSERT_TRUE(scene.add({.shape = scene.add_shape(two).value(), .material = *wood}));
  two.materials.clear();
  ASSERT_TRUE(
      scene.add({.shape = scene.add_shape(two).value(), .transform = {.position = {1, 0, 0}}, .material = *wood}));
  const auto name_at = [&](double x) {
    return scene.material(scene.first_hit({{x - 0.5, 0.2, 0.2}, {x + 0.5, 0.2, 0.2}}).material).name;
  };
  EXPECT_EQ(name_at(0), "steel");
  EXPECT_EQ(name_at(1), "wood");
}

/// A point that slides along a slope far from the origin is looked for by spheres of a tenth of a nanometre, which sink
/// by less than a thousandth of their way.
TEST(Scene, tiny_spheres_that_sink_slowly_into_large_triangles_meet_them) {
  Random r(31);
  int casts = 0;
  for (int i = 0; i < 400; ++i) {
    const Vec3d a{r.in(-3000, 3000), r.in(-300, 300), r.in(-3000, 3000)};
    const Vec3d b = a + Vec3d{r.in(-20, 20), r.in(-90, 90), r.in(150, 300)},
                c = a + Vec3d{r.in(150, 300), r.in(-90, 90), r.in(-20, 20)};
    const Vec3d normal = normalized(cross(b - a, c - a)), middle = (a + b + c) * (1.0 / 3);
    Scene scene;
    const bool is_hull = i % 4 == 0;
    const auto shape = must(is_hull ? scene.add_shape(ConvexHullShape{{a, b, c, middle - normal * 50}})
                                    : scene.add_shape(MeshShape{{a, b, c}, {{0, 1, 2}}, {}}));
    ASSERT_TRUE(scene.add({.shape = shape}));
    for (int k = 0; k < 20; ++k, ++casts) {
      const Vec3d along = normalized(cross(normal, random_vector(r, 1)));
      const double radius = 1e-10, sinks = r.in(3e-10, 3e-9), way = r.in(1e-6, 1e-4);
      // Places are off by some 1e-12 m.
      const Vec3d from = middle + along * r.in(-20, 20) + normal * (radius + r.in(5e-12, 5e-11));
      const SceneHit hit = scene.first_hit({from, from + along * way - normal * sinks, radius});
      ASSERT_TRUE(hit) << i << ", " << k;
      EXPECT_GT(std::abs(dot(hit.normal, normal)), hit.starts_inside ? 0 : 1 - 1e-12);
    }
  }
  EXPECT_EQ(casts, 8000);
}

TEST(Scene, nearest_tells_the_primitive_and_the_material_that_a_hit_there_has) {
  Random r(29);
  Scene scene;
  const MaterialId steel = *scene.add_material({.name = "steel"}), wood = *scene.add_material({.name = "wood"}),
                   glass = *scene.add_material({.name = "glass"});
  MeshShape roof{{{-1, 1, -1}, {-1, 1, 1}, {0, 2, -1}, {0, 2, 1}, {1, 1, -1}, {1, 1, 1}},
                 {{0, 1, 2}, {2, 1, 1}, {2, 1, 3}, {2, 3, 4}, {4, 3, 5}},  // the second has no area
                 {steel, steel, wood, glass, MaterialId{}}};
  const auto tiles = scene.add_shape(roof), wall = scene.add_shape(BoxShape{{1, 0.5, 0.1}});
  const auto house = must(scene.add_shape(CompoundShape{{{*wall, {.position = {0, 0.5, -1}}, glass},
                                                         {*wall, {.position = {0, 0.5, 1}}},
                                                         {*tiles, {.position = {0, 0.1, 0}, .scale = 1.2}, wood}}}));
  ASSERT_TRUE(scene.add({.shape = house, .transform = {.rotation = {1, 0, 0.3, 0}}, .material = steel}));
  ASSERT_TRUE(scene.add({.shape = *tiles, .transform = {.position = {4, 0, 0}, .scale = 0.7}, .material = glass}));
  ASSERT_TRUE(
      scene.add({.shape = *scene.add_shape(HeightFieldShape{4, 3, 1, 1.5, {0, 1, 0, 1, 1, 0, 2, 0, 0, 1, 0, 1}}),
                 .transform = {.position = {7, 0, -2}},
                 .material = wood}));
  std::set<std::tuple<std::uint32_t, std::uint32_t, std::uint32_t>> seen;
  for (int i = 0; i < 5000; ++i) {
    const Vec3d p{r.in(-2, 11), r.in(-1, 4), r.in(-3, 3)};
    const SceneNearest near = scene.nearest(p, 3);
    if (!near || near.distance < 1e-3) continue;
    const Vec3d way = near.position - p;
    const SceneHit hit = scene.first_hit({p, p + way * 1.001});
    if (!hit || std::abs(std::abs(dot(hit.normal, way)) - near.distance) > 1e-9)
      continue;  // at edges another may be met
    ASSERT_EQ(near.instance, hit.instance) << i;
    EXPECT_EQ(near.primitive, hit.primitive) << i;
    EXPECT_EQ(near.material, hit.material) << i;
    seen.insert({near.instance.index, near.primitive, near.material.index});
  }
  EXPECT_GE(seen.size(), 22u) << "6 of the house, 4 of the tiles, 12 of the field";
  EXPECT_EQ(scene.nearest(rotate(normalized(Quatd{1, 0, 0.3, 0}), Vec3d{0, 0.5, 1})).primitive, 1u)
      << "inside of a part";
}

}  // namespace physim::collide_scene_test
