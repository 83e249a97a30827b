// What commands that answer one question about one shot share: the shot, values with units, results on their way out.
#pragma once

#include <optional>
#include <string>

#include "flown.hpp"

namespace physim::cli {

class Command;

/// A scenario, which of its shots, and where results go.
struct Question {
  ScenarioInput input;
  std::string shot;
  std::string json;  // path, "-" for the standard output, empty: not asked for
};
/// FILE, --set and --shot; with `json` also --json.
void add_question_options(Command& command, Question& question, bool json = true);

/// A scenario and the shot in it that was asked for.
struct AskedShot {
  Scenario scenario;
  std::size_t index = 0;
  [[nodiscard]] const ScenarioShot& shot() const { return scenario.shots[index]; }
};
[[nodiscard]] Result<AskedShot> ask(const Question& question);
/// The shot of a name, the first for an empty one.
[[nodiscard]] Result<std::size_t> find_shot(const Scenario& scenario, const std::string& name);
/// An error of the library about a shot, with scenario and name as its place.
[[nodiscard]] Error about(const AskedShot& asked, Error error);

/// The value of an option, "800 m" or a number in SI; nothing where the option was not given.
[[nodiscard]] Result<std::optional<double>> option_value(const char* option, const std::string& text,
                                                         Quantity quantity);
/// The value of an option, "10 m, 2 m, 0 m".
[[nodiscard]] Result<std::optional<Vec3d>> option_vector(const char* option, const std::string& text,
                                                         Quantity quantity);

/// Prints a text, or writes JSON where that was asked for.
[[nodiscard]] Status answer(const Question& question, const std::string& text, const std::string& json);

/// Prints what is wrong and gives the exit code for it.
int exit_code(const Result<int>& result);

}  // namespace physim::cli
