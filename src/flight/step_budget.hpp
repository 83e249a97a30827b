// The steps that all flights of a search may take together, so that odd input does not keep its caller waiting.
#pragma once

#include <cstdint>
#include <string>

#include "physim/flight.hpp"

namespace physim {

inline constexpr std::int64_t kMostSearchSteps = 5'000'000;  // some seconds

class StepBudget {
 public:
  void spend(const Flight& flight) { spent_ += flight.cost().steps; }
  [[nodiscard]] bool is_spent() const { return spent_ > kMostSearchSteps; }
  /// `what` was searched: "the farthest range".
  [[nodiscard]] static Error error(const std::string& what) {
    return {what + " takes more than five million steps to find", "fidelity.integrator",
            "use an adaptive one, or look at mass, diameter and drag: is it so light?"};
  }

 private:
  std::int64_t spent_ = 0;
};

}  // namespace physim
