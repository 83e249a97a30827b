#include "rungs.hpp"

#include <utility>
#include <vector>

#include "physim/names.hpp"

namespace physim::cli {
namespace {

constexpr std::string_view kMissing = "(no text)";

// The names come from the library, so that no rung is ever missing from the list.
template <class Enum>
void add(std::vector<RungDoc>& all, std::string_view effect,
         std::initializer_list<std::pair<Enum, std::string_view>> docs) {
  for (const std::string_view rung : names_of<Enum>()) {
    std::string_view text = kMissing;
    for (const auto& [value, doc] : docs)
      if (name(value) == rung) text = doc;
    all.push_back({effect, rung, text});
  }
}

std::vector<RungDoc> all_docs() {
  std::vector<RungDoc> all;
  add<Motion>(all, "motion",
              {{Motion::closed_form, "exact formulas: vacuum, or drag linear in velocity"},
               {Motion::velocity, "constants act directly on the velocity; no forces"},
               {Motion::force, "the resultant of all forces, divided by mass"}});
  add<Integrator>(all, "integrator",
                  {{Integrator::classic, "the original PhySim frame loop: position, velocity, damping"},
                   {Integrator::explicit_euler, "order 1, fixed step"},
                   {Integrator::semi_implicit_euler, "order 1, symplectic, fixed step; what most game engines do"},
                   {Integrator::heun, "order 2, fixed step"},
                   {Integrator::rk4, "order 4, fixed step"},
                   {Integrator::rk43, "order 4, adaptive (Sofroniou and Spaletta 2004)"},
                   {Integrator::tsit5, "order 5, adaptive (Tsitouras 2011)"},
                   {Integrator::dop853, "order 8, adaptive (Dormand and Prince)"}});
  add<GravityModel>(all, "gravity",
                    {{GravityModel::off, "none"},
                     {GravityModel::constant, "the same everywhere"},
                     {GravityModel::inverse_square, "Newton's law: falls with the square of the distance"},
                     {GravityModel::j2, "a point mass and the Earth's flattening, J2"},
                     {GravityModel::wgs84, "normal gravity of the ellipsoid WGS-84, exact at every height"}});
  add<DragModel>(all, "drag",
                 {{DragModel::off, "none"},
                  {DragModel::damping, "velocity *= damping^dt"},
                  {DragModel::linear_quadratic, "F = -(k1 + k2 |v|) v"},
                  {DragModel::equation, "F = -1/2 rho |v| v Cd A; Cd constant, by Reynolds or by Mach number"}});
  add<AirModel>(all, "air",
                {{AirModel::vacuum, "none"},
                 {AirModel::constant, "the air at the origin, everywhere"},
                 {AirModel::exponential, "density falls by e per scale height"},
                 {AirModel::isa, "US Standard Atmosphere 1976, shifted to the station's weather"}});
  add<WindModel>(all, "wind",
                 {{WindModel::off, "none"},
                  {WindModel::constant, "the same everywhere"},
                  {WindModel::profile, "by height or by range"}});
  add<EarthModel>(all, "earth",
                  {{EarthModel::flat, "flat, not rotating"},
                   {EarthModel::flat_coriolis, "flat, with the Coriolis acceleration"},
                   {EarthModel::sphere, "round, not rotating; gravity points to its centre"},
                   {EarthModel::sphere_rotating, "round and rotating: the air turns with it"},
                   {EarthModel::ellipsoid, "WGS-84, rotating; heights are above the ellipsoid"}});
  add<RotationModel>(all, "rotation",
                     {{RotationModel::none, "spin has no effect"},
                      {RotationModel::spin_drift, "Litz's spin drift with Miller's stability factor"},
                      {RotationModel::magnus, "lift and drag of balls that spin"},
                      {RotationModel::modified_point_mass, "spinning shells in their yaw of repose (STANAG 4355)"},
                      {RotationModel::rigid_body, "six degrees of freedom: the attitude is flown too"}});
  add<BodyForm>(all, "body_form",
                {{BodyForm::automatic, "axis for bodies symmetric about x with rifling, quaternion else"},
                 {BodyForm::quaternion, "quaternion and body rates: any body"},
                 {BodyForm::axis, "symmetry axis and angular momentum: steps need not resolve the spin"}});
  add<Precision>(all, "precision",
                 {{Precision::float32, "single precision"}, {Precision::float64, "double precision"}});
  add<Interpolation>(all, "interpolation",
                     {{Interpolation::linear, "straight lines between the points of a drag curve"},
                      {Interpolation::pchip, "monotone cubic (Fritsch and Butland): smooth slope, no overshoot"},
                      {Interpolation::cubic, "natural cubic spline: smooth curvature"}});
  return all;
}

}  // namespace

std::span<const RungDoc> rung_docs() {
  static const std::vector<RungDoc> all = all_docs();
  return all;
}

}  // namespace physim::cli
