// Analytic cases over flat ground: vacuum, linear and quadratic drag, exponential air, a bouncing ball.
#include <algorithm>
#include <cmath>
#include <map>

#include "physim/names.hpp"
#include "validation/analytic.hpp"

namespace physim::validation {
namespace {

constexpr EventSpec kApex = {.kind = EventKind::apex};
constexpr double kDensity = 1.225;  // of the air in cases that give only k = rho Cd A / (2 m) [kg/m^3]

void aim(Launch& launch, const CsvFile& file, const CsvRow& row) {
  launch.speed = file.needed(row, "v0_m_s");
  launch.elevation = file.needed(row, "elev_deg") * kRadiansPerDegree;
}

/// Air and projectile whose drag deceleration is k v^2 at the origin.
void set_quadratic_drag(ShotInPlace& shot, double k) {
  DragDef& drag = shot.projectile.drag;
  drag.table = DragTable::constant;
  drag.coefficient = 0.5;
  const double area = 2.0 * k * shot.projectile.mass / (kDensity * drag.coefficient);
  shot.projectile.diameter = 2.0 * std::sqrt(area / 3.14159265358979323846);
  shot.environment.atmosphere.density = kDensity;
  shot.environment.atmosphere.sound_speed = 340.0;
}

/// The integrators, with the drag equation in air of a model.
std::vector<Method> integrators_in(AirModel air) {
  std::vector<Method> methods = integrators();
  for (Method& method : methods) {
    method.fidelity.drag = DragModel::equation;
    method.fidelity.air = air;
  }
  return methods;
}

/// The integrators in constant air, by the drag equation and by the constants k1, k2 in its place.
std::vector<Method> quadratic_methods() {
  std::vector<Method> methods = integrators_in(AirModel::constant);
  Method constants = methods.front();
  constants.name += " k1 k2";
  constants.fidelity.drag = DragModel::linear_quadratic;
  methods.push_back(constants);
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

double positive(const CsvFile& file, const CsvRow& row, const char* column) {
  const double value = file.needed(row, column);
  if (value <= 0) file.fail(row, std::string("column \"") + column + "\" needs a number above 0");
  return value;
}

}  // namespace

void vacuum_parabola(const CsvFile& file, SuiteResult& result) {
  file.require({"v0_m_s", "elev_deg"});
  for (const CsvRow& row : file.rows()) {
    ShotInPlace shot = shot_under(file.constant("g", kStandardGravity));
    aim(shot.launch, file, row);
    shot.until.events = {kApex};
    for (const Method& method : parabola_methods()) {
      RowCheck check(file, row, method, label_of(file, row, {{"v0", "v0_m_s"}, {"elev", "elev_deg"}}), result);
      const Flight flight = shot.fly(method);
      check.blame(complaint(flight, method.fidelity));
      const auto apex = first_event(flight, EventKind::apex);
      check.compare("t_flight_s", flight.duration());
      check.compare("range_m", flight.end().position.x);
      check.compare("apex_m", apex ? apex->position.y : kNaN);
    }
  }
}

void linear_drag(const CsvFile& file, SuiteResult& result) {
  file.require({"v0_m_s", "elev_deg", "k_1_s"});
  for (const CsvRow& row : file.rows()) {
    ShotInPlace shot = shot_under(file.constant("g", kStandardGravity));
    aim(shot.launch, file, row);
    shot.projectile.drag.k1 = positive(file, row, "k_1_s") * shot.projectile.mass;
    shot.environment.wind.velocity = {file.number(row, "wind_x_m_s").value_or(0), 0, 0};
    shot.until.events = {kApex};
    const std::string label =
        label_of(file, row, {{"v0", "v0_m_s"}, {"elev", "elev_deg"}, {"k", "k_1_s"}, {"wind", "wind_x_m_s"}});
    for (Method method : closed_form_and_integrators()) {
      method.fidelity.drag = DragModel::linear_quadratic;
      method.fidelity.air = AirModel::constant;
      method.fidelity.wind = WindModel::constant;
      RowCheck check(file, row, method, label, result);
      const Flight flight = shot.fly(method);
      check.blame(complaint(flight, method.fidelity));
      const auto apex = first_event(flight, EventKind::apex);
      const Sample end = flight.end();
      const Sample half = flight.at(0.5 * flight.duration());
      check.compare("t_flight_s", flight.duration());
      check.compare("range_m", end.position.x);
      check.compare("t_apex_s", apex ? apex->time : kNaN);
      check.compare("apex_m", apex ? apex->position.y : kNaN);
      check.compare("x_half_m", half.position.x, length(half.position));
      check.compare("z_half_m", half.position.y, length(half.position));
      check.compare("vx_impact", end.velocity.x, end.speed);
      check.compare("vz_impact", end.velocity.y, end.speed);
    }
  }
}

namespace {

void check_fall(const CsvFile& file, const CsvRow& row, RowCheck& check, const ShotInPlace& shot,
                const Method& method) {
  ShotInPlace fall = shot;
  fall.launch.velocity = Vec3d{};
  fall.until.ground = std::nullopt;
  fall.until.time = positive(file, row, "t_s");
  const Flight flight = fall.fly(method);
  check.blame(complaint(flight, method.fidelity));
  check.compare("speed_m_s", flight.end().speed);
  check.compare("distance_fallen_or_height_m", -flight.end().position.y);
}

void check_ascent(const CsvFile& file, const CsvRow& row, RowCheck& check, const ShotInPlace& shot,
                  const Method& method) {
  ShotInPlace ascent = shot;
  const double v0 = positive(file, row, "v0_up_m_s");
  ascent.launch.velocity = Vec3d{0, v0, 0};
  ascent.until.events = {kApex};
  const Flight flight = ascent.fly(method);
  check.blame(complaint(flight, method.fidelity));
  const auto apex = first_event(flight, EventKind::apex);
  if (file.text(row, "case") == "ascent_apex") {
    check.compare("t_s", apex ? apex->time : kNaN);
    check.compare("speed_m_s", apex ? length(apex->velocity) : kNaN, 1000 * v0);
    check.compare("distance_fallen_or_height_m", apex ? apex->position.y : kNaN);
  } else {  // back on the ground
    check.compare("t_s", flight.duration());
    check.compare("speed_m_s", flight.end().speed);
  }
}

}  // namespace

void quadratic_vertical(const CsvFile& file, SuiteResult& result) {
  file.require({"case", "vt_m_s", "t_s"});
  const double g = file.constant("g", kStandardGravity);
  for (const CsvRow& row : file.rows()) {
    const std::string& kind = file.text(row, "case");
    const bool falls = kind == "fall";
    if (!falls && !kind.starts_with("ascent")) {
      result.skipped.push_back(file.name() + ": no case \"" + kind + "\"");
      continue;
    }
    const double vt = positive(file, row, "vt_m_s");
    ShotInPlace shot = shot_under(g);
    set_quadratic_drag(shot, g / (vt * vt));
    shot.projectile.drag.k2 = shot.projectile.mass * g / (vt * vt);
    const std::string label = falls ? kind + " " + label_of(file, row, {{"vt", "vt_m_s"}, {"t", "t_s"}})
                                    : kind + " " + label_of(file, row, {{"vt", "vt_m_s"}, {"v0", "v0_up_m_s"}});
    for (const Method& method : quadratic_methods()) {
      RowCheck check(file, row, method, label, result);
      if (falls)
        check_fall(file, row, check, shot, method);
      else
        check_ascent(file, row, check, shot, method);
    }
  }
}

void quadratic_2d(const CsvFile& file, SuiteResult& result) {
  file.require({"v0_m_s", "elev_deg", "k_1_m"});
  for (const CsvRow& row : file.rows()) {
    ShotInPlace shot = shot_under(file.constant("g", kStandardGravity));
    aim(shot.launch, file, row);
    const double k = positive(file, row, "k_1_m");
    set_quadratic_drag(shot, k);
    shot.projectile.drag.k2 = k * shot.projectile.mass;
    shot.until.events = {kApex};
    const std::string label = label_of(file, row, {{"v0", "v0_m_s"}, {"elev", "elev_deg"}, {"k", "k_1_m"}});
    for (const Method& method : quadratic_methods()) {
      RowCheck check(file, row, method, label, result);
      const Flight flight = shot.fly(method);
      check.blame(complaint(flight, method.fidelity));
      const auto apex = first_event(flight, EventKind::apex);
      const Sample end = flight.end();
      check.compare("t_apex_s", apex ? apex->time : kNaN);
      check.compare("x_apex_m", apex ? apex->position.x : kNaN);
      check.compare("z_apex_m", apex ? apex->position.y : kNaN);
      check.compare("t_impact_s", flight.duration());
      check.compare("range_m", end.position.x);
      check.compare("vx_impact", end.velocity.x, end.speed);
      check.compare("vz_impact", end.velocity.y, end.speed);
      check.compare("impact_angle_deg", std::atan2(end.velocity.y, end.velocity.x) / kRadiansPerDegree);
    }
  }
}

void fall_exponential(const CsvFile& file, SuiteResult& result) {
  file.require({"k0_1_m", "scale_height_m", "z_start_m", "z_m", "speed_m_s"});
  for (const CsvRow& row : file.rows()) {
    ShotInPlace shot = shot_under(file.constant("g", kStandardGravity));
    set_quadratic_drag(shot, positive(file, row, "k0_1_m"));
    shot.environment.atmosphere.scale_height = positive(file, row, "scale_height_m");
    shot.launch.position = {0, file.needed(row, "z_start_m"), 0};
    shot.launch.velocity = Vec3d{};
    shot.until.ground = file.needed(row, "z_m");
    const std::string label =
        label_of(file, row, {{"k0", "k0_1_m"}, {"H", "scale_height_m"}, {"from", "z_start_m"}, {"to", "z_m"}});
    for (const Method& method : integrators_in(AirModel::exponential)) {
      RowCheck check(file, row, method, label, result);
      const Flight flight = shot.fly(method);
      check.blame(complaint(flight, method.fidelity));
      check.compare("speed_m_s", flight.end().speed);
    }
  }
}

// ------------------------------------------------------------------------------------------------- the bouncing ball
namespace {

struct Contact {
  double time = 0;   // since the drop [s]
  double speed = 0;  // before the contact [m/s]
};

/// Drops a ball and lets it bounce: a chain of flights, each from the ground to the ground.
class Bouncer {
 public:
  Bouncer(double height, double gravity, double restitution, const Method& method)
      : method_(method), restitution_(restitution), shot_(shot_under(gravity)) {
    shot_.launch.position = {0, height, 0};
    shot_.launch.velocity = Vec3d{};
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

/// "dropped from 10 m"
double drop_height(const CsvFile& file) {
  const std::string key = "dropped from ";
  const auto at = file.comments().find(key);
  if (at == std::string::npos) return file.constant("h", 10.0);
  const auto first = at + key.size();
  const auto last = file.comments().find_first_not_of("0123456789.", first);
  return parse_number(file.comments().substr(first, last - first)).value_or(10.0);
}

}  // namespace

void bouncing_ball(const CsvFile& file, SuiteResult& result) {
  file.require({"restitution", "bounce_index"});
  const double g = file.constant("g", kStandardGravity);
  const double height = drop_height(file);
  for (const Method& method : closed_form_and_integrators()) {
    std::map<double, Bouncer> bouncers;  // by restitution
    for (const CsvRow& row : file.rows()) {
      const double restitution = positive(file, row, "restitution");
      if (restitution >= 1) file.fail(row, "column \"restitution\" needs a number below 1");
      const double index = file.number(row, "bounce_index").value_or(kNaN);
      if (!(index >= 0) || (std::isfinite(index) && index > 10000))
        file.fail(row, "column \"bounce_index\" needs the number of a bounce, or inf");
      Bouncer& bouncer = bouncers.try_emplace(restitution, height, g, restitution, method).first->second;
      const Contact contact = std::isinf(index) ? bouncer.limit() : bouncer.contact(static_cast<std::size_t>(index));
      RowCheck check(file, row, method, label_of(file, row, {{"e", "restitution"}, {"bounce", "bounce_index"}}),
                     result);
      check.blame(bouncer.problem());
      check.compare("t_contact_s", contact.time);
      check.compare("speed_before_contact_m_s", contact.speed, std::isinf(index) ? bouncer.contact(0).speed : 0);
    }
  }
}

}  // namespace physim::validation
