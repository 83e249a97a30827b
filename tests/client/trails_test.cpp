// Colours of trails by what flies along them, and targets that say how far a shot was from their middle.
#include <algorithm>
#include <set>

#include "client/support.hpp"
#include "math/angles.hpp"
#include "simclient/core/target_report.hpp"
#include "simclient/core/trail_colours.hpp"

namespace physim::client::client_trails {
namespace {

TEST(TrailColours, GoFromDarkToLight) {
  double before = 0;
  for (int i = 0; i <= 24; ++i) {
    const double lightness = contrast(scale_colour(i / 24.0), 0x000000FF);
    EXPECT_GT(lightness, before) << i;
    before = lightness;
  }
}

std::set<Colour> colours_of_lines(Client& client) {
  Scene scene;
  build_projectiles(client, 1, scene);
  std::set<Colour> colours;
  for (const SceneLine& line : scene.lines) colours.insert(line.colour | 0xFFU);
  return colours;
}

TEST(TrailColours, FollowWhatIsAskedFor) {
  Client client = client_of("308_168gr_g7");
  ASSERT_TRUE(run(client, "marks; fire-whole; wait 60"));
  EXPECT_EQ(colours_of_lines(client).size(), 1U) << "of the shot";
  for (const char* by : {"speed", "mach", "energy"}) {
    ASSERT_TRUE(run(client, std::string("trail-colour ") + by));
    EXPECT_GT(colours_of_lines(client).size(), 15U) << by;
    Scene scene;
    build_scene(client, 1, scene);
    ASSERT_TRUE(scene.legend);
    EXPECT_EQ(scene.legend->what, by);
    const auto scale = must(trail_scale(client));
    const auto& samples = client.session.tracks()[0].samples;
    EXPECT_EQ(scale(samples.front()), scale_colour(1)) << "fastest at the muzzle";
    EXPECT_EQ(scale(samples.back()), scale_colour(0));
  }
  EXPECT_FALSE(run(client, "trail-colour weight"));
  ASSERT_TRUE(run(client, "trail-colour"));  // the next of all: those of the shot again
  EXPECT_EQ(client.show.trails_by, TrailColour::shot);
}

TEST(TrailColours, NothingThatStaysTheSameHasAScale) {
  Client client = client_of("laser");
  ASSERT_TRUE(run(client, "trail-colour speed; fire; wait 3"));
  EXPECT_FALSE(trail_scale(client));
}

TEST(TargetText, SaysWhereAndWhatToDo) {
  EXPECT_EQ((TargetReport{true, -0.04, 0, 0, 100}.text(0.5)), "hit, 4 cm left of the middle");
  EXPECT_EQ((TargetReport{true, 0.1, -0.25, 0, 100}.text(0.5)), "hit, 10 cm right, 25 cm low of the middle");
  EXPECT_EQ((TargetReport{true, 0.001, 0.002, 0, 100}.text(0.5)), "hit, in the middle");
  EXPECT_EQ((TargetReport{false, 0, -1.7, 0, 100}.text(0.5)), "missed by 1.2 m: aim 0.97\u00b0 higher");
  EXPECT_EQ((TargetReport{false, 1.5, 0, 0, 100}.text(0.5)), "missed by 1 m: aim 0.86\u00b0 to the left");
  EXPECT_EQ((TargetReport{false, 0, 0, 12.34, 100}.text(0.5)), "12.3 m short");
  const AimChange change{true, 0.3 * kDegree, -0.1 * kDegree};
  EXPECT_EQ((TargetReport{false, 0, 0, 1.2, 100, change}.text(0.5)),
            "1.2 m short: aim 0.3\u00b0 higher, 0.1\u00b0 to the left");
  EXPECT_EQ((TargetReport{false, 0, -1.7, 0, 100, change}.text(0.5)),
            "missed by 1.2 m: aim 0.3\u00b0 higher, 0.1\u00b0 to the left");
  EXPECT_EQ((TargetReport{false, 0, 0, 12.34, 100, AimChange{false}}.text(0.5)),
            "12.3 m short: out of reach at this speed");
}

struct Shot {
  const char *aim, *says;
};

/// A shot without drag at a target 20 m away, straight at it, off it, and too slow for it.
TEST(Targets, TellHowFarAShotWasFromTheMiddle) {
  const std::string set =
      "shot sphere; set shot.fidelity.preset=arcade; set shot.fidelity.gravity=off; "
      "set shot.elevation=0 deg; set shot.azimuth=0 deg; set shot.speed=40 m/s; target 20 1.5 0; ";
  for (const Shot& shot : {Shot{"", "hit, in the middle"}, Shot{"turn-right; ", "right of the middle"},
                           Shot{"turn-up; turn-up; turn-up; turn-up; turn-up; turn-up; turn-up; turn-up; ", "lower"},
                           Shot{"set shot.fidelity.gravity=constant; set shot.speed=9 m/s; ", " short"}}) {
    Client client = client_of();
    client.placing.radius = 1;
    ASSERT_TRUE(run(client, set + shot.aim + "fire; wait 60"));
    const std::vector<TargetDisc> targets = targets_of(client.session.scenario());
    ASSERT_EQ(targets.size(), 1U);
    EXPECT_NEAR(std::abs(targets[0].normal.x), 1, 1e-12);
    auto report = must(report_of(targets[0], client.session, client.session.tracks()[0]), shot.says);
    if (!report.has_hit) report.change = client.aim_change_of(client.session.tracks()[0], targets[0]);
    EXPECT_NE(report.text(1).find(shot.says), std::string::npos) << report.text(1);
    Scene scene;
    build_scene(client, 1, scene);
    EXPECT_TRUE(std::ranges::any_of(scene.labels, [&](const SceneLabel& l) { return l.text == report.text(1); }));
  }
}

/// The report's advice, taken to the letter, hits: a mortar that is raised, and a flat shot.
TEST(Targets, TheCorrectionHits) {
  for (const char* aim : {"set shot.speed=60 m/s; set shot.elevation=20 deg; target 280 1 4; ",
                          "set shot.speed=60 m/s; set shot.elevation=75 deg; target 250 1 4; "}) {
    Client client = client_of();
    client.placing.radius = 1;
    ASSERT_TRUE(run(client, std::string("shot sphere; set shot.azimuth=0 deg; ") + aim + "fire; wait 1200"));
    const TargetDisc target = targets_of(client.session.scenario()).at(0);
    const Track& track = client.session.tracks()[0];
    const auto report = report_of(target, client.session, track);
    ASSERT_TRUE(report && !report->has_hit) << aim;
    const auto change = client.aim_change_of(track, target);
    ASSERT_TRUE(change && change->is_in_reach) << aim;
    client.launcher.turn(change->right, change->up);
    ASSERT_TRUE(run(client, "fire; wait 1200"));
    const auto again = must(report_of(target, client.session, client.session.tracks()[1]), aim);
    EXPECT_TRUE(again.has_hit) << aim << again.text(target.radius);
  }
  Client slow = client_of();
  ASSERT_TRUE(run(slow, "shot sphere; set shot.speed=10 m/s; target 280 1 0; fire; wait 1200"));
  Scene scene;
  build_scene(slow, 1, scene);
  EXPECT_TRUE(std::ranges::any_of(scene.labels, [](const SceneLabel& l) {
    return l.text.find(" short: out of reach at this speed") != std::string::npos;
  }));
}

/// Rings of five colours on a target; a flat thing of another name has none.
TEST(Targets, HaveRings) {
  const auto colours = [](const std::string& name) {
    Client client = client_of();
    EXPECT_TRUE(run(client, "target 20 1.5 0"));
    Scenario scenario = client.session.scenario();
    scenario.things[0].name = name;
    EXPECT_TRUE(client.session.set_scene(scenario));
    std::set<std::uint32_t> all;
    SceneryMaker maker;
    for (const LitVertex& v : maker.make(client.session.world().scene(), 99, 0, 100).vertices)
      all.insert(static_cast<std::uint32_t>(v.colour[0] << 16 | v.colour[1] << 8 | v.colour[2]));
    return all.size();
  };
  EXPECT_EQ(colours("plate"), 1U);
  EXPECT_EQ(colours("target-1"), 6U);
}

}  // namespace
}  // namespace physim::client::client_trails
