// Shards leave their memory to the shards after them, and nothing else.
#include "study/shard_memory.hpp"

#include <thread>

#include "study/shard.hpp"
#include "study/study_support.hpp"

namespace physim::test::study_shard_memory_test {

TEST(ShardMemory, is_taken_again) {
  SpareMemory spare;
  EXPECT_EQ(spare.count(), 0u);
  auto one = spare.take(), other = spare.take();
  const ShardMemory* const first = one.get();
  ASSERT_NE(first, other.get());
  spare.give_back(std::move(other));
  spare.give_back(std::move(one));
  EXPECT_EQ(spare.count(), 2u);
  EXPECT_EQ(spare.take().get(), first) << "the last is the warmest";
}

TEST(ShardMemory, of_one_shard_does_not_show_in_another) {
  const auto add = [](auto inputs, auto quantities) {
    for (std::size_t i = 0; i < quantities[0].size(); ++i) quantities[0][i] = inputs[0][i] < 0 ? kNan : inputs[0][i];
  };
  Study study{.inputs = {{.path = "a", .distribution = NormalDistribution{0.5, 1}}},
              .shots = 1024,
              .shard_shots = 256,
              .quantities = {StudyQuantity::time}};
  const auto plan = must(plan_study(study, add));
  std::vector<std::vector<std::byte>> parts;
  for (std::uint64_t shard = 0; shard < 4; ++shard) parts.push_back(save_part(run_shard(plan, shard)));
  EXPECT_EQ(plan.record().spare->count(), 1u);
  for (std::uint64_t shard = 4; shard-- > 0;) EXPECT_EQ(save_part(run_shard(plan, shard)), parts[shard]) << shard;
  std::vector<std::thread> threads;
  for (std::uint64_t shard = 0; shard < 4; ++shard)
    threads.emplace_back([&, shard] { EXPECT_EQ(save_part(run_shard(plan, shard)), parts[shard]) << shard; });
  for (std::thread& thread : threads) thread.join();
  EXPECT_GE(plan.record().spare->count(), 1u);
  EXPECT_LE(plan.record().spare->count(), 4u);
}

}  // namespace physim::test::study_shard_memory_test
