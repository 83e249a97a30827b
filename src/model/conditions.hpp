// Conditions: all numbers that the projectiles of one cohort share: environment data and granted rungs, ready to
// compute.
//
// Source: none; the model files say what the numbers mean.
#pragma once

#include "base/members.hpp"
#include "math/interpolation.hpp"
#include "physim/environment.hpp"
#include "physim/fidelity.hpp"

namespace physim {

inline constexpr int kAirLayers = 8;        // of the standard atmosphere
inline constexpr int kMostLevels = 100000;  // of a profile
/// Radius of the Earth that defines geopotential height in US Standard Atmosphere 1976 [m].
inline constexpr double kGeopotentialRadius = 6356766.0;

/// Terms of the polynomials that stand for density and 1 / sound speed in the lowest layer, in double.
inline constexpr int kDensityTerms = 14;
inline constexpr int kPerSoundTerms = 16;

/// A layer of the air by its laws, from its base.
template <class R>
struct AirLayer {
  R lapse;           // L_b / T_b [1/m]
  R power;           // density ~ (T/T_b)^power [-]
  R decay;           // density ~ exp(decay (H - H_b)) [1/m]
  R base_density;    // [kg/m^3]
  R base_per_sound;  // [s/m]
};

/// What the weather changes of the air: one for a cohort, or one for each lane.
template <class R>
struct AirNumbers {
  R density;           // constant and exponential air: at the origin [kg/m^3]
  R per_sound_speed;   // 1 / sound speed [s/m]
  R temperature;       // at the origin [K]
  R kelvin_per_sound;  // temperature over the square of the sound speed [K s^2/m^2]
  // The lowest layer, in powers of u = (Z - low_middle) low_scale:
  R low_density[kDensityTerms];     // [kg/m^3]
  R low_per_sound[kPerSoundTerms];  // [s/m]
  AirLayer<R> layer[kAirLayers];    // of the standard atmosphere
};

/// Air ready to compute; see model/air.hpp.
template <class S>
struct Air {
  AirNumbers<S> common;  // of all that have no air of their own
  S per_scale_height;    // exponential air [1/m]
  // The lowest layer in -1 <= u <= 1:
  S low_middle;        // [m]
  S low_scale;         // [1/m]
  S low_top;           // geometric altitude up to which it reaches; of a profile of levels: -infinity [m]
  int layers;          // of the standard atmosphere, or of the profile
  S base[kAirLayers];  // H_b, geopotential height at which layer i begins; of a profile those of the first two [m]
};

/// A vector that is not set to zero first, so that conditions can be made for a single pack.
template <class S>
struct Components {
  S x;
  S y;
  S z;

  Components& operator=(const Vec3<S>& v) { return x = v.x, y = v.y, z = v.z, *this; }
  operator Vec3<S>() const { return {x, y, z}; }  // NOLINT: it is one
};

/// Wind ready to compute; see model/wind.hpp.
template <class S>
struct WindField {
  int points;              // of its profile; 0: none, it blows the same everywhere or by a function
  bool by_range;           // by downrange distance; else by height
  bool stepped;            // else straight lines
  Components<S> velocity;  // without a profile, or at its first point [m/s]
};
/// A point of a wind profile, and the way to the next one.
template <class S>
struct WindPiece {
  S at;                    // [m]
  Components<S> velocity;  // [m/s]
  Components<S> slope;     // to the next point; 0 at the last one [1/s]
  S per_length;            // 1 / distance to the next point; 0 at the last one [1/m]
};

/// The round Earth ready to compute; see model/earth.hpp, model/geodesy.hpp and model/gravity.hpp.
template <class S>
struct Globe {
  S gm;            // of a point mass under the ellipsoid [m^3/s^2]
  Vec3<S> origin;  // of W from the Earth's centre, in W [m]
  Vec3<S> axis;    // unit vector towards the north pole, in W [-]
  // The ellipsoid at the origin:
  S to_axis;            // N + h0: along the vertical down to the axis [m]
  S axis_offset;        // kappa of the origin [m]
  Vec3<S> squeezed_up;  // l(u0) [-]
  S per_squeezed_up;    // 1 / |l(u0)| [-]
};

struct MotorPiece;
struct MagnusGrid;

/// What some projectiles of a cohort have beside the plain models; the others pay nothing for it.
struct Features {
  bool has_applied = false;          // an applied force
  bool has_force_end = false;        // ... that ends: a stop of their steps (solve/stops.hpp)
  bool has_motor = false;            // a motor
  bool has_rail = false;             // it starts on a rail
  bool has_magnus_tables = false;    // a table of lift by spin
  bool has_spheres = false;          // Cd by Reynolds number
  bool has_bands = false;            // banded ballistic coefficients
  bool has_searched_curves = false;  // a drag curve that fits no equal cells
  bool has_air_profile = false;      // air by levels
  bool has_wind_function = false;    // wind by a function
  bool has_force_function = false;   // a force by a function
  bool has_aero = false;             // aerodynamic coefficients beside drag
  bool has_aero_tables = false;      // ... that change with the Mach number
  bool has_aero_angles = false;      // ... or with the angle of attack
  bool has_own_air = false;          // its own weather: air
  bool has_own_wind = false;         // ... and wind
  bool has_gravity_scale = false;    // its own part of gravity
  bool has_frozen = false;           // it does not move along some axis

  PHYSIM_INLINE bool operator==(const Features&) const = default;
};

/// Where they fly, on what rungs.
template <class S>
struct EnvironmentNumbers {
  Fidelity fidelity;  // as granted
  S gravity;          // at sea level [m/s^2]
  S radius;           // of sea level from the Earth's centre [m]
  S altitude;         // of the origin above sea level [m]
  Vec3<S> omega;      // Earth's rotation in W [rad/s]
  Globe<S> globe;
  Air<S> air;
  WindField<S> wind;
};

/// Functions of the caller, see model/field_function.hpp. The code that prepared the conditions keeps them alive.
struct FunctionPointers {
  const WindFunction::Function* wind_function;
  const ForceFunction::Function* force_function;
};

/// Where on its drag curve a projectile that flies alone is thought to be before its Mach number is known. The
/// processor continues with the row that is guessed and looks back later, where it would wait for the number of the row
/// and then for the row. A guess that is wrong is put right: it changes no bit.
template <class S>
struct GuessedCell {
  S cell;        // from the start of the curve
  const S* row;  // its coefficients
  S place;       // where the last look-up was, in cells
};

/// What they look up.
template <class S>
struct TablePointers {
  const S* curve_rows;                    // pool of cubic rows of all drag curves in use
  const PiecewiseCubic* searched_curves;  // curves with points that fit no equal cells
  const MotorPiece* motor_pieces;         // pool of the tables of all motors in use
  const MagnusGrid* magnus_grids;         // tables of balls that spin
  GuessedCell<S>* guess = nullptr;        // null: nothing is guessed
};

/// The profiles of the environment; see prepare/profile_tables.hpp.
template <class S>
struct ProfilePointers {
  const WindPiece<S>* wind_pieces;  // as many as wind.points
  const AirLayer<S>* air_layers;    // as many as air.layers
  const S* air_bases;               // geopotential heights at which they begin [m]
};

template <class S>
struct Conditions : Features, EnvironmentNumbers<S>, FunctionPointers, TablePointers<S>, ProfilePointers<S> {};

/// Counted here, since they hold arrays.
template <class S>
inline constexpr std::size_t kMemberCount<AirNumbers<S>> = 7;
template <class S>
inline constexpr std::size_t kMemberCount<Air<S>> = 7;

}  // namespace physim
