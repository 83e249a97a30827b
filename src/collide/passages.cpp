#include "collide/passages.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "base/assert.hpp"
#include "base/isa.hpp"
#include "collide/contact_rules.hpp"
#include "math/vec3.hpp"

namespace physim::collide {
namespace {

/// How far beyond its ends a chord is looked at, as a part of it: places are rounded, and its things may move.
PHYSIM_COLD double overhang(const SceneSegment& chord) {
  constexpr double kLeast = 1e-9, kMost = 1e-3;
  const double places = 16 * std::numeric_limits<double>::epsilon() * (length(chord.from) + length(chord.to)) + 1e-12;
  const double way = length(chord.to - chord.from);
  return way > 0 ? std::clamp(places / way, kLeast, kMost) : kMost;
}

/// No surface, but where the point is when its way begins. By which surface it leaves, has the mark too.
bool begins_inside(const SceneHit& hit) { return hit.starts_inside && hit.entering; }

/// Whether a place is inside of the body that a surface is of, by a cast that is always the same.
PHYSIM_COLD bool is_inside(const Scene& scene, const SceneFilter& filter, const SceneHit& surface, const Vec3d& place,
                           double time) {
  constexpr Vec3d kAside{1e-6, 6e-7, 3e-7};  // [m]
  const auto begins_there = [&](const SceneHit& hit) { return begins_inside(hit) && is_one_body(scene, hit, surface); };
  return std::ranges::any_of(scene.all_hits({place, place + kAside, 0, time, 0}, filter), begins_there);
}

/// Leaves out what lies inside of bodies that have several parts.
PHYSIM_COLD void join_parts(const Scene& scene, std::vector<SceneHit>& hits, double one) {
  struct Body {
    SceneHit surface;
    int depth = 0;                           // parts that the point is in
    std::size_t last_out = ~std::size_t{0};  // the surface by which it left the body last
  };
  std::vector<Body> bodies;
  std::vector<bool> is_outer(hits.size(), true);
  for (std::size_t i = 0; i < hits.size(); ++i) {
    const SceneHit& hit = hits[i];
    if (scene.parts(hit.instance) == 0) continue;
    const auto same = [&](const Body& body) { return is_one_body(scene, body.surface, hit); };
    auto body = std::ranges::find_if(bodies, same);
    if (body == bodies.end()) body = bodies.insert(bodies.end(), Body{hit});
    if (begins_inside(hit)) {
      ++body->depth;
    } else if (hit.entering) {
      const bool goes_on = body->depth == 0 && body->last_out < i && hit.part - hits[body->last_out].part <= one;
      if (goes_on) is_outer[body->last_out] = false;
      is_outer[i] = body->depth == 0 && !goes_on;
      ++body->depth;
    } else {
      body->depth = std::max(body->depth - 1, 0);
      is_outer[i] = body->depth == 0;
      if (is_outer[i]) body->last_out = i;
    }
  }
  std::size_t kept = 0;
  for (std::size_t i = 0; i < hits.size(); ++i)
    if (is_outer[i]) hits[kept++] = hits[i];
  hits.resize(kept);
}

}  // namespace

PHYSIM_COLD std::vector<SceneHit> passages(const Scene& scene, const SceneFilter& filter, const SceneSegment& chord) {
  const double beyond = overhang(chord), whole = 1 + 2 * beyond;
  PHYSIM_ASSERT(beyond > 0 && beyond < 0.01);
  const Vec3d more = (chord.to - chord.from) * beyond;
  std::vector<SceneHit> hits = scene.all_hits(
      {chord.from - more, chord.to + more, 0, chord.time - chord.duration * beyond, chord.duration * whole}, filter);
  if (hits.empty()) return hits;
  join_parts(scene, hits, beyond);
  std::erase_if(hits, [&](SceneHit& hit) {
    if (begins_inside(hit)) return true;
    const double part = hit.part * whole - beyond;
    hit.part = std::clamp(part, 0.0, 1.0);
    // What lies on an end belongs to the chord before it if the place is behind the surface, and else to the next one.
    const bool at_start = part<0.5 * beyond, at_end = part> 1 - 0.5 * beyond;
    if (!at_start && !at_end) return false;
    const Vec3d& place = at_start ? chord.from : chord.to;
    const double time = at_start ? chord.time : chord.time + chord.duration;
    const bool is_behind = is_inside(scene, filter, hit, place, time) == hit.entering;
    return at_start ? is_behind : !is_behind;
  });
  return hits;
}

}  // namespace physim::collide
