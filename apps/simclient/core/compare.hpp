// Comparison: one shot on several rungs at once, their paths, how far they part, and what they cost.
#pragma once

#include <string>
#include <vector>

#include "simclient/core/prediction.hpp"

namespace physim::client {

struct ComparedRung {
  std::string name;  // of the preset, or "as set"
  Fidelity asked;
  Colour colour = 0xFFFFFFFF;
  Prediction flight;
  bool is_truth = false;  // the others are measured against it
  double farthest = 0;    // largest distance from the truth at any equal time [m]
  double at_end = 0;      // distance from the truth at the end of what both flew [m]
  double later = 0;       // end of its flight after that of the truth [s]
  double per_step = 0;    // cost of a step, among many of its kind, on this machine [s]
};

/// Flies a shot on presets of fidelity, and as it is set. The last of the presets is the truth.
class CostTable;
[[nodiscard]] std::vector<ComparedRung> compare_rungs(const Session& session, const ScenarioShot& shot,
                                                      const std::vector<std::string>& presets, CostTable& costs);

/// Time of one step of one projectile, measured on a thousand of them and remembered: aiming changes it little.
class CostTable {
 public:
  [[nodiscard]] double of(const Session& session, const ScenarioShot& shot);  // [s]

 private:
  std::vector<std::pair<ProjectileDef, double>> known_;
};

}  // namespace physim::client
