// Queries that see projectiles: in spheres and boxes, and along ways, beside closed forms and beside looking at all.
#include "math/quat.hpp"
#include "random_shots.hpp"
#include "world/thing_support.hpp"

namespace physim::world_projectile_queries_test {

using namespace test_things;
using test::Random;

BodyDef ball_of(double radius, std::uint32_t layers = 1) {
  BodyDef body = body_that(OnHit::stop, radius);
  body.layers = layers;
  return body;
}
ProjectileId put(World& world, const Vec3d& place, const BodyDef& body, double delay = 0) {
  const auto id = must(world.spawn(stone(), {.position = place}, body, delay));
  return id;
}
using Ids = std::vector<ProjectileId>;

/// A crowd on several rungs that flies, sleeps, sticks and is kinematic.
World crowd(Random& r) {
  World world = make_world(nothing_but_things());
  for (int i = 0; i < 300; ++i) {
    BodyDef body = ball_of(i % 3 == 0 ? 0 : r.in(0.1, 1.5), 1u << r.below(3));
    body.kinematic = i % 7 == 0;
    body.gravity_scale = i % 2;
    ProjectileDef p = stone();
    p.fidelity.precision = i % 4 == 0 ? Precision::float32 : Precision::float64;
    if (i % 5 == 0) p.fidelity.motion = Motion::closed_form;
    const Vec3d place{r.in(-10, 10), r.in(-10, 10), r.in(-10, 10)}, v{r.in(-3, 3), r.in(-3, 3), r.in(-3, 3)};
    EXPECT_TRUE(world.spawn(p, {.position = place, .velocity = v}, body, i % 11 == 0 ? 9.0 : 0.0));
  }
  run_for(world, 0.5);
  const Ids all = world.ids();
  for (std::size_t i = 0; i < all.size(); i += 6) static_cast<void>(world[all[i]].sleep());
  for (std::size_t i = 0; i < all.size(); i += 9) EXPECT_TRUE(world[all[i]].despawn());
  return world;
}
double radius_of(const World& world, ProjectileId id) { return world[id].body().collision.radius; }
bool is_launched(const World& world, ProjectileId id) { return world[id].status() == LifeStatus::in_flight; }

TEST(ProjectileQueries, find_in_spheres_what_looking_at_all_finds) {
  Random r(561);
  const World world = crowd(r);
  std::size_t found = 0;
  for (int i = 0; i < 1000; ++i) {
    const Vec3d middle{r.in(-12, 12), r.in(-12, 12), r.in(-12, 12)};
    const double radius = r.one_in(5) ? 0 : r.in(0, 6);
    const auto layers = static_cast<std::uint32_t>(r.below(8));
    Ids expected;
    for (const ProjectileId id : world.ids())
      if (is_launched(world, id) && (world[id].layers() & layers) != 0 &&
          length(world[id].position() - middle) <= radius + radius_of(world, id))
        expected.push_back(id);
    EXPECT_EQ(*world.projectiles_in(middle, radius, layers), expected) << i;
    found += expected.size();
  }
  EXPECT_GT(found, 1000u);
}

/// The distance from a box by the nearest of its points, found coordinate by coordinate in its own frame.
TEST(ProjectileQueries, find_in_boxes_what_looking_at_all_finds) {
  Random r(562);
  const World world = crowd(r);
  std::size_t found = 0;
  for (int i = 0; i < 300; ++i) {
    const double angle = r.in(0, 3);
    const Transform at{.position = {r.in(-9, 9), r.in(-9, 9), r.in(-9, 9)},
                       .rotation = {2 * std::cos(angle / 2), 0, 2 * std::sin(angle / 2), 0},
                       .scale = r.in(0.5, 2)};
    const Vec3d half{r.in(0, 4), r.in(0, 4), r.in(0, 4)};
    const Vec3d x{std::cos(angle), 0, -std::sin(angle)}, z{std::sin(angle), 0, std::cos(angle)};
    Ids expected;
    for (const ProjectileId id : world.ids()) {
      const Vec3d off = world[id].position() - at.position;
      const auto out = [&](double along, double edge) { return std::max(std::abs(along) - edge * at.scale, 0.0); };
      const double apart = std::hypot(out(dot(off, x), half.x), out(off.y, half.y), out(dot(off, z), half.z));
      if (is_launched(world, id) && apart <= radius_of(world, id)) expected.push_back(id);
    }
    EXPECT_EQ(*world.projectiles_in(at, half), expected) << i;
    found += expected.size();
  }
  EXPECT_GT(found, 1000u);
}

/// A ball that is cast along x at a height touches one of radius r at x - sqrt((R + r)^2 - h^2).
TEST(ProjectileQueries, cast_in_order_of_the_way) {
  World world = make_world(nothing_but_things());
  const ProjectileId far = put(world, {30, 0, 0}, ball_of(2)), near = put(world, {10, 1, 0}, ball_of(1.5)),
                     twin = put(world, {10, -1, 0}, ball_of(1.5)), point = put(world, {20, 0.5, 0}, ball_of(0));
  put(world, {-5, 0, 0}, ball_of(1)), put(world, {50, 0, 0}, ball_of(1)), put(world, {20, 9, 0}, ball_of(1));
  put(world, {15, 0, 0}, ball_of(1), 5);  // not launched yet
  const auto ray = *world.projectiles_along({0, 0, 0}, {40, 0, 0});
  ASSERT_EQ(ray.size(), 3u);
  EXPECT_EQ(ray[0].id, near);
  EXPECT_EQ(ray[1].id, twin) << "touched at once, the lower index comes first";
  EXPECT_EQ(ray[0].part, ray[1].part);
  EXPECT_NEAR(ray[0].part * 40, 10 - std::sqrt(1.5 * 1.5 - 1), 1e-12);
  EXPECT_NEAR(ray[2].position.x, 28, 1e-12);
  EXPECT_EQ(ray[2].normal, (Vec3d{-1, 0, 0}));
  const auto tube = *world.projectiles_along({0, 0, 0}, {40, 0, 0}, 1);
  ASSERT_EQ(tube.size(), 4u);
  EXPECT_EQ(tube[2].id, point);
  EXPECT_NEAR(tube[2].position.x, 20 - std::sqrt(0.75), 1e-12);
  EXPECT_LT(length(tube[2].normal - Vec3d{-std::sqrt(0.75), -0.5, 0}), 1e-12);
  EXPECT_EQ(tube[3].id, far);
  const auto inside = *world.projectiles_along({30, 1, 0}, {30, 1, 0});
  ASSERT_EQ(inside.size(), 1u);
  EXPECT_EQ(inside[0].part, 0);
  EXPECT_EQ(inside[0].normal, (Vec3d{0, 1, 0}));
  EXPECT_EQ(world.projectiles_along({0, 5, 0}, {40, 5, 0})->size(), 0u);
}

/// Each ball is touched exactly where the segment comes nearer to it than both radii: found by many small steps.
TEST(ProjectileQueries, cast_touches_what_comes_near) {
  Random r(563);
  const World world = crowd(r);
  int touched = 0;
  for (int i = 0; i < 1000; ++i) {
    const Vec3d from{r.in(-12, 12), r.in(-12, 12), r.in(-12, 12)}, to{r.in(-12, 12), r.in(-12, 12), r.in(-12, 12)};
    const double radius = r.in(0, 0.5);
    const auto hits = *world.projectiles_along(from, to, radius, 3);
    EXPECT_TRUE(std::ranges::is_sorted(hits, {}, &ProjectileHit::part));
    for (const ProjectileId id : world.ids()) {
      const Vec3d middle = world[id].position();
      const double reach = radius + radius_of(world, id);
      const double t = std::clamp(dot(middle - from, to - from) / dot(to - from, to - from), 0.0, 1.0);
      const bool near = length(from + (to - from) * t - middle) <= reach;
      const auto hit = std::ranges::find(hits, id, &ProjectileHit::id);
      const bool is_asked = is_launched(world, id) && (world[id].layers() & 3u) != 0;
      EXPECT_EQ(hit != hits.end(), near && is_asked) << i;
      if (hit == hits.end()) continue;
      ++touched;
      EXPECT_LE(hit->part, t + 1e-12);
      const double apart = length(hit->position - middle);
      if (hit->part > 0)
        EXPECT_NEAR(apart, reach, 1e-9);
      else
        EXPECT_LE(apart, reach);
    }
  }
  EXPECT_GT(touched, 500);
}

TEST(ProjectileQueries, what_makes_no_sense_is_refused_with_its_place) {
  World world = make_world(nothing_but_things());
  put(world, {}, ball_of(1));
  const double none = std::nan("");
  EXPECT_EQ(world.projectiles_in(Vec3d{none, 0, 0}, 1).error().place, "middle");
  EXPECT_EQ(world.projectiles_in(Vec3d{}, -1).error().place, "radius");
  EXPECT_EQ(world.projectiles_in(Vec3d{}, kInfinity).error().place, "radius");
  EXPECT_EQ(world.projectiles_in({.scale = 0}, Vec3d{1, 1, 1}).error().place, "at.scale");
  EXPECT_EQ(world.projectiles_in(Transform{}, {1, -1, 1}).error().place, "half");
  EXPECT_EQ(world.projectiles_along({}, {0, none, 0}).error().place, "to");
  EXPECT_EQ(world.projectiles_along({0, 1e16, 0}, {}).error().place, "from");
  EXPECT_EQ(world.projectiles_along({}, {}, none).error().place, "radius");
  EXPECT_EQ(world.projectiles_in(Vec3d{}, 0)->size(), 1u);
  EXPECT_EQ(world.projectiles_in(Vec3d{}, 0, 2)->size(), 0u);
}

/// A blast: who is in it is thrown outwards; what was asked changed nothing.
TEST(ProjectileQueries, change_nothing) {
  Random r(564);
  const World world = crowd(r);
  const std::uint64_t before = world.hash();
  ASSERT_TRUE(world.projectiles_in(Vec3d{}, 5));
  ASSERT_TRUE(world.projectiles_along({-9, 0, 0}, {9, 0, 0}, 1));
  EXPECT_EQ(world.hash(), before);
}

}  // namespace physim::world_projectile_queries_test
