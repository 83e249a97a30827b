// A preset has its own gravity and its own damping at every door: single flights, batches, worlds, scenarios and
// comparisons fly one path.
#include "scenario/scenario.hpp"
#include "world/world_support.hpp"

namespace physim::world_preset_doors_test {

constexpr double kStep = 1.0 / 60, kTime = 0.5;
constexpr double kStandardGravity = 9.80665;

struct OwnGravity {
  const char* name;
  double gravity;  // [m/s^2]
};
constexpr OwnGravity kOriginals[] = {{"artillery", 20}, {"bullet", 2}, {"laser", 0}};

Launch launch_of(const ProjectilePreset& preset) {
  return {.position = {0, 1.5, 0}, .speed = preset.speed, .elevation = 0.1};
}

/// Where it is after kTime.
Vec3d by_flight(const ProjectileDef& p, const Launch& launch, const Fidelity& fidelity) {
  const Flight flight = fly(p, launch, {}, fidelity, {.step = kStep}, {.ground = std::nullopt, .time = kTime});
  EXPECT_FALSE(flight.error());
  return flight.end().position;
}
Vec3d by_batch(const ProjectileDef& p, const Launch& launch, const Fidelity& fidelity) {
  // A plain shot in front of it, so that one pack holds gravity of two kinds.
  const Shot shots[] = {{ProjectileDef{}, launch}, {p, launch}, {ProjectileDef{}, launch}};
  const BatchResult batch = fly_batch(shots, {}, fidelity, {.step = kStep}, {.ground = std::nullopt, .time = kTime});
  EXPECT_FALSE(batch.error);
  EXPECT_TRUE(test::near(batch.shots[0].position, by_flight(ProjectileDef{}, launch, fidelity), 0, 0));
  return batch.shots[1].position;
}
Vec3d by_columns(const ProjectileDef& p, const Launch& launch, const Fidelity& fidelity) {
  const std::vector<Launch> launches(9, launch);
  const Until until{.ground = std::nullopt, .time = kTime};
  return fly_batch(p, launches, {}, fidelity, {.step = kStep}, until).shots[8].position;
}
Vec3d by_world(const ProjectileDef& p, const Launch& launch, const Fidelity& fidelity, const BodyDef& body = {}) {
  World world = make_world({.ground = {.mode = GroundMode::none}});
  ProjectileDef flown = p;
  flown.fidelity = fidelity;
  const ProjectileId id = *world.spawn(flown, launch, body);
  for (int i = 0; i < 30; ++i) world.step(kStep);
  return world[id].position();
}

TEST(PresetDoors, flights_batches_and_worlds_fly_one_path) {
  Fidelity vacuum = Fidelity::simulation();
  vacuum.drag = DragModel::off;
  Fidelity damped = Fidelity::constant_air();
  damped.drag = DragModel::damping;
  damped.wind = WindModel::off;
  for (const std::string_view name : projectile_presets()) {
    const ProjectilePreset preset = *projectile_preset(name);
    const Launch launch = launch_of(preset);
    for (Fidelity f : {Fidelity::classic(), Fidelity::arcade(), Fidelity::game(), Fidelity::simulation(),
                       Fidelity::reference(), vacuum, damped}) {
      f.rotation = RotationModel::none;  // spin drift is added to whole flights alone
      f.aerodynamic_jump = false;
      SCOPED_TRACE(std::string(name) + " " + std::string(physim::name(f.motion)) + " " +
                   std::string(physim::name(f.integrator)));
      const Vec3d flown = by_flight(preset.projectile, launch, f);
      EXPECT_TRUE(test::near(by_batch(preset.projectile, launch, f), flown, 0, 0));
      EXPECT_TRUE(test::near(by_columns(preset.projectile, launch, f), flown, 0, 0));
      EXPECT_TRUE(test::near(by_world(preset.projectile, launch, f), flown, 2e-6, 1e-6));
    }
  }
}

TEST(PresetDoors, the_originals_fall_as_much_as_they_say) {
  Fidelity vacuum = Fidelity::reference();
  vacuum.drag = DragModel::off;
  vacuum.gravity = GravityModel::constant, vacuum.earth = EarthModel::flat;
  for (const OwnGravity& original : kOriginals) {
    const ProjectilePreset preset = *projectile_preset(original.name);
    const Launch launch = launch_of(preset);
    const double free = 1.5 + preset.speed * std::sin(0.1) * kTime;
    for (const auto& door : {by_flight, by_batch, by_columns})
      EXPECT_NEAR(free - door(preset.projectile, launch, vacuum).y, original.gravity * kTime * kTime / 2, 1e-9)
          << original.name;
    EXPECT_NEAR(free - by_world(preset.projectile, launch, vacuum).y, original.gravity * kTime * kTime / 2, 1e-9);
  }
}

/// Damping d with gravity g: y = y0 + (v0 + g/k) (1 - e^-kt) / k - g t / k, k = -ln d.
TEST(PresetDoors, their_damping_acts_with_their_gravity) {
  Fidelity damped = Fidelity::reference();
  damped.drag = DragModel::damping;
  damped.gravity = GravityModel::constant, damped.earth = EarthModel::flat;
  for (const OwnGravity& original : {kOriginals[0], kOriginals[1]}) {
    const ProjectilePreset preset = *projectile_preset(original.name);
    const double k = -std::log(0.9), v = preset.speed * std::sin(0.1), g = original.gravity;
    const double y = 1.5 + (v + g / k) * (1 - std::exp(-k * kTime)) / k - g * kTime / k;
    EXPECT_NEAR(by_flight(preset.projectile, launch_of(preset), damped).y, y, 1e-8) << original.name;
    EXPECT_NEAR(by_world(preset.projectile, launch_of(preset), damped).y, y, 1e-8) << original.name;
  }
}

TEST(PresetDoors, scenarios_and_comparisons_fly_the_same) {
  for (const OwnGravity& original : kOriginals) {
    const std::string text =
        "physim = 1\n[tolerance]\nstep = \"0.01 s\"\n[until]\nground = \"off\"\ntime = \"0.5 s\"\n"
        "[[shot]]\npreset = \"" +
        std::string(original.name) + "\"\nposition = [\"0 m\", \"1.5 m\", \"0 m\"]\nelevation = 0.1\n";
    for (const char* rung : {"classic", "simulation"}) {
      const Result<Scenario> scenario =
          parse_scenario(text, "f.toml", std::vector<std::string>{"shot.fidelity=" + std::string(rung)});
      ASSERT_TRUE(scenario.ok()) << scenario.error().text();
      const ScenarioShot& shot = scenario->shots[0];
      const Flight flight = fly_shot(*scenario, shot);
      const ProjectilePreset preset = *projectile_preset(original.name);
      const Flight plain = fly(preset.projectile, launch_of(preset), {}, shot.projectile.fidelity, scenario->tolerance,
                               {.ground = std::nullopt, .time = kTime});
      EXPECT_EQ(flight.end().position, plain.end().position) << original.name << rung;
      const FlightSetting setting{shot.projectile.fidelity, scenario->tolerance};
      const Result<Comparison> compared =
          compare(shot.projectile, shot.launch, scenario->environment, {&setting, 1}, setting, scenario->until);
      ASSERT_TRUE(compared.ok());
      EXPECT_EQ(compared->flights[0].flight.end().position, plain.end().position) << original.name << rung;
    }
  }
}

/// Every shot of a study falls as much: the speed is all but certain, and the mean height is that of one flight.
TEST(PresetDoors, studies_fly_the_same) {
  for (const OwnGravity& original : kOriginals) {
    const ProjectilePreset preset = *projectile_preset(original.name);
    for (const Fidelity& f : {Fidelity::classic(), Fidelity::reference()}) {
      Study study{
          .projectile = preset.projectile, .launch = launch_of(preset), .fidelity = f, .tolerance = {.step = kStep}};
      study.fidelity.rotation = RotationModel::none, study.fidelity.aerodynamic_jump = false;
      study.until = {.ground = std::nullopt, .time = kTime};
      study.inputs = {{.path = "shot.speed", .distribution = NormalDistribution{preset.speed, 1e-9}}};
      study.quantities = {StudyQuantity::y};
      study.shots = study.shard_shots = 64;
      const auto run = run_study(study);
      ASSERT_TRUE(run.ok()) << run.error().text();
      EXPECT_NEAR(run->quantities[0].mean.value, by_flight(preset.projectile, study.launch, study.fidelity).y, 1e-5)
          << original.name;
    }
  }
}

TEST(PresetDoors, what_a_body_says_of_gravity_multiplies_and_single_flights_of_a_scenario_take_it) {
  const ProjectilePreset bullet = presets::bullet();
  Fidelity vacuum = Fidelity::reference();
  vacuum.drag = DragModel::off;
  vacuum.gravity = GravityModel::constant, vacuum.earth = EarthModel::flat;
  const Launch launch = launch_of(bullet);
  const double free = 1.5 + bullet.speed * std::sin(0.1) * kTime;
  for (const BodyDef& body : {BodyDef{.gravity_scale = 3}, BodyDef{.use_gravity = false}}) {
    const double wanted = (body.use_gravity ? 3 : 0) * 2 * kTime * kTime / 2;
    EXPECT_NEAR(free - by_world(bullet.projectile, launch, vacuum, body).y, wanted, 1e-9);
    const ProjectileDef alone = projectile_of({.projectile = bullet.projectile, .launch = {}, .body = body});
    EXPECT_NEAR(free - by_flight(alone, launch, vacuum).y, wanted, 1e-9);
  }
}

TEST(PresetDoors, drag_that_a_body_scales_is_that_of_single_flights) {
  const ProjectilePreset ball = presets::baseball();
  const Launch launch = launch_of(ball);
  for (const double scale : {0.0, 0.5, 3.0}) {
    const ProjectileDef alone =
        projectile_of({.projectile = ball.projectile, .launch = {}, .body = {.drag_scale = scale}});
    const Fidelity f = Fidelity::reference();
    EXPECT_TRUE(
        test::near(by_flight(alone, launch, f), by_world(ball.projectile, launch, f, {.drag_scale = scale}), 1e-8))
        << scale;
  }
}

TEST(PresetDoors, gravity_that_is_no_number_is_refused_at_every_door) {
  ProjectileDef p{.gravity_scale = NAN};
  const Flight flight = fly(p, {.speed = 9});
  ASSERT_TRUE(flight.error());
  EXPECT_EQ(flight.error()->place, "projectile.gravity_scale");
  World world;
  EXPECT_FALSE(world.spawn(p, {.speed = 9}).ok());
}

/// The gravity of a live setting goes on top, and comes back.
TEST(PresetDoors, live_gravity_multiplies_that_of_the_projectile) {
  Fidelity vacuum = Fidelity::reference();
  vacuum.drag = DragModel::off;
  vacuum.gravity = GravityModel::constant, vacuum.earth = EarthModel::flat;
  for (const Motion motion : {Motion::force, Motion::closed_form}) {
    vacuum.motion = motion;
    ProjectileDef p{.gravity_scale = 2, .fidelity = vacuum};
    World world = make_world({.ground = {.mode = GroundMode::none}});
    const ProjectileId id = *world.spawn(p, {.speed = 5});
    EXPECT_NEAR(world[id].accelerations().gravity.y, -2 * kStandardGravity, 1e-9);
    ASSERT_TRUE(world[id].set_gravity_scale(0.5));
    world.step(kStep);
    EXPECT_NEAR(world[id].accelerations().gravity.y, -kStandardGravity, 1e-9);
    ASSERT_TRUE(world[id].set_use_gravity(false));
    const Vec3d v = world[id].velocity();
    world.step(kStep);
    EXPECT_NEAR(world[id].velocity().y, v.y, 1e-12);
    ASSERT_TRUE(world[id].set_gravity_scale(1));
    EXPECT_NEAR(world[id].accelerations().gravity.y, -2 * kStandardGravity, 1e-9);
  }
}

}  // namespace physim::world_preset_doors_test
