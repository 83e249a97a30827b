#include "asked.hpp"

#include <cmath>

#include "base/text.hpp"
#include "outputs.hpp"
#include "report/summary.hpp"
#include "report/table.hpp"
#include "scenario/units.hpp"
#include "terminal.hpp"

namespace physim::cli {

void add_scenario_options(Command& command, ScenarioInput& input) {
  command.add_option("FILE", input.file, "Scenario file (TOML)").required();
  command
      .add_option("--set", input.overrides,
                  "Replace a setting of the file: --set shot.mass=\"170 gr\" for every shot, --set shot.NAME.mass=... "
                  "for one; `physim list settings` names them all. May be given many times")
      .type_name("KEY=VALUE")
      .one_value_each();
}

void add_question_options(Command& command, Question& question, bool json) {
  add_scenario_options(command, question.input);
  command.add_option("--shot", question.shot, "NAME", "Which shot; without it the first");
  if (json)
    command.add_output("--json", question.json, "FILE",
                       "Write the answer as JSON; - is the standard output, and then nothing else goes there");
}

Result<Scenario> load(const ScenarioInput& input) {
  std::vector<std::string> overrides = input.overrides;
  const std::string ranges = "output.ranges=" + input.ranges;
  if (!input.ranges.empty()) overrides.push_back(ranges);
  const auto by_option = [&](std::string& text) {
    if (!input.ranges.empty()) replace_all(text, "--set " + ranges, "--ranges");
  };
  Result<Scenario> scenario = load_scenario(input.file, overrides, input.has_complete_study);
  if (!scenario) {
    Error error = scenario.error();
    for (std::string* text : {&error.place, &error.message, &error.hint}) by_option(*text);  // there may be several
    return error;
  }
  for (std::string& note : scenario->notes) {
    by_option(note);
    print_warning(note);
  }
  return scenario;
}

Result<AskedShot> ask(const Question& question) {
  if (!question.json.empty())
    if (Status status = check_output(question.json); !status) return status.error();
  Result<Scenario> scenario = load(question.input);
  if (!scenario) return scenario.error();
  const Result<std::size_t> index = find_shot(*scenario, question.shot);
  if (!index) return index.error();
  scenario->shots[*index] = as_flown(std::move(scenario->shots[*index]));
  return AskedShot{*std::move(scenario), *index};
}

void warn_of_things(const Scenario& scenario, const std::string& answer) {
  if (!scenario.things.empty())
    print_warning("the things of the scenario are left aside: " + answer + " is of shots that meet nothing");
}

void warn_of_fidelity(const ScenarioShot& shot, const std::string& answer) {
  if (shot.cheapest_within)
    print_warning("shot.fidelity.cheapest_within has no effect: " + answer + " is of flights at shot.fidelity itself");
}

void warn_of_curve(const Flight& flight) {
  if (flight.error()) return;  // its command says so
  for (const std::string& note : curve_notes(flight))
    print_warning("shot \"" + one_line(flight.projectile().name) + "\": " + note);
}

void warn_of_curve(const Scenario& scenario, const ScenarioShot& shot) {
  if (has_own_curve(shot.projectile)) warn_of_curve(fly_shot(scenario, shot));
}

Result<AskedShot> ask_without_things(const Question& question, const std::string& answer) {
  Result<AskedShot> asked = ask(question);
  if (!asked) return asked;
  warn_of_things(asked->scenario, answer);
  if (asked->scenario.world.given) return asked;  // they stand in the world alone, and emitters may name their shapes
  asked->scenario.materials.clear();
  asked->scenario.shapes.clear();
  asked->scenario.things.clear();
  return asked;
}

Result<std::optional<double>> option_value(const char* option, const std::string& text, Quantity quantity) {
  if (text.empty()) return std::optional<double>();
  const Result<double> value = parse_quantity(text, quantity);
  if (value && std::isfinite(*value)) return std::optional<double>(*value);
  Error error = value ? Error{.message = "must be a finite number"} : value.error();
  error.place = option;
  return error;
}

Result<std::optional<Vec3d>> option_vector(const char* option, const std::string& text, Quantity quantity) {
  if (text.empty()) return std::optional<Vec3d>();
  double v[3] = {};
  std::size_t from = 0;
  for (int i = 0; i < 3; ++i) {
    const std::size_t comma = text.find(',', from);
    if ((comma == std::string::npos) != (i == 2))
      return Error{.message = "\"" + text + "\" is no vector",
                   .place = option,
                   .hint = "expected three values with commas between, as in \"500 m, 20 m, 0 m\""};
    const std::string part(trimmed(std::string_view(text).substr(from, comma - from)));
    if (part.empty()) return Error{.message = "a component is empty", .place = option, .hint = "write 0 for none"};
    const auto value = option_value(option, part, quantity);
    if (!value) return value.error();
    v[i] = **value;
    from = comma + 1;
  }
  return std::optional<Vec3d>({v[0], v[1], v[2]});
}

const char* option_of(const Error& error, std::initializer_list<OptionOfError> options) {
  for (const auto& [option, is_given, member] : options)
    if (is_given && error.place == member) return option;
  return nullptr;
}

Error about(const AskedShot& asked, Error error, std::initializer_list<OptionOfError> options) {
  const char* option = option_of(error, options);
  if (option == nullptr) return about(asked, std::move(error));
  error.place = option;
  return error;
}

Status give(const Question& question, const Answer& answer) {
  if (!question.json.empty())
    if (Status status = write_output(question.json, answer.json); !status) return status;
  return question.json == "-" ? Status() : print(answer.text);
}

}  // namespace physim::cli
