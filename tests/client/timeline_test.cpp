// Going back and on: by the timeline, to the bit, with what was changed by hand on the way.
#include "simclient/core/timeline.hpp"

#include <random>

#include "cli/program.hpp"
#include "client/support.hpp"
#include "physim/scenario.hpp"

namespace physim::client::client_timeline {
namespace {

constexpr double kStep = 1.0 / 60;

/// Goes to a step and waits until it is there.
void go(Session& session, std::uint64_t step) {
  session.go_to(step);
  while (session.is_seeking()) session.advance(kStep);
}

/// What people see of a track; samples that are thinned out later are not compared.
struct Seen {
  std::size_t tracks = 0, hits = 0;
  std::vector<TrackSample> ends;
  std::vector<LifeStatus> states;
  bool operator==(const Seen&) const = default;
};
Seen seen(const Session& session) {
  Seen all{session.tracks().size(), session.hits().hits().size(), {}, {}};
  for (const Track& track : session.tracks())
    all.ends.push_back(track.samples.back()), all.states.push_back(track.status);
  return all;
}

struct Straight {
  std::vector<std::uint64_t> hashes;
  std::vector<Seen> seen;
};

/// The acts of a hand: shots at steps 10 and 40, one of them changed in flight at step 60, other air at step 75.
void act(Session& session, const ScenarioShot& shot) {
  if (session.step() == 10 || session.step() == 40) {
    ASSERT_TRUE(session.fire(shot));
  }
  if (session.step() == 60) {
    ASSERT_TRUE(session.edit(session.tracks().back().id, [](Projectile p) { return p.set_velocity({9, 9, 1}); }));
  }
  if (session.step() == 75) {
    Environment windy = session.scenario().environment;
    windy.wind.velocity = {-5, 0, 3};
    ASSERT_TRUE(session.set_environment(windy));
  }
}

Straight fly(Session& session, const ScenarioShot& shot, std::uint64_t steps) {
  Straight all;
  const auto note = [&] { all.hashes.push_back(session.world().hash()), all.seen.push_back(seen(session)); };
  act(session, shot);
  note();
  while (session.step() < steps) {
    session.single_step();
    act(session, shot);
    note();
  }
  return all;
}

ScenarioShot next_shot(const char* scenario) { return client_of(scenario).launcher.shot(); }

void expect_same_wherever_it_goes(Session& session, const Straight& straight) {
  std::mt19937 random(7);  // NOLINT: the same every time
  const std::uint64_t last = straight.hashes.size() - 1;
  for (int i = 0; i < 150; ++i) {
    const std::uint64_t step = i == 100 ? last : random() % (last + 1);
    go(session, step);
    ASSERT_EQ(session.step(), step);
    ASSERT_EQ(session.world().hash(), straight.hashes[step]) << "step " << step;
    ASSERT_EQ(seen(session), straight.seen[step]) << "step " << step;
    ASSERT_EQ(session.last_step(), last);
  }
}

TEST(Timeline, GoesAnywhereToTheBitsOfTheStraightWay) {
  Session session = std::move(Session::create(open_range()).value());
  ScenarioShot shot = next_shot("");
  shot.launch.speed = 15;
  const Straight straight = fly(session, shot, 200);
  ASSERT_EQ(session.tracks().size(), 2U);
  ASSERT_FALSE(session.tracks()[0].is_flying()) << "it lands on the way";
  expect_same_wherever_it_goes(session, straight);
}

TEST(Timeline, GoesAnywhereInAWorldThatFiresByItselfAndHitsThings) {
  for (const char* scenario : {"billiards", "emit_machine_gun", "world_machine_gun"}) {
    Client client = client_of(scenario);
    Straight straight;
    for (client.session.set_paused(true); client.session.step() < 240; client.session.single_step())
      straight.hashes.push_back(client.session.world().hash()), straight.seen.push_back(seen(client.session));
    straight.hashes.push_back(client.session.world().hash()), straight.seen.push_back(seen(client.session));
    expect_same_wherever_it_goes(client.session, straight);
  }
}

/// From a moment that was gone back to the session runs on as it ran, with the shots that came.
TEST(Timeline, RunsOnThroughWhatIsKnown) {
  Session session = std::move(Session::create(open_range()).value());
  const Straight straight = fly(session, next_shot(""), 120);
  go(session, 5);
  EXPECT_TRUE(session.tracks().empty());
  session.set_paused(false);
  for (std::uint64_t step = 6; step <= 120; ++step) {
    session.advance(kStep);
    ASSERT_EQ(session.step(), step);
    ASSERT_EQ(session.world().hash(), straight.hashes[step]);
    ASSERT_EQ(seen(session), straight.seen[step]);
  }
}

TEST(Timeline, AChangeByHandEndsWhatIsKnown) {
  Session session = std::move(Session::create(open_range()).value());
  const ScenarioShot shot = next_shot("");
  const Straight straight = fly(session, shot, 100);
  go(session, 30);
  ASSERT_TRUE(session.fire(shot));
  EXPECT_EQ(session.last_step(), 30U);
  EXPECT_EQ(session.known_tracks().size(), 2U);
  while (session.step() < 100) session.single_step();
  EXPECT_NE(session.world().hash(), straight.hashes[100]);
  EXPECT_EQ(session.tracks().size(), 2U) << "the shot of step 40 does not come";
  const std::uint64_t end = session.world().hash();
  go(session, 3);
  go(session, 100);
  EXPECT_EQ(session.world().hash(), end);
}

TEST(Timeline, AWholeFlightIsSeenAtEachOfItsTimes) {
  Client client = client_of("308_168gr_g7");
  ASSERT_TRUE(client.fire_by_hand());
  const Track fired = client.session.tracks()[0];
  ASSERT_TRUE(fired.whole);
  const Timeline before = timeline_of(client);
  EXPECT_EQ(before.begin, fired.born);
  EXPECT_NEAR(before.end, fired.born + fired.whole->duration(), 1e-12) << "known from its launch";
  for (const double part : {0.9, 0.2, 1.0, 0.5}) {
    go(client.session, step_at(client.session, before.time(part)));
    const Track& track = client.session.tracks()[0];
    const double age = std::min(client.session.time() - track.born, track.whole->duration());
    EXPECT_NEAR(track.samples.back().time, age, 1e-12);
    EXPECT_EQ(track.samples.back().position, track.whole->at(track.samples.back().time).position);
    EXPECT_NEAR(timeline_of(client).now, before.time(part), client.session.step_length());
  }
}

/// A recording holds the ways back and on, and its replay can be gone through as well.
TEST(Timeline, IsRecordedAndReplayed) {
  const testing_cli::Folder folder;
  Session session = std::move(Session::create(open_range()).value());
  ASSERT_TRUE(session.restart(folder / "a.rec"));
  const Straight straight = fly(session, next_shot(""), 90);
  for (const std::uint64_t step : {20U, 70U, 3U, 90U}) go(session, step);
  session.single_step();
  const std::uint64_t end = session.world().hash();
  ASSERT_TRUE(session.stop_recording());
  Session replay = std::move(Session::replay(load_recording(folder / "a.rec").value(), "a.rec").value());
  for (int i = 0; i < 100000 && !replay.is_over(); ++i) replay.single_step();
  ASSERT_TRUE(replay.is_over());
  EXPECT_FALSE(replay.replay_report()->difference);
  EXPECT_EQ(replay.world().hash(), end);
  go(replay, 50);
  EXPECT_EQ(replay.world().hash(), straight.hashes[50]);
  go(replay, 12);
  EXPECT_EQ(replay.world().hash(), straight.hashes[12]);
}

/// A long run keeps moments all along its way, within its memory.
TEST(Timeline, ReachesBackToTheStartOfALongRun) {
  Session session = std::move(Session::create(open_range()).value());
  ASSERT_TRUE(session.fire(next_shot("")));
  for (int i = 0; i < 5000; ++i) {
    session.single_step();
    if (i % 40 == 0) {
      ASSERT_TRUE(session.fire(next_shot("laser")));  // something moves all the time
    }
  }
  EXPECT_EQ(session.first_step(), 0U);
  const std::uint64_t end = session.world().hash();
  go(session, 0);
  EXPECT_EQ(session.time(), 0);
  go(session, 5000);
  EXPECT_EQ(session.world().hash(), end);
}

TEST(Timeline, HasTicksOfWhatHappens) {
  const auto kinds = [](Client& client) {
    std::vector<std::string> names;
    for (const TimelineTick& tick : timeline_of(client).ticks) names.emplace_back(name(tick.kind));
    return names;
  };
  Client rocket = client_of("model_rocket");
  ASSERT_TRUE(rocket.fire_by_hand());
  const std::vector<std::string> of_rocket = {"launch", "burnout", "apex", "hit"};
  EXPECT_EQ(kinds(rocket), of_rocket);
  const Track& track = rocket.session.tracks()[0];
  for (const Event& event : track.whole->events())
    if (event.kind == EventKind::burnout) {
      EXPECT_NEAR(timeline_of(rocket).ticks[1].time, track.born + event.time, 1e-9);
    }

  Client range = client_of();
  ASSERT_TRUE(run(range, "set shot.speed=20 m/s; set shot.elevation=50 deg; fire; wait 200"));
  const std::vector<std::string> of_ball = {"launch", "apex", "hit"};
  EXPECT_EQ(kinds(range), of_ball);
  EXPECT_NEAR(timeline_of(range).end, range.session.tracks()[0].impact->time, 1e-9) << "it ends with the flight";
}

/// A knob that is held at one place stays there: the line does not change with the moment it goes to.
TEST(Timeline, EndsAtTheSameMomentWhereverItIsLookedAt) {
  for (const bool is_whole : {false, true}) {
    Client client = client_of();
    const std::string fire = is_whole ? "fire-whole" : "fire-into-world";
    ASSERT_TRUE(run(client, "set shot.speed=20 m/s; set shot.elevation=50 deg; " + fire + "; wait 600"));
    const Timeline behind = timeline_of(client);
    ASSERT_LT(behind.end, 5);
    ASSERT_TRUE(run(client, "seek 1; wait 3"));
    ASSERT_TRUE(client.session.tracks()[0].is_flying());
    EXPECT_EQ(timeline_of(client).end, behind.end) << fire;
    ASSERT_TRUE(run(client, "pause; wait 30"));
    EXPECT_EQ(timeline_of(client).end, behind.end) << fire;
  }
}

/// The end of a flight in the world is foreseen as its prediction foresees it.
TEST(Timeline, ForeseesTheEndOfTheLastShot) {
  Client client = client_of();
  ASSERT_TRUE(run(client, "set shot.speed=20 m/s; set shot.elevation=50 deg; fire; wait 20"));
  const double foreseen = timeline_of(client).end;
  EXPECT_GT(foreseen, 1);
  ASSERT_TRUE(run(client, "wait 200"));
  EXPECT_NEAR(timeline_of(client).end, foreseen, 1e-6);
}

TEST(Timeline, WordsOfScriptsAreChecked) {
  Client client = client_of();
  EXPECT_TRUE(run(client, "wait 30; seek 0.1; wait 1; speed 2"));
  EXPECT_EQ(client.session.step(), 6U);
  EXPECT_EQ(client.session.time_scale(), 2);
  for (const char* bad : {"seek soon", "seek -1", "seek 1 2", "speed 0", "speed fast", "seek nan", "speed inf"})
    EXPECT_FALSE(run(client, bad)) << bad;
}

}  // namespace
}  // namespace physim::client::client_timeline
