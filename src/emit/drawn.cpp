#include "emit/drawn.hpp"

#include <algorithm>
#include <cmath>

#include "emit/emission.hpp"
#include "math/interpolation.hpp"

namespace physim {
namespace {

double integral_of(const std::array<double, 4>& c, double s) {
  return s * (c[0] + s * (c[1] / 2 + s * (c[2] / 3 + s * (c[3] / 4))));
}

/// The least and the most of a curve, which lies between its keys.
NumberRange range_of(const Curve& keys) {
  if (keys.empty()) return {1, 1};
  NumberRange range{keys[0].value, keys[0].value};
  for (const CurveKey& key : keys) {
    range.least = key.value < range.least || std::isnan(key.value) ? key.value : range.least;
    range.most = key.value > range.most || std::isnan(key.value) ? key.value : range.most;
  }
  return range;
}
NumberRange scaled(double factor, const NumberRange& range) {
  const double a = factor * range.least, b = factor * range.most;
  return a <= b ? NumberRange{a, b} : NumberRange{b, a};
}

}  // namespace

// ------------------------------------------------------------------------------------------------- curves
EmitCurve::EmitCurve(const Curve& keys) {
  if (keys.empty()) return;
  std::vector<double> x, y;
  for (const CurveKey& key : keys) x.push_back(key.at), y.push_back(key.value);
  const PiecewiseCubic cubic = interpolate(x, y, Interpolation::pchip);
  const auto add = [this](double start, const std::array<double, 4>& c, double end) {
    double before = 0;
    if (!pieces_.empty()) before = pieces_.back().before + integral_of(pieces_.back().c, start - pieces_.back().start);
    pieces_.push_back({start, c, std::min(c[0], end), std::max(c[0], end), before});
  };
  const auto held = [&](double start, double value) { add(start, {value, 0, 0, 0}, value); };
  if (x[0] > 0) held(0, y[0]), first_ = 1;
  for (std::size_t i = 0; i + 1 < x.size(); ++i) add(x[i], cubic.pieces[i], y[i + 1]);
  held(x.back(), y.back());
  PHYSIM_ASSERT(pieces_.front().start == 0);
}

const CurvePiece& EmitCurve::piece_at(double x) const {
  PHYSIM_ASSERT(!pieces_.empty());
  const auto next = std::upper_bound(pieces_.begin() + 1, pieces_.end(), x,
                                     [](double at, const CurvePiece& p) { return at < p.start; });
  return *(next - 1);
}

double EmitCurve::value(double x) const { return curve_value(lanes_of<double>(piece_at(x)), x); }

double EmitCurve::sum(double x) const {
  const CurvePiece& p = piece_at(x);
  return p.before + integral_of(p.c, x - p.start);
}

double EmitCurve::slope(double x) const {
  if (pieces_.empty()) return 0;
  const CurvePiece& p = piece_at(x);
  const double s = x - p.start;
  return p.c[1] + s * (2 * p.c[2] + s * (3 * p.c[3]));
}

std::vector<double> EmitCurve::knots() const {
  std::vector<double> starts;
  for (const CurvePiece& piece : pieces_) starts.push_back(piece.start);
  return starts;
}

// ------------------------------------------------------------------------------------------------- numbers
EmitNumber::EmitNumber(const DrawnNumber& def)
    : value_(def.value),
      to_(def.to.value_or(def.value)),
      drawn_(def.to.has_value()),
      curve_(def.curve),
      to_curve_(def.to_curve.empty() ? def.curve : def.to_curve) {}

NumberRange range_of(const DrawnNumber& number) {
  const NumberRange from = scaled(number.value, range_of(number.curve));
  if (!number.to) return from;
  const NumberRange to = scaled(*number.to, range_of(number.to_curve.empty() ? number.curve : number.to_curve));
  return {std::min(from.least, to.least), std::max(from.most, to.most)};
}

std::uint32_t whole_count(double x) {
  PHYSIM_ASSERT(x < 4294967295.0);
  return x >= 0.5 ? static_cast<std::uint32_t>(std::floor(x + 0.5)) : 0;
}

// ------------------------------------------------------------------------------------------------- colours
std::uint32_t times(std::uint32_t a, std::uint32_t b) {
  if (b == 0xffffffff) return a;  // as the product would
  return times(Rgba::of(a), Rgba::of(b)).packed();
}

EmitGradient::EmitGradient(const Gradient& keys) {
  if (keys.empty()) return;
  const auto add = [this](double start, double length, std::uint32_t from, std::uint32_t to) {
    GradientPiece piece{start, length, Rgba::of(from).part, Rgba::of(to).part};
    for (std::size_t k = 0; k < 4; ++k) piece.more[k] -= piece.colour[k];
    pieces_.push_back(piece);
  };
  add(0, 1, keys.front().colour, keys.front().colour);
  for (std::size_t i = 0; i + 1 < keys.size(); ++i)
    add(keys[i].at, keys[i + 1].at - keys[i].at, keys[i].colour, keys[i + 1].colour);
  add(keys.back().at, 1, keys.back().colour, keys.back().colour);
}

EmitColour::EmitColour(const DrawnColour& def)
    : colour_(Rgba::of(def.colour)),
      to_(Rgba::of(def.to.value_or(def.colour))),
      drawn_(def.to.has_value()),
      gradient_(def.gradient),
      to_gradient_(def.to_gradient.empty() ? def.gradient : def.to_gradient) {}

}  // namespace physim
