// Studies of functions, whose figures are known in closed form.
#pragma once

#include <cstddef>

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
  return {.inputs = {input("right", NormalDistribution{right, 1}), input("up", NormalDistribution{up, 1})},
          .shots = 1'000'000,
          .quantities = {StudyQuantity::right, StudyQuantity::up}};
}

inline StudyResult result_of(const Study& study, const StudyFunction& function, TaskRunner* runner = nullptr) {
  const auto plan = plan_study(study, function);
  if (!plan) {
    ADD_FAILURE() << plan.error().text();
    return {};
  }
  return must(run_study(*plan, runner));
}

inline StudyPlan plan_of(const Study& study) {
  const auto plan = plan_study(study);
  EXPECT_TRUE(plan) << plan.error().text();
  return *plan;
}

/// All of a study's bits, as they are saved.
inline std::vector<std::byte> saved_shards(const StudyPlan& plan, TaskRunner* runner = nullptr) {
  return save_part(*run_shards(plan, 0, plan.shards(), runner));
}

/// One set of bits from one, two and seven threads, and from parts that were saved, loaded and joined in another order;
/// `all` becomes what was joined. For studies of 48 shards.
inline void expect_one_set_of_bits(const StudyPlan& plan, StudyPart& all) {
  ASSERT_EQ(plan.shards(), 48U);
  const std::vector<std::byte> bytes = saved_shards(plan);
  for (const unsigned threads : {2u, 7u}) {
    const auto pool = make_thread_pool(threads);
    EXPECT_EQ(saved_shards(plan, pool.get()), bytes) << threads;
  }
  all = {};
  for (const auto& [first, count] : {std::pair<std::uint64_t, std::uint64_t>{20, 28}, {0, 7}, {7, 13}}) {
    const auto loaded = load_part(save_part(*run_shards(plan, first, count)));
    ASSERT_TRUE(loaded) << loaded.error().text();
    all = merge(all, *loaded).value();
  }
  EXPECT_EQ(save_part(all), bytes);
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
