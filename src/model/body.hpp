// Body: the numbers of one projectile (or one lane of them) that the models read during a flight.
//
// Symbols as in the model files. Source: none of its own; each field names the model that reads it.
#pragma once

#include <cstddef>

#include "math/pack.hpp"
#include "physim/vec3.hpp"

namespace physim {

inline constexpr int kMaxBands = 8;

/// Position and velocity in W.
template <class R>
struct State {
  Vec3<R> x;  // [m]
  Vec3<R> v;  // [m/s]
};

/// A piece of a motor's table: see model/motor.hpp.
template <class R>
struct Burn {
  R start;        // since launch [s]
  R end;          // [s]
  R thrust;       // at the start [N]
  R thrust_rate;  // [N/s]
  R burned;       // propellant, at the start [kg]
  R burn_rate;    // [kg/s]
  R burn_growth;  // half of its rate [kg/s^2]
  R drag_factor;  // times the drag [-]

  bool operator==(const Burn&) const = default;
};
/// Nothing burns.
template <class R>
Burn<R> no_burn(R start, R end, R burned) {
  return {start, end, R(0), R(0), burned, R(0), R(0), R(1)};
}

/// Every member is an R, so that a lane can be copied in and out field by field.
template <class R>
struct Body {
  State<R> launch;          // state at time 0; closed forms start from it
  Vec3<R> plane;            // unit normal of the plane of fire, horizontal [-]
  Vec3<R> sight;            // unit vector along the line of sight [-]
  R damping_rate;           // k = -ln(d) [1/s]
  R k1_per_mass;            // [1/s]
  R k2_per_mass;            // [1/m]
  R half_area_per_mass;     // i A / (2 m) = pi / (8 BC) [m^2/kg]
  R curve_row;              // first row of the Cd curve in Conditions::curve_rows; below 0: searched curve -1 - row
  R curve_start;            // Mach number of the curve's first point [-]
  R curve_cells;            // cells per Mach number [-]
  R curve_last;             // index of the last cell [-]
  R reynolds_length;        // diameter of a smooth sphere [m]; 0 for curves by Mach number
  Vec3<R> applied;          // applied force over mass [m/s^2]
  R applied_until;          // [s]
  R gravity_scale;          // times gravity [-]; read where some projectile's is not 1
  Vec3<R> free;             // 1 along axes of W that it moves along, 0 along frozen ones [-]
  Burn<R> burn;             // the piece of the motor's table that the time is in
  R burn_piece;             // its index in Conditions::motor_pieces
  R mass;                   // at launch [kg]
  R ignition;               // since launch; where there is no motor, never [s]
  R burnout;                // since launch; where there is no motor, never [s]
  Vec3<R> rail;             // unit vector along the launch rail, or the bore [-]
  R rail_end;               // of x along it [m]
  R rail_phase;             // kHeld, kSliding or kOffRail
  Vec3<R> spin;             // at launch, in W [rad/s]
  R spin_decay;             // 1 / tau [1/s]
  R ball_radius;            // [m]
  R magnus_area;            // A / (2 m) [m^2/kg]
  R lift;                   // l [-]
  R lift_base;              // b [-]
  R lift_saturation;        // c [-]
  R drag_per_spin;          // k [s]
  R magnus_table;           // index in Conditions::magnus_grids; below 0: by the formula
  R band_above[kMaxBands];  // air speed from which band i holds [m/s]; unused bands are infinite
  R band_half_area_per_mass[kMaxBands];  // [m^2/kg]
};

template <class R>
inline constexpr int kBodyFields = sizeof(Body<R>) / sizeof(R);
/// Members that a launch gives come first. Some cohorts get more from it (put_launch() in prepare/launch.hpp): a rail,
/// spin, and the k2 that stands in for the drag equation.
inline constexpr int kLaunchFields = 12;
static_assert(offsetof(Body<double>, damping_rate) == kLaunchFields * sizeof(double));
/// Members that few cohorts read come last: motor and rail, spin, then bands.
inline constexpr int kMotorFields = 17;
inline constexpr int kMagnusFields = 11;
static_assert(offsetof(Body<double>, spin) - offsetof(Body<double>, burn) == kMotorFields * sizeof(double));
static_assert(offsetof(Body<double>, band_above) - offsetof(Body<double>, spin) == kMagnusFields * sizeof(double));

}  // namespace physim

PHYSIM_ISA_BEGIN

/// Copies lane `lane` of any structure of R's from an equal structure of scalars, or to it.
template <template <class> class Struct, class R>
PHYSIM_INLINE void put_lane(Struct<R>& into, int lane, const Struct<ScalarOf<R>>& from) {
  using S = ScalarOf<R>;
  auto* to = reinterpret_cast<char*>(&into) + sizeof(S) * static_cast<unsigned>(lane);
  const auto* source = reinterpret_cast<const char*>(&from);
  for (unsigned i = 0; i < sizeof(Struct<R>) / sizeof(R); ++i)
    std::memcpy(to + i * sizeof(R), source + i * sizeof(S), sizeof(S));
}
template <template <class> class Struct, class R>
PHYSIM_INLINE void get_lane(const Struct<R>& from, int lane, Struct<ScalarOf<R>>& into) {
  using S = ScalarOf<R>;
  const auto* source = reinterpret_cast<const char*>(&from) + sizeof(S) * static_cast<unsigned>(lane);
  auto* to = reinterpret_cast<char*>(&into);
  for (unsigned i = 0; i < sizeof(Struct<R>) / sizeof(R); ++i)
    std::memcpy(to + i * sizeof(S), source + i * sizeof(R), sizeof(S));
}

PHYSIM_ISA_END
