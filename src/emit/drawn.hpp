// Numbers and colours that emitters draw, prepared: curves and gradients as pieces, constants found out.
//
// Symbols: a(x) = value curve(x), b(x) = to to_curve(x), x part of the span; u between 0 and 1.
// Equation: number = a + u (b - a); its integral from 0 to x as well, of the integrals of both curves. A piece
//   c0 + c1 s + c2 s^2 + c3 s^3 has the integral s (c0 + s (c1 / 2 + s (c2 / 3 + s c3 / 4))).
// Source: F. N. Fritsch, J. Butland, SIAM J. Sci. Stat. Comput. 5 (1984) 300-304, for the monotone cubics.
#pragma once

#include <algorithm>
#include <array>
#include <cstdint>
#include <type_traits>
#include <utility>
#include <vector>

#include "base/assert.hpp"
#include "emit/drawn_lanes.hpp"
#include "physim/emitter.hpp"

namespace physim {

/// Several of a column at a time, or, where it is no multiple of them, each alone.
template <std::size_t N>
using WideOf = std::conditional_t<N % 4 != 0, double, Pack<double, 4>>;

/// Which part of its life is over.
[[nodiscard]] inline double part_of_life(double time, double birth, double span) {
  PHYSIM_ASSERT(span > 0);
  const double part = (time - birth) / span;
  return part < 0 ? 0 : part > 1 ? 1 : part;
}

/// A curve over 0..1; 1 where it has no keys.
class EmitCurve {
 public:
  EmitCurve() = default;
  explicit EmitCurve(const Curve& keys);

  [[nodiscard]] bool is_one() const { return pieces_.empty(); }
  [[nodiscard]] double operator()(double x) const { return pieces_.empty() ? 1 : value(x); }
  /// The values at many places, none below 0.
  template <std::size_t N>
  void at_each(const std::array<double, N>& x, std::array<double, N>& y) const;
  /// From 0 to x >= 0, beyond 1 too.
  [[nodiscard]] double integral(double x) const { return pieces_.empty() ? x : sum(x); }
  /// Its derivative, behind a corner that of the piece that begins there.
  [[nodiscard]] double slope(double x) const;
  /// Where its pieces begin.
  [[nodiscard]] std::vector<double> knots() const;

  [[nodiscard]] CurvePieces pieces() const { return {pieces_.data(), pieces_.size(), first_}; }

 private:
  [[nodiscard]] const CurvePiece& piece_at(double x) const;
  [[nodiscard]] double value(double x) const;
  [[nodiscard]] double sum(double x) const;

  std::vector<CurvePiece> pieces_;  // as CurvePieces has them
  std::size_t first_ = 0;           // as CurvePieces has it
};

template <std::size_t N>
void EmitCurve::at_each(const std::array<double, N>& x, std::array<double, N>& y) const {
  if (pieces_.empty()) return y.fill(1);
  put_curve<WideOf<N>>(pieces(), x.data(), y.data(), N);
}

/// A number that is drawn. What wants `draw` calls it for u where it is needed, and not otherwise.
class EmitNumber {
 public:
  explicit EmitNumber(const DrawnNumber& def);

  [[nodiscard]] bool is_constant() const { return !drawn_ && curve_.is_one(); }
  [[nodiscard]] bool is(double constant) const { return is_constant() && value_ == constant; }
  [[nodiscard]] bool is_drawn() const { return drawn_; }
  /// Whether it is another one at other places.
  [[nodiscard]] bool follows() const { return !curve_.is_one() || !to_curve_.is_one(); }
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
  /// Numbers at the places `x` of a column to `y`, made of the words that were drawn where some are.
  [[nodiscard]] NumberJob job(const double* x, const std::uint32_t* words, double* y) const {
    PHYSIM_ASSERT((words != nullptr) == drawn_);
    return {value_, to_, curve_.pieces(), to_curve_.pieces(), x, words, y};
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

/// The smallest and the largest number that can be drawn. NaN if a value or a curve has a NaN.
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

/// Many colours, part by part.
template <std::size_t N>
using RgbaColumns = std::array<std::array<double, N>, 4>;
template <std::size_t N>
[[nodiscard]] ColourColumns columns_of(RgbaColumns<N>& colour) {
  return {{colour[0].data(), colour[1].data(), colour[2].data(), colour[3].data()}};
}
template <std::size_t N>
void multiply(RgbaColumns<N>& a, const RgbaColumns<N>& b) {
  for (std::size_t k = 0; k < 4; ++k)
    for (std::size_t i = 0; i < N; ++i) a[k][i] = a[k][i] * b[k][i] / 255;
}
/// Each rounded to the nearest.
template <std::size_t N>
void pack_each(const RgbaColumns<N>& from, std::array<std::uint32_t, N>& to) {
  to = {};
  for (const std::array<double, N>& part : from)
    for (std::size_t i = 0; i < N; ++i) {
      PHYSIM_ASSERT(part[i] >= 0 && part[i] < 255.5);
      to[i] = to[i] << 8 | static_cast<std::uint32_t>(static_cast<std::int32_t>(part[i] + 0.5));
    }
}

/// A gradient over 0..1; white where it has no keys.
class EmitGradient {
 public:
  EmitGradient() = default;
  explicit EmitGradient(const Gradient& keys);

  [[nodiscard]] bool is_white() const { return pieces_.empty(); }
  [[nodiscard]] Rgba operator()(double x) const {
    RgbaColumns<1> one;
    at_each<1>({x}, one);
    return {{one[0][0], one[1][0], one[2][0], one[3][0]}};
  }
  /// Columns go through a kernel.
  template <std::size_t N>
  void at_each(const std::array<double, N>& x, RgbaColumns<N>& colour, const ParticleKernel* kernel = nullptr) const;

  [[nodiscard]] GradientPieces pieces() const { return {pieces_.data(), pieces_.size()}; }

 private:
  std::vector<GradientPiece> pieces_;  // as GradientPieces has them
};

template <std::size_t N>
void EmitGradient::at_each(const std::array<double, N>& x, RgbaColumns<N>& colour, const ParticleKernel* kernel) const {
  if (pieces_.empty()) {
    for (auto& part : colour) part.fill(255);
    return;
  }
  if constexpr (N == kColumn)
    if (kernel != nullptr) return kernel->gradient(pieces(), x.data(), columns_of(colour));
  put_gradient<WideOf<N>>(pieces(), x.data(), columns_of(colour), N);
}

/// A colour that is drawn.
class EmitColour {
 public:
  explicit EmitColour(const DrawnColour& def);

  [[nodiscard]] bool is_drawn() const { return drawn_; }
  [[nodiscard]] bool is_white() const { return !drawn_ && gradient_.is_white() && colour_.is_white(); }
  /// Whether it is another one at other places.
  [[nodiscard]] bool follows() const { return !gradient_.is_white() || !to_gradient_.is_white(); }
  template <class DrawU>
  [[nodiscard]] Rgba at(double x, DrawU&& draw) const {
    RgbaColumns<1> one;
    at_each<1>({x}, one, [&draw] { return std::array<double, 1>{draw()}; });
    return {{one[0][0], one[1][0], one[2][0], one[3][0]}};
  }
  /// Many colours at a time; `draw` gives all of their u. Gradients of columns go through a kernel.
  template <std::size_t N, class DrawU>
  void at_each(const std::array<double, N>& x, RgbaColumns<N>& colour, DrawU&& draw,
               const ParticleKernel* kernel = nullptr) const {
    put(colour_, gradient_, x, colour, kernel);
    if (!drawn_) return;
    RgbaColumns<N> to;
    put(to_, to_gradient_, x, to, kernel);
    const auto& u = std::forward<DrawU>(draw)();
    for (std::size_t k = 0; k < 4; ++k)
      for (std::size_t i = 0; i < N; ++i) {
        PHYSIM_ASSERT(u[i] >= 0 && u[i] <= 1);
        colour[k][i] = colour[k][i] + u[i] * (to[k][i] - colour[k][i]);
      }
  }

 private:
  /// A colour times a gradient.
  template <std::size_t N>
  static void put(const Rgba& plain, const EmitGradient& gradient, const std::array<double, N>& x,
                  RgbaColumns<N>& colour, const ParticleKernel* kernel) {
    if (!gradient.is_white()) gradient.at_each(x, colour, kernel);
    if (!gradient.is_white() && plain.is_white()) return;  // a product with white is the other factor
    for (std::size_t k = 0; k < 4; ++k)
      for (std::size_t i = 0; i < N; ++i)
        colour[k][i] = gradient.is_white() ? plain.part[k] : plain.part[k] * colour[k][i] / 255;
  }

  Rgba colour_, to_;
  bool drawn_;
  EmitGradient gradient_, to_gradient_;
};

}  // namespace physim
