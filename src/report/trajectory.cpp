#include "report/trajectory.hpp"

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>

#include "base/assert.hpp"
#include "report/json.hpp"
#include "report/number.hpp"
#include "report/world_hits.hpp"

namespace physim::report {
namespace {

using Json = nlohmann::ordered_json;
constexpr double kDefaultSamples = 200;  // at least, for each shot

// The largest of 1, 2, 5 times a power of ten that is not larger than `value`.
double round_down(double value) {
  PHYSIM_ASSERT(value >= 0);
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
  PHYSIM_ASSERT(interval > 0);
  PHYSIM_ASSERT(duration >= 0);
  std::vector<double> times;
  const auto count = static_cast<std::size_t>(duration / interval);
  for (std::size_t k = 0; k <= count; ++k)
    if (const double time = multiple(interval, k); time < duration) times.push_back(time);
  times.push_back(duration);
  PHYSIM_ASSERT(std::ranges::is_sorted(times));
  return times;
}

std::vector<std::string> columns_of(bool with_jerk) {
  std::vector<std::string> columns(kSampleColumns.begin(), kSampleColumns.end());
  if (with_jerk) columns.insert(columns.end(), kJerkColumns.begin(), kJerkColumns.end());
  return columns;
}

/// The numbers of a flight at a time, as many as there are columns.
std::vector<double> numbers_at(const Flight& flight, double time, bool with_jerk) {
  const SampleRow row = row_of(flight.at(time));
  std::vector<double> numbers(row.begin(), row.end());
  if (!with_jerk) return numbers;
  const Vec3d jerk = flight.jerk(time);
  numbers.insert(numbers.end(), {jerk.x, jerk.y, jerk.z});
  return numbers;
}

/// Numbers of one shot, which JSON has column by column: each is asked for once.
Records columns_of(const Flight& flight, const std::vector<double>& times, bool with_jerk) {
  std::vector<std::vector<double>> rows;
  rows.reserve(times.size());
  for (const double time : times) rows.push_back(numbers_at(flight, time, with_jerk));
  return {columns_of(with_jerk), [rows = std::move(rows)](const auto& take) {
            std::vector<Cell> cells;
            for (const std::vector<double>& row : rows) {
              cells.assign(row.begin(), row.end());
              take(cells);
            }
          }};
}

Json sample_json(const Sample& s) {
  return {{"range [m]", s.range},   {"drop [m]", s.drop},   {"windage [m]", s.windage}, {"time [s]", s.time},
          {"speed [m/s]", s.speed}, {"mach [-]", s.mach},   {"energy [J]", s.energy},   {"x [m]", s.position.x},
          {"y [m]", s.position.y},  {"z [m]", s.position.z}};
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
                 .place = "interval",
                 .hint = "take a longer interval"};
  SampleTimes times;
  for (const FlownShot& shot : shots) times.push_back(times_of(shot.flight.duration(), interval_of(shot)));
  return times;
}

Records records_of(const Flights& flights) {
  std::vector<std::string> columns = {"shot"};
  for (std::string& name : columns_of(flights.with_jerk)) columns.push_back(std::move(name));
  return {std::move(columns), [flights](const auto& take) {
            const auto& [flown, times, with_jerk] = flights;
            PHYSIM_ASSERT(times.size() == flown.shots.size());
            std::vector<Cell> row;
            for (std::size_t i = 0; i < flown.shots.size(); ++i) {
              for (const double time : times[i]) {
                row.assign(1, std::string_view(flown.shots[i].name));
                for (const double number : numbers_at(flown.shots[i].flight, time, with_jerk)) row.emplace_back(number);
                take(row);
              }
            }
          }};
}

Content flights_json(const Flights& flights) {
  return [flights](const Sink& sink) {
    const auto& [flown, times, with_jerk] = flights;
    PHYSIM_ASSERT(times.size() == flown.shots.size());
    JsonStream out(sink);
    out.object();
    add_provenance(out, flown.scenario);
    out.list("shots");
    for (std::size_t i = 0; i < flown.shots.size(); ++i) {
      const FlownShot& from = flown.shots[i];
      out.object();
      out.add({{"name", from.name}});
      out.add(flight_json(from.flight, from.shot->projectile.fidelity));
      out.add({{"range_card", range_card_json(from.flight, flown.scenario.ranges)}});
      out.object("trajectory");
      add_columns(out, columns_of(from.flight, times[i], with_jerk));
      out.close();
      out.close();
    }
    out.close();
    if (has_scene(flown.scenario)) add_hits(out, hits_of(flown));
    add_checks(out, flown.checks);
    out.close();
  };
}

}  // namespace physim::report
