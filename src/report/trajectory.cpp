#include "report/trajectory.hpp"

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>

#include "base/assert.hpp"
#include "base/event_table.hpp"
#include "report/json.hpp"
#include "report/number.hpp"
#include "report/summary.hpp"
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

// The k-th multiple of an interval; 3 times 0.1 is 0.3, and 3 times 0.7 is 2.1.
double multiple(double interval, std::size_t k) {
  constexpr int kDigits = 15;  // that are those of a decimal product
  const double rate = std::round(1 / interval);
  const bool is_whole_rate = std::abs(rate * interval - 1) < 1e-12;
  return is_whole_rate ? static_cast<double>(k) / rate : rounded(static_cast<double>(k) * interval, kDigits);
}

Times times_of(double duration, double interval) {
  PHYSIM_ASSERT(interval > 0);
  PHYSIM_ASSERT(duration >= 0);
  Times times;
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

/// The number before a time.
double just_before(double time) { return std::nextafter(time, -kInfinity); }

/// The events of a flight at a time.
std::span<const Event> events_at(const Flight& flight, double time) {
  const std::span<const Event> all = flight.events();
  PHYSIM_ASSERT(std::ranges::is_sorted(all, {}, &Event::time));
  const auto first = std::ranges::lower_bound(all, time, {}, &Event::time);
  const auto last = std::ranges::upper_bound(all, time, {}, &Event::time);
  return all.subspan(static_cast<std::size_t>(first - all.begin()), static_cast<std::size_t>(last - first));
}

/// The state just before a time: that of the first event at the time.
Sample sample_before(const Flight& flight, double time) {
  Sample sample = flight.at(just_before(time));
  sample.time = time;
  if (const auto events = events_at(flight, time); !events.empty()) {
    sample.position = events.front().position;
    sample.velocity = events.front().velocity;
    sample.speed = length(sample.velocity);
  }
  return sample;
}

/// True if position or velocity jumps at a time by more than rounding.
bool jumps_at(const Flight& flight, double time) {
  constexpr double kRounding = 1e-9;
  const Sample before = sample_before(flight, time), after = flight.at(time);
  const double jump = length(after.position - before.position) + length(after.velocity - before.velocity);
  return jump > kRounding * (1 + before.speed);
}

bool is_first_of_two(std::span<const double> times, std::size_t i) {
  return i + 1 < times.size() && times[i] == times[i + 1];
}

/// The numbers of the i-th sample of a flight, as many as there are columns.
std::vector<double> numbers_at(const Flight& flight, const Times& times, std::size_t i, bool with_jerk) {
  const SampleRow row = row_of(sample_at(flight, times, i));
  std::vector<double> numbers(row.begin(), row.end());
  if (!with_jerk) return numbers;
  const Vec3d jerk = flight.jerk(is_first_of_two(times, i) ? just_before(times[i]) : times[i]);
  numbers.insert(numbers.end(), {jerk.x, jerk.y, jerk.z});
  return numbers;
}

/// Numbers of one shot, which JSON has column by column: each is asked for once.
Records columns_of(const Flight& flight, const Times& times, bool with_jerk) {
  std::vector<std::vector<double>> rows;
  rows.reserve(times.size());
  for (std::size_t i = 0; i < times.size(); ++i) rows.push_back(numbers_at(flight, times, i, with_jerk));
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

Sample sample_at(const Flight& flight, std::span<const double> times, std::size_t i) {
  PHYSIM_ASSERT(i < times.size());
  return is_first_of_two(times, i) ? sample_before(flight, times[i]) : flight.at(times[i]);
}

bool may_break_path(EventKind kind) {
  const Watch watch = physim::row_of(kind).watch;
  return watch == Watch::none || is_of_motor_or_rail(kind);
}

Times breaks_of(const Flight& flight) {
  Times breaks;
  for (const Event& event : flight.events())
    if (may_break_path(event.kind) && event.time <= flight.duration()) breaks.push_back(event.time);
  breaks.erase(std::unique(breaks.begin(), breaks.end()), breaks.end());
  return breaks;
}

Times with_breaks(const Flight& flight, const Times& times) {
  PHYSIM_ASSERT(std::ranges::is_sorted(times));
  const Times breaks = breaks_of(flight);
  // Two samples that are closer make an interpolation through both ill-conditioned.
  constexpr double kClose = 1e-6;
  const double close =
      times.size() > 1 ? kClose * (times.back() - times.front()) / static_cast<double>(times.size()) : 0;
  Times all;
  auto next = breaks.begin();
  for (const double time : times) {
    const double reach = time == times.front() ? 0 : close;
    for (; next != breaks.end() && *next <= time + reach; ++next)
      all.insert(all.end(), jumps_at(flight, *next) ? 2 : 1, *next);
    const double least = time == times.back() ? 0 : close;
    if (all.empty() || time - all.back() > least) all.push_back(time);
  }
  PHYSIM_ASSERT(std::ranges::is_sorted(all));
  return all;
}

Result<SampleTimes> sample_times(const std::vector<FlownShot>& shots, std::optional<double> interval) {
  const auto interval_of = [&](const FlownShot& shot) {
    const double duration = shot.flight.duration();
    return interval.value_or(duration > 0 ? round_down(duration / kDefaultSamples) : 1.0);
  };
  double total = 0;
  for (const FlownShot& shot : shots)
    total += std::floor(shot.flight.duration() / interval_of(shot)) + 2 +
             2 * static_cast<double>(shot.flight.events().size());
  if (!(total <= static_cast<double>(kMaxSamples)))
    return Error{.message = "there would be " + significant(total, 3) + " samples, and " + std::to_string(kMaxSamples) +
                            " are allowed",
                 .place = "interval",
                 .hint = "take a longer interval"};
  SampleTimes times;
  for (const FlownShot& shot : shots)
    times.push_back(with_breaks(shot.flight, times_of(shot.flight.duration(), interval_of(shot))));
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
              for (std::size_t k = 0; k < times[i].size(); ++k) {
                row.assign(1, std::string_view(flown.shots[i].name));
                for (const double number : numbers_at(flown.shots[i].flight, times[i], k, with_jerk))
                  row.emplace_back(number);
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
    add_provenance(out, flown.scenario, flown.notes);
    out.list("shots");
    for (std::size_t i = 0; i < flown.shots.size(); ++i) {
      const FlownShot& from = flown.shots[i];
      out.object();
      out.add({{"name", from.name}});
      auto flight = flight_json(from.flight, from.shot->projectile.fidelity);
      flight["notes"] = flight_notes(from);
      out.add(flight);
      out.add({{"assumed", assumed_json(flown, i)}});
      out.add({{"range_card", range_card_json(from.flight, ranges_of_card(flown.scenario, from.flight))}});
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
