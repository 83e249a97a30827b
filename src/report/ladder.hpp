// The ladder of fidelity for one shot: which rungs there are, how far each ends from the reference, and what it costs.
#pragma once

#include "physim/compare.hpp"
#include "physim/result.hpp"
#include "physim/scenario.hpp"
#include "report/picture.hpp"
#include "report/records.hpp"
#include "report/style.hpp"

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
  double time_error = 0;   // difference of the times of flight [s]
  double cost = 0;         // of one fly(), median of several [s]
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
};

/// A ladder and where its shot comes from.
struct LadderOfShot {
  const Scenario& scenario;
  const Ladder& ladder;
};

/// What the others are measured against: the reference preset, with the rotation that the shot asks for.
[[nodiscard]] FlightSetting reference_setting(const ScenarioShot& shot);
/// How the ladder flies a preset of fidelity; the preset has to exist.
[[nodiscard]] FlightSetting preset_setting(const Scenario& scenario, std::string_view preset);

/// How a scenario flies its shot: as the shot asks; of one that asks for an error, what is chosen for it. An error
/// where nothing can be.
[[nodiscard]] Result<FlightSetting> own_setting(const Scenario& scenario, const ScenarioShot& shot);

/// Flies a shot of a scenario on every rung.
[[nodiscard]] Result<Ladder> climb(const Scenario& scenario, const ScenarioShot& shot, const Progress& progress = {});

[[nodiscard]] std::string ladder_text(const LadderOfShot& subject, const Style& style);
/// A row for each rung.
[[nodiscard]] Records records_of(const LadderOfShot& subject);
[[nodiscard]] Content ladder_json(const LadderOfShot& subject);

}  // namespace physim::report
