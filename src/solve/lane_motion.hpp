// How one lane turns and accelerates between two of its steps, in double whatever its own precision. `t` is the time on
// its march's clock.
#pragma once

#include <optional>

#include "model/attitude.hpp"
#include "model/magnus.hpp"
#include "solve/lanes.hpp"

namespace physim {

template <class S>
[[nodiscard]] Body<double> wide_body(const Lanes<S>& lane) {
  Body<double> body;
  cast_numbers(lane.body, body);
  return body;
}

/// How it points and turns where its step starts, where its rung flies that.
template <class S>
[[nodiscard]] Attitude attitude_of_lane(const Conditions<double>& c, const Lanes<S>& lane, double t) {
  PHYSIM_ASSERT(turns(c.fidelity));
  Rotor<double> rotor;
  Turn<double> turn;
  cast_numbers(*lane.rotor, rotor);
  cast_numbers(lane.step.turn->start, turn);
  const State<double> s{vec_cast<double>(lane.step.start.x), vec_cast<double>(lane.step.start.v)};
  return attitude_of(c, wide_body(lane), rotor, t, s, turn);
}

/// Its acceleration in a state, with the rotation it has where its step starts; `held` are the numbers of its body that
/// its course names.
template <class S>
[[nodiscard]] Vec3d acceleration_of_lane(const Conditions<double>& c, const Lanes<S>& lane, const NumberRuns& held,
                                         double t, const State<double>& s) {
  if (!turns(c.fidelity)) {
    Body<double> body;
    cast_numbers(lane.body, body, held);
    return evaluated(c, body, t, s);
  }
  Rotor<double> rotor;
  Turn<double> turn, slope;
  cast_numbers(*lane.rotor, rotor);
  cast_numbers(lane.step.turn->start, turn);
  return evaluated(c, wide_body(lane), rotor, t, s, turn, slope);
}

/// What the constraints of its motion leave of a velocity or a way.
template <class S>
[[nodiscard]] Vec3d kept_of_lane(const Conditions<double>& c, const Lanes<S>& lane, const Vec3d& v) {
  if (!c.fidelity.planar && !c.has_frozen && !c.has_rail) return v;
  return constrained(c, wide_body(lane), v);
}

/// Angular velocity of W in inertial space [rad/s].
[[nodiscard]] inline Vec3d spin_of_W(const Conditions<double>& c) {
  return is_turning(c.fidelity.earth) ? c.omega : Vec3d{};
}

/// Its angular velocity in W as its rung flies it; nothing where the rung flies none [rad/s].
template <class S>
[[nodiscard]] std::optional<Vec3d> spin_of_lane(const Conditions<double>& c, const Lanes<S>& lane, S start,
                                                double passed) {
  if (c.fidelity.rotation == RotationModel::rigid_body) {
    const Attitude now = attitude_of_lane(c, lane, static_cast<double>(start) + passed);
    return rotate(now.q_WB, now.omega) - spin_of_W(c);
  }
  if (spins(c.fidelity)) return vec_cast<double>(spin_at(lane.body, start + static_cast<S>(passed)));
  return std::nullopt;
}

/// Gives it another one; false where its rung flies none.
template <class S>
[[nodiscard]] bool put_spin_of_lane(const Conditions<double>& c, Lanes<S>& lane, S start, double passed,
                                    const Vec3d& spin) {
  if (c.fidelity.rotation == RotationModel::rigid_body) {
    Attitude now = attitude_of_lane(c, lane, static_cast<double>(start) + passed);
    now.omega = rotate(conjugate(now.q_WB), spin + spin_of_W(c));
    Rotor<double> rotor;
    cast_numbers(*lane.rotor, rotor);
    cast_numbers(turn_of(c.fidelity, rotor, now), lane.step.turn->start);
    return true;
  }
  if (!spins(c.fidelity)) return false;
  // The model counts the decay from launch on.
  const S decay = lane.body.spin_decay * (start + static_cast<S>(passed));
  constexpr S kAllGone(60);  // by then nothing turns that could
  lane.body.spin = vec_cast<S>(spin) * exp(decay < kAllGone ? decay : kAllGone);
  return true;
}

}  // namespace physim
