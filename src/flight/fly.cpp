// fly(): computes one flight and keeps its dense output.
#include "base/ieee_mode.hpp"
#include "base/text.hpp"
#include "flight/lane_flight.hpp"
#include "flight/pilot.hpp"
#include "flight/zero.hpp"
#include "prepare/check.hpp"
#include "prepare/conditions.hpp"
#include "prepare/grant.hpp"
#include "prepare/launch.hpp"

namespace physim {
namespace {

/// By default muzzle and ground are both at height 0: the commonest reason for a flight of no length.
void say_why_it_landed_at_once(FlightRecord& record, double ground) {
  const std::string height = short_text(ground);
  record.cohort.in_use.notes.push_back({"until.ground", height, height,
                                        "it starts on the ground and does not rise, so it has landed at once; start it "
                                        "at a higher position, or give another ground or none"});
}

/// A flight that is over before it begins has one node; `body` is launched where it begins.
bool is_over_at_once(FlightRecord& record, const Body<double>& body, const Turn<double>& turn, const Until& until) {
  const State<double>& now = body.launch;
  Outcome outcome;
  if (!ends_at_once(record.cohort.conditions, body, until, outcome)) return false;
  record.outcome = outcome;
  const Vec3d a = accelerations_of(record.cohort.conditions, record.body, record.rotor, record.clock, now, turn).total;
  record.path.nodes.push_back({0, now, a});
  if (record.path.turn) record.path.turn->nodes.push_back({0, turn, {}});
  if (outcome != Outcome::landed) return true;
  keep_event(record, {{EventKind::ground, *until.ground, Crossing::falling, true}, outcome}, false, 0, now);
  say_why_it_landed_at_once(record, *until.ground);
  return true;
}

template <class S>
void fly_lane(FlightRecord& record, const Tolerance& tolerance, const Until& until, const Body<S>& body) {
  const Obstacles obstacles{until.scene, until.contact};
  LaneFlight<S>(record, tolerance, record.step, until, body, obstacles).from_launch(until.time);
}

/// Steps of one length are flown one by one where they may end at a contact.
template <class S>
void fly_steps(FlightRecord& record, const Tolerance& tolerance, const Until& until, const Body<S>& body) {
  FrameStart start{.now = record.body.launch, .turn = record.rotor.launch, .is_clocked = true, .dt = record.step};
  start.obstacles = {until.scene, until.contact};
  start.run_start = until.contact.scene_time;
  start.from_launch = true;
  Tolerance framed = tolerance;
  framed.max_steps = kMostPartsOfFrame;
  LaneFlight<S>(record, framed, 0, until, body, start.obstacles).by_frames(start, until.time, tolerance.max_steps);
}

template <class S>
void fly_body(FlightRecord& record, const Tolerance& tolerance, const Until& until, const Body<S>& body) {
  if (until.scene && record.step > 0) return fly_steps(record, tolerance, until, body);
  fly_lane(record, tolerance, until, body);
}

[[nodiscard]] Body<float> narrow(const Body<double>& body) {
  Body<float> to;
  cast_numbers(body, to);
  return to;
}

void fly_record(FlightRecord& record, const Tolerance& tolerance, const Until& until) {
  PHYSIM_ASSERT(record.path.turn.has_value() == turns(record.cohort.in_use.fidelity));
  if (is_over_at_once(record, record.body, record.rotor.launch, until)) return;
  if (record.cohort.conditions.has_motor && record.body.ignition == 0)
    keep_event(record, {{EventKind::ignition}, Outcome::event}, true, 0, record.body.launch);
  if (record.cohort.in_use.fidelity.precision == Precision::float32)
    fly_body<float>(record, tolerance, until, narrow(record.body));
  else
    fly_body<double>(record, tolerance, until, record.body);
  if (record.outcome == Outcome::landed && record.duration == 0) say_why_it_landed_at_once(record, *until.ground);
}

/// All but the path; the elevation is found.
void prepare(FlightRecord& record, const ProjectileDef& projectile, const Launch& launch,
             const Environment& environment, const Fidelity& fidelity) {
  record.cohort.in_use = grant(fidelity, projectile, environment, launch);
  const Fidelity& granted = record.cohort.in_use.fidelity;
  Conditions<double>& conditions = record.cohort.conditions;
  conditions = prepare_conditions(environment, granted, record.cohort.profiles);
  put_kind(projectile, record.cohort.pool, conditions, record.body);
  record.sight = sight_frame(launch);
  put_launch(projectile, launch, record.sight, record.elevation, conditions, record.body);
  jump_in_crosswind(projectile, environment, conditions, record.body);
  if (turns(granted)) {
    record.path.turn.emplace();
    record.rotor = prepare_rotor(projectile, launch, record.elevation, record.body, record.cohort.pool, conditions);
  }
  record.cohort.finish();
  record.drift = prepare_spin_drift(projectile, length(record.body.launch.v), environment, granted);
  record.keep(environment);
  record.projectile.fidelity = granted;
}

Status check_all(const ProjectileDef& projectile, const Launch& launch, const Environment& environment,
                 const Fidelity& fidelity, const Tolerance& tolerance, const Until& until) {
  if (Status of_projectile = check(projectile); !of_projectile) return of_projectile;
  if (Status of_launch = check(launch); !of_launch) return of_launch;
  if (Status of_environment = check(environment); !of_environment) return of_environment;
  if (Status of_tolerance = check(tolerance, fidelity); !of_tolerance) return of_tolerance;
  if (Status of_until = check(until); !of_until) return of_until;
  return check(projectile, launch);
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

void fly_on(FlightRecord& record, const FrameStart& from, const Tolerance& tolerance, const Until& until) {
  PHYSIM_ASSERT(record.path.nodes.empty() && from.dt > 0);
  Body<double> body = record.body;
  body.launch = from.now;
  if (is_over_at_once(record, body, from.turn, until)) return;
  Until events = until;
  events.time = kInfinity;  // counted in frames
  Tolerance framed = tolerance;
  framed.max_step = kInfinity;
  framed.max_steps = kMostPartsOfFrame;
  if (record.cohort.in_use.fidelity.precision == Precision::float32)
    LaneFlight<float>(record, framed, 0, events, narrow(record.body), from.obstacles)
        .by_frames(from, until.time, tolerance.max_steps);
  else
    LaneFlight<double>(record, framed, 0, events, record.body, from.obstacles)
        .by_frames(from, until.time, tolerance.max_steps);
}

std::shared_ptr<FlightRecord> record_flight(const ProjectileDef& projectile, const Launch& launch,
                                            const Environment& environment, const Fidelity& fidelity,
                                            const Tolerance& tolerance, const Until& until) {
  const auto refuse = [](const Error& error, std::shared_ptr<FlightRecord> record) {
    record->error = error;
    return record;
  };
  const auto refuse_at_once = [&](const Error& error) { return refuse(error, std::make_shared<FlightRecord>()); };
  if (const Status status = check_all(projectile, launch, environment, fidelity, tolerance, until); !status)
    return refuse_at_once(status.error());
  const auto elevation = elevation_of(projectile, launch, environment, fidelity);
  if (!elevation) return refuse_at_once(elevation.error());
  auto record = std::make_shared<FlightRecord>(projectile);
  record->elevation = *elevation;
  prepare(*record, projectile, launch, environment, by_steps(fidelity, tolerance.step > 0));
  const State<double>& start = record->body.launch;
  if (const Status status = check_fits(start.x, start.v, record->cohort.in_use.fidelity.precision); !status)
    return refuse(status.error(), record);
  if (const Status status = choose_step(*record, projectile, launch, environment, tolerance, until); !status)
    return refuse(status.error(), record);
  if (launch.velocity && length(*launch.velocity) > 0) record->elevation = elevation_of(*launch.velocity);
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
