// Studies among the things of a scene: what is hit, and how likely, held to closed forms and to fly().
#include "study_support.hpp"

namespace physim::study_things_test {

using namespace test;

/// A plate of 0.6 m by 1 m at 50 m, and a wide wall at 60 m behind it.
std::shared_ptr<const Scene> range_with_plate(bool sensor = false) {
  Scene scene;
  const ShapeId plate = scene.add_shape(BoxShape{{0.01, 0.5, 0.3}}).value(),
                wall = scene.add_shape(BoxShape{{0.1, 40, 40}}).value();
  EXPECT_TRUE(scene.add({.shape = plate, .transform = {{50.01, 0, 0}}, .sensor = sensor, .name = "plate"}));
  EXPECT_TRUE(scene.add({.shape = wall, .transform = {{60.1, 0, 0}}, .name = "wall"}));
  return std::make_shared<const Scene>(std::move(scene));
}

/// Straight shots whose direction is uncertain.
Study straight() {
  Study study;
  study.environment.gravity.model = GravityModel::constant;
  study.fidelity = vacuum();
  study.fidelity.gravity = GravityModel::off;
  study.fidelity.integrator = Integrator::rk4;
  study.tolerance.step = 0.01;
  study.launch = {.speed = 500};
  study.until = {.ground = std::nullopt, .time = 1};
  study.inputs = {input("shot.azimuth", NormalDistribution{0, 0.006}),
                  input("shot.elevation", NormalDistribution{0, 0.006})};
  study.scene = range_with_plate();
  study.targets = {{"plate", ThingTarget{"plate"}}, {"wall", ThingTarget{"wall"}}};
  study.shard_shots = 512;
  study.shots = 16 * 512;
  return study;
}

/// The plate is seen under known angles; who misses it hits the wall.
TEST(StudyThings, are_hit_as_angles_say) {
  const auto result = must(run_study(plan_of(straight())));
  const auto within = [](double half) { return std::erf(std::atan(half / 50) / 0.006 / std::sqrt(2.0)); };
  const double expected = within(0.3) * within(0.5);
  EXPECT_TRUE(within_4_errors(result.hits[0].probability.value, expected, result.hits[0].probability.error));
  EXPECT_EQ(result.hits[0].hits + result.hits[1].hits, result.shots);
  EXPECT_EQ(result.not_arrived, 0U);
  ASSERT_EQ(result.quantities.size(), 5U) << "right, up, along, time, speed";
  EXPECT_NEAR(result.quantities[2].least, 50, 1e-6);
  EXPECT_NEAR(result.quantities[2].most, 60, 1e-6);
}

/// Shot by shot what fly() says.
TEST(StudyThings, are_those_that_fly_meets) {
  const Study study = straight();
  const StudyPlan plan = plan_of(study);
  const StudyShots shots = fly_shots_of(plan, 1);
  for (std::size_t i = 0; i < 64; ++i) {
    Launch launch = study.launch;
    launch.azimuth = shots.inputs[0][i], launch.elevation = shots.inputs[1][i];
    Until until = study.until;
    until.scene = study.scene.get();
    const Flight flight = fly(study.projectile, launch, study.environment, study.fidelity, study.tolerance, until);
    ASSERT_EQ(flight.outcome(), Outcome::hit);
    const std::string met = study.scene->instance(flight.events().back().instance)->name;
    EXPECT_EQ(shots.hits[0][i], met == "plate") << i;
    EXPECT_EQ(shots.hits[1][i], met == "wall") << i;
    EXPECT_EQ(shots.quantities[3][i], flight.duration()) << i;
  }
}

TEST(StudyThings, have_the_same_bits_with_any_number_of_threads) {
  Study study = straight();
  study.over_inputs = 5;
  const StudyPlan plan = plan_of(study);
  const auto bytes = [&](TaskRunner* runner) { return save_part(*run_shards(plan, 0, plan.shards(), runner)); };
  const std::vector<std::byte> alone = bytes(nullptr);
  for (const unsigned threads : {2u, 7u}) {
    const auto pool = make_thread_pool(threads);
    EXPECT_EQ(bytes(pool.get()), alone) << threads;
  }
  ASSERT_TRUE(load_part(alone));
  const std::vector<HitsOverInput> over = run_study(plan)->over_inputs;
  EXPECT_GT(over[0].parts[2].hits[0].hits, over[0].parts[0].hits[0].hits) << "the plate stands in the middle";
}

/// A sensor is passed; a range behind it is reached by all, one behind the wall by none.
TEST(StudyThings, that_are_passed_or_in_the_way_of_the_plane) {
  Study study = straight();
  study.scene = range_with_plate(true);
  study.until.range = 55;
  const auto passed = must(run_study(plan_of(study)));
  EXPECT_EQ(passed.not_arrived, 0U);
  EXPECT_GT(passed.hits[0].hits, passed.shots / 2);
  EXPECT_EQ(passed.hits[1].hits, 0U);
  study.until.range = 65;
  const auto stopped = plan_study(study);
  ASSERT_FALSE(stopped);
  EXPECT_NE(stopped.error().text().find("things"), std::string::npos) << stopped.error().text();
}

TEST(StudyThings, another_scene_is_another_study) {
  Study study = straight();
  const StudyPlan one = plan_of(study);
  Scene other = *study.scene;
  ASSERT_TRUE(other.add({.shape = other.add_shape(SphereShape{1}).value(), .transform = {{0, 30, 0}}}));
  study.scene = std::make_shared<const Scene>(std::move(other));
  const StudyPlan two = plan_of(study);
  EXPECT_FALSE(merge(run_shard(one, 0), run_shard(two, 1)));
  study.scene = range_with_plate();
  EXPECT_TRUE(merge(run_shard(one, 0), run_shard(plan_of(study), 1))) << "as another run of the program makes it";
}

TEST(StudyThings, bad_input) {
  const auto refusal = [](const auto& change) { return refusal_of(straight(), change); };
  const auto has = [](const std::string& text, const char* part) { return text.find(part) != std::string::npos; };
  EXPECT_EQ(refusal([](Study&) {}), "");
  const std::string unknown = refusal([](Study& s) { s.targets[0].shape = ThingTarget{"plat"}; });
  EXPECT_TRUE(has(unknown, "targets[0].thing") && has(unknown, "plate, wall")) << unknown;
  EXPECT_TRUE(has(refusal([](Study& s) { s.scene.reset(); }), "no scene"));
  const Scene lent;
  EXPECT_TRUE(has(refusal([&](Study& s) { s.until.scene = &lent; }), "study.scene"));
  EXPECT_TRUE(has(refusal([](Study& s) { s.until.contact.restitution = -1; }), "restitution"));
  EXPECT_TRUE(has(refusal([](Study& s) {
                    Scene scene = *s.scene;
                    EXPECT_TRUE(scene.set_engine({.query = [](const EngineBatch&) {}}));
                    s.scene = std::make_shared<const Scene>(std::move(scene));
                  }),
                  "engine"));
  Study function = straight();
  function.quantities = {StudyQuantity::right, StudyQuantity::up};
  const auto plan = plan_study(function, scattered);
  ASSERT_FALSE(plan);
  EXPECT_TRUE(has(plan.error().text(), "function")) << plan.error().text();
}

}  // namespace physim::study_things_test
