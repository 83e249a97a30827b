// Flights of scenarios through things: what they hit is told, counted and judged, read and written, and refused.
#include "scenario/run_support.hpp"
#include "scenario/slope_scene.hpp"
#include "support.hpp"

namespace physim::scenario_flight_hits_test {

constexpr double kG = 9.80665, kPi = 3.14159265358979323846;

/// A ball that bounces down a slope, with a step of its own, so that a world flies the same.
const std::string kSlope = "[tolerance]\nstep = \"10 ms\"\n" + ball_over_slope("-30 deg");
const std::string kNoGround = "[until]\nground = \"off\"\ntime = \"3 s\"\n";

struct Flown {
  SceneParts parts;
  Flight flight;
  FlightHits hits;
};
Flown flown(const Scenario& scenario, std::size_t shot = 0) {
  SceneParts parts = scene_parts(scenario).value();
  Flight flight = fly_shot(scenario, scenario.shots.at(shot), parts.scene);
  FlightHits hits = flight_hits(scenario, scenario.shots[shot], flight, parts);
  return {std::move(parts), std::move(flight), std::move(hits)};
}

std::vector<std::string> beginnings_of(const std::string& text) {
  const Scenario scenario = parsed(kVacuum + text);
  const SceneParts parts = scene_parts(scenario).value();
  return notes_of_beginnings(scenario, parts.scene, parts.things);
}

TEST(FlightHits, SayWhichShotsBeginInsideOfThings) {
  const std::string box = "[[shape]]\nname = \"s\"\nbox = [5, 5, 5]\n[[thing]]\nname = \"t\"\nshape = \"s\"\n";
  const auto shot_at = [](const std::string& place, const std::string& more = "") {
    return "[[shot]]\nname = \"b\"\nspeed = 300\nposition = " + place + "\n" + more;
  };
  const std::vector<std::string> inside = {"shot \"b\" begins inside of the thing \"t\""};
  EXPECT_EQ(beginnings_of(box + shot_at("[0, 1, 0]")), inside);
  EXPECT_EQ(beginnings_of(box + shot_at("[0, 1, 0]") + "[world]\n"), inside);
  EXPECT_TRUE(beginnings_of(box + shot_at("[0, 6, 0]")).empty());
  EXPECT_TRUE(beginnings_of(box + shot_at("[0, 5, 0]")).empty()) << "on its face";
  EXPECT_TRUE(beginnings_of(box + "sensor = true\n" + shot_at("[0, 1, 0]")).empty());
  EXPECT_TRUE(beginnings_of(box + shot_at("[0, 1, 0]", "body.collision.on_hit = \"pass\"\n")).empty());
  // It stands where the thing will be when its volley fires.
  const std::string moving = box + "velocity = [-10, 0, 0]\nposition = [20, 0, 0]\n" + shot_at("[0, 1, 0]");
  const std::string volley = "[world]\n[[volley]]\nshot = \"b\"\nstart = ";
  EXPECT_TRUE(beginnings_of(moving + volley + "1\n").empty());
  EXPECT_EQ(beginnings_of(moving + volley + "2\n"), inside);
}

TEST(FlightHits, TellABounceByItsClosedForm) {
  const Flown ball = flown(parsed(kVacuum + kSlope + kNoGround));
  ASSERT_GE(ball.hits.all.size(), 2u);
  const ThingHit& hit = ball.hits.all[0];
  const double time = std::sqrt(2 * 5 / kG), speed = kG * time, tilt = kPi / 6;
  EXPECT_NEAR(hit.time, time, 1e-9);
  EXPECT_NEAR(hit.obliquity, tilt, 1e-12);
  EXPECT_NEAR(length(hit.velocity), speed, 1e-9);
  const double along = speed * std::sin(tilt), off = 0.5 * speed * std::cos(tilt);
  EXPECT_NEAR(length(hit.velocity_after), std::hypot(along, off), 1e-9);
  EXPECT_EQ(hit.outcome, EventKind::bounced);
  EXPECT_EQ(hit.thing, 0u);
  EXPECT_EQ(hit.material, 0u);
  EXPECT_EQ(hit.launched.group, 0u);
  EXPECT_EQ(hit.launched.number, 1u);
  // Off the slope and back to it, by the part of gravity that is normal to it.
  EXPECT_NEAR(ball.hits.all[1].time - time, 2 * off / (kG * std::cos(tilt)), 1e-9);
  EXPECT_EQ(ball.hits.on_things.count, ball.hits.all.size());
  EXPECT_EQ(ball.hits.on_things.bounces, ball.hits.all.size());
  ASSERT_EQ(ball.hits.by_thing.size(), 1u);
  EXPECT_EQ(ball.hits.by_thing[0].thing, "slope");
}

TEST(FlightHits, AreThoseOfAWorld) {
  const Flown ball = flown(parsed(kVacuum + kSlope + kNoGround));
  WorldRun run =
      WorldRun::create(parsed(kVacuum + kSlope + "[world]\nstep = \"10 ms\"\nduration = \"3 s\"\nground = \"none\"\n"))
          .value();
  const std::vector<ThingHit> hits = hits_of(run);
  ASSERT_EQ(hits.size(), ball.hits.all.size());
  for (std::size_t i = 0; i < hits.size(); ++i) {
    EXPECT_NEAR(hits[i].time, ball.hits.all[i].time, 1e-9);
    EXPECT_LT(length(hits[i].position - ball.hits.all[i].position), 1e-9);
    EXPECT_LT(length(hits[i].velocity_after - ball.hits.all[i].velocity_after), 1e-9);
    EXPECT_EQ(hits[i].outcome, ball.hits.all[i].outcome);
  }
}

TEST(FlightHits, EndAFlightThatStops) {
  Scenario scenario = parsed(kVacuum + kSlope + kNoGround);
  scenario.shots[0].body.collision.on_hit = OnHit::stop;
  const Flown ball = flown(scenario);
  EXPECT_EQ(ball.flight.outcome(), Outcome::hit);
  ASSERT_EQ(ball.hits.all.size(), 1u);
  EXPECT_EQ(ball.hits.all[0].outcome, EventKind::stopped);
  EXPECT_EQ(ball.hits.on_things.stops, 1u);
  const Flight again = fly_shot(scenario, scenario.shots[0]);  // makes the scene itself
  EXPECT_EQ(again.duration(), ball.flight.duration());
}

TEST(FlightHits, OfAShotThatIsSaidToStopAreStopsWhateverComesAfter) {
  Scenario scenario = parsed(kVacuum + kSlope + kNoGround);
  const Flown ball = flown(scenario);
  scenario.shots[0].body.collision.on_hit = OnHit::stop;  // it has flown as one that bounces
  const FlightHits hits = flight_hits(scenario, scenario.shots[0], ball.flight, ball.parts);
  EXPECT_GE(hits.all.size(), ball.hits.all.size());
  for (const ThingHit& hit : hits.all) EXPECT_EQ(hit.outcome, EventKind::stopped) << hit.time;
}

TEST(FlightHits, AreJudged) {
  const Flown ball = flown(parsed(kVacuum + kSlope + kNoGround));
  const auto value = [&](const std::string& quantity, const std::string& thing) {
    return measure(ball.flight, ball.hits, {.thing = thing, .quantity = quantity});
  };
  EXPECT_EQ(value("hits", "").value(), static_cast<double>(ball.hits.all.size()));
  EXPECT_EQ(value("bounces", "slope").value(), static_cast<double>(ball.hits.all.size()));
  EXPECT_EQ(value("stops", "slope").value(), 0);
  EXPECT_NEAR(value("hit_obliquity", "slope").value(), ball.hits.on_things.obliquity.mean, 1e-15);
  EXPECT_NEAR(value("time", "").value(), 3, 1e-12) << "a figure of the flight";
  EXPECT_FALSE(value("hit_depth", "slope")) << "nothing went in";
  EXPECT_FALSE(value("hit_y", "another"));
  EXPECT_FALSE(value("spawned", "")) << "a figure of worlds";
}

TEST(FlightHits, OfWhatIsPassedArePassages) {
  const std::string ball =
      "[[shot]]\nname = \"b\"\nmass = 1\ndiameter = 0.2\nvelocity = [10, 0, 0]\nposition = [-7.3, 0, 0]\ngravity_scale "
      "= 0\n"
      "fidelity = { preset = \"simulation\", drag = \"off\", air = \"vacuum\" }\n";
  const std::string shape = "[[shape]]\nname = \"s\"\nbox = [1, 1, 1]\n";
  const auto zone = [](const std::string& name, const std::string& x, bool is_sensor) {
    return "[[thing]]\nname = \"" + name + "\"\nshape = \"s\"\nposition = [" + x + ", 0, 0]\n" +
           (is_sensor ? "sensor = true\n" : "");
  };
  const auto value = [](const Flown& of, const std::string& quantity, const std::string& thing) {
    return measure(of.flight, of.hits, {.thing = thing, .quantity = quantity}).value();
  };
  const Flown sensed =
      flown(parsed(kVacuum + ball + shape + zone("near", "0", true) + zone("far", "5", true) + kNoGround));
  EXPECT_EQ(value(sensed, "passages", "near"), 1);
  EXPECT_EQ(value(sensed, "passages", "far"), 1);
  EXPECT_EQ(value(sensed, "passages", ""), 2);
  EXPECT_EQ(value(sensed, "passages", "none"), 0);
  EXPECT_EQ(value(sensed, "hits", "near"), 0);
  const std::string pass = "body = { collision = { on_hit = \"pass\" } }\n";
  const Flown passed = flown(parsed(kVacuum + ball + pass + shape + zone("wall", "0", false) + kNoGround));
  EXPECT_EQ(value(passed, "passages", "wall"), 1);
  const Flown stopped = flown(parsed(kVacuum + ball + shape + zone("wall", "0", false) + kNoGround));
  EXPECT_EQ(value(stopped, "passages", "wall"), 0);
  EXPECT_EQ(value(stopped, "hits", "wall"), 1);
}

/// The cheapest fidelity is found up to the first contact, whatever comes after it.
TEST(FlightHits, OfAFidelityThatIsChosen) {
  const std::string text =
      "[[shape]]\nname = \"wall\"\nbox = [1, 100, 100]\n[[thing]]\nshape = \"wall\"\nposition = [301, 0, 0]\n"
      "[[shot]]\nmass = \"168 gr\"\ndiameter = \"0.308 in\"\nspeed = 800\nelevation = 0.01\n"
      "drag = { table = \"g7\", ballistic_coefficient = \"0.218 lb/in^2\" }\n"
      "body = { collision = { on_hit = \"bounce\" } }\n";
  const auto hit_of = [&](const std::string& fidelity) {
    Scenario scenario =
        parse_scenario("physim = 1\n" + text + "fidelity = " + fidelity + "\n" + kNoGround, "f.toml").value();
    const Flown bullet = flown(scenario);
    EXPECT_FALSE(bullet.flight.error()) << bullet.flight.error()->text();
    EXPECT_EQ(bullet.hits.all.size(), 1u) << fidelity;
    return bullet.hits.all.empty() ? ThingHit{} : bullet.hits.all[0];
  };
  const ThingHit truth = hit_of("\"reference\""), near = hit_of("{ cheapest_within = \"1 cm\" }");
  EXPECT_LT(length(truth.position - near.position), 0.01);
  EXPECT_NEAR(truth.position.x, 300, 1e-6);
  const ThingHit stepped = hit_of("{ preset = \"small_arms\", integrator = \"rk4\" }");  // by an automatic step
  EXPECT_LT(length(stepped.position - hit_of("\"small_arms\"").position), 2e-3);
}

TEST(FlightHits, KnowNothingOfTheThingsOfAWorld) {
  const Scenario scenario = parsed(kVacuum + kSlope + "[world]\n");
  EXPECT_EQ(fly_shot(scenario, scenario.shots[0]).outcome(), Outcome::landed);
}

TEST(FlightHits, OfASceneThatCannotBeMadeAreRefused) {
  Scenario scenario = parsed(kVacuum + kSlope + kNoGround);
  scenario.things[0].shape = "another";
  const Flight flight = fly_shot(scenario, scenario.shots[0]);
  EXPECT_EQ(flight.outcome(), Outcome::refused);
  ASSERT_TRUE(flight.error());
  EXPECT_EQ(flight.error()->message, "no shape is named \"another\"");
}

/// Studies fly through the things of a scenario as fly_shot() does, and named things are targets; in a world they do
/// not.
TEST(FlightHits, AreToldOfStudies) {
  Scenario scenario = parsed(kVacuum + kSlope + kNoGround);
  scenario.study.inputs = {"shot.position.y = 4.9 m .. 5.1 m"};
  const auto study = must(study_of(scenario, scenario.shots[0]));
  ASSERT_TRUE(study.scene != nullptr);
  EXPECT_EQ(study.until.contact, contact_of(scenario.shots[0]));
  ASSERT_EQ(study.targets.size(), 1U);
  EXPECT_EQ(study.targets[0], (StudyTarget{"slope", ThingTarget{"slope"}}));
  EXPECT_EQ(*parse_study_target("thing slope"), study.targets[0]);
  EXPECT_EQ(parse_study_target("hill: thing slope")->name, "hill");
  scenario.things[0].shape = "another";
  const auto unmade = study_of(scenario, scenario.shots[0]);
  ASSERT_FALSE(unmade);
  EXPECT_EQ(unmade.error().message, "no shape is named \"another\"");
  const Scenario world = parsed(kVacuum + kSlope + "[world]\n");
  EXPECT_TRUE(study_of(world, world.shots[0])->scene == nullptr);
}

// ----------------------------------------------------------------------------------------------------- read and
// written
TEST(SceneOfFlights, IsWrittenAndReadBack) {
  const Scenario before = parsed(kVacuum + kSlope + kNoGround);
  const std::string text = scenario_text(before);
  const Scenario after = must(parse_scenario(text, "g.toml"), text);
  EXPECT_FALSE(after.world.given);
  EXPECT_EQ(after.shots[0].body, before.shots[0].body);
  EXPECT_EQ(after.things.size(), 1u);
  EXPECT_EQ(effective_settings(after), effective_settings(before));
  std::vector<std::string> overrides;
  for (const auto& [path, value] : effective_settings(before)) overrides.push_back(path + "=" + value);
  const Scenario again = must(parse_scenario("physim = 1\n[[shot]]\nname = \"ball\"\n", "h.toml", overrides));
  EXPECT_EQ(effective_settings(again), effective_settings(before));
}

TEST(SceneOfFlights, IsNotSaidWhereThereIsNone) {
  for (const auto& [path, value] : effective_settings(parsed(kVacuum + "[[shot]]\nspeed = 10\n")))
    EXPECT_TRUE(!path.starts_with("thing") && path.find(".body.") == path.npos) << path;
}

TEST(SceneOfFlights, KnowsColoursOfBodiesThatHaveSome) {
  const Scenario scenario = parsed(kVacuum + "[[shot]]\nspeed = 10\nbody = { colour = 0xE69F00FF }\n");
  EXPECT_EQ(scenario.shots[0].body.colour, 0xE69F00FFU);
  int said = 0;
  for (const auto& [path, value] : effective_settings(scenario)) {
    if (path.find(".body.") == path.npos) continue;
    EXPECT_EQ(path, "shot.shot-1.body.colour");
    EXPECT_EQ(value, "3869180159");
    ++said;
  }
  EXPECT_EQ(said, 1);
  EXPECT_EQ(parse_scenario(scenario_text(scenario), "again.toml").value().shots[0].body.colour, 0xE69F00FFU);
}

struct BadFlight {
  std::string text, error;
  friend std::ostream& operator<<(std::ostream& out, const BadFlight& bad) { return out << bad.error; }
};
class BadFlightTest : public testing::TestWithParam<BadFlight> {};
TEST_P(BadFlightTest, SaysWhereAndWhy) {
  const std::string head =
      "physim = 1\n[[shape]]\nname = \"a\"\nsphere = 1\n[[thing]]\nname = \"ball\"\nshape = \"a\"\n";
  const Result<Scenario> scenario = parse_scenario(head + GetParam().text, "f.toml");
  EXPECT_EQ(scenario.ok() ? "no error" : scenario.error().text(), GetParam().error) << GetParam().text;
}

// The text begins on line 8.
INSTANTIATE_TEST_SUITE_P(
    Scenes, BadFlightTest,
    testing::Values(
        BadFlight{
            "[[shot]]\nbody = { gravity_scale = 0 }",
            "f.toml:9:26: error: shot.body.gravity_scale: there is no [world] for it; write [world], and the shots "
            "fly in it"},
        BadFlight{"[[shot]]\nbody.collision.others = 1",
                  "f.toml:9:25: error: shot.body.collision.others: there is no [world] for it; write [world], and the "
                  "shots fly in it"},
        BadFlight{"[[shot]]\nbody.collision.on_hit = \"bonce\"",
                  "f.toml:9:25: error: shot.body.collision.on_hit: unknown value \"bonce\"; did you mean \"bounce\"?"},
        BadFlight{"[[shot]]\nbody.restitution = 2",
                  "f.toml:9:20: error: shot.body.restitution: 2 is out of range; must be 0 .. 1"},
        BadFlight{"[[shot]]\n[[expect]]\nquantity = \"hits\"\nat = \"apex\"\nequals = 0\nwithin = 0",
                  "f.toml:11:6: error: expect.at: hits are those of the whole flight; leave it out"},
        BadFlight{"[[shot]]\n[[expect]]\nquantity = \"spawned\"\nequals = 0\nwithin = 0",
                  "f.toml:10:12: error: expect.quantity: \"spawned\" is a figure of a [world]; write [world], and the "
                  "shots fly in it"},
        BadFlight{"[[shot]]\n[[expect]]\nthing = \"bal\"\nquantity = \"hits\"\nequals = 0\nwithin = 0",
                  "f.toml:10:9: error: expect.thing: no thing is named \"bal\"; did you mean \"ball\"?"},
        BadFlight{"[[shot]]\n[[thing]]\nshape = \"b\"",
                  "f.toml:10:9: error: thing.shape: no shape is named \"b\"; shapes: a"}));

}  // namespace physim::scenario_flight_hits_test
