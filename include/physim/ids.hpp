// Ids: what projectiles, kinds and force generators of a world are named by, and what stands in a scene.
#pragma once

#include <compare>
#include <cstddef>
#include <cstdint>
#include <functional>

namespace physim {

/// Names a projectile: the number of its slot and how often that slot was used. Index 0 is nobody. Ids of projectiles
/// that are gone are detected; every call ignores them or says so. An id is a number that is the same on every machine
/// that makes the same calls, so it does not say of which world it is: keep ids of different worlds apart. Ids can be
/// compared, sorted (by index) and used as keys.
struct ProjectileId {
  std::uint32_t index = 0;       ///< of the slot; 0: nobody [-]
  std::uint32_t generation = 0;  ///< of the slot's use [-]

  explicit operator bool() const { return index != 0; }
  auto operator<=>(const ProjectileId&) const = default;
};

/// Names a kind of projectile of one world; 0 is none. No number is given twice.
struct KindId {
  std::uint32_t index = 0;  ///< [-]

  explicit operator bool() const { return index != 0; }
  auto operator<=>(const KindId&) const = default;
};

/// Names a force generator of one world.
struct ForceId {
  std::uint32_t index = 0;       ///< 0: none [-]
  std::uint32_t generation = 0;  ///< [-]

  explicit operator bool() const { return index != 0; }
  auto operator<=>(const ForceId&) const = default;
};

/// Names a shape of one scene; index 0 is none. Ids of what is gone are told from those of what took its place.
struct ShapeId {
  std::uint32_t index = 0;       ///< [-]
  std::uint32_t generation = 0;  ///< [-]

  explicit operator bool() const { return index != 0; }
  auto operator<=>(const ShapeId&) const = default;
};
/// Names a thing that stands in one scene; index 0 is none.
struct InstanceId {
  std::uint32_t index = 0;       ///< [-]
  std::uint32_t generation = 0;  ///< [-]

  explicit operator bool() const { return index != 0; }
  auto operator<=>(const InstanceId&) const = default;
};
/// Names a material of one scene; 0 is the one that every scene begins with. Materials stay as long as their scene.
struct MaterialId {
  std::uint32_t index = 0;  ///< [-]

  auto operator<=>(const MaterialId&) const = default;
};

}  // namespace physim

template <>
struct std::hash<physim::ProjectileId> {
  std::size_t operator()(const physim::ProjectileId& id) const noexcept {
    return std::hash<std::uint64_t>()(id.index | std::uint64_t{id.generation} << 32);
  }
};
template <>
struct std::hash<physim::KindId> {
  std::size_t operator()(const physim::KindId& id) const noexcept { return std::hash<std::uint32_t>()(id.index); }
};
template <>
struct std::hash<physim::ForceId> {
  std::size_t operator()(const physim::ForceId& id) const noexcept {
    return std::hash<std::uint64_t>()(id.index | std::uint64_t{id.generation} << 32);
  }
};
template <>
struct std::hash<physim::InstanceId> {
  std::size_t operator()(const physim::InstanceId& id) const noexcept {
    return std::hash<std::uint64_t>()(id.index | std::uint64_t{id.generation} << 32);
  }
};
