// Places on the way of a study's flights, held to parabolas, to studies that end there, and to closed forms of normal
// numbers; the bits of it.
#include "study_support.hpp"

namespace physim::study_places_test {

using namespace test;
using Q = StudyQuantity;

constexpr double kG = 9.80665;

StudyPlace place(EventKind kind, double value = 0, Crossing direction = Crossing::any, std::vector<Q> quantities = {}) {
  return {{.kind = kind, .value = value, .direction = direction}, std::move(quantities)};
}

/// A throw over flat ground in a vacuum, told at its apex, at heights, at a range line and at a time.
Study thrown() {
  Study study;
  study.environment.gravity = {.model = GravityModel::constant, .acceleration = kG};
  study.fidelity = vacuum();
  study.launch = {.position = {0, 3, 0}, .speed = 30, .elevation = 0.5};
  study.inputs = {input("shot.speed", NormalDistribution{30, 1}),
                  input("shot.elevation", NormalDistribution{0.5, 0.01})};
  study.at = {place(EventKind::apex, 0, Crossing::falling),
              place(EventKind::height, 6, Crossing::falling, {Q::right, Q::along, Q::time}),
              place(EventKind::range, 20), place(EventKind::time, 0.5, Crossing::any, {Q::x}),
              place(EventKind::height, 6, Crossing::rising, {Q::time})};
  study.shard_shots = 256;
  study.shots = 2048;
  return study;
}

void expect_parabolas(const StudyPlan& plan, double g) {
  const StudyShots shots = fly_shots_of(plan, 1);
  ASSERT_EQ(shots.at.size(), 5U);
  for (std::size_t i = 0; i < 256; ++i) {
    const double v = shots.inputs[0][i], e = shots.inputs[1][i], across = v * std::cos(e), up = v * std::sin(e);
    const double at_6 = std::sqrt(up * up - 2 * g * 3);
    const auto& apex = shots.at[0].quantities;  // right, along, y, time, speed
    EXPECT_TRUE(near(apex[1][i], across * up / g, 1e-9));
    EXPECT_TRUE(near(apex[2][i], 3 + up * up / (2 * g), 1e-9));
    EXPECT_TRUE(near(apex[4][i], across, 1e-9));
    EXPECT_TRUE(near(shots.at[1].quantities[2][i], (up + at_6) / g, 1e-9));
    EXPECT_TRUE(near(shots.at[4].quantities[0][i], (up - at_6) / g, 1e-9));
    const double t = 20 / across;
    EXPECT_TRUE(near(shots.at[2].quantities[1][i], up * t - 0.5 * g * t * t, 1e-9)) << "above the line of sight";
    EXPECT_TRUE(near(shots.at[2].quantities[2][i], t, 1e-9));
    EXPECT_TRUE(near(shots.at[3].quantities[0][i], 0.5 * across, 1e-9));
    EXPECT_TRUE(near(shots.quantities[1][i], across * (up + std::sqrt(up * up + 6 * g)) / g, 1e-9)) << "its end";
    EXPECT_TRUE(shots.at[0].inputs.empty());
  }
}

/// In each way that shots of a study are flown: as launches, each by itself, each at a place of its own, among things.
TEST(StudyPlaces, lie_on_parabolas) {
  expect_parabolas(plan_of(thrown()), kG);
  Study study = thrown();
  study.inputs.push_back(input("shot.mass", UniformDistribution{0.5, 2}));
  expect_parabolas(plan_of(study), kG);
  study.inputs.back() = input("environment.gravity.acceleration", DiscreteDistribution{{5}});
  expect_parabolas(plan_of(study), 5);
  study = thrown();
  Scene scene;
  ASSERT_TRUE(scene.add({.shape = scene.add_shape(BoxShape{{1, 1, 1}}).value(), .transform = {{0, 0, 500}}}));
  study.scene = std::make_shared<const Scene>(std::move(scene));
  study.quantities = {Q::right, Q::along};
  expect_parabolas(plan_of(study), kG);
}

TEST(StudyPlaces, have_what_nobody_names) {
  Study study = thrown();
  study.at = {place(EventKind::apex, 0, Crossing::any, {Q::y}), place(EventKind::height, 6), place(EventKind::time, 1),
              place(EventKind::speed, 28), place(EventKind::range, 20)};
  const Study filled = plan_of(study).study();
  EXPECT_EQ(filled.at[0].event.direction, Crossing::falling) << "the highest point, not a low one";
  EXPECT_EQ(filled.at[1].event.direction, Crossing::any);
  EXPECT_EQ(filled.at[1].quantities, (std::vector{Q::right, Q::along, Q::time, Q::speed}));
  EXPECT_EQ(filled.at[2].quantities, (std::vector{Q::right, Q::along, Q::y, Q::speed}));
  EXPECT_EQ(filled.at[3].quantities, (std::vector{Q::right, Q::along, Q::y, Q::time}));
  EXPECT_EQ(filled.at[4].quantities, (std::vector{Q::right, Q::up, Q::time, Q::speed}));
}

/// A million normal speeds: the height of the apex has mean h = (m^2 + s^2) sin^2 e / 2 g over the muzzle, and a shot
/// passes above a mark at a range where it is fast enough.
TEST(StudyPlaces, have_figures_that_are_known) {
  const double e = 0.5, m = 30, s = 1;
  Study study = thrown();
  study.inputs.pop_back();
  study.until.range = 60;
  study.at = {place(EventKind::apex, 0, Crossing::any, {Q::y}), place(EventKind::range, 20)};
  study.targets = {{"above", RectangleTarget{{0, 508}, 10, 1000}}};
  study.fidelity.motion = Motion::closed_form;
  study.shots = 200'000;
  study.shard_shots = 4096;
  const auto run = must(run_study(plan_of(study)));
  ASSERT_EQ(run.at.size(), 2U);
  const double factor = std::sin(e) * std::sin(e) / (2 * kG), n = static_cast<double>(run.shots);
  const double variance = factor * factor * (4 * m * m * s * s + 2 * s * s * s * s);
  const QuantityResult& y = run.at[0].quantities[0];
  EXPECT_EQ(run.at[0].quantities.size(), 1U);
  EXPECT_TRUE(within_4_errors(y.mean.value, 3 + (m * m + s * s) * factor, y.mean.error));
  EXPECT_TRUE(near(y.mean.error, std::sqrt(variance / n), 1e-2));
  const StudyResult& line = run.at[1];
  ASSERT_EQ(line.hits.size(), 1U) << "its axes are those of the end";
  const double needed = 20 / std::cos(e) * std::sqrt(0.5 * kG / (20 * std::tan(e) - 8));
  const double expected = 0.5 * std::erfc((needed - m) / s / std::sqrt(2.0));
  EXPECT_GT(expected, 0.05);
  EXPECT_LT(expected, 0.95);
  EXPECT_TRUE(within_4_errors(line.hits[0].probability.value, expected, line.hits[0].probability.error));
  EXPECT_EQ(line.not_arrived, 0U);
}

/// A rifle's shots told on their way to 400 m, and studies that end there.
TEST(StudyPlaces, are_where_studies_would_end) {
  Study study;
  study.projectile = presets::rifle_bullet().projectile;
  study.launch = {.speed = 790, .elevation = 0.003};
  study.fidelity = Fidelity::small_arms();
  study.until = {.ground = std::nullopt, .range = 400};
  study.inputs = {input("shot.speed", NormalDistribution{790, 3}), input("shot.azimuth", NormalDistribution{0, 1e-3}),
                  input("environment.wind.velocity.z", UniformDistribution{-2, 2}),
                  input("environment.atmosphere.temperature", NormalDistribution{288, 4})};
  study.targets = {{"plate", RectangleTarget{{0, 0.2}, 0.5, 0.5}}};
  study.shard_shots = 256;
  study.shots = 512;
  for (const bool own_drag : {false, true}) {
    if (own_drag) study.inputs.push_back(input("shot.drag.ballistic_coefficient", UniformDistribution{150, 160}));
    study.at.clear();
    const StudyResult alone = *run_study(plan_of(study));
    study.at = {place(EventKind::range, 100), place(EventKind::range, 250)};
    const StudyResult both = *run_study(plan_of(study));
    EXPECT_EQ(both.quantities, alone.quantities) << "places change nothing of the end";
    EXPECT_EQ(both.hits, alone.hits);
    for (std::size_t i = 0; i < 2; ++i) {
      Study ends = study;
      ends.at.clear();
      ends.until.range = study.at[i].event.value;
      const StudyResult there = *run_study(plan_of(ends));
      for (std::size_t q = 0; q < 4; ++q) {
        EXPECT_NEAR(both.at[i].quantities[q].mean.value, there.quantities[q].mean.value, 1e-8) << i << ' ' << q;
        EXPECT_NEAR(both.at[i].quantities[q].most, there.quantities[q].most, 1e-8) << i << ' ' << q;
      }
      EXPECT_EQ(both.at[i].hits[0].hits, there.hits[0].hits);
      EXPECT_NEAR(both.at[i].from_aim->mean.value, there.from_aim->mean.value, 1e-8);
    }
  }
}

/// Shots that a wall stops come no farther, and are no hits there.
TEST(StudyPlaces, are_not_come_to_by_shots_that_ended) {
  Study study;
  study.environment.gravity.model = GravityModel::constant;
  study.fidelity = vacuum();
  study.fidelity.gravity = GravityModel::off;
  study.launch = {.speed = 100};
  study.until = {.ground = std::nullopt, .time = 1};
  study.inputs = {input("shot.azimuth", UniformDistribution{-0.1, 0.1})};
  Scene scene;
  ASSERT_TRUE(
      scene.add({.shape = scene.add_shape(BoxShape{{1, 1, 50}}).value(), .transform = {{51, 0, 50}}, .name = "wall"}));
  study.scene = std::make_shared<const Scene>(std::move(scene));
  study.targets = {{"wall", ThingTarget{"wall"}}};
  study.at = {place(EventKind::range, 40), place(EventKind::range, 80)};
  study.shard_shots = 256;
  study.shots = 512;
  const auto run = must(run_study(plan_of(study)));
  EXPECT_EQ(run.at[0].not_arrived, 0U);
  EXPECT_EQ(run.at[1].not_arrived, run.hits[0].hits) << "those that the wall stopped";
  EXPECT_GT(run.hits[0].hits, 100U);
  EXPECT_TRUE(run.at[1].hits.empty()) << "things are hit wherever they stand";
}

/// A function whose end scatters normally, and with half of that at one place, by one number at another.
void on_the_way(std::span<const std::span<const double>> in, std::span<const std::span<double>> out) {
  scattered(in, out);
  for (std::size_t i = 0; i < out[0].size(); ++i) {
    out[2][i] = 0.5 * in[0][i], out[3][i] = 0.5 * in[1][i];
    out[4][i] = in[0][i] > 1 ? NAN : in[0][i] * in[0][i];
  }
}

Study on_the_way_study(Sampling sampling) {
  Study study = scatter();
  study.sampling = sampling;
  study.targets = {{"circle", CircleTarget{{}, 1}}};
  study.at = {{{}, {Q::right, Q::up}}, {{}, {Q::x}}};
  study.indices = true;
  study.over_inputs = 4;
  study.shard_shots = 256;
  study.shots = 48 * 256;
  return study;
}

TEST(StudyPlaces, of_functions_are_further_columns) {
  Study study = on_the_way_study(Sampling::random);
  study.indices = false;
  study.shots = 400'000;
  const StudyResult run = result_of(study, on_the_way);
  ASSERT_EQ(run.at.size(), 2U);
  const StudyResult& near_by = run.at[0];
  EXPECT_TRUE(within_4_errors(near_by.from_aim->mean.value, 0.5 * std::sqrt(0.5 * std::acos(-1.0)),
                              near_by.from_aim->mean.error));
  EXPECT_TRUE(within_4_errors(near_by.hits[0].probability.value, 1 - std::exp(-2), near_by.hits[0].probability.error));
  EXPECT_NEAR(near_by.from_aim->r50, 0.5 * 1.1774, 0.005);
  EXPECT_EQ(near_by.over_inputs.size(), 2U);
  const double never = 0.5 * std::erfc(1 / std::sqrt(2.0)), n = static_cast<double>(run.shots);
  EXPECT_NEAR(static_cast<double>(run.at[1].not_arrived) / n, never, 4 * std::sqrt(never * (1 - never) / n));
  EXPECT_FALSE(run.at[1].from_aim);
  study.at[1].quantities = {Q::x, Q::time};
  study.shots = 512;
  const StudyResult mixed = result_of(study, [](auto in, auto out) {
    on_the_way(in, out);
    std::copy(in[0].begin(), in[0].end(), out[5].begin());
  });
  EXPECT_FALSE(mixed.at[1].ellipse) << "a length and a time are no plane";
  EXPECT_TRUE(run.at[1].hits.empty()) << "no plane";
}

TEST(StudyPlaces, have_the_same_bits_however_they_are_flown) {
  for (const Sampling sampling : {Sampling::random, Sampling::latin_hypercube, Sampling::sobol}) {
    const StudyPlan plan = plan_study(on_the_way_study(sampling), on_the_way).value();
    StudyPart all;
    expect_one_set_of_bits(plan, all);
    const StudyResult run = *run_study(plan), joined = *result_of(plan, all, plan.shards());
    for (std::size_t i = 0; i < 2; ++i) {
      EXPECT_EQ(joined.at[i].quantities, run.at[i].quantities);
      EXPECT_EQ(joined.at[i].indices, run.at[i].indices);
      const StudyResult alone = *run_study(plan.places()[i]);
      EXPECT_EQ(alone.quantities, run.at[i].quantities) << "flown by itself";
      EXPECT_EQ(alone.hits, run.at[i].hits);
      EXPECT_EQ(alone.indices, run.at[i].indices);
      EXPECT_EQ(alone.over_inputs, run.at[i].over_inputs);
      EXPECT_EQ(alone.not_arrived, run.at[i].not_arrived);
      EXPECT_EQ(alone.worst, run.at[i].worst);
    }
  }
}

/// Flights too, on every kernel that this machine has.
TEST(StudyPlaces, have_one_set_of_bits_on_each_kernel) {
  std::vector<std::byte> bytes;
  for (const std::string& kernel : kernels()) {
    ASSERT_TRUE(use_kernel(kernel));
    const StudyPlan plan = plan_of(thrown());
    const std::vector<std::byte> here = saved_shards(plan);
    if (bytes.empty()) bytes = here;
    EXPECT_EQ(here, bytes) << kernel;
    EXPECT_EQ(run_study(plan.places()[2])->quantities, run_study(plan)->at[2].quantities) << kernel;
  }
  ASSERT_TRUE(use_kernel(""));
}

TEST(StudyPlaces, damaged_parts_are_refused) {
  Study study = on_the_way_study(Sampling::latin_hypercube);
  study.shard_shots = 64;
  const StudyPlan plan = plan_study(study, on_the_way).value();
  const std::vector<std::byte> bytes = save_part(*run_shards(plan, 0, 3));
  for (std::size_t i = 0; i < bytes.size(); i += 1 + bytes.size() / 300) {
    std::vector<std::byte> damaged = bytes;
    damaged[i] ^= std::byte{4};
    EXPECT_FALSE(load_part(damaged)) << i;
    EXPECT_FALSE(load_part(std::span(bytes).first(i))) << i;
  }
  study.at.pop_back();
  const auto fewer = plan_study(study, [](auto in, auto out) {
    scattered(in, out);
    scattered(in, out.subspan(2));
  });
  EXPECT_FALSE(merge(run_shard(*fewer, 4), run_shard(plan, 0))) << "it is another study";
}

TEST(StudyPlaces, are_propagated_by_slopes) {
  const StudyPlan plan = plan_of(thrown());
  const auto linear = must(propagate_linearly(plan.places()[0]));
  const double up = 30 * std::sin(0.5), across = 30 * std::cos(0.5);
  EXPECT_TRUE(near(linear.mean[2], 3 + up * up / (2 * kG), 1e-9));
  EXPECT_TRUE(near(linear.rows[0].slope[2], up * std::sin(0.5) / kG, 1e-6)) << "of the apex by the speed";
  EXPECT_TRUE(near(linear.rows[1].slope[2], up * across / kG, 1e-4)) << "... by the elevation";
  EXPECT_EQ(propagate_linearly(plan)->mean.size(), 4U);
  EXPECT_EQ(fly_shot_of(plan, 3).size(), 4U);
  EXPECT_EQ(fly_shot_of(plan.places()[3], 3).size(), 1U);
}

TEST(StudyPlaces, bad_input) {
  const auto refusal = [](auto change) { return refusal_of(thrown(), change); };
  const auto says = [](const std::string& text, const char* a, const char* b) {
    return text.find(a) != text.npos && text.find(b) != text.npos ? testing::AssertionSuccess()
                                                                  : testing::AssertionFailure() << text;
  };
  EXPECT_TRUE(says(refusal([](Study& s) { s.at[2].event.value = 1000; }), "at[2]", "0 arrived there"));
  EXPECT_TRUE(says(refusal([](Study& s) { s.at[2].event.value = -5; }), "at[2].event.value", "above 0"));
  EXPECT_TRUE(says(refusal([](Study& s) { s.at[2].event.value = NAN; }), "at[2].event.value", "no number"));
  EXPECT_TRUE(says(refusal([](Study& s) { s.at[2].event.kind = EventKind::landed; }), "at[2].event.kind", "watches"));
  EXPECT_TRUE(says(refusal([](Study& s) { s.at.push_back(s.at[1]); }), "at[5]", "at[1] again"));
  EXPECT_TRUE(says(refusal([](Study& s) { s.at.push_back(place(EventKind::apex)); }), "at[5]", "at[0] again"));
  EXPECT_TRUE(says(refusal([](Study& s) {
                     s.at[0].quantities = {Q::y, Q::obliquity};
                   }),
                   "at[0].quantities[1]", "first impact"));
  EXPECT_TRUE(says(refusal([](Study& s) { s.at[0].quantities = {Q::y, Q::y}; }), "at[0].quantities[1]", "twice"));
  EXPECT_TRUE(says(refusal([](Study& s) { s.at.assign(25, s.at[0]); }), "at", "more than 24"));
  EXPECT_TRUE(says(refusal([](Study& s) { s.at[0] = place(EventKind::burnout); }), "at[0]", "0 arrived there"));
  Study study = on_the_way_study(Sampling::random);
  study.at[1].quantities.clear();
  EXPECT_TRUE(says(plan_study(study, on_the_way).error().text(), "at[1].quantities", "function"));
}

}  // namespace physim::study_places_test
