// Scenes full of things of all kinds, and hits that are the same to the bit.
#pragma once

#include <gtest/gtest.h>

#include <array>

#include "collide/scene_support.hpp"

namespace physim::test_crowd {

using namespace test;

inline constexpr double kSide = 120;  // of the place [m]

inline HeightFieldShape hills() {
  HeightFieldShape field{.columns = 49, .rows = 41, .spacing_x = 2.5, .spacing_z = 3, .heights = {}};
  for (int i = 0; i < 49 * 41; ++i) field.heights.push_back(3 * std::sin(i * 0.7) + 4 * std::cos(i * 0.01));
  return field;
}

inline Transform somewhere(Random& r) {
  Transform t = random_transform(r, 0);
  t.position = {r.in(0, kSide), r.in(-3, 8), r.in(0, kSide)};
  return t;
}

/// Hills, large meshes turned and scaled, small ones, a heap, compounds, sensors, a plane
/// and what moves.
inline Scene crowd(Random& r) {
  Scene scene;
  const ShapeId hill = scene.add_shape(hills()).value(), large = scene.add_shape(ball(24, 0.2)).value();
  const ShapeId small = scene.add_shape(ball(3, 0)).value(), box = scene.add_shape(BoxShape{{1, 2, 0.3}}).value();
  const ShapeId two = scene.add_shape(CompoundShape{{{large, {.position = {1, 0, 0}}}, {box, {}}}}).value();
  const auto add = [&](const InstanceDef& def) { ASSERT_TRUE(scene.add(def)); };
  add({.shape = hill, .layers = 4});
  add({.shape = hill, .transform = {.position = {5, 1, kSide}, .rotation = {1, 0.1, 1, 0.05}, .scale = 0.7}});
  add({.shape = scene.add_shape(PlaneShape{}).value(), .transform = {.position = {0, -9, 0}}});
  for (int i = 0; i < 60; ++i) {
    InstanceDef def{.shape = std::array{large, small, box, two}[static_cast<std::size_t>(i) % 4],
                    .transform = somewhere(r)};
    def.transform.scale *= 3;
    def.layers = 1u << r.below(3);
    def.sensor = r.one_in(5);
    if (r.one_in(6)) def.motion = SteadyMotion{.velocity = r.vector(3)};
    add(def);
  }
  for (int i = 0; i < 40; ++i)
    add({.shape = i % 2 ? small : box, .transform = {.position = Vec3d{60, 5, 60} + r.vector(4)}});
  return scene;
}

/// A land of so many triangles that it does not fit into the fast caches, with holes in it, and what stands on it.
inline Scene land(Random& r, int things) {
  constexpr std::uint32_t kPoints = 97;
  MeshShape mesh;
  for (std::uint32_t i = 0; i < kPoints * kPoints; ++i) {
    const double x = i % kPoints * 1.25, z = i / kPoints * 1.25;
    mesh.vertices.push_back({x, 4 * std::sin(0.2 * x) * std::cos(0.17 * z) + r.in(-0.3, 0.3), z});
    if (i % kPoints + 1 == kPoints || i + kPoints >= kPoints * kPoints || r.one_in(40)) continue;
    mesh.triangles.push_back({i, i + kPoints, i + 1});
    mesh.triangles.push_back({i + 1, i + kPoints, i + kPoints + 1});
  }
  Scene scene;
  const ShapeId ground = scene.add_shape(mesh).value(), small = scene.add_shape(ball(3, 0)).value();
  const auto add = [&](const InstanceDef& def) { ASSERT_TRUE(scene.add(def)); };
  add({.shape = ground, .layers = 2});
  add({.shape = ground, .transform = {.position = {40, 3, 9}, .rotation = {1, 0.2, 0.3, 0.1}, .scale = 0.4}});
  add({.shape = scene.add_shape(PlaneShape{}).value(), .transform = {.position = {0, -9, 0}}, .layers = 4});
  for (int i = 0; i < things; ++i) {
    InstanceDef def{.shape = i % 9 == 8 ? ground : small, .transform = somewhere(r), .layers = 1u << r.below(3)};
    if (i % 9 == 8) def.transform.scale = 0.05;
    if (r.one_in(9)) def.motion = SteadyMotion{.velocity = r.vector(3)};
    add(def);
  }
  return scene;
}

/// No large mesh, but too much for the fast caches: long batches are sorted.
inline Scene wide_hills(Random& r) {
  HeightFieldShape field{.columns = 401, .rows = 401, .spacing_x = 0.3, .spacing_z = 0.3, .heights = {}};
  for (int i = 0; i < 401 * 401; ++i)
    field.heights.push_back(3 * std::sin(i % 401 * 0.06) + 2 * std::cos(i * 0.0002) + r.in(-0.05, 0.05));
  Scene scene;
  const ShapeId hill = scene.add_shape(field).value(), small = scene.add_shape(ball(3, 0)).value();
  EXPECT_TRUE(scene.add({.shape = hill}));
  for (int i = 0; i < 50; ++i) EXPECT_TRUE(scene.add({.shape = small, .transform = somewhere(r), .layers = 2}));
  return scene;
}

inline void expect_same(const SceneHit& a, const SceneHit& b, std::size_t i) {
  ASSERT_EQ(a.instance, b.instance) << i;
  ASSERT_EQ(a.part, b.part) << i;
  ASSERT_EQ(a.primitive, b.primitive) << i;
  ASSERT_EQ(a.position, b.position) << i;
  ASSERT_EQ(a.normal, b.normal) << i;
  ASSERT_EQ(a.velocity, b.velocity) << i;
  ASSERT_EQ(a.time, b.time) << i;
  ASSERT_EQ(a.material, b.material) << i;
  ASSERT_EQ(a.entering, b.entering) << i;
  ASSERT_EQ(a.starts_inside, b.starts_inside) << i;
}

}  // namespace physim::test_crowd
