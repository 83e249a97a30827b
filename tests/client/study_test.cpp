// Studies in the client: the figures of `physim study`, that grow from frame to frame.
#include <chrono>
#include <cmath>
#include <thread>

#include "cli/program.hpp"
#include "client/support.hpp"
#include "simclient/core/actions.hpp"
#include "simclient/core/layout.hpp"
#include "simclient/core/state_log.hpp"
#include "simclient/core/study_view.hpp"

namespace physim::client {
namespace {

using State = StudyRun::State;

StudyResult flown(const std::string& scenario, std::int64_t shots, const std::optional<StudyWidth>& width = {},
                  const std::vector<std::string>& at = {}) {
  Scenario read = load_scenario(PHYSIM_SOURCE_DIR "/scenarios/" + scenario + ".toml").value();
  read.study.shots = shots;
  read.study.at = at;
  Study study = study_of(read, read.shots[0]).value();
  study.until_width = width;
  return run_study(study).value();
}

void expect_same(const StudyResult& a, const StudyResult& b) {
  EXPECT_EQ(a.shards, b.shards);
  EXPECT_EQ(a.shots, b.shots);
  EXPECT_EQ(a.quantities, b.quantities);
  EXPECT_EQ(a.hits, b.hits);
  EXPECT_EQ(a.from_centre, b.from_centre);
  EXPECT_EQ(a.ellipse, b.ellipse);
  EXPECT_EQ(a.stages, b.stages);
  ASSERT_EQ(a.at.size(), b.at.size());
  for (std::size_t i = 0; i < a.at.size(); ++i) expect_same(a.at[i], b.at[i]);
}

TEST(StudyRun, comes_to_the_figures_of_physim_study) {
  Client client = client_of("study_308");
  ASSERT_TRUE(run(client, "study-shots 20000; study-run; wait 7"));
  ASSERT_EQ(client.study.run.state(), State::done);
  ASSERT_TRUE(client.study.run.result().has_value());
  expect_same(*client.study.run.result(), flown("study_308", 20000));
}

TEST(StudyRun, grows_by_a_shard_a_frame_where_scripts_look) {
  Client client = client_of("study_308");
  ASSERT_TRUE(run(client, "study-shots 40000; study-run"));
  std::size_t dots = client.study.run.dots_shown();
  for (std::uint64_t shards = 1; shards < 4; ++shards) {
    ASSERT_TRUE(client.study.run.result().has_value());
    EXPECT_EQ(client.study.run.result()->shards, shards);
    expect_same(*client.study.run.result(), flown("study_308", static_cast<std::int64_t>(4096 * shards)));
    client.advance(1.0 / 60);
    EXPECT_GT(client.study.run.dots_shown(), dots);
    dots = client.study.run.dots_shown();
  }
  const StudyShots first = fly_shots_of(*client.study.run.plan(), 0);
  EXPECT_EQ(client.study.run.dots().quantities[1][4095], first.quantities[1][4095]);
}

TEST(StudyRun, pauses_and_goes_on_with_the_same_bits) {
  Client client = client_of("study_308");
  ASSERT_TRUE(run(client, "study-shots 20000; study-run; wait 2; study-run"));
  EXPECT_EQ(client.study.run.state(), State::paused);
  const std::uint64_t shots = client.study.run.result()->shots;
  ASSERT_TRUE(run(client, "wait 3"));
  EXPECT_EQ(client.study.run.result()->shots, shots) << "a pause";
  ASSERT_TRUE(run(client, "study-run; wait 7"));
  EXPECT_EQ(client.study.run.state(), State::done);
  expect_same(*client.study.run.result(), flown("study_308", 20000));
}

TEST(StudyRun, flies_on_threads_while_frames_go_on) {
  Client client = client_of("study_308");
  ASSERT_TRUE(set_study_shots(client, "40000"));
  ASSERT_TRUE(start_or_pause_study(client));
  for (int i = 0; i < 60'000 && client.study.run.state() == State::running; ++i) {
    client.advance(1e-3, 0.01);
    std::this_thread::sleep_for(std::chrono::milliseconds(1));
  }
  ASSERT_EQ(client.study.run.state(), State::done);
  expect_same(*client.study.run.result(), flown("study_308", 40000));
  EXPECT_EQ(client.study.run.dots().quantities[0].size(), StudyRun::kMostDots);
}

TEST(StudyRun, ends_at_a_width_where_physim_study_does) {
  Client client = client_of("study_308");
  ASSERT_TRUE(run(client, "study-shots 1000000; study-width 1.1 %; study-run; wait 40"));
  ASSERT_EQ(client.study.run.state(), State::done);
  EXPECT_TRUE(client.study.run.result()->width_reached);
  expect_same(*client.study.run.result(), flown("study_308", 1'000'000, StudyWidth{.target = 0, .width = 0.011}));
}

/// On its way and done: figures of run_study(), dots of shards one by one, slopes of a study that ends there.
TEST(StudyRun, is_told_at_places_with_the_bits_of_run_study) {
  const std::vector<std::string> at = {"300 m", "apex", "speed 500 m/s: y, time"};
  Client client = client_of("study_308");
  ASSERT_TRUE(run(client, "study-at 300 m; study-at apex; study-at speed 500 m/s: y, time"));
  ASSERT_EQ(client.study.asked.at, at);
  ASSERT_TRUE(run(client, "study-shots 20000; study-run; wait 1; study-run"));
  const StudyRun& study = client.study.run;
  ASSERT_EQ(study.state(), State::paused);
  expect_same(*study.result(), flown("study_308", static_cast<std::int64_t>(study.result()->shots), {}, at));
  ASSERT_TRUE(run(client, "study-run; wait 7"));
  ASSERT_EQ(study.state(), State::done);
  expect_same(*study.result(), flown("study_308", 20000, {}, at));
  EXPECT_EQ(&study.told(std::nullopt).result, &*study.result());
  const std::vector<StudyPlan> places = study.plan()->places();
  const StudyShots last = fly_shots_of(*study.plan(), 3);
  for (std::size_t i = 0; i < at.size(); ++i) {
    const StudyTold told = study.told(i);
    EXPECT_EQ(&told.result, &study.result()->at[i]);
    EXPECT_EQ(told.study.quantities, places[i].study().quantities);
    ASSERT_NE(told.linear, nullptr);
    EXPECT_EQ(told.linear->mean, propagate_linearly(places[i])->mean);
    ASSERT_EQ(told.dots.quantities[0].size(), StudyRun::kMostDots);
    EXPECT_EQ(told.dots.quantities[1].back(), last.at[i].quantities[1].back());
    EXPECT_EQ(told.dots.hits.size(), i == 0 ? 1U : 0U) << "the plate stands on the plane of range lines";
  }
}

TEST(StudyRun, goes_away_while_it_flies) {
  Client client = client_of("study_308");
  ASSERT_TRUE(set_study_shots(client, "1e9"));
  ASSERT_TRUE(start_or_pause_study(client));
  client.advance(1e-3, 0.01);
  ASSERT_TRUE(client.open(PHYSIM_SOURCE_DIR "/scenarios/arrow.toml"));
  EXPECT_EQ(client.study.run.state(), State::none);
  EXPECT_TRUE(client.study.asked.inputs.empty());
}

TEST(StudyDesk, what_is_asked_changes_and_is_saved) {
  Client client = client_of("308_168gr_g7");
  const Status nothing = start_or_pause_study(client);
  ASSERT_FALSE(nothing);
  EXPECT_NE(nothing.error().text().find("nothing is uncertain"), std::string::npos) << nothing.error().text();
  EXPECT_FALSE(add_study_input(client, "shot.sped = +- 3 m/s"));
  EXPECT_FALSE(add_study_target(client, "plate: hexagon 3 cm"));
  EXPECT_FALSE(set_study_shots(client, "0"));
  EXPECT_FALSE(set_study_shots(client, "many"));
  EXPECT_FALSE(set_study_width(client, "a bit"));
  EXPECT_FALSE(client.has_unsaved_settings());
  ASSERT_TRUE(add_study_input(client, "shot.speed = +- 5 m/s"));
  ASSERT_TRUE(add_study_input(client, "shot.speed = +- 3 m/s"));
  ASSERT_TRUE(add_study_input(client, "shot.azimuth = +- 0.2 mrad"));
  ASSERT_TRUE(add_study_target(client, "plate: rectangle 45 cm x 75 cm"));
  ASSERT_TRUE(add_study_at(client, "apex: y, time"));
  EXPECT_EQ(client.study.asked.inputs,
            (std::vector<std::string>{"shot.speed = +- 3 m/s", "shot.azimuth = +- 0.2 mrad"}))
      << "one speed alone";
  EXPECT_TRUE(client.has_unsaved_settings());
  const testing_cli::Folder folder;
  const std::string file = folder / "physim_study_desk.toml";
  ASSERT_TRUE(client.save(file));
  const Scenario read = must(load_scenario(file));
  EXPECT_EQ(read.study.inputs, client.study.asked.inputs);
  EXPECT_EQ(read.study.targets, client.study.asked.targets);
  EXPECT_EQ(read.study.at, std::vector<std::string>{"apex: y, time"});
  remove_study_text(client, &ScenarioStudy::inputs, 0);
  remove_study_text(client, &ScenarioStudy::targets, 0);
  remove_study_text(client, &ScenarioStudy::targets, 7);
  EXPECT_EQ(client.study.asked.inputs.size(), 1U);
  EXPECT_TRUE(client.study.asked.targets.empty());
}

TEST(StudyDesk, a_change_forgets_what_was_flown_and_tells_of_the_shot) {
  Client client = client_of("study_308");
  ASSERT_TRUE(run(client, "study-shots 4096; study-run; wait 3"));
  EXPECT_EQ(client.study.begun_at, client.versions());
  ASSERT_TRUE(run(client, "set shot.speed=790 m/s"));
  EXPECT_NE(client.study.begun_at, client.versions()) << "of the shot before";
  EXPECT_EQ(client.study.run.state(), State::done);
  ASSERT_TRUE(run(client, "study-input shot.mass = +- 0.1 g"));
  EXPECT_EQ(client.study.run.state(), State::none);
  EXPECT_FALSE(client.study.run.result().has_value());
}

TEST(StudyDesk, places_are_asked_for_chosen_and_taken_out) {
  Client client = client_of("study_308");
  const std::vector<std::string>& at = client.study.asked.at;
  ASSERT_TRUE(run(client, "study-at 300 m; study-at apex: y, time; study-show 0.3 km"));
  EXPECT_EQ(shown_place(client.study), 0U);
  ASSERT_TRUE(run(client, "study-at 300 m: up, time"));
  EXPECT_EQ(at, (std::vector<std::string>{"300 m: up, time", "apex: y, time"})) << "one text for a place";
  EXPECT_EQ(place_names(client.study), (std::vector<std::string>{"300 m", "apex"}));
  EXPECT_EQ(shown_place(client.study), 0U);
  ASSERT_TRUE(run(client, "study-show apex: y"));
  EXPECT_EQ(shown_place(client.study), 1U);
  remove_study_text(client, &ScenarioStudy::at, 0);
  EXPECT_EQ(shown_place(client.study), 0U) << "the apex still";
  remove_study_text(client, &ScenarioStudy::at, 1);
  EXPECT_EQ(at.size(), 1U) << "there is no second one";
  ASSERT_TRUE(run(client, "study-show end"));
  EXPECT_EQ(shown_place(client.study), std::nullopt);
  ASSERT_TRUE(run(client, "study-show apex"));
  remove_study_text(client, &ScenarioStudy::at, 0);
  EXPECT_EQ(shown_place(client.study), std::nullopt) << "what is not there is not shown";
}

TEST(StudyDesk, bad_places_are_refused_and_nothing_is_lost) {
  Client client = client_of("study_308");
  ASSERT_TRUE(run(client, "study-at apex; study-shots 4096; study-run; wait 2; study-show apex"));
  const auto refusal = [&](const std::string& text) {
    const Status status = add_study_at(client, text);
    return status ? text + " is taken" : status.error().text();
  };
  EXPECT_NE(refusal("apx").find("did you mean \"apex\""), std::string::npos) << refusal("apx");
  EXPECT_NE(refusal("300 kg").find("is a mass"), std::string::npos) << refusal("300 kg");
  EXPECT_NE(refusal("300 m: hight").find("hight"), std::string::npos) << refusal("300 m: hight");
  EXPECT_NE(refusal("300 m: obliquity").find("first impact"), std::string::npos) << refusal("300 m: obliquity");
  EXPECT_NE(refusal("-3 m").find("above 0"), std::string::npos) << refusal("-3 m");
  EXPECT_NE(refusal("").find("is no place"), std::string::npos) << refusal("");
  const Status unknown = show_study_at(client, "300 m");
  ASSERT_FALSE(unknown);
  EXPECT_NE(unknown.error().text().find("end, apex"), std::string::npos) << unknown.error().text();
  EXPECT_EQ(client.study.asked.at, std::vector<std::string>{"apex"});
  EXPECT_EQ(shown_place(client.study), 0U);
  EXPECT_EQ(client.study.run.state(), State::done);
  for (int i = 1; i < 24; ++i) ASSERT_TRUE(add_study_at(client, std::to_string(i) + " m"));
  EXPECT_EQ(client.study.run.state(), State::none) << "of other places than were flown";
  EXPECT_NE(refusal("24 m").find("more than 24"), std::string::npos) << refusal("24 m");
  EXPECT_EQ(client.study.asked.at.size(), 24U);
}

TEST(StudyDesk, a_place_that_no_shot_comes_to_is_told_when_it_begins) {
  Client client = client_of("study_308");
  ASSERT_TRUE(run(client, "study-at 700 m"));
  const Status status = begin_study(client);
  ASSERT_FALSE(status);
  EXPECT_NE(status.error().text().find("at[0]"), std::string::npos) << status.error().text();
  EXPECT_NE(status.error().text().find("before they end"), std::string::npos) << status.error().text();
  EXPECT_EQ(client.study.run.state(), State::none);
}

TEST(StudyDesk, lines_of_state_tell_of_places) {
  Client client = client_of("study_308");
  ASSERT_TRUE(run(client, "study-at 300 m; study-at apex: y; study-shots 4096; study-run; wait 2; study-show apex"));
  const auto state = nlohmann::json::parse(state_line(client, 1))["study"];
  EXPECT_EQ(state["shown"], "apex");
  ASSERT_EQ(state["at"].size(), 2U);
  const StudyResult& range = client.study.run.result()->at[0];
  EXPECT_EQ(state["at"][0]["place"], "300 m");
  EXPECT_EQ(state["at"][0]["cep"], range.from_centre->r50);
  EXPECT_EQ(state["at"][0]["hits"][0]["high"], range.hits[0].high);
  EXPECT_EQ(state["at"][1]["place"], "apex");
  EXPECT_EQ(state["at"][1]["figures"][0]["quantity"], "y");
  EXPECT_EQ(state["at"][1]["figures"][0]["mean"], client.study.run.result()->at[1].quantities[0].mean.value);
  EXPECT_EQ(state["figures"][0]["mean"], client.study.run.result()->quantities[0].mean.value);
  EXPECT_TRUE(state["at"][1]["hits"].empty());
}

/// The face holds three deviations and the target, and a metre across is a metre upwards.
TEST(StudyView, is_to_scale_and_holds_the_target) {
  const StudyResult result = flown("study_308", 4096);
  Scenario read = load_scenario(PHYSIM_SOURCE_DIR "/scenarios/study_308.toml").value();
  const Study study = study_of(read, read.shots[0]).value();
  EXPECT_GT(face_of(study, result, 0.4).stretch, 4) << "a narrow frame of a wide scatter";
  for (const double aspect : {0.8, 1.0, 2.5}) {
    const StudyFace face = face_of(study, result, aspect);
    EXPECT_EQ(face.stretch, 1);
    EXPECT_NEAR((face.across.high - face.across.low) / (face.up.high - face.up.low), aspect, 1e-12);
    ASSERT_EQ(face.ellipses.size(), 3U);
    ASSERT_EQ(face.targets.size(), 1U);
    for (const auto& rim : {face.ellipses[2], face.targets[0]})
      for (const PlanePoint& p : rim) {
        EXPECT_GT(p.right, face.across.low);
        EXPECT_LT(p.right, face.across.high);
        EXPECT_GT(p.up, face.up.low);
        EXPECT_LT(p.up, face.up.high);
      }
    double all = 0;
    for (const double cell : face.cells_across) all += cell;
    EXPECT_GT(all, 99.5);
    EXPECT_LT(all, 100 + 1e-9);
    for (const double tick : face.across.ticks()) {
      EXPECT_GE(tick, face.across.low);
      EXPECT_LE(tick, face.across.high);
      EXPECT_NEAR(std::remainder(tick, face.across.step), 0, 1e-9) << "a round number";
    }
  }
}

TEST(StudyView, settles_to_the_figure_with_its_interval) {
  const StudyResult result = flown("study_308", 60000);
  const std::vector<Settling> list = settling_of(result, 4);
  ASSERT_EQ(list.size(), 2U);
  const Settling::Point& last = list[0].points.back();
  EXPECT_EQ(last.shots, static_cast<double>(result.shots));
  EXPECT_EQ(last.value, 100 * result.hits[0].probability.value);
  EXPECT_EQ(last.low, 100 * result.hits[0].low);
  EXPECT_EQ(last.high, 100 * result.hits[0].high);
  EXPECT_EQ(list[0].part(list[0].points.front().shots), 0);
  EXPECT_GT(list[0].part(last.shots), 0.97);
  EXPECT_LT(list[0].part(last.shots), 1);
  const Settling::Point& mean = list[1].points.back();
  EXPECT_EQ(mean.value, result.from_aim->mean.value);
  EXPECT_NEAR(mean.high - mean.low, 2 * 1.96 * result.from_aim->mean.error, 1e-4 * result.from_aim->mean.error);
}

TEST(StudyView, tells_the_digits_of_physim_study) {
  const StudyResult result = flown("study_308", 102400);
  const std::vector<StudyFigure> list = figures_of(result);
  const auto figure = [&](const std::string& what) {
    for (const StudyFigure& each : list)
      if (each.what == what) return each.value + ", " + each.error;
    return "no " + what;
  };
  // docs/uncertainty.md has these
  EXPECT_EQ(figure("hits on plate"), "59.1 %, 58.8 .. 59.4");
  EXPECT_EQ(figure("CEP"), "0.21 m, R90 0.4582");
  EXPECT_EQ(figure("mean speed"), "444.88 m/s, \u00b1 0.01, \u03c3 3.308");
  EXPECT_EQ(figure("mean right"), "-0.00050 m, \u00b1 0.00085, \u03c3 0.272");  // its error has two digits
}

/// Of one quantity: how shots spread over it.
TEST(StudyView, shows_one_quantity_as_cells) {
  Client client = client_of("study_308");
  client.study.asked.quantities = {"speed"};
  client.study.asked.targets.clear();
  ASSERT_TRUE(run(client, "study-shots 4096; study-run; wait 2"));
  const StudyFace face = face_of(client.study.run.plan()->study(), *client.study.run.result(), 1);
  EXPECT_TRUE(face.ellipses.empty());
  EXPECT_TRUE(face.cells_up.empty());
  EXPECT_EQ(face.across.label, "speed [m/s]");
  EXPECT_GE(face.up.high, *std::ranges::max_element(face.cells_across));
  EXPECT_EQ(settling_of(*client.study.run.result(), 4).size(), 1U);
}

TEST(StudyView, says_what_a_place_has_not) {
  Client client = client_of("study_308");
  ASSERT_TRUE(run(client, "study-at 300 m; study-at apex; study-at time 0.2 s: y"));
  ASSERT_TRUE(run(client, "study-shots 4096; study-run; wait 2"));
  const auto lacking = [&](std::size_t place) {
    return lacking_at(client.study.run.told(place), client.study.run.plan()->study());
  };
  EXPECT_EQ(lacking(0), "");
  EXPECT_NE(lacking(1).find("Targets"), std::string::npos) << lacking(1);
  EXPECT_EQ(lacking(1).find("no plane"), std::string::npos) << lacking(1);
  EXPECT_NE(lacking(2).find("no plane: shots are shown over y"), std::string::npos) << lacking(2);
  Client kick = client_of("study_free_kick");
  ASSERT_TRUE(run(kick, "study-at apex; study-run; wait 2"));
  const std::string things = lacking_at(kick.study.run.told(0), kick.study.run.plan()->study());
  EXPECT_NE(things.find("Things"), std::string::npos) << things;
  EXPECT_EQ(things.find("Targets"), std::string::npos) << things;
}

/// Of rare shots alone that come to a place, the first thousands may have none.
TEST(StudyView, shows_a_place_without_shots) {
  StudyResult result = flown("study_308", 4096, {}, {"300 m"}).at[0];
  const double unknown = std::nan("");
  result.ellipse.reset();
  for (QuantityResult& q : result.quantities)
    q = {q.quantity, {unknown, unknown}, unknown, unknown, unknown, {q.cells.centre, q.cells.scale, 0, {}}};
  for (StudyStage& stage : result.stages) stage.distance = {unknown, unknown};
  const Study study;
  const StudyFace face = face_of(study, result, 1);
  EXPECT_TRUE(face.cells_across.empty() && face.ellipses.empty());
  EXPECT_LT(face.across.ticks().size(), 20U);
  EXPECT_EQ(settling_of(result, 4).size(), 1U) << "hits alone";
  for (const StudyFigure& figure : figures_of(result)) EXPECT_EQ(figure.value.find("nan"), std::string::npos);
}

TEST(StudyView, has_room_beside_the_scene) {
  Client client = client_of();
  client.bottom = BottomPanel::study;
  for (const float height : {320.0F, 720.0F, 2160.0F}) {
    const Layout layout = make_layout(client, 1280, height, 1);
    EXPECT_GE(layout.scene.height, 80);
    EXPECT_LE(layout.bottom.y + layout.bottom.height, layout.status.y + 0.01F);
  }
}

}  // namespace
}  // namespace physim::client
