// Level of detail: projectiles move between rungs by their distance to an observer and their age.
#include <cmath>

#include "prepare/check.hpp"
#include "world/couple/world_impl.hpp"

namespace physim {
namespace {

/// Steps between two looks at a projectile. They are counted from its launch, so that they do not depend on others.
constexpr std::int64_t kStepsBetweenLooks = 8;

/// Whether a projectile is looked at after `steps`, which are rounded as std::llround() does, but without a call. The
/// number below 0.5 is added: with 0.5 itself that number would round to 1. Steps can be so short against the age that
/// their count is no longer exact; the projectile is then looked at in every step.
bool is_time_to_look(double steps) {
  constexpr double kMostCounted = 4e15;
  if (!(std::abs(steps) < kMostCounted)) return true;
  const auto whole = static_cast<std::int64_t>(steps + std::copysign(0.49999999999999994, steps));
  return whole % kStepsBetweenLooks == 0;
}

/// The first rung that holds, or the last.
std::size_t wanted_rung(const DetailRule& rule, double distance, double age) {
  for (std::size_t i = 0; i + 1 < rule.rungs.size(); ++i)
    if (distance <= rule.rungs[i].within && age <= rule.rungs[i].younger) return i;
  return rule.rungs.size() - 1;
}

/// The rung that is wanted with hysteresis: the one that it is on holds until it is left by more than the hysteresis,
/// and a finer one is taken only when it is reached by as much.
std::size_t next_rung(const DetailRule& rule, std::size_t current, double distance, double age) {
  const std::size_t wanted = wanted_rung(rule, distance, age);
  if (current >= rule.rungs.size() || wanted == current) return wanted;
  const DetailRung& border = rule.rungs[wanted < current ? wanted : current];
  if (wanted < current) return distance <= border.within * (1 - rule.hysteresis) ? wanted : current;
  return age > border.younger || distance > border.within * (1 + rule.hysteresis) ? wanted : current;
}

}  // namespace

void WorldImpl::apply_detail() {
  if (!uses_detail()) return;
  const double now = state.clock.time();
  const DetailRule& rule = state.detail;
  state.slots.each_alive([&](std::uint32_t index) {
    const Slot& slot = state.slots[index];
    if (slot.is(kStill)) return;
    const double age = now - state.slots.birth(index);
    if (!is_time_to_look(age / state.clock.dt)) return;
    if ((layers_of(index) & rule.layers) == 0) return;
    const Fidelity& asked = registry.kind(slot.kind).rungs[slot.rung].asked;
    std::size_t current = 0;
    while (current < rule.rungs.size() && !(rule.rungs[current].fidelity == asked)) ++current;
    const double distance = length(state.rows_of(slot).position(slot.row) - state.observer);
    const std::size_t next = next_rung(rule, current, distance, age);
    if (next != current) change_fidelity(index, rule.rungs[next].fidelity);
  });
}

Status World::set_detail(const DetailRule& rule) {
  WorldImpl& w = impl();
  const Recorded<Call::set_detail> call(w, rule);
  if (call.is_refused()) return call.refusal();
  if (Status status = check(rule); !status) return status;
  w.state.detail = rule;
  return {};
}

}  // namespace physim
