// The ladder of fidelity as a table: a row for every rung of every effect. Everything that is to be known of a rung
// beside its formulas stands here: names, texts, order, properties, costs. Lists, checks, granting, costs and the
// candidates of auto fidelity follow from it; of integrators, order and stages follow from their tableaus.
//
// Rows are switches without a default: an enumerator without a row does not compile.
//
// Costs are operations of one evaluation, counted in src/model and src/solve: additions, products, comparisons and
// selections as 1, quotients and square roots as 4, loads of a table's row as 8. Only ratios matter; those of the
// benchmarks agree within 40 %.
//
// Source: none; the files of the models name theirs.
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <type_traits>
#include <vector>

#include "base/enumerators.hpp"
#include "physim/fidelity.hpp"

namespace physim {

namespace cost {
inline constexpr double kReciprocal = 4;
inline constexpr double kExp = 20;
inline constexpr double kPow = 60;
inline constexpr double kSpeed = 9;  // the length of a velocity
}  // namespace cost

PHYSIM_INLINE constexpr RungInfo row(Motion rung) {
  switch (rung) {
    case Motion::closed_form: return {"closed_form", "exact formulas: vacuum, or drag linear in velocity", 0};
    case Motion::velocity: return {"velocity", "constants act directly on the velocity; no forces", 1};
    case Motion::force: return {"force", "the resultant of all forces, divided by mass", 2};
  }
  return {};
}

struct IntegratorRow : RungInfo {
  bool is_candidate;  // of auto fidelity; the others have a better one that costs no more
};
PHYSIM_INLINE constexpr IntegratorRow row(Integrator rung) {
  switch (rung) {
    case Integrator::classic:
      return {{"classic", "the original PhySim frame loop: position, velocity, damping", 0}, false};
    case Integrator::explicit_euler: return {{"explicit_euler", "order 1, fixed step", 1}, false};
    case Integrator::semi_implicit_euler:
      return {{"semi_implicit_euler", "order 1, symplectic, fixed step; what most game engines do", 2}, true};
    case Integrator::heun: return {{"heun", "order 2, fixed step", 3}, true};
    case Integrator::rk4: return {{"rk4", "order 4, fixed step", 4}, true};
    case Integrator::rk43: return {{"rk43", "order 4, adaptive (Sofroniou and Spaletta 2004)", 5}, true};
    case Integrator::tsit5: return {{"tsit5", "order 5, adaptive (Tsitouras 2011)", 6}, true};
    case Integrator::dop853: return {{"dop853", "order 8, adaptive (Dormand and Prince)", 7}, true};
    case Integrator::automatic:
      return {{"automatic", "adaptive in flights that choose their steps, semi_implicit_euler in given frames", -1},
              false};
    case Integrator::adaptive: return {{"adaptive", "rk43 for points, tsit5 for bodies that turn", -2}, false};
  }
  return {};
}

/// What a model of gravity knows about the Earth.
enum class GravityField {
  none,
  uniform,    // weight, the same everywhere
  central,    // a point mass
  flattened,  // of the ellipsoid: goes with the Earth's own mass and shape
};
struct GravityRow : RungInfo {
  GravityField field;
  double flat_cost, sphere_cost, ellipsoid_cost;  // ellipsoid_cost without the vertical
};
PHYSIM_INLINE constexpr GravityRow row(GravityModel rung) {
  using enum GravityField;
  switch (rung) {
    case GravityModel::off: return {{"off", "none", 0}, none, 1, 1, 1};
    case GravityModel::constant: return {{"constant", "the same everywhere", 1}, uniform, 1, 30, 3};
    case GravityModel::inverse_square:
      return {{"inverse_square", "Newton's law: falls with the square of the distance", 2}, central, 9, 30, 25};
    case GravityModel::j2: return {{"j2", "a point mass and the Earth's flattening, J2", 3}, flattened, 9, 30, 50};
    case GravityModel::wgs84:
      return {{"wgs84", "normal gravity of the ellipsoid WGS-84, exact at every height", 4}, flattened, 9, 30, 120};
  }
  return {};
}

struct DragRow : RungInfo {
  bool is_force;   // divided by mass; else it acts on the velocity itself
  bool reads_air;  // density and sound speed
  double cost;     // with the curve, without wind and air
};
PHYSIM_INLINE constexpr DragRow row(DragModel rung) {
  using namespace cost;
  switch (rung) {
    case DragModel::off: return {{"off", "none", 0}, false, false, 0};
    case DragModel::damping: return {{"damping", "velocity *= damping^dt", 1}, false, false, 6};
    case DragModel::linear_quadratic: return {{"linear_quadratic", "F = -(k1 + k2 |v|) v", 2}, true, false, kSpeed + 8};
    case DragModel::equation:
      return {{"equation", "F = -1/2 rho |v| v Cd A; Cd constant, by Reynolds or by Mach number", 3},
              true,
              true,
              kSpeed + 10 + 24};
  }
  return {};
}

struct AirRow : RungInfo {
  bool by_height;
  double cost32, cost64;  // isa: terms of polynomials
};
PHYSIM_INLINE constexpr AirRow row(AirModel rung) {
  using namespace cost;
  switch (rung) {
    case AirModel::vacuum: return {{"vacuum", "none", 0}, false, 0, 0};
    case AirModel::constant: return {{"constant", "the air at the origin, everywhere", 1}, false, 0, 0};
    case AirModel::exponential:
      return {{"exponential", "density falls by e per scale height", 2}, true, 4 + kExp, 4 + kExp};
    case AirModel::isa:
      return {{"isa", "US Standard Atmosphere 1976, shifted to the station's weather; or the levels of a sounding", 3},
              true,
              40,
              50};
  }
  return {};
}

struct WindRow : RungInfo {
  double cost, point_cost;  // point_cost for each point of a profile
};
PHYSIM_INLINE constexpr WindRow row(WindModel rung) {
  switch (rung) {
    case WindModel::off: return {{"off", "none", 0}, 0, 0};
    case WindModel::constant: return {{"constant", "the same everywhere", 1}, 3, 0};
    case WindModel::profile: return {{"profile", "by height or by range", 2}, 3, 9};
  }
  return {};
}

enum class EarthShape { flat, sphere, ellipsoid };
struct EarthRow : RungInfo {
  EarthShape shape;
  bool turning;          // W turns with it
  double vertical_cost;  // of the height and the direction of the vertical
};
PHYSIM_INLINE constexpr EarthRow row(EarthModel rung) {
  using enum EarthShape;
  switch (rung) {
    case EarthModel::flat: return {{"flat", "flat, not rotating", 0}, flat, false, 0};
    case EarthModel::flat_coriolis:
      return {{"flat_coriolis", "flat, with the Coriolis acceleration", 1}, flat, true, 0};
    case EarthModel::sphere:
      return {{"sphere", "round, not rotating; gravity points to its centre", 2}, sphere, false, 25};
    case EarthModel::sphere_rotating:
      return {{"sphere_rotating", "round and rotating: the air turns with it", 3}, sphere, true, 25};
    case EarthModel::ellipsoid:
      return {{"ellipsoid", "WGS-84, rotating; heights are above the ellipsoid", 4}, ellipsoid, true, 170};
  }
  return {};
}

struct RotationRow : RungInfo {
  double cost, step_cost;  // step_cost once for each step, where the flight is shown
};
PHYSIM_INLINE constexpr RotationRow row(RotationModel rung) {
  using namespace cost;
  switch (rung) {
    case RotationModel::none: return {{"none", "spin has no effect", 0}, 0, 0};
    case RotationModel::spin_drift:
      return {{"spin_drift", "Litz's spin drift with Miller's stability factor", 1}, 0, kPow};
    case RotationModel::magnus:
      return {{"magnus", "lift and drag of balls that spin", 2}, kExp + 40 + 4 * kReciprocal, 0};
    case RotationModel::modified_point_mass:
      return {{"modified_point_mass", "spinning shells in their yaw of repose (STANAG 4355)", 3}, 140, 0};
    case RotationModel::rigid_body:
      return {{"rigid_body", "six degrees of freedom: the attitude is flown too", 4}, 110, 0};
    case RotationModel::automatic_point:
      return {{"automatic_point", "the truest that the projectile's data allow, but no rigid body", 5}, 0, 0};
    case RotationModel::automatic: return {{"automatic", "the truest that the projectile's data allow", 6}, 0, 0};
  }
  return {};
}

PHYSIM_INLINE constexpr RungInfo row(BodyForm rung) {
  switch (rung) {
    case BodyForm::automatic:
      return {"automatic", "axis for bodies symmetric about x with rifling, quaternion else", 0};
    case BodyForm::quaternion: return {"quaternion", "quaternion and body rates: any body", 1};
    case BodyForm::axis: return {"axis", "symmetry axis and angular momentum: steps need not resolve the spin", 2};
  }
  return {};
}

struct PrecisionRow : RungInfo {
  double cost_factor;  // a register holds half as many doubles
  double rounding;     // relative [-]
};
PHYSIM_INLINE constexpr PrecisionRow row(Precision rung) {
  switch (rung) {
    case Precision::float32: return {{"float32", "single precision", 0}, 1, 1.1920929e-7};
    case Precision::float64: return {{"float64", "double precision", 1}, 2, 2.220446049250313e-16};
  }
  return {};
}

PHYSIM_INLINE constexpr RungInfo row(Interpolation rung) {
  switch (rung) {
    case Interpolation::linear: return {"linear", "straight lines between the points of a drag curve", 0};
    case Interpolation::pchip: return {"pchip", "monotone cubic (Fritsch and Butland): smooth slope, no overshoot", 1};
    case Interpolation::cubic: return {"cubic", "natural cubic spline: smooth curvature", 2};
  }
  return {};
}

/// Calls f(place, member of Fidelity) for every effect that has rungs; the name of the effect is that of the member.
constexpr void for_each_effect(const auto& f) {
  f("fidelity.motion", &Fidelity::motion);
  f("fidelity.integrator", &Fidelity::integrator);
  f("fidelity.gravity", &Fidelity::gravity);
  f("fidelity.drag", &Fidelity::drag);
  f("fidelity.air", &Fidelity::air);
  f("fidelity.wind", &Fidelity::wind);
  f("fidelity.earth", &Fidelity::earth);
  f("fidelity.rotation", &Fidelity::rotation);
  f("fidelity.body_form", &Fidelity::body_form);
  f("fidelity.precision", &Fidelity::precision);
  f("fidelity.interpolation", &Fidelity::interpolation);
}

/// Number of rungs of an effect; each has a row.
template <class Enum>
inline constexpr std::size_t kRungCount = kEnumerators<Enum>;

/// What one column of the table says of each rung, a byte each.
template <auto kColumn, class Enum>
consteval std::uint64_t packed_column() {
  static_assert(kRungCount<Enum> <= 8);
  std::uint64_t packed = 0;
  for (std::size_t i = 0; i < kRungCount<Enum>; ++i)
    packed |= static_cast<std::uint64_t>(row(static_cast<Enum>(i)).*kColumn) << 8 * i;
  return packed;
}
/// What a column says of a rung, for models: row(rung).*kColumn, a small number. Rows are made with all their texts
/// where they are asked for, among which compilers lose sight of what else they know.
template <auto kColumn, class Enum>
PHYSIM_INLINE constexpr auto column(Enum rung) {
  constexpr std::uint64_t kPacked = packed_column<kColumn, Enum>();
  const std::uint64_t said = kPacked >> 8 * static_cast<unsigned>(rung) & 0xff;
  return static_cast<std::remove_cvref_t<decltype(row(rung).*kColumn)>>(said);
}

/// Its place from cheap to true, by which rungs are compared.
template <class Enum>
PHYSIM_INLINE constexpr int level(Enum rung) {
  return row(rung).level;
}
template <class Enum>
constexpr Enum lower_of(Enum a, Enum b) {
  return level(b) < level(a) ? b : a;
}
template <class Enum>
constexpr Enum higher_of(Enum a, Enum b) {
  return level(a) < level(b) ? b : a;
}

/// All rungs of an effect, cheap to true.
template <class Enum>
constexpr std::array<Enum, kRungCount<Enum>> all_rungs() {
  std::array<Enum, kRungCount<Enum>> all{};
  for (std::size_t i = 0; i < all.size(); ++i) all[i] = static_cast<Enum>(i);
  std::sort(all.begin(), all.end(), [](Enum a, Enum b) { return level(a) < level(b); });
  return all;
}

/// The rungs from `low` (or from `high`, where that is lower) up to and including `high`.
template <class Enum>
std::vector<Enum> rungs_between(Enum low, Enum high) {
  std::vector<Enum> list;
  for (const Enum rung : all_rungs<Enum>())
    if (level(rung) >= level(lower_of(low, high)) && level(rung) <= level(high)) list.push_back(rung);
  return list;
}

}  // namespace physim
