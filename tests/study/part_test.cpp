// Parts of studies joined, whatever they have of each other.
#include "study/part.hpp"

#include <random>
#include <set>

#include "study/study_support.hpp"

namespace physim::study_part_test {

StudyPlan small_study(std::uint64_t seed = 1) {
  Study study = test::scatter();
  study.seed = seed;
  study.shots = 16 * 64;
  study.shard_shots = 16;
  return plan_study(study, test::scattered).value();
}

StudyPart part_of(const StudyPlan& plan, const std::set<std::uint64_t>& shards) {
  StudyPart part;
  for (const std::uint64_t shard : shards) part = merge(part, run_shard(plan, shard)).value();
  return part;
}

std::set<std::uint64_t> drawn_shards(std::mt19937& random, std::uint64_t count, double share) {
  std::set<std::uint64_t> shards;
  for (std::uint64_t i = 0; i < count; ++i)
    if (std::bernoulli_distribution(share)(random)) shards.insert(i);
  return shards;
}

TEST(StudyParts, united_have_the_shards_of_both_and_the_bits_of_one) {
  const StudyPlan plan = small_study();
  std::mt19937 random(1);
  for (int i = 0; i < 40; ++i) {
    const double share = i % 2 == 0 ? 0.5 : 0.9;
    const auto of_a = drawn_shards(random, 64, share), of_b = drawn_shards(random, 64, 1 - share);
    std::set<std::uint64_t> all = of_a;
    all.insert(of_b.begin(), of_b.end());
    const StudyPart expected = part_of(plan, all), a = part_of(plan, of_a), b = part_of(plan, of_b);
    EXPECT_EQ(save_part(united(a, b).value()), save_part(expected)) << i;
    EXPECT_EQ(save_part(united(b, a).value()), save_part(expected)) << i;
  }
}

TEST(StudyParts, merged_have_no_shard_twice) {
  const StudyPlan plan = small_study();
  const StudyPart low = part_of(plan, {0, 1, 2, 3, 8}), high = part_of(plan, {9, 10, 2});
  const auto refused = merge(low, high);
  ASSERT_FALSE(refused);
  EXPECT_EQ(refused.error().message, "both parts have shard 2");
  EXPECT_EQ(merge(high, low).error().message, "both parts have shard 2");
  EXPECT_EQ(merge(low, part_of(plan, {0, 1})).error().message, "both parts have shards 0 to 1");
  EXPECT_EQ(merge(low, part_of(plan, {9, 10}))->shards(), 7U);
}

TEST(StudyParts, of_different_studies_are_not_united) {
  EXPECT_FALSE(united(part_of(small_study(1), {0}), part_of(small_study(2), {1})));
}

}  // namespace physim::study_part_test
