// Adaptive integrators in worlds: the parts of a frame end at the corners of what is piecewise, as the steps of flights
// do, so that a world is as accurate as a flight of its tolerance.
#include "world/world_support.hpp"

namespace physim::world_adaptive_frames_test {

using namespace test;

constexpr double kTolerance = 1e-9;
constexpr double kFrame = 1.0 / 8;
constexpr int kFrames = 16;

struct Bent {
  const char* what;
  ProjectileDef projectile;
  Launch launch{.position = {0, 100, 0}, .speed = 420, .elevation = 0.1};
  Environment environment;
  Interpolation interpolation = Interpolation::pchip;
};

std::vector<Bent> bent_cases() {
  std::vector<Bent> all(6);
  for (Bent& each : all) each.projectile = bullet_308();
  all[0].what = "linear drag table";
  all[0].interpolation = Interpolation::linear;
  all[1].what = "edges of wind by range";
  all[1].environment.wind = {.profile = {{0, {0, 0, 12}}, {130, {0, 3, -20}}, {410, {-9, 0, 30}}},
                             .by = WindAxis::range,
                             .interpolation = WindInterpolation::step};
  all[2].what = "points of wind by height";
  all[2].environment.wind = {.profile = {{90, {}}, {104, {0, 0, 40}}, {131, {0, 0, -40}}, {150, {20, 0, 0}}}};
  all[3].what = "bands";
  all[3].projectile.drag.bands = {{0, 120}, {260, 200}, {330, 90}, {400, 240}};
  all[4].what = "layers of the air";
  all[4].launch.position.y = 10900;
  all[4].launch.elevation = 0.8;
  all[5].what = "a force that ends";
  all[5].projectile.force = {0, 0, 2};
  all[5].projectile.force_duration = 1.03;
  return all;
}

State<double> flown(const Bent& b, Integrator integrator, double tolerance) {
  Fidelity f = Fidelity::simulation();
  f.rotation = RotationModel::none;
  f.integrator = integrator;
  f.interpolation = b.interpolation;
  const Sample s = fly(b.projectile, b.launch, b.environment, f, {tolerance, tolerance}, {.ground = {}, .time = 4})
                       .at(kFrames * kFrame);
  return {s.position, s.velocity};
}

State<double> stepped(const Bent& b, Integrator integrator) {
  WorldDef def{
      .environment = b.environment, .ground = {.mode = GroundMode::none}, .tolerance = {kTolerance, kTolerance}};
  World world = make_world(def);
  ProjectileDef p = b.projectile;
  p.fidelity = Fidelity::simulation();
  p.fidelity.rotation = RotationModel::none;
  p.fidelity.integrator = integrator;
  p.fidelity.interpolation = b.interpolation;
  const ProjectileId id = *world.spawn(p, b.launch);
  for (int i = 0; i < kFrames; ++i) world.step(kFrame);
  return {world[id].position(), world[id].velocity()};
}

double off(const State<double>& a, const State<double>& b) { return length(a.x - b.x) + length(a.v - b.v); }

TEST(AdaptiveFrames, are_as_accurate_as_flights_over_corners) {
  for (const Bent& each : bent_cases()) {
    const State<double> truth = flown(each, Integrator::dop853, 1e-13);
    for (const Integrator integrator : kAdaptive) {
      const double flight = off(flown(each, integrator, kTolerance), truth);
      // Control that starts anew in every frame takes other steps than a flight. Over a linear table frames were off
      // by hundreds of times as much while they stepped over its points.
      EXPECT_LT(off(stepped(each, integrator), truth), 5 * flight + 2e-9) << each.what << " " << text(integrator);
    }
  }
}

/// Packs divide frames for many rows at once, a closer look for one: what happens to others changes nothing.
TEST(AdaptiveFrames, are_divided_for_each_row_alone) {
  for (const Bent& each : bent_cases())
    for (const Precision precision : {Precision::float32, Precision::float64}) {
      WorldDef def{.environment = each.environment, .ground = {.mode = GroundMode::none}};
      World together = make_world(def);
      World looked_at = make_world([&] {
        WorldDef with_apexes = def;
        with_apexes.apex_events = true;
        return with_apexes;
      }());
      ProjectileDef p = each.projectile;
      p.fidelity = Fidelity::simulation();
      p.fidelity.rotation = RotationModel::none;
      p.fidelity.interpolation = each.interpolation;
      p.fidelity.precision = precision;
      std::vector<ProjectileId> many, alone;
      for (int i = 0; i < 40; ++i) {
        Launch launch = each.launch;
        launch.speed += 3 * i;
        launch.elevation = 0.02 + 0.001 * i;  // their apexes are looked for one by one
        many.push_back(*together.spawn(p, launch));
        alone.push_back(*looked_at.spawn(p, launch));
      }
      for (int i = 0; i < kFrames; ++i) together.step(kFrame), looked_at.step(kFrame);
      for (std::size_t i = 0; i < many.size(); ++i)
        EXPECT_EQ(together[many[i]].state(), looked_at[alone[i]].state()) << i;
    }
}

}  // namespace physim::world_adaptive_frames_test
