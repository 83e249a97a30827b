// Worlds over land whose rows know what is clear about them, beside worlds whose rows ask in every step.
#pragma once

#include <array>

#include "random_shots.hpp"
#include "rigid.hpp"
#include "scene_support.hpp"

namespace physim::test_clear {

using test::Random;
using test_scene::put;

inline constexpr std::uint32_t kPoints = 81;
inline constexpr double kSide = 100;  // of the land [m]

inline double height(double x, double z) {
  return 3 * std::sin(0.13 * x) * std::cos(0.11 * z) + 0.4 * std::sin(x + 2 * z);
}

inline HeightFieldShape hills() {
  const double spacing = kSide / (kPoints - 1);
  HeightFieldShape field{
      .columns = kPoints, .rows = kPoints, .spacing_x = spacing, .spacing_z = spacing, .heights = {}};
  for (std::uint32_t row = 0; row < kPoints; ++row)
    for (std::uint32_t column = 0; column < kPoints; ++column)
      field.heights.push_back(height(column * spacing, row * spacing));
  return field;
}
inline MeshShape mesh_of(const HeightFieldShape& field) {
  MeshShape mesh;
  for (std::uint32_t row = 0; row < kPoints; ++row)
    for (std::uint32_t column = 0; column < kPoints; ++column) {
      const std::uint32_t a = row * kPoints + column;
      mesh.vertices.push_back({column * field.spacing_x, field.heights[a], row * field.spacing_z});
      if (row + 1 == kPoints || column + 1 == kPoints) continue;
      mesh.triangles.push_back({a, a + kPoints, a + 1});
      mesh.triangles.push_back({a + 1, a + kPoints, a + kPoints + 1});
    }
  return mesh;
}

struct Shapes {
  ShapeId box, ball, post;
};

/// Land, and some things that stand on it.
inline Scene land(Random& r, Shapes& shapes) {
  Scene scene;
  const MaterialId stone = *scene.add_material({.restitution = 0.6, .friction = 0.3});
  put(scene, r.one_in(2) ? ShapeDef(hills()) : ShapeDef(mesh_of(hills())), {}, stone);
  shapes = {*scene.add_shape(BoxShape{{1, 2, 0.3}}), *scene.add_shape(SphereShape{1.5}),
            *scene.add_shape(CapsuleShape{0.2, 3})};
  for (int i = 0; i < 30; ++i) {
    const ShapeId one = std::array{shapes.box, shapes.ball, shapes.post}[i % 3];
    const double x = r.in(0, kSide), z = r.in(0, kSide);
    EXPECT_TRUE(scene.add({.shape = one, .transform = {.position = {x, height(x, z) + 1, z}}, .material = stone}));
  }
  return scene;
}

/// Two worlds to which the same is done. In one of them a plane turns, far below, which no box holds: there all rows
/// ask about everything in every step.
struct Pair {
  World clear, asking;
  std::vector<ProjectileId> ids;
  std::vector<InstanceId> things;

  template <class F>
  auto both(const F& f) {
    auto one = f(clear), other = f(asking);
    EXPECT_EQ(bool(one), bool(other));
    return one;
  }
};

inline Pair worlds_over(const Scene& scene) {
  WorldDef def{.environment = {.wind = {.velocity = {3, 0, 1}}}, .ground = {.mode = GroundMode::none}};
  Pair pair{make_world(def), make_world(def), {}, {}};
  Scene asked = scene;
  const InstanceId far = put(asked, PlaneShape{}, {0, -1e7, 0});
  EXPECT_TRUE(pair.clear.set_scene(asked));
  EXPECT_TRUE(asked.set_motion(far, SteadyMotion{.angular_velocity = {0, 1e-3, 0}}));
  EXPECT_TRUE(pair.asking.set_scene(asked));
  return pair;
}

inline ProjectileDef some_projectile(Random& r) {
  const std::array fidelities = {Fidelity::game(), Fidelity::constant_air(), Fidelity::small_arms(), Fidelity::game()};
  const int which = r.below(5);
  ProjectileDef p = which == 4 ? test::nasa_brick() : bullet();
  if (which == 4) p.fidelity = test::rigid(Integrator::rk4);
  if (which < 4) p.fidelity = fidelities[static_cast<std::size_t>(which)];
  if (which == 3) p.fidelity.motion = Motion::closed_form, p.fidelity.drag = DragModel::off;
  p.fidelity.precision = r.one_in(2) ? Precision::float32 : Precision::float64;
  return p;
}

inline void launch_some(Pair& pair, Random& r, int count) {
  for (int i = 0; i < count; ++i) {
    const ProjectileDef p = some_projectile(r);
    BodyDef body{.restitution = 0.7,
                 .collision = {.on_hit = std::array{OnHit::bounce, OnHit::stop, OnHit::pass,
                                                    OnHit::stick}[std::size_t(r.below(4))],
                               .radius = r.one_in(2) ? 0 : r.in(0.01, 0.3)}};
    if (r.one_in(5)) body.layers = 2;
    if (r.one_in(12)) body.collision.others = 2;
    Launch launch;
    const double x = r.in(0, kSide), z = r.in(0, kSide), speed = r.one_in(2) ? r.in(5, 40) : r.in(40, 400);
    launch.position = {x, height(x, z) + r.in(0.5, 6), z};
    launch.velocity = normalized(Vec3d{r.in(-1, 1), r.in(-0.1, 0.3), r.in(-1, 1)}) * speed;
    launch.spin.backspin = r.in(-100, 100);
    if (const auto id = pair.both([&](World& w) { return w.spawn(p, launch, body); })) pair.ids.push_back(*id);
  }
}

/// A land of its own, and two worlds over it: a random session.
struct Trial {
  explicit Trial(std::uint64_t seed) : r(seed), scene(land(r, shapes)), pair(worlds_over(scene)) {}

  Random r;
  Shapes shapes;
  Scene scene;
  Pair pair;
};

/// Something comes to stand in the way of somebody, or goes, or is elsewhere.
inline void edit(Pair& pair, Random& r, const Shapes& shapes) {
  const ProjectileId id = pair.ids[std::size_t(r.below(int(pair.ids.size())))];
  if (!pair.clear[id].is_alive()) return;
  const Vec3d ahead = pair.clear[id].position() + pair.clear[id].velocity() * r.in(0.02, 0.1);
  const Transform there{.position = ahead};
  const InstanceDef wall{.shape = r.one_in(2) ? shapes.box : shapes.ball, .transform = there};
  const std::size_t some = pair.things.empty() ? 0 : std::size_t(r.below(int(pair.things.size())));
  switch (pair.things.size() < 4 ? 0 : r.below(4)) {
    case 0:
      if (const auto made = pair.both([&](World& w) { return w.add_instance(wall); })) pair.things.push_back(*made);
      break;
    case 1: pair.both([&](World& w) { return w.move_instance(pair.things[some], there); }); break;
    case 2: {
      const auto layers = static_cast<std::uint32_t>(r.below(2));
      pair.both([&](World& w) { return w.set_instance_layers(pair.things[some], layers); });
      break;
    }
    default:
      pair.both([&](World& w) { return w.remove_instance(pair.things[some]); });
      pair.things.erase(pair.things.begin() + std::ptrdiff_t(some));
  }
}

/// Somebody is moved, turned or stopped, which leaves what is known about him behind.
inline void push(Pair& pair, Random& r) {
  const ProjectileId id = pair.ids[std::size_t(r.below(int(pair.ids.size())))];
  if (!pair.clear[id].is_alive()) return;
  const Vec3d velocity = r.vector(60);
  pair.both([&](World& w) { return w[id].set_velocity(velocity); });
}

inline void expect_the_same(const Pair& pair, int step) {
  ASSERT_EQ(pair.clear.size(), pair.asking.size()) << step;
  const auto one = pair.clear.events(), other = pair.asking.events();
  ASSERT_EQ(one.size(), other.size()) << step;
  for (std::size_t i = 0; i < one.size(); ++i) {
    ASSERT_EQ(one[i].kind, other[i].kind) << step;
    ASSERT_EQ(one[i].id, other[i].id) << step;
    ASSERT_EQ(one[i].instance, other[i].instance) << step;
    ASSERT_TRUE(test::same_bits(one[i].time, other[i].time)) << step;
    ASSERT_TRUE(test::same_bits(one[i].position, other[i].position)) << step;
    ASSERT_TRUE(test::same_bits(one[i].velocity, other[i].velocity)) << step;
  }
  for (const ProjectileId id : pair.ids) {
    ASSERT_EQ(pair.clear[id].is_alive(), pair.asking[id].is_alive()) << step;
    if (!pair.clear[id].is_alive()) continue;
    ASSERT_TRUE(test::same_bits(pair.clear[id].position(), pair.asking[id].position())) << step;
    ASSERT_TRUE(test::same_bits(pair.clear[id].velocity(), pair.asking[id].velocity())) << step;
  }
}

}  // namespace physim::test_clear
