#include "physim/solve.hpp"

#include <algorithm>
#include <limits>

#include "base/ieee_mode.hpp"
#include "flight/zero.hpp"
#include "math/vec3.hpp"
#include "physim/names.hpp"

namespace physim {
namespace {

constexpr int kTimes = 1000;  // at which two paths are compared

/// Up to when a flight has a place: one that has landed stays where it landed.
double last_time(const Flight& flight) {
  return flight.outcome() == Outcome::landed ? std::numeric_limits<double>::infinity() : flight.duration();
}

double largest_distance(const Flight& a, const Flight& b) {
  const double end = std::min({last_time(a), last_time(b), std::max(a.duration(), b.duration())});
  double largest = 0;
  for (int i = 0; i <= kTimes; ++i) {
    const double time = end * i / kTimes;
    largest = std::max(largest, length(a.at(time).position - b.at(time).position));
  }
  return largest;
}

ComparedFlight beside(const Flight& reference, Flight flight) {
  ComparedFlight out{std::move(flight), {}};
  if (out.flight.error()) {
    out.problem = out.flight.error()->message;
  } else if (!ended_as_planned(out.flight.outcome())) {
    out.problem = "its flight ended with " + std::string(name(out.flight.outcome()));
  } else {
    out.end_distance = length(out.flight.end().position - reference.end().position);
    out.largest_distance = largest_distance(out.flight, reference);
    out.end_delay = out.flight.duration() - reference.duration();
  }
  return out;
}

}  // namespace

Result<Comparison> compare(const ProjectileDef& projectile, const Launch& launch, const Environment& environment,
                           std::span<const FlightSetting> settings, const FlightSetting& reference, const Until& until,
                           const Progress& progress) {
  const IeeeMode mode;
  // One bore for all, as the reference zeroes it.
  const auto start = aimed_launch(projectile, launch, environment, reference.fidelity);
  if (!start) return start.error();
  const auto flight_of = [&](const FlightSetting& setting) {
    return fly(projectile, *start, environment, setting.fidelity, setting.tolerance, until);
  };
  Comparison out{flight_of(reference), *start, {}};
  if (out.reference.error()) return *out.reference.error();
  if (!ended_as_planned(out.reference.outcome()))
    return Error{"the reference flight ended with " + std::string(name(out.reference.outcome())), "until",
                 "give it an end that it reaches, as until.ground, until.range or until.time"};
  for (const FlightSetting& setting : settings) {
    out.flights.push_back(beside(out.reference, flight_of(setting)));
    if (progress) progress(out.flights.size(), settings.size());
  }
  return out;
}

}  // namespace physim
