// What contacts of what flies with the ground, with things of a scene and with others have in common.
#pragma once

#include <algorithm>
#include <cstdint>
#include <span>
#include <vector>

#include "base/function_ref.hpp"
#include "collide/even_way.hpp"
#include "collide/path_cast.hpp"
#include "collide/scene_by_motion.hpp"
#include "collide/seen_hit.hpp"
#include "math/elementary.hpp"
#include "math/vec3.hpp"
#include "model/ball_rolling.hpp"
#include "model/body.hpp"
#include "model/contact.hpp"
#include "model/pair_contact.hpp"
#include "physim/body.hpp"
#include "physim/event.hpp"
#include "physim/scene.hpp"

namespace physim {

/// Contacts in a step: between two walls there may be many.
inline constexpr int kMostHits = 1000;

/// Near what it touched it goes on in parts of so much or less: what a bounce may be too low for is judged by them,
/// and a ball that bounces on has steps that its way is right with [s].
inline constexpr double kLongestPart = 1.0 / 30;

/// By so much of the step that follows a contact is judged [s].
[[nodiscard]] inline double frame_of_contact(double step_length) { return std::min(step_length, kLongestPart); }
/// What falls from higher than a step's fall strikes the surface, even where nothing of its speed is left.
[[nodiscard]] inline bool is_strike(double speed, double acceleration, double frame) {
  return speed < acceleration * frame;
}

/// A number of each of two that touch, as one.
[[nodiscard]] inline double combined(double a, double b, Combine rule) {
  switch (rule) {
    case Combine::product: return a * b;
    case Combine::mean: return 0.5 * a + 0.5 * b;
    case Combine::minimum: return std::min(a, b);
    case Combine::maximum: return std::max(a, b);
  }
  return a * b;
}

/// What a projectile brings to its contacts.
struct OwnSurface {
  double restitution;         // [-]
  double friction;            // [-]
  double rolling_resistance;  // [-]
  CombineDef combine;

  /// The surface of a BodyDef or a ContactDef.
  template <class Def>
  [[nodiscard]] static OwnSurface of(const Def& def) {
    return {def.restitution, def.friction, def.rolling_resistance, def.combine};
  }
};

/// Restitution and friction of the contact of two: materials, the ground, bodies.
template <class A, class B>
[[nodiscard]] PairSurface pair_surface(const A& a, const B& b) {
  const CombineDef rules{std::max(a.combine.restitution, b.combine.restitution),
                         std::max(a.combine.friction, b.combine.friction)};
  PHYSIM_ASSERT(a.restitution >= 0 && b.restitution >= 0 && a.friction >= 0 && b.friction >= 0);
  return {combined(a.restitution, b.restitution, rules.restitution), combined(a.friction, b.friction, rules.friction)};
}

/// Restitution, friction and rolling resistance of a projectile on a material or on the ground.
template <class Of>
[[nodiscard]] Surface surface_between(const Of& of, const OwnSurface& own) {
  const PairSurface pair = pair_surface(of, own);
  return {pair.restitution, pair.friction, own.rolling_resistance};
}

/// The way of a projectile along a plane surface, as seen from the thing; the surface of a conveyor runs over the thing
/// by `over`. `f(motion)` gives the way along a surface that stands.
template <class F>
[[nodiscard]] BallWay way_on(BallMotion motion, const Vec3d& over, const F& f) {
  if (over == Vec3d{}) return f(motion);
  motion.velocity -= over;
  BallWay way = f(motion);
  PHYSIM_ASSERT(way.time >= 0);
  way.way += over * way.time;
  way.motion.velocity += over;
  return way;
}
/// The way of a point along such a surface in all of a time.
[[nodiscard]] inline BallWay point_way(const BallMotion& motion, const Vec3d& over, const Pull& pull, const Vec3d& n,
                                       const Surface& on, double time) {
  return way_on(motion, over, [&](const BallMotion& from) {
    const Rolled it = rolled(from.velocity, pull, n, on, time);
    return BallWay{time, it.way, {it.velocity, from.spin}};
  });
}

/// Velocity with which the ground runs [m/s].
[[nodiscard]] inline Vec3d conveyor_along(const Ground& ground, const Vec3d& n) {
  const Vec3d v = ground.conveyor.velocity;
  return v == Vec3d{} ? v : v - n * dot(v, n);
}

/// A hit with the normal of a triangle towards the projectile that meets its back.
[[nodiscard]] inline SceneHit with_facing_normal(SceneHit hit) {
  if (!hit.entering && !hit.starts_inside) hit.normal = -hit.normal;
  return hit;
}

/// A projectile continues in the body that it is inside of as if it came straight into it there.
inline void enter_here(const State<double>& s, SceneHit& hit) {
  PHYSIM_ASSERT(hit.starts_inside);
  const Vec3d relative = s.v - hit.velocity;
  if (!(length(relative) > 0)) return;
  hit.normal = -normalized(relative);
  hit.starts_inside = false;
  hit.entering = true;
}

/// The motion of a ball, or of a point, behind a moment at which it meets several surfaces.
[[nodiscard]] inline BallMotion met_together(const BallMotion& came, const Ball& ball, std::span<const SceneHit> hits,
                                             std::span<const Surface> on) {
  PHYSIM_ASSERT(hits.size() == on.size() && hits.size() > 1);
  PairBody body{came.velocity, came.spin, {1, 1, 1}, ball.radius, 0, ball.turns};
  if (ball.radius > 0) body.turnability = 1 / (ball.inertia * ball.radius * ball.radius);
  std::vector<PairBody> walls;
  for (const SceneHit& hit : hits) walls.push_back({hit.velocity, {}, {}, 0, 0});
  std::vector<PairTouch> touches;
  for (std::size_t i = 0; i < hits.size(); ++i)
    touches.push_back({body, walls[i], hits[i].normal, {on[i].restitution, on[i].friction}});
  meet(touches);
  return {body.velocity, body.spin};
}

/// True if a hit ends the flight.
[[nodiscard]] inline bool ends_flights(OnHit on_hit) { return on_hit == OnHit::stop || on_hit == OnHit::stick; }

/// Whether hits are of one thing, and there of one body: parts of a compound that are of one material are.
[[nodiscard]] inline bool is_one_body(const Scene& scene, const SceneHit& a, const SceneHit& b) {
  if (a.instance != b.instance) return false;
  return a.primitive == b.primitive || a.material == b.material || scene.parts(a.instance) == 0;
}

/// A hit, with the first of the parts that are there: where surfaces of several lie in one plane, rounding decides
/// which of them is met first. `touched`: the place on the surface.
[[nodiscard]] inline SceneHit of_first_part(const Scene& scene, const SceneFilter& solids, SceneHit hit,
                                            const Vec3d& touched, double time) {
  if (!hit.entering || hit.starts_inside || hit.primitive == 0 || scene.parts(hit.instance) == 0) return hit;
  const Vec3d below = touched - hit.normal * (1e-9 + 8 * spacing_at<double>(touched));
  const SceneHit there = scene.first_hit({below, below, 0, time, 0}, solids);
  if (there.instance != hit.instance || there.primitive >= hit.primitive || there.material == hit.material) return hit;
  hit.primitive = there.primitive;
  hit.material = there.material;
  return hit;
}

/// The place behind an edge of a thing that a point touches without going into the thing; none if the point goes into
/// it.
[[nodiscard]] inline std::optional<Vec3d> beyond_edge(const Scene& scene, const SceneFilter& solids,
                                                      const State<double>& s, const SceneHit& hit, double time) {
  if (!hit.entering) return std::nullopt;
  const Vec3d off = normalized(s.v - hit.velocity) * (1e-9 + 8 * spacing_at<double>(s.x));
  const SceneHit back = scene.first_hit({s.x + off, s.x - off, 0, time, 0}, solids);
  if (back.instance != hit.instance || back.starts_inside) return std::nullopt;
  if (!back.entering) {  // triangles: it is one where it is left where it is entered
    const bool has_parts = scene.parts(hit.instance) > 0;
    int inside = 0;
    for (const SceneHit& each : scene.all_hits({s.x - off, s.x + off, 0, time, 0}, solids))
      if (each.instance == hit.instance && (!has_parts || each.primitive == hit.primitive))
        inside += each.entering ? 1 : -1;
    if (inside != 0) return std::nullopt;
  }
  return s.x + off;
}

/// The surface of the body that a hit is of and that a place lies in by no more than `rounding`, in whichever direction
/// that is, or outside of by a quarter of it; none: the place lies deeper.
[[nodiscard]] inline SceneHit surface_beside(const Scene& scene, const SceneFilter& solids, const SceneHit& inside_of,
                                             const Vec3d& place, double rounding, double time) {
  for (const Vec3d& axis : {Vec3d{0, 1, 0}, Vec3d{1, 0, 0}, Vec3d{0, 0, 1}})
    for (const double side : {rounding, -rounding})
      for (const SceneHit& each : scene.all_hits({place + axis * side, place - axis * side, 0, time, 0}, solids))
        if (is_one_body(scene, each, inside_of) && each.entering && !each.starts_inside && each.part <= 0.625)
          return each;
  return {};
}

/// The sensors that tell who stays in them, of some layers, that hold two places, each at its time.
[[nodiscard]] inline std::vector<SceneHit> sensors_around(const Scene& scene, std::uint32_t layers, const Vec3d& start,
                                                          double from, const Vec3d& end, double to) {
  PHYSIM_ASSERT(from <= to);
  std::vector<InstanceId> before;
  std::vector<SceneHit> both;
  const auto each_around = [&](const Vec3d& place, double time, const auto& f) {
    SceneByMotion(scene).each_beside(place, 0, {.layers = layers}, time, [&](const SceneNearest& near) {
      if (near.distance == 0 && near.away == Vec3d{} && scene.is_sensor(near.instance)) f(near);
    });
  };
  each_around(start, from, [&](const SceneNearest& near) { before.push_back(near.instance); });
  each_around(end, to, [&](const SceneNearest& near) {
    const bool tells = SceneByMotion(scene).content().instances[near.instance.index].def.passage.tells_stay;
    if (tells && std::ranges::find(before, near.instance) != before.end())
      both.push_back({.instance = near.instance, .primitive = near.primitive, .material = near.material});
  });
  return both;
}

/// Which draws of chance a hit takes: the so-manyth of a step. The step is told by a number, or by the bits of a time,
/// the lowest of which are often 0.
[[nodiscard]] inline std::uint32_t hit_number(std::uint64_t step, int hits) {
  const auto mixed = static_cast<std::uint32_t>((step * 0x9e3779b97f4a7c15u) >> 32);
  return mixed * 1009u + static_cast<std::uint32_t>(hits);
}

/// What an event tells of a state and of what was met there; not whose it is, nor when.
[[nodiscard]] inline Event event_of(EventKind kind, Reason reason, const State<double>& s, const SceneHit& hit,
                                    double depth, double energy) {
  return {.kind = kind,
          .reason = reason,
          .value = depth,
          .position = s.x,
          .velocity = s.v,
          .normal = hit.normal,
          .instance = hit.instance,
          .primitive = hit.primitive,
          .material = hit.material,
          .energy = energy};
}

/// What is asked of a hit, but for whose it is, when, and how thick the thing is. `mass`: 0 for none [kg].
[[nodiscard]] inline HitQuestion question_of(const State<double>& s, const SceneHit& hit, double mass) {
  const Vec3d way = s.v - hit.velocity;
  return {.position = s.x,
          .velocity = s.v,
          .normal = hit.normal,
          .surface_velocity = hit.velocity,
          .instance = hit.instance,
          .primitive = hit.primitive,
          .material = hit.material,
          .energy = 0.5 * mass * length_squared(way),
          .obliquity = obliquity_of(way, hit.normal),
          .inside = hit.starts_inside};
}

/// A motion along a surface.
struct AlongSurface {
  Vec3d v_t;      // along it, as the surface has it [m/s]
  Vec3d normal;   // of the surface [-]
  double passed;  // of the step before it [s]
  double time;    // that it lasts [s]
};
/// The pull on a host that slides; `a` is its acceleration as the surface has it, which may be accelerated itself.
/// Nothing but drag depends on how fast the host slides, but for what acts across its way. `end(pull)`: its velocity
/// over the surface when the time has passed.
template <class Host>
[[nodiscard]] Pull pull_along(const Host& host, const Vec3d& a, const State<double>& s, const AlongSurface& slide,
                              FunctionRef<Vec3d(const Pull&)> end) {
  if (slide.v_t == Vec3d{}) return a;
  const Vec3d own = host.acceleration_at(s, slide.passed);
  const Vec3d ending = host.acceleration_at({s.x, s.v - slide.v_t}, slide.passed) - own;
  const Vec3d pull_t = own - slide.normal * dot(own, slide.normal);
  const auto pulls = [&](double kept) { return braked(a, pull_t, ending, slide.v_t, slide.time, kept); };
  const Pull alone = pulls(1);
  return alone.has_drag() ? pulls(dot(end(alone), slide.v_t) / length_squared(slide.v_t)) : alone;
}

/// The difference between a host's accelerations in two states at one time, to - from [m/s^2].
template <class Host>
[[nodiscard]] Vec3d changed_by(const Host& host, const State<double>& from, const State<double>& to, double passed) {
  return host.acceleration_at(to, passed) - host.acceleration_at(from, passed);
}

/// What stands in the way of a ball that touches it already: the deepest but `below`; none if nothing does.
[[nodiscard]] inline SceneNearest in_way(const Scene& scene, const SceneFilter& solids, InstanceId below,
                                         const Vec3d& x, const Vec3d& way, double radius, double time) {
  PHYSIM_ASSERT(radius > 0);
  SceneNearest nearest;
  SceneByMotion(scene).each_beside(x, radius, solids, time, [&](const SceneNearest& near) {
    const bool stands = near.instance != below && dot(way, near.away) < 0;
    if (stands && (!nearest || near.distance < nearest.distance)) nearest = near;
  });
  return nearest;
}

}  // namespace physim
