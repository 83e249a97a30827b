// aim(): the launch directions that hit a target.
//
// For every time of flight t there is one launch velocity with which the projectile is at the target at t. In vacuum it
// is (T(t) - x0) / t + g t / 2; with everything else it is that of a neighbour of a flown path (flight/neighbours.hpp).
// Its magnitude falls and rises again with t, and the times at which it equals the launch speed belong to the low and
// the high solution. So one flight answers for all times of flight at once; the next flight, in the direction found, is
// nearer by an order of magnitude or two, and the last one is its own proof. Where the required speed is above the
// launch speed at all times, the target is out of reach as far as the neighbours know. Before that is believed, a fan
// of flights over all elevations and sides looks for paths that pass nearer, and descents start from those.
#include "physim/solve.hpp"

#include <algorithm>
#include <cmath>
#include <tuple>
#include <utility>
#include <vector>

#include "base/checker.hpp"
#include "base/ieee_mode.hpp"
#include "flight/neighbours.hpp"
#include "flight/pilot.hpp"
#include "flight/required_speed.hpp"
#include "flight/step_budget.hpp"
#include "flight/ways.hpp"
#include "math/angles.hpp"
#include "math/elementary.hpp"
#include "model/sight.hpp"
#include "prepare/check.hpp"
#include "prepare/conditions.hpp"
#include "prepare/grant.hpp"

namespace physim {

Vec3d Target::at(double time) const {
  const IeeeMode mode;
  return position + (velocity + acceleration * (0.5 * time)) * time;
}
Vec3d Target::velocity_at(double time) const {
  const IeeeMode mode;
  return velocity + acceleration * time;
}

namespace {

constexpr int kVacuumTimes = 64;
constexpr int kMostFlights = 14;        // of a search from one start
constexpr int kPatience = 4;            // flights without progress
constexpr double kProgress = 0.7;       // what a flight may leave of the miss
constexpr std::size_t kMostStarts = 3;  // from a fan
constexpr int kMostDescents = 25;       // flights of a descent
constexpr int kMostMoves = 10;          // among the neighbours of a flight
constexpr double kLongestTurn = 0.5;    // of the direction in one move [rad]

/// Where a path passes the target.
struct Passing {
  double time = 0;
  Vec3d miss;  // from the projectile to the target
};

/// A direction to start a search from.
struct Start {
  Vec3d velocity;
  double time = 0;  // when it passes the target
  double miss = 0;
};

class Aimer {
 public:
  Aimer(const ProjectileDef& projectile, const Launch& launch, const Environment& environment, const Fidelity& fidelity,
        const Target& target, const AimOptions& options)
      : projectile_(projectile),
        launch_(launch),
        environment_(environment),
        fidelity_(fidelity),
        target_(target),
        options_(options) {
    if (launch_.velocity) launch_.speed = length(*launch_.velocity);
    launch_.velocity.reset();
    launch_.sight = {};
    from_rest_ = launch_.speed == 0;
    const bool pulls = fidelity.gravity != GravityModel::off && environment.gravity.model != GravityModel::off;
    gravity_ = pulls ? environment.gravity.acceleration : 0;
    answer_.nearest.miss = kInfinity;
  }

  Result<Aim> run() {
    prepare();
    const bool wants_low = options_.arc != Arc::high, wants_high = options_.arc != Arc::low;
    std::optional<AimSolution> low, high;
    if (from_rest_) {
      std::tie(low, high) = search_from_rest();
    } else {
      if (wants_low) low = search(Arc::low);
      if (wants_high || !low) high = search(Arc::high);
      if (!wants_low && !high) low = search(Arc::low);
    }
    if (!low && !high) low = search_widely();
    if (error_) return *error_;
    if (!(answer_.nearest.miss < kInfinity))
      return Error{"no flight gets away from the muzzle", "launch", "check where it starts: the air has a lower end"};
    if (!low) low = high;
    if (!high) high = low;
    PHYSIM_ASSERT(low.has_value() == high.has_value());
    if (low && low->time > high->time) std::swap(low, high);
    if (wants_low) answer_.low = low;
    if (wants_high) answer_.high = high;
    if (low) answer_.nearest = low->miss < high->miss ? *low : *high;
    answer_.behind_ground = answer_.behind_ground && !low;
    if (Status status = keep_open_ways(projectile_, environment_, fidelity_, target_, options_, answer_); !status)
      return status.error();
    return std::move(answer_);
  }

 private:
  // --------------------------------------------------------------------------------------------------------- flights
  /// What all flights share; a step that pilot flights find is found once.
  void prepare() {
    const Fidelity asked = by_steps(fidelity_, options_.flight.step > 0);
    const Fidelity granted = grant(asked, projectile_, environment_).fidelity;
    conditions_ = prepare_conditions(environment_, granted, profiles_);
    conditions_.wind.stepped = false;  // neighbours need to know how wind changes with place: a step would hide it
    if (step_given(granted, options_.flight) || steps_by_frames(granted)) return;
    Until until{.ground = std::nullopt, .time = options_.time};
    if (from_rest_) {
      point(toward(0, 45));
      until.ground = min(target_.position.y, launch_.position.y);
    } else {
      const Need need =
          need_in_vacuum(options_.arc == Arc::low ? Arc::low : Arc::high);  // the longest flight asked for
      point(need.velocity);
      until.time = clamp(1.2 * need.time, 1e-9, options_.time);
    }
    const auto step = step_within(projectile_, launch_, environment_, granted, options_.flight, until,
                                  options_.flight.position_error);
    if (step) options_.flight.step = step->step;
    if (!step) error_ = step.error();
  }

  /// A launch velocity to a side of the target and at an elevation [deg]; of a rocket from rest the direction alone.
  [[nodiscard]] Vec3d toward(double side, double elevation) const {
    const Vec3d way = target_.at(from_rest_ ? 0 : need_in_vacuum(Arc::low).time) - launch_.position;
    const SinCos<double> e = sincos(elevation * kDegree), a = sincos(atan2(way.z, way.x) + side * kDegree);
    return Vec3d{e.cos * a.cos, e.sin, e.cos * a.sin} * aimed_speed();
  }
  [[nodiscard]] double aimed_speed() const { return from_rest_ ? 1 : launch_.speed; }

  void point(const Vec3d& velocity) {
    PHYSIM_ASSERT(length_squared(velocity) > 0);
    const Vec3d bore = velocity * (1 / length(velocity)) - jumped_;
    launch_.elevation = atan2(bore.y, sqrt(bore.x * bore.x + bore.z * bore.z));
    launch_.azimuth = atan2(bore.z, bore.x);
  }

  /// Flies towards a velocity's direction, until the path is surely past the target or for a time [s].
  Flight fly_towards(const Vec3d& velocity, double time, double time_there) {
    if (budget_.is_spent() && !error_) error_ = StepBudget::error("the aim");
    point(velocity);
    const Vec3d there = target_.at(time_there);
    const Vec3d way = there - launch_.position;
    const double far = length(way);
    Until until{.ground = std::nullopt, .time = clamp(time, 1e-9, options_.time)};
    if (far < 1e6 && target_.velocity == Vec3d{} && target_.acceleration == Vec3d{}) {
      const double floor = min(there.y, launch_.position.y) - 0.2 * far - 5;
      until.events.push_back({EventKind::height, floor, Crossing::falling, true});
    }
    Flight flight = fly(projectile_, launch_, environment_, fidelity_, options_.flight, until);
    if (flight.error() && !error_) error_ = flight.error();
    budget_.spend(flight);
    const Vec3d flown = flight.at(0).velocity;
    if (flight.fidelity_in_use().fidelity.aerodynamic_jump && flown != Vec3d{})
      jumped_ = flown * (1 / length(flown)) - (velocity * (1 / length(velocity)) - jumped_);
    ++answer_.flights;
    return flight;
  }

  /// The closest approach next to a time.
  [[nodiscard]] Passing passing(const Flight& flight, double near) const {
    Passing p{clamp(near, 0.0, flight.duration()), {}};
    for (int i = 0; i < 12; ++i) {
      const Sample s = flight.at(p.time);
      p.miss = target_.at(p.time) - s.position;
      const Vec3d approach = s.velocity - target_.velocity_at(p.time);
      const double step = dot(p.miss, approach) / max(length_squared(approach), 1e-30);
      const double next = clamp(p.time + step, 0.0, flight.duration());
      if (abs(next - p.time) <= 1e-14 * p.time) break;
      p.time = next;
    }
    p.miss = target_.at(p.time) - flight.at(p.time).position;
    return p;
  }

  [[nodiscard]] AimSolution solution(const Flight& flight, const Passing& passing) const {
    PHYSIM_ASSERT(passing.time >= 0 && passing.time <= flight.duration());
    const Sample s = flight.at(passing.time);
    AimSolution out;
    out.launch = launch_;
    out.miss = length(passing.miss);
    out.time = passing.time;
    out.position = s.position;
    out.velocity = s.velocity;
    out.speed = s.speed;
    out.descent = atan2(-s.velocity.y, sqrt(s.velocity.x * s.velocity.x + s.velocity.z * s.velocity.z));
    return out;
  }

  /// Keeps what came nearest.
  void note(const Flight& flight, const Passing& passing) {
    if (length(passing.miss) < answer_.nearest.miss) answer_.nearest = solution(flight, passing);
    answer_.fidelity_in_use = flight.fidelity_in_use();
  }

  /// A path that hits, unless the ground stops it before.
  std::optional<AimSolution> accepted(const Flight& flight, const Passing& passing, std::int64_t flown) {
    PHYSIM_ASSERT(length(passing.miss) <= options_.tolerance);
    if (options_.ground) {
      const auto below = flight.at_height(*options_.ground - 2 * options_.tolerance, Crossing::falling);
      if (below && below->time < passing.time) {
        answer_.behind_ground = true;
        return std::nullopt;
      }
    }
    AimSolution found = solution(flight, passing);
    found.flights = answer_.flights - flown;
    PHYSIM_ASSERT(found.flights > 0);
    return found;
  }

  // ---------------------------------------------------------------------------------------------------------- search
  /// Without a flight: as in vacuum.
  [[nodiscard]] Need need_in_vacuum(Arc arc) const {
    const double v = launch_.speed;
    const double below = max(0.0, launch_.position.y - target_.position.y);
    double longest = options_.time;
    if (gravity_ > 0) longest = min(longest, 1.1 * (v + sqrt(v * v + 2 * gravity_ * below)) / gravity_);
    std::vector<double> times;
    for (int i = 0; i <= kVacuumTimes; ++i) {
      const double part = static_cast<double>(i) / kVacuumTimes;
      times.push_back(longest * part * part);
    }
    const auto required = [&](double t) {
      return (target_.at(t) - launch_.position) * (1 / t) + Vec3d{0, 0.5 * gravity_ * t, 0};
    };
    return find_need(times, required, v, arc);
  }

  /// Among the neighbours of a flight.
  [[nodiscard]] Need need_near(Neighbours& neighbours, Arc arc) const {
    const auto required = [&](double t) { return neighbours.required_velocity(target_.at(t), t); };
    Need need;
    for (int i = 0; i < kMostMoves; ++i) {
      need = find_need(neighbours.times(), required, launch_.speed, arc);
      const Vec3d now = neighbours.launch_velocity();
      Vec3d wanted = need.velocity * (launch_.speed / length(need.velocity));
      const double turn = length(wanted - now) / launch_.speed;
      if (turn > kLongestTurn) wanted = now + (wanted - now) * (kLongestTurn / turn);
      const double in_all = length(wanted - neighbours.flown_velocity()) / launch_.speed;
      if (turn < 0.003 * in_all || in_all < 1e-3) break;
      neighbours.move_to(wanted - neighbours.flown_velocity());
    }
    return need;
  }

  /// From neighbour to neighbour until a flight hits; nothing where flights stop coming nearer.
  std::optional<AimSolution> pursue(Need need, double time, Arc arc) {
    const std::int64_t flown = answer_.flights;
    std::optional<Neighbours> before;
    double least = kInfinity;
    for (int i = 0, waited = 0; i < kMostFlights && waited < kPatience; ++i) {
      const Flight flight = fly_towards(need.velocity, time, need.time);
      if (error_) return std::nullopt;
      const Passing p = passing(flight, need.time);
      const double miss = length(p.miss);
      if (!std::isfinite(miss) || p.time == 0) return std::nullopt;
      note(flight, p);
      if (miss <= options_.tolerance) return accepted(flight, p, flown);
      waited = miss < kProgress * least ? 0 : waited + 1;
      least = min(least, miss);
      Neighbours neighbours(flight, environment_, conditions_);
      if (before) neighbours.learn_from(*before);
      need = need_near(neighbours, arc);
      if (!finite(need.velocity)) return std::nullopt;
      time = need.time * (need.later ? 3 : 1.3);
      before = std::move(neighbours);
    }
    return std::nullopt;
  }

  std::optional<AimSolution> search(Arc arc) {
    if (error_) return std::nullopt;
    const Need need = need_in_vacuum(arc);
    return pursue(need, need.time * (arc == Arc::low ? 8 : 1.5), arc);
  }

  /// Where both searches fail: a fan of flights in the vertical plane of the target, then to all sides, and descents
  /// from those that pass nearest.
  std::optional<AimSolution> search_widely() {
    const std::int64_t flown = answer_.flights;
    std::vector<double> ahead, around;
    for (double angle = -75; angle <= 120; angle += 15) ahead.push_back(angle);
    for (double angle = -40; angle <= 80; angle += 40) around.push_back(angle);
    if (auto found = descend_from(fan({0}, ahead), flown)) return found;
    return descend_from(fan({45, 90, 135, 180, 225, 270, 315}, around), flown);
  }

  /// A rocket from rest has no way in vacuum to start from, and wind carries it far: descents from a fan of flights
  /// over all elevations, where they come near on the way up and where they do on the way down. Its ways of the
  /// shortest and of the longest time.
  std::pair<std::optional<AimSolution>, std::optional<AimSolution>> search_from_rest() {
    std::pair<std::optional<AimSolution>, std::optional<AimSolution>> ways;
    for (double elevation = 10; elevation <= 170 && !error_; elevation += 10) {
      const Vec3d velocity = toward(0, elevation);
      const Flight flight = fly_towards(velocity, options_.time, 0);
      if (error_) return ways;
      const std::vector<double> times = approaches(flight);
      for (const double time : {times.front(), times.back()}) {
        const auto found = descend(start_at(flight, velocity, time), answer_.flights);
        if (!found || error_) continue;
        if (!ways.first || found->time < ways.first->time) ways.first = found;
        if (!ways.second || found->time > ways.second->time) ways.second = found;
      }
    }
    if (ways.first && are_one(*ways.first, *ways.second))
      ways.first = ways.second = ways.first->miss < ways.second->miss ? ways.first : ways.second;
    return ways;
  }
  /// True if two descents ended at the same solution, from opposite sides of it, to within the tolerance.
  [[nodiscard]] static bool are_one(const AimSolution& a, const AimSolution& b) {
    constexpr double kAlike = 1e-3;  // of the time, and of the speed at the target [-]
    return abs(a.time - b.time) <= kAlike * b.time && length(a.velocity - b.velocity) <= kAlike * b.speed;
  }

  /// Flights to some sides of the target and at some elevations [deg], the nearest first.
  std::vector<Start> fan(const std::vector<double>& sides, const std::vector<double>& elevations) {
    std::vector<Start> starts;
    for (const double side : sides)
      for (const double elevation : elevations) {
        const Vec3d velocity = toward(side, elevation);
        const Flight flight = fly_towards(velocity, options_.time, 0);
        if (error_) return {};
        starts.push_back(start_at(flight, velocity, nearest_time_along(flight)));
      }
    std::erase_if(starts, [](const Start& start) { return !(start.miss < kInfinity); });
    std::sort(starts.begin(), starts.end(), [](const Start& a, const Start& b) { return a.miss < b.miss; });
    return starts;
  }

  /// Where a search may start from a flight next to a time; infinitely far where it does not pass.
  Start start_at(const Flight& flight, const Vec3d& velocity, double near) {
    const Passing p = passing(flight, near);
    const double miss = length(p.miss);
    if (!std::isfinite(miss) || flight.duration() == 0) return {velocity, p.time, kInfinity};
    note(flight, p);
    return {velocity, p.time, p.time == 0 ? kInfinity : miss};  // no descent starts at the muzzle
  }

  [[nodiscard]] double distance_at(const Flight& flight, double time) const {
    return length(target_.at(time) - flight.at(time).position);
  }
  /// Ends of steps, and times between: where little happens, one step may go from the muzzle to behind the target.
  [[nodiscard]] static std::vector<double> times_along(const Flight& flight) {
    constexpr int kTimes = 128;
    std::vector<double> times = flight.step_times();
    const double end = times.back();
    for (int i = 1; i < kTimes; ++i) times.push_back(end * i / kTimes);
    std::sort(times.begin(), times.end());
    return times;
  }
  [[nodiscard]] double nearest_time_along(const Flight& flight) const {
    double nearest = 0, least = kInfinity;
    for (const double time : times_along(flight)) {
      const double distance = distance_at(flight, time);
      if (distance < least) least = distance, nearest = time;
    }
    return nearest;
  }
  /// Times at which it is nearer than before and after; the last, where there is no such.
  [[nodiscard]] std::vector<double> approaches(const Flight& flight) const {
    const std::vector<double> times = times_along(flight);
    std::vector<double> found;
    for (std::size_t i = 1; i + 1 < times.size(); ++i) {
      const double here = distance_at(flight, times[i]);
      if (here <= distance_at(flight, times[i - 1]) && here < distance_at(flight, times[i + 1]))
        found.push_back(times[i]);
    }
    if (found.empty()) found.push_back(times.back());
    return found;
  }

  std::optional<AimSolution> descend_from(const std::vector<Start>& starts, std::int64_t flown) {
    for (std::size_t i = 0; i < starts.size() && i < kMostStarts; ++i)
      if (auto found = descend(starts[i], flown)) return found;
    return std::nullopt;
  }

  /// Makes the miss smaller, to a hit or to the nearest there is hereabouts: the method of Levenberg and Marquardt over
  /// the two angles of the direction, its derivatives from flights a little to the side and a little higher, so that it
  /// needs no idea of what flies. (D. W. Marquardt, "An algorithm for least-squares estimation of nonlinear
  /// parameters", J. SIAM 11 (1963) 431-441.)
  std::optional<AimSolution> descend(const Start& start, std::int64_t flown) {
    double damping = 0.001, least = kInfinity, time = start.time;
    Vec3d velocity = start.velocity, best;
    Slopes slopes;
    Passing passed;
    for (int i = 0; i < kMostDescents && damping < 1e4; ++i) {
      const Flight flight = fly_towards(velocity, 1.5 * time, time);
      if (error_) return std::nullopt;
      const Passing p = passing(flight, time);
      const double miss = length(p.miss);
      if (miss < least) {
        note(flight, p);
        if (miss <= options_.tolerance) return accepted(flight, p, flown);
        if (least - miss < 1e-4 * miss && damping < 1) break;
        best = velocity;
        passed = p;
        least = miss;
        damping *= 0.2;
        slopes = slopes_at(best, passed);
      } else {
        damping *= 5;
      }
      velocity = step_down(best, slopes, passed, damping);
      time = passed.time;
      if (error_ || !finite(velocity)) break;
    }
    return std::nullopt;
  }

  /// Two directions across a direction of fire, and how the path moves past the target with turns towards them.
  struct Slopes {
    Vec3d side, up;
    Vec3d by_side, by_up;  // [m/rad]
  };

  Slopes slopes_at(const Vec3d& velocity, const Passing& passed) {
    constexpr double kTurn = 1e-4;
    const Vec3d forward = normalized(velocity);
    Slopes s;
    s.side = normalized(cross(forward, abs(forward.y) < 0.9 ? Vec3d{0, 1, 0} : Vec3d{1, 0, 0}));
    s.up = cross(s.side, forward);
    const auto moved = [&](const Vec3d& towards) {
      const Flight flight = fly_towards(forward + towards * kTurn, 1.5 * passed.time, passed.time);
      return (passed.miss - passing(flight, passed.time).miss) * (1 / kTurn);
    };
    s.by_side = moved(s.side);
    if (!error_) s.by_up = moved(s.up);
    return s;
  }

  /// The launch velocity that a damped step brings nearer.
  [[nodiscard]] Vec3d step_down(const Vec3d& velocity, const Slopes& s, const Passing& p, double damping) const {
    const double ss = (1 + damping) * dot(s.by_side, s.by_side), uu = (1 + damping) * dot(s.by_up, s.by_up);
    const double su = dot(s.by_side, s.by_up);
    const double ms = dot(s.by_side, p.miss), mu = dot(s.by_up, p.miss);
    const double per_determinant = 1 / (ss * uu - su * su);
    const double turn_side = clamp((ms * uu - mu * su) * per_determinant, -0.5, 0.5);
    const double turn_up = clamp((mu * ss - ms * su) * per_determinant, -0.5, 0.5);
    return normalized(normalized(velocity) + s.side * turn_side + s.up * turn_up) * aimed_speed();
  }

  ProjectileDef projectile_;
  Launch launch_;
  Environment environment_;
  Fidelity fidelity_;
  Target target_;
  AimOptions options_;
  ProfileTables profiles_;
  Conditions<double> conditions_{};
  double gravity_ = 0;
  bool from_rest_ = false;  // a rocket, which a rail points
  Aim answer_;
  StepBudget budget_;
  Vec3d jumped_;  // how far the last flight's direction was off its bore's, by aerodynamic jump
  std::optional<Error> error_;
};

Status check(const ProjectileDef& projectile, const Launch& launch, const Target& target, const AimOptions& options) {
  // Within these the squares of lengths and speeds are numbers that are not 0.
  constexpr double kFarthestPlace = 1e15;          // [m]
  constexpr double kSlowest = 1e-9, kMost = 1e15;  // [m/s], and of an acceleration [m/s^2]
  Checker c;
  c.named(options.arc, "options.arc");
  const auto within = [&c](const Vec3d& v, double most, const char* place) {
    c.is_vector(v, place).require(!(length(v) > most), place, "exceeds " + short_text(most), "numbers are in SI units");
  };
  within(target.position, kFarthestPlace, "target.position"), within(target.velocity, kMost, "target.velocity");
  within(target.acceleration, kMost, "target.acceleration"), within(launch.position, kFarthestPlace, "launch.position");
  const double speed = launch_speed(launch);
  if (speed != 0 || !has_motor(projectile)) {
    c.positive(speed, "launch.speed", "a shot that is aimed needs one");
    c.require(!(speed < kSlowest) && !(speed > kMost), "launch.speed", "must lie between 1e-9 and 1e15 m/s");
  }
  c.positive(options.tolerance, "options.tolerance", "in m").positive(options.time, "options.time", "in s");
  if (options.ground) c.is_number(*options.ground, "options.ground");
  if (options.scene) c.also(check(options.contact, "options.contact"));
  c.require(length(target.position - launch.position) > options.tolerance, "target.position", "is at the muzzle",
            "a target lies further away than the tolerance");
  return c.status();
}

}  // namespace

Result<Aim> aim(const ProjectileDef& projectile, const Launch& launch, const Environment& environment,
                const Fidelity& fidelity, const Target& target, const AimOptions& options) {
  const IeeeMode mode;
  for (const Status& status : {check(projectile, launch, target, options), check(projectile), check(environment),
                               check(options.flight, fidelity)})
    if (!status) return status.error();
  return Aimer(projectile, launch, environment, fidelity, target, options).run();
}

}  // namespace physim
