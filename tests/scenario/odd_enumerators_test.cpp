// Numbers that no enumerator has, given to every public function that takes one: refused, and never asserted.
#include <gtest/gtest.h>

#include <cmath>

#include "physim/physim.hpp"
#include "scenario/scenario.hpp"
#include "scenario/world_run.hpp"

namespace physim::scenario_odd_enumerators_test {

template <class Enum>
constexpr Enum odd = static_cast<Enum>(100);

const ProjectileDef kBall{.mass = 0.1, .diameter = 0.04, .drag = {.coefficient = 0.4}};
const Launch kLaunch{.speed = 60, .elevation = 0.4};

/// The error names the place of the number.
template <class T>
void expect_refused(const Result<T>& result, const std::string& place) {
  ASSERT_FALSE(result) << place;
  EXPECT_NE(result.error().text().find(place), std::string::npos) << result.error().text();
  EXPECT_NE(result.error().message.find("none of the named values"), std::string::npos) << result.error().text();
}

Flight flown() { return fly(kBall, kLaunch, {}, Fidelity::simulation()); }

TEST(OddEnumerators, in_a_fidelity) {
  Fidelity f = Fidelity::simulation();
  const auto check = [&](auto Fidelity::*rung, const char* place) {
    Fidelity bad = f;
    bad.*rung = odd<std::remove_reference_t<decltype(bad.*rung)>>;
    ASSERT_TRUE(fly(kBall, kLaunch, {}, bad).error()) << place;
    EXPECT_NE(fly(kBall, kLaunch, {}, bad).error()->text().find(place), std::string::npos);
    EXPECT_FALSE(aim(kBall, kLaunch, {}, bad, {{50, 0, 0}})) << place;
    EXPECT_FALSE(max_range(kBall, kLaunch, {}, bad)) << place;
    EXPECT_FALSE(zero_elevation(kBall, {.speed = 60}, {}, bad, 20)) << place;
    EXPECT_FALSE(time_to_range(kBall, kLaunch, {}, bad, 20)) << place;
    EXPECT_FALSE(pilot_step(kBall, kLaunch, {}, bad, {}, {})) << place;
    EXPECT_FALSE(compare(kBall, kLaunch, {}, {}, {bad, {}})) << place;
    EXPECT_FALSE(fit_drag(kBall, kLaunch, {}, bad, std::vector<Measurement>{{.range = 20, .speed = 50}})) << place;
    EXPECT_FALSE(cheapest_within(kBall, kLaunch, {}, {.error = 1, .time = 1, .truth = bad})) << place;
    World world;
    ProjectileDef ball = kBall;
    ball.fidelity = bad;
    EXPECT_FALSE(world.add_kind(ball)) << place;
    const ProjectileId id = world.spawn(kBall, kLaunch).value();
    EXPECT_FALSE(world[id].set_fidelity(bad)) << place;
    EXPECT_EQ(world.set_fidelity(std::vector{id}, bad), 0U) << place;
    EXPECT_FALSE(world.set_detail({.rungs = {{Fidelity::game(), 10}, {bad, 100}}})) << place;
  };
  check(&Fidelity::motion, "motion");
  check(&Fidelity::integrator, "integrator");
  check(&Fidelity::gravity, "gravity");
  check(&Fidelity::drag, "drag");
  check(&Fidelity::air, "air");
  check(&Fidelity::wind, "wind");
  check(&Fidelity::earth, "earth");
  check(&Fidelity::rotation, "rotation");
  check(&Fidelity::body_form, "body_form");
  check(&Fidelity::precision, "precision");
  check(&Fidelity::interpolation, "interpolation");
}

TEST(OddEnumerators, in_aim_options) {
  expect_refused(aim(kBall, kLaunch, {}, Fidelity::simulation(), {{50, 0, 0}}, {.arc = odd<Arc>}), "options.arc");
}

TEST(OddEnumerators, in_questions_to_a_flight) {
  expect_refused(flown().at_height(1, odd<Crossing>), "direction");
  const Expectation expectation{.at = odd<ExpectAt>, .quantity = "speed"};
  EXPECT_FALSE(measure(flown(), expectation));
}

TEST(OddEnumerators, in_frames_and_tables) {
  const EarthFrames frames({}, odd<EarthModel>);
  EXPECT_EQ(frames.geodetic({1, 2, 3}).height, EarthFrames({}, EarthModel::flat).geodetic({1, 2, 3}).height);
  EXPECT_TRUE(drag_points(odd<DragTable>).empty());
  EXPECT_TRUE(std::isnan(drag_coefficient({.table = odd<DragTable>}, Interpolation::pchip, 1)));
  EXPECT_EQ(name(odd<Outcome>), "?");
}

TEST(OddEnumerators, in_quantities) {
  expect_refused(parse_quantity("1 m", odd<Quantity>), "quantity");
  EXPECT_TRUE(units_of(odd<Quantity>).empty());
}

TEST(OddEnumerators, in_scenes) {
  Scene scene;
  const ShapeId shape = scene.add_shape(SphereShape{1}).value();
  const KeyedMotion motion{.keys = {{0, {}, {}, {}}, {1, {1, 0, 0}, {}, {}}}, .curve = odd<MotionCurve>};
  EXPECT_FALSE(scene.add({.shape = shape, .motion = motion}));
}

TEST(OddEnumerators, in_a_scenario_of_a_program) {
  const char* text =
      "physim = 1\n[world]\nduration = 1\n[[shot]]\nname = \"a\"\nspeed = 10\n[[volley]]\nshot = \"a\"\n";
  Scenario scenario = parse_scenario(text, "f.toml").value();
  ASSERT_TRUE(WorldRun::create(scenario));
  scenario.volleys[0].spread.shape = odd<SpreadShape>;
  EXPECT_FALSE(WorldRun::create(scenario));
  scenario.volleys[0].spread.shape = SpreadShape::normal;
  scenario.volleys[0].shot = "b";
  EXPECT_FALSE(WorldRun::create(scenario)) << "a shot that there is not";
}

}  // namespace physim::scenario_odd_enumerators_test
