// Standard errors over many repeats, how fast Sobol's sequence converges, and Sobol indices of functions that have them
// in closed form.
#include "random_shots.hpp"
#include "study_support.hpp"

namespace physim::study_errors_test {

using namespace test;

/// Deviations from the truth over 200 studies, in standard errors: their squares sum up to chi-squared of 200 degrees,
/// 200 +- 20; with replicates Student's t of 15 degrees has 15 / 13 of that.
TEST(StudyErrors, are_right_over_200_repeats) {
  for (const Sampling sampling : {Sampling::random, Sampling::latin_hypercube, Sampling::sobol}) {
    Study study = scatter();
    study.sampling = sampling;
    study.shard_shots = 64;
    study.shots = 64 * 16;
    study.targets = {{"circle", CircleTarget{{}, 1}}};
    study.group_sizes = {};
    const double p = 1 - std::exp(-0.5);
    double means = 0, hits = 0, covered = 0;
    for (study.seed = 1; study.seed <= 200; ++study.seed) {
      const StudyResult run = result_of(study, scattered);
      const HitResult& hit = run.hits[0];
      means += std::pow(run.quantities[0].mean.value / run.quantities[0].mean.error, 2);
      hits += std::pow((hit.probability.value - p) / hit.probability.error, 2);
      covered += hit.low < p && p < hit.high ? 1 : 0;
    }
    const double expected = sampling == Sampling::random ? 200 : 200 * 15.0 / 13;
    EXPECT_NEAR(means, expected, 4 * 26) << name(sampling);
    EXPECT_NEAR(hits, expected, 4 * 26) << name(sampling);
    EXPECT_NEAR(covered, 190, 13) << name(sampling);
  }
}

/// Mean radii too, whose truth is sqrt(pi / 2) deviations: of evenly spread draws, and of shots that have an occasion
/// in common, whose extreme spreads of three are those of rounds alone, 2.4088 of their deviations.
TEST(StudyErrors, of_mean_radii_are_right_over_200_repeats) {
  const std::pair<Sampling, std::uint32_t> ways[] = {
      {Sampling::random, 1}, {Sampling::latin_hypercube, 1}, {Sampling::sobol, 1}, {Sampling::random, 16}};
  for (const auto& [sampling, rounds] : ways) {
    Study study = scatter();
    study.sampling = sampling;
    study.rounds = rounds;
    study.shard_shots = 64;
    study.shots = 64 * 64;
    study.group_sizes = {3};
    double deviation = 1;
    if (rounds > 1) {
      deviation = std::sqrt(2.0);
      for (const char* path : {"right of occasion", "up of occasion"})
        study.inputs.push_back(
            {.path = path, .distribution = NormalDistribution{0, 1}, .drawn_for = DrawnFor::occasion});
    }
    const StudyFunction impact = [](auto in, auto out) {
      scattered(in, out);
      for (std::size_t i = 0; i < out[0].size() && in.size() > 2; ++i) out[0][i] += in[2][i], out[1][i] += in[3][i];
    };
    const double truth = deviation * std::sqrt(0.5 * std::acos(-1.0));
    double squares = 0, spreads = 0;
    for (study.seed = 1; study.seed <= 200; ++study.seed) {
      const StudyResult run = result_of(study, impact);
      ASSERT_TRUE(run.from_aim->mean.error > 0) << name(sampling);
      squares += std::pow((run.from_aim->mean.value - truth) / run.from_aim->mean.error, 2);
      if (sampling == Sampling::random)
        spreads += std::pow((run.spreads[0].mean.value - 2.4088) / run.spreads[0].mean.error, 2);
    }
    const bool by_shots = sampling == Sampling::random && rounds == 1;
    const double expected = by_shots ? 200 : 200 * 15.0 / 13;
    EXPECT_NEAR(squares, expected, 4 * 26) << name(sampling) << ' ' << rounds;
    if (sampling == Sampling::random) {
      EXPECT_NEAR(spreads, expected, 4 * 26) << rounds;
    }
  }
}

/// Even draws know a mean radius better than chance does, and say so.
TEST(StudyErrors, of_mean_radii_shrink_with_even_draws) {
  const auto error = [](Sampling sampling) {
    Study study = scatter();
    study.sampling = sampling;
    study.shots = 64 * 4096;
    return result_of(study, scattered).from_centre->mean.error;
  };
  const double random = error(Sampling::random);
  EXPECT_LT(error(Sampling::latin_hypercube), 0.8 * random);
  EXPECT_LT(error(Sampling::sobol), 0.1 * random);
}

/// Replicates without a hit say nothing of how rare hits are: three in as many shots may be expected, and no width is
/// known. Neither is a hit certain where all hit.
TEST(StudyErrors, hits_that_were_not_seen_are_not_impossible) {
  for (const Sampling sampling : {Sampling::latin_hypercube, Sampling::sobol})
    for (const double radius : {1e-9, 100.0}) {
      Study study = scatter();
      study.sampling = sampling;
      study.shard_shots = 64;
      study.shots = 64 * 64;
      study.targets = {{"circle", CircleTarget{{}, radius}}};
      study.until_width = StudyWidth{.target = 0, .width = 1e-4};
      const StudyResult run = result_of(study, scattered);
      EXPECT_EQ(run.hits[0].hits, radius < 1 ? 0 : run.shots);
      EXPECT_NEAR(run.hits[0].high - run.hits[0].low, 3.84 / 4096, 1e-5);
      EXPECT_FALSE(run.width_reached);
      EXPECT_EQ(run.shards, 64U);
    }
}

/// Shots of an occasion that have no number in common are independent, whatever the number of rounds.
TEST(StudyErrors, of_hits_count_occasions_only_where_shots_have_something_in_common) {
  Study study = scatter();
  study.sampling = Sampling::latin_hypercube;
  study.shard_shots = 64;
  study.shots = 64 * 64;
  study.targets = {{"all", CircleTarget{{}, 100}}};
  study.rounds = 16;
  const StudyResult alone = result_of(study, scattered);
  EXPECT_NEAR(alone.hits[0].high - alone.hits[0].low, 3.84 / 4096, 1e-5);
  const auto notes = plan_study(study, scattered)->notes();
  ASSERT_EQ(notes.size(), 1U);
  EXPECT_TRUE(notes[0].starts_with("study.rounds: has no effect: ")) << notes[0];
  study.inputs[0].drawn_for = DrawnFor::occasion;
  EXPECT_TRUE(plan_study(study, scattered)->notes().empty());
  const StudyResult common = result_of(study, scattered);
  EXPECT_NEAR(common.hits[0].high - common.hits[0].low, 3.84 / 256, 1e-3);
}

/// Of two replicates Student's t has one degree of freedom: 95 % of intervals hold the truth of stopped studies, too.
TEST(StudyErrors, of_few_replicates_are_wide_enough) {
  for (const std::uint64_t shards : {2u, 4u}) {
    Study study = scatter();
    study.sampling = Sampling::latin_hypercube;
    study.shard_shots = 64;
    study.shots = 64 * 16;
    study.targets = {{"half", RectangleTarget{{5, 0}, 10, 100}}};
    double covered = 0;
    for (study.seed = 1; study.seed <= 400; ++study.seed) {
      study.inputs[1].distribution = NormalDistribution{0, 1};
      const StudyPlan plan = plan_study(study, [](auto in, auto out) {
                               for (std::size_t i = 0; i < out[0].size(); ++i) {
                                 out[0][i] = in[0][i] * in[1][i];  // what hypercubes do not even out
                                 out[1][i] = in[1][i];
                               }
                             }).value();
      const HitResult hit = physim::result_of(plan, *run_shards(plan, 0, shards), shards)->hits[0];
      covered += hit.low <= 0.5 && 0.5 <= hit.high ? 1 : 0;
    }
    EXPECT_NEAR(covered, 380, 20) << shards;
  }
}

/// What lies outside of a zone, by the bell curve beyond its edges at least, is more than it says in 5 % of studies.
TEST(StudyErrors, zones_hold_what_they_say) {
  Study study = scatter(4, -2);
  study.shard_shots = 1024;
  study.shots = 1024;
  int broken = 0;
  double outside_all = 0;
  for (study.seed = 1; study.seed <= 60; ++study.seed) {
    const ZoneResult zone = *result_of(study, scattered).zone;
    ASSERT_EQ(zone.corners.size(), 16U);
    Random r(study.seed);
    int outside = 0;
    for (int i = 0; i < 2000; ++i) {
      const double radius = std::sqrt(-2 * std::log(1 - r.unit())), turn = 2 * std::acos(-1.0) * r.unit();
      const double x = 4 + radius * std::cos(turn), y = -2 + radius * std::sin(turn);
      bool inside = true;
      for (std::size_t k = 0; k < 16; ++k) {
        const PlanePoint &a = zone.corners[k], &b = zone.corners[(k + 1) % 16];
        inside = inside && (b.right - a.right) * (y - a.up) - (b.up - a.up) * (x - a.right) > -1e-9;
      }
      outside += inside ? 0 : 1;
    }
    broken += outside > 2000 * (1 - zone.holds) ? 1 : 0;
    outside_all += outside / 1.2e5;
  }
  EXPECT_LE(broken, 9) << "3 expected at most, and four deviations";
  EXPECT_NEAR(outside_all, 8.0 / 1024, 6.0 / 1024) << "about as many shots outside as touch the edges";
  study.sampling = Sampling::latin_hypercube;
  EXPECT_FALSE(result_of(study, scattered).zone) << "not of shots that depend on each other";
}

/// A smooth function of five uniform numbers with mean 1.
TEST(StudyErrors, sobol_converges_faster_than_chance) {
  Study study;
  for (const char* path : {"a", "b", "c", "d", "e"}) study.inputs.push_back(input(path, UniformDistribution{0, 1}));
  study.quantities = {StudyQuantity::x};
  const StudyFunction smooth = one_quantity([](const std::vector<double>& x) {
    double product = 1;
    for (const double u : x) product *= 1 + 0.8 * (u * u - 1.0 / 3);
    return product;
  });
  const auto error_of = [&](Sampling sampling, std::uint32_t shard_shots) {
    study.sampling = sampling;
    study.shard_shots = shard_shots;
    study.shots = 16 * std::uint64_t{shard_shots};
    const StudyResult run = result_of(study, smooth);
    EXPECT_LT(std::abs(run.quantities[0].mean.value - 1), 5 * run.quantities[0].mean.error) << name(sampling);
    return run.quantities[0].mean.error;
  };
  const double few = error_of(Sampling::sobol, 64), many = error_of(Sampling::sobol, 16384);
  EXPECT_LT(std::log(many / few) / std::log(256.0), -0.9);
  EXPECT_GT(error_of(Sampling::random, 16384), 30 * many);
  EXPECT_LT(error_of(Sampling::latin_hypercube, 1024), 0.5 * error_of(Sampling::random, 1024));
}

void expect_indices(const StudyResult& run, const std::vector<double>& first, const std::vector<double>& total) {
  ASSERT_EQ(run.indices.size(), first.size());
  for (std::size_t i = 0; i < first.size(); ++i) {
    const IndexResult& index = run.indices[i];
    EXPECT_LT(std::abs(index.first[0].value - first[i]), 4 * index.first[0].error + 1e-9) << i;
    EXPECT_LT(std::abs(index.total[0].value - total[i]), 4 * index.total[0].error + 1e-9) << i;
    EXPECT_LT(index.first[0].error, 0.01) << i;
    EXPECT_LT(index.total[0].error, 0.01) << i;
  }
}

/// T. Ishigami, T. Homma (1990): sin a + 7 sin^2 b + 0.1 c^4 sin a, of numbers from -pi to pi.
TEST(StudyIndices, ishigami) {
  const double pi = std::acos(-1.0);
  Study study;
  for (const char* path : {"a", "b", "c"}) study.inputs.push_back(input(path, UniformDistribution{-pi, pi}));
  study.quantities = {StudyQuantity::x};
  study.indices = true;
  const StudyFunction f = one_quantity([](const std::vector<double>& x) {
    const double b = std::sin(x[1]);
    return std::sin(x[0]) * (1 + 0.1 * std::pow(x[2] * x[2], 2)) + 7 * b * b;
  });
  const double a_alone = 0.5 * std::pow(1 + 0.1 * std::pow(pi, 4) / 5, 2), b_alone = 49.0 / 8;
  const double together = 0.01 * std::pow(pi, 8) * (1.0 / 18 - 1.0 / 50), all = a_alone + b_alone + together;
  for (const Sampling sampling : {Sampling::random, Sampling::sobol}) {
    study.sampling = sampling;
    study.shots = sampling == Sampling::random ? 1 << 18 : 1 << 16;
    expect_indices(result_of(study, f), {a_alone / all, b_alone / all, 0},
                   {(a_alone + together) / all, b_alone / all, together / all});
  }
}

/// Errors of indices are those that 100 seeds show. That of b, which adds by itself and takes most of the variance, was
/// told too small, by a hundred times for a million shots of Sobol: the variance that it is divided by comes from the
/// same shots.
TEST(StudyIndices, errors_are_those_that_seeds_show) {
  constexpr int kSeeds = 100;
  const double pi = std::acos(-1.0);
  Study study;
  for (const char* path : {"a", "b", "c"}) study.inputs.push_back(input(path, UniformDistribution{-pi, pi}));
  study.quantities = {StudyQuantity::x};
  study.indices = true;
  study.shard_shots = 256;
  study.shots = 32 * 256;
  const StudyFunction f = one_quantity([](const std::vector<double>& x) {
    const double b = std::sin(x[1]);
    return std::sin(x[0]) * (1 + 0.1 * std::pow(x[2] * x[2], 2)) + 7 * b * b;
  });
  const double a_alone = 0.5 * std::pow(1 + 0.1 * std::pow(pi, 4) / 5, 2), b_alone = 49.0 / 8;
  const double together = 0.01 * std::pow(pi, 8) * (1.0 / 18 - 1.0 / 50), all = a_alone + b_alone + together;
  const double truth[] = {a_alone / all,     b_alone / all, 0,  // alone, ...
                          1 - b_alone / all, b_alone / all, together / all};
  for (const Sampling sampling : {Sampling::random, Sampling::latin_hypercube, Sampling::sobol}) {
    study.sampling = sampling;
    double off[6] = {}, told[6] = {};
    for (int seed = 0; seed < kSeeds; ++seed) {
      study.seed = static_cast<std::uint64_t>(seed);
      const StudyResult run = result_of(study, f);
      for (std::size_t i = 0; i < 6; ++i) {
        const Estimate& index = i < 3 ? run.indices[i].first[0] : run.indices[i - 3].total[0];
        off[i] += (index.value - truth[i]) * (index.value - truth[i]);
        told[i] += index.error * index.error;
      }
    }
    for (std::size_t i = 0; i < 6; ++i)
      EXPECT_NEAR(std::sqrt(told[i] / off[i]), 1, 0.35) << name(sampling) << ", figure " << i;
  }
}

/// I. M. Sobol's g function: the product of (|4 x - 2| + a) / (1 + a).
TEST(StudyIndices, g_function) {
  const std::vector<double> a{0, 1, 4.5, 9};
  Study study;
  for (const char* path : {"a", "b", "c", "d"}) study.inputs.push_back(input(path, UniformDistribution{0, 1}));
  study.quantities = {StudyQuantity::x};
  study.indices = true;
  study.shots = 1 << 18;
  const StudyResult run = result_of(study, one_quantity([&](const std::vector<double>& x) {
                                      double product = 1;
                                      for (std::size_t i = 0; i < x.size(); ++i)
                                        product *= (std::abs(4 * x[i] - 2) + a[i]) / (1 + a[i]);
                                      return product;
                                    }));
  double all = 1;
  for (const double c : a) all *= 1 + 1 / (3 * (1 + c) * (1 + c));
  std::vector<double> first, total;
  for (const double c : a) {
    const double own = 1 / (3 * (1 + c) * (1 + c));
    first.push_back(own / (all - 1));
    total.push_back(own * all / (1 + own) / (all - 1));
  }
  expect_indices(run, first, total);
}

/// Of a sum, with two inputs of correlation r: the group has a^2 + b^2 + 2 r a b of the variance.
TEST(StudyIndices, a_correlated_group_is_one_input) {
  Study study;
  for (const double deviation : {1.0, 2.0, 1.5})
    study.inputs.push_back(input(deviation == 1 ? "a" : deviation == 2 ? "b" : "c", NormalDistribution{0, deviation}));
  study.correlated = {{{0, 1}, {1, 0.5, 0.5, 1}}};
  study.quantities = {StudyQuantity::x};
  study.indices = true;
  study.shots = 1 << 17;
  const StudyFunction sum = one_quantity([](const std::vector<double>& x) { return x[0] + x[1] + x[2]; });
  const StudyResult run = result_of(study, sum);
  ASSERT_EQ(run.indices.size(), 2U);
  EXPECT_EQ(run.indices[0].inputs, (std::vector<std::size_t>{0, 1}));
  const double group = 1 + 4 + 2.0, all = group + 2.25;
  expect_indices(run, {group / all, 2.25 / all}, {group / all, 2.25 / all});

  const auto plan = plan_study(study, sum);
  const auto linear = must(propagate_linearly(*plan));
  EXPECT_NEAR(linear.covariance[0], all, 1e-9);
  EXPECT_NEAR(linear.rows[0].share[0], group / all, 1e-9);
  EXPECT_EQ(linear.rows[1].share[0], 0) << "stands in the group's first row";
  EXPECT_NEAR(linear.rows[2].slope[0], 1, 1e-9);
}

/// Half a cell at most, against numbers that are sorted.
TEST(StudyCells, quantiles_are_exact_to_their_stated_error) {
  Study study = scatter();
  study.inputs[0].distribution = LognormalDistribution{1, 3};
  study.shots = 4096;
  std::vector<double> x;
  const StudyResult run = result_of(study, [&](auto in, auto out) {
    scattered(in, out);
    x.assign(in[0].begin(), in[0].end());
  });
  std::sort(x.begin(), x.end());
  const CountedCells& cells = run.quantities[0].cells;
  EXPECT_EQ(cells.count(), x.size());
  for (const double p : {0.001, 0.01, 0.25, 0.5, 0.9, 0.99, 0.999}) {
    const double exact = x[static_cast<std::size_t>(p * 4096)];
    EXPECT_NEAR(cells.quantile(p), exact, cells.error_at(exact)) << p;
    EXPECT_NEAR(cells.part_below(cells.quantile(p)), p, 1e-9) << p;
  }
  EXPECT_LE(cells.quantile(0), x.front());
  EXPECT_GE(cells.quantile(1), x.back());
  EXPECT_TRUE(std::isnan(CountedCells{}.quantile(0.5)));
}

}  // namespace physim::study_errors_test
