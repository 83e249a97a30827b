// Numbers and colours that emitters draw, prepared: curves and gradients as pieces, constants found out.
//
// Symbols: a(x) = value curve(x), b(x) = to to_curve(x), x part of the span; u between 0 and 1.
// Equation: number = a + u (b - a); its integral from 0 to x likewise, of the integrals of both curves. A piece
//   c0 + c1 s + c2 s^2 + c3 s^3 has the integral s (c0 + s (c1 / 2 + s (c2 / 3 + s c3 / 4))).
// Source: F. N. Fritsch, J. Butland, SIAM J. Sci. Stat. Comput. 5 (1984) 300-304, for the monotone cubics.
#pragma once

#include <algorithm>
#include <array>
#include <cstdint>
#include <utility>
#include <vector>

#include "base/assert.hpp"
#include "physim/emitter.hpp"

namespace physim {

/// A curve over 0..1; 1 where it has no keys.
class EmitCurve {
 public:
  EmitCurve() = default;
  explicit EmitCurve(const Curve& keys);

  [[nodiscard]] bool is_one() const { return pieces_.empty(); }
  [[nodiscard]] double operator()(double x) const { return pieces_.empty() ? 1 : value(x); }
  /// The values at many places, none below 0: pieces are counted rather than searched.
  template <std::size_t N>
  void at_each(const std::array<double, N>& x, std::array<double, N>& y) const;
  /// From 0 to x >= 0, beyond 1 too.
  [[nodiscard]] double integral(double x) const { return pieces_.empty() ? x : sum(x); }
  /// Its derivative, behind a corner that of the piece that begins there.
  [[nodiscard]] double slope(double x) const;
  /// Where its pieces begin.
  [[nodiscard]] std::vector<double> knots() const;

 private:
  struct Piece {
    double start;
    std::array<double, 4> c;
    double low, high;  // its ends, between which it stays: rounding would not
    double before;     // the integral from 0 to its start
  };
  [[nodiscard]] const Piece& piece_at(double x) const;
  [[nodiscard]] static double value(const Piece& p, double x) {
    const double s = x - p.start;
    return std::clamp(p.c[0] + s * (p.c[1] + s * (p.c[2] + s * p.c[3])), p.low, p.high);
  }
  [[nodiscard]] double value(double x) const;
  [[nodiscard]] double sum(double x) const;

  std::vector<Piece> pieces_;  // in order; the first starts at 0, the last one goes on for ever
};

template <std::size_t N>
void EmitCurve::at_each(const std::array<double, N>& x, std::array<double, N>& y) const {
  if (pieces_.empty()) return y.fill(1);
  std::array<std::uint64_t, N> piece{};
  for (std::size_t k = 1; k < pieces_.size(); ++k) {
    const double start = pieces_[k].start;
    for (std::size_t i = 0; i < N; ++i) piece[i] += x[i] < start ? 0 : 1;
  }
  for (std::size_t i = 0; i < N; ++i) y[i] = value(pieces_[piece[i]], x[i]);
}

/// A number that is drawn. What wants `draw` calls it for u where it is needed, and not otherwise.
class EmitNumber {
 public:
  explicit EmitNumber(const DrawnNumber& def);

  [[nodiscard]] bool is_constant() const { return !drawn_ && curve_.is_one(); }
  [[nodiscard]] bool is(double constant) const { return is_constant() && value_ == constant; }
  [[nodiscard]] bool is_drawn() const { return drawn_; }
  [[nodiscard]] const EmitCurve& curve() const { return curve_; }
  [[nodiscard]] const EmitCurve& to_curve() const { return to_curve_; }

  template <class DrawU>
  [[nodiscard]] double at(double x, DrawU&& draw) const {
    const double a = curve_.is_one() ? value_ : value_ * curve_(x);
    return drawn_ ? between(a, to_ * to_curve_(x), std::forward<DrawU>(draw)()) : a;
  }
  /// Many numbers at a time; `draw` gives all of their u.
  template <std::size_t N, class DrawU>
  void at_each(const std::array<double, N>& x, std::array<double, N>& y, DrawU&& draw) const {
    y.fill(value_);
    if (!curve_.is_one()) {
      curve_.at_each(x, y);
      for (double& a : y) a = value_ * a;
    }
    if (!drawn_) return;
    std::array<double, N> b;
    to_curve_.at_each(x, b);
    const std::array<double, N>& u = std::forward<DrawU>(draw)();
    for (std::size_t i = 0; i < N; ++i) y[i] = between(y[i], to_ * b[i], u[i]);
  }
  template <class DrawU>
  [[nodiscard]] double integral(double x, DrawU&& draw) const {
    const double a = value_ * curve_.integral(x);
    return drawn_ ? between(a, to_ * to_curve_.integral(x), std::forward<DrawU>(draw)()) : a;
  }
  template <class DrawU>
  [[nodiscard]] double slope(double x, DrawU&& draw) const {
    const double a = value_ * curve_.slope(x);
    return drawn_ ? between(a, to_ * to_curve_.slope(x), std::forward<DrawU>(draw)()) : a;
  }
  /// Where curves do not count.
  template <class DrawU>
  [[nodiscard]] double plain(DrawU&& draw) const {
    return drawn_ ? between(value_, to_, std::forward<DrawU>(draw)()) : value_;
  }

 private:
  static double between(double a, double b, double u) {
    PHYSIM_ASSERT(u >= 0 && u <= 1);
    return a == b ? a : a + u * (b - a);
  }

  double value_, to_;
  bool drawn_;
  EmitCurve curve_, to_curve_;
};

/// The smallest and the largest number that can be drawn. NaN where something is none.
struct NumberRange {
  double least, most;
};
[[nodiscard]] NumberRange range_of(const DrawnNumber& number);

/// The nearest whole number, 0 below.
[[nodiscard]] std::uint32_t whole_count(double x);

/// Red, green, blue and alpha, 0..255.
struct Rgba {
  std::array<double, 4> part{255, 255, 255, 255};

  [[nodiscard]] static Rgba of(std::uint32_t colour) {
    const auto byte = [colour](int shift) { return static_cast<double>(colour >> shift & 0xff); };
    return {{byte(24), byte(16), byte(8), byte(0)}};
  }
  /// Rounded to the nearest.
  [[nodiscard]] std::uint32_t packed() const {
    std::uint32_t colour = 0;
    for (const double x : part) {
      PHYSIM_ASSERT(x >= 0 && x < 255.5);
      colour = colour << 8 | static_cast<std::uint32_t>(static_cast<std::int32_t>(x + 0.5));
    }
    return colour;
  }
  [[nodiscard]] bool is_white() const { return part == Rgba{}.part; }
};
[[nodiscard]] inline Rgba times(const Rgba& a, const Rgba& b) {
  Rgba product;
  for (std::size_t i = 0; i < 4; ++i) product.part[i] = a.part[i] * b.part[i] / 255;
  return product;
}
/// a at u = 0, b at u = 1.
[[nodiscard]] inline Rgba mixed(const Rgba& a, const Rgba& b, double u) {
  PHYSIM_ASSERT(u >= 0 && u <= 1);
  Rgba mix;
  for (std::size_t i = 0; i < 4; ++i) mix.part[i] = a.part[i] + u * (b.part[i] - a.part[i]);
  return mix;
}

/// A gradient over 0..1; white where it has no keys.
class EmitGradient {
 public:
  EmitGradient() = default;
  explicit EmitGradient(const Gradient& keys);

  [[nodiscard]] bool is_white() const { return keys_.empty(); }
  [[nodiscard]] Rgba operator()(double x) const;

 private:
  struct Key {
    double at;
    Rgba colour;
  };
  std::vector<Key> keys_;
};

/// A colour that is drawn.
class EmitColour {
 public:
  explicit EmitColour(const DrawnColour& def);

  [[nodiscard]] bool is_drawn() const { return drawn_; }
  [[nodiscard]] bool is_white() const { return !drawn_ && gradient_.is_white() && colour_.is_white(); }
  template <class DrawU>
  [[nodiscard]] Rgba at(double x, DrawU&& draw) const {
    const Rgba a = gradient_.is_white() ? colour_ : starts_white_ ? gradient_(x) : times(colour_, gradient_(x));
    return drawn_ ? mixed(a, times(to_, to_gradient_(x)), std::forward<DrawU>(draw)()) : a;
  }

 private:
  Rgba colour_, to_;
  bool starts_white_;  // a product with white would be the other factor
  bool drawn_;
  EmitGradient gradient_, to_gradient_;
};

}  // namespace physim
