// Scenes in the client: what was hit, what is drawn of it, what a hand puts up, and what is saved of that.
#include <cmath>

#include "base/text.hpp"
#include "cli/program.hpp"
#include "client/support.hpp"
#include "math/angles.hpp"
#include "scenario/revise.hpp"
#include "scenario/world_run.hpp"
#include "simclient/core/scene.hpp"
#include "simclient/core/state_log.hpp"
#include "simclient/core/target_report.hpp"

namespace physim::client {
namespace {

using testing_cli::Folder;

std::string shipped(const std::string& name) { return PHYSIM_SOURCE_DIR "/scenarios/" + name + ".toml"; }

void step(Client& client, int steps) {
  for (int i = 0; i < steps; ++i) client.session.single_step();
}

// ---------------------------------------------------------------------------------------------------------------- hits
class HitsOf : public testing::TestWithParam<const char*> {};

/// What the client lists is what `physim run` does, hit by hit.
TEST_P(HitsOf, AreThoseOfTheCommandLine) {
  Client client = client_of(GetParam());
  WorldRun run = std::move(WorldRun::create(load_scenario(shipped(GetParam())).value()).value());
  std::vector<ThingHit> expected;
  for (std::uint64_t i = 0; i < run.steps(); ++i) {
    run.step();
    expected.insert(expected.end(), run.thing_hits().begin(), run.thing_hits().end());
  }
  step(client, static_cast<int>(run.steps()));
  const auto& hits = client.session.hits().hits();
  ASSERT_EQ(hits.size(), expected.size());
  ASSERT_GT(hits.size(), 1U);
  for (std::size_t i = 0; i < hits.size(); ++i) {
    EXPECT_EQ(hits[i].outcome, expected[i].outcome);
    EXPECT_EQ(hits[i].time, expected[i].time);
    EXPECT_EQ(hits[i].position, expected[i].position);
    EXPECT_EQ(hits[i].velocity, expected[i].velocity);
    EXPECT_EQ(hits[i].depth, expected[i].depth);
    EXPECT_EQ(hits[i].energy, expected[i].energy);
    EXPECT_NEAR(hits[i].obliquity, expected[i].obliquity, 1e-7);
    EXPECT_EQ(hits[i].thing, run.scenario().things[expected[i].thing].name);
    if (hits[i].outcome == EventKind::stopped) continue;
    EXPECT_EQ(hits[i].after, expected[i].velocity_after);
  }
}

INSTANTIATE_TEST_SUITE_P(Scenarios, HitsOf, testing::Values("bullet_through_plank", "ricochet_on_water", "billiards"),
                         [](const auto& test) { return std::string(test.param); });

TEST(Hits, AreToldInTheStateAndByTheirText) {
  Client client = client_of("bullet_through_plank");
  step(client, 12);
  ASSERT_EQ(client.session.hits().hits().size(), 2U);
  EXPECT_EQ(hit_text(client.session.hits().hits()[0]), "plank: penetrated, 780 to 778 m/s");
  EXPECT_EQ(hit_text(client.session.hits().hits()[1]), "wall: stopped 107.9 mm deep, 778 m/s");
  const std::string state = state_line(client, 1);
  EXPECT_NE(state.find("\"thing\":\"plank\",\"material\":\"fir\",\"what\":\"penetrated\""), std::string::npos) << state;
  // Its trail has a corner at each, and ends in the wall.
  EXPECT_NEAR(client.session.tracks()[0].samples.back().position.x, 60.10792, 1e-4);
  EXPECT_NEAR(client.session.tracks()[0].impact->position.x, 49.991, 1e-4);
}

TEST(Hits, AreForgottenOnTheWayBackAndKeptInNumberBelowABound) {
  Client client = client_of("bullet_through_plank");
  step(client, 12);
  while (client.session.time() > 0.07) ASSERT_TRUE(client.session.step_back());
  EXPECT_EQ(client.session.hits().hits().size(), 1U);
  step(client, 1);
  ASSERT_TRUE(client.restart());
  EXPECT_EQ(client.session.hits().count(), 0U);
  Client table = client_of("billiards");
  step(table, 60 * 120);
  const HitLog& log = table.session.hits();
  EXPECT_EQ(log.hits().size(), HitLog::kMost);
  EXPECT_GT(log.count(), HitLog::kMost);
  EXPECT_NEAR(log.hits().back().time, 120, 1);
  Scene scene;
  build_scene(table, 1, scene);
  EXPECT_LT(scene.lines.size(), 300 * HitLog::kMost);
}

/// A mark stays where it was made on a thing that moves and turns.
TEST(Hits, StayOnThingsThatMove) {
  physim::Scene scene;
  const ShapeId box = scene.add_shape(BoxShape{{0.5, 2, 2}}).value();
  const SteadyMotion motion{.velocity = {0, 1, 0}, .angular_velocity = {0, 0.5, 0}};
  const InstanceId door =
      scene.add({.shape = box, .transform = {.position = {10, 0, 0}}, .name = "door", .motion = motion}).value();
  WorldDef def{.environment = {.gravity = {.model = GravityModel::off}}, .ground = {.mode = GroundMode::none}};
  World world = std::move(World::create(def).value());
  ASSERT_TRUE(world.set_scene(scene));
  ProjectileDef ball;
  ball.name = "ball";
  Launch launch{.velocity = Vec3d{40, 0, 0}};
  ASSERT_TRUE(world.spawn(ball, launch));
  HitLog log;
  for (int i = 0; i < 60 && log.count() == 0; ++i) world.step(1.0 / 60), log.look_at(world, world.events());
  ASSERT_EQ(log.hits().size(), 1U);
  const Hit& hit = log.hits()[0];
  EXPECT_EQ(hit.outcome, EventKind::stopped);
  EXPECT_LT(length(place_in_world(*scene.state(door, hit.time), hit.at) - hit.position), 1e-9);
  for (const double later : {0.5, 2.0}) {
    const MotionState then = *scene.state(door, hit.time + later);
    EXPECT_LT(scene.nearest(place_in_world(then, hit.at), 1, {}, hit.time + later).distance, 1e-9);
    EXPECT_NEAR(place_in_world(then, hit.at).y - hit.position.y, later, 1e-9);
  }
}

// ---------------------------------------------------------------------------------------------------------- prediction
/// Through the plank, into the wall, off the cushions: as the shot then flies, to the bit.
TEST(Prediction, MeetsThingsAsTheShotDoes) {
  for (const char* name : {"bullet_through_plank", "ricochet_on_water", "billiards"}) {
    Client client = client_of(name);
    step(client, 3);
    const std::vector<TrackSample> path = client.prediction().path;
    ASSERT_TRUE(client.fire());
    step(client, 40);
    const Track& track = client.session.tracks().back();
    std::size_t compared = 0;
    for (const TrackSample& s : track.samples)
      for (const TrackSample& p : path)
        if (std::abs(p.time - s.time) < 1e-9) {
          EXPECT_LT(length(p.position - s.position), 1e-9) << name << " at " << s.time;
          ++compared;
        }
    EXPECT_GT(compared, 6U) << name;
  }
  Client client = client_of("bullet_through_plank");
  EXPECT_NEAR(client.prediction().path.back().position.x, 60.10792, 1e-4);
}

TEST(Prediction, SeesWhatWasPutUpAndWhatMovesByItself) {
  Client client = client_of();
  const double before = client.prediction().path.back().position.x;
  ASSERT_TRUE(run(client, "wall 10 -3 10 3"));
  EXPECT_NEAR(client.prediction().path.back().position.x, 9.9, 0.1);
  ASSERT_TRUE(run(client, "undo"));
  EXPECT_EQ(client.prediction().path.back().position.x, before);
}

// --------------------------------------------------------------------------------------------------------------- drawn
TEST(Scenery, IsTheSurfaceOfThings) {
  Client client = client_of("billiards");
  const physim::Scene& scene = *client.session.world().scene();
  const Scenery& scenery = client.scenery();
  ASSERT_EQ(scenery.vertices.size(), 5U * 36);
  EXPECT_EQ(scenery.solid, scenery.vertices.size());
  EXPECT_EQ(scenery.names.size(), 5U);
  for (const LitVertex& v : scenery.vertices) {
    const Vec3d at = scenery.origin + Vec3d{v.at[0], v.at[1], v.at[2]}, normal{v.normal[0], v.normal[1], v.normal[2]};
    EXPECT_NEAR(length(normal), 1, 1e-6);
    EXPECT_LT(scene.nearest(at).distance, 1e-6);
    const Vec3d inwards = at - normal * 0.01;
    EXPECT_LT(scene.nearest(inwards).distance, 0.01 + 1e-6);
  }
  EXPECT_NEAR(scenery.high.x, 1.52, 1e-6);
  EXPECT_NEAR(scenery.low.y, -0.1, 1e-6);
  const std::uint64_t version = scenery.version;
  EXPECT_EQ(client.scenery().version, version) << "nothing changed";
  ASSERT_TRUE(run(client, "target 0 1 0"));
  EXPECT_NE(client.scenery().version, version);
  EXPECT_EQ(client.scenery().names.size(), 6U);
}

TEST(Scenery, OfPlanesHasNoSizeAndOfNothingIsEmpty) {
  Client sea = client_of("ricochet_on_water");
  EXPECT_EQ(sea.scenery().vertices.size(), 6U);
  EXPECT_FALSE(sea.scenery().has_size);
  Client range = client_of();
  EXPECT_TRUE(range.scenery().is_empty());
  Scene scene;
  build_scene(range, 1, scene);
  EXPECT_EQ(scene.scenery, nullptr);
  EXPECT_NE(colour_of_material("water"), colour_of_material("concrete"));
}

/// A mesh of two triangles ends somewhere, a plane that is drawn by two does not; only planes reach as far as is seen.
TEST(Scenery, TellsSheetsFromPlanes) {
  physim::Scene scene;
  const MeshShape sheet{{{0, 0, 0}, {2, 0, 0}, {2, 3, 0}, {0, 3, 0}}, {{0, 1, 2}, {0, 2, 3}}, {}};
  ASSERT_TRUE(scene.add({.shape = scene.add_shape(sheet).value()}));
  SceneryMaker maker;
  EXPECT_TRUE(maker.make(&scene, 1, 0, 64).has_size);
  EXPECT_EQ(maker.make(&scene, 1, 0, 64).high.y, 3);
  const std::uint64_t version = maker.make(&scene, 1, 0, 64).version;
  EXPECT_EQ(maker.make(&scene, 1, 0, 128).version, version);
  ASSERT_TRUE(scene.add({.shape = scene.add_shape(PlaneShape{}).value()}));
  EXPECT_EQ(maker.make(&scene, 1, 0, 128).high.y, 3);
  const std::uint64_t near = maker.make(&scene, 1, 0, 128).version, far = maker.make(&scene, 1, 0, 256).version;
  EXPECT_NE(near, far);
  EXPECT_TRUE(maker.make(nullptr, 1, 0, 128).is_empty());
}

/// Moved triangles are those of a scenery that is made anew at that time; at the first time they are where they were.
TEST(Scenery, MovesWithItsThings) {
  physim::Scene scene;
  const ShapeId box = scene.add_shape(BoxShape{{1, 2, 3}}).value(), ball = scene.add_shape(SphereShape{1}).value();
  ASSERT_TRUE(scene.add({.shape = ball, .transform = {.position = {50, 1, 0}}, .sensor = true, .name = "gate"}));
  ASSERT_TRUE(scene.add({.shape = box, .name = "rests"}));
  const SteadyMotion motion{.velocity = {1, 2, -3}, .angular_velocity = {0.3, -0.5, 0.7}};
  const Transform at{.position = {10, 0, 5}, .rotation = {1, 0.2, 0.3, -0.1}, .scale = 2};
  ASSERT_TRUE(scene.add({.shape = box, .transform = at, .name = "turns", .motion = motion}));
  ASSERT_TRUE(scene.add({.shape = ball, .transform = at, .sensor = true, .motion = motion}));
  SceneryMaker moving;
  const std::vector<LitVertex> first = moving.make(&scene, 1, 0, 64).vertices;
  for (const double time : {0.5, 3.0, 0.0}) {
    const physim::Scene copy(scene);  // worlds copy a scene that a moment of them keeps
    const Scenery& moved = moving.make(&copy, 1, time, 64);
    SceneryMaker maker;
    const Scenery anew = maker.make(&scene, 1, time, 64);
    ASSERT_EQ(moved.vertices.size(), anew.vertices.size());
    ASSERT_EQ(moved.edges.size(), anew.edges.size());
    EXPECT_EQ(moved.solid, 72U);
    double farthest = 0;
    for (std::size_t i = 0; i < anew.vertices.size(); ++i)
      for (std::size_t axis = 0; axis < 3; ++axis) {
        const double a = moved.vertices[i].at[axis] + moved.origin[axis];
        EXPECT_NEAR(a, anew.vertices[i].at[axis] + anew.origin[axis], 1e-4);
        EXPECT_NEAR(moved.vertices[i].normal[axis], anew.vertices[i].normal[axis], 1e-5);
        farthest = std::max<double>(farthest, std::abs(moved.vertices[i].at[axis] - first[i].at[axis]));
      }
    EXPECT_EQ(farthest > 1, time > 0);
  }
}

TEST(Scenery, FitsIntoTheView) {
  for (const char* name : {"bullet_through_plank", "billiards"}) {
    Client client = client_of(name);
    client.fit_view();
    for (const Vec3d& corner : {client.scenery().low, client.scenery().high}) {
      const auto pixel = must(client.camera.project(corner), name);
      EXPECT_GE(std::min(pixel.x, pixel.y), 0) << name;
      EXPECT_LE(pixel.x, client.camera.width()) << name;
      EXPECT_LE(pixel.y, client.camera.height()) << name;
    }
  }
}

/// In a scenario that runs by itself a click selects what is there, and fires nothing.
TEST(Clicks, SelectWhereAWorldRuns) {
  for (const char* name : {"emit_fountain", "billiards"}) {
    Client client = client_of(name);
    ASSERT_TRUE(run(client, "wait 60")) << name;
    const std::size_t tracks = client.session.tracks().size();
    ASSERT_GT(tracks, 0U);
    const Track& track = client.session.tracks()[0];
    client.click(*client.camera.project(track.samples.back().position));
    EXPECT_EQ(client.session.changes_by_hand(), 0U) << name;
    EXPECT_TRUE(client.selected) << name;
    client.selected = {};
    client.click({2, 2});
    EXPECT_EQ(client.session.changes_by_hand(), 0U) << name;
    EXPECT_FALSE(client.selected) << name;
    EXPECT_NE(client.messages().back().text.find("Enter fires"), std::string::npos);
  }
  Client flights = client_of("golf_drive");
  flights.click({2, 2});
  EXPECT_EQ(flights.session.tracks().size(), 1U) << "elsewhere it fires";
}

/// Two posts down to the ground, as far apart as the radius; none of what hangs over things of its own.
TEST(Scenery, ATargetHasAStand) {
  Client client = client_of();
  client.placing.radius = 1;
  ASSERT_TRUE(run(client, "target 20 3 0"));
  const Scenery& scenery = client.scenery();
  double lowest = 1e9, left = 1e9, right = -1e9;
  for (const LitVertex& v : scenery.vertices) {
    const double y = v.at[1] + scenery.origin.y, z = v.at[2] + scenery.origin.z;
    lowest = std::min(lowest, y);
    if (y < 1.5) left = std::min(left, z), right = std::max(right, z);
  }
  EXPECT_NEAR(lowest, 0, 1e-5);
  EXPECT_NEAR(right - left, 1.07, 0.01);
  ASSERT_TRUE(run(client, "undo; wall 19 -2 21 -2; wall 19 2 21 2; target 20 3 0"));
  EXPECT_NEAR(client.scenery().low.y, 0, 1e-5);
}

// -------------------------------------------------------------------------------------------------------------- placed
/// Two clicks on the ground: the wall stands between them, stops what is fired at it, and is named in the list of hits.
TEST(Placing, AWallStandsBetweenTwoClicks) {
  Client client = client_of();
  ASSERT_TRUE(run(client, "wall; material oak"));
  client.placing.height = 3, client.placing.thickness = 0.2;
  const Vec3d from{14, 0, -4}, to{16, 0, 5};
  client.click(*client.camera.project(from));
  EXPECT_TRUE(client.session.scenario().things.empty());
  client.click(*client.camera.project(to));
  ASSERT_EQ(client.session.scenario().things.size(), 1U);
  EXPECT_EQ(client.tool, Tool::fire);
  EXPECT_TRUE(client.has_unsaved_settings());
  const physim::Scene& scene = *client.session.world().scene();
  const Vec3d along = normalized(to - from), across{along.z, 0, -along.x};
  for (const double part : {0.02, 0.5, 0.98})
    for (const double height : {0.05, 2.95}) {
      const Vec3d at = from + (to - from) * part + Vec3d{0, height, 0};
      const SceneHit hit = scene.first_hit({.from = at + across * 2, .to = at - across * 2});
      ASSERT_TRUE(hit) << part << " " << height;
      EXPECT_NEAR(length(hit.position - at), 0.1, 0.02);
    }
  EXPECT_FALSE(scene.any_hit({.from = from - along * 0.1 + across, .to = from - along * 0.1 - across}));
  ASSERT_TRUE(run(client, "fire; wait 60"));
  ASSERT_EQ(client.session.hits().hits().size(), 1U);
  EXPECT_EQ(client.session.hits().hits()[0].thing, "wall-1");
  EXPECT_EQ(client.session.hits().hits()[0].material, "oak");
  ASSERT_TRUE(run(client, "undo"));
  EXPECT_EQ(client.session.world().scene(), nullptr);
  EXPECT_TRUE(client.session.hits().hits().empty()) << "with what it was on";
  EXPECT_FALSE(run(client, "undo"));
}

/// A target on the predicted path faces the muzzle and is hit in its middle.
TEST(Placing, ATargetOnThePathIsHit) {
  Client client = client_of();
  const std::vector<TrackSample> path = client.prediction().path;
  const Vec3d middle = path[path.size() / 2].position;
  client.launcher.turn(0.3, 0);
  const Vec3d turned = client.prediction().path[path.size() / 2].position;
  ASSERT_TRUE(run(client, "target"));
  client.click(*client.camera.project(turned));
  ASSERT_EQ(client.session.scenario().things.size(), 1U);
  EXPECT_LT(length(client.session.scenario().things[0].position - turned), 0.5);
  EXPECT_GT(length(turned - middle), 1);
  ASSERT_TRUE(run(client, "fire; wait 90"));
  ASSERT_EQ(client.session.hits().hits().size(), 1U);
  const Hit& hit = client.session.hits().hits()[0];
  EXPECT_EQ(hit.thing, "target-1");
  EXPECT_LT(length(hit.position - client.session.scenario().things[0].position), 0.5);
  EXPECT_LT(hit.obliquity, 20 * kDegree) << "it faces the shot";
}

/// Redone, it is where it was, with what hit it; another one at another place was not hit.
TEST(Placing, HitsComeAgainWithTheirThing) {
  Client client = client_of();
  const std::vector<TrackSample> path = client.prediction().path;
  const Vec3d on_path = path[path.size() / 2].position;
  const auto target_at = [](const Vec3d& at) { return formatted("target %.6f %.6f %.6f", at.x, at.y, at.z); };
  ASSERT_TRUE(run(client, target_at(on_path) + "; fire; wait 90"));
  ASSERT_EQ(client.session.hits().hits().size(), 1U);
  const Track& track = client.session.tracks()[0];
  const TargetDisc target = targets_of(client.session.scenario())[0];
  const std::string report = report_of(target, client.session, track)->text(target.radius);
  EXPECT_TRUE(report.starts_with("hit")) << report;
  EXPECT_EQ(client.session.fate_of(track), "stopped by target-1");
  ASSERT_TRUE(run(client, "undo"));
  EXPECT_TRUE(client.session.hits().hits().empty());
  EXPECT_EQ(client.session.fate_of(client.session.tracks()[0]), "stopped by target-1") << "it was";
  ASSERT_TRUE(run(client, "redo"));
  ASSERT_EQ(client.session.hits().hits().size(), 1U);
  EXPECT_EQ(report_of(target, client.session, client.session.tracks()[0])->text(target.radius), report);
  ASSERT_TRUE(run(client, "undo; " + target_at(on_path + Vec3d{0, 0, 5})));
  EXPECT_EQ(client.session.scenario().things[0].name, "target-1");
  EXPECT_TRUE(client.session.hits().hits().empty()) << "it stands elsewhere";
}

/// A click on the place where a shot came down: all of the target is above the ground, and the same shot hits its
/// middle.
TEST(Placing, ATargetWhereAShotCameDownStandsOnTheGround) {
  Client client = client_of("golf_drive");
  ASSERT_TRUE(run(client, "fire-whole; wait 480; target"));
  const Track& drive = client.session.tracks().back();
  ASSERT_TRUE(drive.impact);
  client.click(*client.camera.project(drive.impact->position));
  ASSERT_EQ(client.session.scenario().things.size(), 1U);
  const Vec3d middle = client.session.scenario().things[0].position;
  EXPECT_GE(middle.y, client.placing.radius - 1e-9);
  EXPECT_LT(middle.x, drive.impact->position.x);
  ASSERT_TRUE(run(client, "fire; wait 480"));
  ASSERT_EQ(client.session.hits().hits().size(), 1U);
  EXPECT_LT(length(client.session.hits().hits()[0].position - middle), 0.1 * client.placing.radius);
}

TEST(Placing, TellsWhatCannotBe) {
  Client client = client_of();
  for (const char* bad : {"wall 1 2 3", "wall a b c d", "wall 1 1 1 1", "wall 0 0 0 0 0", "target 1 2",
                          "target 1 2 3 x", "material unobtainium"})
    EXPECT_FALSE(run(client, bad)) << bad;
  EXPECT_NE(run(client, "material cocnrete").error().text().find("concrete"), std::string::npos);
  EXPECT_TRUE(client.session.scenario().things.empty());
  const Folder folder;
  ASSERT_TRUE(run(client, "record " + (folder / "a.rec") + "; fire; wait 2; wall 20 -3 20 3; wait 40; record; replay"));
  while (!client.session.is_over()) client.session.single_step();
  EXPECT_FALSE(client.session.replay_report()->difference);
  ASSERT_EQ(client.session.hits().hits().size(), 1U) << "things that were put up are recorded";
  EXPECT_EQ(client.session.hits().hits()[0].thing, "wall-1");
  EXPECT_FALSE(run(client, "wall 10 -3 10 3")) << "a replay is not changed";
}

TEST(Placing, WholeFlightsDoNotGoThroughWalls) {
  Client client = client_of("arrow");
  ASSERT_TRUE(run(client, "wall 20 -3 20 3"));
  const Status status = run(client, "fire-whole");
  ASSERT_FALSE(status);
  EXPECT_NE(status.error().text().find("things"), std::string::npos) << status.error().text();
  ASSERT_TRUE(run(client, "undo; fire-whole; clear"));
}

/// What flies is not disturbed by what is put up where it is not.
TEST(Placing, ChangesNothingOfOtherFlights) {
  Client client = client_of(), other = client_of();
  ASSERT_TRUE(run(client, "sphere; fire; wait 10"));
  ASSERT_TRUE(run(other, "sphere; fire; wait 10; wall 0 50 5 50"));
  for (Client* each : {&client, &other}) ASSERT_TRUE(run(*each, "wait 30"));
  const auto &a = client.session.tracks()[0].samples, &b = other.session.tracks()[0].samples;
  ASSERT_EQ(a.size(), b.size());
  for (std::size_t i = 0; i < a.size(); ++i) EXPECT_EQ(a[i].position, b[i].position);
}

// --------------------------------------------------------------------------------------------------------------- saved
TEST(Save, KeepsWhatWasPutUpAndTheCommentsOfTheFile) {
  for (const char* name : {"bullet_through_plank", "billiards", "world_sparks"}) {
    const Folder folder;
    const std::string file = folder / "mine.toml", before = testing_cli::read(shipped(name));
    std::filesystem::copy_file(shipped(name), file);
    Client client = std::move(open_client(file, {}).value());
    ASSERT_TRUE(run(client, "material oak; wall 20 -3 21 3; material concrete; target 30 1 0; save"));
    const std::string text = testing_cli::read(file);
    EXPECT_TRUE(text.starts_with(before)) << name << ": what was there stays\n" << text;
    EXPECT_NE(text.find("[[shape]]\nname = \"wall-1\"", before.size() - 1), std::string::npos) << text;
    Client again = std::move(open_client(file, {}).value());
    EXPECT_TRUE(say_the_same(again.session.scenario(), client.session.scenario())) << name;
    EXPECT_EQ(again.session.world().scene()->hash(), scene_of(client.session.scenario()).value().hash()) << name;
    ASSERT_TRUE(run(client, "undo; undo; save"));
    EXPECT_EQ(testing_cli::read(file), before) << name;
  }
}

TEST(Save, OfAFlightWithThingsIsAWorld) {
  const Folder folder;
  Client client = client_of("golf_ball_no_spin");
  ASSERT_TRUE(run(client, "target 100 1 0; save " + (folder / "a.toml")));
  EXPECT_NE(client.messages().back().text.find("as a world"), std::string::npos) << client.messages().back().text;
  const Scenario saved = load_scenario(folder / "a.toml").value();
  EXPECT_TRUE(saved.world.given);
  EXPECT_TRUE(saved.expect.empty());
  ASSERT_EQ(saved.things.size(), 1U);
  EXPECT_EQ(saved.things[0].material, "concrete");
  Client range = client_of();
  ASSERT_TRUE(run(range, "wall 10 -3 10 3; save " + (folder / "b.toml") + "; target 5 1 0; save"));
  Client again = std::move(open_client(folder / "b.toml", {}).value());
  EXPECT_EQ(again.session.scenario().things.size(), 2U);
  EXPECT_EQ(again.session.world().scene()->hash(), range.session.world().scene()->hash());
}

}  // namespace
}  // namespace physim::client
