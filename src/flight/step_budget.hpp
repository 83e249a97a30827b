// The work that all flights of a search may take together, so that odd input does not keep its caller waiting.
#pragma once

#include <cstdint>
#include <string>

#include "physim/flight.hpp"

namespace physim {

inline constexpr std::int64_t kMostSearchSteps = 5'000'000;         // some seconds
inline constexpr std::int64_t kMostSearchEvaluations = 20'000'000;  // of forces, those of rejected steps too

class StepBudget {
 public:
  void spend(const Flight& flight) {
    steps_ += flight.cost().steps;
    evaluations_ += flight.cost().evaluations;
  }
  [[nodiscard]] bool is_spent() const { return steps_ > kMostSearchSteps || evaluations_ > kMostSearchEvaluations; }
  /// `what` was searched: "the farthest range".
  [[nodiscard]] static Error error(const std::string& what) {
    return {what + " takes more than five million steps or 20 million evaluations of forces to find",
            "fidelity.integrator", "use an adaptive one, or look at mass, diameter and drag: is it so light?"};
  }

 private:
  std::int64_t steps_ = 0, evaluations_ = 0;
};

}  // namespace physim
