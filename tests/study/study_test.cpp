// Studies of flights: their shots are those of fly(), and their bits depend on no thread, order, save or stop.
#include <numeric>

#include "random_shots.hpp"
#include "study_support.hpp"

namespace physim::study_study_test {

using namespace test;

/// A rifle at 300 m with all kinds of inputs.
Study rifle() {
  Study study;
  study.projectile = {
      .mass = 0.01134, .diameter = 0.00782, .drag = {.table = DragTable::g7, .ballistic_coefficient = 171}};
  study.launch = {.position = {0, 1.5, 0}, .speed = 800, .sight = {.height = 0.05, .zero_range = 100}};
  study.fidelity = Fidelity::small_arms();
  study.fidelity.rotation = RotationModel::none;
  study.until = {.range = 300};
  study.inputs = {input("shot.speed", NormalDistribution{800, 3}),
                  {.path = "shot.elevation", .distribution = NormalDistribution{0, 2e-4}, .added = true},
                  {.path = "shot.azimuth", .distribution = NormalDistribution{0, 2e-4}, .added = true},
                  input("environment.wind.velocity.z", UniformDistribution{-3, 3}),
                  input("environment.atmosphere.temperature", TriangularDistribution{275, 285, 295})};
  study.targets = {{"plate", RectangleTarget{{0, -0.4}, 0.3, 0.3}}};
  study.shard_shots = 256;
  study.shots = 2048;
  return study;
}

/// All of a study's bits.
std::vector<std::byte> bytes_of(const StudyPlan& plan, TaskRunner* runner) {
  StudyPart last;
  const StudyOptions options{.after_shard = [&](const StudyPart& part) { return last = part, true; }};
  EXPECT_TRUE(run_study(plan, runner, options));
  return save_part(last);
}

TEST(Study, has_the_same_bits_with_any_number_of_threads_and_order_of_shards) {
  for (const Sampling sampling : {Sampling::random, Sampling::latin_hypercube, Sampling::sobol}) {
    Study study = rifle();
    study.sampling = sampling;
    study.indices = sampling == Sampling::sobol;
    const StudyPlan plan = plan_of(study);
    const std::vector<std::byte> bytes = bytes_of(plan, nullptr);
    for (const unsigned threads : {2u, 7u}) {
      const auto pool = make_thread_pool(threads);
      EXPECT_EQ(bytes_of(plan, pool.get()), bytes) << name(sampling) << ' ' << threads;
    }
    std::vector<std::uint64_t> order(plan.shards());
    std::iota(order.begin(), order.end(), std::uint64_t{0});
    Random r(5);
    StudyPart part;
    for (std::size_t left = order.size(); left > 0; --left) {
      std::swap(order[static_cast<std::size_t>(r.below(static_cast<int>(left)))], order[left - 1]);
      const auto merged = must(merge(run_shard(plan, order[left - 1]), part));
      part = merged;
    }
    EXPECT_EQ(save_part(part), bytes) << name(sampling);
  }
}

/// Its numbers do not depend on the kernel, either.
TEST(Study, has_the_same_bits_with_each_kernel) {
  const StudyPlan plan = plan_of(rifle());
  const std::vector<std::byte> bytes = bytes_of(plan, nullptr);
  for (const std::string& kernel : kernels()) {
    ASSERT_TRUE(use_kernel(kernel));
    EXPECT_EQ(bytes_of(plan_of(rifle()), nullptr), bytes) << kernel;
  }
  use_kernel("");
}

TEST(Study, goes_on_where_it_was_stopped) {
  const StudyPlan plan = plan_of(rifle());
  const auto whole = run_study(plan);
  StudyPart last;
  int left = 3;
  const StudyOptions stops{.after_shard = [&](const StudyPart& part) { return last = part, --left > 0; }};
  const auto stopped = must(run_study(plan, nullptr, stops));
  EXPECT_EQ(stopped.shards, 3U);
  EXPECT_EQ(last.first_missing(), 3U);
  const auto loaded = must(load_part(save_part(last)));
  EXPECT_EQ(loaded.shards(), 3U);
  const auto resumed = must(run_study(plan, nullptr, {.so_far = loaded}));
  EXPECT_EQ(resumed.quantities, whole->quantities);
  EXPECT_EQ(resumed.hits, whole->hits);
  EXPECT_EQ(resumed.worst, whole->worst);
  EXPECT_EQ(resumed.covariance, whole->covariance);
}

/// Widths are judged at fixed counts of shards; where it was stopped between them, and where it had ended, too.
TEST(Study, goes_on_with_a_width) {
  Study study = scatter();
  study.shard_shots = 64;
  study.shots = 64 * 4096;
  study.until_width = StudyWidth{.width = 2 * 1.96 / std::sqrt(64 * 60.0)};
  const StudyPlan plan = plan_study(study, scattered).value();
  StudyPart last;
  const StudyOptions keeps{.after_shard = [&](const StudyPart& part) { return last = part, true; }};
  const auto whole = must(run_study(plan, nullptr, keeps));
  EXPECT_TRUE(whole.width_reached);
  EXPECT_EQ(whole.shards, 64U);
  const auto again = must(run_study(plan, nullptr, {.so_far = last}));
  EXPECT_EQ(again.quantities, whole.quantities);
  EXPECT_TRUE(again.width_reached);
  for (const int shards : {5, 17, 32, 40, 63}) {
    int left = shards;
    const StudyOptions stops{.after_shard = [&](const StudyPart& part) { return last = part, --left > 0; }};
    ASSERT_TRUE(run_study(plan, nullptr, stops));
    const auto resumed = must(run_study(plan, nullptr, {.so_far = last}), shards);
    EXPECT_EQ(resumed.quantities, whole.quantities) << shards;
    EXPECT_EQ(resumed.shards, 64U);
  }
}

/// A muzzle that stands nearer flies a shorter way to the same plane: as the range would be longer or shorter.
TEST(Study, an_uncertain_muzzle_lies_before_one_plane) {
  Study study = rifle();
  study.until = {.ground = std::nullopt, .range = 600};
  study.inputs = {{.path = "shot.position.x", .distribution = UniformDistribution{-20, 20}, .added = true}};
  study.quantities = {StudyQuantity::y, StudyQuantity::z, StudyQuantity::x, StudyQuantity::time, StudyQuantity::speed};
  const StudyPlan plan = plan_of(study);
  Launch launch = study.launch;
  launch.elevation = zero_elevation(study.projectile, launch, study.environment, study.fidelity, 100).value();
  launch.sight.zero_range = 0;
  const Until farther{.ground = std::nullopt, .range = 700};
  const Flight flight = fly(study.projectile, launch, study.environment, study.fidelity, {}, farther);
  for (std::uint64_t shot = 0; shot < 50; ++shot) {
    const double moved = draws_of(plan, shot)[0];
    const std::vector<double> ends = fly_shot_of(plan, shot);
    const Sample expected = *flight.at_range(600 - moved);
    EXPECT_NEAR(ends[0], expected.position.y, 2e-3) << moved;
    EXPECT_NEAR(ends[2], 600, 1e-9);
    EXPECT_NEAR(ends[3], expected.time, 2e-5);
    EXPECT_NEAR(ends[4], expected.speed, 0.15);
    EXPECT_GT(std::abs(ends[4] - flight.at_range(600)->speed), 0.4 * std::abs(moved)) << "the speed feels the way";
  }
}

TEST(Study, shots_that_go_another_way_do_not_arrive) {
  Study study = rifle();
  const double pi = std::acos(-1.0);
  study.inputs = {input("shot.azimuth", UniformDistribution{-pi, pi})};
  study.targets = {{"plate", RectangleTarget{{0, -0.4}, 200, 3}}};
  const auto result = must(run_study(plan_of(study)));
  const double within = std::asin(100.0 / 300) / pi;  // the plate seen from the muzzle, before it and not behind it
  EXPECT_NEAR(result.hits[0].probability.value, within, 4 * result.hits[0].probability.error + 0.005);
  EXPECT_GT(result.not_arrived, result.shots / 2);
}

/// Parts as an array of jobs flies them, joined in any order.
TEST(Study, is_flown_in_parts) {
  const StudyPlan plan = plan_of(rifle());
  ASSERT_EQ(plan.shards(), 8U);
  StudyPart all;
  const auto pool = make_thread_pool(3);
  for (const auto& [first, count] : std::vector<std::pair<std::uint64_t, std::uint64_t>>{{5, 3}, {0, 2}, {2, 3}}) {
    const auto part = must(run_shards(plan, first, count, pool.get()));
    EXPECT_EQ(part.shards(), count);
    const auto merged = must(merge(all, *load_part(save_part(part))));
    all = merged;
  }
  EXPECT_EQ(save_part(all), bytes_of(plan, nullptr));
  EXPECT_FALSE(run_shards(plan, 5, 4));
  EXPECT_FALSE(run_shards(plan, 9, 0));
  EXPECT_EQ(run_shards(plan, 0, 8, nullptr, {.so_far = all})->shards(), 8U) << "nothing is flown twice";
}

/// The plane of impact is that of the shot without uncertainty; fly() measures against each shot's own line of sight,
/// so the places are compared.
TEST(Study, shots_are_those_of_fly) {
  Study study = rifle();
  study.quantities = {StudyQuantity::z, StudyQuantity::y, StudyQuantity::x, StudyQuantity::time, StudyQuantity::speed};
  const StudyPlan plan = plan_of(study);
  const double zero = zero_elevation(study.projectile, study.launch, study.environment, study.fidelity, 100).value();
  for (const std::uint64_t shot : {0u, 300u, 2047u}) {
    const std::vector<double> drawn = draws_of(plan, shot), ends = fly_shot_of(plan, shot);
    Launch launch = study.launch;
    launch.sight.zero_range = 0;
    launch.speed = drawn[0], launch.elevation = zero + drawn[1], launch.azimuth = drawn[2];
    Environment environment = study.environment;
    environment.wind.velocity.z = drawn[3];
    environment.atmosphere.temperature = drawn[4];
    const Sample end = fly(study.projectile, launch, environment, study.fidelity, {}, study.until).end();
    EXPECT_NEAR(ends[0], end.position.z, 1e-7);
    EXPECT_NEAR(ends[1], end.position.y, 1e-7);
    EXPECT_NEAR(ends[2], 300, 1e-9);
    EXPECT_NEAR(ends[3], end.time, 1e-7);
    EXPECT_NEAR(ends[4], end.speed, 1e-5) << "the planes are 1e-5 m apart";
  }
}

/// Drag has columns of its own; beside a number of the projectile that has none, each shot is a structure.
TEST(Study, uncertain_drag_flies_the_same_as_columns_and_as_structures) {
  Study study = rifle();
  study.inputs = {input("shot.drag.ballistic_coefficient", NormalDistribution{171, 3}),
                  input("shot.speed", NormalDistribution{800, 3})};
  const StudyPlan as_columns = plan_of(study);
  study.inputs.push_back(input("shot.length", UniformDistribution{0.03, 0.031}));  // nothing reads it here
  const StudyPlan as_structures = plan_of(study);
  for (const std::uint64_t shot : {0u, 5u, 1000u}) {
    const std::vector<double> drawn = draws_of(as_columns, shot), ends = fly_shot_of(as_columns, shot);
    EXPECT_EQ(ends, fly_shot_of(as_structures, shot));
    ProjectileDef projectile = study.projectile;
    projectile.drag.ballistic_coefficient = drawn[0];
    Launch launch = as_columns.study().launch;
    launch.speed = drawn[1];
    const Sample end = fly(projectile, launch, study.environment, study.fidelity, {}, study.until).end();
    EXPECT_NEAR(ends[0], end.windage, 1e-9);
    EXPECT_NEAR(ends[1], end.drop, 1e-9);
  }
}

/// Numbers of the projectile make a structure of each shot, a rocket's thrust a table of each.
TEST(Study, numbers_of_the_projectile_are_flown) {
  Study study = rifle();
  study.inputs = {input("shot.drag.ballistic_coefficient", NormalDistribution{171, 3}),
                  input("shot.mass", UniformDistribution{0.011, 0.012}),
                  input("environment.wind.velocity.z", NormalDistribution{0, 1})};
  study.quantities = {StudyQuantity::z, StudyQuantity::y};
  const StudyPlan plan = plan_of(study);
  const std::vector<double> drawn = draws_of(plan, 77), ends = fly_shot_of(plan, 77);
  ProjectileDef projectile = study.projectile;
  projectile.drag.ballistic_coefficient = drawn[0], projectile.mass = drawn[1];
  Environment environment;
  environment.wind.velocity.z = drawn[2];
  const Sample end = fly(projectile, plan.study().launch, environment, study.fidelity, {}, study.until).end();
  EXPECT_NEAR(ends[0], end.position.z, 1e-9);
  EXPECT_NEAR(ends[1], end.position.y, 1e-9);

  Study rocket;
  rocket.projectile.motor = {.thrust = {{0, 50}, {1, 50}}, .propellant_mass = 0.1};
  rocket.fidelity = vacuum();
  rocket.launch = {.speed = 1, .elevation = 1.5};
  rocket.inputs = {input("shot.motor.thrust", NormalDistribution{1, 0.05})};
  rocket.until = {.time = 2};
  rocket.quantities = {StudyQuantity::x, StudyQuantity::y};
  const StudyPlan launched = plan_of(rocket);
  const double factor = draws_of(launched, 3)[0];
  for (ThrustPoint& point : rocket.projectile.motor.thrust) point.force *= factor;
  const Sample high = fly(rocket.projectile, rocket.launch, {}, rocket.fidelity, {}, rocket.until).end();
  EXPECT_NEAR(fly_shot_of(launched, 3)[1], high.position.y, 1e-9);
}

TEST(Study, worst_shots_fly_again_by_their_number) {
  const StudyPlan plan = plan_of(rifle());
  const auto run = run_study(plan);
  ASSERT_EQ(run->worst.size(), 10U);
  double before = kInfinity;
  for (const WorstShot& worst : run->worst) {
    EXPECT_LE(worst.distance, before);
    before = worst.distance;
    EXPECT_EQ(worst.draws, draws_of(plan, worst.shot));
    const std::vector<double> ends = fly_shot_of(plan, worst.shot);
    EXPECT_EQ(std::sqrt(ends[0] * ends[0] + ends[1] * ends[1]), worst.distance);
  }
  double farthest = 0;
  for (std::uint64_t shot = 0; shot < run->shots; shot += 7) {
    const std::vector<double> ends = fly_shot_of(plan, shot);
    farthest = std::max(farthest, std::hypot(ends[0], ends[1]));
  }
  EXPECT_LE(farthest, run->worst[0].distance);
}

/// A flight that is nearly straight in its inputs: slopes say what sampling says.
TEST(Study, linear_propagation_is_near_the_samples) {
  Study study = rifle();
  study.shots = 16384;
  study.sampling = Sampling::sobol;
  study.shard_shots = 1024;
  const StudyPlan plan = plan_of(study);
  const auto run = run_study(plan);
  const auto linear = propagate_linearly(plan);
  ASSERT_TRUE(run && linear);
  for (std::size_t q = 0; q < 4; ++q) {
    EXPECT_TRUE(near(std::sqrt(linear->covariance[q * 5]), run->quantities[q].deviation, 0.01)) << q;
    double shares = 0;
    for (const LinearRow& row : linear->rows) shares += row.share[q];
    EXPECT_NEAR(shares, 1, 1e-9);
  }
  EXPECT_NEAR(linear->rows[2].slope[0], 300, 0.1) << "an azimuth moves the impact by the range";
  EXPECT_GT(linear->rows[3].share[0], 0.5) << "wind moves it aside";
}

TEST(Study, ends_when_a_figure_is_known) {
  Study study = rifle();
  study.shots = 1'000'000;
  study.until_width = StudyWidth{.target = 0, .width = 0.03};
  const StudyPlan plan = plan_of(study);
  const auto run = must(run_study(plan));
  EXPECT_TRUE(run.width_reached);
  EXPECT_LT(run.hits[0].high - run.hits[0].low, 0.03);
  const auto pool = make_thread_pool(3);
  const auto again = run_study(plan, pool.get());
  EXPECT_EQ(again->shots, run.shots);
  EXPECT_EQ(again->quantities, run.quantities);
  study.until_width.reset();
  study.shots = run.shots;
  EXPECT_EQ(run_study(study)->quantities, run.quantities) << "as many shots from the first on";
  study.until_width = StudyWidth{.quantity = 1, .width = 1e-9};
  EXPECT_FALSE(run_study(study)->width_reached) << "there are not so many";
}

}  // namespace physim::study_study_test
