// Two projectiles that touch, or pass through each other, within a step.
#pragma once

#include <algorithm>
#include <tuple>

#include "base/assert.hpp"
#include "math/vec3.hpp"
#include "world/core/kinds.hpp"
#include "world/couple/pairs.hpp"

namespace physim {

/// Part of their reach by which two may lie in each other; farther, one was put inside of the other [-].
inline constexpr double kDeep = 1e-3;

/// Layers of both, as both want.
[[nodiscard]] inline bool want_each_other(const Collider& a, const Collider& b) {
  return meet_by_layers(a.kind->body.collision, a.layers, b.kind->body.collision, b.layers);
}
[[nodiscard]] inline bool may_move(const Collider& c) { return c.flies || c.sleeps; }
[[nodiscard]] inline double reach(const Collider& c) { return c.kind->body.collision.radius; }
[[nodiscard]] inline bool passes(const Collider& c) { return c.kind->body.collision.on_hit == OnHit::pass; }

/// So far two that touch may be from where they should be [m].
[[nodiscard]] inline double slack_between(const Collider& a, const Collider& b) {
  return 1e-9 * (reach(a) + reach(b)) + 4 * std::max(a.spacing, b.spacing);
}
/// One was put inside of the other: they meet once in a step, until they have been apart.
[[nodiscard]] inline bool is_deep(const Collider& a, const Collider& b, const collide::Knot& on_a,
                                  const collide::Knot& on_b) {
  const double radius = reach(a) + reach(b);
  PHYSIM_ASSERT(radius >= 0);
  return length(on_a.x - on_b.x) < (1 - kDeep) * radius;
}

/// From b to a.
[[nodiscard]] inline Vec3d normal_between(const collide::Knot& a, const collide::Knot& b) {
  const Vec3d between = a.x - b.x, relative = a.v - b.v;
  if (length(between) > 0) return normalized(between);
  return length(relative) > 0 ? -normalized(relative) : Vec3d{1, 0, 0};  // one in the middle of the other
}

/// Moves two that lie in each other apart, by their masses, and takes away the speed at which they approach.
[[nodiscard]] inline bool push_apart(const Collider& a, const Collider& b, collide::Knot& on_a, collide::Knot& on_b) {
  const Vec3d n = normal_between(on_a, on_b);
  const double give = dot(component_product(a.mobility + b.mobility, n), n);
  PHYSIM_ASSERT(!(give < 0));
  const double deep = reach(a) + reach(b) - length(on_a.x - on_b.x);
  if (!(deep > slack_between(a, b)) || !(give > 0)) return false;
  const Vec3d push = n * (deep / give);
  on_a.x += component_product(a.mobility, push);
  on_b.x -= component_product(b.mobility, push);
  const double speed = dot(on_a.v - on_b.v, n);
  if (!(speed < 0)) return true;
  const Vec3d impulse = n * (-speed / give);
  on_a.v += component_product(a.mobility, impulse);
  on_b.v -= component_product(b.mobility, impulse);
  return true;
}

/// Two that touch, or pass through each other.
struct Meeting {
  double time;         // into the step [s]
  std::uint32_t a, b;  // a < b
  std::uint32_t version_a, version_b;
  EventKind kind;  // hit, entered or left

  /// Later, for a queue whose top is the first.
  bool operator<(const Meeting& other) const { return std::tie(time, a, b) > std::tie(other.time, other.a, other.b); }
};

}  // namespace physim
