// Points of lists that are uncertain, as scenarios write them.
#include <numeric>
#include <set>

#include "scenario/overrides.hpp"
#include "scenario/reader.hpp"
#include "scenario/scenario.hpp"
#include "settings/units.hpp"
#include "support.hpp"

namespace physim::scenario_study_points_test {

constexpr const char* kShot = "physim = 1\n[[shot]]\nname = \"a\"\nspeed = 300\nmass = 1\n";

Result<Study> study_in(const std::string& text) {
  const auto scenario = parse_scenario(text, "test.toml");
  if (!scenario) return scenario.error();
  return study_of(*scenario, scenario->shots[0]);
}

/// As the scenario stands, and as it is written and read again.
void expect_inputs(const Scenario& scenario, const std::vector<StudyInput>& expected) {
  for (const auto& study : {study_of(scenario, scenario.shots[0]), study_in(scenario_text(scenario))}) {
    ASSERT_TRUE(study) << study.error().text();
    EXPECT_EQ(study->inputs, expected);
  }
}

TEST(StudyPointsText, inputs_have_the_unit_of_their_points) {
  const auto input = [](const char* text) { return must(parse_study_input(text)); };
  EXPECT_EQ(input("shot.drag.curve.3 = 0.23 +- 0.01"),
            (StudyInput{"shot.drag.curve.3", NormalDistribution{0.23, 0.01}}));
  EXPECT_EQ(input("shot.motor.thrust.4 = 1 kN +- 20 N").distribution, Distribution(NormalDistribution{1000, 20}));
  EXPECT_EQ(input("shot.motor.propellant.2 = 1 g .. 2 g").distribution, Distribution(UniformDistribution{1e-3, 2e-3}));
  EXPECT_EQ(input("environment.wind.profile.2.velocity.x = 36 km/h +- 3.6 km/h").distribution,
            Distribution(NormalDistribution{10, 1}));
  EXPECT_EQ(input("shot.drag.bands.1.ballistic_coefficient = 300 kg/m^2 +- 5 kg/m^2").distribution,
            Distribution(NormalDistribution{300, 5}));
  EXPECT_EQ(input("shot.motor.thrust = +- 0.03").distribution, Distribution(NormalDistribution{0, 0.03}))
      << "the factor has no unit";
  const auto refused = [](const char* text) {
    const auto read = parse_study_input(text);
    return read ? std::string("none") : read.error().text();
  };
  EXPECT_NE(refused("shot.drag.curv.3 = 0.23 +- 0.01").find("did you mean \"shot.drag.curve.N\""), std::string::npos)
      << refused("shot.drag.curv.3 = 0.23 +- 0.01");
  EXPECT_NE(refused("shot.motor.thrust.4 = 1 kg +- 2 kg").find("kg"), std::string::npos);
}

TEST(StudyPointsText, places_of_points_have_units_of_their_own) {
  const auto drawn = [](const char* text) { return must(parse_study_input(text)).distribution; };
  const Distribution half_second = NormalDistribution{0.5, 0.02};
  EXPECT_EQ(drawn("shot.motor.thrust.4.time = 500 ms +- 20 ms"), half_second);
  EXPECT_EQ(drawn("shot.motor.propellant.2.time = 0.5 s +- 0.02 s"), half_second);
  EXPECT_EQ(drawn("shot.drag.curve.3.mach = 0.5 +- 0.02"), half_second);
  EXPECT_EQ(drawn("shot.aero.lift_cubic.1.mach = 0.5 +- 0.02"), half_second);
  EXPECT_EQ(drawn("shot.aero.magnus_moment.1.angle_squared = 0.5 +- 0.02"), half_second);
  EXPECT_EQ(drawn("shot.drag.bands.1.above = 36 km/h +- 3.6 km/h"), Distribution(NormalDistribution{10, 1}));
  EXPECT_EQ(drawn("environment.wind.profile.2.at = 1 km +- 20 m"), Distribution(NormalDistribution{1000, 20}));
  EXPECT_EQ(drawn("shot.magnus.table.2.spin = 0 rad/s .. 10 rad/s"), Distribution(UniformDistribution{0, 10}));
  for (const char* wrong : {"shot.motor.thrust.4.time = 1 N +- 1 N", "shot.drag.curve.3.mach = 5 m/s +- 1 m/s",
                            "shot.aero.lift.1.angle_squared = 1 +- 0.1", "shot.motor.thrust.time = 1 s +- 1 s",
                            "environment.wind.profile.2.at = 1 m/s +- 1 m/s"})
    EXPECT_FALSE(parse_study_input(wrong)) << wrong;
}

TEST(StudyPointsText, every_number_of_a_study_may_be_a_distribution_where_it_stands) {
  std::size_t found = 0;
  for (const StudyPath& known : study_paths()) {
    const SchemaNode* node = find_node(known.path);
    if (node == nullptr || node->entry == nullptr) continue;  // components, points, wind by compass
    if (node->entry->by_factor) continue;                     // the factor of a list stands in study.inputs alone
    auto document = must(parse_document(kShot, "test.toml"));
    const Range& range = node->entry->range;
    const double mean = !std::isfinite(range.low)   ? 0.5
                        : std::isfinite(range.high) ? std::midpoint(range.low, range.high)
                                                    : range.low + 0.5;
    const std::string text = number_text(mean) + " +- 0.01";
    ASSERT_TRUE(apply_override(document, known.path + " = " + text)) << known.path;
    Scenario scenario;
    ASSERT_TRUE(read_scenario(document, "test.toml", Checks::of_each, scenario));
    EXPECT_EQ(scenario.study.inputs, std::vector<std::string>{known.path + " = " + text});
    ++found;
  }
  EXPECT_GT(found, 30u);
}

TEST(StudyPointsText, points_are_distributions_and_their_means_are_flown) {
  const std::string text =
      std::string(kShot) +
      "drag = { table = \"custom\", curve = [[0.5, \"0.23 +- 0.01\"], [1, 0.4], [2, { low = 0.2, high "
      "= 0.4 }]] }\nmotor = { thrust = [[0, 0], [\"1 s\", \"40 N +- 2 N per occasion\"], [2, 0]] }\n"
      "aero = { lift = \"2 +- 0.1\", magnus_moment = [[1, 0, 0.3], [1, 4, \"0.1 .. 0.3\"]] }\n"
      "[environment.wind]\nprofile = [{ at = 0, velocity = [0, 0, 1] }, { at = \"100 m\", velocity = "
      "[0, 0, \"4 m/s +- 1 m/s\"] }]\n[study]\nrounds = 16\ninputs = [\"shot.speed = +- 1 m/s\"]\n";
  const auto scenario = must(parse_scenario(text, "test.toml"));
  const ProjectileDef& p = scenario.shots[0].projectile;
  EXPECT_EQ(p.drag.curve, (std::vector<DragPoint>{{0.5, 0.23}, {1, 0.4}, {2, 0.5 * (0.2 + 0.4)}}));
  EXPECT_EQ(p.motor.thrust[1], (ThrustPoint{1, 40}));
  EXPECT_EQ(p.aero.lift[0].value, 2);
  EXPECT_EQ(scenario.environment.wind.profile[1].velocity, (Vec3d{0, 0, 4}));
  const std::vector<StudyInput> expected = {
      {"shot.drag.curve.1", NormalDistribution{0.23, 0.01}},
      {"shot.drag.curve.3", UniformDistribution{0.2, 0.4}},
      {"shot.motor.thrust.2", NormalDistribution{40, 2}, DrawnFor::occasion},
      {"shot.aero.lift.1", NormalDistribution{2, 0.1}},
      {"shot.aero.magnus_moment.2", UniformDistribution{0.1, 0.3}},
      {"environment.wind.profile.2.velocity.z", NormalDistribution{4, 1}},
      {.path = "shot.speed", .distribution = NormalDistribution{0, 1}, .added = true}};
  expect_inputs(scenario, expected);
}

TEST(StudyPointsText, places_of_points_are_distributions_too) {
  const std::string text =
      std::string(kShot) +
      "drag = { table = \"custom\", curve = [[0.5, 0.2], [\"0.9 +- 0.01\", \"0.40 +- 0.02\"], [2, 0.3]] }\n"
      "motor = { thrust = [[0, 0], [{ mean = \"1 s\", deviation = \"50 ms\" }, 40], [2, 0]], propellant_mass = 0.1, "
      "propellant = [[0, 0.1], [\"0.9 s .. 1.1 s\", 0.05], [2, 0]] }\n"
      "aero = { magnus_moment = [[\"1 +- 0.1\", 0, 0.3], [\"2 +- 0.1\", 4, 0.2]] }\n"
      "magnus = { measure = \"parameter\", table = [{ speed = \"30 m/s +- 1 m/s\", spin = \"0.1 .. 0.2\", "
      "drag = 0.3, lift = 0.2 }] }\n"
      "[environment.wind]\nprofile = [{ at = 0, velocity = [0, 0, 1] }, { at = \"100 m +- 10 m\", velocity = "
      "[0, 0, 4] }]\n";
  const auto scenario = must(parse_scenario(text, "test.toml"));
  const ProjectileDef& p = scenario.shots[0].projectile;
  EXPECT_EQ(p.drag.curve[1], (DragPoint{0.9, 0.4})) << "means are flown";
  EXPECT_EQ(p.motor.thrust[1], (ThrustPoint{1, 40}));
  EXPECT_EQ(scenario.environment.wind.profile[1].at, 100);
  const std::vector<StudyInput> expected = {{"shot.drag.curve.2", NormalDistribution{0.4, 0.02}},
                                            {"shot.drag.curve.2.mach", NormalDistribution{0.9, 0.01}},
                                            {"shot.motor.thrust.2.time", NormalDistribution{1, 0.05}},
                                            {"shot.motor.propellant.2.time", UniformDistribution{0.9, 1.1}},
                                            {"shot.magnus.table.1.speed", NormalDistribution{30, 1}},
                                            {"shot.magnus.table.1.spin", UniformDistribution{0.1, 0.2}},
                                            {"shot.aero.magnus_moment.1.mach", NormalDistribution{1, 0.1}},
                                            {"shot.aero.magnus_moment.2.mach", NormalDistribution{2, 0.1}},
                                            {"environment.wind.profile.2.at", NormalDistribution{100, 10}}};
  expect_inputs(scenario, expected);
}

/// A shot with a curve and a motor, points of which are drawn, and what goes with what.
std::string correlated(const std::string& list) {
  return std::string(kShot) +
         "drag = { table = \"custom\", curve = [[0.5, \"0.20 +- 0.01\"], [0.9, \"0.40 +- 0.02\"], [2, 0.3]] }\n"
         "motor.thrust = [[0, \"40 +- 2\"], [0.5, \"40 +- 2\"], [1, 0]]\n"
         "[study]\ninputs = [\"shot.speed = +- 3 m/s\"]\ncorrelated = [" +
         list + "]\n";
}

TEST(StudyPointsText, points_go_together_by_their_distance) {
  const auto scenario = must(parse_scenario(
      correlated("\"shot.drag.curve.N by distance = 0.2\", \"shot.motor.thrust.N by distance = 250 ms\", "
                 "\"shot.speed with shot.motor.thrust.1 = 0.5\""),
      "test.toml"));
  for (const auto& study : {study_of(scenario, scenario.shots[0]), study_in(scenario_text(scenario))}) {
    ASSERT_TRUE(study) << study.error().text();
    const auto path = [&](std::size_t input) { return study->inputs[input].path; };
    ASSERT_EQ(study->correlated.size(), 2u) << "what a pair connects is one group";
    for (const StudyCorrelation& with : study->correlated) {
      const std::size_t n = with.inputs.size();
      for (std::size_t i = 0; i < n; ++i)
        for (std::size_t j = 0; j < i; ++j) {
          const std::set<std::string> pair{path(with.inputs[i]), path(with.inputs[j])};
          double expected = 0;
          if (pair == std::set<std::string>{"shot.drag.curve.1", "shot.drag.curve.2"}) expected = std::exp(-2);
          if (pair == std::set<std::string>{"shot.motor.thrust.1", "shot.motor.thrust.2"}) expected = std::exp(-2);
          if (pair == std::set<std::string>{"shot.motor.thrust.1", "shot.speed"}) expected = 0.5;
          EXPECT_NEAR(with.matrix[i * n + j], expected, 1e-15) << *pair.begin() << ' ' << *pair.rbegin();
        }
    }
    EXPECT_TRUE(plan_study(*study)) << plan_study(*study).error().text();
  }
}

TEST(StudyPointsText, distances_have_the_unit_of_places) {
  const auto refused = [](const char* text) {
    const auto study = study_in(correlated(text));
    return study ? std::string("accepted") : study.error().text();
  };
  const auto expect = [&](const char* text, const char* words) {
    const std::string told = refused(text);
    EXPECT_NE(told.find(words), std::string::npos) << text << ": " << told;
    EXPECT_NE(told.find("study.correlated["), std::string::npos) << told;
  };
  expect("\"shot.drag.curve.N by distance = 250 ms\"", "ms");
  expect("\"shot.motor.thrust.N by distance = 3 m\"", "m");
  expect("\"shot.drag.curve.N by distance = 0\"", "positive");
  expect("\"shot.drag.curve.N by distance = wide\"", "wide");
  expect("\"shot.drag.curv.N by distance = 0.2\"", "no list of points");
  expect("\"shot.speed by distance = 0.2\"", "name one with its N");
  expect("\"shot.aero.lift.N by distance = 0.2\"", "fewer than two points");
  expect("\"shot.drag.curve.N near 0.2\"", "is no correlation");
  expect("\"shot.drag.curve.N by distance = 0.2\", \"shot.drag.curve.2 with shot.drag.curve.1 = 0.5\"",
         "has a correlation already");
}

/// What goes with what in one of several shots is none of the others' concern.
TEST(StudyPointsText, correlations_name_the_shot_that_they_are_of) {
  const std::string shots =
      "physim = 1\n[[shot]]\nname = \"a\"\nspeed = \"300 m/s +- 3 m/s\"\nmass = \"1 kg +- 10 g\"\n"
      "drag = { table = \"custom\", curve = [[0.5, \"0.20 +- 0.01\"], [0.9, \"0.40 +- 0.02\"]] }\n"
      "[[shot]]\nname = \"b\"\nspeed = \"300 m/s +- 3 m/s\"\nmass = 1\n[study]\n";
  const auto scenario = must(parse_scenario(
      shots + "inputs = [\"environment.wind.velocity.x = +- 1 m/s\"]\n"
              "correlated = [\"shot.a.speed with shot.a.mass = 0.5\", \"shot.a.drag.curve.N by distance = 0.2\",\n"
              "\"shot.b.speed with environment.wind.velocity.x = 0.25\"]\n",
      "test.toml"));
  const auto a = study_of(scenario, scenario.shots[0]), b = study_of(scenario, scenario.shots[1]);
  ASSERT_TRUE(a) << a.error().text();
  ASSERT_TRUE(b) << b.error().text();
  const auto paths = [](const Study& study, const StudyCorrelation& with) {
    std::set<std::string> names;
    for (const std::size_t input : with.inputs) names.insert(study.inputs[input].path);
    return names;
  };
  ASSERT_EQ(a->correlated.size(), 2u);
  EXPECT_EQ(paths(*a, a->correlated[0]), (std::set<std::string>{"shot.speed", "shot.mass"}));
  EXPECT_EQ(paths(*a, a->correlated[1]), (std::set<std::string>{"shot.drag.curve.1", "shot.drag.curve.2"}));
  ASSERT_EQ(b->correlated.size(), 1u);
  EXPECT_EQ(paths(*b, b->correlated[0]), (std::set<std::string>{"shot.speed", "environment.wind.velocity.x"}));
  const auto two = parse_scenario(shots + "correlated = [\"shot.a.speed with shot.b.speed = 0.5\"]\n", "test.toml");
  ASSERT_FALSE(two);
  EXPECT_NE(two.error().text().find("error: study.correlated[0]: shot.a.speed and shot.b.speed are of two shots"),
            std::string::npos)
      << two.error().text();
}

TEST(StudyPointsText, a_parameter_has_no_unit) {
  const auto drawn = [](const char* measure, const char* spin) {
    return study_in(std::string(kShot) + "magnus = { measure = \"" + measure + "\", table = [{ speed = 30, spin = \"" +
                    spin + "\", drag = 0.3, lift = 0.2 }] }\n");
  };
  EXPECT_TRUE(drawn("rate", "5 rpm +- 1 rpm"));
  EXPECT_TRUE(drawn("parameter", "0.2 +- 0.1"));
  const auto wrong = drawn("parameter", "5 rpm +- 1 rpm");
  ASSERT_FALSE(wrong);
  EXPECT_NE(wrong.error().text().find("rpm"), std::string::npos) << wrong.error().text();
}

TEST(StudyPointsText, points_of_lists_of_tables_and_of_one_of_several_shots) {
  const std::string bands =
      "drag = { table = \"g7\", bands = [{ above = 200, ballistic_coefficient = { mean = 300, deviation = 5 } }, { "
      "ballistic_coefficient = 310 }] }\n";
  const auto study = must(study_in(std::string(kShot) + bands + "[[shot]]\nname = \"b\"\nspeed = 300\nmass = 1\n"));
  EXPECT_EQ(study.inputs,
            (std::vector<StudyInput>{{"shot.drag.bands.1.ballistic_coefficient", NormalDistribution{300, 5}}}));
  const std::string override = "shot.drag={ table = \"custom\", curve = [[0, \"0.2 +- 0.01\"]] }";
  const auto set = must(parse_scenario(kShot, "test.toml", {&override, 1}));
  EXPECT_EQ(set.study.inputs, (std::vector<std::string>{"shot.drag.curve.1 = 0.2 +- 0.01"}));
}

TEST(StudyPointsText, what_is_wrong_is_told_where_it_stands) {
  const auto with = [](std::string_view curve) {
    std::string text = kShot;
    text.append("drag.table = \"custom\"\ndrag.curve = ").append(curve).append("\n");
    return study_in(text);
  };
  const auto study = with("[[0.5, \"0.23 +- -0.01\"]]");
  ASSERT_FALSE(study);
  EXPECT_NE(study.error().text().find("test.toml:7:21: error: shot.drag.curve.1: "), std::string::npos)
      << study.error().text();
  const auto mach = with("[[\"0.5 +- 0.1 s\", 0.2]]");
  ASSERT_FALSE(mach);
  EXPECT_NE(mach.error().text().find("test.toml:7:16: error: shot.drag.curve.1.mach: "), std::string::npos)
      << mach.error().text();
  const auto means = with("[[0.5, 0.2], [\"0.4 +- 0.01\", 0.3]]");
  ASSERT_FALSE(means) << "means are out of order";
  EXPECT_NE(means.error().text().find("test.toml:7:28: "), std::string::npos) << means.error().text();
  const std::string angle = "aero.magnus_moment = [[1, \"4 +- 1\", 0.3]]\n";
  const auto squared = study_in(kShot + angle);
  ASSERT_FALSE(squared) << "square degrees";
  EXPECT_NE(squared.error().text().find("test.toml:6:27: "), std::string::npos) << squared.error().text();
}

}  // namespace physim::scenario_study_points_test
