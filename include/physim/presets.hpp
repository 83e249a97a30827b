// Presets of projectiles: what flies, how a world treats it, and how fast it usually starts. The fidelity is your
// choice.
#pragma once

#include <optional>
#include <span>
#include <string>
#include <string_view>

#include "physim/projectile.hpp"
#include "physim/world_def.hpp"

namespace physim {

/// A projectile to start from.
struct ProjectilePreset {
  ProjectileDef projectile{};  ///< [-]
  BodyDef body{};              ///< [-]
  double speed = 0;            ///< usual at launch [m/s]
  std::string doc{};           ///< what it is [-]
  std::string source{};        ///< where its numbers come from [-]
};

namespace presets {

// The projectiles of the original PhySim (2017): damping and a gravity of their own, in its own frame loop
// (Fidelity::classic()).
[[nodiscard]] ProjectilePreset artillery();
[[nodiscard]] ProjectilePreset bullet();
[[nodiscard]] ProjectilePreset laser();
[[nodiscard]] ProjectilePreset sphere();

[[nodiscard]] ProjectilePreset rifle_bullet();
[[nodiscard]] ProjectilePreset arrow();
[[nodiscard]] ProjectilePreset grenade();
[[nodiscard]] ProjectilePreset paintball();
[[nodiscard]] ProjectilePreset tennis_ball();
[[nodiscard]] ProjectilePreset golf_ball();
[[nodiscard]] ProjectilePreset baseball();
[[nodiscard]] ProjectilePreset football();
[[nodiscard]] ProjectilePreset table_tennis_ball();

}  // namespace presets

/// Names of all presets of projectiles.
[[nodiscard]] std::span<const std::string_view> projectile_presets();
/// The preset of a name ("rifle_bullet"), if it is one.
[[nodiscard]] std::optional<ProjectilePreset> projectile_preset(std::string_view name);

}  // namespace physim
