// Studies of functions, whose figures are known in closed form.
#pragma once

#include <vector>

#include "physim/study.hpp"
#include "physim/task_runner.hpp"
#include "support.hpp"

namespace physim::test {

/// One number out of those of a shot.
template <class F>
StudyFunction one_quantity(F f) {
  return [f](std::span<const std::span<const double>> in, std::span<const std::span<double>> out) {
    std::vector<double> x(in.size());
    for (std::size_t i = 0; i < out[0].size(); ++i) {
      for (std::size_t k = 0; k < in.size(); ++k) x[k] = in[k][i];
      out[0][i] = f(x);
    }
  };
}

/// The first two inputs are the impact.
inline void scattered(std::span<const std::span<const double>> in, std::span<const std::span<double>> out) {
  for (std::size_t q = 0; q < 2; ++q) std::copy(in[q].begin(), in[q].end(), out[q].begin());
}

inline StudyInput input(const char* path, const Distribution& distribution) {
  return {.path = path, .distribution = distribution};
}

/// Impacts that scatter normally about a point.
inline Study scatter(double right = 0, double up = 0) {
  Study study;
  study.inputs = {input("right", NormalDistribution{right, 1}), input("up", NormalDistribution{up, 1})};
  study.quantities = {StudyQuantity::right, StudyQuantity::up};
  study.shots = 1'000'000;
  return study;
}

inline StudyResult result_of(const Study& study, const StudyFunction& function, TaskRunner* runner = nullptr) {
  const auto plan = plan_study(study, function);
  if (!plan) {
    ADD_FAILURE() << plan.error().text();
    return {};
  }
  const auto result = run_study(*plan, runner);
  if (!result) ADD_FAILURE() << result.error().text();
  return result ? *result : StudyResult{};
}

/// What a study is refused with that is changed so; empty where it is not.
template <class Change>
std::string refusal_of(Study study, const Change& change) {
  change(study);
  const auto plan = plan_study(study);
  return plan ? std::string() : plan.error().text();
}

/// Within four standard errors.
inline testing::AssertionResult within_4_errors(double value, double expected, double error) {
  if (std::abs(value - expected) <= 4 * error) return testing::AssertionSuccess();
  return testing::AssertionFailure() << value << " is " << (value - expected) / error << " standard errors from "
                                     << expected;
}

}  // namespace physim::test
