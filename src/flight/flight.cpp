// Flight: answers questions about a computed trajectory.
#include <algorithm>

#include "base/assert.hpp"
#include "base/checker.hpp"
#include "base/ieee_mode.hpp"
#include "base/text.hpp"
#include "flight/flight_record.hpp"
#include "model/attitude.hpp"
#include "model/jerk.hpp"
#include "model/stability.hpp"
#include "prepare/grant.hpp"
#include "solve/watch.hpp"

namespace physim {

State<double> with_drift(const State<double>& s, const SpinDrift& drift, const Vec3d& right, double time) {
  if (drift.coefficient == 0) return s;
  return {s.x + right * drift.drift(time), s.v + right * drift.drift_rate(time)};
}

namespace {

double nearest_time(double time, double duration) { return time > 0 ? std::min(time, duration) : 0; }

using LegPart = FlightRecord::LegPart;

/// Number of the node that ends the step of a leg which a time lies in.
std::size_t later_node(const NodeList& nodes, const LegPart& part, double time) {
  PHYSIM_ASSERT(part.end_node <= nodes.size() && part.end_node - part.leg.first_node >= 2);
  const auto at = [&](std::size_t node) { return nodes.begin() + static_cast<std::ptrdiff_t>(node); };
  const auto later = std::upper_bound(at(part.leg.first_node + 1), at(part.end_node - 1), time,
                                      [](double t, const Node& node) { return t < node.t; });
  return static_cast<std::size_t>(later - nodes.begin());
}

/// The node of a leg at a very time; null if there is no such node.
const Node* node_at(const NodeList& nodes, const LegPart& part, double time) {
  const auto first = nodes.begin() + static_cast<std::ptrdiff_t>(part.leg.first_node);
  const auto end = nodes.begin() + static_cast<std::ptrdiff_t>(part.end_node);
  const auto at = std::lower_bound(first, end, time, [](const Node& n, double t) { return n.t < t; });
  return at != end && at->t == time ? &*at : nullptr;
}

/// Along a surface the velocity changes evenly.
State<double> state_on_surface(const Node& n0, const Node& n1, double theta) {
  const double h = n1.t - n0.t, u = 1 - theta;
  const Vec3d rise = n1.y.x - n0.y.x;
  const Vec3d x = n0.y.x + rise * (theta * theta * (3 - 2 * theta)) + n0.y.v * (h * theta * u * u) -
                  n1.y.v * (h * theta * theta * u);
  if (theta == 1) return n1.y;
  return {x, n0.y.v + (n1.y.v - n0.y.v) * theta};
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
  std::vector<double> times = r.node_times();
  if (r.cohort.in_use.fidelity.motion == Motion::closed_form) times.insert(times.begin(), 0);
  for (const Event& e : r.events)
    if (e.kind == EventKind::apex) times.insert(std::ranges::upper_bound(times, e.time), e.time);
  times.erase(std::unique(times.begin(), times.end()), times.end());
  PHYSIM_ASSERT(std::ranges::is_sorted(times));
  return times;
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

LegPart FlightRecord::leg(std::size_t number) const {
  const bool is_last = number + 1 >= legs.size();
  if (legs.empty()) return {{.clock = clock}, 0, path.nodes.size(), duration};
  return {legs[number], number, is_last ? path.nodes.size() : legs[number + 1].first_node,
          is_last ? duration : legs[number + 1].begins};
}

LegPart FlightRecord::leg_at(double time) const {
  if (legs.empty()) return leg(0);
  const auto later = std::upper_bound(legs.begin() + 1, legs.end(), time,
                                      [](double t, const FlightLeg& each) { return t < each.begins; });
  return leg(static_cast<std::size_t>(later - legs.begin()) - 1);
}

std::vector<double> FlightRecord::node_times() const {
  std::vector<double> times;
  times.reserve(path.nodes.size() + 1);
  for (std::size_t i = 0; i < std::max<std::size_t>(legs.size(), 1); ++i) {
    const LegPart part = leg(i);
    for (std::size_t node = part.leg.first_node; node < part.end_node; ++node)
      times.push_back(std::min({path.nodes[node].t, part.end, duration}));
  }
  return times;
}

const SpinDrift& FlightRecord::drift_at(double time) const {
  static constexpr SpinDrift kNone{};
  return leg_at(time).number == 0 ? drift : kNone;
}

Accelerations FlightRecord::accelerations_at(double time) const {
  Body<double> changed;
  return accelerations_of_body(time, body_at(time, changed), state(time));
}

Accelerations FlightRecord::accelerations_of_body(double time, const Body<double>& at, const State<double>& s) const {
  Accelerations a = accelerations_of(cohort.conditions, at, rotor, clock + time, s, turn(time));
  const LegPart part = leg_at(time);
  if (is_classic(cohort.in_use.fidelity) && part.end_node > part.leg.first_node + 1)
    a.total = path.nodes[later_node(path.nodes, part, time) - 1].a;
  return a;
}

const Body<double>& FlightRecord::body_at(double time, Body<double>& changed) const {
  const Conditions<double>& c = cohort.conditions;
  const LegPart part = leg_at(time);
  if (!has_stops(c) && path.pushes.size() <= 1) return body_of(part);
  Body<double>& b = changed = body_of(part);
  if (has_stops(c)) {
    for (const Event& e : events)
      if (e.kind == EventKind::rail_exit && e.time <= time) b.rail_phase = kOffRail;
    State<double> s = state(time);
    pass_stops(c, clock + time, true, s, b);
  }
  if (path.pushes.size() > 1 && part.end_node > part.leg.first_node + 1) {
    PHYSIM_ASSERT(path.pushes.size() == path.nodes.size());
    const std::size_t later = later_node(path.nodes, part, time);
    const double place = place_between(path.nodes[later - 1], path.nodes[later], time);
    const Vec3d &before = path.pushes[later - 1], &after = path.pushes[later];
    add_push(c, {clock + time, clock + time}, clock + time, before + (after - before) * place, has_own_force, b);
  }
  return b;
}

State<double> FlightRecord::state(double time) const {
  const Fidelity& f = cohort.in_use.fidelity;
  const auto& nodes = path.nodes;
  const LegPart part = leg_at(time);
  if (f.motion == Motion::closed_form && !part.leg.on_surface) {
    if (const Node* node = is_framed ? node_at(nodes, part, time) : nullptr) return node->y;
    const Body<double>& own = body_of(part);
    if (f.precision == Precision::float64) return closed_form(cohort.conditions, own, part.leg.clock + time);
    Body<float> narrow;
    cast_numbers(own, narrow);
    const State<float> s = closed_form(cohort.conditions_float, narrow, static_cast<float>(part.leg.clock + time));
    return {vec_cast<double>(s.x), vec_cast<double>(s.v)};
  }
  if (nodes.empty()) return body.launch;
  if (part.end_node - part.leg.first_node < 2) return nodes[part.leg.first_node].y;
  const std::size_t later = later_node(nodes, part, time);
  const Node &n0 = nodes[later - 1], &n1 = nodes[later];
  const double theta = place_between(n0, n1, time);
  if (part.leg.on_surface) return state_on_surface(n0, n1, theta);
  if (theta == 0) return n0.y;
  if (theta == 1) return n1.y;
  if (path.kept.empty())
    return dense_state(f.integrator, n0, n1, coefficients_before(path.coefficients, f.integrator, later), theta);
  State<double> coefficients[kMaxDenseCoefficients];
  interpolate_kept(path.kept[later - 1], n0, n1, coefficients);
  return dense_state(f.integrator, n0, n1, coefficients, theta);
}

Turn<double> FlightRecord::turn(double time) const {
  const auto& nodes = path.nodes;
  if (!path.turn || nodes.empty()) return rotor.launch;
  const LegPart part = leg_at(time);
  PHYSIM_ASSERT(path.turn->nodes.size() == nodes.size());
  if (part.end_node - part.leg.first_node < 2)
    return part.number == 0 ? rotor.launch : path.turn->nodes[part.leg.first_node].y;
  const Fidelity& f = cohort.in_use.fidelity;
  const std::size_t later = later_node(nodes, part, time);
  const TurnNode &n0 = path.turn->nodes[later - 1], &n1 = path.turn->nodes[later];
  const double theta = place_between(nodes[later - 1], nodes[later], time);
  if (part.leg.on_surface) return on_unit_length(f, n0.y + (n1.y - n0.y) * theta);
  return dense_turn(f, n0, n1, coefficients_before(path.turn->coefficients, f.integrator, later), theta);
}

State<double> FlightRecord::shown(double time) const {
  return with_drift(state(time), drift_at(time), sight.right, time);
}

std::shared_ptr<const FlightRecord> Flight::none() noexcept {
  static const auto record = [] {
    auto none = std::make_shared<FlightRecord>();
    none->error = Error{"there is no flight", "flight", "it was moved away, or nothing was flown"};
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

Vec3d Flight::jerk(double time) const {
  const IeeeMode mode;
  const FlightRecord& r = *record_;
  if (r.outcome == Outcome::refused) return {};
  time = nearest_time(time, r.duration);
  Body<double> changed;
  const Body<double>& b = r.body_at(time, changed);
  return jerk_of(r.cohort.conditions, b, r.rotor, r.clock + time, r.state(time), r.turn(time));
}

const ProjectileDef& Flight::projectile() const { return record_->projectile; }

Result<Departure> Flight::departure(double time) const {
  const IeeeMode mode;
  const FlightRecord& r = *record_;
  if (r.error) return *r.error;
  if (!(time >= 0 && time <= r.duration))
    return Error{"is no time of the flight", "time", "it lasts " + short_text(r.duration) + " s"};
  Body<double> changed;
  const Body<double>& b = r.body_at(time, changed);
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
  const State<double> flown = r.state(time);
  const State<double> s = with_drift(flown, r.drift_at(time), r.sight.right, time);
  Body<double> changed;
  const Body<double>& b = r.body_at(time, changed);
  const Conditions<double>& c = r.cohort.conditions;
  out.time = time;
  out.position = s.x;
  out.velocity = s.v;
  out.acceleration = r.accelerations_of_body(time, b, flown).total;
  out.speed = length(s.v);
  mach_number(c, r.body, r.clock + time, s, out.mach);
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
  // A range in yards, converted to metres, or that of a wall or a landing, may exceed the end of the flight by one
  // rounding.
  constexpr double kRounding = 1e-12;
  if (abs(past(r.duration)) <= kRounding * abs(range)) return at(r.duration);
  return never("a range of " + short_text(range) + " m", r);
}

Result<Sample> Flight::at_height(double level, Crossing direction) const {
  const IeeeMode mode;
  const FlightRecord& r = *record_;
  if (const Status status = Checker().named(direction, "direction").status(); !status) return status.error();
  const auto above = [&](double t) { return height(r.cohort.conditions, r.state(t).x) - level; };
  if (r.outcome == Outcome::refused) return never("anything", r);
  if (const auto time = first_crossing(r, direction, {.kind = EventKind::height, .value = level}, above))
    return at(*time);
  return never("a height of " + short_text(level) + " m", r);
}

std::vector<double> Flight::step_times() const {
  const IeeeMode mode;
  std::vector<double> times = record_->node_times();
  times.erase(std::unique(times.begin(), times.end()), times.end());  // nodes where the acceleration jumps
  return times;
}

}  // namespace physim
