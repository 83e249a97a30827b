// The odometer: the distance travelled on a path by a time, and the time of a distance. A pure function of the
// path, so that what happens every few metres does not depend on when a caller looks.
//
// Symbols: s(t) length of the path from its beginning to time t [m], c(t) its place, so that s' = |c'|.
// Equation: on a straight piece s grows by |c'| t; on a cubic one s is the sum of Gauss-Legendre quadratures of |c'|
//   with five points over equal parts of the piece, which depend on the piece alone.
// When it is wrong: where a cubic piece turns back on the spot its speed has a corner, and the sum is off by some
//   1e-5 of that part.
// Source: M. Abramowitz, I. A. Stegun, Handbook of Mathematical Functions (1964), table 25.4.
#pragma once

#include <optional>
#include <vector>

#include "collide/path.hpp"

namespace physim {

class Odometer {
 public:
  /// Counts on a path from a time on [s].
  Odometer(const collide::Path& path, double from);

  /// Distance travelled by a time, from() or later [m].
  [[nodiscard]] double at(double time) const;
  /// The time at which the distance, above 0, is reached, if that is not after `latest` [s].
  [[nodiscard]] std::optional<double> when(double distance, double latest) const;
  [[nodiscard]] double from() const { return marks_.front().time; }

 private:
  /// The beginning of a part of a piece, and the distance by then.
  struct Mark {
    double time = 0;
    double distance = 0;
    collide::Path::Piece piece;
  };
  /// The last mark that is not after a time.
  [[nodiscard]] const Mark& mark_at(double time) const;
  [[nodiscard]] static double way(const collide::Path::Piece& piece, double from, double to);

  std::vector<Mark> marks_;
};

}  // namespace physim
