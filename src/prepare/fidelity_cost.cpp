#include "prepare/fidelity_cost.hpp"

#include "prepare/grant.hpp"
#include "solve/take_step.hpp"

namespace physim {
namespace {

// Counted in src/model and src/solve: additions, products, comparisons and selections as 1, quotients and square roots
// as 4, loads of a table's row as 8. Only ratios matter; those of the benchmarks agree within 40 %.
constexpr double kAdvance = 12;  // y + h y'
constexpr double kReciprocal = 4, kExp = 20, kPow = 60;

/// Of the height and the direction of the vertical.
double vertical_cost(const Fidelity& f) {
  if (f.earth == EarthModel::ellipsoid) return 170;
  return is_round(f.earth) ? 25 : 0;
}

double gravity_cost(const Fidelity& f) {
  if (f.earth == EarthModel::ellipsoid && f.gravity != GravityModel::off) {
    if (f.gravity == GravityModel::constant) return vertical_cost(f) + 3;
    return f.gravity == GravityModel::inverse_square ? 25 : f.gravity == GravityModel::j2 ? 50 : 120;
  }
  if (is_round(f.earth)) return 30;
  return f.gravity >= GravityModel::inverse_square ? 5 + kReciprocal : 1;
}

double air_cost(const Fidelity& f) {
  const double height = vertical_cost(f);
  if (f.air == AirModel::isa) return height + (f.precision == Precision::float32 ? 40 : 50);  // terms of polynomials
  return f.air == AirModel::exponential ? height + 4 + kExp : 0;
}

double wind_cost(const Fidelity& f, const Environment& environment) {
  if (f.wind == WindModel::off) return 0;
  const auto points = static_cast<double>(environment.wind.profile.size());
  const double turn = is_round(f.earth) ? vertical_cost(f) + 24 : 0;
  return turn + (f.wind == WindModel::profile ? 3 + 9 * points : 3);
}

double drag_cost(const Fidelity& f, const ProjectileDef& projectile, const Environment& environment) {
  if (f.drag == DragModel::off) return 0;
  const double wind = wind_cost(f, environment);
  if (f.drag == DragModel::damping) return wind + 6;
  constexpr double kSpeed = 5 + 4;
  if (f.drag == DragModel::linear_quadratic) return wind + kSpeed + 8;
  constexpr double kCurve = 24;
  const DragDef& d = projectile.drag;
  const double sphere = d.table == DragTable::sphere ? 40 + 2 * kPow : 0;
  const double bands = 2 * static_cast<double>(d.bands.size());
  return wind + kSpeed + 10 + kCurve + sphere + bands + air_cost(f);
}

double evaluation_cost(const Fidelity& f, const ProjectileDef& projectile, const Environment& environment) {
  double cost = gravity_cost(f) + drag_cost(f, projectile, environment);
  if (is_turning(f.earth)) cost += 15;
  if (throws_out(f)) cost += 21;
  if (f.motion == Motion::force && projectile.force != Vec3d{}) cost += 7;
  if (flies_motors(f) && has_motor(projectile)) cost += wind_cost(f, environment) + 24 + 2 * kReciprocal;
  if (f.rotation == RotationModel::magnus) cost += kExp + 40 + 4 * kReciprocal;
  if (f.planar) cost += 11;
  if (turns(f)) cost += is_in_repose(f) ? 140 : 110;
  return cost;
}

/// Of an integrator, beside its evaluations: the sums over earlier slopes, and step control.
double integrator_cost(Integrator integrator) {
  constexpr double kSlope = 12, kControl = 80;
  switch (integrator) {
    case Integrator::heun:
      return 2 * kAdvance + kSlope;
    case Integrator::rk4:
      return 4 * kAdvance + 3 * kSlope;
    case Integrator::rk43:
      return 4 * kAdvance + 10 * kSlope + kControl;
    case Integrator::tsit5:
      return 6 * kAdvance + 21 * kSlope + kControl;
    case Integrator::dop853:
      return 12 * kAdvance + 66 * kSlope + kControl;
    default:
      return kAdvance;
  }
}

/// With a rotation more than twice as many numbers are moved.
double growth(const Fidelity& f) { return turns(f) ? 13.0 / 6 : 1; }

double closed_form_cost(const Fidelity& f) {
  constexpr double kSeries = 34 + 10;
  return kAdvance + (f.drag == DragModel::off ? 0 : kSeries + 2 * kExp);
}

}  // namespace

double step_cost(const Fidelity& f, const ProjectileDef& projectile, const Environment& environment) {
  double cost = f.rotation == RotationModel::spin_drift ? kPow : 0;  // added where the flight is shown
  if (f.motion == Motion::closed_form)
    cost += closed_form_cost(f);
  else
    cost += end_slope(f.integrator) * evaluation_cost(f, projectile, environment) +
            growth(f) * integrator_cost(f.integrator);
  return f.precision == Precision::float64 ? 2 * cost : cost;
}

}  // namespace physim
