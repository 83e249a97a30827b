// What commands that answer one question about one shot share: the shot, values with units, results on their way out.
#pragma once

#include "command.hpp"
#include "report/answer.hpp"

namespace physim::cli {

using namespace report;

/// What commands about scenarios read: a file, and settings that replace some of its own.
struct ScenarioInput {
  std::string file;
  std::vector<std::string> overrides;
  std::string ranges;              // of --ranges, instead of output.ranges
  bool has_complete_study = true;  // no option adds to it
};
void add_scenario_options(Command& command, ScenarioInput& input);

/// A scenario, which of its shots, and where results go.
struct Question {
  ScenarioInput input;
  std::string shot;
  std::string json;  // path, "-" for the standard output, empty: not asked for
};
/// FILE, --set and --shot; with `json` also --json.
void add_question_options(Command& command, Question& question, bool json = true);

/// Says that an answer about shots that meet nothing leaves the things of a scenario aside. `answer`: "a range card".
void warn_of_things(const Scenario& scenario, const std::string& answer);
/// Says that an answer flies a shot at its fidelity, if cheapest_within asks for another one.
void warn_of_fidelity(const ScenarioShot& shot, const std::string& answer);
/// Warns where a flight leaves the drag curve of its own projectile.
void warn_of_curve(const Flight& flight);
/// ... where the flight of a shot of a scenario does, flown alone as the scenario says.
void warn_of_curve(const Scenario& scenario, const ScenarioShot& shot);
/// Reads the scenario, and prints its notes as warnings.
[[nodiscard]] Result<Scenario> load(const ScenarioInput& input);
/// The scenario, and the shot that was asked for.
[[nodiscard]] Result<AskedShot> ask(const Question& question);
/// ... for an answer about shots that meet nothing: of flights the things are taken out, and a warning says so.
[[nodiscard]] Result<AskedShot> ask_without_things(const Question& question, const std::string& answer);
/// The value of an option, "800 m" or a number in SI; nothing where the option was not given.
[[nodiscard]] Result<std::optional<double>> option_value(const char* option, const std::string& text,
                                                         Quantity quantity);
/// The value of an option, "10 m, 2 m, 0 m".
[[nodiscard]] Result<std::optional<Vec3d>> option_vector(const char* option, const std::string& text,
                                                         Quantity quantity);

/// An option, whether it was given, and what an error of the library calls its value.
struct OptionOfError {
  const char* option;
  bool is_given;
  std::string_view member;
};
/// The option that was given and that an error is about; null where it is about none.
[[nodiscard]] const char* option_of(const Error& error, std::initializer_list<OptionOfError> options);
/// An error about a shot; one about the value of an option that was given names the option.
[[nodiscard]] Error about(const AskedShot& asked, Error error, std::initializer_list<OptionOfError> options);

/// Prints the text, or writes the JSON where that was asked for.
[[nodiscard]] Status give(const Question& question, const Answer& answer);

}  // namespace physim::cli
