// Speed, obliquity and energy of impacts, held to closed forms: parabolas on the ground, Kepler's ellipses on a sphere,
// straight shots on planes and balls, things in motion.
#include "study_support.hpp"

namespace physim::study_impacts_test {

using namespace test;

constexpr double kG = 9.80665;

const std::vector<StudyQuantity> kImpact = {StudyQuantity::impact_speed, StudyQuantity::obliquity,
                                            StudyQuantity::impact_energy};

/// A throw from 3 m above the ground, in a vacuum.
Study throw_down() {
  Study study;
  study.environment.gravity = {.model = GravityModel::constant, .acceleration = kG};
  study.fidelity = vacuum();
  study.projectile.mass = 0.5;
  study.launch = {.position = {0, 3, 0}, .speed = 30, .elevation = 0.5};
  study.inputs = {input("shot.speed", NormalDistribution{30, 2}), input("shot.elevation", UniformDistribution{-0.5, 1}),
                  input("shot.azimuth", UniformDistribution{-1, 1})};
  study.quantities = kImpact;
  study.shard_shots = 64;
  study.shots = 256;
  return study;
}

/// Speed and obliquity of a parabola that ends h below its start.
void expect_parabola(const std::vector<double>& impact, double speed, double elevation, double h, double mass) {
  const double across = speed * std::cos(elevation), up = speed * std::sin(elevation),
               down = std::sqrt(up * up + 2 * kG * h);
  EXPECT_TRUE(near(impact[0], std::hypot(across, down), 1e-9));
  EXPECT_TRUE(near(impact[1], std::atan2(across, down), 1e-9));
  EXPECT_TRUE(near(impact[2], 0.5 * mass * (across * across + down * down), 1e-9));
}

TEST(StudyImpacts, on_the_ground_end_parabolas) {
  const Study study = throw_down();
  const StudyPlan plan = plan_of(study);
  for (std::uint64_t shot = 0; shot < study.shots; ++shot) {
    const std::vector<double> drawn = draws_of(plan, shot);
    expect_parabola(fly_shot_of(plan, shot), drawn[0], drawn[1], 3, 0.5);
  }
  const auto result = must(run_study(plan));
  EXPECT_EQ(result.not_arrived, 0U);
  EXPECT_EQ(result.quantities[1].quantity, StudyQuantity::obliquity);
  EXPECT_GT(result.quantities[1].deviation, 0.05);
}

TEST(StudyImpacts, have_the_mass_that_was_drawn) {
  Study study = throw_down();
  study.inputs.push_back(input("shot.mass", UniformDistribution{0.3, 0.8}));
  study.environment.wind.profile = {};
  const StudyPlan plan = plan_of(study);
  for (std::uint64_t shot = 0; shot < study.shots; ++shot) {
    const std::vector<double> drawn = draws_of(plan, shot);
    expect_parabola(fly_shot_of(plan, shot), drawn[0], drawn[1], 3, drawn[3]);
  }
}

/// Over a sphere that does not turn a path without air lies symmetrically about its apex.
TEST(StudyImpacts, on_a_round_Earth_are_measured_from_its_vertical) {
  Study study = throw_down();
  study.environment.gravity = {};
  study.fidelity.gravity = GravityModel::inverse_square;
  study.fidelity.earth = EarthModel::sphere;
  study.launch = {.speed = 4000, .elevation = 0.7};
  study.inputs = {input("shot.speed", UniformDistribution{3000, 5000}),
                  input("shot.elevation", UniformDistribution{0.3, 1.2}),
                  input("shot.azimuth", UniformDistribution{-1, 1})};
  const StudyPlan plan = plan_of(study);
  for (std::uint64_t shot = 0; shot < 64; ++shot) {
    const std::vector<double> drawn = draws_of(plan, shot), impact = fly_shot_of(plan, shot);
    EXPECT_TRUE(near(impact[0], drawn[0], 1e-7)) << shot;
    EXPECT_NEAR(impact[1], std::acos(0.0) - drawn[1], 1e-7) << shot;
  }
}

/// As fly() says, where the mass falls over the flight: landed behind the burn, and within it.
TEST(StudyImpacts, have_the_mass_that_is_left) {
  Study study = throw_down();
  study.projectile.motor = {.thrust = {{0, 8}, {0.4, 2}, {1, 3}}, .propellant_mass = 0.2, .ignition_delay = 0.1};
  for (const bool own_motor : {false, true})
    for (const double elevation : {1.2, -0.5}) {
      SCOPED_TRACE(elevation);
      study.inputs = {input("shot.speed", UniformDistribution{5, 6}),
                      input("shot.elevation", UniformDistribution{elevation, elevation + 0.1})};
      if (own_motor) study.inputs.push_back(input("shot.motor.propellant_mass", UniformDistribution{0.1, 0.3}));
      const StudyPlan plan = plan_of(study);
      for (std::uint64_t shot = 0; shot < 32; ++shot) {
        const std::vector<double> drawn = draws_of(plan, shot), impact = fly_shot_of(plan, shot);
        Shot own{study.projectile, study.launch};
        own.launch.speed = drawn[0], own.launch.elevation = drawn[1];
        if (own_motor) own.projectile.motor.propellant_mass = drawn[2];
        const Sample end =
            fly(own.projectile, own.launch, study.environment, study.fidelity, plan.study().tolerance).end();
        EXPECT_EQ(end.time < 1.1, elevation < 0);
        EXPECT_LT(end.mass, own.projectile.mass);
        EXPECT_TRUE(near(impact[0], end.speed, 1e-12));
        EXPECT_TRUE(near(impact[2], end.energy, 1e-12));
      }
    }
}

/// Straight shots among things.
Study straight(Scene scene) {
  Study study;
  study.environment.gravity.model = GravityModel::constant;
  study.fidelity = vacuum();
  study.fidelity.gravity = GravityModel::off;
  study.fidelity.integrator = Integrator::rk4;
  study.tolerance.step = 0.01;
  study.projectile.mass = 0.01;
  study.launch = {.speed = 500};
  study.until = {.ground = std::nullopt, .time = 1};
  study.inputs = {input("shot.azimuth", UniformDistribution{-0.3, 0.3})};
  study.quantities = kImpact;
  study.scene = std::make_shared<const Scene>(std::move(scene));
  study.shard_shots = 64;
  study.shots = 64;
  return study;
}

TEST(StudyImpacts, on_a_plane_of_known_normal) {
  Scene scene;
  const double turned = 0.4;  // about the vertical, the normal from (-1, 0, 0)
  const Quatd rotation{std::cos(turned / 2), 0, std::sin(turned / 2), 0};
  ASSERT_TRUE(scene.add({.shape = scene.add_shape(BoxShape{{0.1, 20, 60}}).value(),
                         .transform = {.position = {30, 0, 0}, .rotation = rotation}}));
  const StudyPlan plan = plan_of(straight(std::move(scene)));
  bool to_either_side[2] = {};
  for (std::uint64_t shot = 0; shot < 64; ++shot) {
    const double azimuth = draws_of(plan, shot)[0];
    const std::vector<double> impact = fly_shot_of(plan, shot);
    const Vec3d way{std::cos(azimuth), 0, std::sin(azimuth)}, inwards = rotate(rotation, Vec3d{1, 0, 0});
    EXPECT_TRUE(near(impact[0], 500, 1e-12));
    EXPECT_TRUE(near(impact[1], std::acos(dot(way, inwards)), 1e-7)) << azimuth;
    EXPECT_TRUE(near(impact[2], 0.005 * 250000, 1e-12));
    to_either_side[azimuth > 0] = true;
  }
  EXPECT_TRUE(to_either_side[0] && to_either_side[1]);
}

TEST(StudyImpacts, on_a_ball_are_as_far_off_as_its_middle) {
  constexpr double kRadius = 2;
  Scene scene;
  ASSERT_TRUE(scene.add({.shape = scene.add_shape(SphereShape{kRadius}).value(), .transform = {{30, 0, 0}}}));
  Study study = straight(std::move(scene));
  study.inputs = {input("shot.position.z", UniformDistribution{-1.9, 1.9})};
  const StudyPlan plan = plan_of(study);
  for (std::uint64_t shot = 0; shot < 64; ++shot)
    EXPECT_NEAR(fly_shot_of(plan, shot)[1], std::asin(std::abs(draws_of(plan, shot)[0]) / kRadius), 1e-6);
}

/// What comes to meet a shot is struck faster. It stands still before scene time 100 s.
TEST(StudyImpacts, on_a_thing_in_motion_are_as_it_sees_them) {
  Scene scene;
  KeyedMotion motion{{{.time = 100, .position = {30, 0, 0}}, {.time = 101, .position = {-20, 0, 50}}}};
  ASSERT_TRUE(scene.add({.shape = scene.add_shape(BoxShape{{0.1, 80, 80}}).value(), .motion = motion}));
  Study study = straight(std::move(scene));
  for (const double since : {0.0, 100.0}) {
    study.until.contact.scene_time = since;
    const StudyPlan plan = plan_of(study);
    for (std::uint64_t shot = 0; shot < 16; ++shot) {
      const double azimuth = draws_of(plan, shot)[0];
      const Vec3d of_thing = since > 0 ? Vec3d{-50, 0, 50} : Vec3d{};
      const Vec3d seen = Vec3d{500 * std::cos(azimuth), 0, 500 * std::sin(azimuth)} - of_thing;
      const std::vector<double> impact = fly_shot_of(plan, shot);
      EXPECT_TRUE(near(impact[0], length(seen), 1e-9)) << since;
      EXPECT_TRUE(near(impact[1], std::atan2(std::abs(seen.z), seen.x), 1e-7)) << since;
      EXPECT_TRUE(near(impact[2], 0.005 * length_squared(seen), 1e-9)) << since;
    }
  }
}

/// Off a wall onto the ground: the wall counts. Past it: the ground. Into the air: nothing, and it does not arrive.
TEST(StudyImpacts, are_the_first) {
  Scene scene;
  ASSERT_TRUE(scene.add({.shape = scene.add_shape(BoxShape{{0.1, 20, 20}}).value(), .transform = {{20, 0, 20}}}));
  Study study = straight(std::move(scene));
  study.environment.gravity = {.model = GravityModel::constant, .acceleration = kG};
  study.fidelity.gravity = GravityModel::constant;
  study.launch = {.position = {0, 10, 0}, .speed = 40};
  study.until = {.time = 2};
  study.until.contact.collision.on_hit = OnHit::bounce;
  study.until.contact.restitution = 0.5;
  const StudyPlan plan = plan_of(study);
  const double to_wall = 19.9 / 40;
  int walls = 0;
  for (std::uint64_t shot = 0; shot < 64; ++shot) {
    const double azimuth = draws_of(plan, shot)[0];
    const std::vector<double> impact = fly_shot_of(plan, shot);
    if (azimuth < 0) {
      expect_parabola(impact, 40, 0, 10, 0.01);
      continue;
    }
    const double down = kG * to_wall / std::cos(azimuth);
    EXPECT_TRUE(near(impact[0], std::hypot(40, down), 1e-6));
    EXPECT_NEAR(impact[1], std::acos(40 * std::cos(azimuth) / std::hypot(40, down)), 1e-6);
    ++walls;
  }
  EXPECT_GT(walls, 10);
  study.until.time = 1;  // the ground is 1.43 s away
  const auto result = must(run_study(plan_of(study)));
  EXPECT_GT(result.not_arrived, 10U);
  EXPECT_LT(result.not_arrived, 54U);
  EXPECT_TRUE(near(result.quantities[2].most, result.quantities[2].least, 0.1)) << "of those that hit the wall";
}

TEST(StudyImpacts, same_bits_with_threads_and_saved) {
  const StudyPlan plan = plan_of(throw_down());
  const auto pool = make_thread_pool(3);
  const std::vector<std::byte> alone = save_part(*run_shards(plan, 0, plan.shards()));
  EXPECT_EQ(save_part(*run_shards(plan, 0, plan.shards(), pool.get())), alone);
  ASSERT_TRUE(load_part(alone));
}

TEST(StudyImpacts, are_refused_where_there_can_be_none) {
  const auto refusal = [](const auto& change) { return refusal_of(throw_down(), change); };
  const auto has = [](const std::string& text, const char* part) { return text.find(part) != std::string::npos; };
  EXPECT_EQ(refusal([](Study&) {}), "");
  const std::string at_range = refusal([](Study& s) { s.until.range = 20; });
  EXPECT_TRUE(has(at_range, "quantities[0]") && has(at_range, "until.range")) << at_range;
  const std::string nowhere = refusal([](Study& s) { s.until.ground.reset(); });
  EXPECT_TRUE(has(nowhere, "neither ground nor things") && has(nowhere, "until.ground")) << nowhere;
  const std::string short_of_time = refusal([](Study& s) { s.until.time = 0.01; });
  EXPECT_TRUE(has(short_of_time, "0 arrived") && has(short_of_time, "no impact")) << short_of_time;
}

}  // namespace physim::study_impacts_test
