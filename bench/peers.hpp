// The solvers that PhySim is measured against, behind plain functions: most are compiled with every instruction of this
// machine and fused multiply-add allowed, so nothing of the library may be instantiated in their files.
#pragma once

#include <cstdint>
#include <span>

namespace physim::bench {

inline constexpr int kPeerLayers = 8;

inline constexpr int kPeerDensityTerms = 14;
inline constexpr int kPeerSoundTerms = 16;

/// Gravity, standard atmosphere and drag curve: the very numbers that PhySim computes with.
struct PeerModel {
  double gravity;              // [m/s^2]
  double altitude;             // of the origin [m]
  double geopotential_radius;  // [m]
  // The lowest layer as polynomials of u = (Z - middle) scale, up to the geometric altitude `top`.
  double middle;                            // [m]
  double scale;                             // [1/m]
  double top;                               // [m]
  double density[kPeerDensityTerms];        // [kg/m^3]
  double per_sound_speed[kPeerSoundTerms];  // [s/m]
  // Other layers by their law.
  int layers;
  double base[kPeerLayers];                  // [m]
  double lapse[kPeerLayers];                 // [1/m]
  double power[kPeerLayers];                 // [-]
  double decay[kPeerLayers];                 // [1/m]
  double base_density[kPeerLayers];          // [kg/m^3]
  double base_per_sound_speed[kPeerLayers];  // [s/m]
  const double* rows;                        // four coefficients a cell, from Mach 0 on
  double cells_per_mach;                     // [-]
  int last_cell;
  double half_area_per_mass;  // [m^2/kg]
};

struct PeerShot {
  double speed;      // [m/s]
  double elevation;  // [rad]
};

struct PeerEnd {
  double time;         // [s]
  double position[3];  // [m]
  double apex = 0;     // time of the highest point, where it is looked for [s]
};

struct PeerTask {
  const PeerModel* model;
  double range;      // where flights end [m]
  double tolerance;  // relative and absolute
  std::span<const PeerShot> shots;
  PeerEnd* ends;
  std::int64_t steps;        // taken by all flights together
  std::int64_t evaluations;  // of the right-hand side
};

/// Boost.odeint: runge_kutta_dopri5, controlled, with dense output.
void fly_odeint_dopri5(PeerTask& task);
void fly_odeint_dopri5_portable(PeerTask& task);  ///< compiled as PhySim's portable files are
void fly_odeint_dopri5_apex(PeerTask& task);      ///< finds the highest point too
void fly_odeint_dopri5_laws(PeerTask& task);      ///< with the air's laws: exp() and log() in every evaluation
/// SUNDIALS CVODE with root finding: Adams with fixed-point iteration, BDF with Newton's method and a dense Jacobian.
void fly_cvode_adams(PeerTask& task);
void fly_cvode_bdf(PeerTask& task);
/// SUNDIALS ARKODE ERKStep: Dormand-Prince 5(4) with root finding.
void fly_arkode_dopri5(PeerTask& task);

}  // namespace physim::bench
