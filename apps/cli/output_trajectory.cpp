#include "output_trajectory.hpp"

#include <cmath>
#include <cstdint>
#include <nlohmann/json.hpp>

#include "fidelity_text.hpp"
#include "output_number.hpp"
#include "physim/names.hpp"
#include "physim/version.hpp"

namespace physim::cli {
namespace {

using Json = nlohmann::ordered_json;
constexpr double kDefaultSamples = 200;  // at least, for each shot

// The largest of 1, 2, 5 times a power of ten that is not larger than `value`.
double round_down(double value) {
  const double power = std::pow(10.0, std::floor(std::log10(value)));
  for (const double digit : {5.0, 2.0})
    if (digit * power <= value) return digit * power;
  return power;
}

// The k-th multiple of an interval; 3 times 0.1 is 0.3.
double multiple(double interval, std::size_t k) {
  const double rate = std::round(1 / interval);
  const bool is_whole_rate = std::abs(rate * interval - 1) < 1e-12;
  return is_whole_rate ? static_cast<double>(k) / rate : static_cast<double>(k) * interval;
}

std::vector<double> times_of(double duration, double interval) {
  std::vector<double> times;
  const auto count = static_cast<std::size_t>(duration / interval);
  for (std::size_t k = 0; k <= count; ++k)
    if (const double time = multiple(interval, k); time < duration) times.push_back(time);
  times.push_back(duration);
  return times;
}

Json fidelity_json(const Fidelity& fidelity) {
  Json out;
  for (const auto& [effect, rung] : fidelity_fields(fidelity)) {
    if (rung == "true" || rung == "false")
      out[std::string(effect)] = rung == "true";
    else
      out[std::string(effect)] = rung;
  }
  return out;
}

Json sample_json(const Sample& sample) {
  return {{"range [m]", sample.range},   {"drop [m]", sample.drop},     {"windage [m]", sample.windage},
          {"time [s]", sample.time},     {"speed [m/s]", sample.speed}, {"mach [-]", sample.mach},
          {"energy [J]", sample.energy}, {"x [m]", sample.position.x},  {"y [m]", sample.position.y},
          {"z [m]", sample.position.z}};
}

Json trajectory_json(const Flight& flight, const std::vector<double>& times) {
  Json columns;
  for (const std::string_view name : kSampleColumns) columns[std::string(name)] = Json::array();
  for (const double time : times) {
    const SampleRow row = row_of(flight.at(time));
    for (std::size_t i = 0; i < row.size(); ++i) columns[std::string(kSampleColumns[i])].push_back(row[i]);
  }
  return columns;
}

Json range_card_json(const Flight& flight, const std::vector<double>& ranges) {
  Json card = Json::array();
  for (const double range : ranges)
    if (const Result<Sample> sample = flight.at_range(range)) card.push_back(sample_json(*sample));
  return card;
}

}  // namespace

SampleRow row_of(const Sample& s) {
  return {s.time,           s.position.x,     s.position.y,     s.position.z, s.velocity.x, s.velocity.y, s.velocity.z,
          s.acceleration.x, s.acceleration.y, s.acceleration.z, s.speed,      s.mach,       s.mass,       s.thrust};
}

Result<SampleTimes> sample_times(const std::vector<FlownShot>& shots, std::optional<double> interval) {
  const auto interval_of = [&](const FlownShot& shot) {
    const double duration = shot.flight.duration();
    return interval.value_or(duration > 0 ? round_down(duration / kDefaultSamples) : 1.0);
  };
  double total = 0;
  for (const FlownShot& shot : shots) total += std::floor(shot.flight.duration() / interval_of(shot)) + 2;
  if (!(total <= static_cast<double>(kMaxSamples)))
    return Error{.message = "there would be " + significant(total, 3) + " samples, and " + std::to_string(kMaxSamples) +
                            " are allowed",
                 .place = "--interval",
                 .hint = "take a longer interval"};
  SampleTimes times;
  for (const FlownShot& shot : shots) times.push_back(times_of(shot.flight.duration(), interval_of(shot)));
  return times;
}

std::string csv_field(const std::string& text) {
  if (text.find_first_of(",\"\r\n") == std::string::npos) return text;
  std::string out = "\"";
  for (const char c : text) out += c == '"' ? std::string("\"\"") : std::string(1, c);
  return out + "\"";
}

std::string trajectories_csv(const std::vector<FlownShot>& shots, const SampleTimes& times) {
  std::string out = "shot";
  for (const std::string_view column : kSampleColumns) out += ", " + std::string(column);
  out += "\n";
  for (std::size_t i = 0; i < shots.size(); ++i) {
    const std::string shot = csv_field(shots[i].name);
    for (const double time : times[i]) {
      out += shot;
      for (const double value : row_of(shots[i].flight.at(time))) out += ", " + shortest(value);
      out += "\n";
    }
  }
  return out;
}

Json checks_json(const std::vector<Check>& checks) {
  Json out = Json::array();
  for (const Check& check : checks) {
    const Expectation& expectation = *check.expectation;
    Json entry = {{"shot", check.shot},
                  {"at", place_text(expectation)},
                  {"quantity", expectation.quantity},
                  {"unit", unit_of(expectation.quantity)},
                  {"value", check.value ? Json(*check.value) : Json()},
                  {"equals", expectation.equals},
                  {"within", expectation.within},
                  {"met", check.met},
                  {"source", expectation.source},
                  {"place", expectation.place}};
    if (!check.value) entry["error"] = check.value.error().message;
    out.push_back(std::move(entry));
  }
  return out;
}

Json vector_json(const Vec3d& v) { return Json::array({v.x, v.y, v.z}); }

Json provenance(const Scenario& scenario) {
  Json values;
  for (const auto& [path, value] : effective_settings(scenario)) values[path] = value;
  return {{"program", "physim"},
          {"version", kVersion},
          {"scenario", {{"file", scenario.file}, {"title", scenario.title}, {"source", scenario.source}}},
          {"settings", std::move(values)}};
}

Json flight_json(const Flight& flight, const Fidelity& asked) {
  const FidelityInUse& in_use = flight.fidelity_in_use();
  Json notes = Json::array(), events = Json::array();
  for (const FidelityNote& note : in_use.notes)
    notes.push_back(
        {{"effect", note.effect}, {"asked", note.asked}, {"granted", note.granted}, {"reason", note.reason}});
  for (const Event& event : flight.events())
    events.push_back({{"kind", name(event.kind)},
                      {"value", event.value},
                      {"direction", name(event.direction)},
                      {"time [s]", event.time},
                      {"position [m]", vector_json(event.position)},
                      {"velocity [m/s]", vector_json(event.velocity)}});
  const FlightCost& cost = flight.cost();
  return {{"outcome", name(flight.outcome())},
          {"duration [s]", flight.duration()},
          {"elevation [rad]", flight.elevation()},
          {"fidelity_asked", fidelity_json(asked)},
          {"fidelity_granted", fidelity_json(in_use.fidelity)},
          {"fidelity_notes", std::move(notes)},
          {"step [s]", flight.step()},
          {"cost", {{"steps", cost.steps}, {"rejected", cost.rejected}, {"evaluations", cost.evaluations}}},
          {"events", std::move(events)}};
}

std::string trajectories_json(const FlownScenario& flown, const SampleTimes& times) {
  Json out = provenance(flown.scenario);
  out["shots"] = Json::array();
  for (std::size_t i = 0; i < flown.shots.size(); ++i) {
    const FlownShot& from = flown.shots[i];
    Json shot = {{"name", from.name}};
    shot.update(flight_json(from.flight, from.shot->projectile.fidelity));
    shot["range_card"] = range_card_json(from.flight, flown.scenario.ranges);
    shot["trajectory"] = trajectory_json(from.flight, times[i]);
    out["shots"].push_back(std::move(shot));
  }
  out["expect"] = checks_json(flown.checks);
  return json_text(out);
}

std::string json_text(const Json& json) { return json.dump(1, ' ', false, Json::error_handler_t::replace) + "\n"; }

}  // namespace physim::cli
