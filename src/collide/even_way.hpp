// Ways along surfaces between two states: where what slides, rolls or is carried is in between.
#pragma once

#include <cmath>
#include <functional>

#include "base/assert.hpp"
#include "math/vec3.hpp"
#include "model/body.hpp"

namespace physim {

/// Place and velocity of a point of a moving surface as a function of time [s]; empty if the surface is at rest.
using Carrier = std::function<State<double>(double)>;

/// A straight way from one state to another in some time with a constant acceleration along it; a projectile that comes
/// to rest before the end of the time stays there. What is carried goes such a way over what carries it.
///
/// Symbols: T time of the motion [s], L length of the way [m], v0, v1 speeds along it at its ends [m/s], tau = t / T,
///   sigma = s / L, f = 2 v0 / (v0 + v1).
/// Equation: sigma = tau (f + (1 - f) tau), T = 2 L / (v0 + v1); its inverse tau = 2 sigma / (f + sqrt(f^2 + 4 (1 - f)
///   sigma)) loses no digits where f is near 1.
/// When wrong: if the speeds at the ends contradict length and time, the way is steady, f = 1.
class EvenWay {
 public:
  PHYSIM_COLD EvenWay(const State<double>& from, const State<double>& to, double time, Carrier carrier = {})
      : from_(from), to_(to), end_(to), time_(time), carrier_(std::move(carrier)) {
    PHYSIM_ASSERT(time >= 0);
    constexpr double kEven = 1e-3;  // velocities and ways are rounded [-]
    if (carrier_) leave_carrier();
    const Vec3d chord = to_.x - from_.x, towards = normalized(chord);
    const double first = dot(from_.v, towards), last = dot(to_.v, towards), lasts = 2 * length(chord) / (first + last);
    if (!(first >= 0 && last >= 0 && lasts > 0 && lasts <= time * (1 + kEven))) return;
    first_ = 2 * (first / (first + last));
    if (last <= kEven * first) lasts_ = min(lasts / time, 1.0);
  }

  /// A moment of it.
  struct Moment {
    State<double> state;
    double time;     // since it began [s]
    double of_time;  // the part of the time that it goes [-]

    /// A number that changes evenly, too.
    [[nodiscard]] Vec3d mixed(const Vec3d& from, const Vec3d& to) const {
      return of_time < 1 ? from + (to - from) * of_time : to;
    }
  };
  /// After a part of the way: where something stands.
  [[nodiscard]] Moment after_way(double part) const {
    if (!(part > 0)) return {carrier_ ? (*this)(0) : from_, 0, 0};
    if (part >= 1) return {end_, time_, 1};
    const double of_time = 2 * part / (first_ + std::sqrt(first_ * first_ + 4 * (1 - first_) * part));
    return {at(of_time, part), of_time * lasts_ * time_, of_time};
  }
  /// After a part of the time, as if it went steadily: along its chord.
  [[nodiscard]] Moment steadily(double part) const {
    return {carrier_ ? (*this)(part) : at(part, part), part * time_, part};
  }
  /// After a part of the time.
  [[nodiscard]] Moment after_time(double part) const { return {(*this)(part), part * time_, part}; }
  [[nodiscard]] double time() const { return time_; }
  [[nodiscard]] State<double> operator()(double part) const {
    const double of_time = min(part / lasts_, 1.0);
    if (part < 1 && carrier_) return carried(part, of_time);
    return at(of_time, of_way(of_time));
  }

 private:
  [[nodiscard]] double of_way(double of_time) const { return of_time * (first_ + (1 - first_) * of_time); }
  [[nodiscard]] State<double> at(double of_time, double of_way) const {
    if (of_time >= 1) return end_;
    return {from_.x + (to_.x - from_.x) * of_way, from_.v + (to_.v - from_.v) * of_time};
  }
  /// The states at the ends as what carries it has them.
  PHYSIM_COLD void leave_carrier() {
    const State<double> first = carrier_(0), last = carrier_(time_);
    from_.v -= first.v, to_ = {from_.x + (to_.x - last.x), to_.v - last.v};
  }
  [[nodiscard]] PHYSIM_COLD State<double> carried(double part, double of_time) const {
    const State<double> by = carrier_(part * time_);
    return {by.x + (to_.x - from_.x) * of_way(of_time), by.v + from_.v + (to_.v - from_.v) * of_time};
  }
  State<double> from_, to_;  // as what carries it has them
  State<double> end_;
  double time_;
  Carrier carrier_;
  double first_ = 1;  // f [-]
  double lasts_ = 1;  // T of the time that was given [-]
};

}  // namespace physim
