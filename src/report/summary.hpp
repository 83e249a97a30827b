// What people read of flights: for each shot its fidelity, range card, end, apex and cost; then the checks.
#pragma once

#include <string>
#include <vector>

#include "report/flown.hpp"
#include "report/style.hpp"
#include "report/text.hpp"

namespace physim::report {

[[nodiscard]] Text summary_text(const FlownScenario& flown, const Style& style);

/// The verdicts, a line for each.
[[nodiscard]] std::string checks_text(const std::vector<Check>& checks, const Style& style);

/// Whether a shot is measured against a line of sight of its own; one without is shown by its height, not its drop.
[[nodiscard]] bool has_sight(const Launch& launch);
/// The entry of a card for a range that a flight does not reach: its outcome, and its last range below the one asked.
[[nodiscard]] std::string not_reached(const Flight& flight, double asked, const std::string& unit = "m",
                                      double size = 1);
/// The stability of what spins, at the muzzle, and at the end where the attitude is flown; empty for what does not
/// spin.
[[nodiscard]] std::string stability_text(const ScenarioShot& shot, const Flight& flight,
                                         const Environment& environment);

/// Notes on the distance by which a flight leaves its own drag curve, and the place; empty if it stays on the curve.
[[nodiscard]] std::vector<std::string> curve_notes(const Flight& flight);
/// ... and that it never leaves its rail: all that `run` notes on a flight.
[[nodiscard]] std::vector<std::string> flight_notes(const FlownShot& flown);
/// Whether a projectile has a drag curve of its own, which a flight may leave.
[[nodiscard]] bool has_own_curve(const ProjectileDef& projectile);

/// Round ranges [m] for a range card of a flight that ends at this range [m].
[[nodiscard]] std::vector<double> default_ranges(double end_range);
/// The ranges [m] of a flight's card: output.ranges of its scenario, or else round ones.
[[nodiscard]] std::vector<double> ranges_of_card(const Scenario& scenario, const Flight& flight);

}  // namespace physim::report
