#include "world/core/step_way.hpp"

#include <limits>

#include "base/assert.hpp"

namespace physim {
namespace {

/// Keys that are no farther apart are one: how fast something moved between them would be a matter of rounding [s].
constexpr double kShortestMove = 1e-9;

}  // namespace

StepWay::StepWay(const MotionKey& begin) : last_(begin) {
  pieces_.push_back(collide::resting(begin, -std::numeric_limits<double>::infinity()));
}

void StepWay::go(const MotionKey& key, MotionCurve curve) {
  PHYSIM_ASSERT(curve == MotionCurve::straight || curve == MotionCurve::smooth);
  if (key.time - last_.time > kShortestMove) pieces_.push_back(collide::between(last_, key, curve));
  last_ = key;
}

void StepWay::go_straight(MotionKey key) {
  const double h = key.time - last_.time;
  key.velocity = h > kShortestMove ? (key.position - last_.position) * (1 / h) : Vec3d{};
  go(key, MotionCurve::straight);
}

void StepWay::arrive(const MotionKey& key) { go(key, MotionCurve::smooth); }

void StepWay::turn(const MotionKey& key) {
  const double h = key.time - last_.time;
  MotionKey before = key;
  if (h > kShortestMove) before.velocity = (key.position - last_.position) * (2 / h) - last_.velocity;
  go(before, MotionCurve::smooth);
  last_ = key;
}

collide::Path StepWay::path() const {
  std::vector<collide::Path::Piece> pieces = pieces_;
  pieces.push_back(collide::resting(last_, last_.time));
  pieces.back().c1 = last_.velocity;
  return collide::Path(std::move(pieces));
}

}  // namespace physim
