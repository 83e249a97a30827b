// The figures that an [[expect]] can check, and what flights and groups of a world say about them.
#include "scenario/expectation.hpp"

#include <algorithm>
#include <array>
#include <functional>

#include "base/assert.hpp"
#include "base/ieee_mode.hpp"
#include "physim/names.hpp"
#include "scenario/suggest.hpp"
#include "scenario/units.hpp"
#include "scenario/world_run.hpp"

namespace physim {
namespace {

using Amount = std::optional<double>;

/// The numbers of two series as one.
Series together(const Series& a, const Series& b) {
  if (a.count == 0) return b;
  if (b.count == 0) return a;
  const IeeeMode mode;
  Series all;
  all.count = a.count + b.count;
  const double of_a = static_cast<double>(a.count), of_b = static_cast<double>(b.count), n = of_a + of_b;
  const double apart = b.mean - a.mean;
  all.mean = a.mean + apart * (of_b / n);
  all.squares = a.squares + b.squares + apart * apart * (of_a * of_b / n);
  all.low = std::min(a.low, b.low);
  all.high = std::max(a.high, b.high);
  return all;
}

template <Vec3d WorldGroup::*mean, double Vec3d::*axis>
Amount mean_of(const WorldGroup& g) {
  return g.alive > 0 ? Amount(g.*mean.*axis) : std::nullopt;
}
Amount speed(const WorldGroup& g) { return g.alive > 0 ? Amount(g.mean_speed) : std::nullopt; }

/// A count that a group or hits have.
template <auto count, class Of>
Amount count_of(const Of& of) {
  return static_cast<double>(of.*count);
}
/// A part of a series that a group or hits have, as &Series::mean; nothing of no numbers.
template <auto series, auto part = &Series::mean, class Of>
Amount part_of(const Of& of) {
  const Series& numbers = std::invoke(series, of);
  return numbers.count > 0 ? Amount(std::invoke(part, numbers)) : std::nullopt;
}

using OfHits = Amount (*)(const ThingHits&);
/// A figure of hits alone.
constexpr Figure of_hits(std::string_view name, Quantity quantity, OfHits measure) {
  return {name, quantity, nullptr, nullptr, nullptr, nullptr, measure};
}

constexpr Figure of_passages(std::string_view name) {
  return {.name = name, .quantity = Quantity::number, .is_of_passages = true};
}

/// A count that emitters alone have.
template <std::uint64_t EmitterCounts::*count>
Amount emitted(const WorldGroup& g) {
  return g.emitter ? Amount(static_cast<double>(g.counts.*count)) : std::nullopt;
}
constexpr Figure of_emitters(std::string_view name, std::optional<double> (*measure)(const WorldGroup&)) {
  return {name, Quantity::number, nullptr, nullptr, measure, nullptr, nullptr, true};
}

/// The number where rotation was flown.
Amount flown(const Flight& flight, double value) {
  return turns(flight.fidelity_in_use().fidelity) ? Amount(value) : std::nullopt;
}
template <double YawPitchRoll::*angle>
Amount attitude(const Flight& flight, const Sample& s) {
  return flown(flight, flight.earth_frames().yaw_pitch_roll(s.position, s.orientation).*angle);
}
Amount spin_rate(const Flight& flight, const Sample& s) { return flown(flight, s.angular_velocity.x); }
Amount angle_of_attack(const Flight& flight, const Sample& s) { return flown(flight, s.angle_of_attack); }
Amount gyroscopic_stability(const Flight& flight, const Sample& s) {
  const auto stability = flight.stability(s.time);
  return stability ? Amount(stability->gyroscopic) : std::nullopt;
}
template <double Vec3d::*axis>
Amount jerk(const Flight& flight, const Sample& s) {
  return flight.jerk(s.time).*axis;
}

constexpr Figure kFigures[] = {
    {"drop", Quantity::length, [](const Sample& s) { return s.drop; }},
    {"windage", Quantity::length, [](const Sample& s) { return s.windage; }},
    {"range", Quantity::length, [](const Sample& s) { return s.range; }},
    {"speed", Quantity::speed, [](const Sample& s) { return s.speed; }, nullptr, speed},
    {"time", Quantity::time, [](const Sample& s) { return s.time; }},
    {"x", Quantity::length, [](const Sample& s) { return s.position.x; }, nullptr,
     mean_of<&WorldGroup::position, &Vec3d::x>},
    {"y", Quantity::length, [](const Sample& s) { return s.position.y; }, nullptr,
     mean_of<&WorldGroup::position, &Vec3d::y>},
    {"z", Quantity::length, [](const Sample& s) { return s.position.z; }, nullptr,
     mean_of<&WorldGroup::position, &Vec3d::z>},
    {"vx", Quantity::speed, [](const Sample& s) { return s.velocity.x; }, nullptr,
     mean_of<&WorldGroup::velocity, &Vec3d::x>},
    {"vy", Quantity::speed, [](const Sample& s) { return s.velocity.y; }, nullptr,
     mean_of<&WorldGroup::velocity, &Vec3d::y>},
    {"vz", Quantity::speed, [](const Sample& s) { return s.velocity.z; }, nullptr,
     mean_of<&WorldGroup::velocity, &Vec3d::z>},
    {"ax", Quantity::acceleration, [](const Sample& s) { return s.acceleration.x; }},
    {"ay", Quantity::acceleration, [](const Sample& s) { return s.acceleration.y; }},
    {"az", Quantity::acceleration, [](const Sample& s) { return s.acceleration.z; }},
    {"jx", Quantity::jerk, nullptr, nullptr, nullptr, jerk<&Vec3d::x>},
    {"jy", Quantity::jerk, nullptr, nullptr, nullptr, jerk<&Vec3d::y>},
    {"jz", Quantity::jerk, nullptr, nullptr, nullptr, jerk<&Vec3d::z>},
    {"mach", Quantity::number, [](const Sample& s) { return s.mach; }},
    {"energy", Quantity::energy, [](const Sample& s) { return s.energy; }},
    {"mass", Quantity::mass, [](const Sample& s) { return s.mass; }},
    {"thrust", Quantity::force, [](const Sample& s) { return s.thrust; }},
    {"latitude", Quantity::angle, nullptr, &Geodetic::latitude},
    {"longitude", Quantity::angle, nullptr, &Geodetic::longitude},
    {"altitude", Quantity::length, nullptr, &Geodetic::height},
    {"elevation", Quantity::angle, nullptr},
    {"yaw", Quantity::angle, nullptr, nullptr, nullptr, attitude<&YawPitchRoll::yaw>},
    {"pitch", Quantity::angle, nullptr, nullptr, nullptr, attitude<&YawPitchRoll::pitch>},
    {"roll", Quantity::angle, nullptr, nullptr, nullptr, attitude<&YawPitchRoll::roll>},
    {"spin_rate", Quantity::angular_rate, nullptr, nullptr, nullptr, spin_rate},
    {"angle_of_attack", Quantity::angle, nullptr, nullptr, nullptr, angle_of_attack},
    {"gyroscopic_stability", Quantity::number, nullptr, nullptr, nullptr, gyroscopic_stability},
    // Figures of groups of projectiles in a world: counts, and what their impacts were.
    {"spawned", Quantity::number, nullptr, nullptr, count_of<&WorldGroup::spawned>},
    {"refused", Quantity::number, nullptr, nullptr, count_of<&WorldGroup::refused>},
    {"landed", Quantity::number, nullptr, nullptr, count_of<&WorldGroup::landed>},
    {"bounces", Quantity::number, nullptr, nullptr, count_of<&WorldGroup::bounces>, nullptr,
     count_of<&ThingHits::bounces>},
    {"slept", Quantity::number, nullptr, nullptr, count_of<&WorldGroup::slept>},
    {"expired", Quantity::number, nullptr, nullptr, count_of<&WorldGroup::expired>},
    {"retired", Quantity::number, nullptr, nullptr, count_of<&WorldGroup::retired>},
    {"hits", Quantity::number, nullptr, nullptr, count_of<&WorldGroup::hits>, nullptr, count_of<&ThingHits::count>},
    {"alive", Quantity::number, nullptr, nullptr, count_of<&WorldGroup::alive>},
    {"impact_range", Quantity::length, nullptr, nullptr, part_of<&WorldGroup::range>},
    {"impact_range_min", Quantity::length, nullptr, nullptr, part_of<&WorldGroup::range, &Series::low>},
    {"impact_range_max", Quantity::length, nullptr, nullptr, part_of<&WorldGroup::range, &Series::high>},
    {"impact_range_spread", Quantity::length, nullptr, nullptr, part_of<&WorldGroup::range, &Series::spread>},
    {"impact_time", Quantity::time, nullptr, nullptr, part_of<&WorldGroup::time>},
    {"impact_speed", Quantity::speed, nullptr, nullptr, part_of<&WorldGroup::speed>},
    {"apex", Quantity::length, nullptr, nullptr, part_of<&WorldGroup::apex>},
    {"apex_max", Quantity::length, nullptr, nullptr, part_of<&WorldGroup::apex, &Series::high>},
    {"hit_y", Quantity::length, nullptr, nullptr, part_of<hit_heights>, nullptr, part_of<&ThingHits::y>},
    {"hit_z", Quantity::length, nullptr, nullptr, part_of<hit_sides>, nullptr, part_of<&ThingHits::z>},
    {"hit_y_spread", Quantity::length, nullptr, nullptr, part_of<hit_heights, &Series::spread>, nullptr,
     part_of<&ThingHits::y, &Series::spread>},
    {"hit_z_spread", Quantity::length, nullptr, nullptr, part_of<hit_sides, &Series::spread>, nullptr,
     part_of<&ThingHits::z, &Series::spread>},
    // Figures of hits on things of the scene: on one that the expectation names, or on all.
    of_hits("ricochets", Quantity::number, count_of<&ThingHits::ricochets>),
    of_hits("penetrations", Quantity::number, count_of<&ThingHits::penetrations>),
    of_hits("stops", Quantity::number, count_of<&ThingHits::stops>),
    of_hits("hit_time", Quantity::time, part_of<&ThingHits::time>),
    of_hits("hit_x", Quantity::length, part_of<&ThingHits::x>),
    of_hits("hit_speed", Quantity::speed, part_of<&ThingHits::speed>),
    of_hits("hit_speed_after", Quantity::speed, part_of<&ThingHits::speed_after>),
    of_hits("hit_obliquity", Quantity::angle, part_of<&ThingHits::obliquity>),
    of_hits("hit_depth", Quantity::length, part_of<&ThingHits::depth>),
    of_passages("passages"),
    // Figures of emitters; refused, landed, expired and alive are those of groups.
    of_emitters("born", emitted<&EmitterCounts::born>),
    of_emitters("aged", emitted<&EmitterCounts::aged>),
    of_emitters("replaced", emitted<&EmitterCounts::replaced>),
    of_emitters("taken", emitted<&EmitterCounts::taken>),
    of_emitters("cut", emitted<&EmitterCounts::cut>),
};

constexpr auto kFigureNames = [] {
  std::array<std::string_view, std::size(kFigures)> names;
  for (std::size_t i = 0; i < names.size(); ++i) names[i] = kFigures[i].name;
  return names;
}();

/// Where an event happens first: fly() always records these.
Result<Sample> sample_at_event(const Flight& flight, EventKind kind) {
  for (const Event& event : flight.events())
    if (event.kind == kind) return flight.at(event.time);
  return Error{"the flight has no " + std::string(name(kind)), "", ""};
}

Result<Sample> sample_at(const Flight& flight, const Expectation& expectation) {
  switch (expectation.at) {
    case ExpectAt::end: return flight.end();
    case ExpectAt::apex: return sample_at_event(flight, EventKind::apex);
    case ExpectAt::rail_exit: return sample_at_event(flight, EventKind::rail_exit);
    case ExpectAt::burnout: return sample_at_event(flight, EventKind::burnout);
    case ExpectAt::time: {
      // A flight that ends at until.time = 10 s may last 9.999999999999998 s: its end is found in its last step.
      constexpr double kRounding = 1e-12;
      if (expectation.at_value <= flight.duration() * (1 + kRounding)) return flight.at(expectation.at_value);
      return Error{"the flight ends after " + quantity_in_words(flight.duration(), Quantity::time), "", ""};
    }
    case ExpectAt::range: return flight.at_range(expectation.at_value);
    case ExpectAt::height: return flight.at_height(expectation.at_value);
  }
  return Error{"expect.at is none of the named values", "", ""};
}

/// The hits of a group or a flight on a thing, or on all; none where it never hit it.
template <class Hits>
ThingHits hits_on(const Hits& of, const std::string& thing) {
  if (thing.empty()) return of.on_things;
  for (const ThingHits& hits : of.by_thing)
    if (hits.thing == thing) return hits;
  return {};
}

Result<double> measure_anywhere(const Flight& flight, const Expectation& expectation) {
  if (flight.error()) return *flight.error();
  const Figure* figure = find_figure(expectation.quantity);
  if (figure == nullptr)
    return Error{"unknown quantity " + in_quotes(expectation.quantity), "",
                 suggestion(expectation.quantity, figure_names(), "known quantities")};
  if (!figure->is_of_flights()) return Error{in_quotes(figure->name) + " is a figure of a world", "", ""};
  const bool is_of_moment = figure->value != nullptr || figure->place != nullptr || figure->of_moment != nullptr;
  if (!is_of_moment) return flight.elevation();
  const Result<Sample> sample = sample_at(flight, expectation);
  if (!sample) return sample.error();
  if (figure->place != nullptr) return flight.earth_frames().geodetic(sample->position).*(figure->place);
  if (figure->value != nullptr) return figure->value(*sample);
  PHYSIM_ASSERT(figure->of_moment != nullptr);
  if (const auto value = figure->of_moment(flight, *sample)) return *value;
  return Error{"there is no " + in_quotes(figure->name) + " where rotation is not flown", "",
               "ask for the rotation model \"rigid_body\" or \"modified_point_mass\""};
}

}  // namespace

Series hit_heights(const WorldGroup& group) { return together(group.hit_y, group.on_things.y); }
Series hit_sides(const WorldGroup& group) { return together(group.hit_z, group.on_things.z); }

std::span<const Figure> figures() { return kFigures; }

std::span<const std::string_view> figure_names() { return kFigureNames; }

namespace {
template <class Is>
std::vector<std::string_view> names_where(const Is& is) {
  std::vector<std::string_view> names;
  for (const Figure& figure : kFigures)
    if (is(figure)) names.push_back(figure.name);
  return names;
}
}  // namespace

std::vector<std::string_view> group_figure_names() {
  return names_where([](const Figure& f) { return f.is_of_worlds(); });
}

std::vector<std::string_view> hit_figure_names() {
  return names_where([](const Figure& f) { return f.is_of_things(); });
}

const Figure* find_figure(std::string_view name) {
  for (const Figure& figure : kFigures)
    if (figure.name == name) return &figure;
  return nullptr;
}

Result<double> measure(const Flight& flight, const Expectation& expectation) {
  const IeeeMode mode;
  Result<double> value = measure_anywhere(flight, expectation);
  if (value) return value;
  Error error = value.error();
  error.place = expectation.place;  // the line of the file that asked
  return error;
}

Result<double> measure(const Flight& flight, const FlightHits& hits, const Expectation& expectation) {
  const IeeeMode mode;
  const Figure* figure = find_figure(expectation.quantity);
  if (figure != nullptr && figure->is_of_passages) return static_cast<double>(hits.passages.of(expectation.thing));
  if (figure == nullptr || figure->is_of_flights() || figure->of_hits == nullptr) return measure(flight, expectation);
  if (const auto value = figure->of_hits(hits_on(hits, expectation.thing))) return *value;
  return Error{"there is no hit to measure", expectation.place, "its count is zero"};
}

Result<double> measure(const WorldGroup& group, const Passages& passages, const Expectation& expectation) {
  const Figure* figure = find_figure(expectation.quantity);
  if (figure == nullptr || !figure->is_of_passages) return measure(group, expectation);
  return static_cast<double>(passages.of(expectation.thing));
}

Result<double> measure(const WorldGroup& group, const Expectation& expectation) {
  const IeeeMode mode;
  const Figure* figure = find_figure(expectation.quantity);
  if (figure == nullptr || !figure->is_of_worlds())
    return Error{in_quotes(expectation.quantity) + " is no figure of a world", expectation.place,
                 suggestion(expectation.quantity, group_figure_names(), "known are")};
  const bool of_hits = figure->of_group == nullptr || !expectation.thing.empty();
  if (of_hits && figure->of_hits == nullptr)
    return Error{in_quotes(expectation.quantity) + " is no figure of hits", expectation.place,
                 suggestion(expectation.quantity, hit_figure_names(), "known are")};
  if (figure->is_of_emitters && !group.emitter)
    return Error{in_quotes(group.name) + " is no emitter", expectation.place, "name one as expect.shot"};
  const std::optional<double> value =
      of_hits ? figure->of_hits(hits_on(group, expectation.thing)) : figure->of_group(group);
  if (value) return *value;
  return Error{"there is nothing of " + in_quotes(group.name) + " to measure", expectation.place, "its count is zero"};
}

}  // namespace physim
