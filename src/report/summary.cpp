#include "report/summary.hpp"

#include <algorithm>
#include <cmath>
#include <cstdlib>

#include "base/assert.hpp"
#include "base/event_table.hpp"
#include "math/angles.hpp"
#include "model/earth.hpp"
#include "physim/names.hpp"
#include "report/fidelity_text.hpp"
#include "report/number.hpp"
#include "report/table.hpp"
#include "report/world_hits.hpp"
#include "scenario/units.hpp"

namespace physim::report {
namespace {

constexpr int kIndent = 2;

// A line of the summary: its subject in a column of its own.
std::string line(const std::string& subject, const std::string& text) {
  constexpr std::size_t kSubject = 15;
  return "  " + subject + std::string(kSubject - std::min(kSubject - 1, display_width(subject)), ' ') + text + "\n";
}

// The correction that brings the shot back to the line of sight [mil = mrad].
std::string hold(double offset, double range) { return range > 0 ? fixed(-std::atan2(offset, range) * 1e3, 2) : "-"; }

// A time [s] of a flight; four decimals, more for a flight that lasts no longer than those show.
std::string time_text(double time, const Flight& flight) {
  const double duration = flight.duration();
  const int needed = duration > 0 ? 4 - static_cast<int>(std::floor(std::log10(duration))) : 0;
  return fixed(time, std::clamp(needed, 4, 12));
}

std::string range_card(const FlownShot& flown, const std::vector<double>& ranges) {
  const bool with_drop = has_sight(flown.shot->launch);
  const bool with_holds = flown.shot->launch.sight.zero_range > 0;
  std::vector<std::string> columns = {"range [m]", with_drop ? "drop [m]" : "height [m]", "windage [m]"};
  if (with_holds) columns.insert(columns.end(), {"hold up [mil]", "hold right [mil]"});
  columns.insert(columns.end(), {"time [s]", "speed [m/s]", "mach [-]", "energy [J]"});
  Table table(columns);
  for (const double range : ranges) {
    const Result<Sample> found = flown.flight.at_range(range);
    if (!found) {
      table.add_row({as_typed(range), not_reached(flown.flight, range)});
      continue;
    }
    const Sample& s = *found;
    std::vector<std::string> row = {as_typed(range), fixed(with_drop ? s.drop : s.position.y, 3), fixed(s.windage, 3)};
    if (with_holds) row.insert(row.end(), {hold(s.drop, range), hold(s.windage, range)});
    row.insert(row.end(), {time_text(s.time, flown.flight), fixed(s.speed, 2), fixed(s.mach, 3), sized(s.energy, 4)});
    table.add_row(std::move(row));
  }
  return table.empty() ? "" : "\n" + table.text(kIndent) + "\n";
}

// Where it is; over a round Earth along its ground, as the tangent plane's height there says little.
std::string place_text(const Flight& flight, const Vec3d& position, double downrange) {
  if (!is_round(flight.fidelity_in_use().fidelity.earth))
    return readable(downrange, 6) + " m downrange, height " + readable(position.y, 5) + " m";
  const EarthFrames frames = flight.earth_frames();
  const double distance = frames.ground_distance(flight.at(0).position, position);
  return readable(downrange < 0 ? -distance : distance, 6) + " m along the ground, altitude " +
         readable(frames.geodetic(position).height, 5) + " m";
}

std::string end_text(const Flight& flight) {
  const Sample s = flight.end();
  const double horizontal = std::hypot(s.velocity.x, s.velocity.z);
  const double angle = std::atan2(s.velocity.y, horizontal) / kDegree;
  const std::string speed = readable(s.speed, 5);
  std::string text = time_text(s.time, flight) + " s: " + place_text(flight, s.position, s.range) + ", windage " +
                     readable(s.windage, 4) + " m; " + speed + " m/s";
  if (s.mach > 0) text += " (Mach " + fixed(s.mach, 3) + ")";
  text += ", " + (speed == "0" ? readable(s.energy, 4) : sized(s.energy, 4)) + " J";
  if (speed == "0") return text;  // a direction would be that of a rounding
  return text + ", " + fixed(std::abs(angle), 2) + " deg " + (angle < 0 ? "down" : "up");
}

// How a rigid body is stable at the muzzle and at the end, and how far it points off its path there.
std::string stability_in_flight(const Flight& flight) {
  std::string text;
  for (const double time : {0.0, flight.duration()}) {
    if (const auto s = flight.stability(time))
      text += "Sg " + significant(s->gyroscopic, 4) + ", Sd " + significant(s->dynamic, 4) + ", ";
    text += "yaw " + fixed(flight.at(time).angle_of_attack / kDegree, 3) + " deg";
    text += time == 0 ? " at the muzzle; " : " at the end";
    if (flight.duration() == 0) break;
  }
  return text;
}

std::string motor_text(const MotorDef& motor) {
  const std::string named = motor.name.empty() ? "" : one_line(motor.name) + ": ";
  const std::string burn =
      named + readable(total_impulse(motor), 4) + " N s in " + readable(burn_time(motor), 4) + " s, ";
  if (!(motor.propellant_mass > 0)) return burn + "without propellant: the mass stays";
  return burn + "specific impulse " + readable(specific_impulse(motor), 4) + " s";
}

/// Ignition, burnout or the end of the rail.
std::string stop_text(const Flight& flight, const Event& stop) {
  return time_text(stop.time, flight) + " s: height " + readable(stop.position.y, 5) + " m, " +
         readable(length(stop.velocity), 5) + " m/s, " + readable(flight.at(stop.time).mass, 4) + " kg";
}

/// True of a value that until.events asks for: the end at the ground or at a range is another line.
bool is_asked_for(const Event& event, const std::vector<EventSpec>& asked) {
  return row_of(event.kind).waits_for_value && std::ranges::any_of(asked, [&](const EventSpec& spec) {
           return spec.kind == event.kind && spec.value == event.value &&
                  (spec.direction == Crossing::any || spec.direction == event.direction);
         });
}

std::string crossing_text(const Flight& flight, const Event& event) {
  return quantity_in_words(event.value, quantity_of_value(event.kind)) + " " + std::string(name(event.direction)) +
         " at " + time_text(event.time, flight) +
         " s: " + place_text(flight, event.position, flight.at(event.time).range);
}

/// The part of a flight on one side of its own drag curve.
struct Beyond {
  double mach = 0;             // the farthest
  double curve_end = 0;        // Mach number
  std::optional<Sample> from;  // of the farthest
  double first = 0, last = 0;  // [s]

  void add(const Sample& sample, double end, bool is_above) {
    if (is_above ? !(sample.mach > end) : !(sample.mach < end)) return;
    if (!from) first = sample.time;
    last = sample.time;
    if (from && (is_above ? !(sample.mach > mach) : !(sample.mach < mach))) return;
    mach = sample.mach, curve_end = end, from = sample;
  }
  [[nodiscard]] std::string text(bool is_above) const {
    if (!from) return "";
    return std::string("the drag curve ") + (is_above ? "ends" : "begins") + " at Mach " + as_typed(curve_end) +
           ", and the flight is " + (is_above ? "above" : "below") + " it between " + readable(first, 4) + " and " +
           readable(last, 4) + " s, by Mach " + fixed(mach, 3) + " at " + readable(from->range, 5) +
           " m at the most; the coefficient at the end is held there";
  }
};

std::string cost_text(const Flight& flight) {
  const FlightCost& cost = flight.cost();
  std::string text = std::to_string(cost.steps) + " steps";
  if (flight.step() > 0) text += " of " + significant(flight.step(), 4) + " s";
  if (cost.rejected > 0) text += " (" + std::to_string(cost.rejected) + " more rejected)";
  return text + ", " + std::to_string(cost.evaluations) + " evaluations of the acceleration";
}

std::string shot_text(const FlownShot& flown, const Scenario& scenario, const Style& style) {
  PHYSIM_ASSERT(flown.shot != nullptr);
  const Flight& flight = flown.flight;
  const FidelityInUse& in_use = flight.fidelity_in_use();
  std::string out = style.bold(one_line(flown.name)) + "\n";
  const std::string preset = preset_name(flown.shot->projectile.fidelity);
  const auto& within = flown.shot->cheapest_within;
  out += line("fidelity", within ? "cheapest within " + significant(*within, 4) + " m of " + preset : preset);
  out += line("granted", in_words(in_use.fidelity));
  for (const FidelityNote& note : in_use.notes) out += line(style.warn("note"), note_text(note));
  for (const std::string& note : flight_notes(flown)) out += line(style.warn("note"), note);
  out += range_card(flown, ranges_of_card(scenario, flight));
  out += line(std::string(name(flight.outcome())), "at " + end_text(flight));
  const MotorDef& motor = flown.shot->projectile.motor;
  if (!motor.thrust.empty()) out += line("motor", motor_text(motor));
  for (const Event& event : flight.events()) {
    if (event.kind == EventKind::apex)
      out += line("apex", "at " + time_text(event.time, flight) +
                              " s: " + place_text(flight, event.position, flight.at(event.time).range));
    if (is_asked_for(event, scenario.until.events))
      out += line(std::string(name(event.kind)), crossing_text(flight, event));
    if (is_of_motor_or_rail(event.kind)) out += line(std::string(name(event.kind)), "at " + stop_text(flight, event));
  }
  if (const std::string text = stability_text(*flown.shot, flight, scenario.environment); !text.empty())
    out += line("stability", text);
  out += line("elevation", fixed(flight.elevation() / kDegree, 4) + " deg");
  out += line("cost", cost_text(flight));
  return out;
}

bool flies_curve(const ProjectileDef& p) { return p.drag.table == DragTable::custom && !p.drag.curve.empty(); }

}  // namespace

bool has_own_curve(const ProjectileDef& p) { return flies_curve(p) || !p.motor.drag_curve.empty(); }

std::vector<std::string> curve_notes(const Flight& flight) {
  const ProjectileDef& p = flight.projectile();
  const bool has_curve = flies_curve(p);
  if (p.fidelity.drag != DragModel::equation || !has_own_curve(p)) return {};
  constexpr int kParts = 400;
  std::vector<double> times = flight.step_times();
  for (int i = 0; i <= kParts; ++i) times.push_back(flight.duration() * i / kParts);
  std::ranges::sort(times);
  Beyond below, above;
  for (const double time : times) {
    const Sample sample = flight.at(time);
    const bool burns = sample.thrust > 0 && !p.motor.drag_curve.empty();
    if (!(sample.mach > 0) || (!burns && !has_curve)) continue;
    const std::vector<DragPoint>& curve = burns ? p.motor.drag_curve : p.drag.curve;
    below.add(sample, curve.front().mach, false);
    above.add(sample, curve.back().mach, true);
  }
  std::vector<std::string> notes;
  for (const std::string& text : {above.text(true), below.text(false)})
    if (!text.empty()) notes.push_back(text);
  return notes;
}

std::vector<std::string> flight_notes(const FlownShot& flown) {
  PHYSIM_ASSERT(flown.shot != nullptr);
  std::vector<std::string> notes = curve_notes(flown.flight);
  const double rail = flown.shot->launch.rail_length;
  const Sample end = flown.flight.end();
  const double moved = length(end.position - flown.flight.at(0).position);
  const bool has_left =
      std::ranges::any_of(flown.flight.events(), [](const Event& event) { return event.kind == EventKind::rail_exit; });
  if (!has_left && end.speed == 0 && moved > 0 && moved < rail)
    notes.push_back("it never leaves its rail of " + as_typed(rail) + " m: it stops " + readable(moved, 4) +
                    " m along it, and stays there");
  return notes;
}

std::string stability_text(const ScenarioShot& shot, const Flight& flight, const Environment& environment) {
  if (turns(flight.fidelity_in_use().fidelity)) return stability_in_flight(flight);
  const auto factor = stability_factor(shot.projectile, shot.launch, environment);
  return factor ? "Sg " + significant(*factor, 3) + " at the muzzle, by Miller's rule" : "";
}

bool has_sight(const Launch& launch) {
  const Sight& sight = launch.sight;
  return sight.zero_range > 0 || sight.look_angle != 0 || sight.height != 0;
}

std::string not_reached(const Flight& flight, double asked, const std::string& unit, double size) {
  const double end = flight.end().range / size;
  constexpr int kFewest = 4, kMost = 12;
  int digits = kFewest;  // enough for the rounded end to stay below the range that was asked for
  while (digits < kMost && end < asked && std::atof(readable(end, digits).c_str()) >= asked) ++digits;
  return "not reached: " + std::string(name(flight.outcome())) + " at " + readable(end, digits) + " " + unit;
}

std::vector<double> default_ranges(double end_range) {
  std::vector<double> ranges;
  constexpr double kShortest = 1e-3;  // [m]; straight up and down there is no range
  if (!(end_range > kShortest) || !std::isfinite(end_range)) return ranges;
  const double power = std::pow(10.0, std::floor(std::log10(end_range)));
  double step = power;
  for (const double part : {0.5, 0.2, 0.1})
    if (end_range / step < 5) step = part * power;
  PHYSIM_ASSERT(step > 0);
  for (int k = 1; k * step <= end_range && k <= 10; ++k) ranges.push_back(k * step);
  return ranges;
}

std::vector<double> ranges_of_card(const Scenario& scenario, const Flight& flight) {
  return scenario.ranges.empty() ? default_ranges(flight.end().range) : scenario.ranges;
}

std::string checks_text(const std::vector<Check>& checks, const Style& style) {
  Table table({"verdict", "shot", "at", "quantity", "value", "expected", "within", "unit", "source"}, "llllrrrll");
  std::size_t missed = 0;
  for (const Check& check : checks) {
    PHYSIM_ASSERT(check.expectation != nullptr);
    const Expectation& expectation = *check.expectation;
    missed += check.met ? 0 : 1;
    table.add_row({check.met ? style.good("ok") : style.bad("MISSED"), one_line(check.shot), place_text(expectation),
                   expectation.quantity, check.value ? significant(*check.value, 7) : "none",
                   as_typed(expectation.equals), as_typed(expectation.within),
                   std::string(unit_of(expectation.quantity)), one_line(expectation.source)});
  }
  std::string out = style.bold("checks") + "\n" + table.text(kIndent);
  for (const Check& check : checks)
    if (!check.value) out += line("none", check.expectation->place + ": " + check.value.error().message);
  const std::string verdict = std::to_string(checks.size() - missed) + " of " + std::to_string(checks.size()) + " met";
  return out + "  " + (missed == 0 ? style.good(verdict) : style.bad(verdict)) + "\n";
}

Text summary_text(const FlownScenario& flown, const Style& style) {
  return [&flown, style](const Sink& sink) {
    const Scenario& scenario = flown.scenario;
    sink(style.bold(one_line(title_of(scenario))) + "\n");
    for (const FlownShot& shot : flown.shots) sink("\n" + shot_text(shot, scenario, style));
    sink(hits_table(hits_of(flown)));
    if (!flown.checks.empty()) sink("\n" + checks_text(flown.checks, style));
  };
}

}  // namespace physim::report
