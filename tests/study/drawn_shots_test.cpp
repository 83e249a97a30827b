// What one shot draws by itself is what it draws among the others of its shard, bit for bit.
#include "study_support.hpp"

namespace physim::study_drawn_shots_test {

using namespace test;

/// Inputs of all kinds: one alone, two that belong together, one and two of an occasion.
Study drawn_study(Sampling sampling) {
  const auto of_occasion = [](const char* path, const Distribution& distribution) {
    return StudyInput{.path = path, .distribution = distribution, .drawn_for = DrawnFor::occasion};
  };
  Study study{
      .inputs = {input("alone", UniformDistribution{1, 2}), input("a", NormalDistribution{800, 3}),
                 input("b", LognormalDistribution{2, 0.7}), of_occasion("day", TriangularDistribution{1, 2, 7}),
                 of_occasion("c", NormalDistribution{0, 1}), of_occasion("d", TruncatedNormalDistribution{1, 2, 0, 3})},
      .correlated = {{.inputs = {1, 2}, .matrix = {1, 0.6, 0.6, 1}}, {.inputs = {4, 5}, .matrix = {1, -0.4, -0.4, 1}}},
      .rounds = 8,
      .sampling = sampling,
      .quantities = {StudyQuantity::right, StudyQuantity::up}};
  if (sampling == Sampling::sobol) {  // it knows no occasions
    study.rounds = 1;
    for (StudyInput& each : study.inputs) each.drawn_for = DrawnFor::round;
  }
  study.shard_shots = 64;
  study.shots = 64 * 48;
  return study;
}

TEST(DrawnShots, are_those_of_their_shards) {
  for (const Sampling sampling : {Sampling::random, Sampling::latin_hypercube, Sampling::sobol}) {
    const auto plan = must(plan_study(drawn_study(sampling), scattered));
    for (const std::uint64_t shard : {0u, 1u, 17u, 47u}) {
      const StudyShots all = fly_shots_of(plan, shard);
      for (std::size_t place = 0; place < 64 && !testing::Test::HasFailure(); ++place) {
        const std::vector<double> drawn = draws_of(plan, shard * 64 + place);
        ASSERT_EQ(drawn.size(), 6U);
        for (std::size_t i = 0; i < drawn.size(); ++i)
          EXPECT_TRUE(same_bits(drawn[i], all.inputs[i][place])) << name(sampling) << ' ' << shard << ' ' << place;
      }
    }
  }
}

}  // namespace physim::study_drawn_shots_test
