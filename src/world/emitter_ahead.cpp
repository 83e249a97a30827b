#include "world/emitter_ahead.hpp"

#include <algorithm>

#include "world/world_impl.hpp"

namespace physim {
namespace {

/// So many at least are worth being drawn side by side.
constexpr std::uint32_t kFew = 4;

}  // namespace

const BirthPlan* EmitterAhead::plan_of(const Firing& firing) {
  const bool is_many = firing.moment.count >= kFew && !firing.moment.is_round;
  return is_many && !is_past_ && firing.rank != kRain && firing.rank != kFill ? batches_.plan(firing.emitter) : nullptr;
}

const BirthPlan* EmitterAhead::plan_ahead(const Firing& firing) {
  const BirthPlan* const plan = batches_.plan(firing.emitter);
  if (!plan || has_ahead(firing.emitter)) return plan;
  if (!sees_ahead(firing)) return nullptr;
  BirthColumns& births = look_ahead(firing, may_be_born(firing));
  if (births.count >= kFew && room(*plan) > 0) batches_.prepare(*plan, births);
  return plan;
}

void EmitterAhead::look_at_moment(const BirthPlan& plan, const Firing& firing, const Pose& pose, std::uint32_t from) {
  BirthColumns& b = s_.together;
  b.begin();
  if (room(plan) == 0) return;
  const EmitMoment& m = firing.moment;
  b.count = std::min<std::size_t>(BirthColumns::kLanes, m.count - from);
  b.pose[0] = pose, b.one_pose = true;
  b.inherited = cause_of(firing) ? sub_of(firing).inherit_velocity : all_[firing.emitter].def().inherit_velocity;
  for (std::uint32_t lane = 0; lane < b.count; ++lane) {
    b.number[lane] = all_[firing.emitter].born + lane;
    b.own_time[lane] = m.time, b.phase[lane] = m.phase;
    b.of_moment[lane] = from + lane, b.moment[lane] = m.count;
    b.time[lane] = firing.time;
  }
  batches_.prepare(plan, b);
}

std::size_t EmitterAhead::room(const BirthPlan& plan) const {
  const bool refuses = all_[plan.emitter].def().when_full == WhenFull::refuse;
  return batches_.room(plan, refuses ? departed_ + s_.departures.size() : 0);
}

std::size_t EmitterAhead::may_be_born(const Firing& firing) const {
  const std::uint32_t born = cause_of(firing) ? s_.births : s_.own_births[firing.emitter];
  if (cause_of(firing) && depth_of(firing) > kDeepest) return 0;
  return kMostBirths - std::min(kMostBirths, born);
}

}  // namespace physim
