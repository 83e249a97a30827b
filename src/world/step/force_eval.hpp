// Evaluates force generators over batches of projectiles, in double whatever their precision.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "model/body.hpp"
#include "physim/result.hpp"
#include "physim/world.hpp"

namespace physim {

/// Refuses bad input with a place ("force.stiffness") and a hint. Whether its ids and kind exist, the world knows.
[[nodiscard]] Status check(const ForceDef& force);

inline constexpr std::uint32_t kNotInStage = 0xffffffff;

/// The other end of a spring.
struct Partner {
  bool alive = false;
  std::uint32_t row = kNotInStage;  // of the stage: it feels the opposite force
  State<double> state;              // where it is in no stage (asleep, kinematic, infinite mass, another batch)
};

/// What laws ask about the world outside the stage's columns. Virtual, because it is asked once per spring, or for the
/// few projectiles inside a wind zone.
class Surroundings {
 public:
  [[nodiscard]] virtual Partner partner(ProjectileId id) const = 0;
  /// The drag equation for a row's own area and Cd, at a velocity u through air of a density [N]; see KindDrag.
  [[nodiscard]] virtual Vec3d drag_equation(std::uint32_t row, double density, const Vec3d& u) const = 0;
  /// What the row's own drag model gives at its state in the stage; zero where drag is off.
  struct OwnDrag {
    Vec3d force;  // [N]
    double rate;  // times the mass [kg/s]
  };
  [[nodiscard]] virtual OwnDrag own_drag(std::uint32_t row) const = 0;

 protected:
  ~Surroundings() = default;
};

/// Projectiles in one stage of a step, side by side. Those of infinite mass are not here: nothing moves them.
struct ForceStage {
  double time = 0;                            // of the world [s]
  std::span<const ProjectileId> id;           //
  std::span<const Vec3d> position;            // [m]
  std::span<const Vec3d> velocity;            // [m/s]
  std::span<const double> mass;               // [kg]
  std::span<const double> age;                // since launch; read by thrust alone, and may be empty without [s]
  std::span<const ProjectileDef* const> def;  // read by buoyancy alone
  std::span<std::uint8_t> in_zone;  // zeros at the start of a stage: the first zone of wind that holds a row takes it
  std::span<Vec3d> force;           // is added to [N]
  std::span<double> drag_rate;      // of the drag in it, times the mass; is added to [kg/s]
};

/// What the clock of a generator says.
struct ForceClock {
  double since_start = 0;    // since the generator began to act [s]
  bool from_launch = false;  // thrust counts from each launch instead: generators of kinds
};

/// Columns for user functions, kept from call to call so that a steady step allocates nothing.
struct ForceScratch {
  std::vector<ProjectileId> id;
  std::vector<Vec3d> position, velocity, force;
  std::vector<double> mass;
};

/// Adds a law's force on the rows `members` of the stage, and the opposite force on the other end of a spring where
/// that is in the stage. False where the other end is gone: there is no force, and there never will be.
///
/// Each row's force depends on that row alone, so any cut of the members gives the same bits, also from several threads
/// with a scratch each; but not for a user function (one call for all) nor a spring between two (rows of one partner
/// are summed in the order of the members, which must not depend on where rows happen to lie: order them by id).
/// A NaN is not hidden: it reaches the force of that row, and of its partner.
bool add_force(const ForceLaw& law, const ForceClock& clock, std::span<const std::uint32_t> members,
               const Surroundings& surroundings, ForceStage& stage, ForceScratch& scratch);

}  // namespace physim
