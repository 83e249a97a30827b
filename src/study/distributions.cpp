#include "study/distributions.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

#include "base/checker.hpp"
#include "base/ieee_mode.hpp"
#include "math/normal.hpp"
#include "study/draw_job.hpp"
#include "study/shard_job.hpp"

namespace physim {
namespace {

constexpr double kNoNumber = std::numeric_limits<double>::quiet_NaN();

/// The height of the normal bell.
double bell_density(double z) { return 0.39894228040143267794 * exp(-0.5 * z * z); }

struct LogNumbers {
  double mean, deviation;
};
LogNumbers logarithm_of(const LognormalDistribution& d) {
  PHYSIM_ASSERT(d.mean > 0 && d.deviation > 0);
  const double ratio = d.deviation / d.mean;
  const double variance = log1p(ratio * ratio);
  return {log(d.mean) - 0.5 * variance, std::sqrt(variance)};
}

/// The part of the bell curve between the ends of a truncated one, in the tail where it keeps its digits.
struct Ends {
  double low, high;      // in deviations
  double below, inside;  // parts of the curve
  bool mirrored;
};
Ends ends_of(const TruncatedNormalDistribution& d) {
  Ends e{(d.low - d.mean) / d.deviation, (d.high - d.mean) / d.deviation, 0, 0, false};
  if (e.low > 0) {
    std::swap(e.low, e.high);
    e.low = -e.low, e.high = -e.high, e.mirrored = true;
  }
  e.below = normal_cdf(e.low);
  e.inside = normal_cdf(e.high) - e.below;
  return e;
}

struct Checks {
  Checker& c;

  void operator()(const NormalDistribution& d) {
    c.is_number(d.mean, "mean").positive(d.deviation, "deviation", "leave a certain number out of the inputs");
  }
  void operator()(const UniformDistribution& d) {
    c.is_number(d.low, "low").is_number(d.high, "high").require(d.low < d.high, "high", "must be above low");
    c.is_number(d.high - d.low, "high");
  }
  void operator()(const TriangularDistribution& d) {
    c.is_number(d.low, "low").is_number(d.high, "high").require(d.low < d.high, "high", "must be above low");
    c.is_number(d.high - d.low, "high");
    c.require(d.peak >= d.low && d.peak <= d.high, "peak", "must be from low to high");
  }
  void operator()(const LognormalDistribution& d) {
    c.positive(d.mean, "mean", "a lognormal number is above zero").positive(d.deviation, "deviation");
    c.require(d.deviation < 1e3 * d.mean, "deviation", "is more than a thousand times the mean");
  }
  void operator()(const TruncatedNormalDistribution& d) {
    c.is_number(d.mean, "mean").positive(d.deviation, "deviation");
    c.require(d.low < d.high, "high", "must be above low");
    if (!c.status_so_far()) return;
    c.require(ends_of(d).inside > 1e-200, "low", "next to nothing of the curve lies between low and high",
              "move the mean, or the ends");
  }
  void operator()(const DiscreteDistribution& d) {
    c.require(!d.values.empty(), "values", "must have at least one value");
    for (const double x : d.values) c.is_number(x, "values");
    c.require(d.weights.empty() || d.weights.size() == d.values.size(), "weights", "must be as many as values");
    double sum = 0;
    for (const double w : d.weights) c.not_negative(w, "weights"), sum += w;
    if (!d.weights.empty()) c.positive(sum, "weights", "one of them at least is above 0");
  }
};

/// Mean and variance in closed form.
struct MeanAndVariance {
  double mean, variance;
};
struct FirstMoments {
  MeanAndVariance operator()(const NormalDistribution& d) const { return {d.mean, d.deviation * d.deviation}; }
  MeanAndVariance operator()(const UniformDistribution& d) const {
    const double width = d.high - d.low;
    return {d.low + 0.5 * width, width * width / 12};
  }
  MeanAndVariance operator()(const TriangularDistribution& d) const {
    const double a = d.high - d.low, b = d.peak - d.low;
    return {d.low + (a + b) / 3, (a * a - a * b + b * b) / 18};
  }
  MeanAndVariance operator()(const LognormalDistribution& d) const { return {d.mean, d.deviation * d.deviation}; }
  /// N. L. Johnson, S. Kotz, Continuous Univariate Distributions 1 (1970), sec. 13.7.
  MeanAndVariance operator()(const TruncatedNormalDistribution& d) const {
    const Ends e = ends_of(d);
    // So narrow a piece of the bell is level to a hundredth; the formula below would lose its width to cancellation.
    if (e.high - e.low < 1e-3 && std::max(std::abs(e.low), std::abs(e.high)) < 10)
      return (*this)(UniformDistribution{d.low, d.high});
    const auto times = [](double z, double density) { return std::isfinite(z) ? z * density : 0; };
    const double low = bell_density(e.low), high = bell_density(e.high);
    const double shift = (low - high) / e.inside;
    const double shape = (times(e.low, low) - times(e.high, high)) / e.inside;
    const double mean = d.mean + (e.mirrored ? -shift : shift) * d.deviation;
    return {mean, d.deviation * d.deviation * (1 + shape - shift * shift)};
  }
  MeanAndVariance operator()(const DiscreteDistribution& d) const {
    double sum = 0, mean = 0, squares = 0;
    const auto weight = [&](std::size_t i) { return d.weights.empty() ? 1 : d.weights[i]; };
    for (std::size_t i = 0; i < d.values.size(); ++i) sum += weight(i), mean += weight(i) * d.values[i];
    mean /= sum;
    for (std::size_t i = 0; i < d.values.size(); ++i)
      squares += weight(i) * (d.values[i] - mean) * (d.values[i] - mean);
    return {mean, squares / sum};
  }
};

struct UpTo {
  double x;

  double operator()(const NormalDistribution& d) const { return normal_cdf((x - d.mean) / d.deviation); }
  double operator()(const UniformDistribution& d) const { return std::clamp((x - d.low) / (d.high - d.low), 0.0, 1.0); }
  double operator()(const TriangularDistribution& d) const {
    if (x <= d.low || x >= d.high) return x <= d.low ? 0 : 1;
    const double width = d.high - d.low;
    if (x < d.peak) return (x - d.low) * (x - d.low) / (width * (d.peak - d.low));
    return 1 - (d.high - x) * (d.high - x) / (width * (d.high - d.peak));
  }
  double operator()(const LognormalDistribution& d) const {
    const LogNumbers logs = logarithm_of(d);
    return x > 0 ? normal_cdf((log(x) - logs.mean) / logs.deviation) : 0;
  }
  double operator()(const TruncatedNormalDistribution& d) const {
    if (x <= d.low || x >= d.high) return x < d.high ? 0 : 1;
    const Ends e = ends_of(d);
    const double z = (x - d.mean) / d.deviation;
    const double part = (normal_cdf(e.mirrored ? -z : z) - e.below) / e.inside;
    return std::clamp(e.mirrored ? 1 - part : part, 0.0, 1.0);
  }
  double operator()(const DiscreteDistribution& d) const {
    double sum = 0, up_to = 0;
    for (std::size_t i = 0; i < d.values.size(); ++i) {
      const double weight = d.weights.empty() ? 1 : d.weights[i];
      sum += weight;
      if (d.values[i] <= x) up_to += weight;
    }
    return up_to / sum;
  }
};

}  // namespace

Status check(const Distribution& distribution) {
  const IeeeMode mode;
  Checker c;
  std::visit(Checks{c}, distribution);
  return c.status();
}

double mean_of(const Distribution& distribution) {
  const IeeeMode mode;
  return check(distribution) ? std::visit(FirstMoments{}, distribution).mean : kNoNumber;
}

double variance_of(const Distribution& distribution) {
  const IeeeMode mode;
  return check(distribution) ? std::visit(FirstMoments{}, distribution).variance : kNoNumber;
}

double quantile_of(const Distribution& distribution, double p) {
  const IeeeMode mode;
  return p > 0 && p < 1 && check(distribution) ? Quantiles(distribution)(p) : kNoNumber;
}

double probability_up_to(const Distribution& distribution, double x) {
  const IeeeMode mode;
  return check(distribution) && x == x ? std::visit(UpTo{x}, distribution) : kNoNumber;
}

Quantiles::Quantiles(const Distribution& distribution) : distribution_(distribution) {
  PHYSIM_ASSERT(check(distribution));
  if (const auto* lognormal = std::get_if<LognormalDistribution>(&distribution_)) {
    const LogNumbers logs = logarithm_of(*lognormal);
    log_mean_ = logs.mean, log_deviation_ = logs.deviation;
  } else if (const auto* truncated = std::get_if<TruncatedNormalDistribution>(&distribution_)) {
    const Ends e = ends_of(*truncated);
    below_ = e.below, inside_ = e.inside, mirrored_ = e.mirrored;
  } else if (const auto* discrete = std::get_if<DiscreteDistribution>(&distribution_)) {
    std::vector<std::size_t> order(discrete->values.size());
    std::iota(order.begin(), order.end(), std::size_t{0});
    std::stable_sort(order.begin(), order.end(),
                     [&](std::size_t a, std::size_t b) { return discrete->values[a] < discrete->values[b]; });
    double sum = 0;
    for (const std::size_t i : order) {
      values_.push_back(discrete->values[i]);
      cumulated_.push_back(sum += discrete->weights.empty() ? 1 : discrete->weights[i]);
    }
  }
}

double Quantiles::within_tails(double p) const {
  const auto& d = std::get<TruncatedNormalDistribution>(distribution_);
  const double part = below_ + (mirrored_ ? 1 - p : p) * inside_;
  const double z = part > 0 && part < 1 ? normal_quantile(part) : 0;
  return std::clamp(d.mean + (mirrored_ ? -z : z) * d.deviation, d.low, d.high);
}

double Quantiles::listed(double p) const {
  PHYSIM_ASSERT(!values_.empty());
  const auto at = std::upper_bound(cumulated_.begin(), cumulated_.end() - 1, p * cumulated_.back());
  return values_[static_cast<std::size_t>(at - cumulated_.begin())];
}

namespace {
double triangle_quantile(const TriangularDistribution& d, double p) {
  const double width = d.high - d.low, rise = d.peak - d.low;
  if (p * width < rise) return d.low + std::sqrt(p * width * rise);
  return d.high - std::sqrt((1 - p) * width * (d.high - d.peak));
}
}  // namespace

double Quantiles::operator()(double p) const {
  double number[1] = {p};
  from_units(number);
  return number[0];
}

void Quantiles::from_units(std::span<double> numbers) const {
  if (const auto* d = std::get_if<NormalDistribution>(&distribution_)) {
    draw_kernel().normals(numbers.data(), numbers.size(), {d->mean, d->deviation});
  } else if (const auto* u = std::get_if<UniformDistribution>(&distribution_)) {
    shard_kernel().stretch(u->low, u->high - u->low, numbers.data(), numbers.data(), numbers.size());
  } else if (const auto* t = std::get_if<TriangularDistribution>(&distribution_)) {
    for (double& x : numbers) x = triangle_quantile(*t, x);
  } else if (std::holds_alternative<LognormalDistribution>(distribution_)) {
    draw_kernel().normals(numbers.data(), numbers.size(), {});
    for (double& x : numbers) x = exp(log_mean_ + log_deviation_ * x);
  } else if (std::holds_alternative<TruncatedNormalDistribution>(distribution_)) {
    for (double& x : numbers) x = within_tails(x);
  } else {
    PHYSIM_ASSERT(std::holds_alternative<DiscreteDistribution>(distribution_));
    for (double& x : numbers) x = listed(x);
  }
}

void Quantiles::from_scores(std::span<double> numbers) const {
  if (const auto* d = std::get_if<NormalDistribution>(&distribution_)) {
    shard_kernel().stretch(d->mean, d->deviation, numbers.data(), numbers.data(), numbers.size());
  } else if (std::holds_alternative<LognormalDistribution>(distribution_)) {
    for (double& x : numbers) x = exp(log_mean_ + log_deviation_ * x);
  } else {
    constexpr double kLeast = 0x1p-53;
    for (double& x : numbers) x = std::clamp(normal_cdf(x), kLeast, 1 - kLeast);
    from_units(numbers);
  }
}

}  // namespace physim
