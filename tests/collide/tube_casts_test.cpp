// Casts among what a tube may touch, and how far many ways are clear: each is as the scene says of it alone.
#include "collide/tube_casts.hpp"
#include "support.hpp"

#include "collide/crowd_support.hpp"
#include "collide/scene_by_motion.hpp"

namespace physim::collide_tube_casts_test {

using namespace test_crowd;
using collide::TubeCasts;

std::vector<Scene> scenes(Random& r) {
  std::vector<Scene> list;
  list.push_back(crowd(r)), list.push_back(land(r, 0)), list.push_back(land(r, 200)), list.push_back(wide_hills(r));
  return list;
}

SceneSegment somewhere_along(Random& r) {
  const Vec3d from{r.in(-5, kSide), r.in(-4, 9), r.in(-5, kSide)};
  SceneSegment s{from, from + r.vector(r.one_in(20) ? 150 : 9)};
  if (r.one_in(9)) s.to.y = s.from.y;
  if (r.one_in(25)) s.to = s.from;
  s.radius = r.one_in(3) ? r.in(0.5, 3) : r.in(1e-3, 0.4);
  s.time = r.in(0, 2);
  s.duration = r.one_in(3) ? 0 : r.in(0, 1);
  return s;
}

/// Inside of a tube, of a part of its time; or with some that reach beyond.
SceneSegment within(Random& r, const SceneSegment& tube, bool beyond = false) {
  SceneSegment s{.radius = r.one_in(2) ? 0 : r.in(0, 1) * tube.radius};
  const double room = beyond && r.one_in(9) ? 3 * tube.radius : tube.radius - s.radius;
  const auto place = [&] {
    const Vec3d off = r.vector(1);
    return tube.from + (tube.to - tube.from) * r.in(0, 1) + off * (r.in(0, 1) * room / std::max(length(off), 1e-9));
  };
  s.from = place(), s.to = r.one_in(15) ? s.from : place();
  s.time = beyond && r.one_in(3) ? r.in(-9, 9) : tube.time + tube.duration * r.in(0, 0.5);
  s.duration = r.one_in(3) ? 0 : 0.5 * tube.duration;
  return s;
}

TEST(TubeCasts, are_as_the_scene_answers) {
  Random r(41);
  for (const Scene& scene : scenes(r)) {
    int hits = 0, none = 0;
    for (int i = 0; i < 2000; ++i) {
      const SceneFilter filter{.layers = r.one_in(2) ? 0xffffffff : 3, .sensors = r.one_in(2)};
      const SceneSegment tube = somewhere_along(r);
      TubeCasts casts(&scene, filter);
      if (r.one_in(3)) static_cast<void>(casts.find(somewhere_along(r)));  // is forgotten
      const bool some = casts.find(tube);
      none += some ? 0 : 1;
      for (int k = 0; k < 8; ++k) {
        const SceneSegment s = k == 0 ? tube : within(r, tube, true);
        const SceneHit hit = scene.first_hit(s, filter);
        hits += hit ? 1 : 0;
        expect_same(casts.first_hit(s), hit, static_cast<std::size_t>(i));
        if (testing::Test::HasFatalFailure()) return;
      }
      if (!some) {
        const bool is_met = scene.any_hit(tube, filter);
        EXPECT_FALSE(is_met) << i;
      }
    }
    EXPECT_GT(hits, 2000);
    EXPECT_GT(none, 100);
  }
}

/// Rows that fly in float leave surfaces by less than a millimetre, in double by less than a nanometre.
TEST(TubeCasts, from_a_surface_on_they_are_as_the_scene_answers) {
  Random r(42);
  int left = 0, met = 0;
  for (const Scene& scene : scenes(r))
    for (int i = 0; i < 1500; ++i) {
      const SceneFilter filter{.sensors = false};
      SceneSegment s = somewhere_along(r);
      s.radius = r.one_in(2) ? 0 : 0.05, s.duration = 0;
      const SceneHit hit = scene.first_hit(s, filter);
      if (!hit || hit.starts_inside) continue;
      const Vec3d n = hit.entering ? hit.normal : -hit.normal, way = r.vector(10);
      const Vec3d from = hit.position + n * (r.one_in(3) ? 1e-10 : r.one_in(2) ? 0 : 4e-4);
      const SceneSegment path{from, from + (dot(way, n) < 0 ? -way : way), s.radius + 0.02, s.time};
      TubeCasts casts(&scene, filter);
      const bool some = casts.find(path);
      EXPECT_TRUE(some);
      for (const double part : {1e-5, 1e-3, 0.1, 1.0})
        for (const double radius : {s.radius, s.radius + 1e-3}) {
          const SceneSegment chord{from, from + (path.to - from) * part, radius, s.time};
          const SceneHit next = scene.first_hit(chord, filter);
          (next ? met : left) += 1;
          expect_same(casts.first_hit(chord), next, static_cast<std::size_t>(i));
          if (testing::Test::HasFatalFailure()) return;
        }
    }
  EXPECT_GT(left, 2000);
  EXPECT_GT(met, 2000);
}

/// A heap of more than a tube keeps, and triangles so narrow that they have no sound normal.
TEST(TubeCasts, heaps_and_slivers_are_asked_whole) {
  Random r(43);
  MeshShape slivers;
  for (std::uint32_t i = 0; i < 600; i += 3) {
    const Vec3d a = r.vector(4), along = r.vector(3);
    slivers.vertices.insert(slivers.vertices.end(), {a, a + along, a + along * 0.5 + r.vector(1e-6)});
    slivers.triangles.push_back({i, i + 1, i + 2});
  }
  Scene scene;
  add_thing(scene, slivers);
  const ShapeId bumpy = *scene.add_shape(ball(12, 0.3));
  for (int i = 0; i < 12; ++i)
    ASSERT_TRUE(scene.add({.shape = bumpy, .transform = {.position = Vec3d{9, 0, 0} + r.vector(1)}}));
  int hits = 0;
  for (int i = 0; i < 4000; ++i) {
    const Vec3d about{r.one_in(2) ? 9.0 : 0.0, 0, 0};
    const SceneSegment tube{about + r.vector(4), about + r.vector(4), r.in(1e-3, 1)};
    TubeCasts casts(&scene, {});
    const bool some = casts.find(tube);
    for (int k = 0; k < 4; ++k) {
      const SceneSegment s = within(r, tube);
      const SceneHit hit = scene.first_hit(s);
      EXPECT_TRUE(some || !hit);
      hits += hit ? 1 : 0;
      expect_same(casts.first_hit(s), hit, static_cast<std::size_t>(i));
      if (testing::Test::HasFatalFailure()) return;
    }
  }
  EXPECT_GT(hits, 2000);
}

/// Things that came lately and those that have stood for long are looked at in another order, which the last bits of a
/// part may show.
TEST(ClearParts, of_many_ways_are_those_of_each) {
  Random r(44);
  for (const Scene& scene : scenes(r)) {
    const SceneByMotion parts(scene);
    for (const std::size_t count : {0, 1, 3, 8, 9, 500}) {
      std::vector<collide::ClearQuery> queries;
      for (std::size_t i = 0; i < count; ++i) {
        queries.push_back({somewhere_along(r), r.one_in(3) ? 3u : 7u, 0.3});
        if (r.one_in(30)) queries.back().segment.radius = -1;
      }
      parts.clear_parts(queries);
      int some = 0, whole = 0;
      for (const collide::ClearQuery& query : queries) {
        const double alone = parts.clear_part(query.segment, {.layers = query.layers});
        EXPECT_NEAR(query.part, alone, 1e-12);
        some += alone > 0 && alone < 1 ? 1 : 0;
        whole += alone == 1 ? 1 : 0;
      }
      if (count == 500) {
        EXPECT_GT(some, 20);
        EXPECT_GT(whole, 20);
      }
    }
  }
}

}  // namespace physim::collide_tube_casts_test
