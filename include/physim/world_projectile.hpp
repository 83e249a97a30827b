// Projectile: a projectile of a world, by its id. What it does, and how to change it.
#pragma once

#include <cstdint>
#include <string>

#include "physim/forces.hpp"
#include "physim/quat.hpp"
#include "physim/result.hpp"
#include "physim/world_def.hpp"

namespace physim {

/// Where a projectile is and how it moves.
struct BodyState {
  Vec3d position{};  ///< [m]
  Vec3d velocity{};  ///< [m/s]

  bool operator==(const BodyState&) const = default;
};

struct WorldImpl;

/// A projectile of a world, to be read: `world[id]`. It is an id and a place to look it up, as cheap to make as to
/// copy, and holds as long as its world. Of a projectile that is gone all is zero.
class ProjectileView {
 public:
  ProjectileView(const WorldImpl* world, ProjectileId id) : world_(world), id_(id) {}

  [[nodiscard]] ProjectileId id() const { return id_; }
  [[nodiscard]] bool is_alive() const;
  /// Also of one that is gone, until its slot is used again.
  [[nodiscard]] LifeStatus status() const;
  [[nodiscard]] bool is_asleep() const;
  [[nodiscard]] bool is_kinematic() const;

  [[nodiscard]] Vec3d position() const { return position_of(world_, id_); }  ///< [m]
  [[nodiscard]] Vec3d velocity() const { return velocity_of(world_, id_); }  ///< [m/s]
  [[nodiscard]] BodyState state() const { return state_of(world_, id_); }
  [[nodiscard]] Vec3d previous_position() const;  ///< before the last step [m]
  /// To draw, by its Smoothing: between steps by the leftover fraction of World::advance() [m].
  [[nodiscard]] Vec3d render_position() const;
  [[nodiscard]] Quatd orientation() const;       ///< takes body axes into W [-]
  [[nodiscard]] Vec3d angular_velocity() const;  ///< [rad/s]
  [[nodiscard]] double age() const;              ///< since launch [s]
  [[nodiscard]] double mach() const;             ///< [-]
  [[nodiscard]] double mass() const;             ///< infinite where nothing moves it [kg]
  [[nodiscard]] double inverse_mass() const;     ///< [1/kg]
  /// Mass times acceleration now: of all models and generators, as accelerations() [N].
  [[nodiscard]] Vec3d resultant_force() const;
  /// Acceleration by effect now; `applied` holds the generators too (inside a step of its world, without custom
  /// forces).
  [[nodiscard]] Accelerations accelerations() const;
  /// How fast the acceleration changes along the path now, as Flight::jerk(); generators count by place and velocity
  /// [m/s^3].
  [[nodiscard]] Vec3d jerk() const;

  [[nodiscard]] KindId kind() const;
  [[nodiscard]] const ProjectileDef* definition() const;  ///< null where it is gone
  /// What it really uses, and why.
  [[nodiscard]] FidelityInUse fidelity_in_use() const;
  /// How the world treats it now: as its kind, but for what was changed since.
  [[nodiscard]] BodyDef body() const;
  [[nodiscard]] std::uint64_t user_data() const;
  [[nodiscard]] std::uint32_t layers() const;
  [[nodiscard]] std::uint32_t colour() const;
  [[nodiscard]] std::string label() const;

 private:
  // What is read most, so that the view itself need not be in memory.
  static Vec3d position_of(const WorldImpl* world, ProjectileId id);
  static Vec3d velocity_of(const WorldImpl* world, ProjectileId id);
  static BodyState state_of(const WorldImpl* world, ProjectileId id);

 protected:
  const WorldImpl* world_;
  ProjectileId id_;
};

/// A projectile of a world, to be changed too. What cannot be done is refused, with a reason: the projectile is gone,
/// or the value makes no sense. A change of how it moves wakes it.
class Projectile : public ProjectileView {
 public:
  Projectile(WorldImpl* world, ProjectileId id) : ProjectileView(world, id) {}

  Status despawn();
  /// A jump: it meets nothing on the way, and render_position() goes on behind it as it went before [m].
  Status set_position(const Vec3d& position);
  Status set_velocity(const Vec3d& velocity);
  Status set_state(const BodyState& state);
  Status apply_impulse(const Vec3d& impulse);  ///< [N s]
  Status set_angular_velocity(const Vec3d& omega);
  /// Moves it to another rung, as it is.
  Status set_fidelity(const Fidelity& fidelity);
  /// Changes all that ProjectileDef marks (live) at once: it becomes a projectile of another kind, and generators of
  /// its former kind act on it no more. Place, velocity, spin and attitude stay, its momentum does not. A k2 that
  /// stands in for the drag equation is found anew, where it is. Refused where `projectile` differs from definition()
  /// in anything else or makes no sense, and for what has a motor, whose tables say how its mass and its drag change.
  Status set_projectile(const ProjectileDef& projectile);
  Status set_mass(double mass);          ///< [kg]; drag by a ballistic coefficient stays: it contains a mass of its own
  Status set_drag(const DragDef& drag);  ///< all of it: table, coefficients, damping, k1 and k2
  Status set_damping(double damping);    ///< DragDef::damping alone, above 0 and not above 1 [-]
  /// Changes all that BodyDef marks (live) at once; refused where `body` differs from body() in anything else.
  Status set_body(const BodyDef& body);
  Status set_gravity_scale(double scale);
  Status set_use_gravity(bool use);
  Status set_kinematic(bool kinematic);
  Status set_frozen(Axes position_axes, Axes rotation_axes);
  Status set_can_sleep(bool can);
  Status sleep();  ///< an error where it stands still already
  Status wake();   ///< an error where it neither sleeps nor sticks
  Status set_smoothing(Smoothing smoothing);
  Status set_user_data(std::uint64_t data);
  Status set_layers(std::uint32_t layers);
  Status set_colour(std::uint32_t rgba);
  Status set_label(const std::string& label);
  /// A generator that acts on this one alone, until it is removed; or for a duration [s].
  Result<ForceId> add_force(ForceLaw law);
  Result<ForceId> add_force(ForceLaw law, double duration);
  /// Takes it out of a generator's targets.
  Status remove_force(ForceId force);

 private:
  [[nodiscard]] WorldImpl& world() const { return const_cast<WorldImpl&>(*world_); }
};

}  // namespace physim
