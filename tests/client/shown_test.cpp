// What the client shows is so: the comparison's truth and figures, forces that add up, the pace reached.
#include <algorithm>
#include <cmath>
#include <map>
#include <set>
#include <sstream>

#include "client/support.hpp"
#include "report/ladder.hpp"
#include "simclient/core/labels.hpp"
#include "simclient/core/length_text.hpp"
#include "simclient/core/scene.hpp"

namespace physim::client {
namespace {

// ---------------------------------------------------------------------------------------------------------- comparison
/// Error, error at worst and time error of a rung, as `physim compare` prints them.
std::vector<std::string> printed(const std::string& table, const std::string& rung) {
  std::istringstream lines(table);
  for (std::string line; std::getline(lines, line);) {
    const std::size_t at = line.find_first_not_of(' ');
    if (at == line.npos || !line.substr(at).starts_with(rung + "  ")) continue;
    std::istringstream words(line.substr(at + rung.size()));
    std::vector<std::string> figures(3);
    words >> figures[0] >> figures[1] >> figures[2];
    return figures;
  }
  return {};
}

class Compared : public testing::TestWithParam<std::string> {};

TEST_P(Compared, HasTheFiguresOfTheCommandLineToTheDigit) {
  Client client = client_of(GetParam());
  client.compared = {"classic", "arcade", "game", "constant_air", "small_arms", "artillery", "simulation", "reference"};
  const auto& rungs = client.comparison();
  const Scenario& scenario = client.session.scenario();
  const auto ladder = must(report::climb(scenario, client.launcher.shot()));
  const std::string table = report::ladder_text({scenario, ladder}, report::Style());
  const report::RungResult& truth = ladder.rungs.back();
  ASSERT_TRUE(rungs.back().is_truth);
  EXPECT_EQ(rungs.back().granted.fidelity, truth.flight.fidelity_in_use().fidelity);
  EXPECT_EQ(rungs.back().end.position, truth.flight.end().position);
  int compared = 0;
  for (const ComparedRung& rung : rungs) {
    EXPECT_EQ(rung.is_truth, &rung == &rungs.back());
    const bool as_chosen = rung.name == "as set" && client.launcher.shot().cheapest_within;
    const auto figures = printed(table, as_chosen ? ladder.rungs.front().rung.name() : rung.name);
    if (figures.empty() || !rung.problem.empty()) continue;
    EXPECT_EQ(rung.figures()[0], figures[0]) << rung.name;
    EXPECT_EQ(rung.figures()[2], figures[1]) << rung.name;
    EXPECT_EQ(rung.figures()[1], figures[2]) << rung.name;
    ++compared;
  }
  EXPECT_GE(compared, 4);
}

INSTANTIATE_TEST_SUITE_P(Shots, Compared,
                         testing::Values("golf_drive", "original_bullet", "model_rocket", "308_168gr_published"),
                         [](const auto& test) { return test.param; });

TEST(Comparison, TheTruthOfAGolfDriveHasItsSpin) {
  Client client = client_of("golf_drive");
  client.compared = {"classic", "game"};
  const ComparedRung& truth = client.comparison().back();
  EXPECT_EQ(truth.name, "reference");
  EXPECT_EQ(truth.granted.fidelity.rotation, RotationModel::magnus);
  EXPECT_NEAR(truth.end.range, 253.0, 0.1);
  EXPECT_LT(client.comparison().front().at_end, 1) << "the shot as it is set";
}

TEST(Comparison, ShowsWhatIsFlownOfAShotThatAsksForAnError) {
  Client client = client_of("308_168gr_g7");
  ASSERT_TRUE(client.set("shot.fidelity.cheapest_within = 5 cm"));
  const ComparedRung& own = client.comparison().front();
  EXPECT_GT(own.at_end, 0);
  EXPECT_LT(own.at_end, 0.05);
  EXPECT_NE(own.asked, Fidelity::reference());
}

/// The command line's list of what a rung leaves out, as a sentence.
TEST(Comparison, SaysWhyInASentence) {
  Client client = client_of("golf_drive");
  ASSERT_TRUE(client.set("shot.fidelity.rotation = none"));
  client.compared = {"arcade", "game", "artillery"};
  const auto& rungs = client.comparison();
  const ComparedRung& truth = rungs.back();
  const std::string own = rungs.front().why(truth);
  EXPECT_TRUE(own.ends_with("no lift from spin")) << own;
  EXPECT_NE(own.find(" m short: "), std::string::npos) << own;
  EXPECT_NEAR(std::stod(own), truth.end.range - rungs.front().end.range, 1);
  EXPECT_EQ(truth.why(truth), "the truth");
  const auto ladder = must(report::climb_presets(client.session.scenario(), client.launcher.shot()));
  int found = 0;
  for (const ComparedRung& rung : rungs)
    for (const report::RungResult& result : ladder.rungs) {
      if (result.rung.name() != rung.name || rung.is_truth) continue;
      const std::string why = rung.why(truth);
      const bool is_same = why.ends_with("float32") || why.ends_with("the same physics, other steps");
      EXPECT_EQ(is_same, result.leaves_out.empty()) << rung.name << ": " << why << " | " << result.leaves_out;
      EXPECT_EQ(why.find("no drag") != why.npos, result.leaves_out.find("drag off") != std::string::npos) << why;
      EXPECT_EQ(why.find("flat earth") != why.npos, result.leaves_out.find("earth flat") != std::string::npos) << why;
      EXPECT_EQ(why.find("no air"), why.npos) << "follows from no drag: " << why;
      ++found;
    }
  EXPECT_EQ(found, 3);
}

TEST(Comparison, LengthsHaveNoPowersOfTen) {
  for (double metres = 1e-4; metres < 1e8; metres *= 1.001)
    EXPECT_EQ(length_text(metres).find('e'), std::string::npos) << length_text(metres);
  EXPECT_EQ(length_text(0.9999), "1 m");
  EXPECT_EQ(length_text(2390), "2.39 km");
  EXPECT_EQ(length_text(0.011), "1.1 cm");
}

/// Of each shot the lengths of the sentences are those of the figures, in units that people use.
TEST(Comparison, SaysHowFarInUnitsThatFit) {
  for (const char* name : {"golf_drive", "105mm_m1_six_dof", "308_168gr_g7", "model_rocket", "curve_ball"}) {
    Client client = client_of(name);
    const auto& rungs = client.comparison();
    const ComparedRung& truth = rungs.back();
    for (const ComparedRung& rung : rungs) {
      if (rung.is_truth) continue;
      const std::string why = rung.why(truth);
      double number = 0;
      char unit[8] = "";
      ASSERT_EQ(std::sscanf(why.c_str(), "%lf %7s", &number, unit), 2) << why;
      const std::map<std::string, double> units = {{"km", 1000}, {"m", 1}, {"cm", 0.01}, {"mm", 0.001}};
      ASSERT_EQ(units.count(unit), 1u) << why;
      EXPECT_LT(number, 1000) << why;
      const double metres = number * units.at(unit);
      EXPECT_LE(metres, 1.06 * rung.at_end) << why;
      EXPECT_GE(metres, 0.94 * rung.at_end / std::sqrt(3.0)) << why << ": the largest of three sides";
      EXPECT_EQ(why.find('_'), why.npos) << why;
      EXPECT_EQ(why.find("e+"), why.npos) << why;
      EXPECT_NE(why.find(": "), why.npos) << why;
    }
  }
}

TEST(Comparison, SaysToWhichSide) {
  Client client = client_of("308_168gr_g7");
  client.compared = {"arcade", "game"};
  const auto& rungs = client.comparison();
  const std::string arcade = rungs[1].why(rungs.back());
  EXPECT_NE(arcade.find(" m high: "), std::string::npos)
      << "without drag a bullet drops less up to its range: " << arcade;
}

// -------------------------------------------------------------------------------------------------------------- forces
struct Arrows {
  std::vector<SceneLine> forces;  // their shafts, in order
  std::optional<SceneLine> resultant;
  std::set<std::string> names;
};

Arrows arrows_of(Client& client) {
  Scene scene;
  build_vectors(client, 1, scene);
  Arrows arrows;
  for (std::size_t i = 0; i < scene.lines.size(); i += 3) {  // a shaft and two sides of its head
    if (scene.lines[i].colour == colours::kForce) arrows.forces.push_back(scene.lines[i]);
    if (scene.lines[i].colour == colours::kAcceleration) arrows.resultant = scene.lines[i];
  }
  for (const SceneLabel& label : scene.labels) arrows.names.insert(label.text.substr(0, label.text.find(' ')));
  return arrows;
}

TEST(Forces, ShowEveryEffectOfTheLedger) {
  const struct {
    const char *scenario, *script;
    std::set<std::string> names;
  } flights[] = {{"golf_drive", "fire; wait 30", {"gravity", "drag", "Magnus"}},
                 {"model_rocket", "set shot.elevation=60 deg; fire; wait 2", {"gravity", "thrust", "constraint"}},
                 {"308_168gr_six_dof", "fire; wait 2", {"drag", "body"}},
                 {"original_test_3", "fire-scenario; wait 20", {"applied"}}};
  for (const auto& flight : flights) {
    Client client = client_of(flight.scenario);
    ASSERT_TRUE(run(client, flight.script));
    const std::set<std::string> shown = arrows_of(client).names;
    for (const std::string& name : flight.names) EXPECT_EQ(shown.count(name), 1U) << flight.scenario << " " << name;
  }
}

TEST(Forces, AddUpToMassTimesAcceleration) {
  for (const char* scenario : {"golf_drive", "model_rocket", "105mm_m1_six_dof", "golf_ball_no_spin"}) {
    Client client = client_of(scenario);
    ASSERT_TRUE(run(client, "fire; wait 10"));
    const ProjectileView projectile = client.session.world()[client.selected_track()->id];
    const Arrows apart = arrows_of(client);
    ASSERT_TRUE(apart.resultant);
    const Vec3d way = apart.resultant->b - apart.resultant->a;
    const double unit = length(way) / length(projectile.accelerations().total);
    EXPECT_LT(length(way - projectile.accelerations().total * unit), 1e-9 * length(way));
    bool has_gravity = false;
    for (const SceneLine& line : apart.forces) {
      EXPECT_EQ(line.a, apart.resultant->a);
      const Vec3d gravity = projectile.accelerations().gravity * unit;
      has_gravity |= length(line.b - line.a - gravity) < 1e-6 * length(gravity);
    }
    EXPECT_TRUE(has_gravity) << "one scale for all";

    ASSERT_TRUE(run(client, "pause; add-up"));
    const Arrows chain = arrows_of(client);
    ASSERT_GE(chain.forces.size(), 2U);
    for (std::size_t i = 1; i < chain.forces.size(); ++i) EXPECT_EQ(chain.forces[i].a, chain.forces[i - 1].b);
    EXPECT_EQ(chain.forces.front().a, chain.resultant->a);
    EXPECT_LT(length(chain.forces.back().b - chain.resultant->b), 1e-6 * length(way)) << scenario;
  }
}

TEST(Forces, AreThoseOfTheMassThatIsLeft) {
  Client client = client_of("model_rocket");
  ASSERT_TRUE(run(client, "fire; wait 150"));  // burnt out
  const TrackSample& now = client.session.tracks()[0].samples.back();
  EXPECT_NEAR(now.mass, 0.0463, 1e-6);
  EXPECT_NEAR(client.session.tracks()[0].samples.front().mass, 0.0571, 1e-6);
  const auto energy = plot_quantities()[parse_plots("energy").value()[0].y];
  EXPECT_NEAR(energy.of(client.session.tracks()[0], now), 0.0463 * length_squared(now.velocity) / 2, 1e-4);
  Scene scene;
  build_vectors(client, 1, scene);
  for (const SceneLabel& label : scene.labels)
    if (label.text.starts_with("gravity")) {
      EXPECT_NEAR(std::stod(label.text.substr(8)), 0.0463 * 9.8, 0.003) << label.text;
    }
}

// -------------------------------------------------------------------------------------------------------------- labels
TEST(Labels, AtTheMuzzleCanAllBeRead) {
  Client client = client_of();
  ASSERT_TRUE(run(client, "laser; fire; bullet; fire; artillery; fire; sphere; fire; step; vectors"));
  Scene scene;
  build_projectiles(client, 1, scene);
  const std::size_t projectiles = scene.labels.size();
  build_vectors(client, 1, scene);
  constexpr float kLine = 15, kLetter = 7;
  const auto width_of = [](const std::string& text) { return kLetter * static_cast<float>(text.size()); };
  const Box box{0, 0, static_cast<float>(client.camera.width()), static_cast<float>(client.camera.height())};
  const auto placed = place_labels(scene.labels, client.camera, box, kLine, 1, width_of);
  EXPECT_GE(projectiles, 4U);
  EXPECT_EQ(placed.size(), scene.labels.size());
  for (const PlacedLabel& a : placed)
    for (const PlacedLabel& b : placed) {
      const bool beside = a.x + width_of(a.label->text) <= b.x || b.x + width_of(b.label->text) <= a.x;
      EXPECT_TRUE(&a == &b || beside || std::abs(a.y - b.y) >= kLine - 2) << a.label->text << " " << b.label->text;
    }
}

/// Of shots that do the same the last one is told, and the others do not stand about it.
TEST(Labels, OfShotsBeforeGiveWay) {
  Client client = client_of("golf_drive");
  client.camera.set_viewport(1000, 600);
  ASSERT_TRUE(run(client, "fire-whole; wait 450; fire-whole; wait 450; fire-whole; wait 450"));
  Scene scene;
  build_scene(client, 1, scene);
  const Box box{0, 0, 1000, 600};
  const auto width_of = [](const std::string& text) { return 7.0F * static_cast<float>(text.size()); };
  std::map<std::string, int> told;
  for (const PlacedLabel& each : place_labels(scene.labels, client.camera, box, 16, 1, width_of))
    ++told[each.label->text.substr(0, each.label->text.find(' '))];
  EXPECT_EQ(told["apex"], 1);
  EXPECT_EQ(told["253.03"], 1);
}

TEST(Labels, OverARoundEarthTellAltitudeAndTheWayAround) {
  Client client = client_of("intercontinental_lob");
  ASSERT_TRUE(run(client, "fire-whole"));
  client.session.set_time_scale(1024);
  for (int i = 0; i < 300 && client.session.in_flight() > 0; ++i) client.advance(1.0 / 60);
  const Track& track = client.session.tracks()[0];
  ASSERT_TRUE(track.apex && track.impact);
  const EarthFrames frames = track.whole->earth_frames();
  Scene scene;
  build_projectiles(client, 1, scene);
  double apex = 0, distance = 0;
  for (const SceneLabel& label : scene.labels) {
    std::sscanf(label.text.c_str(), "apex %lf km", &apex);
    std::sscanf(label.text.c_str(), "%lf km in", &distance);
  }
  const double height = frames.geodetic(track.apex->position).height / 1000;
  const double last_digit = std::pow(10, std::floor(std::log10(height)) - 5);  // of six
  EXPECT_NEAR(apex, height, 0.5001 * last_digit);
  EXPECT_GT(1000 * apex, track.apex->position.y + 1e5) << "the plane of the muzzle lies far below the ground there";
  EXPECT_NEAR(distance, 47.5358469047 * 0.017453292519943295 * 6371, 0.01) << "as its scenario expects in degrees";
}

TEST(Numbers, FitIntoTheirColumns) {
  for (const double x : {0.0, -0.001, 12.3456, -999.999, 12345.678, -316400.7, 4006000.0, -40060000.0, 6.378e9, -1e300})
    EXPECT_LE(fitting_text(x, 8).size(), 8U) << x;
  EXPECT_EQ(fitting_text(-12.3456, 8), "-12.346");
  EXPECT_EQ(fitting_text(-316400.7, 8), "-316401");
  EXPECT_EQ(fitting_text(-40060000.0, 8), "-4.0e+07");
}

// ---------------------------------------------------------------------------------------------------------------- pace
TEST(Pace, AShellInSmallStepsFliesInRealTime) {
  Client client = client_of("105mm_m1_six_dof");  // steps of 0.5 ms
  ASSERT_TRUE(run(client, "fire; wait 60"));
  EXPECT_NEAR(client.session.time(), 1, 0.02);
  EXPECT_NEAR(client.session.time_scale_reached(), 1, 1e-9);
}

TEST(Pace, TellsWhatIsNotReached) {
  Client client = client_of("105mm_m1_six_dof");
  ASSERT_TRUE(run(client, "fire"));
  client.session.set_time_scale(4);
  for (int i = 0; i < 200; ++i) client.advance(1.0 / 60, 0);  // has no time for steps at all
  EXPECT_LT(client.session.time_scale_reached(), 0.1);
  for (int i = 0; i < 200; ++i) client.advance(1.0 / 60);
  EXPECT_NEAR(client.session.time_scale_reached(), 4, 0.05);
  client.session.set_paused(true);
  client.advance(1.0 / 60);
  EXPECT_NEAR(client.session.time_scale_reached(), 4, 0.05) << "a pause is not slow";
}

TEST(Pace, FlightsComputedWholeArePlayedAtAnySpeed) {
  Client client = client_of("105mm_m1_six_dof");
  ASSERT_TRUE(run(client, "fire-whole"));
  const Flight flight = fly_shot(client.session.scenario(), client.launcher.shot());
  for (const double scale : {1.0, 0.25, 512.0}) {
    client.session.set_time_scale(scale);
    for (int i = 0; i < 3; ++i) client.advance(1.0 / 60);
    const Track& track = client.session.tracks()[0];
    const TrackSample& now = track.samples.back();
    EXPECT_NEAR(now.time, client.session.time(), 1e-9);
    EXPECT_EQ(now, sample_of(flight, now.time));
    EXPECT_NEAR(client.session.time_scale_reached(), scale, 1e-6 * scale);
  }
  const Track& track = client.session.tracks()[0];
  EXPECT_GT(track.samples.size(), 200U) << "the trail is no polygon";
  EXPECT_TRUE(client.session.world().ids().empty());
  client.session.set_time_scale(1024);
  for (int i = 0; i < 10; ++i) client.advance(1.0 / 60);
  EXPECT_EQ(track.status, LifeStatus::landed);
  EXPECT_EQ(track.samples.back(), sample_of(flight, flight.duration()));
  ASSERT_TRUE(track.apex && track.impact);
  EXPECT_NEAR(track.apex->velocity.y, 0, 1e-6);
  EXPECT_EQ(client.session.in_flight(), 0U);
  ASSERT_TRUE(run(client, "back"));
  ASSERT_FALSE(client.session.edit(track.id, [](Projectile p) { return p.set_velocity({}); }));
}

/// With the drift of its spin, and with a mark at the range that ends it.
TEST(Fired, AClickFliesWhatTheScenarioSays) {
  Client client = client_of("308_168gr_g7");
  client.click({client.camera.width() / 2, client.camera.height() / 2});
  ASSERT_EQ(client.session.tracks().size(), 1U);
  client.session.set_time_scale(64);
  for (int i = 0; i < 10; ++i) client.advance(1.0 / 60);
  const Track& track = client.session.tracks()[0];
  ASSERT_FALSE(track.is_flying());
  const Flight flight = fly_shot(client.session.scenario(), client.launcher.shot());
  EXPECT_EQ(track.samples.back(), sample_of(flight, flight.duration()));
  EXPECT_NEAR(flight.end().range, 1000, 1e-6);
  EXPECT_EQ(client.session.fate_of(track), "at its end");
  Scene scene;
  build_scene(client, 1, scene);
  std::set<std::string> labels;
  for (const SceneLabel& label : scene.labels) labels.insert(label.text);
  char said[64];
  std::snprintf(said, sizeof said, "drop %.3f m, windage %.3f m", flight.end().drop, flight.end().windage);
  EXPECT_TRUE(labels.contains(said)) << said;
}

TEST(Fired, StatisticsSayWhatHasBecomeOfIt) {
  Client client = client_of("mortar_over_hill");
  ASSERT_TRUE(run(client, "fire; wait 500"));
  std::set<std::string> fates;
  for (const Track& track : client.session.tracks()) fates.insert(client.session.fate_of(track));
  EXPECT_TRUE(fates.contains("stopped by hill")) << *fates.begin();
  EXPECT_FALSE(fates.contains("unknown"));
  Client range = client_of();
  ASSERT_TRUE(run(range, "fire; wait 2"));
  EXPECT_EQ(range.session.fate_of(range.session.tracks()[0]), "in flight");
  ASSERT_TRUE(run(range, "wait 60"));
  EXPECT_EQ(range.session.fate_of(range.session.tracks()[0]), "landed");
}

/// A ball that lies without sleeping is at rest, and nothing accelerates it.
TEST(Fired, WhatLiesIsAtRest) {
  const Result<Scenario> scenario = parse_scenario(R"(physim = 1
environment = { atmosphere = "vacuum" }
[[shot]]
name = "ball"
position = ["0 m", "1 m", "0 m"]
speed = 0
body = { restitution = 0, can_sleep = false }
[world]
duration = "10 s"
ground = "bounce"
)",
                                                   "f.toml");
  ASSERT_TRUE(scenario) << scenario.error().text();
  Client client(Session::create(*scenario).value());
  ASSERT_TRUE(run(client, "wait 20"));
  ASSERT_EQ(client.session.tracks().size(), 1U);
  const Track& track = client.session.tracks()[0];
  EXPECT_EQ(client.session.fate_of(track), "in flight");
  EXPECT_NEAR(track.samples.back().acceleration.y, -9.80665, 1e-3);
  ASSERT_TRUE(run(client, "wait 60"));
  EXPECT_FALSE(client.session.world()[track.id].is_asleep());
  EXPECT_EQ(client.session.fate_of(track), "at rest");
  EXPECT_EQ(track.samples.back().acceleration, Vec3d{});
}

TEST(Pace, WhatWasComparedIsWhatIsPlayed) {
  Client client = client_of("golf_drive");
  ASSERT_TRUE(client.fire_compared());
  const auto& rungs = client.comparison();
  ASSERT_EQ(client.session.tracks().size(), rungs.size());
  client.session.set_time_scale(16);
  for (int i = 0; i < 60; ++i) client.advance(1.0 / 60);
  for (std::size_t i = 0; i < rungs.size(); ++i)
    EXPECT_EQ(client.session.tracks()[i].samples.back().position, rungs[i].end.position) << rungs[i].name;
  Client world = client_of("world_sparks");
  EXPECT_FALSE(world.fire_whole()) << "its shots fly in a world";
}

TEST(Pace, StepsBackIntoAFlightThatIsPlayed) {
  Client client = client_of("golf_drive");
  ASSERT_TRUE(run(client, "fire-whole; step; step; step"));
  const TrackSample third = client.session.tracks()[0].samples.back();
  ASSERT_TRUE(run(client, "step; back"));
  EXPECT_EQ(client.session.tracks()[0].samples.back(), third);
  while (client.session.tracks()[0].is_flying()) client.session.single_step();
  ASSERT_TRUE(client.session.step_back());
  EXPECT_TRUE(client.session.tracks()[0].is_flying());
  EXPECT_FALSE(client.session.tracks()[0].impact);
}

TEST(Performance, KnowsThatNothingHasMoved) {
  Client client = client_of();
  ASSERT_TRUE(run(client, "wait 30"));
  EXPECT_FALSE(client.session.cost().per_projectile_step());
  ASSERT_TRUE(run(client, "laser; fire; wait 20"));
  const double each = client.session.cost().per_projectile_step().value();
  EXPECT_GT(each, 0);
  client.session.clear_tracks();
  Client landed = client_of("golf_ball_no_spin");
  ASSERT_TRUE(run(landed, "set shot.speed=1 m/s; fire; wait 400"));
  EXPECT_EQ(landed.session.world().size(), 0U);
  EXPECT_LT(landed.session.cost().per_projectile_step().value(), 1e-2) << "an average over nothing";
}

}  // namespace
}  // namespace physim::client
