// Which part of the shots that miss a target miss it for the spread of one input, by slopes.
//
// Model: impacts on the plane are normal about the impact m of the shot with the mean of each input, with a covariance
//   S = sum over groups of correlated inputs of S_g, J C J^T of that group (study/linear.cpp).
// Symbols: M(S) part of the impacts beside the target; share of a group's misses 1 - M(S - S_g) / M(S): these
//   would hit if its inputs stood at their means. Shares of all groups do not add up to 1; where the mean shot misses,
//   spread brings hits, and shares may be negative.
//   M is a mean over a Fibonacci lattice of N points u_i = (i / N, {i F / N}), shifted by half a cell, which the
//   inverse normal distribution function and Cholesky's root of S carry to the plane.
// When wrong: as for slopes (study/linear.cpp). Fewer than a hundred points beside a target show nothing.
// Source: I. H. Sloan, S. Joe, Lattice Methods for Multiple Integration (1994), sec. 1.4 and ch. 4.
#pragma once

#include <vector>

#include "study/plan.hpp"

namespace physim {

/// The covariance of impacts on the plane: right and right, right and up, up and up [m^2].
struct PlaneCovariance {
  double right_right = 0, right_up = 0, up_up = 0;

  friend PlaneCovariance operator-(const PlaneCovariance& a, const PlaneCovariance& b) {
    return {a.right_right - b.right_right, a.right_up - b.right_up, a.up_up - b.up_up};
  }
};

/// Misses of the targets of a study; its mean shot hits the plane at a point.
class Misses {
 public:
  Misses(const Study& study, const PlanePoint& mean, const PlaneCovariance& all);

  /// The share of each target's misses that a group makes, by its part of the covariance; NaN where hardly any miss,
  /// and of things, which are no part of the plane.
  [[nodiscard]] std::vector<double> shares_of(const PlaneCovariance& group);
  /// The part of all impacts that lies beside each target.
  [[nodiscard]] const std::vector<double>& parts_beside() const { return beside_; }

 private:
  [[nodiscard]] std::vector<double> parts_beside(const PlaneCovariance& covariance);

  const Study& study_;
  PlanePoint mean_;
  PlaneCovariance all_;
  std::vector<std::uint32_t> numbers_;  // of the lattice's points
  std::vector<double> first_, second_;  // normal numbers of each
  std::vector<double> right_, up_;      // where they lie on the plane [m]
  std::vector<std::uint8_t> marks_;
  std::vector<double> beside_;
};

}  // namespace physim
