// Equations: flight/neighbours.hpp.
#include "flight/neighbours.hpp"

#include <algorithm>
#include <cmath>

#include "math/elementary.hpp"
#include "model/wind.hpp"

namespace physim {
namespace {

constexpr int kSpeeds = 48;                 // of the learned drag
constexpr std::size_t kMostIntervals = 32;  // between nodes, before stiff ones are divided
constexpr std::size_t kLeastSteps = 10;
constexpr std::size_t kMostParts = 40;   // of a stiff step
constexpr double kTiny = 1e-4;           // difference of launch velocities, relative to the speed
constexpr double kDensityHeight = 9500;  // over which the lower air thins by e [m]

/// The ends of the steps of a flight, thinned out or filled up to a useful number.
std::vector<double> useful_times(const Flight& flight) {
  const std::vector<double> steps = flight.step_times();
  PHYSIM_ASSERT(steps.size() >= 2);
  const std::size_t count = steps.size() - 1;
  const std::size_t stride = (count + kMostIntervals - 1) / kMostIntervals;
  std::vector<double> times{0};
  for (std::size_t i = stride; i < count + stride; i += stride) {
    const double from = times.back();
    const double to = steps[std::min(i, count)];
    const std::size_t parts = std::max<std::size_t>(1, kLeastSteps / count);
    for (std::size_t part = 1; part <= parts; ++part)
      times.push_back(part == parts ? to : from + (to - from) * static_cast<double>(part) / static_cast<double>(parts));
  }
  return times;
}

/// Number of the time that ends the stretch which a time lies in.
std::size_t later_time(const std::vector<double>& times, double time) {
  PHYSIM_ASSERT(times.size() >= 2);
  return static_cast<std::size_t>(std::upper_bound(times.begin() + 1, times.end() - 1, time) - times.begin());
}

}  // namespace

Neighbours::Neighbours(const Flight& flight, const Environment& environment, const Conditions<double>& conditions)
    : flight_(flight), conditions_(&conditions) {
  const Fidelity& granted = flight.fidelity_in_use().fidelity;
  launch_velocity_ = flight.at(0).velocity;
  wind_varies_ = granted.wind == WindModel::profile || (is_round(granted.earth) && granted.wind != WindModel::off);
  wind_ = wind(*conditions_, launched_, 0.0, flight.at(0).position);
  if (granted.planar) plane_ = normalized(cross(launch_velocity_, Vec3d{0, 1, 0}));
  if (granted.air == AirModel::exponential) per_height_ = 1 / environment.atmosphere.scale_height;
  if (granted.air == AirModel::isa) per_height_ = 1 / kDensityHeight;
  if (granted.drag != DragModel::equation) per_height_ = 0;
  if (is_round(granted.earth) && falls(granted.gravity)) {
    radius_ = environment.gravity.radius + environment.altitude;
    gravity_ = length(flight.accelerations(0).gravity);
  }
  const std::vector<double> coarse = useful_times(flight);
  learn_drag(flight, coarse);
  times_.push_back(0);
  for (std::size_t i = 1; i < coarse.size(); ++i) {
    const double h = coarse[i] - coarse[i - 1];
    const double damping =
        h * drag_rate(length(flight.at(coarse[i]).velocity - wind_at(coarse[i], flight.at(coarse[i]).position)));
    const auto parts = static_cast<std::size_t>(damping > 1 ? std::ceil(std::min(damping, double{kMostParts})) : 1);
    for (std::size_t part = 1; part <= parts; ++part)
      times_.push_back(coarse[i - 1] + h * static_cast<double>(part) / static_cast<double>(parts));
    times_.back() = coarse[i];
  }
  for (std::size_t i = 0; i < times_.size(); ++i) {
    const auto keep = [&](double time) {
      const Sample sample = flight.at(time);
      known_.push_back({time, sample.position, sample.velocity});
    };
    if (i > 0) keep(0.5 * (times_[i - 1] + times_[i]));
    keep(times_[i]);
  }
  PHYSIM_ASSERT(std::is_sorted(times_.begin(), times_.end()) && known_.size() == 2 * times_.size() - 1);
  move_to({});
}

// ------------------------------------------------------------------------------------------------------- the model m
void Neighbours::learn_drag(const Flight& flight, std::span<const double> times) {
  most_speed_ = 1e-9;
  std::vector<std::pair<double, double>> found;
  for (const double time : times) {
    const Sample sample = flight.at(time);
    const double speed = length(sample.velocity - wind_at(time, sample.position));
    const double thinner = per_height_ == 0 ? 1 : exp(-per_height_ * sample.position.y);
    if (speed > 0 && speed < 1e12)
      found.emplace_back(speed, length(flight.accelerations(time).drag) / (speed * thinner));
    if (speed < 1e12) most_speed_ = std::max(most_speed_, speed);
  }
  rate_.assign(kSpeeds + 1, -1);
  for (std::size_t i = 1; i < found.size(); ++i)
    spread_rate(found[i - 1].first, found[i - 1].second, found[i].first, found[i].second);
  // Below and between what was flown: in proportion to speed, as drag in the square of it has.
  double last = 0, last_speed = 0;
  for (int i = kSpeeds; i >= 0; --i) {
    const double speed = most_speed_ * i / kSpeeds;
    if (rate_[static_cast<std::size_t>(i)] >= 0) {
      last = rate_[static_cast<std::size_t>(i)];
      last_speed = speed;
    } else if (last_speed > 0) {
      rate_[static_cast<std::size_t>(i)] = last * speed / last_speed;
    } else {
      rate_[static_cast<std::size_t>(i)] = found.empty() ? 0 : found.front().second;
    }
  }
}

/// Sets the rate at the even speeds between two that were flown; the mean where a speed was flown twice.
void Neighbours::spread_rate(double speed0, double rate0, double speed1, double rate1) {
  if (speed0 > speed1) return spread_rate(speed1, rate1, speed0, rate0);
  const double cell = most_speed_ / kSpeeds;
  for (int i = static_cast<int>(std::ceil(speed0 / cell)); i <= kSpeeds && i * cell <= speed1; ++i) {
    const double part = speed1 > speed0 ? (i * cell - speed0) / (speed1 - speed0) : 0;
    const double rate = rate0 + part * (rate1 - rate0);
    double& known = rate_[static_cast<std::size_t>(i)];
    known = known < 0 ? rate : 0.5 * (known + rate);
  }
}

double Neighbours::drag_rate(double speed) const {
  const double place = speed / most_speed_ * kSpeeds;
  if (!(place < kSpeeds)) return rate_.back() * speed / most_speed_;
  const auto i = static_cast<std::size_t>(place);
  PHYSIM_ASSERT(i + 1 < rate_.size());
  return rate_[i] + (place - static_cast<double>(i)) * (rate_[i + 1] - rate_[i]);
}

Vec3d Neighbours::wind_at(double time, const Vec3d& x) const {
  return wind_varies_ ? wind(*conditions_, launched_, time, x) : wind_;
}

Vec3d Neighbours::pull(double time, const Vec3d& x, const Vec3d& v) const {
  const Vec3d u = v - wind_at(time, x);
  const double thinner = per_height_ == 0 ? 1 : exp(clamp(-per_height_ * x.y, -50.0, 2.0));
  Vec3d a = u * (-drag_rate(length(u)) * thinner);
  a -= plane_ * dot(plane_, a);
  if (radius_ == 0) return a;
  const Vec3d from_centre = x + Vec3d{0, radius_, 0};
  const double part = radius_ / length(from_centre);
  return a - from_centre * (gravity_ / radius_ * part * part * part);
}

// -------------------------------------------------------------------------------------------------------- integration
Neighbours::Node Neighbours::rates(const Known& known, const Node& node) const {
  const Vec3d here = pull(known.time, known.x, known.v);
  Node out;
  for (int i = 0; i < 4; ++i) {
    const Offset& d = node.path[i];
    out.path[i] = {d.v, pull(known.time, known.x + d.x, known.v + d.v) - here};
  }
  return out;
}

Neighbours::Node Neighbours::stepped(const Node& from, const Known& k0, const Known& k1, const Known& k2,
                                     double h) const {
  const auto plus = [](const Node& a, const Node& slope, double by) {
    Node out;
    for (int i = 0; i < 4; ++i) out.path[i] = {a.path[i].x + slope.path[i].x * by, a.path[i].v + slope.path[i].v * by};
    return out;
  };
  const Node s1 = rates(k0, from);
  const Node s2 = rates(k1, plus(from, s1, 0.5 * h));
  const Node s3 = rates(k1, plus(from, s2, 0.5 * h));
  const Node s4 = rates(k2, plus(from, s3, h));
  return plus(plus(plus(plus(from, s1, h / 6), s2, h / 3), s3, h / 3), s4, h / 6);
}

void Neighbours::move_to(const Vec3d& change) {
  change_ = change;
  const double tiny = kTiny * length(launch_velocity_);
  nodes_.resize(times_.size());
  nodes_[0] = {};
  for (int k = 0; k < 4; ++k) {
    changes_[k] = change + Vec3d{k == 1 ? tiny : 0, k == 2 ? tiny : 0, k == 3 ? tiny : 0};
    nodes_[0].path[k].v = changes_[k] - plane_ * dot(plane_, changes_[k]);
  }
  for (std::size_t i = 1; i < times_.size(); ++i)
    nodes_[i] = stepped(nodes_[i - 1], known_[2 * i - 2], known_[2 * i - 1], known_[2 * i], times_[i] - times_[i - 1]);
}

void Neighbours::learn_from(Neighbours& before) {
  const Vec3d c = launch_velocity_ - before.launch_velocity_;
  if (!(length_squared(c) > 0)) return;
  before.move_to(c);
  error_of_ = c * (1 / length_squared(c));
  PHYSIM_ASSERT(change_ == Vec3d{});  // it has not moved on yet
  error_.assign(times_.size(), {});
  const double end = before.times_.back();
  for (std::size_t i = 1; i < times_.size(); ++i) {
    const double t = min(times_[i], end);
    const double grown = times_[i] / t;  // beyond what was known
    const Vec3d foretold = before.flight_.at(t).position + before.between(t).path[0].x;
    error_[i] = (flight_.at(t).position - foretold) * (grown * grown);
  }
}

Vec3d Neighbours::error_at(double time) const {
  if (error_.empty()) return {};
  const std::size_t i = later_time(times_, time);
  const double part = (time - times_[i - 1]) / (times_[i] - times_[i - 1]);
  return error_[i - 1] + (error_[i] - error_[i - 1]) * part;
}

/// The offsets at any time, by cubics through the nodes.
Neighbours::Node Neighbours::between(double time) const {
  PHYSIM_ASSERT(nodes_.size() == times_.size());
  const std::size_t i = later_time(times_, time);
  const double h = times_[i] - times_[i - 1];
  const double s = (time - times_[i - 1]) / h;
  const double b0 = (1 + 2 * s) * (1 - s) * (1 - s), b1 = s * s * (3 - 2 * s);
  const double c0 = h * s * (1 - s) * (1 - s), c1 = h * s * s * (s - 1);
  Node out;
  for (int k = 0; k < 4; ++k) {
    const Offset& from = nodes_[i - 1].path[k];
    const Offset& to = nodes_[i].path[k];
    out.path[k].x = from.x * b0 + to.x * b1 + from.v * c0 + to.v * c1;
  }
  if (plane_ == Vec3d{}) return out;
  // The plane turns about the vertical with the direction of fire, and the whole path with it.
  const Vec3d forward = cross(Vec3d{0, 1, 0}, plane_);
  const double reach = dot(flight_.at(time).position - known_.front().x, forward) / dot(launch_velocity_, forward);
  for (int k = 0; k < 4; ++k) out.path[k].x += plane_ * (dot(plane_, changes_[k]) * reach);
  return out;
}

Vec3d Neighbours::required_velocity(const Vec3d& place, double time) const {
  const Node node = between(time);
  const Vec3d e = error_at(time);
  const double per_tiny = 1 / (kTiny * length(launch_velocity_));
  // How the place changes with each component of the launch velocity, and the linear equations for the change.
  const Vec3d a = (node.path[1].x - node.path[0].x) * per_tiny + e * error_of_.x;
  const Vec3d b = (node.path[2].x - node.path[0].x) * per_tiny + e * error_of_.y;
  const Vec3d c = (node.path[3].x - node.path[0].x) * per_tiny + e * error_of_.z;
  const Vec3d here = flight_.at(time).position + node.path[0].x + e * dot(error_of_, change_);
  const Vec3d off = place - here;
  const Vec3d bc = cross(b, c), ca = cross(c, a), ab = cross(a, b);
  return launch_velocity() + Vec3d{dot(off, bc), dot(off, ca), dot(off, ab)} * (1 / dot(a, bc));
}

}  // namespace physim
