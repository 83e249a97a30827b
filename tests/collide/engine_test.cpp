// Questions to a scene whose things are an engine's: against the scene that answers, and with answers that are none.
#include "collide/scene_support.hpp"
#include "engine_support.hpp"
#include "support.hpp"

namespace physim::collide_engine_test {

using test::answered_by;
using test::Random;

/// Solids that do not touch: on a grid, turned, smaller than its cells.
Scene solids() {
  Random r(7);
  Scene scene;
  const ShapeId shapes[] = {*scene.add_shape(BoxShape{{0.3, 0.2, 0.4}}), *scene.add_shape(SphereShape{0.4}),
                            *scene.add_shape(CylinderShape{0.3, 0.3}), *scene.add_shape(test::ball(6, 0))};
  for (int i = 0; i < 60; ++i) {
    const Vec3d cell{double(i % 5), double(i / 5 % 4), double(i / 20)};
    Transform at = test::random_transform(r, 1);
    at.position = cell * 2.0 - Vec3d{4, 3, 2};
    at.scale = i % 4 == 3 ? 0.4 : 1;
    EXPECT_TRUE(scene.add({.shape = shapes[i % 4], .transform = at, .layers = 1u << (i % 2)}));
  }
  return scene;
}

TEST(Engine, answers_as_the_scene_behind_it) {
  const Scene scene = solids(), asking = answered_by(scene, 0);
  Random r(8);
  int hits = 0;
  for (int i = 0; i < 9000; ++i) {
    SceneSegment s = test::random_segment(r, {}, 6);
    s.radius = i % 3 == 0 ? 0.05 : 0;
    s.time = 2;
    s.duration = 0.5;
    const SceneFilter filter{.layers = i % 5 == 0 ? 1u : 3u};
    const SceneHit right = test::first_from_outside(scene, s, filter), hit = asking.first_hit(s, filter);
    ASSERT_EQ(bool(hit), bool(right)) << i;
    ASSERT_EQ(asking.any_hit(s, filter), bool(right)) << i;
    if (!hit) continue;
    ++hits;
    EXPECT_EQ(hit.instance, (InstanceId{right.instance.index, kEngineGeneration}));
    EXPECT_LT(length(hit.normal - right.normal), 1e-9);
    const double outside = right.entering ? 1e-6 : -1e-6;  // from the back of a mesh it is met within
    EXPECT_NEAR(dot(hit.position - right.position, right.normal), outside, 1e-9) << "a skin before it";
    EXPECT_NEAR(hit.time, s.time + s.duration * hit.part, 1e-12);
    EXPECT_LT(length(hit.position - (s.from + (s.to - s.from) * hit.part)), 1.1e-6);
  }
  EXPECT_GT(hits, 800);
}

TEST(Engine, the_way_through_solids_is_found_from_both_ends) {
  const Scene scene = solids(), asking = answered_by(scene, 0);
  Random r(9);
  std::size_t crossings = 0;
  for (int i = 0; i < 7000; ++i) {
    const SceneSegment s = test::random_segment(r, {}, 9);
    if (!scene.overlaps(s.from, 1e-3).empty() || !scene.overlaps(s.to, 1e-3).empty()) continue;
    const auto right = scene.all_hits(s), hits = asking.all_hits(s);
    ASSERT_EQ(hits.size(), right.size()) << i;
    for (std::size_t k = 0; k < hits.size(); ++k) {
      EXPECT_EQ(hits[k].instance.index, right[k].instance.index) << i;
      EXPECT_EQ(hits[k].entering, right[k].entering) << i;
      EXPECT_NEAR(hits[k].part, right[k].part, 1e-9) << i;
      EXPECT_GT(dot(hits[k].normal, right[k].normal), 0.999) << i;
    }
    crossings += hits.size();
  }
  EXPECT_GT(crossings, 1000u);
}

TEST(Engine, what_is_met_from_both_sides_at_one_place_is_a_sheet) {
  Scene asking;
  const auto wall = [](const EngineBatch& batch) {  // the plane x = 2, whose normal is towards who comes
    for (std::size_t i = 0; i < batch.segments.size(); ++i) {
      const double from = batch.segments[i].from.x - 2, to = batch.segments[i].to.x - 2;
      if (from * to > 0 || from == to) continue;
      batch.hits[i].part = from / (from - to);
      batch.hits[i].normal = {from > 0 ? 1.0 : -1.0, 0, 0};
      batch.hits[i].instance.index = 1;
    }
  };
  ASSERT_TRUE(asking.set_engine({wall, 1e-6}));
  const auto hits = asking.all_hits({{0, 0, 0}, {5, 0, 0}});
  ASSERT_EQ(hits.size(), 1u);
  EXPECT_TRUE(hits[0].entering);
  EXPECT_NEAR(hits[0].part, 0.4, 1e-9);
}

/// A flat floor, as an engine knows it that rounds to so much.
EngineQuery floor_off_by(double error) {
  return [error](const EngineBatch& batch) {
    for (std::size_t i = 0; i < batch.segments.size(); ++i) {
      const SceneSegment& s = batch.segments[i];
      const double noise = error * std::sin(1e6 * s.from.x + 1e7 * s.to.y);
      const double from = s.from.y - s.radius + noise, to = s.to.y - s.radius + noise;
      if (!(from >= 0 && to < 0)) continue;  // what is below is not met any more
      batch.hits[i].part = from / (from - to);
      batch.hits[i].normal = {0, 1, 0};
      batch.hits[i].instance.index = 1;
    }
  };
}

TEST(Engine, surfaces_are_met_a_skin_before_they_are_there) {
  constexpr double kSkin = 1e-3, kOff = 1e-5;
  Scene scene;
  ASSERT_TRUE(scene.set_engine({floor_off_by(kOff), kSkin}));
  Random r(10);
  for (int i = 0; i < 2000; ++i) {
    const double radius = i % 2 == 0 ? 0 : 0.1, height = radius + kSkin + r.in(0, 0.5);
    const Vec3d way{r.in(-1, 1), -std::pow(10, r.in(-5, 0)), 0};
    const SceneSegment s{{0, height, 0}, Vec3d{0, height, 0} + way, radius};
    const SceneHit hit = scene.first_hit(s);
    const double steep = -way.y / length(way);
    const bool is_met = height + way.y < radius + kSkin - 2 * kOff;
    if (is_met && steep > 0.05) {
      EXPECT_TRUE(hit) << i;
    }
    if (height + way.y > radius + kSkin + 2 * kOff) {
      EXPECT_FALSE(hit) << i;
    }
    if (hit && steep > 0.05) {
      EXPECT_NEAR(hit.position.y, radius + kSkin, 2 * kOff) << i;
    }
    if (hit) {
      EXPECT_GT(hit.position.y, radius + 2 * kOff) << i;
    }
  }
  // Within the skin: met at once by who comes, and put back; not at all by who goes or stays.
  const SceneHit within = scene.first_hit({{0, kSkin / 2, 0}, {0, -1, 0}});
  EXPECT_NEAR(within.part, 1e-6, 1e-9);
  EXPECT_NEAR(within.position.y, kSkin, 2 * kOff);
  EXPECT_FALSE(scene.first_hit({{0, kSkin / 2, 0}, {0, 1, 0}}));
  EXPECT_FALSE(scene.first_hit({{0, kSkin / 2, 0}, {0, kSkin / 2, 0}}));
}

TEST(Engine, own_things_and_the_engines_are_met_in_order) {
  Scene scene;
  ASSERT_TRUE(scene.set_engine({floor_off_by(0), 1e-6}));
  const InstanceId table = add_thing(scene, BoxShape{{1, 0.5, 1}}, {.transform = {.position = {0, 0.5, 0}}});
  const SceneSegment through{{0, 5, 0}, {0, -5, 0}}, beside{{3, 5, 0}, {3, -5, 0}};
  EXPECT_EQ(scene.first_hit(through).instance, table);
  EXPECT_EQ(scene.first_hit(beside).instance.generation, kEngineGeneration);
  const auto hits = scene.all_hits(through);
  ASSERT_EQ(hits.size(), 3u);
  EXPECT_EQ(hits[0].instance, table);
  SceneHit both[2];
  scene.first_hits(std::vector{through, beside}, both);
  EXPECT_EQ(both[0].instance, table);
  EXPECT_EQ(both[1].instance.index, 1u);
  EXPECT_EQ(scene.clearance({0, 9, 0}, 5), 0) << "nobody knows";
  EXPECT_FALSE(scene.instance(both[1].instance));
  EXPECT_FALSE(scene.is_sensor(both[1].instance));
  EXPECT_FALSE(scene.first_hit({{3, 5, 0}, {3, -5, 0}}, {.layers = 0}));
  ASSERT_TRUE(scene.set_engine({}));
  EXPECT_EQ(scene.engine(), nullptr);
  EXPECT_FALSE(scene.first_hit(beside));
}

TEST(Engine, answers_that_make_no_sense_are_refused_and_counted) {
  constexpr double kNone = std::numeric_limits<double>::quiet_NaN();
  const SceneHit good{.part = 0.5, .normal = {-1, 0, 0}, .instance = {1, 0}};
  std::vector<SceneHit> bad(9, good);
  bad[0].part = kNone;
  bad[1].part = -0.1;
  bad[2].part = 1.1;
  bad[3].normal = {};
  bad[4].normal = {kNone, 0, 0};
  bad[5].normal = {1e200, 0, 0};
  bad[6].velocity = {0, kNone, 0};
  bad[7].velocity = {1e300, 0, 0};
  bad[8].part = kInfinity;
  for (const SceneHit& answer : bad) {
    Scene scene;
    ASSERT_TRUE(scene.set_engine({[&](const EngineBatch& b) { b.hits[0] = answer; }}));
    EXPECT_FALSE(scene.first_hit({{0, 0, 0}, {1, 0, 0}}));
    EXPECT_EQ(scene.engine_counters().refused, 1u);
    EXPECT_TRUE(scene.all_hits({{0, 0, 0}, {1, 0, 0}}).empty());
  }
  Scene scene;
  ASSERT_TRUE(scene.set_engine({[&](const EngineBatch& b) { b.hits[0] = good; }}));
  EXPECT_TRUE(scene.first_hit({{0, 0, 0}, {1, 0, 0}}));
  EXPECT_FALSE(scene.first_hit({{1, 0, 0}, {0, 0, 0}})) << "it moves away from what it is said to meet";
  EXPECT_FALSE(scene.first_hit({{kNone, 0, 0}, {1, 0, 0}}));
  EXPECT_FALSE(scene.first_hit({{0, 0, 0}, {1, 0, 0}, -1}));
  EXPECT_EQ(scene.engine_counters().calls, 2u) << "questions that make no sense are not asked";
  EXPECT_LE(scene.all_hits({{0, 0, 0}, {1, 0, 0}}).size(), 64u) << "an engine that always meets something";
  for (const double skin : {-1e-3, 0.0, 9e-7, 0.11, kNone})
    EXPECT_EQ(scene.set_engine({{}, skin}).error().place, "engine.skin");
}

TEST(Engine, a_segment_that_begins_in_a_solid_is_met_where_it_begins) {
  Scene scene;
  const SceneHit answer{.part = 0.4, .normal = {-1, 0, 0}, .instance = {1, 0}, .starts_inside = true};
  ASSERT_TRUE(scene.set_engine({[&](const EngineBatch& b) { b.hits[0] = answer; }}));
  const SceneHit hit = scene.first_hit({{1, 2, 3}, {4, 2, 3}, 0.1, 5, 2});
  ASSERT_TRUE(hit && hit.starts_inside);
  EXPECT_EQ(hit.part, 0) << "whatever the engine says";
  EXPECT_EQ(hit.position, (Vec3d{1, 2, 3}));
  EXPECT_EQ(hit.time, 5);
}

TEST(Engine, who_throws_is_asked_alone_and_who_asks_back_gets_its_own_things) {
  Scene scene;
  const Scene* itself = &scene;
  const auto query = [&itself](const EngineBatch& batch) {
    EXPECT_FALSE(itself->first_hit(batch.segments[0])) << "not handed to it again";
    for (std::size_t i = 0; i < batch.segments.size(); ++i) {
      if (batch.segments[i].from.z == 3) throw std::runtime_error("no");
      batch.hits[i].part = 0.5;
      batch.hits[i].normal = {-1, 0, 0};
      batch.hits[i].instance.index = 1;
    }
  };
  ASSERT_TRUE(scene.set_engine({query}));
  std::vector<SceneSegment> segments;
  for (int i = 0; i < 6; ++i) segments.push_back({{0, 0, double(i)}, {1, 0, double(i)}});
  std::vector<SceneHit> hits(6);
  scene.first_hits(segments, hits);
  for (std::size_t i = 0; i < 6; ++i) EXPECT_EQ(bool(hits[i]), i != 3) << i;
  const EngineCounters counted = scene.engine_counters();
  EXPECT_EQ(counted.calls, 7u);
  EXPECT_EQ(counted.segments, 12u);
  EXPECT_EQ(counted.refused, 1u);
}

TEST(Engine, saves_hold_the_skin_and_want_the_function_again) {
  Scene scene = solids();
  const std::vector<std::byte> without = scene.save();
  const std::uint64_t hash = scene.hash();
  ASSERT_TRUE(scene.set_engine({floor_off_by(0), 2e-3}));
  EXPECT_NE(scene.hash(), hash);
  const std::vector<std::byte> save = scene.save();
  const auto refused = Scene::load(save);
  ASSERT_FALSE(refused);
  EXPECT_EQ(refused.error().place, "query");
  const auto loaded = must(Scene::load(save, floor_off_by(0)));
  EXPECT_EQ(loaded.skin(), 2e-3);
  EXPECT_EQ(loaded.hash(), scene.hash());
  EXPECT_EQ(loaded.save(), save);
  EXPECT_TRUE(loaded.first_hit({{90, 1, 0}, {90, -1, 0}}));
  ASSERT_TRUE(scene.set_engine({}));
  EXPECT_EQ(scene.hash(), hash);
  EXPECT_EQ(scene.save().size(), without.size());
  EXPECT_FALSE(Scene::load(without, floor_off_by(0))->engine()) << "a function that is not wanted";
  for (std::size_t cut = 0; cut < save.size(); cut += 1 + save.size() / 50)
    EXPECT_FALSE(Scene::load(std::span(save).first(cut), floor_off_by(0)));
}

}  // namespace physim::collide_engine_test
