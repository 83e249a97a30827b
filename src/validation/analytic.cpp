// Suite analytic: flights with known exact solutions. Here: what the cases share, and which file is which case.
#include "validation/analytic.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include "base/assert.hpp"
#include "report/number.hpp"

namespace physim::validation {
using report::significant;
namespace {

constexpr double kTight = 1e-14;  // tolerance of the integrators

Method integrator_method(const char* name, Integrator integrator) {
  Method method{.name = name, .relative = 1e-9, .floor = 1e-12};
  method.fidelity = {.integrator = integrator,
                     .gravity = GravityModel::constant,
                     .drag = DragModel::off,
                     .air = AirModel::vacuum,
                     .wind = WindModel::off,
                     .earth = EarthModel::flat,
                     .rotation = RotationModel::none};
  method.tolerance = {.relative = kTight, .absolute = kTight};
  return method;
}

}  // namespace

std::vector<Method> integrators() {
  return {integrator_method("tsit5", Integrator::tsit5), integrator_method("dop853", Integrator::dop853)};
}

std::vector<Method> closed_form_and_integrators() {
  std::vector<Method> methods = integrators();
  Method exact = methods.front();
  exact.name = "closed_form";
  exact.fidelity.motion = Motion::closed_form;
  exact.relative = 1e-12;
  exact.floor = 1e-15;
  methods.insert(methods.begin(), exact);
  return methods;
}

Flight ShotInPlace::fly(const Method& method) const {
  return physim::fly(projectile, launch, environment, method.fidelity, method.tolerance, until);
}

ShotInPlace shot_under(double gravity) {
  ShotInPlace shot;
  shot.projectile.mass = 1;
  shot.environment.gravity.acceleration = gravity;
  return shot;
}

RowCheck::RowCheck(const CsvFile& file, const CsvRow& row, const Method& method, std::string label, std::string problem,
                   SuiteResult& result)
    : file_(file),
      row_(row),
      method_(method),
      label_(std::move(label)),
      problem_(std::move(problem)),
      result_(result) {}

void RowCheck::compare(const char* column, double actual, double scale) {
  PHYSIM_ASSERT(method_.relative > 0);
  const double expected = file_.number(row_, column).value_or(0);
  compare_within(column, actual, std::max(method_.relative * std::abs(expected), method_.floor * std::abs(scale)));
}

void RowCheck::compare_within(const char* column, double actual, double gate) {
  const auto expected = file_.number(row_, column);
  if (expected && std::isfinite(*expected))
    result_.compare(file_.stem() + " " + method_.name, std::string(column) + " " + label_, *expected, actual, gate,
                    problem_);
}

void fly_row(const CsvFile& file, const CsvRow& row, const std::string& label, const std::vector<Method>& methods,
             const ShotInPlace& shot, SuiteResult& result,
             const std::function<void(RowCheck& check, const Flight& flight)>& compare) {
  for (const Method& method : methods) {
    const Flight flight = shot.fly(method);
    RowCheck check(file, row, method, label, complaint(flight, method.fidelity), result);
    compare(check, flight);
  }
}

std::string label_of(const CsvFile& file, const CsvRow& row, std::initializer_list<Parameter> parameters) {
  std::string label;
  for (const Parameter& parameter : parameters) {
    const std::string& field = file.text(row, parameter.column);
    if (field.empty()) continue;
    const auto value = parse_number(field);
    label += (label.empty() ? "" : " ") + std::string(parameter.name) + "=" + (value ? significant(*value, 6) : field);
  }
  return label;
}

Sample apex_of(const Flight& flight) {
  for (const Event& event : flight.events())
    if (event.kind == EventKind::apex)
      return {
          .time = event.time, .position = event.position, .velocity = event.velocity, .speed = length(event.velocity)};
  return {.time = kNaN, .position = {kNaN, kNaN, kNaN}, .velocity = {kNaN, kNaN, kNaN}, .speed = kNaN};
}

namespace {

struct Case {
  std::string_view file;
  Reader read;
};

constexpr Case kCases[] = {
    {"vacuum_parabola.csv", vacuum_parabola},
    {"linear_drag.csv", linear_drag},
    {"quadratic_vertical.csv", quadratic_vertical},
    {"quadratic_2d_constant_density.csv", quadratic_2d},
    {"fall_exponential_atmosphere.csv", fall_exponential},
    {"bouncing_ball.csv", bouncing_ball},
    {"coriolis_uniform_g.csv", coriolis_uniform_g},
    {"magnus_constant_kappa.csv", magnus_constant_kappa},
    {"kepler_orbits.csv", kepler_orbits},
    {"newton_gravity_range.csv", newton_gravity_range},
    {"radial_fall_newton.csv", radial_fall_newton},
    {"torque_free_brick.csv", torque_free_body},
};

constexpr auto kAnalyticFiles = [] {
  std::array<std::string_view, std::size(kCases)> files;
  std::ranges::transform(kCases, files.begin(), &Case::file);
  return files;
}();

void run_analytic(const std::filesystem::path& folder, SuiteResult& result) {
  for (const auto& path : files_in(folder, kAnalyticFiles, ".csv")) {
    const std::string name = path.filename().string();
    const auto found = std::ranges::find(kCases, name, &Case::file);
    if (found == std::end(kCases)) {
      result.skipped.push_back(name + ": no case of this name");
      continue;
    }
    const CsvFile file = CsvFile::read(path);
    result.sources.push_back({name, file.comments()});
    found->read(file, result);
  }
}

}  // namespace

const Suite kAnalyticSuite = {
    "analytic",
    "Flights with an exact solution",
    "closed form 1e-12, integrators 1e-9 of the figure; components of a vector also 1e-12 of its length; Kepler orbits "
    "1e-4 m after a revolution, circular 1e-5 m, and their energy 1e-11",
    "analytic",
    kAnalyticFiles,
    run_analytic};

}  // namespace physim::validation
