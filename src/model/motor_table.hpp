// The tables of the motors of a cohort, as pieces side by side in one pool.
//
// What it models: thrust, mass and drag over a burn, piece by piece: see model/motor.hpp for equations and symbols.
// Source: model/motor.hpp.
#pragma once

#include <cstddef>
#include <unordered_map>
#include <vector>

#include "model/body.hpp"
#include "physim/projectile.hpp"

namespace physim {

/// A piece of a motor's table, with the drag curve that holds in it. What a body has of it (Body::burn and the place of
/// the curve) changes where the piece ends.
struct MotorPiece {
  Burn<double> burn;
  CurvePart<double> curve;

  bool operator==(const MotorPiece&) const = default;
};

/// The pieces of all motors of a cohort, one motor after the other; the last piece of each never ends.
class MotorPool {
 public:
  /// Index of the first piece of a motor, which is found again where it is known. `burning` is the drag curve while it
  /// burns, with a factor; `coasting` that before and after.
  std::size_t add(const MotorDef& motor, const CurvePart<double>& coasting, const CurvePart<double>& burning,
                  double drag_factor);

  [[nodiscard]] const std::vector<MotorPiece>& pieces() const { return pieces_; }

 private:
  std::vector<MotorPiece> pieces_;
  std::unordered_multimap<std::size_t, std::size_t> known_;  // by hash: index of the first piece
};

}  // namespace physim
