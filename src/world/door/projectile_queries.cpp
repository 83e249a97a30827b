// Queries of a world that see projectiles: those in a sphere or in a box, and those along a way.
//
// Each is the ball of its CollisionDef, or a point, where the last step left it. All are looked at, in order of their
// indices: a query costs as much as reading their places.
#include <algorithm>
#include <string>
#include <tuple>

#include "base/checker.hpp"
#include "base/ieee_mode.hpp"
#include "collide/content.hpp"
#include "math/pack.hpp"
#include "math/quat.hpp"
#include "world/couple/world_impl.hpp"

namespace physim {
namespace {

/// Calls f(id, place, radius) for all of some layers that were launched.
template <class F>
void each_projectile(const WorldImpl& world, std::uint32_t layers, const F& f) {
  const SlotTable& slots = world.state.slots;
  slots.each_alive([&](std::uint32_t index) {
    const Slot& slot = slots[index];
    if (slot.is(kPending) || (world.layers_of(index) & layers) == 0) return;
    const double radius = world.registry.kind(slot.kind).body.collision.radius;
    PHYSIM_ASSERT(radius >= 0);
    f(slots.id_of(index), world.state.rows_of(slot).position(slot.row), radius);
  });
}

/// Where a ball that goes straight first touches another one that stands; none: nowhere.
std::optional<double> first_touch(const Vec3d& from, const Vec3d& along, const Vec3d& middle, double reach) {
  const Vec3d off = from - middle;
  if (length_squared(off) <= reach * reach) return 0.0;
  const double a = length_squared(along), b = dot(off, along);
  if (!(b < 0)) return std::nullopt;
  PHYSIM_ASSERT(a > 0);
  const Vec3d aside = off - along * (b / a);
  const double left = reach * reach - length_squared(aside);
  if (!(left >= 0)) return std::nullopt;
  const double part = max((-b - sqrt(a * left)) / a, 0.0);
  return part <= 1 ? std::optional(part) : std::nullopt;
}

Status check_radius(double radius) {
  return Checker()
      .require(radius >= 0 && radius <= collide::kFarthest, "radius", "must lie between 0 and 1e15 m")
      .status();
}
Status check_place(const Vec3d& place, const char* name) {
  return Checker().require(collide::is_near(place), name, "must lie within 1e15 m of the origin").status();
}

}  // namespace

Result<std::vector<ProjectileId>> World::projectiles_in(const Vec3d& middle, double radius,
                                                        std::uint32_t layers) const {
  const IeeeMode mode;
  Checker c;
  if (auto status = c.also(check_place(middle, "middle")).also(check_radius(radius)).status(); !status)
    return status.error();
  std::vector<ProjectileId> found;
  each_projectile(impl(), layers, [&](ProjectileId id, const Vec3d& place, double own) {
    const double reach = radius + own;
    if (length_squared(place - middle) <= reach * reach) found.push_back(id);
  });
  return found;
}

Result<std::vector<ProjectileId>> World::projectiles_in(const Transform& at, const Vec3d& half,
                                                        std::uint32_t layers) const {
  const IeeeMode mode;
  Checker c;
  c.also(collide::check(at, "at"));
  c.require(half.x >= 0 && half.y >= 0 && half.z >= 0 && collide::is_near(half), "half",
            "must have components between 0 and 1e15 m", "half of the edges");
  if (auto status = c.status(); !status) return status.error();
  const Quatd inwards = conjugate(normalized(at.rotation));
  const Vec3d reach = half * at.scale;
  std::vector<ProjectileId> found;
  each_projectile(impl(), layers, [&](ProjectileId id, const Vec3d& place, double own) {
    const Vec3d p = rotate(inwards, place - at.position);
    const Vec3d beyond{max(abs(p.x) - reach.x, 0.0), max(abs(p.y) - reach.y, 0.0), max(abs(p.z) - reach.z, 0.0)};
    if (length_squared(beyond) <= own * own) found.push_back(id);
  });
  return found;
}

Result<std::vector<ProjectileHit>> World::projectiles_along(const Vec3d& from, const Vec3d& to, double radius,
                                                            std::uint32_t layers) const {
  const IeeeMode mode;
  Checker c;
  c.also(check_place(from, "from")).also(check_place(to, "to")).also(check_radius(radius));
  if (auto status = c.status(); !status) return status.error();
  const Vec3d along = to - from;
  std::vector<ProjectileHit> found;
  each_projectile(impl(), layers, [&](ProjectileId id, const Vec3d& place, double own) {
    const auto part = first_touch(from, along, place, radius + own);
    if (!part) return;
    const Vec3d touching = from + along * *part, off = touching - place;
    const double apart = length(off);
    found.push_back({.id = id, .part = *part, .position = touching, .normal = apart > 0 ? off * (1 / apart) : Vec3d{}});
  });
  std::ranges::sort(found, {}, [](const ProjectileHit& hit) { return std::tuple(hit.part, hit.id.index); });
  return found;
}

}  // namespace physim
