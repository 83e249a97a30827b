// Bad scenarios of worlds: every one gets a place, a reason and, where there is one, a way out.

#include "must.hpp"
#include "scenario/world_run.hpp"

namespace physim::scenario_world_errors_test {

struct Bad {
  std::string text, error;
  friend std::ostream& operator<<(std::ostream& out, const Bad& bad) { return out << bad.error; }
};

class BadWorldTest : public testing::TestWithParam<Bad> {};
TEST_P(BadWorldTest, SaysWhereAndWhy) {
  const Result<Scenario> scenario = parse_scenario("physim = 1\n" + GetParam().text, "f.toml");
  EXPECT_EQ(scenario.ok() ? "no error" : scenario.error().text(), GetParam().error) << GetParam().text;
}

// The text begins on line 2.
INSTANTIATE_TEST_SUITE_P(
    Keys, BadWorldTest,
    testing::Values(
        Bad{"[[shot]]\n[world]\nduraton = 1",
            "f.toml:4:1: error: unknown key \"duraton\" in [world]; did you mean \"duration\"?"},
        Bad{"[[shot]]\nbody = { restituton = 1 }\n[world]",
            "f.toml:3:10: error: unknown key \"restituton\" in [body]; did you mean \"restitution\"?"},
        Bad{"[[shot]]\n[world]\n[[volley]]\nshots = \"a\"",
            "f.toml:5:1: error: unknown key \"shots\" in [volley]; did you mean \"shot\"?"},
        Bad{"[[shot]]\n[world]\n[[volley]]\ncount = 3",
            "f.toml:4:1: error: missing key \"shot\" in [volley]; name of the shot"},
        Bad{"[[shot]]\n[world]\n[[force]]\nname = \"f\"\ngravity_force = {}\n[[force]]\nname = \"f\"\ngravity_force = "
            "{}",
            "f.toml:8:8: error: force.name: another force is named \"f\"; give it a name of its own"},
        Bad{"[[shot]]\n[world]\n[[shape]]\nname = \"s\"\nsphere = 1\n[[thing]]\nname = \"t\"\nshape = "
            "\"s\"\n[[thing]]\n"
            "name = \"t\"\nshape = \"s\"",
            "f.toml:11:8: error: thing.name: another thing is named \"t\"; give it a name of its own"},
        Bad{"[[shot]]\n[world]\n[[force]]\nwind_zne = {}",
            "f.toml:5:1: error: unknown key \"wind_zne\" in [force]; did you mean \"wind_zone\"?"},
        Bad{"[[shot]]\n[world]\n[[force]]\nspring = { stiffness = 3 }",
            "f.toml:5:10: error: missing key \"other\" in [spring]; name of the shot at its other end, which is fired "
            "once"},
        Bad{"[[shot]]\npreset = \"rifle_bulet\"",
            "f.toml:3:10: error: shot.preset: unknown value \"rifle_bulet\"; did you mean \"rifle_bullet\"?"},
        Bad{"[[shot]]\n[world]\nground = \"bouncy\"",
            "f.toml:4:10: error: world.ground.mode: unknown value \"bouncy\"; did you mean \"bounce\"?"},
        Bad{"[[shot]]\nbody = { frozen = \"w\" }\n[world]",
            "f.toml:3:19: error: shot.body.frozen: unknown value \"w\"; known values: none, x, y, xy, z, xz, yz, "
            "xyz"}));

INSTANTIATE_TEST_SUITE_P(
    Values, BadWorldTest,
    testing::Values(
        Bad{"[[shot]]\n[world]\nstep = \"1 m\"",
            "f.toml:4:8: error: world.step: \"1 m\" is a length; expected a time such as \"2.5 s\""},
        Bad{"[[shot]]\n[world]\nstep = 0",
            "f.toml:4:8: error: world.step: 0 is out of range; must be > 0, <= 10 s; a bare number is in s"},
        Bad{"[[shot]]\n[world]\nthreads = 1.5",
            "f.toml:4:11: error: world.threads: 1.5 is not a whole number; expected a whole number such as 1000"},
        Bad{"[[shot]]\nbody = { layers = -1 }\n[world]",
            "f.toml:3:19: error: shot.body.layers: -1 is out of range; must be 0 .. 4294967295"},
        Bad{"[[shot]]\n[world]\n[[volley]]\nshot = \"shot-1\"\nrate = \"10 rp\"",
            "f.toml:6:8: error: volley.rate: unknown unit \"rp\" in \"10 rp\"; did you mean \"rpm\"?"},
        Bad{"[[shot]]\n[world]\n[[volley]]\nshot = \"shot-1\"\nspread = { horizontal = \"-1 deg\" }",
            "f.toml:6:25: error: volley.spread.horizontal: \"-1 deg\" is out of range; must be 0 .. 180 deg"},
        Bad{"[[shot]]\n[world]\n[[force]]\nshots = [1]",
            "f.toml:5:10: error: force.shots: found a number; expected a text in quotes"},
        Bad{"[[shot]]\n[world]\n[[force]]\nshots = 5",
            "f.toml:5:9: error: force.shots: found a number; expected a list of texts such as [\"a\", \"b\"]"},
        Bad{"[[shot]]\n[world]\n[[force]]\npoint_attractor = { strength = \"3 kg\" }",
            "f.toml:5:32: error: force.point_attractor.strength: \"3 kg\" is a mass; expected an attraction (G M) such "
            "as \"2000 m^3/s^2\""}));

INSTANTIATE_TEST_SUITE_P(
    Contradictions, BadWorldTest,
    testing::Values(
        Bad{"[[shot]]\n[[volley]]\nshot = \"shot-1\"",
            "f.toml:3:1: error: volley: there is no [world] for it; write [world], and the shots fly in it"},
        Bad{"[[shot]]\nbody = { restitution = 1 }",
            "f.toml:3:24: error: shot.body.restitution: there is no [world] for it; write [world], and the shots fly "
            "in it"},
        Bad{"[[shot]]\n[world]\n[until]\nground = 3",
            "f.toml:4:1: error: until: not used in a [world]; world.duration and shot.body.despawn end things"},
        Bad{"[[shot]]\nname = \"gun\"\n[world]\n[[volley]]\nshot = \"gum\"",
            "f.toml:6:8: error: volley.shot: no shot is named \"gum\"; did you mean \"gun\"?"},
        Bad{"[[shot]]\n[world]\n[[volley]]\nshot = \"shot-1\"\nrate = 1\ninterval = 1",
            "f.toml:6:8: error: volley.rate: given together with interval; give one of them"},
        Bad{"[[shot]]\n[[shot]]\n[world]\n[[volley]]\nshot = \"shot-1\"\nname = \"shot-2\"",
            "f.toml:7:8: error: volley.name: another volley or shot is named \"shot-2\"; give it a name of its own"},
        Bad{"[[shot]]\nbody = { pool = \"smal\" }\n[world]\npools = [{ name = \"small\" }]",
            "f.toml:3:17: error: shot.body.pool: no pool is named \"smal\"; did you mean \"small\"?"},
        Bad{"[[shot]]\n[world]\npools = [{ name = \"a\" }, { name = \"a\" }]",
            "f.toml:4:35: error: world.pools.name: two pools are named \"a\""},
        Bad{"[[shot]]\n[world]\n[world.detail]\nrungs = [{ fidelity = \"game\" }]",
            "f.toml:3:1: error: world (detail.rungs): must be two or three; none: no rule"},
        Bad{"[[shot]]\nbody = { despawn = { outside_box = true } }\n[world]",
            "f.toml:3:8: error: shot (body.despawn.box_low): must lie below box_high in every axis; swap the corners"},
        Bad{"[[shot]]\n[world]\n[[force]]\nconstant_force = {}\ngravity_force = {}",
            "f.toml:6:1: error: force: it has two laws, constant_force and gravity_force; write a [[force]] for each"},
        Bad{"[[shot]]\n[world]\n[[force]]\nconstant_force = {}\nshots = \"shot-2\"",
            "f.toml:6:9: error: force.shots: no shot is named \"shot-2\"; did you mean \"shot-1\"?"},
        Bad{"[[shot]]\n[world]\n[[force]]\nthrust = {}",
            "f.toml:5:10: error: force.thrust (force.curve): needs two points or more; thrust is zero outside of its "
            "points"},
        Bad{"[[shot]]\n[[shot]]\n[world]\n[[volley]]\nshot = \"shot-1\"\n[[force]]\nspring = { other = \"shot-1\" }",
            "f.toml:8:20: error: force.spring.other: \"shot-1\" is fired by a volley; name a shot that no volley "
            "fires: "
            "there is one of it"},
        Bad{"[[shot]]\n[world]\n[[expect]]\nquantity = \"drop\"\nequals = 1\nwithin = 1",
            "f.toml:5:12: error: expect.quantity: \"drop\" is a figure of single flights; in a world there are: speed, "
            "x, y, z, vx, vy, vz, spawned, refused, landed, bounces, slept, expired, retired, hits, alive, "
            "impact_range, "
            "impact_range_min, impact_range_max, impact_range_spread, impact_time, impact_speed, apex, apex_max, "
            "hit_y, hit_z, hit_y_spread, hit_z_spread, ricochets, penetrations, ..."},
        Bad{"[[shot]]\n[[expect]]\nquantity = \"hits\"\nequals = 1\nwithin = 1",
            "f.toml:4:12: error: expect.quantity: \"hits\" is a figure of a [world]; write [world], and the shots fly "
            "in it"},
        Bad{"[[shot]]\n[world]\n[[expect]]\nquantity = \"hits\"\nequals = 1\nwithin = 1\nat = \"apex\"",
            "f.toml:8:6: error: expect.at: a world is looked at when its run is over; leave it out"},
        Bad{"[[shot]]\n[world]\n[[expect]]\nshot = \"x\"\nquantity = \"hits\"\nequals = 1\nwithin = 1",
            "f.toml:5:8: error: expect.shot: nothing is counted as \"x\"; there are: shot-1"}));

TEST(BadWorld, AForceWithoutALawNamesThem) {
  const Result<Scenario> scenario = parse_scenario("physim = 1\n[[shot]]\n[world]\n[[force]]\ndelay = 1", "f.toml");
  ASSERT_FALSE(scenario.ok());
  EXPECT_EQ(scenario.error().place, "f.toml:4:1");
  EXPECT_TRUE(scenario.error().hint.starts_with("give one of: constant_force, ")) << scenario.error().hint;
}

TEST(BadWorld, WithoutAWorldThereIsNoRun) {
  const Result<WorldRun> run = WorldRun::create(*parse_scenario("physim = 1\n[[shot]]\n", "f.toml"));
  ASSERT_FALSE(run.ok());
  EXPECT_EQ(run.error().text(), "f.toml: error: the scenario has no [world]; write [world] into it");
}

TEST(BadWorld, AnImpossibleLaunchNamesItsShot) {
  const Scenario scenario = must(parse_scenario(
      "physim = 1\n[[shot]]\nname = \"slow\"\nspeed = 5\nsight = { zero_range = 1000 }\n[world]\n", "f.toml"));
  const Result<WorldRun> run = WorldRun::create(scenario);
  ASSERT_FALSE(run.ok());
  EXPECT_TRUE(run.error().place.starts_with("f.toml: shot \"slow\"")) << run.error().text();
}

}  // namespace physim::scenario_world_errors_test
