// Questions of range: how far a projectile carries, how long it takes to a range, and where it stays near a height.
#include <algorithm>
#include <cmath>

#include "base/checker.hpp"
#include "base/ieee_mode.hpp"
#include "base/text.hpp"
#include "flight/step_budget.hpp"
#include "math/angles.hpp"
#include "math/elementary.hpp"
#include "math/minimum.hpp"
#include "math/root.hpp"
#include "math/vec3.hpp"
#include "model/earth.hpp"
#include "model/sight.hpp"
#include "physim/names.hpp"
#include "physim/scene.hpp"
#include "physim/solve.hpp"
#include "prepare/check.hpp"
#include "prepare/grant.hpp"

namespace physim {
namespace {

/// Time at which a value along a flight first falls through zero, or starts to fall from there; nothing where it does
/// not.
std::optional<double> first_fall(const Flight& flight, const auto& value) {
  constexpr int kParts = 4;  // of a step, which is long where little happens
  const std::vector<double> times = flight.step_times();
  double before = 0, at_before = value(0);
  for (std::size_t i = 1; i < times.size(); ++i)
    for (int part = 1; part <= kParts; ++part) {
      const double time = times[i - 1] + (times[i] - times[i - 1]) * part / kParts;
      const double at_time = value(time);
      if (before == 0 && at_before <= 0 && at_time < 0) return 0.0;  // straight into it
      if (at_before > 0 && at_time <= 0) return find_root(value, before, at_before, time, at_time, 1e-13 * time);
      before = time;
      at_before = at_time;
    }
  return std::nullopt;
}

/// Shots over even ground, judged by where they come down.
class Carry {
 public:
  Carry(const ProjectileDef& projectile, const Launch& launch, const Environment& environment, const Fidelity& fidelity,
        double ground, double slope, double time)
      : projectile_(projectile), launch_(launch), environment_(environment), fidelity_(fidelity), slope_(slope) {
    if (launch_.velocity) launch_.speed = length(*launch_.velocity);
    launch_.velocity.reset();
    launch_.sight = {};
    const SinCos<double> azimuth = sincos(launch.azimuth), rise = sincos(slope);
    base_ = {launch.position.x, ground, launch.position.z};
    ahead_ = {azimuth.cos, 0, azimuth.sin};
    up_ = {-rise.sin * azimuth.cos, rise.cos, -rise.sin * azimuth.sin};
    until_.ground = slope == 0 ? std::optional(ground) : std::nullopt;
    until_.time = time;
    find_step();
  }

  /// Flies; error() says why a shot does not come down.
  MaxRange shoot(double elevation) {
    launch_.elevation = elevation;
    ++flights_;
    MaxRange out{.elevation = elevation};
    const Flight flight = fly_all();
    const std::optional<double> landing = landing_of(flight);
    if (flight.error()) error_ = flight.error();
    budget_.spend(flight);
    if (budget_.is_spent() && !error_) error_ = StepBudget::error("the farthest range");
    if (!landing && !error_) error_ = does_not_land(flight);
    if (!landing) return out;
    PHYSIM_ASSERT(*landing >= 0 && *landing <= flight.duration());
    const Sample impact = flight.at(*landing);
    out.position = impact.position;
    out.velocity = impact.velocity;
    out.time = *landing;
    const double way = is_round(flight.fidelity_in_use().fidelity.earth)
                           ? flight.earth_frames().ground_distance(base_, impact.position)
                           : length(impact.position - base_);
    out.range = dot(impact.position - base_, ahead_) < 0 ? -way : way;
    return out;
  }
  [[nodiscard]] const std::optional<Error>& error() const { return error_; }
  [[nodiscard]] std::int64_t flights() const { return flights_; }

 private:
  /// A step that pilot flights find is found once, at about the elevation that carries farthest.
  void find_step() {
    launch_.elevation = 45 * kDegree;
    const Flight flight = fly_all();
    if (!flight.error()) tolerance_.step = flight.step();  // 0 of what steps itself
    budget_.spend(flight);
  }
  Flight fly_all() { return slope_ == 0 ? fly_until(until_.time) : fly_over_slope(); }
  Flight fly_until(double time) {
    Until until = until_;
    until.time = time;
    return fly(projectile_, launch_, environment_, fidelity_, tolerance_, until);
  }
  /// The ground falls away without end: longer and longer, until the flight is below it.
  Flight fly_over_slope() {
    for (double time = 60;; time *= 4) {
      Flight flight = fly_until(std::min(time, until_.time));
      const bool over = flight.error() || flight.outcome() != Outcome::time_limit || time >= until_.time;
      if (over || landing_of(flight)) return flight;
    }
  }
  [[nodiscard]] std::optional<double> landing_of(const Flight& flight) const {
    if (flight.error()) return std::nullopt;
    if (slope_ == 0) return flight.outcome() == Outcome::landed ? std::optional(flight.duration()) : std::nullopt;
    return first_fall(flight, [&](double t) { return dot(flight.at(t).position - base_, up_); });
  }
  [[nodiscard]] Error does_not_land(const Flight& flight) const {
    const std::string elevation = rounded_text(launch_.elevation / kDegree) + " degrees";
    if (flight.outcome() == Outcome::time_limit)
      return {"at " + elevation + " the shot does not come down within " + short_text(until_.time) + " s", "launch",
              "there is no farthest range, or it takes a longer time"};
    return {"at " + elevation + " the flight ends as " + std::string(name(flight.outcome())), "launch",
            "check ground, speed and tolerance"};
  }

  ProjectileDef projectile_;
  Launch launch_;
  Environment environment_;
  Fidelity fidelity_;
  double slope_;
  Vec3d base_, ahead_, up_;
  Until until_;
  Tolerance tolerance_;
  std::optional<Error> error_;
  std::int64_t flights_ = 0;
  StepBudget budget_;
};

/// The surfaces of a scene that a path passes over.
struct GroundBelow {
  static constexpr double kLift = 1e-6;  // what lies on a surface is not below it by a rounding [m]
  static constexpr double kDeepest = 1e5;

  const Scene& scene;
  SceneFilter filter;
  EarthFrames frames;
  bool is_round;

  /// Above the nearest surface below a place [m]; in a solid, or over nothing, -kDeepest or kDeepest.
  [[nodiscard]] double height_of(const Vec3d& place) const {
    const Vec3d up = is_round ? frames.from_local(place, {0, 0, 1}) : Vec3d{0, 1, 0};
    const SceneHit hit = scene.first_hit({place + up * kLift, place - up * kDeepest, 0, 0, 0}, filter);
    if (!hit) return kDeepest;
    return hit.starts_inside ? -kDeepest : dot(place - hit.position, up);
  }
};

/// Where a flight passes a target of a height.
Result<Sample> middle_of(const Flight& flight, double range, double height) {
  if (!(std::isfinite(height) && height > 0))
    return Error{"must be a positive number, not " + short_text(height), "height", "of the target, in m"};
  return flight.at_range(range);
}

/// The ranges around a time of a flight within which a value is not negative; `longest`: way between two looks [m].
DangerSpace space_around(const Flight& flight, double middle, const auto& inside, double longest) {
  std::vector<double> times = flight.step_times();
  times.push_back(middle);
  std::sort(times.begin(), times.end());
  const auto here = static_cast<std::size_t>(std::find(times.begin(), times.end(), middle) - times.begin());
  PHYSIM_ASSERT(here < times.size());
  DangerSpace space;
  const auto range_at = [&](double time) { return flight.at(time).range; };
  // Walks from the middle to where the path leaves the space or turns back along the line of sight, or to an end.
  const auto edge = [&](int step) {
    double from = middle, at_from = inside(from), before = middle;
    for (std::size_t i = here; step < 0 ? i > 0 : i + 1 < times.size();) {
      i = step < 0 ? i - 1 : i + 1;
      constexpr double kFewest = 4, kMost = 1e6;
      const double start = from, way = length(flight.at(times[i]).position - flight.at(start).position);
      const int parts = static_cast<int>(std::clamp(std::ceil(way / longest), kFewest, kMost));
      for (int part = 1; part <= parts; ++part) {
        const double to = start + (times[i] - start) * part / parts;
        const double at_to = inside(to);
        if (at_to < 0) return range_at(find_root(inside, from, at_from, to, at_to, 1e-13));
        if (step * (range_at(to) - range_at(from)) < 0)
          return range_at(
              least_between([&](double time) { return -step * range_at(time); }, min(before, to), max(before, to)));
        before = from;
        from = to;
        at_from = at_to;
      }
    }
    space.ends_with_flight = step > 0;
    return range_at(from);
  };
  space.from = edge(-1);
  space.to = edge(1);
  return space;
}

}  // namespace

Result<MaxRange> max_range(const ProjectileDef& projectile, const Launch& launch, const Environment& environment,
                           const Fidelity& fidelity, double ground, double slope, double time) {
  const IeeeMode mode;
  Checker c;
  c.is_number(ground, "ground").is_number(slope, "slope").positive(time, "time", "in s");
  c.require(std::abs(slope) < kRightAngle, "slope", "must lie between -90 and 90 degrees", "angles are in radians");
  c.require(!(launch.position.y < ground), "ground", "lies above the muzzle", "the shot has to start over it");
  const bool from_rest = launch_speed(launch) == 0 && has_motor(projectile);
  if (!from_rest) c.positive(launch_speed(launch), "launch.speed", "a shot needs one");
  if (const Status status = c.status(); !status) return status.error();
  Carry carry(projectile, launch, environment, fidelity, ground, slope, time);
  constexpr double kScan = 5 * kDegree;
  // Between a steep slope and the vertical there is less room.
  const double above = slope > 0 ? (kRightAngle - slope) * (kScan / kRightAngle) : kScan;
  MaxRange best{.range = -kInfinity};
  // A rail does not point into the ground.
  const double lowest = std::ceil((from_rest ? slope : slope - kRightAngle) / kScan) * kScan + kScan;
  for (double elevation = max(lowest, -85 * kDegree); elevation < kRightAngle - 0.2 * above;
       elevation = elevation < slope ? min(elevation + kScan, slope) : elevation + above) {
    const MaxRange found = carry.shoot(elevation);
    if (carry.error()) return *carry.error();
    if (found.range > best.range) best = found;
  }
  const auto shortfall = [&](double elevation) { return -carry.shoot(elevation).range; };
  const double near = best.elevation < slope ? kScan : above;
  const double elevation = least_between(shortfall, best.elevation - near, min(best.elevation + near, kRightAngle));
  MaxRange found = carry.shoot(elevation);
  if (carry.error()) return *carry.error();
  if (found.range < best.range) found = best;  // a drag curve with corners may have two tops
  found.flights = carry.flights();
  return found;
}

Result<DangerSpace> danger_space(const Flight& flight, double range, double height) {
  const IeeeMode mode;
  const auto middle = middle_of(flight, range, height);
  if (!middle) return middle.error();
  const auto inside = [&](double t) { return 0.5 * height - abs(flight.at(t).drop - middle->drop); };
  return space_around(flight, middle->time, inside, kInfinity);
}

Result<DangerSpace> danger_space(const Flight& flight, double range, double height, const Scene& ground,
                                 std::uint32_t layers) {
  const IeeeMode mode;
  const auto middle = middle_of(flight, range, height);
  if (!middle) return middle.error();
  const GroundBelow below{ground,
                          {.layers = layers, .sensors = false},
                          flight.earth_frames(),
                          is_round(flight.fidelity_in_use().fidelity.earth)};
  const auto inside = [&](double t) {
    const double above = below.height_of(flight.at(t).position);
    return std::min(above + GroundBelow::kLift, height - above);
  };
  if (inside(middle->time) < 0) {
    const double above = below.height_of(middle->position);
    const bool is_there = abs(above) < GroundBelow::kDeepest;
    return Error{is_there ? "the path passes " + length_text(above) + " above the ground there"
                          : "the path passes over no ground there",
                 "range", "it hits nothing there that is " + length_text(height) + " high"};
  }
  return space_around(flight, middle->time, inside, 0.25 * height);
}

Result<double> time_to_range(const ProjectileDef& projectile, const Launch& launch, const Environment& environment,
                             const Fidelity& fidelity, double range) {
  const IeeeMode mode;
  if (!(std::isfinite(range) && range > 0))
    return Error{"must be a positive number, not " + short_text(range), "range", "in m"};
  const Until until{.ground = std::nullopt, .time = 600, .range = range};
  const Flight flight = fly(projectile, launch, environment, fidelity, {}, until);
  if (flight.error()) return *flight.error();
  const Result<Sample> there = flight.at_range(range);
  return there ? Result<double>(there->time) : Result<double>(there.error());
}

}  // namespace physim
