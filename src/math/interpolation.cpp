#include "math/interpolation.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>

#include "base/assert.hpp"

namespace physim {
namespace {

using Slopes = std::vector<double>;

/// Interior slopes are weighted harmonic means of the neighbouring secants, zero where these change sign (Fritsch and
/// Butland's formula); end slopes come from the parabola through three points, limited to keep the curve monotone.
double pchip_end_slope(double h0, double h1, double d0, double d1) {
  const double slope = ((2 * h0 + h1) * d0 - h0 * d1) / (h0 + h1);
  if (slope * d0 <= 0) return 0;
  if (d0 * d1 <= 0 && std::abs(slope) > 3 * std::abs(d0)) return 3 * d0;
  return slope;
}

Slopes pchip_slopes(std::span<const double> h, std::span<const double> secant) {
  const std::size_t n = h.size();
  PHYSIM_ASSERT(n > 0 && secant.size() == n);
  Slopes m(n + 1, secant[0]);
  if (n == 1) return m;
  for (std::size_t i = 1; i < n; ++i) {
    const double before = secant[i - 1];
    const double after = secant[i];
    const double w1 = 2 * h[i] + h[i - 1];
    const double w2 = h[i] + 2 * h[i - 1];
    m[i] = before * after <= 0 ? 0 : (w1 + w2) / (w1 / before + w2 / after);
  }
  m[0] = pchip_end_slope(h[0], h[1], secant[0], secant[1]);
  m[n] = pchip_end_slope(h[n - 1], h[n - 2], secant[n - 1], secant[n - 2]);
  return m;
}

/// Natural spline: continuity of the second derivative gives a tridiagonal system for the slopes,
/// m[i-1]/h[i-1] + 2 m[i] (1/h[i-1] + 1/h[i]) + m[i+1]/h[i] = 3 (d[i-1]/h[i-1] + d[i]/h[i]), with 2 m0 + m1 = 3 d0 at
/// the ends; solved by elimination without pivoting (it is diagonally dominant).
Slopes natural_slopes(std::span<const double> h, std::span<const double> secant) {
  const std::size_t n = h.size();
  PHYSIM_ASSERT(n > 0 && secant.size() == n);
  std::vector<double> diagonal(n + 1), upper(n + 1), right(n + 1);
  diagonal[0] = 2, upper[0] = 1, right[0] = 3 * secant[0];
  for (std::size_t i = 1; i <= n; ++i) {
    const double lower = i < n ? 1 / h[i - 1] : 1;
    const double factor = lower / diagonal[i - 1];
    if (i < n) {
      diagonal[i] = 2 * (1 / h[i - 1] + 1 / h[i]) - factor * upper[i - 1];
      upper[i] = 1 / h[i];
      right[i] = 3 * (secant[i - 1] / h[i - 1] + secant[i] / h[i]) - factor * right[i - 1];
    } else {
      diagonal[i] = 2 - factor * upper[i - 1];
      right[i] = 3 * secant[n - 1] - factor * right[i - 1];
    }
  }
  Slopes m(n + 1);
  m[n] = right[n] / diagonal[n];
  for (std::size_t i = n; i-- > 0;) m[i] = (right[i] - upper[i] * m[i + 1]) / diagonal[i];
  return m;
}

/// The slopes at the points of a curve that is smooth there.
Slopes slopes(Interpolation how, const std::vector<double>& h, const std::vector<double>& secant) {
  switch (how) {
    case Interpolation::pchip: return pchip_slopes(h, secant);
    case Interpolation::cubic: return natural_slopes(h, secant);
    case Interpolation::linear: break;
  }
  PHYSIM_UNREACHABLE();
}

bool every_knot_on_grid(const std::vector<double>& knots, double cell) {
  return std::all_of(knots.begin(), knots.end(), [&](double x) {
    const double u = (x - knots.front()) / cell;
    return std::abs(u - std::round(u)) < 1e-9;
  });
}

}  // namespace

double PiecewiseCubic::operator()(double x) const {
  if (pieces.empty()) return 0;
  PHYSIM_ASSERT(knots.size() == pieces.size() + 1);
  x = std::clamp(x, knots.front(), knots.back());
  const auto next = std::upper_bound(knots.begin() + 1, knots.end() - 1, x);
  const auto i = static_cast<std::size_t>(next - knots.begin()) - 1;
  const auto& c = pieces[i];
  const double s = x - knots[i];
  return c[0] + s * (c[1] + s * (c[2] + s * c[3]));
}

std::vector<double> rising(std::vector<double> numbers) {
  std::sort(numbers.begin(), numbers.end());
  numbers.erase(std::unique(numbers.begin(), numbers.end()), numbers.end());
  return numbers;
}

PiecewiseCubic interpolate(std::span<const double> x, std::span<const double> y, Interpolation how) {
  PHYSIM_ASSERT(!x.empty() && x.size() == y.size());
  PiecewiseCubic curve;
  curve.knots.assign(x.begin(), x.end());
  if (x.size() == 1) {
    curve.knots.push_back(x[0] + 1);
    curve.pieces = {{y[0], 0, 0, 0}};
    return curve;
  }
  const std::size_t n = x.size() - 1;
  curve.pieces.reserve(n);
  std::vector<double> h(n), secant(n);
  for (std::size_t i = 0; i < n; ++i) {
    h[i] = x[i + 1] - x[i];
    PHYSIM_ASSERT(h[i] > 0);
    secant[i] = (y[i + 1] - y[i]) / h[i];
  }
  if (how == Interpolation::linear) {  // its slope jumps at the points
    for (std::size_t i = 0; i < n; ++i) curve.pieces.push_back({y[i], secant[i], 0, 0});
    return curve;
  }
  const Slopes m = slopes(how, h, secant);
  for (std::size_t i = 0; i < n; ++i) {
    const double c2 = (3 * secant[i] - 2 * m[i] - m[i + 1]) / h[i];
    const double c3 = (m[i] + m[i + 1] - 2 * secant[i]) / (h[i] * h[i]);
    curve.pieces.push_back({y[i], m[i], c2, c3});
  }
  return curve;
}

std::optional<UniformCubic> on_uniform_cells(const PiecewiseCubic& curve, int max_cells) {
  PHYSIM_ASSERT(max_cells > 0 && curve.knots.size() == curve.pieces.size() + 1);
  const auto& knots = curve.knots;
  const double span = knots.back() - knots.front();
  double smallest = span;
  for (std::size_t i = 1; i < knots.size(); ++i) smallest = std::min(smallest, knots[i] - knots[i - 1]);
  for (int part = 1; span / (smallest / part) <= max_cells + 0.5; ++part) {
    const double cell = smallest / part;
    if (!every_knot_on_grid(knots, cell)) continue;
    const int cells = static_cast<int>(std::lround(span / cell));
    UniformCubic out{knots.front(), span / cells, {}};
    out.rows.reserve(static_cast<std::size_t>(cells));
    std::size_t piece = 0;
    PHYSIM_ASSERT(cells >= 1 && cells <= max_cells);
    for (int i = 0; i < cells; ++i) {
      const double x = out.start + (i + 0.5) * out.cell;
      while (piece + 2 < knots.size() && x > knots[piece + 1]) ++piece;
      // Shift the polynomial from the knot to the cell's left border, then stretch the cell to unit length.
      const auto& c = curve.pieces[piece];
      const double first = std::round((knots[piece] - out.start) / out.cell);
      const double s = (i - first) * out.cell;
      const double w = out.cell;
      out.rows.push_back({c[0] + s * (c[1] + s * (c[2] + s * c[3])), w * (c[1] + s * (2 * c[2] + 3 * s * c[3])),
                          w * w * (c[2] + 3 * s * c[3]), w * w * w * c[3]});
    }
    return out;
  }
  return std::nullopt;
}

}  // namespace physim
