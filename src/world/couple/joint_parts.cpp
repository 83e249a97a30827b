// A step of a net in parts: short enough ones for it, and cut where cables come taut.
#include <algorithm>
#include <cmath>
#include <vector>

#include "base/assert.hpp"
#include "math/vec3.hpp"
#include "world/core/joint_solver.hpp"

namespace physim {
namespace {

/// In how many parts a step of a net is taken. A light body between two rods that hold a heavy one swings across them
/// at the root of w T (1/L + 1/L'), with w one over its mass and T what pulls at the rods; steps that are long beside
/// that would throw it about. What pulls is three times the weights of all: as much as at the lowest point of a
/// pendulum that came down from the level.
std::uint32_t parts_of_step(std::span<const NetBody> bodies, std::span<const NetRow> rows, double h) {
  constexpr double kSlow = 4, kTurnOfPart = 4.0 / 3, kMostParts = 1000;  // [rad], [rad], [-]
  std::vector<double> bends(bodies.size());                              // by body, sum of 1/L [1/m]
  for (const NetRow& row : rows) {
    const bool holds = !row.is_spring() && !row.has_normal;
    if (holds && row.length > 0) bends[row.a] += 1 / row.length, bends[row.b] += 1 / row.length;
  }
  double pull = 0, swings = 0;
  for (std::size_t i = 0; i < bodies.size(); ++i) {
    const NetBody& body = bodies[i];
    const double w = std::max(std::max(body.mobility.x, body.mobility.y), body.mobility.z);
    if (!(w > 0)) continue;
    pull += 3 / w * length(body.v - body.start_velocity) / h;
    swings = std::max(swings, w * bends[i]);
  }
  const double turns = h * std::sqrt(pull * swings);
  return turns > kSlow ? static_cast<std::uint32_t>(std::min(std::ceil(turns / kTurnOfPart), kMostParts)) : 1;
}

/// In how many parts springs are followed where one step is too long for them: the fastest swing of a net is slower
/// than that of the two ends of a spring at all of their springs (Gershgorin).
std::uint32_t parts_of_springs(std::span<const NetBody> bodies, std::span<const NetRow> rows, double h) {
  constexpr double kTurnOfPart = 0.5, kMostParts = 1000;  // [rad], [-]
  std::vector<double> rates(bodies.size());               // by body, squared [1/s2]
  const auto rate = [&](std::uint32_t i, const NetRow& row) {
    const Vec3d& w = bodies[i].mobility;
    return std::max(std::max(w.x, w.y), w.z) * (row.is_spring() ? row.stiffness : 0);
  };
  for (const NetRow& row : rows) rates[row.a] += rate(row.a, row), rates[row.b] += rate(row.b, row);
  double fastest = 0;
  for (const NetRow& row : rows) fastest = std::max(fastest, rates[row.a] + rates[row.b]);
  return static_cast<std::uint32_t>(std::clamp(std::ceil(h * std::sqrt(fastest) / kTurnOfPart), 1.0, kMostParts));
}

/// A step that is flown from part to part. Each begins where the net left off in the last one, and is flown with the
/// mean acceleration of the step.
class StepInParts {
 public:
  StepInParts(std::span<NetBody> bodies, std::span<NetRow> rows, std::span<NetBounce> bounces, double h,
              NetEffort& effort)
      : bodies_(bodies),
        rows_(rows),
        bounces_(bounces),
        h_(h),
        effort_(effort),
        flown_(bodies.begin(), bodies.end()),
        found_(rows.begin(), rows.end()) {
    PHYSIM_ASSERT(h > 0);
    for (NetBody& body : bodies) body.x = body.start, body.v = body.start_velocity;
    for (NetBounce& bounce : bounces) bounce.is_over = false;
    for (NetRow& row : found_) row.forget();
    has_springs_ = std::ranges::any_of(rows, &NetRow::is_spring);
    holds_ = !std::ranges::all_of(rows, &NetRow::is_spring);
  }

  NetReport run(std::uint32_t parts) {
    for (std::uint32_t k = 0, count = 1; k < parts; k += count) {
      count = effort_.is_spent() ? parts - k : 1;
      take(h_ / parts * count, 1.0 / parts * count);
    }
    std::ranges::copy(found_, rows_.begin());
    for (std::size_t i = 0; i < bodies_.size(); ++i)
      bodies_[i].start = flown_[i].start, bodies_[i].start_velocity = flown_[i].start_velocity;
    return all_;
  }

 private:
  /// A part, which `share` of the step is, from one moment to the next at which a cable comes taut or bodies bounce.
  void take(double part, double share) {
    for (double left = part; left > 0;) {
      const std::vector<NetBody> before(bodies_.begin(), bodies_.end());
      const auto hold_until = [&](double until) { return hold(until, share * (until / part)); };
      double until = left;
      NetReport report = hold_until(until);
      while (has_springs_ && !report.solved && shorter_ < kMostShorter && !effort_.is_spent()) {
        ++shorter_;
        std::ranges::copy(before, bodies_.begin());
        report = hold_until(until /= 4);
      }
      const double held = until;
      meetings_.clear();
      if (!effort_.is_spent()) {
        if (cables_ < kMostCables) until = first_taut(before, held, share * (held / part));
        find_meetings(held);
      }
      const double first = first_meeting();
      const bool bounces = first <= until;
      if (bounces)
        until = first;
      else if (until < held)
        ++cables_;
      if (until < held) {
        std::ranges::copy(before, bodies_.begin());
        report = hold_until(until);
      }
      note(report);
      if (bounces) bounce_until(first + (bounces_.size() > kFewBounces ? h_ / kMostCuts : 0));
      done_ += until < left ? until : left;
      left = until < left ? left - until : 0;
    }
  }
  NetReport hold(double part, double share, bool comes_taut = true) {
    for (std::size_t i = 0; i < bodies_.size(); ++i) {
      NetBody& body = bodies_[i];
      const NetBody& alone = flown_[i];
      Vec3d a = (alone.v - alone.start_velocity) * (1 / h_);
      Vec3d beside = alone.x - alone.start - (alone.v + alone.start_velocity) * (0.5 * h_);
      if (body.acceleration) a = *body.acceleration, beside = {};
      body.start = body.x, body.start_velocity = body.v;
      body.x += body.v * part + a * (0.5 * part * part) + beside * share;
      body.v += a * part;
    }
    for (std::size_t i = 0; i < rows_.size(); ++i) turn(found_[i], part, rows_[i]);
    return hold_part(bodies_, rows_, {part, h_, comes_taut}, effort_);
  }
  /// The direction of a plane or guide in a part: a parabola through both of the step that has its rate at the end.
  void turn(const NetRow& whole, double part, NetRow& row) const {
    if (whole.normal_rate == Vec3d{} && whole.normal == whole.start_normal) return;
    const Vec3d way = whole.normal - whole.start_normal, bend = whole.normal_rate * h_ - way;
    const auto at = [&](double s) { return normalized(whole.start_normal + way * s + bend * (s * (s - 1))); };
    const double end = (done_ + part) / h_;
    PHYSIM_ASSERT(end > 0 && end < 1 + 1e-6);
    row.start_normal = at(done_ / h_);
    row.normal = at(end);
    row.normal_rate = (way + bend * (2 * end - 1)) * (1 / h_);
  }
  void note(const NetReport& report) {
    all_.rounds += report.rounds;
    all_.residual = std::max(all_.residual, report.residual);
    all_.solved = all_.solved && report.solved;
    for (std::size_t i = 0; i < rows_.size(); ++i) {
      found_[i].impulse += rows_[i].impulse;
      if (rows_[i].came_taut) found_[i].came_taut = true, found_[i].speed = std::max(found_[i].speed, rows_[i].speed);
    }
  }

  /// Finds when bodies come to planes in the part just held, after its start [s]; infinity: not in it.
  void find_meetings(double part) {
    meetings_.assign(bounces_.size(), kInfinity);
    for (std::size_t i = 0; i < bounces_.size(); ++i) {
      const NetBounce& bounce = bounces_[i];
      const NetBody& body = bodies_[bounce.body];
      if (bounce.is_over || body.mobility == Vec3d{}) continue;
      const auto above = [&](double s) { return dot(bounce.normal, on_way(body, part, s) - bounce.place); };
      const double started = above(0);
      const double slack = 8 * body.spacing + 1e-12 * (length(bounce.place) + length(body.x - body.start));
      if (started <= slack && dot(bounce.normal, body.start_velocity) < 0) {
        meetings_[i] = kLeastCut * h_;
        continue;
      }
      const double s = first_where(kLooks, [&](double at) { return above(at) < 0 && above(at) < started; });
      if (above(s) < slack) meetings_[i] = std::max(part * s, kLeastCut * h_);
    }
  }
  [[nodiscard]] double first_meeting() const { return meetings_.empty() ? kInfinity : std::ranges::min(meetings_); }
  void bounce_until(double until) {
    for (std::size_t i = 0; i < bounces_.size(); ++i)
      if (meetings_[i] <= until) bounce(bounces_[i]);
  }
  /// Turns the velocity of a body around along the normal, times its restitution. Friction takes what it took of the
  /// flight alone, in proportion to the speed along the normal, and never turns a slide around.
  void bounce(NetBounce& bounce) {
    bounce.is_over = true;
    NetBody& body = bodies_[bounce.body];
    const Vec3d& n = bounce.normal;
    const double came = -dot(n, body.v);
    if (!(came > 0)) return;
    if (holds_)
      push(bounce, came);
    else
      body.v += n * ((1 + bounce.restitution) * came);
    const Vec3d& across = bounce.across;
    const double most = length_squared(across) > 0 ? -dot(across, body.v) / length_squared(across) : 0;
    const double moved = length_squared(body.v);
    body.v += across * std::clamp(most, 0.0, std::min(came / bounce.speed, 1.0));
    // The flight alone has changed the spin: the bounce pays for energy that the ball does not lose here.
    const double owed = bounce.rubbed - (moved - length_squared(body.v)), up = dot(n, body.v);
    if (owed > 0 && up > 0) body.v -= n * (up - std::sqrt(std::max(up * up - owed, 0.0)));
    if (body.acceleration && bounce.restitution == 0)  // it lies there
      *body.acceleration -= n * std::min(dot(n, *body.acceleration), 0.0);
  }
  /// Applies a blow to the net: its response is that to a push along the normal, which is linear.
  void push(const NetBounce& bounce, double came) {
    const double moment = kLeastCut * h_;
    std::vector<NetBody> bodies(bodies_.begin(), bodies_.end());
    std::vector<NetRow> rows(rows_.begin(), rows_.end());
    for (NetBody& b : bodies) b.start = b.x, b.start_velocity = b.v, b.x += b.v * moment;
    bodies[bounce.body].v += bounce.normal * came;
    hold_part(bodies, rows, {moment, h_}, effort_);
    const double gives = dot(bounce.normal, bodies[bounce.body].v - bodies_[bounce.body].v) / came;  // 1 without rows
    if (!(gives > kLeastGive)) return;
    const double times = (1 + bounce.restitution) / gives;
    for (std::size_t i = 0; i < bodies_.size(); ++i) bodies_[i].v += (bodies[i].v - bodies_[i].v) * times;
    for (std::size_t i = 0; i < rows_.size(); ++i) found_[i].impulse += rows[i].impulse * times;
  }
  /// A part of the way of a body in the part just held: a cubic through both of its states.
  static Vec3d on_way(const NetBody& body, double h, double s) {
    const Vec3d way = body.x - body.start, early = body.start_velocity * h - way, late = way - body.v * h;
    return body.start + way * s + (early * (1 - s) + late * s) * (s * (1 - s));
  }
  /// The first part of a way at which something holds, looked for at some places; 1: nowhere.
  template <class Holds>
  static double first_where(int looks, const Holds& holds) {
    double low = 0, high = 1;
    for (int i = 1; i < looks; ++i) {
      const double s = static_cast<double>(i) / looks;
      if (holds(s)) {
        high = s;
        break;
      }
      low = s;
    }
    for (int halves = 0; halves < 60; ++halves) {
      const double middle = 0.5 * (low + high);
      (holds(middle) ? high : low) = middle;
    }
    return high;
  }

  /// When the first of the cables that came taut in the part just held did so, on its way without them; bodies stay
  /// as they are [s].
  double first_taut(const std::vector<NetBody>& before, double part, double share) {
    std::vector<std::size_t> taut;
    for (std::size_t i = 0; i < rows_.size(); ++i)
      if (rows_[i].came_taut && rows_[i].speed * part > kNoWay * rows_[i].length) taut.push_back(i);
    if (taut.empty()) return part;
    const std::vector<NetBody> held(bodies_.begin(), bodies_.end());
    const std::vector<NetRow> rows(rows_.begin(), rows_.end());
    std::ranges::copy(before, bodies_.begin());
    hold(part, share, false);
    double first = 1;
    for (const std::size_t i : taut) first = std::min(first, part_until_taut(rows_[i], part));
    std::ranges::copy(held, bodies_.begin());
    std::ranges::copy(rows, rows_.begin());
    return std::max(first * part, kLeastCut * h_);
  }
  /// The part of the way of its ends, cubics through both states of each, after which a cable is as long as it may be.
  [[nodiscard]] double part_until_taut(const NetRow& row, double h) const {
    const NetBody &a = bodies_[row.a], &b = bodies_[row.b];
    // So much longer that it is taut there, too, for rounding.
    const double most = row.length * (1 + kBeyond) + 8 * (a.spacing + b.spacing);
    return first_where(kLooks, [&](double s) { return !(length(on_way(a, h, s) - on_way(b, h, s)) < most); });
  }

  static constexpr std::uint32_t kMostCables = 16;  // behind them cables come taut at the end of a part
  static constexpr std::size_t kFewBounces = 8;     // that are cut one by one ...
  static constexpr double kMostCuts = 16;           // of a step by more: those that are near in time bounce together
  static constexpr int kMostShorter = 24;           // times that a part of a step is not solved, and taken shorter
  static constexpr double kLeastCut = 1e-9;         // of a step [-]
  static constexpr double kLeastGive = 1e-3;        // of a blow, in a body's speed: else its net holds it fast [-]
  static constexpr double kBeyond = 1e-10;          // of a length [-]
  static constexpr double kNoWay = 1e-9;  // of a length: what parts by less in a part comes taut at its end [-]
  static constexpr int kLooks = 8;        // along a part

  std::span<NetBody> bodies_;
  std::span<NetRow> rows_;
  std::span<NetBounce> bounces_;
  double h_;
  NetEffort& effort_;
  std::vector<NetBody> flown_;
  std::vector<NetRow> found_;
  NetReport all_;
  std::vector<double> meetings_;  // of bounces, after the start of the part at hand [s]
  std::uint32_t cables_ = 0;      // that came taut
  bool has_springs_ = false, holds_ = false;
  int shorter_ = 0;
  double done_ = 0;  // of the step [s]
};

}  // namespace

NetReport hold_net(std::span<NetBody> bodies, std::span<NetRow> rows, std::span<NetBounce> bounces, double h,
                   NetEffort& effort) {
  const std::uint32_t parts = parts_of_step(bodies, rows, h);
  if (parts > 1) return StepInParts(bodies, rows, bounces, h, effort).run(parts);
  const std::vector<NetBody> flown(bodies.begin(), bodies.end());
  const NetReport report = hold_part(bodies, rows, {h, h}, effort);
  const std::uint32_t shorter = report.is_rough ? parts_of_springs(bodies, rows, h) : 1;
  const bool comes_taut = std::ranges::any_of(rows, &NetRow::came_taut);
  if (effort.is_spent() || (shorter == 1 && !comes_taut && bounces.empty())) return report;
  std::ranges::copy(flown, bodies.begin());
  return StepInParts(bodies, rows, bounces, h, effort).run(shorter);
}

}  // namespace physim
