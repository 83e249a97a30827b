// Rain in a step: the boxes that emitters let rain fill, as they go through it.
#pragma once

#include <optional>
#include <unordered_map>

#include "emit/rain.hpp"
#include "physim/world.hpp"
#include "world/core/emitters.hpp"
#include "world/couple/emitter_pose.hpp"

namespace physim {

struct WorldImpl;

class RainStep {
 public:
  explicit RainStep(WorldImpl& world) : w_(world) {}

  /// The box of an emitter goes straight from one pose to another between two times; candidates that fill it, where it
  /// was somewhere else before.
  std::uint32_t begin(std::uint32_t emitter, const Pose& from, const Pose& to, double from_time, double to_time);
  /// When its next candidate comes; nothing where that is after the way.
  [[nodiscard]] std::optional<double> next(std::uint32_t emitter) const;
  void take(std::uint32_t emitter) { ++ways_.at(emitter).taken; }

  /// How a candidate comes into the world, if it does: place and velocity.
  [[nodiscard]] std::optional<BodyState> candidate(std::uint32_t emitter, const Birth& birth, bool fills, double time,
                                                   const Quatd& rotation) const;
  /// The step is over: the box is at a place, and what is outside of it goes.
  void end(std::uint32_t emitter, const Vec3d& about);

 private:
  struct Way {
    double from = 0, to = 0;        // [s]
    Vec3d begin;                    // the middle of the box [m]
    std::optional<Vec3d> before{};  // that of the box that is full, from there
    Rain::Inflow inflow;
    std::uint64_t taken = 0;
  };
  [[nodiscard]] bool is_under_cover(std::uint32_t emitter, const BodyState& at, double time) const;

  WorldImpl& w_;
  std::unordered_map<std::uint32_t, Way> ways_;
};

}  // namespace physim
