// The path of one lane as its flight keeps it: nodes and interpolants, step by step and leg by leg.
#pragma once

#include <algorithm>
#include <optional>
#include <utility>

#include "base/assert.hpp"
#include "flight/flight_record.hpp"
#include "flight/known_step.hpp"
#include "solve/judge.hpp"
#include "solve/lane_motion.hpp"

namespace physim {

[[nodiscard]] inline std::size_t coefficient_count(const FlightRecord& record) {
  const Fidelity& f = record.cohort.in_use.fidelity;
  return f.motion == Motion::closed_form ? 0 : static_cast<std::size_t>(dense_coefficient_count(f.integrator));
}

/// Times of the march are since launch; the record's are since the flight began.
template <class S>
class PathKeeper {
 public:
  PathKeeper(FlightRecord& record, const Lanes<S>& lane) : record_(record), lane_(lane) {}

  // What interpolants need is kept in their place, and they are made on demand: few callers need all of them. Flights
  // of known steps that meet nothing do so.
  bool keeps_slopes = false;

  // What generators give.
  bool is_pushed = false;           // now and then
  Vec3d push{};                     // of late [m/s^2]
  std::optional<Body<S>> own_body;  // in a frame in which they push: without that

  /// A part of a frame: its start and end on the march's clock, and since the flight began.
  void note_times(S clock, double start, S limit, double finish) {
    part_ = {static_cast<double>(clock), start, static_cast<double>(limit), finish};
  }
  /// A time of the march as one since the flight began. The end of a frame is a whole number of frames, so that flights
  /// are asked there for what was flown and not for what lies a rounding beside it.
  [[nodiscard]] double since_start(double time) const {
    if (part_.finish == 0) return time;  // from a launch
    if (time >= part_.limit) return part_.finish;
    return std::min(part_.start + (time - part_.clock), part_.finish);
  }

  void keep_step(const DenseLanes<S>& at) {
    if constexpr (std::is_same_v<S, double>) {
      if (keeps_slopes) return keep_known_slopes();
    }
    const auto keep = [this, count = coefficient_count(record_)](const auto& dense, auto& path) {
      PHYSIM_ASSERT(!path.nodes.empty() && path.coefficients.size() == (path.nodes.size() - 1) * count);
      // Fixed steps count their time, which may differ from start + step by a rounding.
      path.nodes.back().t = since_start(dense.n0.t);
      path.nodes.push_back(dense.n1);
      path.nodes.back().t = since_start(dense.n1.t);
      path.coefficients.insert(path.coefficients.end(), dense.coefficient, dense.coefficient + count);
    };
    for_parts(fidelity(), keep, at, record_.path);
    keep_push();
  }

  /// The step just taken, of a known rung.
  void keep_known_step(const KnownStep& known) {
    if (keeps_slopes) return keep_known_slopes();
    const Step<S>& s = lane_.step;
    FlownPath& path = record_.path;
    const std::size_t count = path.coefficients.size(), more = coefficient_count(record_);
    PHYSIM_ASSERT(!path.nodes.empty() && count == (path.nodes.size() - 1) * more && !path.turn);
    path.nodes.back().t = since_start(s.t);
    path.nodes.push_back({since_start(s.t_end), s.end, s.slope[last_slope(fidelity())].v});
    path.coefficients.resize(count + more);
    if (known.interpolate) known.interpolate(s, path.coefficients.data() + count);
    keep_push();
  }

  /// Room for the steps of most flights, so that it is asked for once.
  void reserve() {
    constexpr std::size_t kSteps = kNearNodes - 1;
    constexpr std::size_t kEvents = 4;
    record_.events.reserve(kEvents);
    record_.path.nodes.reserve(kNearNodes);
    if (keeps_slopes)
      record_.path.kept.reserve(kSteps);
    else
      record_.path.coefficients.reserve(kSteps * coefficient_count(record_));
  }

  /// Takes known steps as long as they go on.
  [[nodiscard]] KnownStop go_on(const KnownStep& known, const Course<double>& course, Lanes<double>& lanes) {
    while (may_go_on(course, lanes)) {
      KnownFlight flight = lend_room(course, lanes);
      const KnownStop stop = known.go_on(flight);
      take_room(flight);
      if (stop.why != KnownEnd::out_of_room) return stop;
    }
    return {KnownEnd::of_another_rung, kAllWatched};
  }

  /// Keeps where a step starts; of a state's slope the acceleration alone.
  void keep_start(double time) {
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
    for_parts(fidelity(), keep, lane_.step, record_.path);
  }

  /// Where a stop makes the acceleration jump, or a contact in the last frame left a velocity of other steps, the next
  /// step starts from its own node, after a step of no length.
  void keep_jump() {
    PHYSIM_ASSERT(!record_.path.nodes.empty());
    const Node& last = record_.path.nodes.back();
    const bool is_same_speed = stagger(fidelity()) == 0 || vec_cast<double>(lane_.step.start.v) == last.y.v;
    if (is_same_speed && vec_cast<double>(lane_.step.slope[0].v) == last.a) return;
    keep_start(last.t);
    pad();
  }
  /// Before the last node nothing is interpolated.
  void pad() {
    const auto no_change = [count = coefficient_count(record_)](auto& path) {
      path.coefficients.resize((path.nodes.size() - 1) * count);
    };
    for_parts(fidelity(), no_change, record_.path);
    keep_push();
  }
  void keep_push() {
    if (is_pushed) record_.path.pushes.resize(record_.path.nodes.size(), push);
  }

  // ------------------------------------------------------------------------------------------- legs
  /// The next step begins a leg at a time since the flight began.
  void put_leg(double time) { coming_leg_ = time; }
  /// The first node of a frame: the last one's end, but where the acceleration jumps.
  void starts_frame() {
    if (record_.path.nodes.empty())
      keep_start(0);
    else if (coming_leg_)
      keep_leg(*std::exchange(coming_leg_, std::nullopt));
    else if (fidelity().motion != Motion::closed_form)
      keep_jump();
  }
  /// Where no step follows, it ends in a leg of one node.
  void finish_leg() {
    if (!coming_leg_) return;
    const State<S>& s = lane_.step.start;
    keep_node(*std::exchange(coming_leg_, std::nullopt), {vec_cast<double>(s.x), vec_cast<double>(s.v)}, true);
  }
  void keep_leg(double time) {
    begin_leg(time, false);
    keep_start(time);
    pad();
  }
  void begin_leg(double time, bool on_surface) {
    Body<double> body = wide_body(lane_);
    if (own_body) {  // what generators give is kept beside it
      body.applied = vec_cast<double>(own_body->applied);
      body.applied_until = static_cast<double>(own_body->applied_until);
    }
    const bool closed = fidelity().motion == Motion::closed_form;
    record_.bodies.push_back(body);
    record_.legs.push_back({.first_node = record_.path.nodes.size(),
                            .begins = time,
                            .clock = closed ? -time : record_.clock,
                            .body = record_.bodies.size() - 1,
                            .on_surface = on_surface});
  }
  /// A node that no step ends in; the first of a leg along a surface, or its second.
  void keep_node(double time, const State<double>& s, bool begins) {
    if (begins) begin_leg(time, true);
    record_.path.nodes.push_back({time, s, {}});
    if (record_.path.turn) {
      TurnNode node{time, {}, {}};
      cast_numbers(lane_.step.turn->start, node.y);
      record_.path.turn->nodes.push_back(node);
    }
    pad();
  }

 private:
  [[nodiscard]] const Fidelity& fidelity() const { return record_.cohort.in_use.fidelity; }

  /// Room for one more step. Lists grow in few steps, for what is long already is mostly a long flight's.
  void make_room() {
    const auto grow = [](auto& list) {
      PHYSIM_ASSERT(list.capacity() > 0);
      if (list.size() == list.capacity()) list.reserve(4 * list.size());
    };
    grow(record_.path.nodes);
    if (keeps_slopes) grow(record_.path.kept);
  }

  // Known steps are kept by the code that takes them: room is lent to it, and what it has filled is taken back. What is
  // lent is set to zero, so it is not all that there is.
  [[nodiscard]] KnownFlight lend_room(const Course<double>& course, Lanes<double>& lanes) {
    constexpr std::size_t kMostLent = 64;
    make_room();
    FlownPath& path = record_.path;
    const std::size_t count = path.nodes.size();
    std::size_t room = std::min(path.nodes.capacity(), count + kMostLent);
    if (keeps_slopes) room = std::min(room, path.kept.capacity() + 1);
    PHYSIM_ASSERT(count > 0 && !is_pushed && !path.turn && (!keeps_slopes || path.kept.size() == count - 1));
    path.nodes.resize(room);
    if (keeps_slopes) path.kept.resize(room - 1);
    Node* const nodes = path.nodes.data();
    KeptStep* const kept = keeps_slopes ? path.kept.data() + (count - 1) : nullptr;
    return {course, lanes, nodes + count, nodes + room, kept, on_curve_};
  }
  void take_room(const KnownFlight& flight) {
    FlownPath& path = record_.path;
    path.nodes.resize(static_cast<std::size_t>(flight.node - path.nodes.data()));
    if (keeps_slopes) path.kept.resize(path.nodes.size() - 1);
  }

  void keep_known_slopes() {
    const Step<S>& s = lane_.step;
    FlownPath& path = record_.path;
    PHYSIM_ASSERT(!path.nodes.empty() && path.kept.size() == path.nodes.size() - 1 && !is_pushed && !path.turn);
    make_room();
    keep_end(s, path.nodes.emplace_back());
    keep_slopes(s, path.kept.emplace_back());
  }

  FlightRecord& record_;
  const Lanes<S>& lane_;
  std::optional<double> coming_leg_;  // [s]
  CurvePlace on_curve_;               // of known steps
  struct {
    double clock, start, limit, finish;
  } part_{};  // of the frame at hand; all 0 in flights from a launch
};

}  // namespace physim
