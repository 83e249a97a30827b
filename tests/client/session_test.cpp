// The client's session without a window: its clock, firing, going back, recording.
#include "simclient/core/session.hpp"

#include <malloc.h>

#include <cmath>

#include "cli/program.hpp"
#include "physim/body.hpp"
#include "physim/scenario.hpp"
#include "simclient/core/client.hpp"
#include "simclient/core/original_tests.hpp"
#include "simclient/core/prediction.hpp"

namespace physim::client {
namespace {

constexpr double kStep = 1.0 / 60;

Session range() { return std::move(Session::create(open_range()).value()); }

ScenarioShot laser() {
  ScenarioShot shot;
  const ProjectilePreset preset = presets::laser();
  shot.projectile = preset.projectile;
  shot.body = preset.body;
  shot.launch = {.position = {0, 1.5, 0}, .speed = 35};
  return shot;
}

Session session_of(const char* file) {
  return std::move(Session::create(load_scenario(PHYSIM_SOURCE_DIR "/scenarios/" + std::string(file)).value()).value());
}

TEST(Session, TakesAsManyStepsAsTimeHasPassed) {
  Session session = range();
  EXPECT_EQ(session.advance(1.0), 8) << "after a hitch it takes only so many";
  EXPECT_EQ(session.advance(0.5 * kStep), 1) << "what was left over counts";
  for (int i = 0; i < 60; ++i) session.advance(kStep);
  EXPECT_NEAR(session.time(), 69 * kStep, 1.1 * kStep);
}

TEST(Session, SlowMotionPassesLessTime) {
  Session session = range();
  session.set_time_scale(0.25);
  for (int i = 0; i < 40; ++i) session.advance(kStep);
  EXPECT_EQ(session.step(), 10U);
}

TEST(Session, NoTimePassesWhilePaused) {
  Session session = range();
  ASSERT_TRUE(session.fire(laser()));
  session.advance(kStep);
  session.set_paused(true);
  const double then = session.time();
  for (int i = 0; i < 1000; ++i) EXPECT_EQ(session.advance(kStep), 0);
  EXPECT_EQ(session.time(), then);
  session.set_paused(false);
  EXPECT_LE(session.advance(kStep), 1);
  EXPECT_NEAR(session.tracks()[0].samples.back().position.x, 35 * session.time(), 1e-4);
}

TEST(Session, SettingsBindWhenTheShotIsFired) {
  Session session = range();
  ScenarioShot shot = laser();
  const ProjectileId first = *session.fire(shot);
  shot.projectile.mass = 7;
  const ProjectileId second = *session.fire(shot);
  EXPECT_EQ(session.world()[first].mass(), 1);
  EXPECT_EQ(session.world()[second].mass(), 7);
  EXPECT_NE(session.track(first)->colour, session.track(second)->colour);
}

TEST(Session, AShotThatMakesNoSenseIsRefusedWithAReason) {
  Session session = range();
  ScenarioShot shot = laser();
  shot.projectile.mass = -1;
  const Result<ProjectileId> fired = session.fire(shot);
  ASSERT_FALSE(fired);
  EXPECT_NE(fired.error().text().find("mass"), std::string::npos) << fired.error().text();
  EXPECT_TRUE(session.tracks().empty());
}

TEST(Session, StepsBackToTheSameBits) {
  Session session = range();
  ASSERT_TRUE(session.fire(laser()));
  std::vector<std::uint64_t> hashes = {session.world().hash()};
  for (int i = 0; i < 20; ++i) {
    session.single_step();
    hashes.push_back(session.world().hash());
  }
  ASSERT_TRUE(session.fire(laser()));  // changes the present, not what was before
  hashes.back() = session.world().hash();
  for (int i = 19; i >= 0; --i) {
    ASSERT_TRUE(session.step_back());
    EXPECT_EQ(session.world().hash(), hashes[static_cast<std::size_t>(i)]) << i;
    EXPECT_EQ(session.tracks().size(), 1U);
    EXPECT_EQ(session.tracks()[0].samples.size(), static_cast<std::size_t>(i) + 1);
  }
  EXPECT_FALSE(session.step_back());
  for (std::size_t i = 1; i <= 20; ++i) {
    session.single_step();
    EXPECT_EQ(session.world().hash(), hashes[i]) << i;
  }
  EXPECT_EQ(session.tracks().size(), 2U) << "what was fired by hand comes again";
}

/// A rocket and five shells at once are six tracks; of a crowd that comes within a step, some are enough.
TEST(Session, FollowsASalvoWhole) {
  const auto followed = [](double count) {
    Scenario scenario = load_scenario(PHYSIM_SOURCE_DIR "/scenarios/emit_fireworks.toml").value();
    scenario.emitters[0].def.bursts[0].count = DrawnNumber{count};
    Session session = std::move(Session::create(scenario).value());
    for (int i = 0; i < 30; ++i) session.single_step();
    return std::ranges::count(session.tracks(), "shell", &Track::name);
  };
  EXPECT_EQ(followed(5), 5);
  EXPECT_EQ(followed(50), 4) << "five tracks, one of them the rocket's";
}

/// Against what the allocator says, where it says something.
TEST(Session, TheWayBackKeepsWithinItsMemory) {
  constexpr std::size_t kBudget = 256u << 20;
  Session session = session_of("emit_fountain.toml");
  session.set_time_scale(128);
  const std::size_t before = mallinfo2().uordblks + mallinfo2().hblkhd;
  for (int i = 0; i < 600; ++i) session.advance(kStep);
  const std::size_t used = mallinfo2().uordblks + mallinfo2().hblkhd - before;
  EXPECT_LE(session.way_back_memory(), kBudget);
  EXPECT_LE(static_cast<double>(used), 1.1 * static_cast<double>(session.way_back_memory()) + 4e6);
}

TEST(Session, StepsBackThroughVolleys) {
  Session session = session_of("world_machine_gun.toml");
  std::vector<std::uint64_t> hashes;
  std::vector<std::size_t> alive;
  for (int i = 0; i < 30; ++i) {
    session.single_step();
    hashes.push_back(session.world().hash());
    alive.push_back(session.world().size());
  }
  for (int i = 0; i < 20; ++i) session.step_back();
  EXPECT_EQ(session.world().hash(), hashes[9]);
  for (int i = 0; i < 20; ++i) session.single_step();
  EXPECT_EQ(session.world().hash(), hashes.back());
  EXPECT_EQ(session.world().size(), alive.back());
}

TEST(Session, AFlightThatLandedFliesAgainAfterStepsBack) {
  Session session = range();
  ScenarioShot shot = laser();
  shot.projectile.fidelity = Fidelity::game();
  shot.projectile.gravity_scale = 1;
  shot.body = {};
  shot.launch.speed = 5;
  ASSERT_TRUE(session.fire(shot));
  while (session.tracks()[0].is_flying()) session.single_step();
  EXPECT_EQ(session.tracks()[0].status, LifeStatus::landed);
  ASSERT_TRUE(session.tracks()[0].impact);
  EXPECT_NEAR(session.tracks()[0].impact->position.y, 0, 1e-6);
  ASSERT_TRUE(session.step_back());
  EXPECT_TRUE(session.tracks()[0].is_flying());
  EXPECT_FALSE(session.tracks()[0].impact);
}

TEST(Session, PathsEndAtTheWall) {
  Session session = session_of("world_machine_gun.toml");
  for (int i = 0; i < 20; ++i) session.single_step();
  const Track& first = session.tracks()[0];
  ASSERT_TRUE(first.impact);
  EXPECT_EQ(first.impact->position.x, 100);
  EXPECT_EQ(first.samples.back().position, first.impact->position);
  EXPECT_EQ(first.samples.front().time, 0) << "the launch is there";
  EXPECT_EQ(first.samples.front().position.x, 0);
  EXPECT_EQ(session.fate_of(first), "stopped by the wall");
}

TEST(Session, RestartForgetsWhatWasFiredByHand) {
  Session session = range();
  ASSERT_TRUE(session.fire(laser()));
  session.single_step();
  ASSERT_TRUE(session.restart());
  EXPECT_EQ(session.time(), 0);
  EXPECT_EQ(session.world().size(), 0U);
  EXPECT_TRUE(session.tracks().empty());
}

TEST(Session, EditsInFlightAreMarked) {
  Session session = range();
  const ProjectileId id = *session.fire(laser());
  session.single_step();
  ASSERT_TRUE(session.edit(id, [](Projectile p) { return p.set_velocity({0, 10, 0}); }));
  EXPECT_TRUE(session.track(id)->edited);
  EXPECT_EQ(session.world()[id].velocity().y, 10);
  const Status status = session.edit(id, [](Projectile p) { return p.set_velocity({NAN, 0, 0}); });
  EXPECT_FALSE(status);
}

TEST(Session, DeterminismCheckPassesAndLeavesEverythingAsItWas) {
  Session session = session_of("world_mixed_fidelities.toml");
  for (int i = 0; i < 30; ++i) session.single_step();
  const std::uint64_t before = session.world().hash();
  const DeterminismCheck check = must(session.check_determinism(40));
  EXPECT_TRUE(check.passed());
  EXPECT_NE(check.first, before) << "nothing was stepped";
  EXPECT_EQ(session.world().hash(), before);
}

TEST(Session, PlaysItsRecording) {
  const testing_cli::Folder folder;
  Session session = range();
  ASSERT_TRUE(session.restart(folder / "a.rec"));
  for (int i = 0; i < 40; ++i) {
    if (i % 10 == 0) {
      ASSERT_TRUE(session.fire(laser()));
    }
    session.single_step();
  }
  session.step_back();
  session.single_step();
  const std::uint64_t end = session.world().hash();
  const Vec3d last = session.tracks().back().samples.back().position;
  ASSERT_TRUE(session.stop_recording());
  Session replay = must(Session::replay(load_recording(folder / "a.rec").value(), "a.rec"));
  for (int i = 0; i < 1000 && !replay.is_over(); ++i) replay.single_step();
  EXPECT_TRUE(replay.is_over());
  EXPECT_EQ(replay.world().hash(), end);
  EXPECT_FALSE(replay.replay_report()->difference);
  EXPECT_EQ(replay.tracks().back().samples.back().position, last);
  EXPECT_FALSE(replay.fire(laser())) << "a replay cannot be changed";
}

TEST(Prediction, IsTheFlightItself) {
  Session session = session_of("308_168gr_g7.toml");
  const Launcher launcher(session.scenario());
  for (const ShotType& type : launcher.types()) {
    const Prediction prediction = Predictor().predict(session, type.shot, 2);
    ASSERT_FALSE(prediction.error) << prediction.error->text();
    ASSERT_TRUE(session.restart());
    const ProjectileId id = *session.fire(type.shot);
    EXPECT_EQ(session.world()[id].velocity(), prediction.velocity) << type.name;
    for (std::size_t i = 1; i < 30 && i + 1 < prediction.path.size(); ++i) {
      session.single_step();
      EXPECT_EQ(session.tracks()[0].samples[i].position, prediction.path[i].position) << type.name << " step " << i;
    }
  }
}

TEST(Prediction, EndsAtTheWallAsTheShotDoes) {
  Session session = session_of("world_machine_gun.toml");
  Predictor predictor;
  const Prediction found = predictor.predict(session, session.scenario().shots[0]);
  ASSERT_FALSE(found.error);
  EXPECT_NEAR(found.path.back().position.x, 100, 1e-9);
  EXPECT_FALSE(found.is_cut);
}

TEST(Prediction, FeelsTheForcesOfTheScenario) {
  Session session = session_of("world_force_field.toml");
  const Launcher launcher(session.scenario());
  const ShotType* dart = nullptr;
  for (const ShotType& type : launcher.types())
    if (type.name == "dart") dart = &type;
  ASSERT_NE(dart, nullptr);
  const Prediction prediction = Predictor().predict(session, dart->shot, 2);
  const ProjectileId id = *session.fire(dart->shot);
  for (std::size_t i = 1; i < 30; ++i) session.single_step();
  EXPECT_LT(length(session.world()[id].position() - prediction.path[29].position), 1e-6);
}

/// The six tests of the original, flown in the client's world, over the rows that were published.
class OriginalTests : public testing::TestWithParam<std::string> {};

TEST_P(OriginalTests, MeetThePublishedRows) {
  Client client = std::move(open_client("", {}).value());
  ASSERT_TRUE(open_original_test(client, GetParam()));
  const std::vector<Expectation> expected = client.session.scenario().expect;
  ASSERT_FALSE(client.session.tracks().empty());
  while (!client.session.tracks().empty() && client.session.time() < 8.1) client.session.single_step();
  int compared = 0;
  for (const Expectation& e : expected) {
    if (e.at != ExpectAt::time) continue;
    for (const Track& track : client.session.tracks()) {
      if (!e.shot.empty() && e.shot != track.name) continue;
      for (const TrackSample& s : track.samples) {
        if (std::abs(s.time - e.at_value) > 1e-6) continue;
        const PlotSpec spec = parse_plots(e.quantity).value()[0];
        const double value = plot_quantities()[spec.y].of(track, s);
        EXPECT_NEAR(value, e.equals, e.within)
            << track.name << " " << e.quantity << " at " << s.time << ": " << e.source;
        ++compared;
      }
    }
  }
  EXPECT_GT(compared, 5);
}

INSTANTIATE_TEST_SUITE_P(All, OriginalTests, testing::Values("1", "2", "3", "3-drag", "4", "5", "6", "6-drag"),
                         [](const auto& test) {
                           std::string name = test.param;
                           std::erase(name, '-');
                           return name;
                         });

}  // namespace
}  // namespace physim::client
