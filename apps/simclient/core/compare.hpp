// Comparison: one shot on several rungs at once, their paths, how far they part, and what they cost.
#pragma once

#include <array>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "simclient/core/session.hpp"

namespace physim::client {

struct ComparedRung {
  std::string name;  // of the preset, or "as set"
  Fidelity asked;
  Colour colour = 0xFFFFFFFF;
  bool is_truth = false;  // the others are measured against it
  std::string problem;    // why it cannot be compared; empty: it can
  FidelityInUse granted;
  std::vector<TrackSample> path;
  double farthest = 0;              // largest distance from the truth at any equal time [m]
  double at_end = 0;                // distance between its end and that of the truth [m]
  double later = 0;                 // end of its flight after that of the truth [s]
  Sample end;                       // of its flight
  std::optional<Flight> flight;     // nothing where there is a problem
  double per_step = 0;              // cost of a step, among many of its kind, on this machine [s]
  std::optional<double> in_frames;  // largest distance from the truth in a world of 60 steps a second [m]

  /// Error and time error as `physim compare` prints them, the largest distance, and of the end its time, range, height
  /// and windage.
  [[nodiscard]] std::array<std::string, 7> figures() const;
  /// The distance and the side of its end from the end of the truth, with the cause: "107 m short: no lift from spin".
  [[nodiscard]] std::string why(const ComparedRung& truth) const;
};

/// The colour of a rung by its name, whatever else is compared.
[[nodiscard]] Colour colour_of_rung(std::string_view name);

/// Time of one step of one projectile, measured on a thousand of them and remembered: aiming changes it little.
class CostTable {
 public:
  [[nodiscard]] double of(const WorldDef& world, const ScenarioShot& shot);  // [s]

 private:
  std::vector<std::pair<ProjectileDef, double>> known_;
};

/// Flies a shot as it is set and on presets of fidelity, with the figures of `physim compare`: single flights until the
/// scenario ends them, without the forces of its world. The last is the truth, the reference of the ladder. `world`: in
/// which steps are measured; bare_world() of a session.
[[nodiscard]] std::vector<ComparedRung> compare_rungs(const Scenario& scenario, const WorldDef& world,
                                                      const ScenarioShot& shot, const std::vector<std::string>& presets,
                                                      CostTable& costs);
/// The world of a session without what is in it.
[[nodiscard]] WorldDef bare_world(const Session& session);

}  // namespace physim::client
