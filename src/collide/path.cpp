#include "collide/path.hpp"

#include <algorithm>

#include "base/checker.hpp"
#include "base/ieee_mode.hpp"
#include "collide/carried.hpp"
#include "math/elementary.hpp"
#include "math/quat.hpp"
#include "math/root.hpp"

namespace physim::collide {
namespace {

constexpr double kLongestTime = 1e9, kFastest = 1e9, kFastestTurn = 1e6;
constexpr std::size_t kMostKeys = 1'000'000;

Quatd turned_by(const Vec3d& axis, double angle) {
  const SinCos<double> half = sincos(0.5 * angle);
  return {half.cos, axis.x * half.sin, axis.y * half.sin, axis.z * half.sin};
}

/// Turns steadily from one rotation to another one, the shorter way.
void set_turn(Path::Piece& piece, const Quatd& from, const Quatd& to, double duration) {
  PHYSIM_ASSERT(duration > 0);
  piece.q0 = from;
  Quatd step = to * conjugate(from);
  if (step.w < 0) step = {-step.w, -step.x, -step.y, -step.z};
  const Vec3d part{step.x, step.y, step.z};
  const double sine = length(part);
  if (!(sine > 1e-15)) return;
  piece.axis = part * (1 / sine);
  piece.rate = 2 * atan2(sine, step.w) / duration;
}

Status check_path(const SteadyMotion& m) {
  Checker c;
  c.require(std::abs(m.start) <= kLongestTime, "motion.start", "must lie within 1e9 s");
  c.require(length(m.velocity) <= kFastest, "motion.velocity", "must be numbers within 1e9 m/s");
  c.require(length(m.angular_velocity) <= kFastestTurn, "motion.angular_velocity", "must be numbers within 1e6 rad/s");
  return c.status();
}

Status check_path(const KeyedMotion& m) {
  if (m.keys.empty() || m.keys.size() > kMostKeys)
    return Error{"has " + std::to_string(m.keys.size()) + " keys", "motion.keys", "one at least, 1e6 at most"};
  if (static_cast<unsigned>(m.curve) > static_cast<unsigned>(MotionCurve::smooth))
    return Error{"is none of the named values", "motion.curve", ""};
  for (std::size_t i = 0; i < m.keys.size(); ++i) {
    const MotionKey& key = m.keys[i];
    const std::string place = "motion.keys[" + std::to_string(i) + "]";
    const double norm = norm_squared(key.rotation);
    Checker c;
    c.require(std::abs(key.time) <= kLongestTime, place + ".time", "must lie within 1e9 s");
    c.require(i == 0 || key.time - m.keys[i - 1].time > 1e-9, place + ".time", "must be later than the key before",
              "by more than 1e-9 s");
    c.require(length(key.position) <= kFarthest, place + ".position", "must lie within 1e15 m");
    c.require(norm > 1e-12 && norm < 1e12, place + ".rotation", "is no rotation: its length is none");
    c.require(length(key.velocity) <= kFastest, place + ".velocity", "must be numbers within 1e9 m/s");
    c.require(i == 0 || length(key.position - m.keys[i - 1].position) <= kFastest * (key.time - m.keys[i - 1].time),
              place + ".position", "is farther from the key before than 1e9 m/s go");
    if (auto status = c.status(); !status) return status;
  }
  return {};
}

}  // namespace

Path::Piece resting(const MotionKey& key, double start) {
  Path::Piece piece;
  piece.start = start;
  piece.origin = key.time;
  piece.c0 = key.position;
  piece.q0 = normalized(key.rotation);
  return piece;
}

Path::Piece between(const MotionKey& a, const MotionKey& b, MotionCurve curve) {
  PHYSIM_ASSERT(a.time < b.time);
  Path::Piece piece = resting(a, a.time);
  const double h = b.time - a.time;
  const Vec3d mean = (b.position - a.position) * (1 / h);
  piece.c1 = mean;
  if (curve == MotionCurve::smooth) {
    piece.c1 = a.velocity;
    piece.c2 = (mean * 3 - a.velocity * 2 - b.velocity) * (1 / h);
    piece.c3 = (a.velocity + b.velocity - mean * 2) * (1 / (h * h));
  }
  set_turn(piece, piece.q0, normalized(b.rotation), h);
  return piece;
}

Result<Path> Path::make(const SceneMotion& motion, const Transform& at) {
  PHYSIM_ASSERT(at.scale > 0 && !std::holds_alternative<AtRest>(motion));
  Path path;
  path.scale_ = at.scale;
  path.carriage_ = &kCarriage;
  if (const auto* steady = std::get_if<SteadyMotion>(&motion)) {
    if (auto status = check_path(*steady); !status) return status.error();
    Piece& piece = path.pieces_.emplace_back(resting({steady->start, at.position, at.rotation, {}}, -kInfinity));
    piece.c1 = steady->velocity;
    piece.rate = length(steady->angular_velocity);
    piece.axis = normalized(steady->angular_velocity);
  } else if (const auto* keyed = std::get_if<KeyedMotion>(&motion)) {
    if (auto status = check_path(*keyed); !status) return status.error();
    const auto& keys = keyed->keys;
    path.pieces_.reserve(keys.size() + 1);
    path.pieces_.push_back(resting(keys.front(), -kInfinity));
    for (std::size_t i = 0; i + 1 < keys.size(); ++i)
      path.pieces_.push_back(between(keys[i], keys[i + 1], keyed->curve));
    path.pieces_.push_back(resting(keys.back(), keys.back().time));
  }
  return path;
}

MotionState Path::Piece::at(double time) const {
  const double u = time - origin;
  const Quatd q = rate == 0 ? q0 : turned_by(axis, rate * u) * q0;
  return {c0 + (c1 + (c2 + c3 * u) * u) * u, q, velocity(time), axis * rate};
}

Vec3d Path::Piece::velocity(double time) const {
  const double u = time - origin;
  return c1 + (c2 * 2 + c3 * (3 * u)) * u;
}

double Path::Piece::most_acceleration(double from, double to) const {
  PHYSIM_ASSERT(from <= to);
  const auto at = [&](double time) { return length(c2 * 2 + c3 * (6 * (time - origin))); };
  return c2 == Vec3d{} && c3 == Vec3d{} ? 0 : std::max(at(from), at(to));
}

std::size_t Path::index_at(double time) const {
  const auto after =
      std::upper_bound(pieces_.begin(), pieces_.end(), time, [](double t, const Piece& p) { return t < p.start; });
  PHYSIM_ASSERT(after != pieces_.begin());
  return static_cast<std::size_t>(after - pieces_.begin()) - 1;
}

Transform Path::transform(const Piece& piece, double time) const {
  const MotionState state = piece.at(time);
  return {state.position, state.rotation, scale_};
}

bool Path::rests(double from, double to) const {
  bool some = false;
  pieces(from, to, [&](const Piece& piece, double, double) {
    some = some || !piece.is_straight() || piece.c1 != Vec3d{};
    return !some;
  });
  return !some;
}

Bounds Path::bounds(const Bounds& own, double from, double to) const {
  PHYSIM_ASSERT(own.low.x <= own.high.x);
  const Vec3d far{std::max(std::abs(own.low.x), std::abs(own.high.x)),
                  std::max(std::abs(own.low.y), std::abs(own.high.y)),
                  std::max(std::abs(own.low.z), std::abs(own.high.z))};
  const double reach = length(far) * scale_ * (1 + 1e-12);
  Bounds all;
  pieces(from, to, [&](const Piece& piece, double begin, double end) {
    const double h = end - begin, bend = h * h / 8;
    const Vec3d a = piece.at(begin).position, b = piece.at(end).position;
    Bounds origins, about = placement(piece, begin).outside(own);
    origins.take(a), origins.take(b);
    about.take(placement(piece, end).outside(own));
    const double off = bend * piece.most_acceleration(begin, end);
    about.widen(off + bend * piece.rate * piece.rate * reach);
    if (piece.rate != 0) {  // it lies in the ball about its origin, however far it turns
      origins.widen((off + reach) * (1 + 1e-12) + 1e-15 * origins.extent());
      about.meet(origins);
    }
    all.take(about);
    return true;
  });
  return all;
}

double Path::most_approach(const Vec3d& p, double from, double to) const {
  double most = 0;
  pieces(from, to, [&](const Piece& piece, double begin, double end) {
    const double h = end - begin;
    const double speed = length(piece.velocity(begin)) + piece.most_acceleration(begin, end) * h;
    most = std::max(most, speed + piece.rate * (length(p - piece.at(begin).position) + speed * h));
    return true;
  });
  return most * (1 + 1e-12);
}

}  // namespace physim::collide

namespace physim {

Vec3d velocity_at(const MotionState& state, const Vec3d& place) {
  const IeeeMode mode;
  return state.velocity + cross(state.angular_velocity, place - state.position);
}

namespace {

Quatd turn_of(const collide::Path::Piece& by, double since, double time) {
  return by.at(since + time).rotation * conjugate(by.at(since).rotation);
}

State<double> carried(const collide::Path::Piece& by, const OnThing& on, const Vec3d& along, double time) {
  const MotionState from = by.at(on.since), to = by.at(on.since + time);
  if (by.rate == 0) return {on.x + along + (to.position - from.position), to.velocity};
  const Quatd turn = to.rotation * conjugate(from.rotation);
  const Vec3d gone = along - cross(from.angular_velocity, on.normal) * (on.radius * time);
  // All of it tilts with the surface; about the normal, what was gone first turned farthest.
  Vec3d way = gone + rotate(turn, gone);
  const Vec3d then = rotate(turn, on.normal);
  way -= then * dot(way, then);
  if (const double chord = length(way); chord > 0) way *= length(gone) / chord;
  const Vec3d place = to.position + rotate(turn, on.x - from.position) + way;
  return {place, velocity_at(to, place - then * on.radius)};
}

Vec3d seen_from_turning(const collide::Path::Piece& by, const OnThing& on, const Vec3d& a, const Vec3d& v,
                        const AlongThing& along) {
  PHYSIM_ASSERT(along.time > 0);
  const Vec3d n = on.normal, omega = by.axis * by.rate, tilt = omega - n * dot(omega, n);
  const Vec3d more = carried(by, on, along.way, along.time).v - carried(by, on, {}, along.time).v;
  const Vec3d seen = a - more * (1 / along.time);
  return seen - cross(tilt, seen) * (0.5 * along.time) + n * dot(v, cross(tilt, n));
}

BallMotion turned(const collide::Path::Piece& by, const OnThing& on, const BallMotion& motion, const Ball& ball,
                  const AlongThing& along) {
  constexpr double kNoSlip = 1e-9;  // [m/s]
  const Vec3d n = on.normal, then = rotate(turn_of(by, on.since, along.time), n);
  const Vec3d v = motion.velocity - (n + then) * (dot(motion.velocity, then) / (1 + dot(n, then)));
  const bool rolls =
      on.radius > 0 && length(motion.velocity - along.over - cross(motion.spin, n) * on.radius) <= kNoSlip;
  if (!rolls) return {v, motion.spin};
  const Vec3d about = cross(then, v - along.over) * (1 / on.radius) + then * dot(motion.spin, n);
  return {v, component_product(ball.turns, about)};
}

EvenWay::Moment moment_met(const EvenWay& way, const SceneHit& met, const Vec3d& over) {
  const auto gap = [&](double part) {
    const EvenWay::Moment at = way.after_time(part);
    const Vec3d there = met.position + met.velocity * (at.time - met.part * way.time());
    return dot(at.state.x + over - there, met.normal);
  };
  const double before = gap(0), after = gap(1);
  return way.after_time(before > 0 && after < 0 ? find_root(gap, 0, before, 1, after, 0) : met.part);
}

}  // namespace

const Carriage collide::kCarriage{carried, seen_from_turning, turned, moment_met};

}  // namespace physim
