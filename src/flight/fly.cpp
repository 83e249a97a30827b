// fly(): computes one flight and keeps its dense output.
#include "flight/flight_record.hpp"
#include "flight/pilot.hpp"
#include "flight/zero.hpp"
#include "prepare/check.hpp"
#include "prepare/conditions.hpp"
#include "prepare/grant.hpp"
#include "prepare/launch.hpp"
#include "prepare/watch_list.hpp"
#include "solve/judge.hpp"

namespace physim {
namespace {

template <class S>
void keep_step(FlightRecord& record, const DenseLanes<S>& at) {
  record.nodes.back().t = at.n0.t;  // fixed steps count their time, which may differ from start + step by a rounding
  record.nodes.push_back(at.n1);
  const int count = dense_coefficient_count(record.cohort.in_use.fidelity.integrator);
  if (record.cohort.in_use.fidelity.motion == Motion::closed_form) return;
  record.coefficients.insert(record.coefficients.end(), at.coefficient, at.coefficient + count);
  if (!turns(record.cohort.in_use.fidelity)) return;
  record.turn_nodes.back().t = at.turn->n0.t;
  record.turn_nodes.push_back(at.turn->n1);
  record.turn_coefficients.insert(record.turn_coefficients.end(), at.turn->coefficient, at.turn->coefficient + count);
}
void keep_event(FlightRecord& record, const Watched& watched, bool rising, double time, const State<double>& flown) {
  const State<double> s = with_drift(flown, record.drift, record.sight.right, time);
  record.events.push_back({.kind = watched.spec.kind,
                           .direction = rising ? Crossing::rising : Crossing::falling,
                           .value = watched.spec.value,
                           .time = time,
                           .position = s.x,
                           .velocity = s.v});
}

template <class S>
Node first_node(const Step<S>& s) {
  Node n{0, {}, vec_cast<double>(s.slope[0].v)};
  cast_numbers(s.start, n.y);
  return n;
}
template <class S>
TurnNode first_turn_node(const Step<S>& s) {
  TurnNode n{};
  cast_numbers(s.turn->start, n.y);
  cast_numbers(s.turn->slope[0], n.slope);
  return n;
}

/// Where a stop makes the acceleration jump, the next step starts from a node of its own, after a step of no length.
template <class S>
void keep_jump(FlightRecord& record, const Lanes<S>& lane) {
  const Vec3d a = vec_cast<double>(lane.step.slope[0].v);
  if (a == record.nodes.back().a) return;
  record.nodes.push_back(
      {record.nodes.back().t, {vec_cast<double>(lane.step.start.x), vec_cast<double>(lane.step.start.v)}, a});
  const int count = dense_coefficient_count(record.cohort.in_use.fidelity.integrator);
  record.coefficients.insert(record.coefficients.end(), static_cast<std::size_t>(count), State<double>{});
  if (!turns(record.cohort.in_use.fidelity)) return;
  record.turn_nodes.push_back(first_turn_node(lane.step));
  record.turn_nodes.back().t = record.nodes.back().t;
  record.turn_coefficients.insert(record.turn_coefficients.end(), static_cast<std::size_t>(count), Turn<double>{});
}

/// Flies a single lane to its end; the loop is that of the batch kernels (flight/batch_driver.hpp) with a record kept.
template <class S>
void fly_lane(FlightRecord& record, const Course<S>& course, const Body<S>& body) {
  Lanes<S> lane{};
  const bool turn = turns(course.conditions->fidelity);
  lane.body = body;
  if (turn) cast_numbers(record.rotor, *lane.rotor);
  begin(course, lane);
  record.nodes.push_back(first_node(lane.step));
  if (turn) record.turn_nodes.push_back(first_turn_node(lane.step));
  Judgement<S> j{};
  for (bool ended = false; !ended;) {
    const bool accepted = try_step(course, lane);
    const bool special = needs_attention(course, lane, accepted).special;
    const bool sound = accepted && ends_finite(course.conditions->fidelity, lane.step);
    Verdict verdict{false, Outcome::step_limit, 1};
    j.crossings[0].count = 0;
    if (sound) dense_lanes(course, lane, j.at);
    if (special) {
      find_crossings<S>(course, sound, j);
      verdict = verdict_on(course, lane, step_marks(course, lane), 0, accepted, j.crossings[0]);
    }
    if (sound) keep_step(record, j.at);
    for (int i = 0; i < j.crossings[0].count; ++i) {
      const Found& found = j.crossings[0].found[i];
      const double time = j.at.time(found.theta);
      keep_event(record, course.watch.item[found.index], found.rising, time, j.at.at_time(time));
    }
    ended = verdict.ended;
    if (ended) {
      record.outcome = verdict.outcome;
      record.duration = sound ? j.at.time(verdict.theta) : record.nodes.back().t;
      if (sound) lane.count += S(1);
    } else {
      accept(course, lane, accepted);
      if (sound && has_stops(*course.conditions)) keep_jump(record, lane);
    }
  }
  const auto tries = static_cast<std::int64_t>(lane.tries);
  record.cost.steps = static_cast<std::int64_t>(lane.count + lane.parts);
  record.cost.rejected = tries - record.cost.steps;
  record.cost.evaluations = evaluations(course.conditions->fidelity, tries);
}

void fly_record(FlightRecord& record, const Tolerance& tolerance, const Until& until) {
  const WatchList watch = prepare_watch(until, record.cohort.conditions, Watcher::flight);
  cast_numbers(record.body, record.body_float);
  if (const auto outcome = ends_at_once(record.cohort.conditions, record.body, until)) {
    record.outcome = *outcome;
    const Vec3d a = accelerations_of(record.cohort.conditions, record.body, record.rotor, 0, record.body.launch,
                                     record.rotor.launch)
                        .total;
    record.nodes.push_back({0, record.body.launch, a});
    if (turns(record.cohort.in_use.fidelity)) record.turn_nodes.push_back({0, record.rotor.launch, {}});
    if (outcome == Outcome::landed) keep_event(record, watch.item[0], false, 0, record.body.launch);
    return;
  }
  if (record.cohort.conditions.has_motor && record.body.ignition == 0)
    keep_event(record, {{EventKind::ignition}, Outcome::event}, true, 0, record.body.launch);
  if (record.cohort.in_use.fidelity.precision == Precision::float32)
    fly_lane(record, record.cohort.course<float>(tolerance, record.step, watch), record.body_float);
  else
    fly_lane(record, record.cohort.course<double>(tolerance, record.step, watch), record.body);
}

}  // namespace

std::shared_ptr<FlightRecord> record_flight(const ProjectileDef& projectile, const Launch& launch,
                                            const Environment& environment, const Fidelity& fidelity,
                                            const Tolerance& tolerance, const Until& until) {
  auto record = std::make_shared<FlightRecord>();
  const auto refuse = [&](const Error& error) {
    record->error = error;
    return record;
  };
  for (const Status& status :
       {check(projectile), check(launch), check(environment), check(tolerance, fidelity), check(until)})
    if (!status) return refuse(status.error());
  if (const Status status = check(projectile, launch); !status) return refuse(status.error());
  const auto elevation = elevation_of(projectile, launch, environment, fidelity);
  if (!elevation) return refuse(elevation.error());
  record->elevation = *elevation;
  record->cohort.in_use = grant(fidelity, projectile, environment, launch);
  const Fidelity& granted = record->cohort.in_use.fidelity;
  if (const auto step = step_without_pilot(granted, tolerance)) {
    record->step = *step;
  } else {
    Launch zeroed = launch;  // the zero is found already
    zeroed.elevation = record->elevation;
    zeroed.sight.zero_range = 0;
    const auto found = pilot_step(projectile, zeroed, environment, granted, tolerance, until);
    if (!found) return refuse(found.error());
    record->step = *found;
  }
  record->cohort.conditions = prepare_conditions(environment, granted);
  record->body = prepare_body(projectile, launch, record->elevation, record->cohort.pool, record->cohort.conditions);
  jump_in_crosswind(projectile, environment, record->cohort.conditions, record->body);
  if (turns(granted))
    record->rotor = prepare_rotor(projectile, launch, record->elevation, record->body, record->cohort.pool,
                                  record->cohort.conditions);
  record->cohort.finish();
  record->sight = sight_frame(launch);
  record->drift = prepare_spin_drift(projectile, length(record->body.launch.v), environment, granted);
  record->environment.altitude = environment.altitude;
  record->environment.gravity = environment.gravity;
  record->environment.earth = environment.earth;
  fly_record(*record, tolerance, until);
  return record;
}

Flight fly(const ProjectileDef& projectile, const Launch& launch, const Environment& environment,
           const Fidelity& fidelity, const Tolerance& tolerance, const Until& until) {
  return Flight(record_flight(projectile, launch, environment, fidelity, tolerance, until));
}

Flight fly(const ProjectileDef& projectile, const Launch& launch, const Environment& environment) {
  return fly(projectile, launch, environment, projectile.fidelity);
}

}  // namespace physim
