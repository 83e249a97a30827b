#include "prepare/fidelity_cost.hpp"

#include <type_traits>

#include "base/assert.hpp"
#include "model/ladder.hpp"
#include "prepare/grant.hpp"
#include "solve/take_step.hpp"

namespace physim {
namespace {

// Units: see model/ladder.hpp.
constexpr double kAdvance = 12;  // y + h y'

double vertical_cost(const Fidelity& f) { return row(f.earth).vertical_cost; }

double gravity_cost(const Fidelity& f) {
  const GravityRow& gravity = row(f.gravity);
  switch (row(f.earth).shape) {
    case EarthShape::flat: return gravity.flat_cost;
    case EarthShape::sphere: return gravity.sphere_cost;
    case EarthShape::ellipsoid:
      return gravity.ellipsoid_cost + (gravity.field == GravityField::uniform ? vertical_cost(f) : 0);
  }
  PHYSIM_UNREACHABLE();
}

double air_cost(const Fidelity& f) {
  const AirRow& air = row(f.air);
  return (air.by_height ? vertical_cost(f) : 0) + (f.precision == Precision::float32 ? air.cost32 : air.cost64);
}

double wind_cost(const Fidelity& f, const Environment& environment) {
  if (f.wind == WindModel::off) return 0;
  const double turn = is_round(f.earth) ? vertical_cost(f) + 24 : 0;
  const auto points = static_cast<double>(environment.wind.profile.size());
  return turn + row(f.wind).cost + row(f.wind).point_cost * points;
}

double drag_cost(const Fidelity& f, const ProjectileDef& projectile, const Environment& environment) {
  if (f.drag == DragModel::off) return 0;
  const double simple = wind_cost(f, environment) + row(f.drag).cost;
  if (!row(f.drag).reads_air) return simple;
  const DragDef& d = projectile.drag;
  const double sphere = d.table == DragTable::sphere ? 40 + 2 * cost::kPow : 0;
  const double bands = 2 * static_cast<double>(d.bands.size());
  return simple + sphere + bands + air_cost(f);
}

double evaluation_cost(const Fidelity& f, const ProjectileDef& projectile, const Environment& environment) {
  double sum = gravity_cost(f) + drag_cost(f, projectile, environment) + row(f.rotation).cost;
  if (is_turning(f.earth)) sum += 15;
  if (throws_out(f)) sum += 21;
  if (f.motion == Motion::force && projectile.force != Vec3d{}) sum += 7;
  if (flies_motors(f) && has_motor(projectile)) sum += wind_cost(f, environment) + 24 + 2 * cost::kReciprocal;
  if (f.planar) sum += 11;
  return sum;
}

/// The entries of a tableau's rows that are not zero.
template <class Rows>
constexpr int terms(const Rows& rows) {
  if constexpr (std::is_arithmetic_v<Rows>) {
    return rows != 0 ? 1 : 0;
  } else {
    int count = 0;
    for (const auto& each : rows) count += terms(each);
    return count;
  }
}

/// What an integrator costs beside its evaluations: the sums over slopes, and step control.
double integrator_cost(Integrator integrator) {
  constexpr double kSlope = 12, kControl = 80;
  return with_method(integrator, [](auto method) {
    using Method = decltype(method);
    if constexpr (RungeKutta<Method>)
      return Method::kStages * kAdvance + (terms(Method::a) + terms(Method::b)) * kSlope +
             (Adaptive<Method> ? kControl : 0);
    else
      return kAdvance;
  });
}

/// With a rotation more than twice as many numbers are moved.
double growth(const Fidelity& f) { return turns(f) ? 13.0 / 6 : 1; }

double closed_form_cost(const Fidelity& f) {
  constexpr double kSeries = 34 + 10;
  return kAdvance + (f.drag == DragModel::off ? 0 : kSeries + 2 * cost::kExp);
}

}  // namespace

double step_cost(const Fidelity& f, const ProjectileDef& projectile, const Environment& environment) {
  double sum = row(f.rotation).step_cost;
  if (f.motion == Motion::closed_form)
    sum += closed_form_cost(f);
  else
    sum += end_slope(f.integrator) * evaluation_cost(f, projectile, environment) +
           growth(f) * integrator_cost(f.integrator);
  PHYSIM_ASSERT(sum > 0);
  return row(f.precision).cost_factor * sum;
}

}  // namespace physim
