// Suite analytic: flights with known exact solutions.
#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <map>

#include "base/assert.hpp"
#include "physim/names.hpp"
#include "report/number.hpp"
#include "validation/suite.hpp"

namespace physim::validation {
using report::significant;
namespace {

constexpr double kStandardGravity = 9.80665;  // [m/s^2]
constexpr double kEarthGM = 3.986004418e14;   // [m^3/s^2]
constexpr double kMeanRadius = 6371000.0;     // [m]
constexpr double kTight = 1e-14;              // tolerance of the integrators
constexpr EventSpec kApex = {.kind = EventKind::apex};

// ------------------------------------------------------------------------------------------------------------- methods
/// A way to fly a case, and the error it may have.
struct Method {
  std::string name;
  Fidelity fidelity;
  Tolerance tolerance;
  double relative = 0;  // gate: part of the figure [-]
  double floor = 0;     // gate: part of the scale that the figure is a component of [-]
};

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

/// tsit5 and dop853 at tight tolerance, without any effect but constant gravity.
std::vector<Method> integrators() {
  return {integrator_method("tsit5", Integrator::tsit5), integrator_method("dop853", Integrator::dop853)};
}

/// The exact formulas, and the integrators.
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

/// The integrators with other rungs.
std::vector<Method> integrators_with(void (*change)(Fidelity& fidelity)) {
  std::vector<Method> methods = integrators();
  for (Method& method : methods) change(method.fidelity);
  return methods;
}

/// The parabola is exact for every method of order two or more.
std::vector<Method> parabola_methods() {
  std::vector<Method> methods = closed_form_and_integrators();
  for (const Integrator integrator : {Integrator::heun, Integrator::rk4}) {
    Method fixed_step = methods.back();
    fixed_step.name = name(integrator);
    fixed_step.fidelity.integrator = integrator;
    fixed_step.tolerance.step = 0.05;
    methods.push_back(fixed_step);
  }
  return methods;
}

std::vector<Method> linear_drag_methods() {
  std::vector<Method> methods = closed_form_and_integrators();
  for (Method& method : methods) {
    method.fidelity.drag = DragModel::linear_quadratic;
    method.fidelity.air = AirModel::constant;
    method.fidelity.wind = WindModel::constant;
  }
  return methods;
}

/// The integrators in constant air, by the drag equation and by the constants k1, k2 in its place.
std::vector<Method> quadratic_methods() {
  std::vector<Method> methods = integrators_with([](Fidelity& fidelity) {
    fidelity.drag = DragModel::equation;
    fidelity.air = AirModel::constant;
  });
  Method constants = methods.front();
  constants.name += " k1 k2";
  constants.fidelity.drag = DragModel::linear_quadratic;
  methods.push_back(constants);
  return methods;
}

std::vector<Method> in_exponential_air() {
  return integrators_with([](Fidelity& fidelity) {
    fidelity.drag = DragModel::equation;
    fidelity.air = AirModel::exponential;
  });
}
std::vector<Method> on_the_sphere() {
  return integrators_with([](Fidelity& fidelity) {
    fidelity.gravity = GravityModel::inverse_square;
    fidelity.earth = EarthModel::sphere;
  });
}
std::vector<Method> with_coriolis() {
  return integrators_with([](Fidelity& fidelity) { fidelity.earth = EarthModel::flat_coriolis; });
}
std::vector<Method> with_magnus() {
  return integrators_with([](Fidelity& fidelity) {
    fidelity.drag = DragModel::equation;
    fidelity.air = AirModel::constant;
    fidelity.rotation = RotationModel::magnus;
  });
}
std::vector<Method> of_free_bodies() {
  return integrators_with([](Fidelity& fidelity) {
    fidelity.rotation = RotationModel::rigid_body;
    fidelity.gravity = GravityModel::off;
  });
}

// ---------------------------------------------------------------------------------------------------------------- rows
/// A row of a table of figures.
struct FigureRow {
  const CsvFile& file;
  const CsvRow& row;

  [[nodiscard]] const std::string& text(std::string_view column) const { return file.text(row, column); }
  [[nodiscard]] double needed(const char* column) const { return file.needed(row, column); }
  /// 0 where there is none.
  [[nodiscard]] double number(const char* column) const { return file.number(row, column).value_or(0); }
  [[nodiscard]] double positive(const char* column) const {
    const double value = needed(column);
    if (value <= 0) file.fail(row, std::string("column \"") + column + "\" needs a number above 0");
    return value;
  }
};

/// Compares the columns of one row of a table with what one method gives.
class RowCheck {
 public:
  /// `problem`: why nothing of this row can be computed; empty: it can.
  RowCheck(const FigureRow& row, const Method& method, std::string label, std::string problem, SuiteResult& result)
      : row_(row), method_(method), label_(std::move(label)), problem_(std::move(problem)), result_(result) {}

  [[nodiscard]] const FigureRow& row() const { return row_; }
  /// Compares with a column by its relative error; nothing where the row has no value there. A component of a vector is
  /// also allowed rounding of the vector's length, `scale`.
  void compare(const char* column, double actual, double scale = 0) {
    PHYSIM_ASSERT(method_.relative > 0);
    const double relative = method_.relative * std::abs(row_.number(column));
    compare_within(column, actual, std::max(relative, method_.floor * std::abs(scale)));
  }
  /// Compares with a column by its absolute error.
  void compare_within(const char* column, double actual, double gate) {
    const auto expected = row_.file.number(row_.row, column);
    if (expected && std::isfinite(*expected))
      result_.compare(row_.file.stem() + " " + method_.name, std::string(column) + " " + label_, *expected, actual,
                      gate, problem_);
  }

 private:
  FigureRow row_;
  const Method& method_;
  std::string label_;
  std::string problem_;
  SuiteResult& result_;
};

/// An input of a row, and its column.
struct Parameter {
  std::string_view name;  // empty: the value alone
  std::string_view column;
};
/// "drop v0=100 elev=45": the inputs of a row.
std::string label_of(const FigureRow& row, std::span<const Parameter> parameters) {
  std::string label;
  for (const auto& [name, column] : parameters) {
    const std::string& field = row.text(column);
    if (column.empty() || field.empty()) continue;
    const auto value = parse_number(field);
    label += (label.empty() ? "" : " ") + std::string(name) + (name.empty() ? "" : "=") +
             (value ? significant(*value, 6) : field);
  }
  return label;
}

/// A shot and the place where it flies; the fidelity says what of it counts.
struct ShotInPlace {
  ProjectileDef projectile;
  Launch launch;
  Environment environment;
  Until until;

  [[nodiscard]] Flight fly(const Method& method) const {
    return physim::fly(projectile, launch, environment, method.fidelity, method.tolerance, until);
  }
  /// Drops it instead of launching it.
  void drop_from(const Vec3d& place) { launch.position = place, launch.velocity = Vec3d{}; }
  /// Ends it after a time, over no ground.
  void end_after(double time) { until.ground = std::nullopt, until.time = time; }
};

/// 1 kg, launched from the origin under constant gravity.
ShotInPlace shot_under(double gravity) {
  ShotInPlace shot;
  shot.projectile.mass = 1;
  shot.environment.gravity.acceleration = gravity;
  return shot;
}
ShotInPlace shot_on_the_ground(const CsvFile& file) { return shot_under(file.constant("g", kStandardGravity)); }
/// Around a sphere; the origin of W is on its surface.
ShotInPlace shot_around(double gm, double radius) {
  ShotInPlace shot = shot_under(gm / (radius * radius));
  shot.environment.gravity.radius = radius;
  return shot;
}
ShotInPlace shot_around(const CsvFile& file) {
  return shot_around(file.constant("GM", kEarthGM), file.constant("R", kMeanRadius));
}
/// Launches it as the row tells; its apex is an event.
ShotInPlace aimed(ShotInPlace shot, const FigureRow& row) {
  shot.launch.speed = row.needed("v0_m_s");
  shot.launch.elevation = row.needed("elev_deg") * kDegree;
  shot.until.events = {kApex};
  return shot;
}

/// The apex of a flight; all numbers are NaN if it has no apex.
Sample apex_of(const Flight& flight) {
  for (const Event& event : flight.events())
    if (event.kind == EventKind::apex)
      return {
          .time = event.time, .position = event.position, .velocity = event.velocity, .speed = length(event.velocity)};
  return {.time = kNaN, .position = {kNaN, kNaN, kNaN}, .velocity = {kNaN, kNaN, kNaN}, .speed = kNaN};
}

/// Flies the shot of a row by each method, and compares each flight with the row.
void fly_row(const FigureRow& row, const std::string& label, const std::vector<Method>& methods,
             const ShotInPlace& shot, void (*compare)(RowCheck& check, const Flight& flight), SuiteResult& result) {
  for (const Method& method : methods) {
    const Flight flight = shot.fly(method);
    RowCheck check(row, method, label, complaint(flight, method.fidelity), result);
    compare(check, flight);
  }
}

// ------------------------------------------------------------------------------------------------- quadratic drag
/// Air and a projectile with a drag deceleration of k v^2 at the origin.
void set_quadratic_drag(ShotInPlace& shot, double k) {
  constexpr double kDensity = 1.225;  // files give only k = rho Cd A / (2 m) [kg/m^3]
  DragDef& drag = shot.projectile.drag;
  drag.table = DragTable::constant;
  drag.coefficient = 0.5;
  const double area = 2.0 * k * shot.projectile.mass / (kDensity * drag.coefficient);
  shot.projectile.diameter = 2.0 * std::sqrt(area / kPi);
  shot.environment.atmosphere.density = kDensity;
  shot.environment.atmosphere.sound_speed = 340.0;
}

void compare_fall(RowCheck& check, const Flight& flight) {
  check.compare("speed_m_s", flight.end().speed);
  check.compare("distance_fallen_or_height_m", -flight.end().position.y);
}
void compare_rise(RowCheck& check, const Flight& flight) {
  const Sample apex = apex_of(flight);
  check.compare("t_s", apex.time);
  check.compare("speed_m_s", apex.speed, 1000 * check.row().needed("v0_up_m_s"));
  check.compare("distance_fallen_or_height_m", apex.position.y);
}
void compare_return(RowCheck& check, const Flight& flight) {
  check.compare("t_s", flight.duration());
  check.compare("speed_m_s", flight.end().speed);
}

/// Falls, and ascents to the apex and back to the ground.
void quadratic_vertical(const CsvFile& file, SuiteResult& result) {
  static constexpr Parameter kOfFall[] = {{"", "case"}, {"vt", "vt_m_s"}, {"t", "t_s"}};
  static constexpr Parameter kOfAscent[] = {{"", "case"}, {"vt", "vt_m_s"}, {"v0", "v0_up_m_s"}};
  for (const CsvRow& of : file.rows()) {
    const FigureRow row{file, of};
    const std::string& kind = row.text("case");
    if (kind != "fall" && !kind.starts_with("ascent")) {
      result.skipped.push_back(file.name() + ": no case \"" + kind + "\"");
      continue;
    }
    ShotInPlace shot = shot_on_the_ground(file);
    const double g = shot.environment.gravity.acceleration, vt = row.positive("vt_m_s");
    set_quadratic_drag(shot, g / (vt * vt));
    shot.projectile.drag.k2 = shot.projectile.mass * g / (vt * vt);
    if (kind == "fall") {
      shot.drop_from({});
      shot.end_after(row.positive("t_s"));
      fly_row(row, label_of(row, kOfFall), quadratic_methods(), shot, compare_fall, result);
    } else {
      shot.launch.velocity = Vec3d{0, row.positive("v0_up_m_s"), 0};
      shot.until.events = {kApex};
      fly_row(row, label_of(row, kOfAscent), quadratic_methods(), shot,
              kind == "ascent_apex" ? compare_rise : compare_return, result);
    }
  }
}

// ------------------------------------------------------------------------------------------------- the bouncing ball

struct Contact {
  double time = 0;   // since the drop [s]
  double speed = 0;  // before the contact [m/s]
};

/// Drops a ball and lets it bounce: a chain of flights, each from the ground to the ground.
class Bouncer {
 public:
  Bouncer(const CsvFile& file, double restitution, const Method& method)
      : method_(method), restitution_(restitution), shot_(shot_on_the_ground(file)) {
    const auto stated = number_after(file.comments(), "dropped from");  // "dropped from 10 m"
    shot_.drop_from({0, stated.value_or(file.constant("h", 10.0)), 0});
  }

  /// The contact of a number, 0 the first.
  Contact contact(std::size_t index) {
    while (contacts_.size() <= index && problem_.empty()) fly_on();
    return index < contacts_.size() ? contacts_[index] : Contact{kNaN, kNaN};
  }

  /// Where the contacts lead: flown until what is left is lost in rounding.
  Contact limit() {
    for (std::size_t index = 0; index < kMaxBounces && problem_.empty(); ++index)
      if (const Contact last = contact(index); last.speed < 1e-16 * contacts_.front().speed) return last;
    return {kNaN, kNaN};
  }

  [[nodiscard]] const std::string& problem() const { return problem_; }

 private:
  static constexpr std::size_t kMaxBounces = 2000;

  void fly_on() {
    PHYSIM_ASSERT(problem_.empty());
    const Flight flight = shot_.fly(method_);
    problem_ = complaint(flight, method_.fidelity);
    const Sample end = flight.end();
    contacts_.push_back({(contacts_.empty() ? 0.0 : contacts_.back().time) + flight.duration(), end.speed});
    shot_.launch.position = {};
    shot_.launch.velocity = Vec3d{0, restitution_ * end.speed, 0};
  }

  const Method& method_;
  double restitution_;
  ShotInPlace shot_;
  std::vector<Contact> contacts_;
  std::string problem_;
};

void bouncing_ball(const CsvFile& file, SuiteResult& result) {
  static constexpr Parameter kParameters[] = {{"e", "restitution"}, {"bounce", "bounce_index"}};
  for (const Method& method : closed_form_and_integrators()) {
    std::map<double, Bouncer> bouncers;  // by restitution
    for (const CsvRow& of : file.rows()) {
      const FigureRow row{file, of};
      const double restitution = row.positive("restitution");
      if (restitution >= 1) file.fail(of, "column \"restitution\" needs a number below 1");
      const double index = file.number(of, "bounce_index").value_or(kNaN);
      if (!(index >= 0) || (std::isfinite(index) && index > 10000))
        file.fail(of, "column \"bounce_index\" needs the number of a bounce, or inf");
      Bouncer& bouncer = bouncers.try_emplace(restitution, file, restitution, method).first->second;
      const Contact contact = std::isinf(index) ? bouncer.limit() : bouncer.contact(static_cast<std::size_t>(index));
      RowCheck check(row, method, label_of(row, kParameters), bouncer.problem(), result);
      check.compare("t_contact_s", contact.time);
      check.compare("speed_before_contact_m_s", contact.speed, std::isinf(index) ? bouncer.contact(0).speed : 0);
    }
  }
}

// -------------------------------------------------------------------------------------------------------------- orbits

/// Its x is up in W, from the sphere's centre, its y downrange; it starts at its periapsis.
struct Orbit {
  double a = 0, e = 0;
  std::vector<const CsvRow*> rows;
};

std::vector<Orbit> orbits_of(const CsvFile& file) {
  std::vector<Orbit> orbits;
  for (const CsvRow& row : file.rows()) {
    const double a = file.needed(row, "a_m");
    const double e = file.needed(row, "e");
    if (a <= 0 || e < 0 || e >= 1) file.fail(row, "an orbit needs a_m > 0 and 0 <= e < 1");
    auto at = std::find_if(orbits.begin(), orbits.end(), [&](const Orbit& o) { return o.a == a && o.e == e; });
    if (at == orbits.end()) at = orbits.insert(orbits.end(), Orbit{a, e, {}});
    at->rows.push_back(&row);
  }
  return orbits;
}

/// The largest change of the energy over the revolution, relative to it.
void report_energy_drift(const Flight& flight, double gm, const Method& method, const std::string& label,
                         SuiteResult& result) {
  const auto energy = [&](double time) {
    const Sample s = flight.at(time);
    return 0.5 * s.speed * s.speed - gm / length(s.position + Vec3d{0, kMeanRadius, 0});
  };
  double drift = 0;
  for (const double time : flight.step_times()) drift = std::max(drift, std::abs(energy(time) / energy(0) - 1));
  result.compare("kepler_orbits energy " + method.name, "energy drift " + label, 0, drift, 1e-11,
                 complaint(flight, method.fidelity));
}

void check_orbit(const CsvFile& file, const Orbit& orbit, double gm, const Method& method, SuiteResult& result) {
  static constexpr Parameter kParameters[] = {{"a", "a_m"}, {"e", "e"}, {"t", "t_s"}};
  const auto& [a, e, rows] = orbit;
  ShotInPlace shot = shot_around(gm, kMeanRadius);
  shot.launch.position = {0, a * (1 - e) - kMeanRadius, 0};
  shot.launch.velocity = Vec3d{std::sqrt(gm / a * (1 + e) / (1 - e)), 0, 0};
  shot.end_after(0);
  for (const CsvRow* row : rows) shot.until.time = std::max(shot.until.time, file.needed(*row, "t_s"));
  const Flight flight = shot.fly(method);
  const double gate = e == 0 ? 1e-5 : 1e-4;
  for (const CsvRow* of : rows) {
    const FigureRow row{file, *of};
    const Sample sample = flight.at(row.needed("t_s"));
    RowCheck check(row, method, label_of(row, kParameters), complaint(flight, method.fidelity), result);
    check.compare_within("x_m", sample.position.y + kMeanRadius, gate);
    check.compare_within("y_m", sample.position.x, gate);
    check.compare_within("vx_m_s", sample.velocity.y, method.relative * sample.speed);
    check.compare_within("vy_m_s", sample.velocity.x, method.relative * sample.speed);
  }
  report_energy_drift(flight, gm, method, formatted("a=%.6g e=%g", a, e), result);
}

void kepler_orbits(const CsvFile& file, SuiteResult& result) {
  const double gm = file.constant("GM", kEarthGM);
  for (const Method& method : on_the_sphere())
    for (const Orbit& orbit : orbits_of(file)) check_orbit(file, orbit, gm, method, result);
}

// ------------------------------------------------------------------------------------------------------ turning frames
/// A ball without drag with the lift kappa x v, for any kappa in W: rho A l r / (2 m) omega = kappa.
void spin_by(const Vec3d& kappa, ShotInPlace& shot) {
  constexpr double kDensity = 1.2, kRadius = 0.1, kArea = 0.0314159265358979323846;
  shot.environment.atmosphere.model = AirModel::constant;
  shot.environment.atmosphere.density = kDensity;
  shot.projectile.diameter = 2 * kRadius;
  shot.projectile.drag.coefficient = 0;
  shot.projectile.magnus.lift = 1;
  const Vec3d omega = kappa * (2 * shot.projectile.mass / (kDensity * kArea * kRadius));
  const Vec3d& v = *shot.launch.velocity;
  const double level = std::hypot(v.x, v.z);
  const Vec3d forward = v * (1 / length(v)), right{-v.z / level, 0, v.x / level};
  shot.launch.spin = {dot(omega, right), -dot(omega, cross(right, forward)), dot(omega, forward)};
}

/// "v0=(30,0,20)"
Vec3d launch_velocity(const CsvFile& file) {
  const std::string& text = file.comments();
  const auto open = text.find("v0=(");
  const auto close = open == std::string::npos ? open : text.find(')', open);
  if (close == std::string::npos) return {30, 0, 20};
  std::string list = text.substr(open + 4, close - open - 4);
  double v[3] = {};
  for (double& component : v) {
    const auto comma = std::min(list.find(','), list.size());
    component = parse_number(list.substr(0, comma)).value_or(kNaN);
    list.erase(0, std::min(comma + 1, list.size()));
  }
  return {v[0], v[1], v[2]};
}

/// The file's z is up and its x downrange: a turn about x.
Vec3d into_W(const Vec3d& v) { return {v.x, v.z, -v.y}; }
Vec3d from_W(const Vec3d& v) { return {v.x, -v.z, v.y}; }

// ------------------------------------------------------------------------------------------------ bodies that turn
constexpr double kSlugFt2 = 14.5939029372 * 0.3048 * 0.3048;  // [kg m^2]

/// Moments about forward, right and down [kg m^2], as the comments state them: "(A,B,C slug ft2)".
Vec3d stated_moments(const CsvFile& file) {
  Vec3d m;
  const std::size_t at = file.comments().find('(');
  if (at == std::string::npos || std::sscanf(file.comments().c_str() + at, "(%lf,%lf,%lf slug", &m.x, &m.y, &m.z) != 3)
    throw DataError{{.message = "the comments do not state the moments of inertia", .place = file.name()}};
  return m * kSlugFt2;
}

void compare_rotation(RowCheck& check, const Flight& flight, const Vec3d& moments) {
  const Vec3d w = flight.at(check.row().needed("t_s")).angular_velocity;  // forward, up, right
  const Vec3d momentum = component_product(moments, w);
  const double size = length(w) / kDegree;
  check.compare("p_deg_s", w.x / kDegree, size);
  check.compare("q_deg_s", w.z / kDegree, size);
  check.compare("r_deg_s", -w.y / kDegree, size);
  check.compare("kinetic_energy_J", 0.5 * dot(momentum, w));
  check.compare("ang_momentum_kg_m2_s", length(momentum));
}

void torque_free_body(const CsvFile& file, SuiteResult& result) {
  static constexpr Parameter kParameters[] = {{"t", "t_s"}};
  const Vec3d stated = stated_moments(file);
  const CsvRow* first = nullptr;
  double last = 0;
  for (const CsvRow& row : file.rows()) {
    last = std::max(last, file.needed(row, "t_s"));
    if (file.needed(row, "t_s") == 0) first = &row;
  }
  if (first == nullptr) throw DataError{{.message = "no row at time 0 tells how it starts", .place = file.name()}};
  ShotInPlace shot = shot_under(kStandardGravity);
  shot.projectile.inertia.moments = {stated.x, stated.z, stated.y};
  shot.launch.attitude.rates =
      Vec3d{file.needed(*first, "p_deg_s"), -file.needed(*first, "r_deg_s"), file.needed(*first, "q_deg_s")} * kDegree;
  shot.end_after(std::max(last, 1e-3));
  for (const Method& method : of_free_bodies()) {
    const Flight flight = shot.fly(method);
    for (const CsvRow& of : file.rows()) {
      const FigureRow row{file, of};
      RowCheck check(row, method, label_of(row, kParameters), complaint(flight, method.fidelity), result);
      compare_rotation(check, flight, shot.projectile.inertia.moments);
    }
  }
}

// ----------------------------------------------------------------------------------------------------------- the cases
/// A file of figures: how each row is flown, and what of its flight is compared, or a reader for all of it.
struct Case {
  std::string_view file;
  std::string_view columns[5];  // that it must have
  void (*read)(const CsvFile& file, SuiteResult& result) = nullptr;
  Parameter parameters[5] = {};  // in labels
  std::vector<Method> (*methods)() = nullptr;
  ShotInPlace (*shot)(const FigureRow& row) = nullptr;
  void (*compare)(RowCheck& check, const Flight& flight) = nullptr;
};

constexpr Case kCases[] = {
    {.file = "vacuum_parabola.csv",
     .columns = {"v0_m_s", "elev_deg"},
     .parameters = {{"v0", "v0_m_s"}, {"elev", "elev_deg"}},
     .methods = parabola_methods,
     .shot = [](const FigureRow& row) { return aimed(shot_on_the_ground(row.file), row); },
     .compare =
         [](RowCheck& check, const Flight& flight) {
           check.compare("t_flight_s", flight.duration());
           check.compare("range_m", flight.end().position.x);
           check.compare("apex_m", apex_of(flight).position.y);
         }},
    {.file = "linear_drag.csv",
     .columns = {"v0_m_s", "elev_deg", "k_1_s"},
     .parameters = {{"v0", "v0_m_s"}, {"elev", "elev_deg"}, {"k", "k_1_s"}, {"wind", "wind_x_m_s"}},
     .methods = linear_drag_methods,
     .shot =
         [](const FigureRow& row) {
           ShotInPlace shot = aimed(shot_on_the_ground(row.file), row);
           shot.projectile.drag.k1 = row.positive("k_1_s") * shot.projectile.mass;
           shot.environment.wind.velocity = {row.number("wind_x_m_s"), 0, 0};
           return shot;
         },
     .compare =
         [](RowCheck& check, const Flight& flight) {
           const Sample apex = apex_of(flight), end = flight.end(), half = flight.at(0.5 * flight.duration());
           check.compare("t_flight_s", flight.duration());
           check.compare("range_m", end.position.x);
           check.compare("t_apex_s", apex.time);
           check.compare("apex_m", apex.position.y);
           check.compare("x_half_m", half.position.x, length(half.position));
           check.compare("z_half_m", half.position.y, length(half.position));
           check.compare("vx_impact", end.velocity.x, end.speed);
           check.compare("vz_impact", end.velocity.y, end.speed);
         }},
    {.file = "quadratic_vertical.csv", .columns = {"case", "vt_m_s", "t_s"}, .read = quadratic_vertical},
    {.file = "quadratic_2d_constant_density.csv",
     .columns = {"v0_m_s", "elev_deg", "k_1_m"},
     .parameters = {{"v0", "v0_m_s"}, {"elev", "elev_deg"}, {"k", "k_1_m"}},
     .methods = quadratic_methods,
     .shot =
         [](const FigureRow& row) {
           ShotInPlace shot = aimed(shot_on_the_ground(row.file), row);
           const double k = row.positive("k_1_m");
           set_quadratic_drag(shot, k);
           shot.projectile.drag.k2 = k * shot.projectile.mass;
           return shot;
         },
     .compare =
         [](RowCheck& check, const Flight& flight) {
           const Sample apex = apex_of(flight), end = flight.end();
           check.compare("t_apex_s", apex.time);
           check.compare("x_apex_m", apex.position.x);
           check.compare("z_apex_m", apex.position.y);
           check.compare("t_impact_s", flight.duration());
           check.compare("range_m", end.position.x);
           check.compare("vx_impact", end.velocity.x, end.speed);
           check.compare("vz_impact", end.velocity.y, end.speed);
           check.compare("impact_angle_deg", std::atan2(end.velocity.y, end.velocity.x) / kDegree);
         }},
    {.file = "fall_exponential_atmosphere.csv",
     .columns = {"k0_1_m", "scale_height_m", "z_start_m", "z_m", "speed_m_s"},
     .parameters = {{"k0", "k0_1_m"}, {"H", "scale_height_m"}, {"from", "z_start_m"}, {"to", "z_m"}},
     .methods = in_exponential_air,
     .shot =
         [](const FigureRow& row) {
           ShotInPlace shot = shot_on_the_ground(row.file);
           set_quadratic_drag(shot, row.positive("k0_1_m"));
           shot.environment.atmosphere.scale_height = row.positive("scale_height_m");
           shot.drop_from({0, row.needed("z_start_m"), 0});
           shot.until.ground = row.needed("z_m");
           return shot;
         },
     .compare = [](RowCheck& check, const Flight& flight) { check.compare("speed_m_s", flight.end().speed); }},
    {.file = "bouncing_ball.csv", .columns = {"restitution", "bounce_index"}, .read = bouncing_ball},
    {.file = "coriolis_uniform_g.csv",
     .columns = {"case", "lat_deg", "t_s"},
     .parameters = {{"", "case"}, {"lat", "lat_deg"}, {"h/v0", "h_m_or_v0"}, {"elev", "elev_deg"}, {"az", "az_deg"}},
     .methods = with_coriolis,
     .shot =
         [](const FigureRow& row) {
           ShotInPlace shot = shot_on_the_ground(row.file);
           shot.environment.earth = {.latitude = row.needed("lat_deg") * kDegree,
                                     .azimuth = row.number("az_deg") * kDegree,
                                     .rotation_rate = row.file.constant("w", 7.292115e-5)};
           if (row.text("case") == "drop") {
             shot.drop_from({});
           } else {
             shot.launch.speed = row.needed("h_m_or_v0");
             shot.launch.elevation = row.needed("elev_deg") * kDegree;
           }
           shot.end_after(row.needed("t_s"));
           return shot;
         },
     .compare =
         [](RowCheck& check, const Flight& flight) {
           const double azimuth = check.row().number("az_deg") * kDegree;
           const Vec3d end = flight.end().position;
           check.compare("east_m", end.x * std::sin(azimuth) + end.z * std::cos(azimuth), length(end));
           check.compare("north_m", end.x * std::cos(azimuth) - end.z * std::sin(azimuth), length(end));
           check.compare("up_m", end.y, length(end));
         }},
    {.file = "magnus_constant_kappa.csv",
     .columns = {"kx_1_s", "ky_1_s", "kz_1_s", "t_s"},
     .parameters = {{"kx", "kx_1_s"}, {"ky", "ky_1_s"}, {"kz", "kz_1_s"}, {"t", "t_s"}},
     .methods = with_magnus,
     .shot =
         [](const FigureRow& row) {
           ShotInPlace shot = shot_on_the_ground(row.file);
           shot.launch.velocity = into_W(launch_velocity(row.file));
           spin_by(into_W({row.needed("kx_1_s"), row.needed("ky_1_s"), row.needed("kz_1_s")}), shot);
           shot.end_after(row.needed("t_s"));
           return shot;
         },
     .compare =
         [](RowCheck& check, const Flight& flight) {
           const Vec3d x = from_W(flight.end().position), v = from_W(flight.end().velocity);
           check.compare("x_m", x.x, length(x));
           check.compare("y_m", x.y, length(x));
           check.compare("z_m", x.z, length(x));
           check.compare("vx", v.x, length(v));
           check.compare("vy", v.y, length(v));
           check.compare("vz", v.z, length(v));
         }},
    {.file = "kepler_orbits.csv", .columns = {"a_m", "e", "t_s", "x_m", "y_m"}, .read = kepler_orbits},
    {.file = "newton_gravity_range.csv",
     .columns = {"v0_m_s", "elev_deg"},
     .parameters = {{"v0", "v0_m_s"}, {"elev", "elev_deg"}},
     .methods = on_the_sphere,
     .shot = [](const FigureRow& row) { return aimed(shot_around(row.file), row); },
     .compare =
         [](RowCheck& check, const Flight& flight) {
           const double radius = check.row().file.constant("R", kMeanRadius);
           const Vec3d end = flight.end().position, apex = apex_of(flight).position;
           check.compare("ground_range_m", radius * std::atan2(end.x, end.y + radius));
           check.compare("apex_height_m", std::hypot(apex.x, apex.y + radius) - radius);
           check.compare("t_flight_s", flight.duration());
         }},
    {.file = "radial_fall_newton.csv",
     .columns = {"h_m"},
     .parameters = {{"h", "h_m"}},
     .methods = on_the_sphere,
     .shot =
         [](const FigureRow& row) {
           ShotInPlace shot = shot_around(row.file);
           shot.drop_from({0, row.needed("h_m"), 0});
           return shot;
         },
     .compare =
         [](RowCheck& check, const Flight& flight) {
           check.compare("t_s", flight.duration());
           check.compare("v_impact_m_s", flight.end().speed);
         }},
    {.file = "torque_free_brick.csv", .columns = {"t_s", "p_deg_s", "q_deg_s", "r_deg_s"}, .read = torque_free_body},
};

constexpr auto kAnalyticFiles = [] {
  std::array<std::string_view, std::size(kCases)> files;
  std::ranges::transform(kCases, files.begin(), &Case::file);
  return files;
}();

void read(const Case& of, const CsvFile& file, SuiteResult& result) {
  for (const std::string_view column : of.columns)
    if (!column.empty()) file.require({column});
  if (of.read) return of.read(file, result);
  for (const CsvRow& each : file.rows()) {
    const FigureRow row{file, each};
    fly_row(row, label_of(row, of.parameters), of.methods(), of.shot(row), of.compare, result);
  }
}

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
    read(*found, file, result);
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
