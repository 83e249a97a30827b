// The rules of a cohort, as one of its rows follows them at the end of its step: it expires, or rests until it sleeps.
#pragma once

#include <cmath>
#include <cstdint>

#include "world/step/settled_row.hpp"

namespace physim {

template <class S>
class RowRules {
 public:
  RowRules(const SettleContext& context, SettledRow<S>& row) : context_(context), r_(row) {}

  /// `is_carried`: it lies on what moves.
  void follow(bool is_carried) {
    const CohortRules& rules = r_.cohort().key.rules;
    const DespawnRules& d = rules.despawn;
    const auto [x, v] = r_.here();
    const double speed = length(v);
    const auto outside = [](double at, double low, double high) { return at < low || at > high; };
    if (height(r_.conditions(), x) < d.below) return expire(Reason::below);
    if (speed < d.slower && !waits_for_motor()) return expire(Reason::slower);
    if (r_.has_launch_place() && length(x - r_.launch_place()) > d.farther) return expire(Reason::farther);
    if (d.outside_box && (outside(x.x, d.box_low.x, d.box_high.x) || outside(x.y, d.box_low.y, d.box_high.y) ||
                          outside(x.z, d.box_low.z, d.box_high.z)))
      return expire(Reason::outside_box);
    if (speed < rules.sleep_speed && !waits_for_motor() && !is_carried) rest(rules.sleep_time);
  }

 private:
  /// On its rail, or before burnout: it only looks as if it rested.
  [[nodiscard]] bool waits_for_motor() const {
    const Conditions<S>& c = *r_.march.course().conditions;
    const Body<S>& b = r_.march.lanes.body;
    return (c.has_motor && std::isfinite(b.burn.end)) || (c.has_rail && b.rail_phase < S(kOffRail));
  }

  /// Counts the time at rest; enough of it, without a break, and it sleeps.
  void rest(double enough) {
    Rest& rest = context_.state->slots.rest(r_.slot_index());
    rest.count(context_.state->clock.steps, context_.dt);
    if (static_cast<double>(rest.time) < enough) return;
    r_.change(Change::Kind::sleep, LifeStatus::in_flight, Reason::none);
  }

  void expire(Reason reason) {
    r_.tell(EventKind::expired, reason, context_.dt, r_.here());
    r_.change(Change::Kind::remove, LifeStatus::expired, reason);
  }

  const SettleContext& context_;
  SettledRow<S>& r_;
};

}  // namespace physim
