// The ladder of fidelity for one shot: which rungs there are, how far each ends from the reference, and what it costs.
#pragma once

#include "physim/result.hpp"
#include "physim/solve.hpp"
#include "report/picture.hpp"
#include "report/records.hpp"
#include "report/style.hpp"
#include "scenario/scenario.hpp"

namespace physim::report {

enum class Family { preset, integrator, effect };
inline constexpr int kFamilies = 3;
[[nodiscard]] std::string_view family_name(Family family);

/// One way to fly the shot.
struct Rung {
  Family family = Family::preset;
  std::string series;  // rungs that differ in step or tolerance only: "rk4"; the name itself where there is one
  std::string detail;  // "1/60 s", "1e-6"; may be empty
  FlightSetting setting;
  [[nodiscard]] std::string name() const { return detail.empty() ? series : series + " " + detail; }
};

/// A rung flown. The last of them is the reference itself.
struct RungResult {
  Rung rung;
  Flight flight;
  std::string leaves_out;  // physics of the reference that this rung was not granted
  double error = 0;        // distance between the ends of this flight and the reference [m]
  double resolved = 0;     // largest, but no less than 1 um, and 1e-8 or some roundings of the greatest distance [m]
  double largest = 0;      // distance between the two at any equal time [m]
  double time_error = 0;   // difference of the times of flight [s]
  double cost = 0;         // of one fly(), median of several [s]
  double work = 0;      // steps, rejected ones included, times the operations of one, which are counted in the models:
                        // the same on every machine [-]
  std::string doubt{};  // why the rung's model does not hold on this flight; empty: it does
  std::string beaten_by{};  // a rung of the family that costs no more, by its work, and errs less; empty: none
  [[nodiscard]] bool holds() const { return doubt.empty(); }
};

/// A preset as a world steps it.
struct StepsOfRung {
  std::string name;
  double largest = 0;       // distance from the reference at any frame [m]
  double cost = 0;          // of one step of one projectile among a thousand [s]
  std::string leaves_out;   // physics of the reference that its flight leaves out; worlds leave out spin drift, too
  std::string beaten_by{};  // a preset whose steps cost no more, as measured, and err less; empty: none
};

/// A rung that is not in the table, and why.
struct RungLeftOut {
  std::string name;
  std::string reason;
};

struct Ladder {
  std::string shot;
  std::vector<RungResult> rungs;  // presets from cheap to true, integrators by order, effects; then the reference
  std::vector<RungLeftOut> left_out;
  std::vector<StepsOfRung> steps;  // presets in a world of 60 steps a second; none if the flight has no such frames
};

/// A ladder and where its shot comes from.
struct LadderOfShot {
  const Scenario& scenario;
  const Ladder& ladder;
};

/// The setting that the others are measured against: the reference preset, with Earth, gravity and rotation of the shot
/// if those are truer.
[[nodiscard]] FlightSetting reference_setting(const Scenario& scenario, const ScenarioShot& shot);
/// How the ladder flies a preset of fidelity, which has to exist: by its own steps and tolerance. Those of the scenario
/// belong to its own rung.
[[nodiscard]] FlightSetting preset_setting(const Scenario& scenario, const ScenarioShot& shot, std::string_view preset);

/// How a scenario flies its shot: as the shot says; if it gives an error, what is chosen for it. An error
/// if nothing can be chosen.
[[nodiscard]] Result<FlightSetting> own_setting(const Scenario& scenario, const ScenarioShot& shot);

/// Flies a shot of a scenario on every rung.
[[nodiscard]] Result<Ladder> climb(const Scenario& scenario, const ScenarioShot& shot, const Progress& progress = {});
/// The presets and the reference alone, without measuring times: costs are 0.
[[nodiscard]] Result<Ladder> climb_presets(const Scenario& scenario, const ScenarioShot& shot);

[[nodiscard]] std::string ladder_text(const LadderOfShot& subject, const Style& style);
/// A row for each rung.
[[nodiscard]] Records records_of(const LadderOfShot& subject);
[[nodiscard]] Content ladder_json(const LadderOfShot& subject);

}  // namespace physim::report
