// Equations, symbols and Source: model/motor.hpp.
#include "model/motor_table.hpp"

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>

#include "base/assert.hpp"
#include "base/ieee_mode.hpp"
#include "math/interpolation.hpp"

namespace physim {
namespace {

constexpr double kStandardGravity = 9.80665;

/// On which side of a step a table is read: two points at one time are one.
enum class Side { before, after };

/// Straight lines through points with a time and a value.
template <class Point>
double line_at(const std::vector<Point>& points, double Point::*value, double time, Side side = Side::after) {
  PHYSIM_ASSERT(!points.empty());
  const auto later = std::partition_point(points.begin(), points.end(), [&](const Point& point) {
    return side == Side::after ? point.time <= time : point.time < time;
  });
  if (later == points.begin()) return points.front().*value;
  if (later == points.end()) return points.back().*value;
  const Point& p1 = *later;
  const Point& p0 = *(later - 1);
  return p0.*value + (p1.*value - p0.*value) * ((time - p0.time) / (p1.time - p0.time));
}

/// Times at which thrust or mass may have a corner, from ignition to burnout.
std::vector<double> knots(const MotorDef& motor) {
  std::vector<double> times;
  for (const ThrustPoint& p : motor.thrust) times.push_back(p.time);
  for (const PropellantPoint& p : motor.propellant)
    if (p.time > 0 && p.time < burn_time(motor)) times.push_back(p.time);
  return rising(std::move(times));
}

/// The piece from t0 to t1 after ignition.
Burn<double> burning_piece(const MotorDef& motor, double impulse_before, double impulse, double t0, double t1) {
  PHYSIM_ASSERT(t0 >= 0 && t1 > t0);
  Burn<double> b{};
  b.start = motor.ignition_delay + t0;
  b.end = motor.ignition_delay + t1;
  b.thrust = line_at(motor.thrust, &ThrustPoint::force, t0);
  b.thrust_rate = (line_at(motor.thrust, &ThrustPoint::force, t1, Side::before) - b.thrust) / (t1 - t0);
  if (motor.propellant.empty()) {
    PHYSIM_ASSERT(impulse > 0);
    const double per_impulse = motor.propellant_mass / impulse;
    b.burned = per_impulse * impulse_before;
    b.burn_rate = per_impulse * b.thrust;
    b.burn_growth = per_impulse * (0.5 * b.thrust_rate);
  } else {
    b.burned = motor.propellant_mass - line_at(motor.propellant, &PropellantPoint::mass, t0);
    b.burn_rate =
        (motor.propellant_mass - line_at(motor.propellant, &PropellantPoint::mass, t1) - b.burned) / (t1 - t0);
  }
  return b;
}

std::size_t hash_of(const std::vector<MotorPiece>& pieces) {
  std::size_t h = pieces.size();
  for (const MotorPiece& p : pieces)
    for (const double x : {p.burn.end, p.burn.thrust, p.burn.burned, p.burn.drag_factor, p.curve.curve_row})
      h = h * 1000003 ^ std::hash<double>()(x);
  return h;
}

}  // namespace

double burn_time(const MotorDef& motor) { return motor.thrust.empty() ? 0 : motor.thrust.back().time; }

double total_impulse(const MotorDef& motor) {
  const IeeeMode mode;
  double sum = 0;
  for (std::size_t i = 1; i < motor.thrust.size(); ++i)
    sum +=
        0.5 * (motor.thrust[i].force + motor.thrust[i - 1].force) * (motor.thrust[i].time - motor.thrust[i - 1].time);
  return sum;
}

double specific_impulse(const MotorDef& motor) {
  const IeeeMode mode;
  return motor.propellant_mass > 0 ? total_impulse(motor) / (motor.propellant_mass * kStandardGravity) : 0;
}

double thrust_at(const MotorDef& motor, double time) {
  const IeeeMode mode;
  if (motor.thrust.empty() || time < 0 || time > burn_time(motor)) return 0;
  return line_at(motor.thrust, &ThrustPoint::force, time);
}

double propellant_left(const MotorDef& motor, double time) {
  const IeeeMode mode;
  if (motor.thrust.empty() || time <= 0) return motor.propellant_mass;
  if (time >= burn_time(motor)) return 0;
  if (!motor.propellant.empty()) return line_at(motor.propellant, &PropellantPoint::mass, time);
  double impulse = 0;
  for (std::size_t i = 1; i < motor.thrust.size() && motor.thrust[i - 1].time < time; ++i) {
    const double t0 = motor.thrust[i - 1].time;
    const double t1 = std::min(time, motor.thrust[i].time);
    const double f1 = line_at(motor.thrust, &ThrustPoint::force, t1, Side::before);
    impulse += 0.5 * (motor.thrust[i - 1].force + f1) * (t1 - t0);
  }
  return motor.propellant_mass * (1 - impulse / total_impulse(motor));
}

PHYSIM_COLD std::size_t MotorPool::add(const MotorDef& motor, const CurvePart<double>& coasting,
                                       const CurvePart<double>& burning, double drag_factor) {
  const double never = std::numeric_limits<double>::infinity();
  std::vector<MotorPiece> pieces;
  if (motor.ignition_delay > 0) pieces.push_back({no_burn(0.0, motor.ignition_delay, 0.0), coasting});
  const std::vector<double> times = knots(motor);
  PHYSIM_ASSERT(times.size() >= 2 && times.front() == 0);
  const double impulse = total_impulse(motor);
  double delivered = 0;
  for (std::size_t i = 0; i + 1 < times.size(); ++i) {
    Burn<double> burn = burning_piece(motor, delivered, impulse, times[i], times[i + 1]);
    const bool pauses = burn.thrust == 0 && burn.thrust_rate == 0;
    burn.drag_factor = pauses ? 1 : drag_factor;
    const double lasts = times[i + 1] - times[i];
    delivered += lasts * (burn.thrust + 0.5 * burn.thrust_rate * lasts);
    PHYSIM_ASSERT(pieces.empty() || pieces.back().burn.end == burn.start);
    pieces.push_back({burn, pauses ? coasting : burning});
  }
  pieces.push_back({no_burn(motor.ignition_delay + times.back(), never, motor.propellant_mass), coasting});

  PHYSIM_ASSERT(std::abs(delivered - impulse) <= 1e-9 * impulse);
  const std::size_t hash = hash_of(pieces);
  const auto [from, to] = known_.equal_range(hash);
  for (auto at = from; at != to; ++at)
    if (at->second + pieces.size() <= pieces_.size() &&
        std::equal(pieces.begin(), pieces.end(), pieces_.begin() + static_cast<std::ptrdiff_t>(at->second)))
      return at->second;
  const std::size_t first = pieces_.size();
  known_.emplace(hash, first);
  pieces_.insert(pieces_.end(), pieces.begin(), pieces.end());
  return first;
}

}  // namespace physim
