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

/// A step that is flown from part to part. Each begins where the net left off in the last one, and is flown with the
/// mean acceleration of the step.
class StepInParts {
 public:
  StepInParts(std::span<NetBody> bodies, std::span<NetRow> rows, double h, NetEffort& effort)
      : bodies_(bodies),
        rows_(rows),
        h_(h),
        effort_(effort),
        flown_(bodies.begin(), bodies.end()),
        found_(rows.begin(), rows.end()) {
    PHYSIM_ASSERT(h > 0);
    for (NetBody& body : bodies) body.x = body.start, body.v = body.start_velocity;
    for (NetRow& row : found_) row.impulse = 0, row.came_taut = false;
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
  /// A part, which `share` of the step is, from one moment to the next at which a cable comes taut.
  void take(double part, double share) {
    for (double left = part; left > 0;) {
      const std::vector<NetBody> before(bodies_.begin(), bodies_.end());
      NetReport report = hold(left, share * (left / part));
      const double until =
          cuts_ < kMostCuts && !effort_.is_spent() ? first_taut(before, left, share * (left / part)) : left;
      if (until < left) {
        ++cuts_;
        std::ranges::copy(before, bodies_.begin());
        report = hold(until, share * (until / part));
      }
      note(report);
      done_ += until < left ? until : left;
      left = until < left ? left - until : 0;
    }
  }
  NetReport hold(double part, double share, bool comes_taut = true) {
    for (std::size_t i = 0; i < bodies_.size(); ++i) {
      NetBody& body = bodies_[i];
      const NetBody& alone = flown_[i];
      const Vec3d a = (alone.v - alone.start_velocity) * (1 / h_);
      const Vec3d beside = alone.x - alone.start - (alone.v + alone.start_velocity) * (0.5 * h_);
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
    const Vec3d from = a.start - b.start, way = a.x - b.x - from;
    const Vec3d early = (a.start_velocity - b.start_velocity) * h - way, late = way - (a.v - b.v) * h;
    // So much longer that it is taut there, too, for rounding.
    const double most = row.length * (1 + kBeyond) + 8 * (a.spacing + b.spacing);
    const auto is_taut = [&](double s) {
      return !(length(from + way * s + (early * (1 - s) + late * s) * (s * (1 - s))) < most);
    };
    double low = 0, high = 1;
    for (int i = 1; i < kLooks; ++i) {
      const double s = static_cast<double>(i) / kLooks;
      if (is_taut(s)) {
        high = s;
        break;
      }
      low = s;
    }
    for (int halves = 0; halves < 60; ++halves) {
      const double middle = 0.5 * (low + high);
      (is_taut(middle) ? high : low) = middle;
    }
    return high;
  }

  static constexpr std::uint32_t kMostCuts = 16;  // behind them cables come taut at the end of a part
  static constexpr double kLeastCut = 1e-9;       // of a step [-]
  static constexpr double kBeyond = 1e-10;        // of a length [-]
  static constexpr double kNoWay = 1e-9;          // of a length: what parts by less in a part comes taut at its end [-]
  static constexpr int kLooks = 8;                // along a part

  std::span<NetBody> bodies_;
  std::span<NetRow> rows_;
  double h_;
  NetEffort& effort_;
  std::vector<NetBody> flown_;
  std::vector<NetRow> found_;
  NetReport all_;
  std::uint32_t cuts_ = 0;
  double done_ = 0;  // of the step [s]
};

}  // namespace

NetReport hold_net(std::span<NetBody> bodies, std::span<NetRow> rows, double h, NetEffort& effort) {
  const std::uint32_t parts = parts_of_step(bodies, rows, h);
  if (parts > 1) return StepInParts(bodies, rows, h, effort).run(parts);
  const std::vector<NetBody> flown(bodies.begin(), bodies.end());
  const NetReport report = hold_part(bodies, rows, {h, h}, effort);
  if (effort.is_spent() || std::ranges::none_of(rows, &NetRow::came_taut)) return report;
  std::ranges::copy(flown, bodies.begin());
  return StepInParts(bodies, rows, h, effort).run(1);
}

}  // namespace physim
