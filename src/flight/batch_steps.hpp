// The automatic steps of a batch, one for each granted fidelity, found once for all threads that fly it.
#pragma once

#include <deque>
#include <mutex>
#include <optional>
#include <vector>

#include "flight/pilot.hpp"
#include "flight/shot_groups.hpp"

namespace physim {

/// The fixed step of shots that are granted the same: what the first of them that flies and the batch's middle, last,
/// slowest and fastest shots need, if these are granted it too. Pilot flights aim for less than half of the error
/// allowed, since some shot of the batch will be worse than they are. The order of calls changes nothing.
class BatchSteps {
 public:
  explicit BatchSteps(const BatchTask& task) : task_(task), scout_(task) {}

  /// 0 for what steps itself [s].
  [[nodiscard]] Result<double> step_of(const Fidelity& granted);
  /// Notes on steps that do not keep the error, in the order of the shots.
  [[nodiscard]] std::vector<FidelityNote> notes() const;

 private:
  struct Known {
    Fidelity granted;
    std::size_t first;  // shot that flies so
    std::optional<Result<double>> step{};
    std::optional<FidelityNote> note{};
  };
  [[nodiscard]] Known& known(const Fidelity& granted);
  [[nodiscard]] Result<double> choose(Known& known);
  [[nodiscard]] std::vector<std::size_t> pilots(const Known& known);
  [[nodiscard]] bool is_granted(std::size_t shot, const Fidelity& granted);

  const BatchTask& task_;
  std::mutex mutex_;
  ShotGroups scout_;
  std::size_t scouted_ = 0;  // shots looked at
  std::deque<Known> known_;  // in the order of their first shots
};

}  // namespace physim
