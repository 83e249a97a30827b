// fly(): computes one flight and keeps its dense output.
#include "base/ieee_mode.hpp"
#include "base/text.hpp"
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

std::size_t coefficient_count(const FlightRecord& record) {
  const Fidelity& f = record.cohort.in_use.fidelity;
  return f.motion == Motion::closed_form ? 0 : static_cast<std::size_t>(dense_coefficient_count(f.integrator));
}

template <class S>
void keep_step(FlightRecord& record, const DenseLanes<S>& at) {
  const auto keep = [count = coefficient_count(record)](const auto& dense, auto& path) {
    PHYSIM_ASSERT(!path.nodes.empty() && path.coefficients.size() == (path.nodes.size() - 1) * count);
    path.nodes.back().t = dense.n0.t;  // fixed steps count their time, which may differ from start + step by a rounding
    path.nodes.push_back(dense.n1);
    path.coefficients.insert(path.coefficients.end(), dense.coefficient, dense.coefficient + count);
  };
  for_parts(record.cohort.in_use.fidelity, keep, at, record.path);
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

/// Keeps where a step starts; of a state's slope the acceleration alone.
template <class S>
void keep_start(FlightRecord& record, const Step<S>& step, double time) {
  const auto keep = [time](const auto& part, auto& path) {
    path.nodes.push_back({});
    auto& node = path.nodes.back();
    node.t = time;
    cast_numbers(part.start, node.y);
    if constexpr (requires { node.slope; })
      cast_numbers(part.slope[0], node.slope);
    else
      node.a = vec_cast<double>(part.slope[0].v);
  };
  for_parts(record.cohort.in_use.fidelity, keep, step, record.path);
}

/// Where a stop makes the acceleration jump, the next step starts from a node of its own, after a step of no length.
template <class S>
void keep_jump(FlightRecord& record, const Lanes<S>& lane) {
  const Node& last = record.path.nodes.back();
  if (vec_cast<double>(lane.step.slope[0].v) == last.a) return;
  keep_start(record, lane.step, last.t);
  const auto no_change = [count = coefficient_count(record)](auto& path) {
    path.coefficients.resize(path.coefficients.size() + count);
  };
  for_parts(record.cohort.in_use.fidelity, no_change, record.path);
}

/// Flies a single lane to its end; the loop is that of the batch kernels (flight/batch_driver.hpp) with a record kept.
template <class S>
void fly_lane(FlightRecord& record, const Course<S>& course, const Body<S>& body) {
  March<S> march(course);
  Lanes<S>& lane = march.lanes;
  lane.body = body;
  const auto take_rotor = [&](auto& rotor) { cast_numbers(record.rotor, rotor); };
  for_rotors(course.conditions->fidelity, take_rotor, lane);
  march.launch();
  keep_start(record, lane.step, 0);
  Judgement<S> j{};
  for (bool ended = false; !ended;) {
    const bool accepted = march.try_step();
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
      PHYSIM_ASSERT(record.events.empty() || record.events.back().time <= time);
      keep_event(record, course.watch.item[found.index], found.rising, time, j.at.at_time(time));
    }
    ended = verdict.ended;
    if (ended) {
      record.outcome = verdict.outcome;
      record.duration = sound ? j.at.time(verdict.theta) : record.path.nodes.back().t;
      if (sound) lane.count += S(1);
    } else {
      march.accept(accepted);
      if (sound && has_stops(*course.conditions)) keep_jump(record, lane);
    }
  }
  PHYSIM_ASSERT(record.duration >= 0 && !record.path.nodes.empty());
  const auto tries = static_cast<std::int64_t>(lane.tries);
  record.cost.steps = static_cast<std::int64_t>(lane.count + lane.parts);
  record.cost.rejected = tries - record.cost.steps;
  PHYSIM_ASSERT(record.cost.steps >= 0 && record.cost.rejected >= 0);
  record.cost.evaluations = evaluations(course.conditions->fidelity, tries);
}

/// Muzzle and ground are both at height 0 where nobody says otherwise: the commonest reason for a flight of no length.
void say_why_it_landed_at_once(FlightRecord& record, double ground) {
  const std::string height = short_text(ground);
  record.cohort.in_use.notes.push_back({"until.ground", height, height,
                                        "it starts on the ground and does not rise, so it has landed at once; start it "
                                        "higher by launch.position, or give another ground or none"});
}

void fly_record(FlightRecord& record, const Tolerance& tolerance, const Until& until) {
  const WatchList watch = prepare_watch(until, record.cohort.conditions, Watcher::flight);
  cast_numbers(record.body, record.body_float);
  PHYSIM_ASSERT(record.path.turn.has_value() == turns(record.cohort.in_use.fidelity));
  if (const auto outcome = ends_at_once(record.cohort.conditions, record.body, until)) {
    record.outcome = *outcome;
    const Vec3d a = accelerations_of(record.cohort.conditions, record.body, record.rotor, 0, record.body.launch,
                                     record.rotor.launch)
                        .total;
    record.path.nodes.push_back({0, record.body.launch, a});
    if (record.path.turn) record.path.turn->nodes.push_back({0, record.rotor.launch, {}});
    if (outcome == Outcome::landed) {
      keep_event(record, watch.item[0], false, 0, record.body.launch);
      say_why_it_landed_at_once(record, *until.ground);
    }
    return;
  }
  if (record.cohort.conditions.has_motor && record.body.ignition == 0)
    keep_event(record, {{EventKind::ignition}, Outcome::event}, true, 0, record.body.launch);
  if (record.cohort.in_use.fidelity.precision == Precision::float32)
    fly_lane(record, record.cohort.course<float>(tolerance, record.step, watch), record.body_float);
  else
    fly_lane(record, record.cohort.course<double>(tolerance, record.step, watch), record.body);
}

/// All but the path; the elevation is found.
void prepare(FlightRecord& record, const ProjectileDef& projectile, const Launch& launch,
             const Environment& environment, const Fidelity& fidelity) {
  record.cohort.in_use = grant(fidelity, projectile, environment, launch);
  const Fidelity& granted = record.cohort.in_use.fidelity;
  Conditions<double>& conditions = record.cohort.conditions;
  conditions = prepare_conditions(environment, granted);
  record.body = prepare_body(projectile, launch, record.elevation, record.cohort.pool, conditions);
  jump_in_crosswind(projectile, environment, conditions, record.body);
  if (turns(granted)) {
    record.path.turn.emplace();
    record.rotor = prepare_rotor(projectile, launch, record.elevation, record.body, record.cohort.pool, conditions);
  }
  record.cohort.finish();
  record.sight = sight_frame(launch);
  record.drift = prepare_spin_drift(projectile, length(record.body.launch.v), environment, granted);
  record.environment.altitude = environment.altitude;
  record.environment.gravity = environment.gravity;
  record.environment.earth = environment.earth;
}

Status choose_step(FlightRecord& record, const ProjectileDef& projectile, const Launch& launch,
                   const Environment& environment, const Tolerance& tolerance, const Until& until) {
  const Fidelity& granted = record.cohort.in_use.fidelity;
  if (const auto given = step_given(granted, tolerance)) {
    record.step = *given;
  } else if (steps_by_frames(granted)) {
    record.step = frame_step(record.cohort, record.body, record.rotor, until);
  } else {
    Launch zeroed = launch;  // the zero is found already
    zeroed.elevation = record.elevation;
    zeroed.sight.zero_range = 0;
    const double allowed = tolerance.position_error;
    const auto found = step_within(projectile, zeroed, environment, granted, tolerance, until, allowed);
    if (!found) return found.error();
    record.step = found->step;
    if (found->reached > allowed) record.cohort.in_use.notes.push_back(note_of_step(*found, allowed));
  }
  PHYSIM_ASSERT(steps_itself(granted) ? record.step == 0 : record.step > 0);
  return {};
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
  prepare(*record, projectile, launch, environment, fidelity);
  if (const Status status = choose_step(*record, projectile, launch, environment, tolerance, until); !status)
    return refuse(status.error());
  fly_record(*record, tolerance, until);
  return record;
}

Flight fly(const ProjectileDef& projectile, const Launch& launch, const Environment& environment,
           const Fidelity& fidelity, const Tolerance& tolerance, const Until& until) {
  const IeeeMode mode;
  return Flight(record_flight(projectile, launch, environment, fidelity, tolerance, until));
}

Flight fly(const ProjectileDef& projectile, const Launch& launch, const Environment& environment) {
  return fly(projectile, launch, environment, projectile.fidelity);
}

}  // namespace physim
