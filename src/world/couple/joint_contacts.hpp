// What held projectiles meet while their net moves them: the ground that they bounce on, and things of the scene.
#pragma once

#include <cstdint>
#include <optional>

#include "physim/event.hpp"
#include "physim/math.hpp"

namespace physim {

class Scene;
struct WorldImpl;

/// A plane that a projectile stays in front of.
struct NetContact {
  Vec3d normal{};          // of length one, outwards
  double offset = 0;       // dot(normal, place) is not below [m]
  Vec3d place{};           // of its middle where it touches [m]
  double restitution = 0;  // 0 where it stops or sticks [-]
  bool rests = true;       // the ground, or a thing that does not move
};

/// True if a thing of the scene does not move; the motion of an engine's thing is not known.
[[nodiscard]] bool is_at_rest(const Scene& scene, InstanceId thing);

/// What a projectile would go into on a straight way at the end of a step; nothing where the way is free.
[[nodiscard]] std::optional<NetContact> contact_on_way(const WorldImpl& world, std::uint32_t slot, const Vec3d& from,
                                                       const Vec3d& to);

}  // namespace physim
