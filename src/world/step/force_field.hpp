// The force field: what all generators of a world do together to some of its projectiles, stage by stage.
#pragma once

#include <optional>
#include <unordered_map>

#include "world/core/state.hpp"
#include "world/step/force_eval.hpp"
#include "world/step/kind_drag.hpp"

namespace physim {

/// What is left of its mass, where a motor burns it [kg].
[[nodiscard]] double mass_of(const Registry& registry, const WorldState& state, const Slot& slot);
/// Times gravity: its projectile's own and its live one [-].
[[nodiscard]] double gravity_scale_of(const Registry& registry, const WorldState& state, std::uint32_t slot);
/// The layer bits of a projectile, its own or those of its kind.
[[nodiscard]] std::uint32_t layers_of(const Registry& registry, const WorldState& state, std::uint32_t slot);
/// Whether a generator's kind or layers hold a projectile.
[[nodiscard]] bool is_in_group(const Generator& generator, const Registry& registry, const WorldState& state,
                               std::uint32_t slot);
[[nodiscard]] inline bool has_group(const ForceTarget& target) { return target.kind || target.layers != 0; }
/// The other end of springs between two; null for other laws.
[[nodiscard]] ProjectileId other_end(const ForceLaw& law);

/// Times closer than this part of a step are the same: a duration of whole steps must not gain or miss one by rounding.
inline constexpr double kSameTime = 1e-6;

/// A law and the rows that it acts on.
struct Push {
  std::uint32_t generator;
  std::uint32_t first;  // of its members
  std::uint32_t last;
  ProjectileId from;  // a spring with a target outside of the rows pulls at its other end: that target
};

/// Rows that generators act on, side by side.
struct ForceRows {
  std::vector<std::uint32_t> first_of_cohort;  // the row of its first projectile, or kNotInStage; empty: one row alone
  std::vector<ProjectileId> id;
  std::vector<double> mass;
  std::vector<double> age;  // [s]
  std::vector<const ProjectileDef*> def;
  std::vector<Vec3d> position;
  std::vector<Vec3d> velocity;
  std::vector<Vec3d> force;       // [N]
  std::vector<double> drag_rate;  // of the drag in it, times the mass [kg/s]
  std::vector<std::uint8_t> in_zone;
  std::vector<std::uint32_t> members;
  std::vector<std::uint32_t> sound_members;
  std::vector<Push> pushes;
  ForceScratch scratch;
  bool sound = true;  // all positions and velocities are numbers

  void clear();
  void add(const Registry& registry, const WorldState& state, std::uint32_t slot);
};

/// The drag of kinds inside zones of wind, prepared when it is first asked for.
struct ZoneDrag {
  std::optional<KindDrag> drag;
  std::unordered_map<std::uint32_t, std::uint32_t> index;  // in `drag`, by the number of the kind
};

class ForceField final : public Surroundings {
 public:
  ForceField(const Registry& registry, const WorldState& state, ForceRows& rows, ZoneDrag& zones)
      : registry_(registry), state_(state), rows_(rows), zones_(zones) {}

  /// Custom forces are left out: one of them asks.
  void leave_functions_out() { without_functions_ = true; }
  /// Springs between two are left out: where the other one will be is not known.
  void leave_pairs_out() { without_pairs_ = true; }
  /// Finds out which generators act on which rows during a step from a time of the world on.
  void begin_step(double time, double dt);
  /// Whether one does.
  [[nodiscard]] bool is_felt() const { return !rows_.pushes.empty(); }
  /// Fills rows.force and rows.drag_rate, from positions and velocities at a place 0..1 of the step.
  void evaluate(double place);
  /// ... as they are at the start of the step, also where they end within it.
  void evaluate_now();

  [[nodiscard]] Partner partner(ProjectileId id) const override;
  [[nodiscard]] Vec3d drag_equation(std::uint32_t row, double density, const Vec3d& u) const override;
  [[nodiscard]] OwnDrag own_drag(std::uint32_t row) const override;

 private:
  void begin_stage(double place);
  void add(const Push& push, double place);
  void add_part(const Push& push, double place, double part);
  void list(std::uint32_t generator);
  void list_backwards(std::uint32_t generator, ProjectileId other);
  [[nodiscard]] std::uint32_t row_of(ProjectileId id) const;
  [[nodiscard]] bool is_sound(std::uint32_t row) const;
  [[nodiscard]] std::span<const std::uint32_t> members_of(const Push& push);

  const Registry& registry_;
  const WorldState& state_;
  ForceRows& rows_;
  ZoneDrag& zones_;
  double time_ = 0;  // at the start of the step [s]
  double dt_ = 0;
  double place_ = 0;
  bool without_functions_ = false;
  bool without_pairs_ = false;
  bool has_zones_ = false;
  bool has_ages_ = false;
};

}  // namespace physim
