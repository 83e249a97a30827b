// What a flight says about an expectation.

#include "base/assert.hpp"
#include "base/ieee_mode.hpp"
#include "physim/names.hpp"
#include "scenario/expectation.hpp"
#include "scenario/suggest.hpp"
#include "scenario/units.hpp"
#include "scenario/world_run.hpp"

namespace physim {
namespace {

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
      return Error{"the flight ends after " + quantity_text(flight.duration(), Quantity::time), "", ""};
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
