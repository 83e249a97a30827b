// Fields: functions of one's own over place and time, of an environment: its wind, and a force.
#pragma once

#include <functional>
#include <memory>
#include <span>
#include <type_traits>
#include <utility>

#include "physim/vec3.hpp"

namespace physim {

/// What a wind function sees and fills: places side by side.
struct WindBatch {
  std::span<const double> time{};     ///< since launch; in worlds, of the world [s]
  std::span<const Vec3d> position{};  ///< in W [m]
  std::span<Vec3d> velocity{};        ///< of the air in W, zero as it comes: to be filled [m/s]
};

/// What a force function sees and fills: projectiles side by side.
struct FieldForceBatch {
  std::span<const double> time{};     ///< since launch; in worlds, of the world [s]
  std::span<const Vec3d> position{};  ///< in W [m]
  std::span<const Vec3d> velocity{};  ///< in W [m/s]
  std::span<const double> mass{};     ///< that is left [kg]
  std::span<Vec3d> force{};           ///< in W, zero as it comes: to be filled [N]
};

/// A function of one's own, from any callable that takes a `const Batch&`. Copies share it, and only they are equal.
///
/// Each answer must be a function of its own place alone, the same bits for the same numbers, and use no world. It is
/// called from any number of threads at once, any number of times, for steps that are given up and lanes that hold
/// nobody, too (with finite numbers). Where it throws, each place is asked about alone. A place that throws again, or
/// whose answer is not finite, ends the flight: as non_finite, or as stalled where adaptive steps come to a halt before
/// it; in a world its projectile is retired. No file holds it: who loads a world gives it again.
template <class Batch>
class FieldFunction {
 public:
  using Function = std::function<void(const Batch&)>;

  FieldFunction() = default;
  template <class F>
  requires std::is_invocable_v<F&, const Batch&> FieldFunction(F function) {  // NOLINT: it is one
    Function made(std::move(function));
    if (made) function_ = std::make_shared<const Function>(std::move(made));
  }

  [[nodiscard]] const Function* get() const { return function_.get(); }
  explicit operator bool() const { return function_ != nullptr; }
  bool operator==(const FieldFunction&) const = default;

 private:
  std::shared_ptr<const Function> function_;
};

using WindFunction = FieldFunction<WindBatch>;
using ForceFunction = FieldFunction<FieldForceBatch>;

}  // namespace physim
