// Things in motion: what is met when, beside a reference that walks along the curve in long double and knows no chords.
#include "collide/reference.hpp"
#include "collide/scene_support.hpp"
#include "math/quat.hpp"
#include "support.hpp"

namespace physim::collide_motion_test {

using namespace test;

constexpr double kGrazed = 1e-6;  // what is grazed by less may be missed [m]

/// Where a steady motion has brought a point of W that is seen from the thing, by Rodrigues' formula.
Point seen_from(const Transform& at, const SteadyMotion& m, Real time, const Point& p) {
  const Real t = time - m.start, rate = norm(point(m.angular_velocity));
  const Point d = p - (point(at.position) + point(m.velocity) * t);
  Point back = d;
  if (rate > 0) {
    const Point axis = point(m.angular_velocity) * (1 / rate);
    const Real c = std::cos(rate * t), s = std::sin(-rate * t);
    back = d * c + outer(axis, d) * s + axis * (inner(axis, d) * (1 - c));
  }
  return into_frame(at, point(at.position) + back);
}

/// The first zero of a gap that is no convex function: by many samples, and the least gap near each of them.
Met first_of_many(const std::function<Real(Real)>& gap, int samples) {
  Met met;
  met.least = gap(0);
  if (met.least <= 0) return {true, 0, met.least, -1};
  for (int i = 0; i < samples; ++i) {
    const Real from = Real(i) / samples, to = Real(i + 1) / samples;
    const Met here = first_zero([&](Real t) { return gap(from + (to - from) * t); }, 1);
    if (here.least < met.least) met.least = here.least;
    if (here.hit) return {true, from + (to - from) * here.part, here.least, 0};
  }
  return met;
}

SteadyMotion random_motion(Random& r, bool turns) {
  SteadyMotion m{.start = r.in(-1, 1), .velocity = r.vector(30), .angular_velocity = {}};
  if (turns) m.angular_velocity = r.vector(r.one_in(3) ? 100 : 8);
  return m;
}

template <class Shape>
void expect_met(const Shape& shape, bool turns, int casts, const std::string& what) {
  Random r(turns ? 31 : 30);
  const SignedDistance distance = distance_of(shape);
  int hits = 0, misses = 0;
  for (int i = 0; i < casts && !testing::Test::HasFailure(); ++i) {
    Scene scene;
    const double far = r.one_in(4) ? 1e5 : 3;
    const Transform at = random_transform(r, far);
    const SteadyMotion motion = random_motion(r, turns);
    const auto thing = must(scene.add({.shape = scene.add_shape(shape).value(), .transform = at, .motion = motion}));
    SceneSegment s = random_segment(r, at.position, at.scale);
    s.time = motion.start + r.in(-0.01, 0.01);
    s.duration = r.one_in(5) ? 0 : r.in(0.001, 0.05);
    s.radius = r.one_in(2) ? 0 : r.in(0.01, 0.5);
    if (r.one_in(2)) {
      EXPECT_TRUE(scene.cover(s.time - 0.01, s.time + 0.1));
    }
    const Point from = point(s.from), along = point(s.to) - from;
    const auto gap = [&](Real t) {
      return distance(seen_from(at, motion, Real(s.time) + t * Real(s.duration), from + along * t)) * Real(at.scale) -
             Real(s.radius);
    };
    const Met met = first_of_many(gap, turns ? 200 : 1);
    const SceneHit hit = scene.first_hit(s);
    (met.hit ? hits : misses) += 1;
    const double bound = 1e-12 * (1 + 4 * far + s.radius + 30 * at.scale);
    if (static_cast<bool>(hit) != met.hit) {
      EXPECT_LT(std::fabs(met.least), turns ? kGrazed : bound) << what << " " << i;
      continue;
    }
    if (!hit) continue;
    EXPECT_EQ(hit.time, s.time + hit.part * s.duration);
    EXPECT_NEAR(length(hit.normal), 1, 1e-12);
    if (met.part == 0) continue;
    // The gap there: closed to within what the reference rounds to, and to the square of a chord's error where it
    // turns.
    EXPECT_LT(std::fabs(gap(hit.part)), turns ? 5e-9 + bound : 2 * bound) << what << " " << i;
    if (std::fabs(met.least) > 10 * kGrazed) {
      EXPECT_NEAR(hit.part, static_cast<double>(met.part), turns ? 1e-6 : 1e-9) << what << " " << i;
    }
    EXPECT_TRUE(near(velocity_at(*scene.state(thing, hit.time), hit.position - hit.normal * s.radius), hit.velocity,
                     1e-12, 1e-12));
  }
  EXPECT_GT(hits, casts / 20);
  EXPECT_GT(misses, casts / 20);
}

TEST(SceneMotion, what_moves_straight_is_met_exactly) {
  expect_met(SphereShape{0.8}, false, 1500, "sphere");
  expect_met(BoxShape{{0.2, 0.5, 1.1}}, false, 1500, "box");
  expect_met(CylinderShape{0.6, 0.4}, false, 1500, "cylinder");
}

TEST(SceneMotion, what_turns_is_met_within_its_tolerance) {
  expect_met(BoxShape{{0.2, 0.5, 1.1}}, true, 70, "box");
  expect_met(CapsuleShape{0.2, 0.9}, true, 70, "capsule");
  expect_met(BoxShape{{1, 0.001, 1}}, true, 70, "sheet");
}

/// A ball on a cubic between two keys, by de Casteljau's scheme.
TEST(SceneMotion, what_moves_along_a_curve_is_met_within_its_tolerance) {
  Random r(33);
  int hits = 0;
  for (int i = 0; i < 300 && !HasFailure(); ++i) {
    Scene scene;
    const MotionKey a{r.in(-1, 0), r.vector(2), {}, r.vector(9)}, b{r.in(0.1, 1), r.vector(2), {}, r.vector(9)};
    const ShapeId ball = scene.add_shape(SphereShape{0.7}).value();
    ASSERT_TRUE(scene.add({.shape = ball, .motion = KeyedMotion{{a, b}, MotionCurve::smooth}}));
    SceneSegment s = random_segment(r, {}, 1);
    s.time = a.time - 0.1;
    s.duration = b.time - a.time + 0.2;
    s.radius = r.one_in(2) ? 0 : 0.2;
    const Real h = b.time - a.time;
    const Point ends[] = {point(a.position), point(a.position) + point(a.velocity) * (h / 3),
                          point(b.position) - point(b.velocity) * (h / 3), point(b.position)};
    const auto mix = [](const Point& p, const Point& q, Real u) { return p + (q - p) * u; };
    const auto gap = [&](Real part) {
      const Real u = std::clamp((s.time + part * Real(s.duration) - a.time) / h, Real(0), Real(1));
      const Point p = mix(ends[0], ends[1], u), q = mix(ends[1], ends[2], u), o = mix(ends[2], ends[3], u);
      const Point at = mix(mix(p, q, u), mix(q, o, u), u);
      return norm(point(s.from) + (point(s.to) - point(s.from)) * part - at) - 0.7L - s.radius;
    };
    const Met met = first_of_many(gap, 150);
    const SceneHit hit = scene.first_hit(s);
    if (static_cast<bool>(hit) != met.hit) {
      EXPECT_LT(std::fabs(met.least), kGrazed) << i;
      continue;
    }
    if (!hit || met.part == 0) continue;
    ++hits;
    EXPECT_LT(std::fabs(gap(hit.part)), 1e-9) << i;
    if (std::fabs(met.least) > 10 * kGrazed) {
      EXPECT_NEAR(hit.part, static_cast<double>(met.part), 1e-7) << i;
    }
  }
  EXPECT_GT(hits, 25);
}

/// Meshes, fields and compounds that move are met where those at rest are, as seen from them.
TEST(SceneMotion, every_shape_is_met_as_seen_from_it) {
  Random r(34);
  for (int i = 0; i < 300; ++i) {
    Scene moving, resting;
    HeightFieldShape field{.columns = 3, .rows = 3, .heights = {0, 0.2, 0, 0.1, 0.5, 0, 0, 0.3, 0}};
    const Vec3d velocity = r.vector(200);
    const Transform at{.position = r.vector(1)};
    for (Scene* scene : {&moving, &resting}) {
      const ShapeId box = scene->add_shape(BoxShape{}).value();
      const ShapeDef defs[] = {ball(6, 0.1), field, CompoundShape{{{box, {.position = {1, 0, 0}}}}}, PlaneShape{}};
      const ShapeId shape = scene->add_shape(defs[i % 4]).value();
      const SceneMotion motion = scene == &moving ? SceneMotion(SteadyMotion{.velocity = velocity}) : SceneMotion();
      ASSERT_TRUE(scene->add({.shape = shape, .transform = at, .motion = motion}));
    }
    SceneSegment s = random_segment(r, at.position, 1);
    s.radius = r.one_in(2) ? 0 : 0.05;
    const SceneHit rest = resting.first_hit(s);
    const std::size_t crossings = resting.all_hits(s).size();
    s.duration = 0.01;
    s.to += velocity * s.duration;
    const SceneHit hit = moving.first_hit(s);
    ASSERT_EQ(static_cast<bool>(hit), static_cast<bool>(rest)) << i;
    ASSERT_EQ(moving.any_hit(s), static_cast<bool>(rest)) << i;
    ASSERT_EQ(moving.all_hits(s).size(), crossings) << i;
    if (!hit) continue;
    EXPECT_NEAR(hit.part, rest.part, 1e-11) << i;
    EXPECT_EQ(hit.primitive, rest.primitive) << i;
    EXPECT_EQ(hit.velocity, velocity) << i;
    EXPECT_TRUE(near(hit.normal, rest.normal, 1e-9)) << i;
  }
}

/// A blade of a fan comes round to where a bullet waits: time, normal and velocity follow from the angle.
TEST(SceneMotion, a_blade_strikes_what_stands_still) {
  Scene scene;
  constexpr double kRate = 40;  // [rad/s]
  const ShapeId blade = scene.add_shape(BoxShape{{1, 0.01, 0.1}}).value();
  const auto fan = scene.add({.shape = blade, .motion = SteadyMotion{.angular_velocity = {0, 0, kRate}}});
  ASSERT_TRUE(fan);
  const Vec3d waits{0, 0.5, 0};
  const SceneHit hit = scene.first_hit({waits, waits, 0, 0, 0.1});
  ASSERT_TRUE(hit);
  // The upper face, y = 0.01 in the blade, reaches the point when its own height above the axis has turned to it.
  const double angle = std::acos(-1.0) / 2 - std::asin(0.01 / 0.5);
  EXPECT_NEAR(hit.time, angle / kRate, 1e-11);
  EXPECT_TRUE(near(hit.normal, {-std::sin(angle), std::cos(angle), 0}, 1e-9));
  EXPECT_TRUE(near(hit.velocity, {-kRate * 0.5, 0, 0}, 1e-9));
  EXPECT_FALSE(hit.starts_inside);
  const auto hits = scene.all_hits({waits, waits, 0, 0, 0.15});
  ASSERT_EQ(hits.size(), 4u) << "the blade comes and goes, then its other half";
  const double through = 2 * std::asin(0.01 / 0.5) / kRate;
  EXPECT_NEAR(hits[1].time - hits[0].time, through, 1e-8);
  EXPECT_FALSE(hits[1].entering);
  EXPECT_NEAR(hits[2].time - hits[0].time, std::acos(-1.0) / kRate, 1e-8);
}

TEST(SceneMotion, keys_are_passed_at_their_times) {
  Scene scene;
  const ShapeId box = scene.add_shape(BoxShape{}).value();
  const Quatd quarter = quat_from_axis_angle<double>({0, 1, 0}, 1.5);
  KeyedMotion motion{{{1, {0, 0, 0}, {}, {1, 0, 0}}, {3, {4, 2, 0}, quarter, {0, 3, 0}}, {4, {4, 2, 6}, {}, {}}}};
  for (const MotionCurve curve : {MotionCurve::straight, MotionCurve::smooth}) {
    motion.curve = curve;
    const auto thing = must(scene.add({.shape = box, .motion = motion}));
    for (const MotionKey& key : motion.keys) {
      const MotionState state = *scene.state(thing, key.time);
      EXPECT_TRUE(near(state.position, key.position, 1e-15, 1e-15));
      EXPECT_NEAR(std::abs(state.rotation.w), std::abs(key.rotation.w), 1e-15);
    }
    const MotionState middle = *scene.state(thing, 2);
    // Hermite's cubic at its middle: the mean of the ends and an eighth of the difference of the slopes times 2 s.
    const Vec3d hermite{2 + 0.25, 1 - 0.75, 0};
    EXPECT_TRUE(near(middle.position, curve == MotionCurve::smooth ? hermite : Vec3d{2, 1, 0}, 1e-15));
    EXPECT_TRUE(near(middle.rotation.y, std::sin(0.375), 1e-14)) << "half of the turn";
    EXPECT_TRUE(near(middle.angular_velocity, {0, 0.75, 0}, 1e-14));
    const double step = 1e-6;
    for (const double t : {0.5, 1.7, 2.9, 3.5, 7.0}) {
      const MotionState a = *scene.state(thing, t - step), b = *scene.state(thing, t + step);
      EXPECT_TRUE(near((b.position - a.position) * (0.5 / step), scene.state(thing, t)->velocity, 1e-8, 1e-8)) << t;
    }
    EXPECT_EQ(scene.state(thing, -100)->position, motion.keys.front().position) << "it stands before the first";
    EXPECT_EQ(scene.state(thing, 100)->velocity, Vec3d{}) << "and after the last one";
    EXPECT_TRUE(scene.remove(thing));
    EXPECT_FALSE(scene.state(thing));
  }
}

/// Boxes hold the way of what moves: with them, without them, and on any threads the answers are the same bits.
TEST(SceneMotion, answers_do_not_depend_on_what_is_covered) {
  Random r(37);
  Scene covered, other;
  for (int i = 0; i < 60; ++i) {
    const bool keyed = i % 3 == 0;
    SceneMotion motion = random_motion(r, i % 2 == 0);
    if (keyed) {
      KeyedMotion keys{{}, i % 2 == 0 ? MotionCurve::smooth : MotionCurve::straight};
      double time = r.in(-2, 0);
      for (int k = 0; k < 6; ++k)
        keys.keys.push_back(
            {time += r.in(0.1, 0.6), r.vector(10), {r.in(-1, 1), r.in(-1, 1), r.in(-1, 1), 1}, r.vector(20)});
      motion = keys;
    }
    for (Scene* scene : {&covered, &other}) {
      const ShapeId shape = i % 4 == 0 ? scene->add_shape(ball(4, 0.1)).value() : scene->add_shape(BoxShape{}).value();
      Random same(static_cast<std::uint64_t>(i));
      ASSERT_TRUE(scene->add({.shape = shape, .transform = random_transform(same, 10), .motion = motion}));
    }
  }
  std::vector<SceneSegment> segments;
  int hits = 0;
  for (int i = 0; i < 1500; ++i) {
    const double from = r.in(-3, 3), to = from + r.in(0, 0.3);
    ASSERT_TRUE(covered.cover(from, to));
    SceneSegment s = random_segment(r, {}, 10);
    s.radius = r.one_in(2) ? 0 : 0.1;
    s.time = r.in(from, to);
    s.duration = r.in(0, to - s.time);
    segments.push_back(s);
    const SceneHit a = covered.first_hit(s), b = other.first_hit(s);
    hits += a ? 1 : 0;
    ASSERT_EQ(a.instance, b.instance) << i;
    ASSERT_EQ(a.part, b.part) << i;
    ASSERT_EQ(covered.all_hits(s).size(), other.all_hits(s).size()) << i;
    ASSERT_EQ(covered.nearest(s.from, kInfinity, {}, s.time).distance,
              other.nearest(s.from, kInfinity, {}, s.time).distance);
    ASSERT_EQ(covered.overlaps(s.from, 1, {}, s.time), other.overlaps(s.from, 1, {}, s.time));
  }
  EXPECT_GT(hits, 200);
  std::vector<SceneHit> one(segments.size()), many(segments.size());
  const auto pool = make_thread_pool(3);
  covered.first_hits(segments, one);
  covered.first_hits(segments, many, {}, pool.get());
  for (std::size_t i = 0; i < segments.size(); ++i) {
    EXPECT_EQ(one[i].part, many[i].part);
    EXPECT_EQ(one[i].velocity, many[i].velocity);
  }
}

/// A thin wall that comes at 50 m/s, and whatever flies at it: nothing slips through, and near misses are none.
TEST(SceneMotion, a_wall_that_moves_lets_nothing_through) {
  Random r(39);
  Scene scene;
  MeshShape sheet{.vertices = {{0, -1, -1}, {0, 1, -1}, {0, 1, 1}, {0, -1, 1}}, .triangles = {{0, 1, 2}, {0, 2, 3}}};
  const ShapeId shapes[] = {scene.add_shape(sheet).value(), scene.add_shape(BoxShape{{0.0005, 1, 1}}).value()};
  for (const ShapeId shape : shapes)
    for (const double spin : {0.0, 3.0}) {
      const SteadyMotion motion{.velocity = {-50, 0, 0}, .angular_velocity = {spin, 0, 0}};
      const auto wall = must(scene.add({.shape = shape, .motion = motion}));
      for (int i = 0; i < 3000; ++i) {
        const double speed = r.one_in(2) ? 5 : 900, dt = 1.0 / 60;
        const Vec3d velocity = normalized(Vec3d{r.one_in(2) ? 1.0 : -1.0, r.in(-0.3, 0.3), 0}) * speed;
        if (std::abs(velocity.x + 50) < 1) continue;
        // At a time within the frame it is in the plane of the wall, inside of its edge or outside of it.
        const double when = r.in(0, dt);
        const bool meets = r.one_in(2);
        const double across = meets ? 0.9 : 1.5;
        const Vec3d place{-50 * when, r.in(-0.6, 0.6) * across, meets ? r.in(-0.6, 0.6) : 1.5};
        const Vec3d from = place - velocity * when;
        const SceneHit hit = scene.first_hit({from, from + velocity * dt, r.one_in(2) ? 0 : 1e-3, 0, dt});
        ASSERT_EQ(static_cast<bool>(hit), meets) << i;
        if (!hit) continue;
        EXPECT_NEAR(hit.time, when, 2e-3 / std::abs(velocity.x + 50) * 2);
        EXPECT_NEAR(hit.velocity.x, -50, 1e-9);
      }
      ASSERT_TRUE(scene.remove(wall));
    }
}

TEST(SceneMotion, things_come_to_rest_and_move_on) {
  Scene scene;
  const ShapeId box = scene.add_shape(BoxShape{}).value();
  const auto thing = must(scene.add({.shape = box, .transform = {.position = {5, 0, 0}}}));
  const SceneSegment down{{7, 9, 0}, {7, -9, 0}, 0, 2, 0};
  EXPECT_FALSE(scene.first_hit(down));
  std::uint64_t before = scene.changes();
  ASSERT_TRUE(scene.set_motion(thing, SteadyMotion{.velocity = {1, 0, 0}}));
  EXPECT_GT(scene.changes(), before);
  EXPECT_TRUE(scene.first_hit(down)) << "after 2 s it is there";
  EXPECT_EQ(scene.first_hit(down).velocity, (Vec3d{1, 0, 0}));
  before = scene.changes();
  ASSERT_TRUE(scene.cover(0, 5));
  EXPECT_EQ(scene.changes(), before) << "what is met where is what it was";
  ASSERT_TRUE(scene.set_motion(thing, AtRest{}));
  EXPECT_FALSE(scene.first_hit(down));
  ASSERT_TRUE(scene.set_motion(thing, SteadyMotion{.velocity = {1, 0, 0}}));
  ASSERT_TRUE(scene.move(thing, {.position = {7, 0, 0}}));
  EXPECT_TRUE(scene.first_hit(down));
  EXPECT_EQ(scene.first_hit(down).velocity, Vec3d{}) << "it rests where it was put";
  EXPECT_EQ(scene.instance(thing)->motion, SceneMotion(AtRest{}));
}

TEST(SceneMotion, bad_input_is_refused_with_its_place) {
  Scene scene;
  const ShapeId box = scene.add_shape(BoxShape{}).value();
  const auto thing = scene.add({.shape = box});
  const auto refusal = [&](const SceneMotion& motion) {
    const Status status = scene.set_motion(*thing, motion);
    const auto other = scene.add({.shape = box, .motion = motion});
    EXPECT_EQ(static_cast<bool>(other), static_cast<bool>(status));
    return status ? std::string("none") : status.error().place;
  };
  EXPECT_EQ(refusal(SteadyMotion{.start = kNan}), "motion.start");
  EXPECT_EQ(refusal(SteadyMotion{.velocity = {kInfinity, 0, 0}}), "motion.velocity");
  EXPECT_EQ(refusal(SteadyMotion{.angular_velocity = {0, 1e7, 0}}), "motion.angular_velocity");
  EXPECT_EQ(refusal(KeyedMotion{}), "motion.keys");
  EXPECT_EQ(refusal(KeyedMotion{{{0, {}, {}, {}}, {0, {1, 0, 0}, {}, {}}}}), "motion.keys[1].time");
  EXPECT_EQ(refusal(KeyedMotion{{{0, {kNan, 0, 0}, {}, {}}}}), "motion.keys[0].position");
  EXPECT_EQ(refusal(KeyedMotion{{{0, {}, {0, 0, 0, 0}, {}}}}), "motion.keys[0].rotation");
  EXPECT_EQ(refusal(KeyedMotion{{{0, {}, {}, {kNan, 0, 0}}}}), "motion.keys[0].velocity");
  EXPECT_EQ(refusal(KeyedMotion{{{0, {}, {}, {}}, {1e-8, {1e9, 0, 0}, {}, {}}}}), "motion.keys[1].position");
  EXPECT_EQ(refusal(KeyedMotion{{{0, {}, {}, {}}}, static_cast<MotionCurve>(7)}), "motion.curve");
  EXPECT_EQ(refusal(KeyedMotion{{{0, {}, {}, {}}}}), "none") << "one key is a place";
  EXPECT_FALSE(scene.cover(1, 0));
  EXPECT_FALSE(scene.cover(0, kNan));
  EXPECT_FALSE(scene.cover(-kInfinity, kInfinity));
  EXPECT_FALSE(scene.state(*thing, kNan));
  const Vec3d far{0, 9, 0};
  EXPECT_TRUE(scene.first_hit({far, -far}));
  EXPECT_FALSE(scene.first_hit({far, -far, 0, kNan}));
  EXPECT_FALSE(scene.first_hit({far, -far, 0, 0, -1}));
  EXPECT_FALSE(scene.first_hit({far, -far, 0, 0, kInfinity}));
  EXPECT_FALSE(scene.nearest(far, kInfinity, {}, kNan));
  EXPECT_TRUE(scene.overlaps({}, 1, {}, kInfinity).empty());
}

TEST(Motion, in_next_to_no_time_things_stand_where_they_are) {
  Scene scene;
  for (const ShapeDef& shape : {ShapeDef(PlaneShape{}), ShapeDef(BoxShape{{1, 1, 1}}), ShapeDef(SphereShape{1})})
    add_thing(scene, shape,
              {.transform = {.position = {0, -1, 0}},
               .motion = SteadyMotion{.velocity = {0, 1, 0}, .angular_velocity = {0, 2, 1}}});
  for (const double radius : {0.0, 0.2}) {
    const SceneSegment at_once{{0.3, 5, 0.1}, {0.3, -5, 0.1}, radius, 0.25, 0};
    const SceneHit wanted = scene.first_hit(at_once);
    ASSERT_TRUE(wanted);
    for (const double duration : {5e-324, 1e-310, 1e-300, 1e-160, 1e-110, 1e-50}) {
      SceneSegment asked = at_once;
      asked.duration = duration;
      const SceneHit hit = scene.first_hit(asked);
      ASSERT_TRUE(hit) << duration;
      EXPECT_EQ(hit.instance, wanted.instance) << duration;
      EXPECT_NEAR(hit.part, wanted.part, 1e-12) << duration;
      EXPECT_EQ(scene.all_hits(asked).size(), scene.all_hits(at_once).size()) << duration;
    }
  }
}

}  // namespace physim::collide_motion_test
