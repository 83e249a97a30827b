// The client's logic without a window: launcher, actions, scripts, settings, plots, camera, scene.
#include "simclient/core/client.hpp"

#include <cmath>
#include <map>
#include <set>

#include "cli/program.hpp"
#include "client/support.hpp"
#include "physim/names.hpp"
#include "report/format.hpp"
#include "report/ladder.hpp"
#include "simclient/core/actions.hpp"
#include "simclient/core/layout.hpp"
#include "simclient/core/original_tests.hpp"
#include "simclient/core/scene.hpp"

namespace physim::client {
namespace {

// ------------------------------------------------------------------------------------------------------------ launcher
TEST(Launcher, OriginalShotsHaveTheirVelocities) {
  Client client = client_of();
  const struct {
    const char* name;
    double forward, up;
  } shots[] = {{"artillery", 40, 2}, {"bullet", 35, 1}, {"laser", 35, 1}};
  for (const auto& shot : shots) {
    ASSERT_TRUE(client.launcher.select(shot.name));
    for (int i = 0; i < 6; ++i) {
      const int e = client.launcher.elevation_setting().value();
      const Vec3d v = client.prediction().velocity;
      EXPECT_NEAR(v.x, shot.forward, 1e-5) << shot.name << e;
      EXPECT_NEAR(v.y, shot.up * e, 1e-5) << shot.name << e;
      client.launcher.cycle_elevation();
    }
  }
}

TEST(Launcher, AScenarioComesFirstToHand) {
  Client client = client_of("308_168gr_g7");
  EXPECT_EQ(client.launcher.shot().projectile.name, "308-168gr");
  EXPECT_EQ(client.launcher.elevation_text(), "zeroed at 100 m");
  client.launcher.turn(0, 0.1);  // above the zero, which stays
  EXPECT_EQ(client.launcher.shot().launch.sight.zero_range, 100);
  EXPECT_NEAR(client.launcher.elevation(), 0.1, 1e-12);
  EXPECT_EQ(client.launcher.elevation_text(), "zeroed at 100 m, +5.73\u00b0");
}

TEST(Launcher, AZeroIsAimedFrom) {
  Client client = client_of("308_168gr_g7");
  const auto slope = [&] {
    const Vec3d v = client.prediction().velocity;
    return std::atan2(v.y, std::hypot(v.x, v.z));
  };
  const double zeroed = slope();
  client.launcher.turn(0.02, 0.003);
  EXPECT_NEAR(slope() - zeroed, 0.003, 1e-6);
  EXPECT_NEAR(client.launcher.azimuth(), 0.02, 1e-12);
  ASSERT_TRUE(client.fire());
  EXPECT_EQ(client.session.world()[client.selected].velocity(), client.prediction().velocity);
  client.launcher.turn(-0.02, -0.003);
  EXPECT_NEAR(slope(), zeroed, 1e-12);
  client.launcher.cycle_elevation();
  EXPECT_EQ(client.launcher.shot().launch.sight.zero_range, 100);
  EXPECT_NEAR(slope() - zeroed, 5 * 0.017453292519943295, 1e-6);
}

/// Sights are zeroed on the level and raised with the rifle: the shot in hand is that of the flight.
TEST(Launcher, AZeroBesideALookAngleIsThatOfTheFlight) {
  Client client = client_of("308_168gr_g7");
  ScenarioShot shot = client.launcher.shot();
  shot.launch.sight.look_angle = 0.5;
  client.launcher.set_shot(shot);
  const auto slope = [&] {
    const Vec3d v = client.prediction().velocity;
    return std::atan2(v.y, std::hypot(v.x, v.z));
  };
  const double zeroed = slope();
  EXPECT_NEAR(zeroed, 0.5, 0.005);
  client.launcher.turn(0, 0.003);
  EXPECT_NEAR(slope() - zeroed, 0.003, 1e-9);
}

/// Panels keep what they read by the version: another scenario must never look like the one before.
TEST(Launcher, VersionsRiseAcrossScenarios) {
  Client client = client_of();
  for (const char* scenario : {"arrow", "308_168gr_g7", "arrow"}) {
    const std::uint64_t before = client.launcher.version();
    ASSERT_TRUE(client.open(PHYSIM_SOURCE_DIR "/scenarios/" + std::string(scenario) + ".toml"));
    EXPECT_GT(client.launcher.version(), before);
  }
}

TEST(Launcher, TurningAVelocityKeepsItsSpeed) {
  Client client = client_of("original_bullet");
  ASSERT_TRUE(client.launcher.shot().launch.velocity);
  const double speed = client.launcher.speed(), azimuth = client.launcher.azimuth();
  client.launcher.turn(0.2, 0);
  EXPECT_NEAR(client.launcher.speed(), speed, 1e-12);
  EXPECT_NEAR(client.launcher.azimuth(), azimuth + 0.2, 1e-12);
}

// ------------------------------------------------------------------------------------------------------------- actions
TEST(Actions, HaveNamesKeysAndHelpOfTheirOwn) {
  std::set<std::string_view> names;
  std::set<std::string> keys;
  for (const Action& action : actions()) {
    EXPECT_TRUE(names.insert(action.name).second) << action.name;
    EXPECT_FALSE(action.help.empty()) << action.name;
    EXPECT_NE(action.run, nullptr);
    std::istringstream in{std::string(action.keys)};
    for (std::string key; in >> key;) {
      EXPECT_TRUE(keys.insert(key).second) << key << " is taken twice";
      const bool ctrl = key.starts_with("Ctrl+");
      EXPECT_EQ(action_of_key(ctrl ? key.substr(5) : key, ctrl), &action) << key;
    }
  }
}

TEST(Actions, LettersCountInEitherCase) {
  for (const char* key : {"e", "E"}) EXPECT_EQ(action_of_key(key, false)->name, "elevation");
  for (const char* key : {"p", "P", "space", "Space"}) EXPECT_EQ(action_of_key(key, false)->name, "pause");
  EXPECT_EQ(action_of_key("Q", false)->name, action_of_key("q", false)->name);
  EXPECT_EQ(action_of_key("no key", false), nullptr);
  EXPECT_EQ(action_of_key("s", true)->name, "save");
}

TEST(Actions, EveryOneRunsWithoutAWindow) {
  const testing_cli::Folder folder;
  for (const Action& action : actions()) {
    Client client = client_of();
    ASSERT_TRUE(run(client, "fire; wait 3"));
    std::string argument = action.argument == "FILE" ? folder / std::string(action.name) : "";
    if (action.name == "open") argument = PHYSIM_SOURCE_DIR "/scenarios/arrow.toml";
    if (action.name == "shot") argument = "laser";
    if (action.name == "set") argument = "shot.mass=3 kg";
    if (action.name == "plot") argument = "speed";
    if (action.name == "test") argument = "1";
    if (action.name == "material") argument = "oak";
    if (action.name == "study-input") argument = "shot.speed = +- 3 m/s";
    if (action.name == "study-target") argument = "circle 10 cm";
    if (action.name == "study-at") argument = "apex: y, time";
    if (action.name == "study-show") argument = "end";
    if (action.name == "study-shots") argument = "1000";
    if (action.name == "seek") argument = "0.02";
    if (action.name == "speed" || action.name == "picture-size" || action.name == "film-length") argument = "4";
    if (action.name == "study-run" || action.name == "study-again") {
      ASSERT_TRUE(run(client, "study-input shot.speed = +- 1 m/s"));
    }
    if (action.name == "replay" || action.name == "fire-scenario" || action.name == "undo" || action.name == "redo")
      continue;  // there is nothing of the kind yet
    const Status status = action.run(client, argument);
    EXPECT_TRUE(status) << action.name << ": " << status.error().text();
  }
}

TEST(Actions, StandInTheDocumentation) {
  const std::string page = testing_cli::read(PHYSIM_SOURCE_DIR "/docs/client_actions.md");
  EXPECT_NE(page.find(actions_table()), std::string::npos)
      << "docs/client_actions.md is out of date: put in what simclient --list-actions prints";
}

// ------------------------------------------------------------------------------------------------------------- scripts
TEST(Script, SaysWhatIsWrongAndWhere) {
  const struct {
    const char *text, *says;
  } bad[] = {{"fire; fyre", "script, action 2: error: there is no action \"fyre\"; did you mean \"fire\"?"},
             {"wait", "wait needs a number of frames"},
             {"wait x", "wait needs a number of frames"},
             {"wait -1", "wait needs a number of frames"},
             {"fire 3", "fire takes nothing, but was given \"3\""}};
  for (const auto& each : bad) {
    const Result<Script> script = Script::parse(each.text);
    ASSERT_FALSE(script) << each.text;
    EXPECT_NE(script.error().text().find(each.says), std::string::npos) << script.error().text();
  }
  for (const char* text : {"set shot.mas=1", "set shot.mass=1 s", "shot nobody", "plot nothing", "test 7",
                           "open x.toml", "save /nowhere/x.toml", "fire-scenario", "replay"}) {
    Client client = client_of();
    EXPECT_FALSE(run(client, text)) << text;
  }
}

TEST(Script, WaitsFrames) {
  Client client = client_of();
  ASSERT_TRUE(run(client, "# a comment\nfire\nwait 30; fire"));
  ASSERT_EQ(client.session.tracks().size(), 2U);
  EXPECT_NEAR(client.session.tracks()[1].born, 0.5, 1e-9);
}

// ------------------------------------------------------------------------------------------------------------ settings
TEST(SettingRows, AreAllOfTheListForAShot) {
  std::set<std::string> rows;
  for (const SettingRow& row : setting_rows("shot")) {
    EXPECT_FALSE(row.doc.empty()) << row.path;
    rows.insert(row.path);
  }
  for (const Setting& setting : settings()) {
    const bool in_list =  // a row of its own for each list
        setting.path.starts_with("shot.drag.bands.") || setting.path.starts_with("shot.magnus.table.");
    if (!setting.path.starts_with("shot.") || in_list) continue;
    EXPECT_EQ(rows.count(setting.path), 1U) << setting.path;
  }
}

TEST(SettingRows, WhatIsShownCanBeTypedIn) {
  Client client = client_of("308_168gr_g7");
  for (const char* table : {"shot", "environment"})
    for (const SettingRow& row : setting_rows(table)) {
      const auto text = row_text(row, client.session.scenario(), client.launcher.shot());
      if (!text || row.path == "shot.fidelity.cheapest_within") continue;
      const Status status = client.set(row, *text);
      EXPECT_TRUE(status) << row.path << " = " << *text << ": " << status.error().text();
      EXPECT_EQ(row_text(row, client.session.scenario(), client.launcher.shot()), text) << row.path;
    }
}

TEST(SettingRows, ShowNumbersThatFitIntoTheirField) {
  Client client = client_of();
  ASSERT_TRUE(client.set("shot.elevation = 35 deg"));
  ASSERT_TRUE(client.set("shot.position = 1 ft, 2, 1e-12"));
  for (const SettingRow& row : setting_rows("shot")) {
    const auto text = row_text(row, client.session.scenario(), client.launcher.shot());
    if (row.path == "shot.elevation") {
      EXPECT_EQ(text, "35 deg");
    }
    if (row.path == "shot.position") {
      EXPECT_EQ(text, "0.3048 m, 2 m, 1e-12 m");
    }
  }
  EXPECT_EQ(client.launcher.shot().launch.elevation, 35 * 0.017453292519943295);
}

TEST(SettingRows, UnderstandUnitsAndRefuseNonsense) {
  Client client = client_of();
  ASSERT_TRUE(client.set("shot.mass = 168 gr"));
  EXPECT_NEAR(client.launcher.shot().projectile.mass, 0.010886, 1e-6);
  ASSERT_TRUE(client.set("shot.position = 1 m, 2 ft, 0"));
  EXPECT_NEAR(client.launcher.shot().launch.position.y, 0.6096, 1e-12);
  EXPECT_FALSE(client.set("shot.mass=-1 kg"));
  EXPECT_FALSE(client.set("shot.fidelity.drag=water"));
  EXPECT_NEAR(client.launcher.shot().projectile.mass, 0.010886, 1e-6) << "a refused value changed something";
  ASSERT_TRUE(client.set("environment.wind.velocity=0, 0, 5 m/s"));
  EXPECT_EQ(client.session.scenario().environment.wind.velocity.z, 5);
}

TEST(SettingRows, NameThemselvesOnceInErrors) {
  Client client = client_of();
  std::size_t refused = 0;
  for (const char* table : {"shot", "environment"})
    for (const SettingRow& row : setting_rows(table)) {
      const Status status = client.set(row, "-1 parsec");
      if (status || row.path == "shot.motor.file") continue;  // names, of shots and of files
      ++refused;
      std::string text = status.error().text();
      text.resize(std::min(text.find("; "), text.size()));  // hints to lists name them again
      EXPECT_TRUE(text.starts_with(row.path + ": error: ")) << text;
      EXPECT_EQ(text.find(row.path, row.path.size()), text.npos) << text;
    }
  EXPECT_GT(refused, 50U);
}

// ---------------------------------------------------------------------------------------------------------------- save
TEST(Save, WritesAScenarioThatFiresTheSameShot) {
  const testing_cli::Folder folder;
  Client client = client_of();
  ASSERT_TRUE(run(client, "artillery; elevation; save " + (folder / "a.toml")));
  Client again = std::move(open_client(folder / "a.toml", {}).value());
  EXPECT_EQ(again.launcher.shot().projectile, client.launcher.shot().projectile);
  EXPECT_EQ(again.launcher.shot().body, client.launcher.shot().body);
  EXPECT_EQ(again.prediction().velocity, client.prediction().velocity);
}

TEST(Save, CsvHasEverySample) {
  const testing_cli::Folder folder;
  Client client = client_of();
  ASSERT_TRUE(run(client, "laser; fire; wait 10; save-csv " + (folder / "a.csv")));
  std::istringstream in(testing_cli::read(folder / "a.csv"));
  std::string line;
  std::getline(in, line);
  EXPECT_EQ(line.substr(0, 30), "number,name,time [s],x [m],y [");
  std::size_t lines = 0;
  for (std::string next; std::getline(in, next); ++lines) line = next;
  EXPECT_EQ(lines, client.session.tracks()[0].samples.size() - 1);  // one step more was taken after it was saved
  EXPECT_NEAR(std::stod(line.substr(line.find("laser,") + 6)), 10.0 / 60, 1e-9);
}

TEST(Save, EveryFormatOfRecordsByItsEnding) {
  const testing_cli::Folder folder;
  Client client = client_of();
  ASSERT_TRUE(run(client, "laser; fire; wait 10"));
  for (const report::Format& format : report::formats()) {
    const std::string file = folder / ("flights" + std::string(format.ending));
    const bool is_known = can_write(format, report::Subject::records) || format.ending.ends_with(".csv");
    EXPECT_EQ(client.save_flights(file).ok(), is_known) << format.name;
    EXPECT_EQ(testing_cli::read(file).size() > 100, is_known) << format.name;
  }
}

TEST(Record, ReplaysAndComesBack) {
  const testing_cli::Folder folder;
  Client client = client_of("arrow");
  ASSERT_TRUE(run(client, "fire; wait 5; record " + (folder / "a.rec") + "; wait 2; fire; wait 10"));
  EXPECT_TRUE(client.session.is_recording());
  EXPECT_EQ(client.session.tracks().size(), 1U) << "a recording starts anew";
  const Vec3d last = client.session.tracks()[0].samples[5].position;
  ASSERT_TRUE(run(client, "record; replay; wait 30"));
  ASSERT_TRUE(client.session.is_replay());
  ASSERT_EQ(client.session.tracks().size(), 1U);
  EXPECT_EQ(client.session.tracks()[0].samples[5].position, last);
  EXPECT_TRUE(client.session.is_over());
  EXPECT_FALSE(run(client, "fire")) << "a replay cannot be changed";
  EXPECT_FALSE(run(client, "record x.rec"));
  ASSERT_TRUE(run(client, "replay"));
  EXPECT_FALSE(client.session.is_replay());
  EXPECT_EQ(client.launcher.shot().projectile.name, client_of("arrow").launcher.shot().projectile.name);
  ASSERT_TRUE(run(client, "open " + (folder / "a.rec")));
  EXPECT_TRUE(client.session.is_replay());
}

// --------------------------------------------------------------------------------------------------------------- plots
TEST(Plots, AxesAreRoundAndHoldEverything) {
  const struct {
    double low, high;
  } ranges[] = {{0, 1}, {-3.2, 17}, {0.0012, 0.0019}, {1e6, 3e6}, {5, 5}, {0, 0}, {-1e-7, 1e-7}};
  for (const auto& r : ranges)
    for (const int wanted : {2, 5, 10}) {
      const PlotAxis axis = make_axis(r.low, r.high, wanted);
      EXPECT_LE(axis.low, r.low + 1e-9 * std::abs(r.low));
      EXPECT_GE(axis.high, r.high - 1e-9 * std::abs(r.high));
      const double mantissa = axis.step / std::pow(10.0, std::floor(std::log10(axis.step) + 1e-9));
      EXPECT_TRUE(std::abs(mantissa - 1) < 1e-6 || std::abs(mantissa - 2) < 1e-6 || std::abs(mantissa - 5) < 1e-6);
      EXPECT_LE(axis.ticks().size(), static_cast<std::size_t>(wanted) + 3);
      std::set<std::string> texts;
      for (const double tick : axis.ticks()) texts.insert(axis.text(tick));
      EXPECT_EQ(texts.size(), axis.ticks().size()) << "two ticks read the same";
    }
}

TEST(Plots, CurvesAreTheFlight) {
  Client client = client_of();
  ASSERT_TRUE(run(client, "laser; fire; wait 30"));
  const Track* track = &client.session.tracks()[0];
  const std::vector<PlotSpec> specs = parse_plots("y/x speed energy/range").value();
  const Plot path = make_plot(specs[0], client.session.tracks(), nullptr, client.session.scenario(), 5, 5);
  ASSERT_EQ(path.curves.size(), 1U);
  ASSERT_EQ(path.curves[0].points.size(), track->samples.size());
  for (const PlotPoint& p : path.curves[0].points) EXPECT_NEAR(p.y, 1.5 + 2 * p.x / 35, 1e-5);  // e = 2
  const Plot energy = make_plot(specs[2], client.session.tracks(), track, client.session.scenario(), 5, 5);
  EXPECT_NEAR(energy.curves[0].points.back().y, 0.5 * (35 * 35 + 4), 1e-2);
  const auto hit = must(nearest_point(path, {path.x.part(0), path.y.part(1.5)}, 2, 0.1));
  EXPECT_EQ(hit.point.x, 0);
  EXPECT_FALSE(nearest_point(path, {5, 5}, 2, 0.1));
}

TEST(Plots, ShowWhatWasPublished) {
  Client client = client_of();
  ASSERT_TRUE(open_original_test(client, "1"));
  EXPECT_EQ(client.bottom, BottomPanel::plots);
  const Plot plot = make_plot(client.plots[0], client.session.tracks(), nullptr, client.session.scenario(), 5, 5);
  ASSERT_EQ(plot.expected.size(), 6U) << "z of the six rows of table 5-2";
  EXPECT_EQ(plot.expected[1].point.y, 15.395968);
  for (const PlotMark& mark : plot.expected) EXPECT_TRUE(mark.published);
}

TEST(Plots, TellWhatWasPublishedFromWhatIsExpected) {
  Client client = client_of();
  ASSERT_TRUE(open_original_test(client, "6"));
  const auto marks_of = [&](const char* quantity) {
    return make_plot(parse_plots(quantity).value()[0], client.session.tracks(), nullptr, client.session.scenario(), 5,
                     5)
        .expected;
  };
  const std::vector<PlotMark> heights = marks_of("y");
  EXPECT_EQ(std::ranges::count(heights, true, &PlotMark::published), 6) << "rows of table 5-7";
  EXPECT_EQ(std::ranges::count(heights, false, &PlotMark::published), 8) << "closed form of two shots, by hand";
  for (const char* quantity : {"ay", "az", "speed"}) {
    const std::vector<PlotMark> marks = marks_of(quantity);
    EXPECT_EQ(marks.size(), 6U) << quantity;
    for (const PlotMark& mark : marks) EXPECT_TRUE(mark.published) << quantity;
  }
  ASSERT_EQ(client.plots.size(), 6U);
  EXPECT_EQ(plot_quantities()[client.plots[4].y].name, "az");
  EXPECT_EQ(plot_quantities()[client.plots[5].y].name, "speed");
  // Orange is as published, here and in the pictures of the command line.
  EXPECT_EQ(client.session.tracks()[0].colour, 0xE69F00FFU);
}

// ------------------------------------------------------------------------------------------------------------- compare
TEST(Compare, MeasuresAgainstTheTruth) {
  Client client = client_of("308_168gr_g7");
  const std::vector<ComparedRung>& rungs = client.comparison();
  ASSERT_EQ(rungs.size(), 5U);
  EXPECT_TRUE(rungs.back().is_truth);
  EXPECT_EQ(rungs.back().farthest, 0);
  EXPECT_EQ(rungs[1].name, "game");
  EXPECT_GT(rungs[1].farthest, 1) << "a bullet to 1000 m with k1 k2 drag";
  EXPECT_LT(rungs[3].farthest, 0.1);
  for (const ComparedRung& rung : rungs) {
    EXPECT_GT(rung.per_step, 0) << rung.name;
    ASSERT_TRUE(rung.in_frames) << rung.name;
  }
  // The same bullet in frames of a game: the reference of a world has no drift by formula, 0.36 m at 1000 m.
  EXPECT_GT(*rungs[1].in_frames, 1);
  EXPECT_LT(*rungs[3].in_frames, *rungs[1].in_frames);
  EXPECT_NEAR(*rungs.back().in_frames, 0.36, 0.02);
  ASSERT_TRUE(client.fire_compared());
  ASSERT_EQ(client.session.tracks().size(), 5U);
  for (std::size_t i = 0; i < rungs.size(); ++i) EXPECT_EQ(client.session.tracks()[i].colour, rungs[i].colour) << i;
  EXPECT_EQ(client.session.tracks()[1].granted.fidelity.drag, DragModel::linear_quadratic);
}

/// One more preset recolours none of the others, and no two of all have one colour.
TEST(Compare, KeepsTheColoursOfItsRungs) {
  Client client = client_of("arrow");
  std::map<std::string, Colour> before;
  for (const ComparedRung& rung : client.comparison()) before[rung.name] = rung.colour;
  client.compared.assign(fidelity_presets().begin(), fidelity_presets().end());
  std::set<Colour> all;
  for (const ComparedRung& rung : client.comparison()) {
    EXPECT_TRUE(all.insert(rung.colour).second) << rung.name;
    EXPECT_NE(rung.colour, kNoColour) << rung.name;
    EXPECT_EQ(rung.colour, before.contains(rung.name) ? before[rung.name] : rung.colour) << rung.name;
  }
  EXPECT_EQ(all.size(), fidelity_presets().size() + 1);
}

TEST(Compare, HasTheFiguresOfTheCommandLine) {
  Client client = client_of("308_168gr_g7");
  const std::vector<ComparedRung>& rungs = client.comparison();
  const auto ladder = must(report::climb(client.session.scenario(), client.launcher.shot()));
  int compared = 0;
  for (const ComparedRung& rung : rungs)
    for (const report::RungResult& other : ladder.rungs)
      if (other.rung.name() == rung.name) {
        EXPECT_EQ(rung.at_end, other.error) << rung.name;
        EXPECT_EQ(std::abs(rung.later), other.time_error) << rung.name;
        EXPECT_EQ(rung.path.back().position, other.flight.end().position) << rung.name;
        ++compared;
      }
  EXPECT_EQ(compared, 4) << "all but the shot as it is set";
}

// -------------------------------------------------------------------------------------------------------------- camera
TEST(Camera, PixelsAndPointsAgree) {
  Camera camera;
  camera.set_viewport(900, 500);
  for (const double stretch : {1.0, 20.0})
    for (const double yaw : {0.0, 1.0, -2.5}) {
      camera.yaw = yaw, camera.pitch = 0.4, camera.stretch = stretch, camera.target = {10, 1, -3};
      const auto centre = must(camera.project(camera.target));
      EXPECT_NEAR(centre.x, 450, 1e-9);
      EXPECT_NEAR(centre.y, 250, 1e-9);
      const auto point = must(camera.at_height({300, 420}, 0));
      const auto back = camera.project(point);
      EXPECT_NEAR(back->x, 300, 1e-6);
      EXPECT_NEAR(back->y, 420, 1e-6);
      EXPECT_FALSE(camera.project(camera.eye() - camera.forward() * 5.0));
    }
}

TEST(Camera, MatrixIsTheProjection) {
  Camera camera;
  camera.set_viewport(900, 500);
  const Vec3d point{20, 4, 2}, way = camera.shown(point) - camera.eye();
  const Mat4 m = camera.matrix();
  const auto row = [&](std::size_t i) { return m[i] * way.x + m[4 + i] * way.y + m[8 + i] * way.z + m[12 + i]; };
  const auto pixel = camera.project(point);
  EXPECT_NEAR((row(0) / row(3) + 1) * 450, pixel->x, 1e-2);
  EXPECT_NEAR((1 - row(1) / row(3)) * 250, pixel->y, 1e-2);
}

TEST(Camera, FitShowsAll) {
  for (const char* scenario : {"", "308_168gr_g7", "lob_16km", "golf_ball_no_spin"}) {
    Client client = client_of(scenario);
    for (const CameraMode mode : {CameraMode::orbit, CameraMode::side}) {
      client.camera.mode = mode;
      client.fit_view();
      for (const TrackSample& s : client.prediction().path) {
        const auto pixel = must(client.camera.project(s.position));
        EXPECT_GE(std::min(pixel.x, pixel.y), 0) << scenario;
        EXPECT_LE(pixel.x, client.camera.width()) << scenario;
        EXPECT_LE(pixel.y, client.camera.height()) << scenario;
      }
    }
  }
}

// --------------------------------------------------------------------------------------------------------------- scene
TEST(Scene, ScaleLinesStandAtTheirDistances) {
  Client client = client_of();
  Scene scene;
  build_scene(client, 1, scene);
  int labels = 0;
  for (const SceneLabel& label : scene.labels) {
    double metres = 0;
    if (std::sscanf(label.text.c_str(), "%lf m", &metres) != 1 || label.text != distance_text(metres)) continue;
    EXPECT_NEAR(label.at.x, metres, 1e-9) << label.text;
    EXPECT_EQ(label.at.y, 0);
    ++labels;
  }
  EXPECT_GT(labels, 10);
}

TEST(Scene, ProbeAndTapeMeasureFindTheirPoints) {
  Client client = client_of();
  ASSERT_TRUE(run(client, "laser; fire; wait 30; tape"));
  const TrackSample s = client.session.tracks()[0].samples[20];
  const auto seen = must(client.camera.project(s.position));
  const auto probe = must(client.probe(seen));
  EXPECT_LT(length(probe.sample.position - s.position), 1.5);
  client.click(seen);
  ASSERT_TRUE(client.tape.from);
  const auto ground = client.camera.project({10, 0, 3});
  client.click(*ground);
  ASSERT_TRUE(client.tape.to);
  EXPECT_NEAR(client.tape.to->x, 10, 1e-6);
  EXPECT_NEAR(client.tape.to->z, 3, 1e-6);
  EXPECT_EQ(client.session.tracks().size(), 1U) << "measuring fires nothing";
  Scene scene;
  build_scene(client, 1, scene);
  const double apart = length(*client.tape.to - *client.tape.from);
  char text[32];
  std::snprintf(text, sizeof text, "%.3f m", apart);
  bool found = false;
  for (const SceneLabel& label : scene.labels) found = found || label.text == text;
  EXPECT_TRUE(found) << text;
}

TEST(Scene, VectorsPointAlongWhatTheyShow) {
  Client client = client_of("golf_ball_no_spin");
  ASSERT_TRUE(run(client, "fire; wait 30; vectors"));
  Scene scene;
  build_scene(client, 1, scene);
  const Vec3d at = client.session.shown_position(client.selected_track()->id);
  const Vec3d v = client.session.world()[client.selected_track()->id].velocity();
  bool found = false;
  for (const SceneLine& line : scene.lines)
    if (line.colour == colours::kVelocity && length(line.a - at) < 1e-9)
      found = length(cross(line.b - line.a, v)) < 1e-6 * length(line.b - line.a) * length(v);
  EXPECT_TRUE(found);
  std::set<std::string> labels;
  for (const SceneLabel& label : scene.labels) labels.insert(label.text.substr(0, label.text.find(' ')));
  for (const char* each : {"v", "a", "gravity", "drag"}) EXPECT_EQ(labels.count(each), 1U) << each;
}

// -------------------------------------------------------------------------------------------------------------- layout
bool overlap(const Box& a, const Box& b) {
  return a.x < b.x + b.width && b.x < a.x + a.width && a.y < b.y + b.height && b.y < a.y + a.height;
}

TEST(Layout, NothingOverlapsAtAnySize) {
  Client client = client_of();
  for (const BottomPanel bottom : {BottomPanel::none, BottomPanel::plots})
    for (const int panels : {0, 1, 2, 3})
      for (const float scale : {1.0F, 1.5F, 2.0F, 3.0F})
        for (const float width : {480 * scale, 640 * scale, 800 * scale, 1280.0F * scale, 3840.0F * scale})
          for (const float height : {320 * scale, 720 * scale, 2160 * scale}) {
            client.bottom = bottom;
            client.show.settings = (panels & 1) != 0, client.show.statistics = (panels & 2) != 0;
            const Layout l = make_layout(client, width, height, scale);
            const Box boxes[] = {l.menu, l.settings, l.statistics, l.bottom, l.play, l.status, l.scene};
            for (const Box& box : boxes) {
              EXPECT_GE(std::min(box.x, box.y), 0);
              EXPECT_LE(box.x + box.width, width + 0.01F);
              EXPECT_LE(box.y + box.height, height + 0.01F);
              for (const Box& other : boxes)
                if (&box != &other && box.width * box.height > 0 && other.width * other.height > 0) {
                  EXPECT_FALSE(overlap(box, other)) << width << "x" << height << " at " << scale;
                }
            }
            EXPECT_GE(l.scene.width, 239 * scale) << "the scene stays";
            const float beside = l.scene.width * (l.scene.height + l.bottom.height);
            EXPECT_GE(beside, 0.599F * width * height) << width << "x" << height << " at " << scale;
            EXPECT_GE(l.scene.height, 100 * scale);
          }
}

}  // namespace
}  // namespace physim::client
