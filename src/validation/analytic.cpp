// Suite analytic: flights with known exact solutions. Here: what the cases share, and which file is which case.
#include "validation/analytic.hpp"

#include <algorithm>
#include <cmath>

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
                     .earth = EarthModel::flat};
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

RowCheck::RowCheck(const CsvFile& file, const CsvRow& row, const Method& method, std::string label, SuiteResult& result)
    : file_(file), row_(row), method_(method), label_(std::move(label)), result_(result) {}

void RowCheck::compare(const char* column, double actual, double scale) {
  add(column, actual, [&](double expected) {
    return std::max(method_.relative * std::abs(expected), method_.floor * std::abs(scale));
  });
}

void RowCheck::compare_within(const char* column, double actual, double gate) {
  add(column, actual, [&](double) { return gate; });
}

void RowCheck::add(const char* column, double actual, const std::function<double(double)>& gate) {
  const auto expected = file_.number(row_, column);
  if (!expected || !std::isfinite(*expected)) return;
  const std::string stem = file_.name().substr(0, file_.name().rfind('.'));
  result_.figures.push_back({.case_name = stem + " " + method_.name,
                             .figure = std::string(column) + " " + label_,
                             .expected = *expected,
                             .actual = problem_.empty() ? actual : kNaN,
                             .gate = gate(*expected),
                             .note = problem_});
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

std::optional<Event> first_event(const Flight& flight, EventKind kind) {
  for (const Event& event : flight.events())
    if (event.kind == kind) return event;
  return std::nullopt;
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

constexpr std::size_t kCaseCount = std::size(kCases);
constexpr std::string_view kFiles[kCaseCount] = {
    kCases[0].file, kCases[1].file, kCases[2].file, kCases[3].file, kCases[4].file,  kCases[5].file,
    kCases[6].file, kCases[7].file, kCases[8].file, kCases[9].file, kCases[10].file, kCases[11].file,
};

void run(const std::filesystem::path& folder, SuiteResult& result) {
  for (const auto& path : files_in(folder, kFiles, ".csv")) {
    const std::string name = path.filename().string();
    const auto found =
        std::find_if(std::begin(kCases), std::end(kCases), [&](const Case& c) { return c.file == name; });
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
    kFiles,
    run};

}  // namespace physim::validation
