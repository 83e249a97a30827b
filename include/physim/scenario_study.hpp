// The [study] of a scenario: which of its numbers are uncertain, and what is asked of many shots.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "physim/study.hpp"

namespace physim {

struct Scenario;
struct ScenarioShot;

/// The [study] of a scenario, as it is written.
struct ScenarioStudy {
  std::vector<std::string> inputs{};      ///< "shot.speed = 800 m/s +- 3 m/s"; see parse_study_input() [-]
  std::vector<std::string> correlated{};  ///< "shot.speed with shot.mass = 0.5" [-]
  std::vector<std::string> targets{};  ///< "plate: rectangle 30 cm x 50 cm at 0 m, 1 m"; see parse_study_target() [-]
  std::vector<std::string> quantities{};  ///< "y", "time": StudyQuantity; empty: those of Study [-]
  std::vector<std::string> at{};          ///< "800 m", "apex: y, time"; see parse_study_place() [-]
  std::string aim{};                      ///< on the plane of impact, "0 m, 1 m"; empty: its origin [m]
  Sampling sampling = Sampling::random;   ///< [-]
  std::int64_t shots = 100'000;           ///< [-]
  std::optional<double> until_time{};     ///< fly for so long, however many shots that makes [s]
  std::int64_t seed = 1;                  ///< [-]
  std::int64_t rounds = 1;                ///< of an occasion [-]
  bool indices = false;                   ///< Sobol indices [-]
  std::int64_t over_inputs = 0;           ///< parts of each input over which hits are told; 0: not told [-]
  std::int64_t histograms = 0;            ///< bars of histograms; 0: not told [-]
};

/// A number and its distribution from a text, PATH = DISTRIBUTION:
///   800 m/s +- 3 m/s                     normal
///   +- 3 m/s                             normal, added to what the scenario has
///   800 m/s +- 3 m/s within 790 m/s .. 805 m/s     normal, cut off; one end may be left out
///   -2 m/s .. 2 m/s                      uniform
///   -2 m/s .. 2 m/s peak 1 m/s           triangular
///   lognormal 2 m/s +- 0.5 m/s
///   one of 1 m/s, 2 m/s, 5 m/s, or of measurements in a CSV file: column speed of speeds.csv
/// "added" before it adds it to what the scenario has, "per occasion" behind it draws it once for each occasion.
[[nodiscard]] Result<StudyInput> parse_study_input(std::string_view text);
/// A target from a text, with a name and a place or without: "NAME: circle 10 cm at 0 m, 1 m" (its radius),
/// "rectangle 30 cm x 50 cm", "polygon 0 m, 0 m; 1 m, 0 m; 0 m, 1 m", "thing THE-NAME-OF-A-THING".
[[nodiscard]] Result<StudyTarget> parse_study_target(std::string_view text);
/// A place on the way from a text: "800 m" (of range), "apex", "height 100 m falling", "time 2 s", "speed 340 m/s",
/// "mach 1", "ground", "burnout", "ignition", "rail_exit"; behind a colon what is told there: "apex: y, time".
[[nodiscard]] Result<StudyPlace> parse_study_place(std::string_view text);
/// The text of a place's event, which parse_study_place() reads.
[[nodiscard]] std::string place_text(const EventSpec& event);
/// The study of a shot of a scenario, at the shot's own fidelity. Without a [world] its shots meet the scenario's
/// things as fly_shot() does; things that have names are targets, too, unless their names are more than 32.
[[nodiscard]] Result<Study> study_of(const Scenario& scenario, const ScenarioShot& shot);

}  // namespace physim
