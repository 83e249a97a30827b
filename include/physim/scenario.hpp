// Scenario files, by the paths of their settings. Part of the library physim_scenario.
#pragma once

#include <cstdint>
#include <memory>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "physim/flight.hpp"
#include "physim/result.hpp"
#include "physim/units.hpp"
#include "physim/world.hpp"

namespace physim {

class WorldRun;

/// The units that are accepted for a quantity, the SI unit first; "%" for plain numbers.
[[nodiscard]] std::vector<std::string> units_of(Quantity quantity);

/// Parses "168 gr", "2600 ft/s", "0.218 lb/in^2", "15 degC", "-3.10 m" or a plain number (SI) into SI.
/// May be infinite ("inf"), never NaN.
[[nodiscard]] Result<double> parse_quantity(std::string_view text, Quantity quantity);

/// One public setting, declared once. Files, overrides, docs, panels and error messages are made from this list.
struct Setting {
  std::string path{};  ///< "shot.drag.ballistic_coefficient" [-]
  /// quantity, integer, boolean, text, choice, vector, points, list, drawn (a number that emitters draw), colour (that
  /// they draw) or gradient [-]
  std::string type{};
  Quantity quantity = Quantity::number;  ///< of quantities, vectors and lists of numbers [-]
  std::string unit{};                    ///< SI unit, "" for none, "of the kind" where another setting decides [-]
  std::string default_value{};           ///< as typed in an override; "" if there is no default [-]
  std::string range{};                   ///< "> 0", "0 .. 1", "off | constant | ..."; of lists: their length [-]
  std::string doc{};                     ///< one line [-]
  bool live = false;                     ///< worlds can change it for one projectile in flight [-]
};

/// The list of all settings of scenario files, in the order in which they are read. Settings of list elements have the
/// path of the list before them: "until.events.kind".
[[nodiscard]] std::span<const Setting> settings();

/// The world of a scenario file, run step by step: it fires shots, volleys and emitters when they are due.
class ScenarioRun {
 public:
  ScenarioRun(ScenarioRun&&) noexcept;
  ScenarioRun& operator=(ScenarioRun&&) noexcept;
  ~ScenarioRun();

  /// Fires what is due and takes one step.
  void step();
  /// Number of steps in the scenario's duration.
  [[nodiscard]] std::uint64_t steps() const;
  [[nodiscard]] World& world();
  [[nodiscard]] const World& world() const;

 private:
  friend class ScenarioFile;
  explicit ScenarioRun(std::unique_ptr<WorldRun> run);
  std::unique_ptr<WorldRun> run_;
};

/// A scenario file that could be read. Its settings are read and changed by their paths (docs/settings.md): those of a
/// shot as "shot.NAME.mass", or as "shot.mass" where there is one shot. Copies are cheap, and independent.
class ScenarioFile {
 public:
  /// Reads a file. An override is "path=value", as `--set` has it, and replaces what the file says. An error has the
  /// place in the file, or the override.
  [[nodiscard]] static Result<ScenarioFile> load(const std::string& file, std::span<const std::string> overrides = {});
  /// Reads the text of a file; `file` names it in errors, and other files are looked for beside it.
  [[nodiscard]] static Result<ScenarioFile> parse(const std::string& text, const std::string& file,
                                                  std::span<const std::string> overrides = {});

  /// Notes on the file, with their places: former names of settings.
  [[nodiscard]] std::span<const std::string> notes() const;
  /// Names of the shots, in the order of the file; "" for a shot without a name.
  [[nodiscard]] std::vector<std::string> shots() const;
  /// The value of a setting as text, in SI units, default or not: get("shot.mass") == "0.0109 kg".
  [[nodiscard]] Result<std::string> get(std::string_view path) const;
  /// Changes a setting: set("shot.mass", "170 gr"). After an error the scenario is as it was.
  Status set(std::string_view path, std::string_view value);
  /// The settings that differ from their defaults, as the text of a file.
  [[nodiscard]] std::string text() const;

  /// Flies a shot of the file: the first, or the named one.
  [[nodiscard]] Result<Flight> fly(std::string_view shot = {}) const;
  /// The world of the file, before its first step; an error if the file has no [world]. With `recording` every call is
  /// recorded into that file.
  [[nodiscard]] Result<ScenarioRun> run(const std::string& recording = {}) const;

 private:
  struct State;
  explicit ScenarioFile(std::shared_ptr<const State> state);
  std::shared_ptr<const State> state_;
};

}  // namespace physim
