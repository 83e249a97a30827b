// Covariances carried through a flight by its slopes.
//
// Symbols: J slopes of the quantities by the inputs at their means, by central differences over a tenth of a deviation
//   to each side; C covariance of the inputs. Covariance of the quantities: J C J^T.
// When wrong: where quantities bend within the spread of the inputs, or inputs are far from normal.
// Source: JCGM 100:2008, Guide to the Expression of Uncertainty in Measurement, sec. 5 and eq. (13).
#include <cmath>

#include "base/ieee_mode.hpp"
#include "study/correlation.hpp"
#include "study/estimates.hpp"
#include "study/misses.hpp"

namespace physim {
namespace {

constexpr double kPart = 0.1;  // of a deviation to each side

/// Columns of the shots that slopes are taken from: the mean of all, then each input up and down.
struct SlopeBlock {
  std::vector<std::vector<double>> inputs, quantities;
  std::vector<double> deviations;

  explicit SlopeBlock(const StudyPlanRecord& plan) {
    const std::size_t n = plan.study.inputs.size();
    quantities.assign(plan.columns(), std::vector<double>(2 * n + 1));
    for (std::size_t i = 0; i < n; ++i) {
      const Distribution& d = plan.study.inputs[i].distribution;
      deviations.push_back(std::sqrt(variance_of(d)));
      inputs.emplace_back(2 * n + 1, mean_of(d));
      inputs[i][2 * i + 1] += kPart * deviations[i];
      inputs[i][2 * i + 2] -= kPart * deviations[i];
    }
  }
  void evaluate(const ShotModel& model) {
    const std::vector<std::span<const double>> in(inputs.begin(), inputs.end());
    const std::vector<std::span<double>> out(quantities.begin(), quantities.end());
    ModelScratch scratch;
    model.evaluate(in, out, scratch);
  }
};

/// Effects of a group's inputs together, one row for each independent number that they are made of.
std::vector<std::vector<double>> independent_effects(const InputGroup& group, const LinearResult& result) {
  const std::size_t quantities = result.mean.size();
  std::vector<std::vector<double>> rows(group.inputs.size(), std::vector<double>(quantities));
  for (std::size_t i = 0; i < group.inputs.size(); ++i)
    for (std::size_t k = 0; k <= i; ++k) {
      const double part = group.root.empty() ? 1 : group.root[i * (i + 1) / 2 + k];
      for (std::size_t q = 0; q < quantities; ++q) rows[k][q] += part * result.rows[group.inputs[i]].effect[q];
    }
  return rows;
}

void add_group(const InputGroup& group, LinearResult& result) {
  const std::size_t n = result.mean.size();
  PHYSIM_ASSERT(result.covariance.size() == n * n);
  for (const std::vector<double>& effect : independent_effects(group, result))
    for (std::size_t a = 0; a < n; ++a) {
      for (std::size_t b = 0; b < n; ++b) result.covariance[a * n + b] += effect[a] * effect[b];
      result.rows[group.inputs[0]].share[a] += effect[a] * effect[a];
    }
}

/// The part of the plane's covariance that a group makes.
PlaneCovariance on_plane(const InputGroup& group, const LinearResult& result) {
  PlaneCovariance sum;
  for (const std::vector<double>& effect : independent_effects(group, result)) {
    sum.right_right += effect[0] * effect[0];
    sum.right_up += effect[0] * effect[1];
    sum.up_up += effect[1] * effect[1];
  }
  return sum;
}

void put_misses(const StudyPlanRecord& plan, LinearResult& result) {
  const std::size_t n = result.mean.size();
  PHYSIM_ASSERT(n >= 2 && result.covariance.size() == n * n);
  const PlaneCovariance all{result.covariance[0], result.covariance[1], result.covariance[n + 1]};
  Misses misses(plan.study, {result.mean[0], result.mean[1]}, all);
  for (LinearRow& row : result.rows) row.misses.assign(plan.study.targets.size(), 0);
  for (const InputGroup& group : plan.groups)
    result.rows[group.inputs[0]].misses = misses.shares_of(on_plane(group, result));
}

}  // namespace

Result<LinearResult> propagate_linearly(const StudyPlan& plan) {
  const IeeeMode mode;
  const StudyPlanRecord& record = plan.record();
  SlopeBlock block(record);
  block.evaluate(*record.model);
  block.quantities.resize(record.study.quantities.size());  // those of places have plans of their own
  const std::size_t quantities = block.quantities.size();
  LinearResult result;
  for (const auto& column : block.quantities) {
    for (const double x : column)
      if (!is_finite(x))
        return Error{"a shot near the mean of all inputs does not arrive", "until",
                     "linear propagation needs slopes there; sample instead"};
    result.mean.push_back(column[0]);
  }
  result.covariance.assign(quantities * quantities, 0);
  for (std::size_t i = 0; i < block.inputs.size(); ++i) {
    LinearRow row{.input = i, .deviation = block.deviations[i], .share = std::vector<double>(quantities)};
    for (const auto& column : block.quantities) {
      const double change = column[2 * i + 1] - column[2 * i + 2];
      row.effect.push_back(row.deviation > 0 ? change / (2 * kPart) : 0);
      row.slope.push_back(row.deviation > 0 ? row.effect.back() / row.deviation : 0);
    }
    result.rows.push_back(std::move(row));
  }
  for (const InputGroup& group : record.groups) add_group(group, result);
  for (LinearRow& row : result.rows)
    for (std::size_t q = 0; q < quantities; ++q)
      if (const double all = result.covariance[q * quantities + q]; all > 0) row.share[q] /= all;
  if (record.has_plane() && !record.study.targets.empty()) put_misses(record, result);
  return result;
}

}  // namespace physim
