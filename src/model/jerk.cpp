// Equations, symbols and Source: model/jerk.hpp.
#include "model/jerk.hpp"

#include <algorithm>

#include "base/assert.hpp"
#include "math/elementary.hpp"

namespace physim {
namespace {

constexpr double kLongest = 1e-3;   // step in time [s]
constexpr double kMostPart = 1e-2;  // of the time in which drag stops it or its nose turns by a radian [-]

/// The path near a moment, to first order in the attitude and to second in the place.
class Nearby {
 public:
  Nearby(const Conditions<double>& c, const Body<double>& b, const Rotor<double>& rotor, double t,
         const State<double>& s, const Turn<double>& turn, const PushChange& push_change)
      : c_(c), b_(b), rotor_(rotor), t_(t), s_(s), turn_(turn), push_change_(push_change) {
    // The force does not end within the step: it acts on this side of its end, or does not.
    b_.applied_until = t < b.applied_until ? constant<double>(kInfinity) : 0;
    const Accelerations now = accelerations_of(c, b_, rotor, t, s, turn);
    slope_ = now.total;  // with damping, which the original's register does not hold
    if (turns(c.fidelity)) {
      Sum<double> sum;
      sum_effects(c, b_, rotor, t, s, turn, turn_slope_, sum);
    }
    const double speed = length(s.v), stops = speed > 0 ? length(now.drag) / speed : 0;
    const double nose = sqrt(turn_slope_.w * turn_slope_.w + length_squared(turn_slope_.u));
    const bool has_nose = turns(c.fidelity) && !is_in_repose(c.fidelity);
    step_ = std::min(kLongest, kMostPart / std::max({stops, has_nose ? nose : 0.0, kMostPart / kLongest}));
    PHYSIM_ASSERT(!(step_ < 0) && step_ <= kLongest);
  }

  [[nodiscard]] Vec3d jerk() const { return (slope_over(0.5 * step_) * 4 - slope_over(step_)) * (1.0 / 3); }

 private:
  [[nodiscard]] Vec3d slope_over(double h) const { return (at(h) - at(-h)) * (0.5 / h); }

  [[nodiscard]] Vec3d at(double h) const {
    PHYSIM_ASSERT(h >= -kLongest && h <= kLongest);
    const State<double> s{s_.x + s_.v * h + slope_ * (0.5 * h * h), s_.v + slope_ * h};
    const double t = t_ + h;
    Vec3d a;
    if (turns(c_.fidelity)) {
      Turn<double> slope, turn = turn_ + turn_slope_ * h;
      if (!is_in_repose(c_.fidelity)) turn = on_unit_length(c_.fidelity, turn);
      evaluate(c_, b_, rotor_, t, s, turn, no_step<double>(), a, slope);
    } else {
      a = is_classic(c_.fidelity) ? evaluated_original(c_, b_, t, s) : acceleration(c_, b_, t, s);
    }
    return push_change_ ? a + constrained(c_, b_, push_change_(s)) : a;
  }

  const Conditions<double>& c_;
  Body<double> b_;
  const Rotor<double>& rotor_;
  double t_;
  const State<double>& s_;
  const Turn<double>& turn_;
  const PushChange& push_change_;
  Vec3d slope_;                // of the velocity [m/s^2]
  Turn<double> turn_slope_{};  // of the attitude
  double step_ = kLongest;     // [s]
};

}  // namespace

Vec3d jerk_of(const Conditions<double>& c, const Body<double>& b, const Rotor<double>& rotor, double t,
              const State<double>& s, const Turn<double>& turn, const PushChange& push_change) {
  return Nearby(c, b, rotor, t, s, turn, push_change).jerk();
}

}  // namespace physim
