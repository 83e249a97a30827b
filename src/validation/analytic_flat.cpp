// Analytic cases over flat ground: vacuum, linear and quadratic drag, exponential air, a bouncing ball.
#include <cmath>
#include <map>

#include "base/assert.hpp"
#include "physim/names.hpp"
#include "validation/analytic.hpp"

namespace physim::validation {
namespace {

constexpr EventSpec kApex = {.kind = EventKind::apex};
constexpr double kFlatAirDensity = 1.225;  // of the air in cases that give only k = rho Cd A / (2 m) [kg/m^3]

/// The shot of a row that gives speed and elevation; its apex is an event.
ShotInPlace aimed_shot(const CsvFile& file, const CsvRow& row) {
  ShotInPlace shot = shot_under(file.constant("g", kStandardGravity));
  shot.launch.speed = file.needed(row, "v0_m_s");
  shot.launch.elevation = file.needed(row, "elev_deg") * kDegree;
  shot.until.events = {kApex};
  return shot;
}

/// Air and a projectile with a drag deceleration of k v^2 at the origin.
void set_quadratic_drag(ShotInPlace& shot, double k) {
  DragDef& drag = shot.projectile.drag;
  drag.table = DragTable::constant;
  drag.coefficient = 0.5;
  const double area = 2.0 * k * shot.projectile.mass / (kFlatAirDensity * drag.coefficient);
  shot.projectile.diameter = 2.0 * std::sqrt(area / kPi);
  shot.environment.atmosphere.density = kFlatAirDensity;
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

void check_fall(const CsvFile& file, const CsvRow& row, ShotInPlace shot, SuiteResult& result) {
  shot.launch.velocity = Vec3d{};
  shot.until.ground = std::nullopt;
  shot.until.time = positive(file, row, "t_s");
  const std::string label = "fall " + label_of(file, row, {{"vt", "vt_m_s"}, {"t", "t_s"}});
  fly_row(file, row, label, quadratic_methods(), shot, result, [](RowCheck& check, const Flight& flight) {
    check.compare("speed_m_s", flight.end().speed);
    check.compare("distance_fallen_or_height_m", -flight.end().position.y);
  });
}

void check_ascent(const CsvFile& file, const CsvRow& row, ShotInPlace shot, SuiteResult& result) {
  const std::string& kind = file.text(row, "case");
  const double v0 = positive(file, row, "v0_up_m_s");
  shot.launch.velocity = Vec3d{0, v0, 0};
  shot.until.events = {kApex};
  const std::string label = kind + " " + label_of(file, row, {{"vt", "vt_m_s"}, {"v0", "v0_up_m_s"}});
  fly_row(file, row, label, quadratic_methods(), shot, result, [&](RowCheck& check, const Flight& flight) {
    if (kind == "ascent_apex") {
      const Sample apex = apex_of(flight);
      check.compare("t_s", apex.time);
      check.compare("speed_m_s", apex.speed, 1000 * v0);
      check.compare("distance_fallen_or_height_m", apex.position.y);
    } else {  // back on the ground
      check.compare("t_s", flight.duration());
      check.compare("speed_m_s", flight.end().speed);
    }
  });
}

// ------------------------------------------------------------------------------------------------- the bouncing ball

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

/// "dropped from 10 m"
double drop_height(const CsvFile& file) {
  return number_after(file.comments(), "dropped from").value_or(file.constant("h", 10.0));
}

}  // namespace

void vacuum_parabola(const CsvFile& file, SuiteResult& result) {
  file.require({"v0_m_s", "elev_deg"});
  for (const CsvRow& row : file.rows()) {
    const std::string label = label_of(file, row, {{"v0", "v0_m_s"}, {"elev", "elev_deg"}});
    const ShotInPlace shot = aimed_shot(file, row);
    fly_row(file, row, label, parabola_methods(), shot, result, [](RowCheck& check, const Flight& flight) {
      check.compare("t_flight_s", flight.duration());
      check.compare("range_m", flight.end().position.x);
      check.compare("apex_m", apex_of(flight).position.y);
    });
  }
}

void linear_drag(const CsvFile& file, SuiteResult& result) {
  file.require({"v0_m_s", "elev_deg", "k_1_s"});
  std::vector<Method> methods = closed_form_and_integrators();
  for (Method& method : methods) {
    method.fidelity.drag = DragModel::linear_quadratic;
    method.fidelity.air = AirModel::constant;
    method.fidelity.wind = WindModel::constant;
  }
  for (const CsvRow& row : file.rows()) {
    ShotInPlace shot = aimed_shot(file, row);
    shot.projectile.drag.k1 = positive(file, row, "k_1_s") * shot.projectile.mass;
    shot.environment.wind.velocity = {file.number(row, "wind_x_m_s").value_or(0), 0, 0};
    const std::string label =
        label_of(file, row, {{"v0", "v0_m_s"}, {"elev", "elev_deg"}, {"k", "k_1_s"}, {"wind", "wind_x_m_s"}});
    fly_row(file, row, label, methods, shot, result, [](RowCheck& check, const Flight& flight) {
      const Sample apex = apex_of(flight), end = flight.end(), half = flight.at(0.5 * flight.duration());
      check.compare("t_flight_s", flight.duration());
      check.compare("range_m", end.position.x);
      check.compare("t_apex_s", apex.time);
      check.compare("apex_m", apex.position.y);
      check.compare("x_half_m", half.position.x, length(half.position));
      check.compare("z_half_m", half.position.y, length(half.position));
      check.compare("vx_impact", end.velocity.x, end.speed);
      check.compare("vz_impact", end.velocity.y, end.speed);
    });
  }
}

void quadratic_vertical(const CsvFile& file, SuiteResult& result) {
  file.require({"case", "vt_m_s", "t_s"});
  const double g = file.constant("g", kStandardGravity);
  for (const CsvRow& row : file.rows()) {
    const std::string& kind = file.text(row, "case");
    if (kind != "fall" && !kind.starts_with("ascent")) {
      result.skipped.push_back(file.name() + ": no case \"" + kind + "\"");
      continue;
    }
    const double vt = positive(file, row, "vt_m_s");
    ShotInPlace shot = shot_under(g);
    set_quadratic_drag(shot, g / (vt * vt));
    shot.projectile.drag.k2 = shot.projectile.mass * g / (vt * vt);
    (kind == "fall" ? check_fall : check_ascent)(file, row, shot, result);
  }
}

void quadratic_2d(const CsvFile& file, SuiteResult& result) {
  file.require({"v0_m_s", "elev_deg", "k_1_m"});
  for (const CsvRow& row : file.rows()) {
    ShotInPlace shot = aimed_shot(file, row);
    const double k = positive(file, row, "k_1_m");
    set_quadratic_drag(shot, k);
    shot.projectile.drag.k2 = k * shot.projectile.mass;
    const std::string label = label_of(file, row, {{"v0", "v0_m_s"}, {"elev", "elev_deg"}, {"k", "k_1_m"}});
    fly_row(file, row, label, quadratic_methods(), shot, result, [](RowCheck& check, const Flight& flight) {
      const Sample apex = apex_of(flight), end = flight.end();
      check.compare("t_apex_s", apex.time);
      check.compare("x_apex_m", apex.position.x);
      check.compare("z_apex_m", apex.position.y);
      check.compare("t_impact_s", flight.duration());
      check.compare("range_m", end.position.x);
      check.compare("vx_impact", end.velocity.x, end.speed);
      check.compare("vz_impact", end.velocity.y, end.speed);
      check.compare("impact_angle_deg", std::atan2(end.velocity.y, end.velocity.x) / kDegree);
    });
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
    fly_row(file, row, label, integrators_in(AirModel::exponential), shot, result,
            [](RowCheck& check, const Flight& flight) { check.compare("speed_m_s", flight.end().speed); });
  }
}

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
                     bouncer.problem(), result);
      check.compare("t_contact_s", contact.time);
      check.compare("speed_before_contact_m_s", contact.speed, std::isinf(index) ? bouncer.contact(0).speed : 0);
    }
  }
}

}  // namespace physim::validation
