// Projectiles that begin inside a thing: by rounding, or because they left another thing there. Each function finds the
// surface that they meet.
#pragma once

#include "collide/contact_rules.hpp"

namespace physim {

/// A projectile that may be inside a thing.
struct Within {
  const Scene& scene;
  const SceneFilter& solids;
  double radius;      // 0: a point [m]
  double gap;         // that it keeps from surfaces, see gap_at() [m]
  double time;        // of the scene [s]
  bool goes_through;  // what it meets
};

/// Sets `hit` to the surface of a thing that the projectile is inside of by no more than rounding, and the projectile
/// on that surface, also if it moves along the surface; a ball also if it left another thing that touches this one.
inline void look_for_surface(const Within& w, State<double>& s, SceneHit& hit) {
  const Vec3d relative = s.v - hit.velocity;
  const double speed = length(relative);
  const bool is_ball = w.radius > 0;
  const double near = 4 * w.gap + (is_ball && w.goes_through ? 2 * w.radius : 0);
  const double here = 0.5 + 0.5 * w.gap / near;  // rounded as seen from the thing, it may lie outside by as much
  const Vec3d off = relative * (speed > 0 ? near / speed : 0);
  const SceneHit inside_of = hit;
  for (const SceneHit& each : w.scene.all_hits({s.x - off, s.x + off, 0, w.time, 0}, w.solids)) {
    if (!is_one_body(w.scene, each, inside_of) || each.starts_inside) continue;
    const bool is_it = each.entering ? each.part <= here : hit.starts_inside && each.part >= 0.5 && !is_ball;
    if (!is_it) continue;
    hit = each;
    s.x = each.position + each.normal * w.radius;
  }
  if (!hit.starts_inside) return;
  if (const SceneHit beside = surface_beside(w.scene, w.solids, hit, s.x, 4 * w.gap, w.time))
    hit = beside, s.x = beside.position + beside.normal * w.radius;
}

/// The surface of another thing than the one below that a point's way goes into at once, as the point is in it by a
/// micrometre at most.
[[nodiscard]] inline SceneHit point_stands_here(const Within& w, const Vec3d& x, const SceneHit& below,
                                                const SceneHit& wall, const Vec3d& way) {
  if (wall.instance == below.instance) return {};
  SceneHit surface = surface_beside(w.scene, w.solids, wall, x, max(1e-6, 4 * w.gap), w.time);
  surface.part = 0;
  return dot(way, surface.normal) < 0 ? surface : SceneHit{};
}

/// The surface of another body through which a point was put as it came out of one: a mesh that touches it.
[[nodiscard]] inline SceneHit entered_at(const Within& w, const State<double>& s, const SceneHit& left) {
  const Vec3d off = normalized(s.v - left.velocity) * (4 * w.gap);
  for (const SceneHit& each : w.scene.all_hits({s.x - off, s.x, 0, w.time, 0}, w.solids))
    if (each.entering && !each.starts_inside && !is_one_body(w.scene, each, left)) return each;
  return {};
}

}  // namespace physim
