// Body: the numbers of one projectile (or one lane of them) that the models read during a flight.
//
// A body is made of parts. What a cohort reads is a set of parts: lanes, rows and batches keep and copy no others.
//
// Symbols as in the model files. Source: none; each field names the model that reads it.
#pragma once

#include <array>
#include <bit>

#include "math/numbers.hpp"
#include "math/vec3.hpp"
#include "model/conditions.hpp"

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
  PHYSIM_ASSERT(start <= end && burned >= 0);
  return {start, end, R(0), R(0), burned, R(0), R(0), R(1)};
}

// ------------------------------------------------------------------------------------------- the parts of a body
template <class R>
struct LaunchPart {
  State<R> launch;  // state at time 0; closed forms start from it
};
template <class R>
struct PlanePart {
  Vec3<R> plane;  // unit normal of the plane of fire, horizontal [-]
};
template <class R>
struct SightPart {
  Vec3<R> sight;  // unit vector along the line of sight [-]
};
template <class R>
struct DampingPart {
  R damping_rate;  // k = -ln(d) [1/s]
};
template <class R>
struct QuadraticPart {
  R k1_per_mass;  // [1/s]
  R k2_per_mass;  // [1/m]
};
template <class R>
struct AreaPart {
  R half_area_per_mass;  // i A / (2 m) = pi / (8 BC) [m^2/kg]
};
/// Where a drag curve lies in the pool of tables.
template <class R>
struct CurvePart {
  R curve_row;    // first row of the Cd curve in Conditions::curve_rows; below 0: searched curve -1 - row
  R curve_first;  // Mach number of the curve's first point, in cells [-]
  R curve_cells;  // cells per Mach number [-]
  R curve_last;   // index of the last cell [-]

  bool operator==(const CurvePart&) const = default;
};
template <class R>
struct SpherePart {
  R reynolds_length;  // diameter of a smooth sphere [m]; 0 for curves by Mach number
};
template <class R>
struct BandPart {
  R band_above[kMaxBands];               // air speed from which band i holds [m/s]; unused bands are infinite
  R band_half_area_per_mass[kMaxBands];  // [m^2/kg]
};
template <class R>
struct AppliedPart {
  Vec3<R> applied;  // applied force over mass [m/s^2]
  R applied_until;  // [s]
};
/// Balls that spin: see model/magnus.hpp.
template <class R>
struct SpinPart {
  Vec3<R> spin;       // at launch, in W [rad/s]
  R spin_decay;       // 1 / tau [1/s]
  R ball_radius;      // [m]
  R magnus_area;      // A / (2 m) [m^2/kg]
  R lift;             // l [-]
  R lift_base;        // b [-]
  R lift_saturation;  // c [-]
  R drag_per_spin;    // k [s]
  R magnus_table;     // index in Conditions::magnus_grids; below 0: by the formula
};
template <class R>
struct MotorPart {
  Burn<R> burn;  // the piece of the motor's table that the time is in
  R burn_piece;  // its index in Conditions::motor_pieces
  R mass;        // at launch [kg]
  R ignition;    // since launch; where there is no motor, never [s]
  R burnout;     // since launch; where there is no motor, never [s]
};
template <class R>
struct RailPart {
  Vec3<R> rail;  // unit vector along the launch rail, or the bore [-]
  R rail_end;    // of x along it [m]
  R rail_phase;  // kHeld, kSliding or kOffRail
};
/// Functions of one's own are asked for another clock than that of the launch.
template <class R>
struct BirthPart {
  R birth;  // time of the launch: in worlds by their clock, in flights 0 [s]
};
template <class R>
struct GravityPart {
  R gravity_scale;  // times gravity [-]; read where some projectile's is not 1
};
template <class R>
struct FreePart {
  Vec3<R> free;  // 1 along axes of W that it moves along, 0 along frozen ones [-]
};

/// The air and the wind of a shot that has its own weather.
template <class R>
struct WindPart {
  Vec3<R> wind;  // velocity of the air [m/s]
};
template <class R>
struct AirPart {
  AirNumbers<R> air;
};

/// Structures of R's, one behind the other.
template <template <class> class... Part>
struct PartList {
  template <class R>
  struct Joined : Part<R>... {};

  static constexpr unsigned kParts = sizeof...(Part);
  /// Number of a part in the list.
  template <template <class> class Wanted>
  static constexpr unsigned index() {
    unsigned i = 0;
    bool found = false;
    ((found = found || std::is_same_v<Part<double>, Wanted<double>>, i += found ? 0u : 1u), ...);
    return i;
  }
  /// How many numbers stand before a part.
  static constexpr unsigned first(unsigned part) {
    unsigned sum = 0, i = 0;
    ((sum += i++ < part ? kNumbers<Part> : 0u), ...);
    return sum;
  }
};

/// In the order in which they lie in memory. What a launch alone gives comes first: batches copy it for every shot.
/// Weather comes last: few have their own.
using BodyParts =
    PartList<LaunchPart, PlanePart, SightPart, DampingPart, QuadraticPart, AreaPart, CurvePart, SpherePart, BandPart,
             AppliedPart, SpinPart, MotorPart, RailPart, GravityPart, FreePart, BirthPart, WindPart, AirPart>;

template <class R>
struct Body : BodyParts::Joined<R> {};
static_assert(sizeof(Body<float>) == BodyParts::first(BodyParts::kParts) * sizeof(float), "parts have no gaps");

namespace detail {
constexpr Body<unsigned> numbered_body() {
  std::array<unsigned, kNumbers<Body>> numbers{};
  for (unsigned i = 0; i < kNumbers<Body>; ++i) numbers[i] = i;
  return std::bit_cast<Body<unsigned>>(numbers);
}
}  // namespace detail
/// Each number of a body by the name of its member: its place among all of them.
inline constexpr Body<unsigned> kBodyNumber = detail::numbered_body();

/// Some of a body's parts.
class PartSet {
 public:
  template <template <class> class... Part>
  static constexpr PartSet of() {
    PartSet set;
    (set.add<Part>(), ...);
    return set;
  }
  static constexpr PartSet all() {
    PartSet set;
    set.bits_ = (1u << BodyParts::kParts) - 1;
    return set;
  }
  template <template <class> class Part>
  constexpr void add(bool in = true) {
    constexpr unsigned kPart = BodyParts::index<Part>();
    static_assert(kPart < BodyParts::kParts, "no part of a body");
    if (in) bits_ |= 1u << kPart;
  }
  constexpr PartSet operator|(PartSet other) const { return other.bits_ |= bits_, other; }
  constexpr PartSet operator&(PartSet other) const { return other.bits_ &= bits_, other; }
  constexpr PartSet operator-(PartSet other) const { return other.bits_ = bits_ & ~other.bits_, other; }
  bool operator==(const PartSet&) const = default;

  /// Their numbers.
  [[nodiscard]] constexpr NumberRuns runs() const {
    NumberRuns runs{};
    for (unsigned left = bits_; left != 0; left &= left - 1) {
      const auto part = static_cast<unsigned>(std::countr_zero(left));
      runs.add(BodyParts::first(part), BodyParts::first(part + 1) - BodyParts::first(part));
    }
    return runs;
  }

 private:
  unsigned bits_ = 0;
};

/// Which parts of their bodies the models of a cohort read: the one place that says so.
constexpr PartSet parts_read(const Fidelity& f, const Features& some) {
  const bool closed = f.motion == Motion::closed_form;
  const bool equation = !closed && f.drag == DragModel::equation;
  PartSet set;
  set.add<LaunchPart>(closed || f.original_one_shot_forces);
  set.add<DampingPart>(f.drag == DragModel::damping || (closed && f.drag != DragModel::off));
  set.add<QuadraticPart>(!closed && f.drag == DragModel::linear_quadratic);
  set.add<AreaPart>(equation);
  set.add<CurvePart>(equation);
  set.add<SpherePart>(equation && some.has_spheres);
  set.add<BandPart>(equation && some.has_bands);
  set.add<AppliedPart>(some.has_applied);
  set.add<SpinPart>(f.rotation == RotationModel::magnus);
  set.add<MotorPart>(some.has_motor || some.has_rail || some.has_force_function);
  set.add<RailPart>(some.has_motor || some.has_rail);
  set.add<BirthPart>(some.has_wind_function || some.has_force_function);
  set.add<PlanePart>(f.planar);
  set.add<GravityPart>(some.has_gravity_scale);
  set.add<FreePart>(some.has_frozen);
  set.add<WindPart>(some.has_own_wind);
  set.add<AirPart>(some.has_own_air);
  return set;
}

/// What a launch gives. Some cohorts get more from it (put_launch() in prepare/launch.hpp): a rail, spin, and the k2
/// that stands in for the drag equation.
inline constexpr PartSet kLaunchParts = PartSet::of<LaunchPart, PlanePart, SightPart>();

/// What a shot's weather gives.
inline constexpr PartSet kWeatherParts = PartSet::of<WindPart, AirPart>();

/// What lanes of flights hold: launch and sight are asked for by events and by the first step, and where a nose without
/// air about it points by answers about attitudes.
constexpr PartSet parts_flown(const Fidelity& f, const Features& some) {
  PartSet set = parts_read(f, some) | kLaunchParts;
  set.add<RailPart>(f.rotation == RotationModel::modified_point_mass);
  return set;
}

}  // namespace physim
