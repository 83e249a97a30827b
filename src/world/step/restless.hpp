// Where a step may come to something that rows have not noticed.
//
// Rows keep what they found to be clear of the things at rest (world/step/look_around.hpp), for as long as these stay
// where they were then. All else is restless: what moves, and what came to where it rests since rows found out. Before
// each step a few boxes are put about it, and a row that keeps away from all of them in its step meets nothing of it.
#pragma once

#include "world/core/newcomers.hpp"
#include "world/step/world_job.hpp"

namespace physim {

class Scene;

/// What is restless in one step.
class Restless {
 public:
  void clear();
  /// Looks where what moves goes in the time that the scene covers, and where newcomers are, which stay as they are as
  /// long as this is asked.
  void find(const Scene& scene, Newcomers& newcomers);
  /// Anything may be anywhere.
  void be_everywhere();

  [[nodiscard]] bool is_any() const { return double_.count > 0; }
  template <class S>
  [[nodiscard]] const RestlessBoxes<S>& boxes() const {
    if constexpr (sizeof(S) == 4) return float_;
    if constexpr (sizeof(S) == 8) return double_;
  }
  /// Whether newcomers may be in a box.
  [[nodiscard]] bool may_have_come(const collide::Bounds& box) const { return !came_ || came_->meets(box); }

 private:
  void put(const BoxGroups& moving, const BoxGroups& came);

  const BoxGroups* came_ = nullptr;  // null: they may be anywhere
  RestlessBoxes<float> float_;
  RestlessBoxes<double> double_;
};

}  // namespace physim
