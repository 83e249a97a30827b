// Rules of combination and conveyors in scenario files: read, flown, refused, and what has no effect.
#include "scenario/run_support.hpp"
#include "scenario/slope_scene.hpp"
#include "support.hpp"

namespace physim::scenario_surface_test {

constexpr double kG = 9.80665;

const std::string kBelt = R"([[material]]
name = "rubber"
restitution = 0
friction = 0.2
combine = { friction = "minimum", restitution = "maximum" }
[[shape]]
name = "slab"
box = ["60 m", "0.5 m", "5 m"]
[[thing]]
name = "belt"
shape = "slab"
material = "rubber"
position = [0, "-0.5 m", 0]
conveyor = ["2 m/s", 0, 0]
[[shot]]
name = "parcel"
speed = 0
fidelity = { preset = "game", integrator = "rk4", precision = "float64", drag = "off" }
body.restitution = 0
body.friction = 0.7
body.rolling_resistance = 0
body.combine.friction = "mean"
body.collision.on_hit = "bounce"
)";
const std::string kWorld = "[world]\nduration = \"2 s\"\nground = { mode = \"none\" }\n";
const std::string kRunningGround =
    "[world]\nduration = \"2 s\"\nground = { mode = \"bounce\", friction = 0.2, conveyor = [\"2 m/s\", 0, 0], "
    "combine = { friction = \"minimum\" } }\n";
const std::string kParcel = R"([[shot]]
name = "parcel"
speed = 0
fidelity = { preset = "game", integrator = "rk4", precision = "float64", drag = "off" }
body = { restitution = 0, friction = 0.7, rolling_resistance = 0 }
)";

TEST(SurfaceScenario, is_read_as_it_is_written) {
  const Scenario belt = parsed(kVacuum + kBelt + kWorld);
  EXPECT_EQ(belt.materials[0].combine, (CombineDef{Combine::maximum, Combine::minimum}));
  EXPECT_EQ(belt.shots[0].body.combine, (CombineDef{Combine::product, Combine::mean}));
  EXPECT_EQ(belt.things[0].conveyor.velocity, (Vec3d{2, 0, 0}));
  const Ground ground = parsed(kVacuum + kParcel + kRunningGround).world.def.ground;
  EXPECT_EQ(ground.conveyor.velocity, (Vec3d{2, 0, 0}));
  EXPECT_EQ(ground.combine.friction, Combine::minimum);
}

/// The smaller friction takes the parcel along: u t - u^2 / (2 mu g).
TEST(SurfaceScenario, carries_what_lies_on_it) {
  for (const std::string& text : {kBelt + kWorld, kParcel + kRunningGround}) {
    WorldRun run = must(WorldRun::create(parsed(kVacuum + text)));
    const World& world = run.world();
    while (world.time() < 1.99) run.step();
    ASSERT_EQ(world.size(), 1u);
    const ProjectileId id = world.ids().front();
    EXPECT_NEAR(world[id].velocity().x, 2, 1e-9);
    EXPECT_NEAR(world[id].position().x, 2 * world.time() - 4 / (2 * 0.2 * kG), 1e-6);
  }
}

TEST(SurfaceScenario, refuses_what_makes_no_sense_with_its_place) {
  const auto error_of = [](const std::string& text) {
    const Result<Scenario> scenario = parse_scenario("physim = 1\n[[shot]]\n[world]\n" + text, "f.toml");
    return scenario ? "no error" : scenario.error().text();
  };
  EXPECT_EQ(error_of("[[material]]\ncombine = { friction = \"means\" }"),
            "f.toml:5:24: error: material.combine.friction: unknown value \"means\"; did you mean \"mean\"?");
  EXPECT_EQ(error_of("ground = { conveyor = [\"3e6 m/s\", 0, 0] }").substr(0, 50),
            "f.toml:4:24: error: world.ground.conveyor.velocity");
}

TEST(SurfaceScenario, names_what_has_no_effect) {
  const auto notes = [](std::string text, const std::string& from, const std::string& to) {
    const std::size_t at = text.find(from);
    EXPECT_NE(at, text.npos);
    text.replace(at, from.size(), to);
    std::string all;
    for (const std::string& note : parsed(kVacuum + text).notes) all += note + "\n";
    return all;
  };
  const std::string none = notes(kBelt + kWorld, "", "");
  EXPECT_EQ(none.find("has no effect"), none.npos) << none;
  const std::string stops = notes(kBelt + kWorld, "\"bounce\"", "\"stop\"");
  EXPECT_NE(stops.find("material.combine: has no effect"), stops.npos) << stops;
  EXPECT_NE(stops.find("thing.conveyor: has no effect"), stops.npos) << stops;
  const std::string lands = notes(kParcel + kRunningGround, "\"bounce\"", "\"land\"");
  EXPECT_NE(lands.find("world.ground.conveyor: has no effect"), lands.npos) << lands;
}

}  // namespace physim::scenario_surface_test
