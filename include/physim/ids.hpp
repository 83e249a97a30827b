// Ids: what projectiles, kinds and force generators of a world are named by.
#pragma once

#include <cstdint>

namespace physim {

/// Names a projectile: the number of its slot and how often that slot was used. Index 0 is nobody. Ids of projectiles
/// that are gone are detected; every call ignores them or says so.
struct ProjectileId {
  std::uint32_t index = 0;       ///< of the slot; 0: nobody [-]
  std::uint32_t generation = 0;  ///< of the slot's use [-]

  explicit operator bool() const { return index != 0; }
  bool operator==(const ProjectileId&) const = default;
};

/// Names a kind of projectile of one world; 0 is none.
struct KindId {
  std::uint32_t index = 0;  ///< [-]

  explicit operator bool() const { return index != 0; }
  bool operator==(const KindId&) const = default;
};

/// Names a force generator of one world.
struct ForceId {
  std::uint32_t index = 0;       ///< 0: none [-]
  std::uint32_t generation = 0;  ///< [-]

  explicit operator bool() const { return index != 0; }
  bool operator==(const ForceId&) const = default;
};

}  // namespace physim
