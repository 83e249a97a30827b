// Mistakes of a [study] have the place of their text, whichever command reads the file.
#include <gtest/gtest.h>

#include "must.hpp"
#include "scenario/scenario.hpp"
#include "scenario/study_text.hpp"

namespace physim::scenario_study_errors_test {

const std::string kShot =
    "physim = 1\n[[shot]]\nmass = \"10 g\"\ndiameter = \"7.82 mm\"\n"
    "drag = { table = \"g7\", ballistic_coefficient = 170 }\nspeed = \"800 m/s\"\n[until]\nrange = \"600 m\"\n";
const std::string kInput = "[study]\ninputs = [\"shot.speed = 800 m/s +- 3 m/s\"]\n";  // lines 9 and 10

std::string error_of(const std::string& text, const std::vector<std::string>& overrides = {}) {
  const Result<Scenario> scenario = parse_scenario(kShot + text, "f.toml", overrides);
  return scenario.ok() ? "no error" : scenario.error().text();
}

void expect_begins(const std::string& text, const std::string& begin) {
  EXPECT_TRUE(text.starts_with(begin)) << text << "\ninstead of\n" << begin;
}

TEST(StudyErrors, inputs_have_their_places) {
  expect_begins(
      error_of("[study]\ninputs = [\n  \"shot.speed = 800 m/s +- 3 m/s\",\n  \"shot.mass = 10 g +- -1 g\"]\n"),
      "f.toml:12:3: error: study.inputs[1].distribution.deviation: must be a positive number, not ");
  expect_begins(error_of("[study]\ninputs = [\"shot.speeed = 800 m/s +- 3 m/s\"]\n"),
                "f.toml:10:11: error: study.inputs[0]: no number of a shot that may be uncertain is called \"shot.sp");
  expect_begins(error_of("[study]\ninputs = \"shot.speed = 800 m +- 3 m\"\n"),
                "f.toml:10:10: error: study.inputs[0]: ");
  expect_begins(error_of("[study]\ninputs = [\"shot.speed = 8 m/s +- 3 m/s\", \"shot.speed = 8 m/s +- 1 m/s\"]\n"),
                "f.toml:10:42: error: study.inputs[1].path: shot.speed is drawn by inputs[0] already");
  expect_begins(error_of("[study]\ninputs = [\"shot.speed = 800 m/s +- 3 m/s per occasion\"]\n"),
                "f.toml:9:1: error: study.rounds: an occasion has one shot, and inputs[0] is drawn once");
}

TEST(StudyErrors, the_other_lists_have_theirs) {
  expect_begins(error_of(kInput + "targets = [\"plate: rectangle -45 cm x 75 cm\"]\n"),
                "f.toml:11:12: error: study.targets[0].width: must be a positive number, not -0.45");
  expect_begins(error_of(kInput + "targets = [\"a: circle 1 m\", \"a: circle 2 m\"]\n"),
                "f.toml:11:29: error: study.targets[1]: has the name \"a\" of targets[0]");
  expect_begins(error_of(kInput + "at = [\"100 m\",\n \"100 m\"]\n"),
                "f.toml:12:2: error: study.at[1]: is the place of at[0] again");
  expect_begins(error_of(kInput + "at = [\"apox\"]\n"),
                "f.toml:11:7: error: study.at[0]: no place on the way is called");
  expect_begins(error_of(kInput + "quantities = [\"right\", \"upp\"]\n"), "f.toml:11:24: error: study.quantities[1]: ");
  expect_begins(error_of(kInput + "correlated = [\"shot.speed with shot.mass = 0.5\"]\n"),
                "f.toml:11:15: error: study.correlated[0]: ");
  expect_begins(error_of(kInput + "aim = \"0 m\"\n"), "f.toml:11:7: error: study.aim: ");
  expect_begins(error_of(kInput + "histograms = 2\n"), "f.toml:11:14: error: study.histograms: must be from 3 to 1000");
  expect_begins(error_of(kInput + "rounds = 2\nsampling = \"sobol\"\n"),
                "f.toml:11:10: error: study.rounds: Sobol's sequence knows no occasions");
}

TEST(StudyErrors, an_override_is_named_as_the_option_that_it_is) {
  expect_begins(error_of(kInput, {"study.at=[\"apox\"]"}), "--set study.at=[\"apox\"]: error: study.at[0]: no place");
  expect_begins(error_of(kInput, {"study.inputs=[\"shot.mass = 10 g +- -1 g\"]"}),
                "--set study.inputs=[\"shot.mass = 10 g +- -1 g\"]: error: study.inputs[0].distribution.deviation: ");
}

/// A study has the inputs of its own shot alone; an error names the text.
TEST(StudyErrors, inputs_of_other_shots_count_among_the_texts) {
  Scenario asked = must(parse_scenario(kShot + "[[shot]]\nname = \"t\"\nspeed = \"1 m/s\"\n", "f.toml", {}));
  asked.shots[0].projectile.name = "s";
  asked.study.inputs = {"shot.t.mass = 1 kg +- 0.1 kg", "shot.s.speed = 8 m/s +- 1 m/s",
                        "shot.s.speed = 8 m/s +- 2 m/s", "shot.s.mass = -2 kg .. -1 kg"};
  asked.study.correlated = {"shot.s.mass with shot.s.speed = 0.5", "shot.t.mass with shot.t.speed = 0.5"};
  asked.study.places = {{"inputs", "f.toml:1"},         {"inputs[0]", "f.toml:2"},     {"inputs[1]", "f.toml:3"},
                        {"inputs[2]", "f.toml:4"},      {"inputs[3]", "--vary"},       {"correlated", "f.toml:9"},
                        {"correlated[0]", "f.toml:10"}, {"correlated[1]", "f.toml:11"}};
  const auto told = [&](const Error& error) { return in_study(asked, asked.shots[0], error).text(); };
  EXPECT_EQ(told({"shot.speed is drawn by inputs[0] already", "inputs[1].path", "let one be added"}),
            "f.toml:4: error: study.inputs[2].path: shot.speed is drawn by inputs[1] already; let one be added");
  EXPECT_EQ(told({"is a text", "study.inputs[1]", ""}), "f.toml:3: error: study.inputs[1]: is a text");
  EXPECT_EQ(told({"must be positive", "projectile.mass", ""}),
            "--vary: error: study.inputs[3]: shot.mass: must be positive");
  EXPECT_EQ(told({"is not positive definite", "correlated[0].matrix", ""}),
            "f.toml:9: error: study.correlated.matrix: is not positive definite");
  EXPECT_EQ(told({"must be positive", "projectile.diameter", ""}), "projectile.diameter: error: must be positive");
  const auto inputs = inputs_of(asked, asked.shots[1]);
  ASSERT_EQ(inputs.size(), 1U);
  EXPECT_EQ(inputs[0].written, "shot.mass = 1 kg +- 0.1 kg");
}

TEST(StudyErrors, a_study_of_one_of_several_shots_is_good) {
  const std::string zeroed =
      "[study]\ninputs = [\"shot.elevation = 1 deg +- 0.1 deg\"]\n[[shot]]\nspeed = \"800 m/s\"\n"
      "sight = { zero_range = \"100 m\" }\n";
  EXPECT_EQ(error_of(zeroed), "no error");  // the first shot has no zero range
  EXPECT_EQ(error_of("[study]\nshots = 1000\ntargets = [\"circle 10 cm\"]\n"), "no error");  // inputs by --vary
}

}  // namespace physim::scenario_study_errors_test
