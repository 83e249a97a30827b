// Flight: answers questions about a computed trajectory.
#include <algorithm>

#include "base/assert.hpp"
#include "base/ieee_mode.hpp"
#include "base/text.hpp"
#include "flight/flight_record.hpp"
#include "model/attitude.hpp"
#include "model/stability.hpp"
#include "prepare/grant.hpp"

namespace physim {

State<double> with_drift(const State<double>& s, const SpinDrift& drift, const Vec3d& right, double time) {
  if (drift.coefficient == 0) return s;
  return {s.x + right * drift.drift(time), s.v + right * drift.drift_rate(time)};
}

namespace {

double nearest_time(double time, double duration) { return time > 0 ? std::min(time, duration) : 0; }

/// Number of the node that ends the step which a time lies in.
std::size_t later_node(const std::vector<Node>& nodes, double time) {
  PHYSIM_ASSERT(nodes.size() >= 2 && nodes.front().t <= nodes.back().t);
  const auto later =
      std::upper_bound(nodes.begin() + 1, nodes.end() - 1, time, [](double t, const Node& node) { return t < node.t; });
  return static_cast<std::size_t>(later - nodes.begin());
}

/// The node at a very time; null where there is none.
const Node* node_at(const std::vector<Node>& nodes, double time) {
  const auto at = std::lower_bound(nodes.begin(), nodes.end(), time, [](const Node& n, double t) { return n.t < t; });
  return at != nodes.end() && at->t == time ? &*at : nullptr;
}

/// The coefficients of the step that a node ends.
template <class Y>
const Y* coefficients_before(const std::vector<Y>& all, Integrator integrator, std::size_t node) {
  const auto count = static_cast<std::size_t>(dense_coefficient_count(integrator));
  PHYSIM_ASSERT(node >= 1 && node * count <= all.size());
  return all.data() + (node - 1) * count;
}

/// Times between which a height is crossed at most once: the ends of the steps and the apexes.
std::vector<double> borders(const FlightRecord& r) {
  std::vector<double> times;
  if (r.cohort.in_use.fidelity.motion == Motion::closed_form) times.push_back(0);
  for (const Node& node : r.path.nodes) times.push_back(std::min(node.t, r.duration));
  for (const Event& e : r.events)
    if (e.kind == EventKind::apex) times.push_back(e.time);
  return rising(std::move(times));
}

/// First time at which value(time) crosses zero in a direction; nothing where it never does. A flight that was ended by
/// this very crossing may lie a rounding before it, so its own events are asked at last.
template <class F>
std::optional<double> first_crossing(const FlightRecord& r, Crossing direction, const EventSpec& asked,
                                     const F& value) {
  const auto times = borders(r);
  PHYSIM_ASSERT(!times.empty());
  double from = value(times.front());
  if (from == 0 && direction == Crossing::any) return times.front();
  for (std::size_t i = 1; i < times.size(); ++i) {
    const double to = value(times[i]);
    if (crosses(direction, from, to))
      return find_root(value, times[i - 1], from, times[i], to, kThetaTolerance * (times[i] - times[i - 1]));
    from = to;
  }
  for (const Event& e : r.events) {
    const bool same_kind = e.kind == asked.kind || (e.kind == EventKind::ground && asked.kind == EventKind::height);
    if (same_kind && e.value == asked.value && (direction == Crossing::any || direction == e.direction)) return e.time;
  }
  return std::nullopt;
}

Error never(const std::string& what, const FlightRecord& r) {
  if (r.error) return *r.error;
  return Error{"the flight never reaches " + what, "", "it lasts " + short_text(r.duration) + " s"};
}

}  // namespace

Accelerations FlightRecord::accelerations_at(double time) const {
  Accelerations a = accelerations_of(cohort.conditions, body_at(time), rotor, clock + time, state(time), turn(time));
  if (is_classic(cohort.in_use.fidelity) && path.nodes.size() > 1)
    a.total = path.nodes[later_node(path.nodes, time) - 1].a;
  return a;
}

Body<double> FlightRecord::body_at(double time) const {
  const Conditions<double>& c = cohort.conditions;
  Body<double> b = body;
  if (has_stops(c)) {
    for (const Event& e : events)
      if (e.kind == EventKind::rail_exit && e.time <= time) b.rail_phase = kOffRail;
    State<double> s = state(time);
    pass_stops(c, clock + time, true, s, b);
  }
  if (path.pushes.size() > 1) {
    PHYSIM_ASSERT(path.pushes.size() == path.nodes.size());
    const std::size_t later = later_node(path.nodes, time);
    const double part = place_between(path.nodes[later - 1], path.nodes[later], time);
    const Vec3d &before = path.pushes[later - 1], &after = path.pushes[later];
    add_push(c, clock + time, before + (after - before) * part, has_own_force, b);
  }
  return b;
}

State<double> FlightRecord::state(double time) const {
  const Fidelity& f = cohort.in_use.fidelity;
  const auto& nodes = path.nodes;
  if (f.motion == Motion::closed_form) {
    if (const Node* node = is_framed ? node_at(nodes, time) : nullptr) return node->y;
    if (f.precision == Precision::float64) return closed_form(cohort.conditions, body, clock + time);
    const State<float> s = closed_form(cohort.conditions_float, body_float, static_cast<float>(clock + time));
    return {vec_cast<double>(s.x), vec_cast<double>(s.v)};
  }
  if (nodes.size() < 2) return nodes.empty() ? body.launch : nodes.front().y;
  const std::size_t later = later_node(nodes, time);
  const Node &n0 = nodes[later - 1], &n1 = nodes[later];
  const State<double>* c = coefficients_before(path.coefficients, f.integrator, later);
  return dense_state(f.integrator, n0, n1, c, place_between(n0, n1, time));
}

Turn<double> FlightRecord::turn(double time) const {
  const auto& nodes = path.nodes;
  if (!path.turn || nodes.size() < 2) return rotor.launch;
  const Fidelity& f = cohort.in_use.fidelity;
  const std::size_t later = later_node(nodes, time);
  PHYSIM_ASSERT(path.turn->nodes.size() == nodes.size());
  const TurnNode &n0 = path.turn->nodes[later - 1], &n1 = path.turn->nodes[later];
  const Turn<double>* c = coefficients_before(path.turn->coefficients, f.integrator, later);
  return dense_turn(f, n0, n1, c, place_between(nodes[later - 1], nodes[later], time));
}

State<double> FlightRecord::shown(double time) const { return with_drift(state(time), drift, sight.right, time); }

std::shared_ptr<const FlightRecord> Flight::none() noexcept {
  static const auto record = [] {
    auto none = std::make_shared<FlightRecord>();
    none->error = Error{"there is no flight any more", "flight", "it was moved away"};
    return none;
  }();
  return record;
}

Outcome Flight::outcome() const { return record_->outcome; }
const std::optional<Error>& Flight::error() const { return record_->error; }
double Flight::duration() const { return record_->duration; }
std::span<const Event> Flight::events() const { return record_->events; }
const FidelityInUse& Flight::fidelity_in_use() const { return record_->cohort.in_use; }
const FlightCost& Flight::cost() const { return record_->cost; }
double Flight::elevation() const { return record_->elevation; }
EarthFrames Flight::earth_frames() const {
  const IeeeMode mode;
  return EarthFrames(record_->environment, record_->cohort.in_use.fidelity.earth);
}
double Flight::step() const { return record_->step; }

Accelerations Flight::accelerations(double time) const {
  const IeeeMode mode;
  const FlightRecord& r = *record_;
  if (r.outcome == Outcome::refused) return {};
  return r.accelerations_at(nearest_time(time, r.duration));
}

const ProjectileDef& Flight::projectile() const { return record_->projectile; }

Result<Departure> Flight::departure(double time) const {
  const IeeeMode mode;
  const FlightRecord& r = *record_;
  if (r.error) return *r.error;
  if (!(time >= 0 && time <= r.duration))
    return Error{"is no time of the flight", "time", "it lasts " + short_text(r.duration) + " s"};
  const Body<double> b = r.body_at(time);
  if (r.cohort.conditions.has_rail && b.rail_phase < kOffRail)
    return Error{"it is still on its rail", "time", "ask later"};
  const State<double> s = r.shown(time);
  Departure from{s.x, s.v, r.clock + time, b.spin, std::nullopt};
  if (!r.path.turn) return from;
  const Attitude attitude = attitude_of(r.cohort.conditions, b, r.rotor, from.age, r.state(time), r.turn(time));
  from.attitude = {attitude.q_WB, attitude.omega};
  return from;
}

std::optional<Stability> Flight::stability(double time) const {
  const IeeeMode mode;
  const FlightRecord& r = *record_;
  if (r.outcome == Outcome::refused || !r.path.turn) return std::nullopt;
  time = nearest_time(time, r.duration);
  return stability_of(r.cohort.conditions, r.body, r.rotor, r.clock + time, r.state(time), r.turn(time));
}

Sample Flight::at(double time) const {
  const IeeeMode mode;
  const FlightRecord& r = *record_;
  Sample out;
  if (r.outcome == Outcome::refused) return out;
  time = nearest_time(time, r.duration);
  const State<double> s = r.shown(time);
  const Conditions<double>& c = r.cohort.conditions;
  out.time = time;
  out.position = s.x;
  out.velocity = s.v;
  out.acceleration = r.accelerations_at(time).total;
  out.speed = length(s.v);
  const bool has_air = c.fidelity.air != AirModel::vacuum;
  out.mach =
      has_air ? length(air_velocity(c, r.body, r.clock + time, s)) * air_state(c, r.body, s.x).per_sound_speed : 0;
  const Body<double> b = r.body_at(time);
  out.mass = mass_at(b, r.clock + time);
  out.thrust = thrust_at(b, r.clock + time);
  out.energy = 0.5 * out.mass * out.speed * out.speed;
  out.range = dot(s.x - r.sight.muzzle, r.sight.forward);
  out.drop = dot(s.x - r.sight.start, r.sight.up);
  out.windage = dot(s.x - r.sight.start, r.sight.right);
  if (!r.path.turn) return out;
  const Attitude attitude = attitude_of(c, b, r.rotor, r.clock + time, s, r.turn(time));
  out.orientation = attitude.q_WB;
  out.angular_velocity = attitude.omega;
  out.angle_of_attack = angle_between(rotate(attitude.q_WB, Vec3d{1, 0, 0}), air_velocity(c, b, r.clock + time, s));
  return out;
}

Result<Sample> Flight::at_range(double range) const {
  const IeeeMode mode;
  const FlightRecord& r = *record_;
  const auto past = [&](double t) { return dot(r.state(t).x - r.sight.muzzle, r.sight.forward) - range; };
  if (r.outcome == Outcome::refused) return never("anything", r);
  if (const auto time = first_crossing(r, Crossing::any, {.kind = EventKind::range, .value = range}, past))
    return at(*time);
  return never("a range of " + short_text(range) + " m", r);
}

Result<Sample> Flight::at_height(double level, Crossing direction) const {
  const IeeeMode mode;
  const FlightRecord& r = *record_;
  const auto above = [&](double t) { return height(r.cohort.conditions, r.state(t).x) - level; };
  if (r.outcome == Outcome::refused) return never("anything", r);
  if (const auto time = first_crossing(r, direction, {.kind = EventKind::height, .value = level}, above))
    return at(*time);
  return never("a height of " + short_text(level) + " m", r);
}

std::vector<double> Flight::step_times() const {
  const IeeeMode mode;
  std::vector<double> times;
  for (const Node& node : record_->path.nodes) times.push_back(std::min(node.t, record_->duration));
  times.erase(std::unique(times.begin(), times.end()), times.end());  // nodes where the acceleration jumps
  return times;
}

}  // namespace physim
