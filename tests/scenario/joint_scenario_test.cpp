// Joints in scenario files: what is read, what is written back, how a run has them, and what is refused and where.
#include <cmath>

#include "base/archive.hpp"
#include "must.hpp"
#include "scenario/revise.hpp"
#include "scenario/world_run.hpp"

namespace physim::scenario_joint_scenario_test {

const std::string kJoined = R"(physim = 1
[environment]
atmosphere = { model = "vacuum" }
[world]
duration = "2 s"
ground = "none"
[[shot]]
name = "ball"
mass = "2 kg"
position = ["1 m", "0 m", "0 m"]
speed = "0 m/s"
[[shot]]
name = "weight"
mass = "1 kg"
position = ["1 m", "-1 m", "0 m"]
speed = "0 m/s"
[[joint]]
name = "arm"
a = "ball"
point = ["0 m", "0 m", "0 m"]
[[joint]]
kind = "cable"
a = "weight"
b = "ball"
length = "1.5 m"
restitution = 0.25
[[joint]]
kind = "spring"
a = "weight"
b = "ball"
length = "0 m"
stiffness = "50 N/m"
damping = "0.5 kg/s"
)";

TEST(JointScenario, all_that_a_joint_may_say_is_read_and_written_back) {
  const Scenario read = must(parse_scenario(kJoined, "f.toml"));
  ASSERT_EQ(read.joints.size(), 3u);
  EXPECT_EQ(read.joints[0].name, "arm");
  EXPECT_EQ(read.joints[0].def, Joint{});
  EXPECT_EQ(read.joints[1].name, "joint-2");
  EXPECT_EQ(read.joints[1].def, (Joint{.kind = JointKind::cable, .length = 1.5, .restitution = 0.25}));
  EXPECT_EQ(read.joints[2].b, "ball");
  EXPECT_EQ(read.joints[2].def, (Joint{.kind = JointKind::spring, .length = 0, .stiffness = 50, .damping = 0.5}));
  const Result<Scenario> again = parse_scenario(scenario_text(read), "g.toml");
  ASSERT_TRUE(again) << again.error().text() << scenario_text(read);
  EXPECT_EQ(hash_of(again->joints), hash_of(read.joints));
  Scenario more = read;
  more.joints.push_back({.name = "last", .a = "ball", .def = {.point = {0, 9, 0}}});
  const auto revised = must(revised_text(kJoined, "f.toml", more));
  EXPECT_EQ(revised.substr(0, kJoined.size()), kJoined);
  EXPECT_EQ(hash_of(parse_scenario(revised, "f.toml")->joints), hash_of(more.joints));
}

const std::string kCarried = R"(physim = 1
[world]
duration = "2 s"
ground = "none"
[[shape]]
name = "box"
box = { half = ["10 cm", "10 cm", "10 cm"] }
[[thing]]
name = "crane"
shape = "box"
position = ["0 m", "5 m", "0 m"]
scale = 2
velocity = ["1 m/s", "0 m/s", "0 m/s"]
angular_velocity = ["0 rad/s", "2 rad/s", "0 rad/s"]
[[shot]]
name = "load"
position = ["1 m", "2 m", "0 m"]
speed = "0 m/s"
body = { collision = { on_hit = "pass" } }
[[shot]]
name = "bead"
position = ["0 m", "0 m", "3 m"]
speed = "0 m/s"
[[shot]]
name = "door"
position = ["0 m", "0 m", "8 m"]
speed = "0 m/s"
[[joint]]
a = "load"
thing = "crane"
point = ["50 cm", "0 m", "0 m"]
break_force = "1 kN"
[[joint]]
kind = "slider"
a = "bead"
point = ["0 m", "0 m", "3 m"]
velocity = ["0 m/s", "0 m/s", "1 m/s"]
axis = [1, -1, 0]
low = "-1 m"
high = "60 cm"
[[joint]]
kind = "hinge"
a = "door"
point = ["1 m", "0 m", "9 m"]
axis = [0, 0, 2]
reference = [-1, 0, 0]
low_angle = "-10 deg"
high_angle = "40 deg"
)";

TEST(JointScenario, points_that_move_and_axes_are_read_and_written_back) {
  const Scenario read = must(parse_scenario(kCarried, "f.toml"));
  EXPECT_TRUE(read.notes.empty()) << read.notes.front();
  ASSERT_EQ(read.joints.size(), 3u);
  EXPECT_EQ(read.joints[0].thing, "crane");
  EXPECT_EQ(read.joints[0].def, (Joint{.point = {0.5, 0, 0}, .break_force = 1000}));
  EXPECT_EQ(read.joints[1].def, (Joint{.kind = JointKind::slider,
                                       .point = {0, 0, 3},
                                       .velocity = {0, 0, 1},
                                       .axis = {1, -1, 0},
                                       .low = -1,
                                       .high = 0.6}));
  EXPECT_EQ(read.joints[2].def.axis, (Vec3d{0, 0, 2}));
  EXPECT_NEAR(*read.joints[2].def.high_angle, 0.6981317, 1e-7);
  const Result<Scenario> again = parse_scenario(scenario_text(read), "g.toml");
  ASSERT_TRUE(again) << again.error().text() << scenario_text(read);
  EXPECT_EQ(hash_of(again->joints), hash_of(read.joints));
}

TEST(JointScenario, a_run_carries_its_points_and_keeps_its_axes) {
  auto run = must(WorldRun::create(*parse_scenario(kCarried, "f.toml")));
  const auto ids = run.world().ids();
  const auto joints = run.world().joints();
  for (std::uint64_t i = 0; i < run.steps(); ++i) {
    run.step();
    const double t = run.world().time();
    // The crane's hook is 1 m from its middle, as its point is scaled with it.
    const Vec3d hook{t + std::cos(2 * t), 5, -std::sin(2 * t)};
    ASSERT_NEAR(length(run.world()[ids[0]].position() - hook), 3, 1e-9);
    const Vec3d bead = run.world()[ids[1]].position();
    ASSERT_NEAR(bead.z, 3 + t, 1e-9);
    ASSERT_NEAR(bead.x + bead.y, 0, 1e-9);
  }
  EXPECT_NEAR(run.world().joint_state(joints[1]).way, 0.6, 1e-9) << "it came down to its stop";
  EXPECT_NEAR(run.world().joint_state(joints[2]).angle, 0.6981317, 1e-6);
}

TEST(JointScenario, a_run_has_its_joints_and_goes_on_from_a_save) {
  Scenario scenario = *parse_scenario(kJoined, "f.toml");
  auto run = must(WorldRun::create(scenario));
  ASSERT_EQ(run.world().joints().size(), 3u);
  const auto ids = run.world().ids();
  for (int i = 0; i < 30; ++i) run.step();
  EXPECT_NEAR(length(run.world()[ids[0]].position()), 1, 1e-9);
  EXPECT_LE(length(run.world()[ids[0]].position() - run.world()[ids[1]].position()), 1.5 + 1e-9);
  const auto saved = must(run.save());
  auto loaded = must(WorldRun::load(scenario, saved));
  for (int i = 0; i < 30; ++i) run.step(), loaded.step();
  EXPECT_EQ(run.world().hash(), loaded.world().hash());
  scenario.joints[2].def.stiffness = 60;
  EXPECT_FALSE(WorldRun::load(scenario, saved));
}

TEST(JointScenario, bad_joints_are_refused_where_they_stand) {
  const std::string head =
      "physim = 1\n[world]\n[[shot]]\nname = \"a\"\n[[shot]]\nname = \"b\"\n[[volley]]\nshot = \"b\"\n"
      "[[joint]]\n";  // joints begin on line 10
  const auto error = [&](const std::string& joint) {
    const Result<Scenario> read = parse_scenario(head + joint, "f.toml");
    return read.ok() ? "no error" : read.error().text();
  };
  EXPECT_EQ(error("b = \"a\"\n"),
            "f.toml:9:1: error: missing key \"a\" in [joint]; name of the shot at one end, fired once");
  EXPECT_EQ(error("a = \"c\"\n"), "f.toml:10:5: error: joint.a: no shot is named \"c\"; shots: a, b");
  EXPECT_EQ(
      error("a = \"b\"\n"),
      "f.toml:10:5: error: joint.a: \"b\" is fired by a volley; name a shot that no volley fires: there is one of it");
  EXPECT_EQ(error("a = \"a\"\nb = \"a\"\n"),
            "f.toml:11:5: error: joint.b: is joint.a too; a joint holds two different shots");
  EXPECT_EQ(error("a = \"a\"\nkind = \"rope\"\n"),
            "f.toml:11:8: error: joint.kind: unknown value \"rope\"; known values: rod, cable, spring, hinge, slider");
  EXPECT_EQ(error("a = \"a\"\nlength = \"-1 m\"\n").substr(0, 29), "f.toml:11:10: error: joint.le");
  EXPECT_EQ(error("a = \"a\"\nlength = \"0 m\"\n").substr(0, 29), "f.toml:11:10: error: joint.le");
  EXPECT_EQ(error("a = \"a\"\nlength = \"2 kg\"\n").substr(0, 29), "f.toml:11:10: error: joint.le");
  EXPECT_EQ(error("a = \"a\"\nrestitution = 2\n").substr(0, 29), "f.toml:11:15: error: joint.re");
  EXPECT_EQ(error("a = \"a\"\nrestitution = 0.5\n"),
            "f.toml:11:15: error: joint.restitution: is that of a cable; rods and springs have none");
  const std::string hinge = "a = \"a\"\nkind = \"hinge\"\n";
  EXPECT_EQ(error(hinge + "axis = [0, 0, 0]\n"),
            "f.toml:12:8: error: joint.axis: must have a length; a hinge or slider has a direction");
  EXPECT_EQ(error(hinge + "axis = [0, 0, 1]\nlow_angle = \"20 deg\"\nhigh_angle = \"10 deg\"\n"),
            "f.toml:14:14: error: joint.high_angle: must be above low_angle");
  EXPECT_EQ(error(hinge + "axis = [0, 0, 1]\nlow = \"1 m\"\n"),
            "f.toml:13:7: error: joint.low: is that of a slider; limits of hinges are low_angle and high_angle");
  EXPECT_EQ(error(hinge + "axis = [0, 0, 1]\nlow_angle = \"190 deg\"\n").substr(0, 36),
            "f.toml:13:13: error: joint.low_angle");
  EXPECT_EQ(error("a = \"a\"\nbreak_force = \"0 N\"\n").substr(0, 30), "f.toml:11:15: error: joint.bre");
  EXPECT_EQ(error("a = \"a\"\nthing = \"crane\"\n").substr(0, 58),
            "f.toml:11:9: error: joint.thing: no thing is named \"crane\"");
  EXPECT_EQ(error("a = \"a\"\nlenth = 3\n"),
            "f.toml:11:1: error: unknown key \"lenth\" in [joint]; did you mean \"length\"?");
  const Result<Scenario> no_world =
      parse_scenario("physim = 1\n[[shot]]\nname = \"a\"\n[[joint]]\na = \"a\"\n", "f.toml");
  ASSERT_FALSE(no_world);
  EXPECT_EQ(no_world.error().place, "f.toml:4:1");
  EXPECT_EQ(error("a = \"a\"\nname = \"arm\"\n[[joint]]\na = \"a\"\nname = \"arm\"\n"),
            "f.toml:14:8: error: joint.name: another joint is named \"arm\"; give it a name of its own");
  // What needs the places of its ends is found when the run begins.
  auto scenario = must(parse_scenario("physim = 1\n[world]\n[[shot]]\nname = \"a\"\n[[joint]]\na = \"a\"\n", "f.toml"));
  const auto run = WorldRun::create(scenario);
  ASSERT_FALSE(run);
  EXPECT_EQ(run.error().text(), "f.toml:5:1: error: joint.length: its ends are at one place; say how long it is");
  const auto refused = [&](const std::string& joint) {
    const std::string text = "physim = 1\n[world]\n[[shot]]\nname = \"a\"\nposition = [0, 1, 0]\n" + joint;
    return WorldRun::create(must(parse_scenario(text, "f.toml"))).error().text();
  };
  const std::string none = " has no direction across the axis; a stands on the axis, or it is along it";
  EXPECT_EQ(refused("[[joint]]\nkind = \"hinge\"\na = \"a\"\naxis = [0, 1, 0]\n"),
            "f.toml:6:1: error: joint.reference:" + none);
  EXPECT_EQ(refused("[[joint]]\nkind = \"hinge\"\na = \"a\"\naxis = [0, 0, 1]\nreference = [0, 0, 2]\n"),
            "f.toml:10:13: error: joint.reference:" + none);
  std::string many;
  for (int i = 0; i < 65; ++i) many += "[[joint]]\na = \"a\"\n";
  EXPECT_EQ(refused(many),
            "f.toml:135:5: error: joint.a: is held by 64 joints already; spread them over several projectiles");
}

}  // namespace physim::scenario_joint_scenario_test
