// Attitude: what a Turn means as seen from outside, and the Turn that a launch begins with.
//
// Symbols and equations as in model/rigid_body.hpp. Source: geometry.
#pragma once

#include "math/quat.hpp"
#include "model/acceleration.hpp"
#include "physim/projectile.hpp"

namespace physim {

/// A rotation in terms that all forms share.
struct Attitude {
  Quatd q_WB;   // [-]
  Vec3d omega;  // angular velocity in I, along body axes [rad/s]
};

/// A shell in its yaw of repose turns about its axis only: the slow turn of the axis with the path is left out.
[[nodiscard]] Attitude attitude_of(const Conditions<double>& conditions, const Body<double>& body,
                                   const Rotor<double>& rotor, double time, const State<double>& state,
                                   const Turn<double>& turn);
/// The spin about the x axis [rad/s].
[[nodiscard]] double spin_of(const Fidelity& granted, const Rotor<double>& rotor, const Turn<double>& turn);
[[nodiscard]] Turn<double> turn_of(const Fidelity& granted, const Rotor<double>& rotor, const Attitude& attitude);

/// How a launch at a velocity points and turns. `bore`: its unit direction in W, which counts where it stands still.
[[nodiscard]] Attitude launch_attitude(const ProjectileDef& projectile, const Launch& launch, const Vec3d& velocity,
                                       const Vec3d& bore, const Conditions<double>& conditions);

/// Between two vectors, 0 where one has no direction [rad].
[[nodiscard]] double angle_between(const Vec3d& a, const Vec3d& b);

/// Whether moments of inertia are given.
[[nodiscard]] bool has_inertia(const ProjectileDef& projectile);
/// Whether it is symmetric about its x axis.
[[nodiscard]] bool is_axisymmetric(const ProjectileDef& projectile);
/// Whether the tensor is one that a body can have.
[[nodiscard]] bool is_possible(const Inertia& inertia);

/// The rotor of a projectile; its launch is left to turn_of().
[[nodiscard]] Rotor<double> prepare_rotor(const ProjectileDef& projectile);

}  // namespace physim
