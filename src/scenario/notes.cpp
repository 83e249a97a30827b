
#include <algorithm>
#include <cmath>
#include <map>
#include <set>

#include "emit/emission.hpp"
#include "math/angles.hpp"
#include "math/elementary.hpp"
#include "model/sight.hpp"
#include "physim/names.hpp"
#include "scenario/checks.hpp"
#include "scenario/expectation.hpp"
#include "scenario/suggest.hpp"
#include "scenario/units.hpp"
#include "scenario/unread.hpp"

namespace physim {
namespace {

class Notes {
 public:
  Notes(Scenario& scenario, const Value& document) : scenario_(scenario), document_(document) {}

  void add_all() {
    for (const UnreadSetting& unread : unread_settings(scenario_, document_))
      scenario_.notes.push_back(unread.place + ": " + unread.path + ": has no effect" + unread.why);
    of_environment();
    for (std::size_t i = 0; i < scenario_.shots.size(); ++i) of_shot(scenario_.shots[i], element(document_, "shot", i));
    for (const JointRemark& remark : joint_remarks(scenario_))
      note(element(document_, "joint", remark.joint), "joint", remark.key, remark.what);
    for (std::size_t i = 0; i < scenario_.emitters.size(); ++i)
      of_emitter(scenario_.emitters[i], element(document_, "emitter", i));
    if (scenario_.world.given) of_end();
    for (std::size_t i = 0; i < scenario_.shapes.size(); ++i)
      of_shape(scenario_.shapes[i], element(document_, "shape", i));
    for (std::size_t i = 0; i < scenario_.expect.size(); ++i)
      of_expectation(scenario_.expect[i], element(document_, "expect", i));
  }

 private:
  /// `path`: in a table whose own path is `head`.
  void note(const Value& table, const std::string& head, const std::string& path, const std::string& what) {
    const char* const dot = head.empty() || path.empty() ? "" : ".";
    scenario_.notes.push_back(place_of(table, path) + ": " + head + dot + path + ": " + what);
  }

  // ----------------------------------------------------------------------------------------------------- unlikely
  /// A number that lies outside of what is usual, if it is given.
  void unusual(const Value& table, const std::string& head, const std::string& path, const std::string& value,
               const std::string& usual) {
    if (follow(table, path).is_there) note(table, head, path, value + " is unusual; " + usual);
  }

  void of_environment() {
    const Environment& e = scenario_.environment;
    constexpr double kMostGravity = 9.9, kLeastGravity = 9.7;  // of the Earth [m/s^2]
    const bool on_earth = e.gravity.model != GravityModel::off && e.gravity.acceleration > kLeastGravity &&
                          e.gravity.acceleration < kMostGravity;
    const double pressure = e.atmosphere.pressure.value_or(101325), altitude = e.altitude;
    if (on_earth && (pressure < 1e4 || pressure > 1.2e5))
      unusual(document_, "", "environment.atmosphere.pressure", quantity_in_words(pressure, Quantity::pressure),
              "air on the ground has 50 to 108 kPa, as \"1013 hPa\"");
    else if (on_earth)
      of_station(pressure, altitude);
    if (!e.atmosphere.profile.empty() && e.atmosphere.profile[0].pressure) {
      const AirPoint& first = e.atmosphere.profile[0];
      const Result<AirSample> standard = air_at({}, first.altitude);
      const double part = standard ? *first.pressure / standard->pressure : 1;
      if (on_earth && (part < 0.7 || part > 1.3))
        unusual(document_, "", "environment.atmosphere.profile",
                "a pressure of " + quantity_in_words(*first.pressure, Quantity::pressure) + " at " +
                    quantity_in_words(first.altitude, Quantity::length),
                "the standard has " + quantity_in_words(standard->pressure, Quantity::pressure) + " there");
    }
    if (altitude < -5e3 || altitude > 1e6)
      unusual(document_, "", "environment.altitude", quantity_in_words(altitude, Quantity::length),
              "it is a height above the sea, from -400 m to 1000 km");
    if (const double relative = scenario_.tolerance.relative.value_or(0); relative > 1e-2)
      unusual(document_, "", "tolerance.relative", number_text(relative), "errors of a step are from 1e-12 to 1e-4");
  }

  /// A pressure that the standard's share of it at the station takes to the sea beyond the records there.
  void of_station(double pressure, double altitude) {
    constexpr double kHighest = 5000;                 // no ground where people live is higher [m]
    constexpr double kLeast = 87000, kMost = 108500;  // Typhoon Tip 1979, Tosontsengel 2001 (WMO) [Pa]
    const Result<AirSample> standard = air_at({}, altitude);
    if (!standard || altitude > kHighest) return;
    const double at_sea = pressure / standard->pressure * 101325;
    if (at_sea >= kLeast && at_sea <= kMost) return;
    unusual(document_, "", "environment.atmosphere.pressure",
            quantity_text(pressure, Quantity::pressure) + " at " + quantity_text(altitude, Quantity::length),
            "it is that of the station, not reduced to the sea; the standard has " +
                quantity_text(standard->pressure, Quantity::pressure) + " there");
  }

  void of_shot(const ScenarioShot& shot, const Value& table) {
    const bool is_world = scenario_.world.given;
    if (!is_world || !emitter_alone_of(scenario_, shot.projectile.name)) of_ground(shot, table);
    if (is_world && !emitter_alone_of(scenario_, shot.projectile.name)) of_beginning(shot, table);
    of_numbers(shot, table);
    of_sight(shot, table);
    of_drag(shot.projectile, table);
    of_ignition(shot, table);
    of_motor(shot, table);
  }

  static std::string begins_below(double height) {
    return "it begins at a height of " + quantity_in_words(height, Quantity::length) + ", below ";
  }

  /// Adds a note if a shot begins below the ground that ends its flight. The ground stops what sinks.
  void of_ground(const ScenarioShot& shot, const Value& table) {
    const Ground& ground = scenario_.world.def.ground;
    const bool is_world = scenario_.world.given,
               ends = ground.mode == GroundMode::land || ground.mode == GroundMode::stick;
    const std::optional<double> level = !is_world ? scenario_.until.ground
                                        : ends    ? std::optional(ground.height)
                                                  : std::nullopt;
    const Launch& launch = shot.launch;
    if (!level || !(launch.position.y < *level)) return;
    const double climb = launch.velocity ? launch.velocity->y : launch.speed * sincos(launch.elevation).sin;
    const bool may_rise = launch.sight.zero_range > 0 || !shot.projectile.motor.thrust.empty();
    std::string what = "and has landed there";
    if (climb > 0) what = "and rises through it; it lands where it sinks to the ground or below it";
    if (!(climb > 0) && may_rise) what = "and lands at once unless it rises";
    note(table, "shot", "",
         begins_below(launch.position.y) + (is_world ? "world.ground.height = " : "until.ground = ") +
             quantity_in_words(*level, Quantity::length) + ", " + what);
  }

  /// Adds a note if a shot of a world ends at once by a rule of despawning.
  void of_beginning(const ScenarioShot& shot, const Value& table) {
    const DespawnRules& rules = shot.body.despawn;
    const double height = shot.launch.position.y, speed = launch_speed(shot.launch);
    if (height < rules.below)
      note(table, "shot", "",
           begins_below(height) + "shot.body.despawn.below = " + quantity_in_words(rules.below, Quantity::length) +
               ", and leaves at once");
    if (speed < rules.slower)
      note(table, "shot", "",
           "it begins with " + quantity_in_words(speed, Quantity::speed) + ", below shot.body.despawn.slower = " +
               quantity_in_words(rules.slower, Quantity::speed) + ", and leaves unless it speeds up at once");
  }

  /// Adds a note if the thrust never exceeds the weight along the rail, even at the mass after burnout.
  void of_motor(const ScenarioShot& shot, const Value& table) {
    const MotorDef& motor = shot.projectile.motor;
    const Gravity& gravity = scenario_.environment.gravity;
    if (motor.thrust.empty() || launch_speed(shot.launch) > 0 || gravity.model == GravityModel::off) return;
    if (shot.projectile.fidelity.gravity == GravityModel::off || shot.launch.position.y > 0) return;
    const double most = std::ranges::max_element(motor.thrust, {}, &ThrustPoint::force)->force;
    const double weight = (shot.projectile.mass - motor.propellant_mass) * gravity.acceleration;
    const double held = weight * sincos(shot.launch.elevation).sin;
    if (most < held)
      note(table, "shot", "motor",
           "its thrust never exceeds the weight along the rail: " + quantity_in_words(most, Quantity::force) + " of " +
               quantity_in_words(held, Quantity::force) + "; the rocket stays where it is");
  }

  /// Adds a note if the run ends before a motor burns.
  void of_ignition(const ScenarioShot& shot, const Value& table) {
    const MotorDef& motor = shot.projectile.motor;
    const bool is_world = scenario_.world.given;
    const double end = is_world ? scenario_.world.duration : scenario_.until.time;
    double launched = kInfinity;  // for the first time
    for (const Volley& volley : scenario_.volleys)
      if (volley.shot == shot.projectile.name) launched = std::min(launched, volley.start);
    if (!std::isfinite(launched)) launched = 0;
    if (motor.thrust.empty() || launched + motor.ignition_delay < end) return;
    note(table, "shot", "motor.ignition_delay",
         quantity_in_words(motor.ignition_delay, Quantity::time) + ", and " +
             (is_world ? "world.duration" : "until.time") + " = " + quantity_in_words(end, Quantity::time) +
             ": the motor never burns");
  }

  /// Adds notes on what is due when the run has ended.
  void of_end() {
    for (std::size_t i = 0; i < scenario_.volleys.size(); ++i)
      if (const double start = scenario_.volleys[i].start; start >= scenario_.world.duration)
        too_late(element(document_, "volley", i), "volley", "start", quantity_in_words(start, Quantity::time),
                 "it never fires");
    const std::set<std::string_view> firing = emitters_that_fire();
    for (std::size_t i = 0; i < scenario_.emitters.size(); ++i) {
      const EmitterDef& def = scenario_.emitters[i].def;
      const Value& table = element(document_, "emitter", i);
      if (firing.count(def.name) > 0)
        of_births(def, table);
      else
        note(table, "emitter", "",
             std::string("nothing fires it: it ") +
                 (has_own_fire(def) ? "does not play" : "has no rate, burst, gun or rain") +
                 ", and is the sub of no emitter that fires");
    }
    for (std::size_t i = 0; i < scenario_.forces.size(); ++i)
      if (const double delay = scenario_.forces[i].delay; delay >= scenario_.world.duration)
        too_late(element(document_, "force", i), "force", "delay", quantity_in_words(delay, Quantity::time),
                 "it never acts");
  }
  /// Names of emitters that fire by themselves, and of their subs.
  [[nodiscard]] std::set<std::string_view> emitters_that_fire() const {
    std::map<std::string_view, const ScenarioEmitter*> by_name;
    std::vector<const ScenarioEmitter*> firing;
    for (const ScenarioEmitter& emitter : scenario_.emitters) {
      by_name[emitter.def.name] = &emitter;
      if (emitter.def.cycle.plays && has_own_fire(emitter.def)) firing.push_back(&emitter);
    }
    std::set<std::string_view> names;
    while (!firing.empty()) {
      const ScenarioEmitter& next = *firing.back();
      firing.pop_back();
      if (!names.insert(next.def.name).second) continue;
      for (const ScenarioSub& sub : next.subs)
        if (const auto found = by_name.find(sub.emitter); found != by_name.end()) firing.push_back(found->second);
    }
    return names;
  }
  void too_late(const Value& table, const std::string& head, const std::string& path, const std::string& due,
                const std::string& so) {
    note(table, head, path,
         due + ", and world.duration = " + quantity_in_words(scenario_.world.duration, Quantity::time) + ": " + so);
  }
  void of_births(const EmitterDef& def, const Value& table) {
    const EmitterCycle& cycle = def.cycle;
    if (!cycle.plays || cycle.prewarm) return;
    const double least = std::min(cycle.delay.value, cycle.delay.to.value_or(kInfinity));
    const double end = scenario_.world.duration, delay = std::min(least, least / cycle.rate);
    if (delay >= end && def.bursts.empty())
      return too_late(table, "emitter", "cycle.delay", quantity_in_words(delay, Quantity::time), "it fires nothing");
    for (std::size_t i = 0; i < def.bursts.size(); ++i) {
      const double time = def.bursts[i].time, due = delay + time / cycle.rate;
      if (due > end && time < cycle.duration)
        too_late(table, "emitter", "bursts",
                 "burst " + std::to_string(i + 1) + " is due at " + quantity_in_words(due, Quantity::time),
                 "it never comes");
    }
  }

  void of_sight(const ScenarioShot& shot, const Value& table) {
    constexpr double kHighest = 1;  // above a bore [m]
    const double height = shot.launch.sight.height;
    if (std::abs(height) > kHighest)
      unusual(table, "shot", "sight.height", quantity_in_words(height, Quantity::length),
              "sights of rifles stand 3 to 10 cm above the bore, as \"1.5 in\"");
  }

  /// Adds a note for each ballistic coefficient that mass and diameter cannot give.
  void of_drag(const ProjectileDef& p, const Value& table) {
    if (!(p.diameter > 0) || !follow(table, "drag").is_there) return;
    const double sectional_density = p.mass / (p.diameter * p.diameter);
    const auto judge = [&](const std::string& path, double coefficient) {
      constexpr double kHigh = 1406, kLeastFactor = 0.3, kMostFactor = 30;  // 2 lb/in^2 [kg/m^2]; of shapes [-]
      const double factor = sectional_density / coefficient;
      if ((coefficient > kHigh && factor < kLeastFactor) || factor > kMostFactor)
        unusual(table, "shot", path, quantity_in_words(coefficient, Quantity::ballistic_coefficient),
                "with this mass and diameter the form factor is " + number_text(std::round(1e4 * factor) / 1e4) +
                    ", and bullets have 0.8 to 2; as \"0.223 lb/in^2\"");
    };
    if (p.drag.ballistic_coefficient > 0) judge("drag.ballistic_coefficient", p.drag.ballistic_coefficient);
    for (const BallisticBand& band : p.drag.bands) judge("drag.bands", band.ballistic_coefficient);
  }

  void of_numbers(const ScenarioShot& shot, const Value& table) {
    const ProjectileDef& p = shot.projectile;
    constexpr double kFastest = 1e5;  // of what Newton's mechanics and drag tables are for [m/s]
    constexpr double kFastestBullet = 2000, kWidestBullet = 0.02;  // [m/s], [m]
    const bool has_curve_of_bullets = p.drag.ballistic_coefficient > 0 || !p.drag.bands.empty() || p.twist != 0;
    const bool is_bullet = has_curve_of_bullets && p.diameter < kWidestBullet;
    for (const char* key : {"speed", "velocity"}) {
      const double speed = shot.launch.velocity ? length(*shot.launch.velocity) : shot.launch.speed;
      if (speed > kFastest)
        unusual(table, "shot", key, quantity_in_words(speed, Quantity::speed),
                "guns reach 3 km/s and meteors 72 km/s, and there is no relativity here");
      else if (speed > kFastestBullet && is_bullet)
        unusual(table, "shot", key, quantity_in_words(speed, Quantity::speed),
                "bullets of rifles have 300 to 1400 m/s, as \"2600 ft/s\"");
    }
    // A cylinder of lead of this mass and diameter would be so many calibres long.
    constexpr double kLead = 11340, kLongest = 60;
    const double calibres = p.mass / (kLead * 0.25 * kPi * p.diameter * p.diameter * p.diameter);
    if (p.diameter > 0 && calibres > kLongest && follow(table, "diameter").is_there)
      unusual(table, "shot", "mass", quantity_in_words(p.mass, Quantity::mass),
              "with this diameter it is a rod of lead " + number_text(std::round(calibres)) + " calibres long");
    const auto stability = stability_factor(p, shot.launch, scenario_.environment);
    if (stability && (*stability < 1 || *stability > 20))
      unusual(table, "shot", "twist", quantity_in_words(p.twist, Quantity::length),
              "it gives a stability factor of " + number_text(std::round(100 * *stability) / 100) +
                  ", and bullets that fly straight have 1.3 to 5");
  }

  /// Adds a note if an emitter has more particles in a step than the limit, at which it stops.
  void of_emitter(const ScenarioEmitter& emitter, const Value& table) {
    const EmitterDef& def = emitter.def;
    const auto most_of = [](const DrawnNumber& number) {
      const auto top = [](double value, const Curve& curve) {
        double largest = curve.empty() ? 1 : 0;
        for (const CurveKey& key : curve) largest = std::max(largest, key.value);
        return value * largest;
      };
      const Curve& to_curve = number.to_curve.empty() ? number.curve : number.to_curve;
      return std::max(top(number.value, number.curve), number.to ? top(*number.to, to_curve) : 0);
    };
    const std::string limit = "an emitter lets out " + number_text(kMostBirthsInStep) + " at most in a step";
    const double rate = most_of(def.per_second), in_step = rate * def.cycle.rate * scenario_.world.def.step;
    if (in_step > kMostBirthsInStep)
      note(table, "emitter", "per_second",
           number_text(rate) + " a second are " + number_text(std::ceil(in_step)) + " in a step; " + limit +
               " and stops where there are more");
    for (std::size_t i = 0; i < def.bursts.size(); ++i)
      if (const double count = most_of(def.bursts[i].count); count > kMostBirthsInStep)
        note(table, "emitter", "bursts", "a burst of " + number_text(count) + "; " + limit + " and stops");
    const double past = rate * def.cycle.duration;
    const bool is_flown =
        !emitter.subs.empty() || !def.bursts.empty() || def.per_second.to || !def.per_second.curve.empty();
    if (def.cycle.prewarm && is_flown && past > kMostBirthsOfPast)
      note(table, "emitter", "cycle.prewarm",
           "one cycle has " + number_text(past) + " particles; more than " + number_text(kMostBirthsOfPast) +
               " of the past are not flown");
  }

  /// Whether a shot is of those that an expectation asks about: by its own name, or by a volley or an emitter.
  [[nodiscard]] bool is_asked_about(const ScenarioShot& shot, const std::string& group) const {
    const std::string& name = shot.projectile.name;
    const auto fires = [&](const auto& each) { return each.name == group && each.shot == name; };
    const auto emits = [&](const ScenarioEmitter& each) { return each.def.name == group && each.shot == name; };
    return group.empty() || group == name || std::ranges::any_of(scenario_.volleys, fires) ||
           std::ranges::any_of(scenario_.emitters, emits);
  }

  /// Adds a note if an expectation asks for hits on what is only passed: there is none.
  void of_expectation(const Expectation& expect, const Value& table) {
    const Figure* figure = find_figure(expect.quantity);
    PHYSIM_ASSERT(figure != nullptr);  // the reader knows no others
    if (expect.thing.empty() || figure->of_hits == nullptr) return;
    const bool is_sensor = std::ranges::all_of(
        scenario_.things, [&](const ScenarioThing& thing) { return thing.name != expect.thing || thing.sensor; });
    const bool passes = std::ranges::all_of(scenario_.shots, [&](const ScenarioShot& shot) {
      return !is_asked_about(shot, expect.shot) || shot.body.collision.on_hit == OnHit::pass;
    });
    if (!is_sensor && !passes) return;
    note(table, "expect", "quantity",
         in_quotes(expect.quantity) + " is of hits, and " +
             (is_sensor ? "the sensor " + in_quotes(expect.thing) + " is passed without one"
                        : "shots with on_hit = \"pass\" have none") +
             ": \"passages\" counts ways into it");
  }

  void of_shape(const ScenarioShape& shape, const Value& table) {
    if (shape.impossible > 0)
      note(table, "shape", "mesh.missing",
           "it replaces a height of " + quantity_in_words(shape.impossible_height, Quantity::length) +
               ", which no ground has" +
               (shape.impossible == 1 ? "" : ", and " + std::to_string(shape.impossible - 1) + " more such heights"));
    if (std::isfinite(shape.reached))
      note(table, "shape", "mesh.reach",
           quantity_in_words(shape.cut.reach, Quantity::length) + ", and on one side the file ends " +
               quantity_in_words(std::round(shape.reached), Quantity::length) +
               " from environment.earth.latitude and longitude; there is no ground beyond");
    const bool is_picture = std::holds_alternative<HeightFieldShape>(shape.shape) && !shape.file.empty();
    if (is_picture && shape.low >= shape.high)
      note(table, "shape", "height_field.low",
           quantity_in_words(shape.low, Quantity::length) +
               " is not below shape.height_field.high = " + quantity_in_words(shape.high, Quantity::length) + ": " +
               (shape.low == shape.high ? "the field is flat" : "black is high ground and white is low"));
  }

  Scenario& scenario_;
  const Value& document_;
};

}  // namespace

void add_notes(Scenario& scenario, const Value& document) { Notes(scenario, document).add_all(); }

}  // namespace physim
