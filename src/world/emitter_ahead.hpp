// Births of emitters that are drawn ahead, and how many at a time: those of one moment, and those of the moments of one
// emitter that come before all else.
#pragma once

#include "world/birth_batch.hpp"
#include "world/emitter_moments.hpp"

namespace physim {

class EmitterAhead : protected EmitterMoments {
 public:
  using EmitterMoments::close_ways;

 protected:
  /// Births that lead to one another at one moment, and those of all sub-emitters, or of one emitter by itself, in one
  /// step: more are cut.
  static constexpr std::uint32_t kDeepest = 32;
  static constexpr std::uint32_t kMostBirths = 1u << 20;

  EmitterAhead(WorldImpl& world, const SettleContext& context, double end)
      : EmitterMoments(world, context, end), batches_(world, context, end) {}

  /// What set off a sub-emitter, until others are queued; null: it fires by itself.
  [[nodiscard]] const EmitterTrigger* cause_of(const Firing& firing) const {
    return firing.by == Firing::kNothing ? nullptr : &s_.causes[firing.by];
  }
  [[nodiscard]] const SubEmitter& sub_of(const Firing& firing) const {
    return all_[firing.parent_emitter].def().subs[firing.sub];
  }
  [[nodiscard]] std::uint32_t depth_of(const Firing& firing) const {
    const EmitterTrigger* by = cause_of(firing);
    return by && by->time == by->birth ? by->particle.depth + 1 : 0;
  }

  /// How a moment's births go side by side; null: one by one.
  [[nodiscard]] const BirthPlan* plan_of(const Firing& firing);
  /// How the births of an emitter's own moments go side by side, which are drawn ahead; null: they go one by one.
  [[nodiscard]] const BirthPlan* plan_ahead(const Firing& firing);
  /// Births of a moment, from that one on.
  void look_at_moment(const BirthPlan& plan, const Firing& firing, const Pose& pose, std::uint32_t from);
  /// How many more one lets out by its maximum, at least.
  [[nodiscard]] std::size_t room(const BirthPlan& plan) const;
  /// How many more are not cut.
  [[nodiscard]] std::size_t may_be_born(const Firing& firing) const;

  BirthBatches batches_;
  std::uint64_t departed_ = 0;  // particles that left in this step and were asked about
};

}  // namespace physim
