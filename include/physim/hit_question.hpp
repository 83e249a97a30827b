// Hits that ask: what a world tells of each hit of a projectile whose kind asks (OnHit::ask), and what is answered.
#pragma once

#include <cstdint>
#include <functional>
#include <optional>
#include <span>

#include "physim/collision.hpp"
#include "physim/ids.hpp"
#include "physim/vec3.hpp"

namespace physim {

/// A hit about which a world asks.
struct HitQuestion {
  ProjectileId projectile{};    ///< that struck [-]
  KindId kind{};                ///< of it [-]
  double time = 0;              ///< of the world, inside of the step at hand [s]
  Vec3d position{};             ///< of the point, or of the middle of the ball, then [m]
  Vec3d velocity{};             ///< with which it came [m/s]
  Vec3d normal{};               ///< of the surface, towards the projectile [-]
  Vec3d surface_velocity{};     ///< of what was struck, there and then [m/s]
  InstanceId instance{};        ///< that was struck [-]
  std::uint32_t primitive = 0;  ///< of it, as SceneHit::primitive [-]
  MaterialId material{};        ///< of it [-]
  double energy = 0;            ///< of its motion, as seen from the surface; 0 without a mass [J]
  double obliquity = 0;         ///< between its way, as seen from the surface, and the normal; 0 straight on [rad]
  double thickness = 0;         ///< of the thing along its way; 0: not known, a sheet, or more than 1000 m [m]
  bool inside = false;  ///< it was inside of the thing when the step began: it stays there, unless it is to stop [-]

  bool operator==(const HitQuestion&) const = default;
};

/// What a projectile does then: as if its kind did, but for `pass`.
struct HitAnswer {
  OnHit then = OnHit::stop;  ///< any but `ask`; `pass`: it comes out behind the thing at once, by the straight way, and
                             ///< flies on from there: an event `penetrated` [-]
  std::optional<Vec3d> velocity{};  ///< after it, instead of what follows: of `bounce`, not into the surface, or of
                                    ///< `pass`, on into it; as seen from the surface no faster than before [m/s]

  bool operator==(const HitAnswer&) const = default;
};

/// All hits about which nothing is known yet, in order of time, then of id; no projectile has two.
struct HitBatch {
  std::span<const HitQuestion> questions{};  ///< [-]
  std::span<HitAnswer> answers{};            ///< one for each question, HitAnswer{} as it comes [-]
};
using HitFunction = std::function<void(const HitBatch&)>;

/// What a world asked since it was made or loaded.
struct HitCounts {
  std::uint64_t calls = 0;      ///< of its function [-]
  std::uint64_t questions = 0;  ///< in these [-]
  std::uint64_t refused = 0;    ///< answers that made no sense, or threw: they count as OnHit::stop [-]
};

}  // namespace physim
