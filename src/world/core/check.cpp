// Refuses bad definitions of worlds and bodies.
#include <algorithm>
#include <cmath>

#include "base/checker.hpp"
#include "physim/result.hpp"
#include "prepare/check.hpp"
#include "world/core/registry.hpp"

namespace physim {
namespace {

void check_rules(Checker& c, const DespawnRules& d) {
  c.require(!std::isnan(d.below), "body.despawn.below", "must be a number");
  c.require(d.farther > 0, "body.despawn.farther", "must be positive", "leave it out for no limit");
  c.require(d.older > 0, "body.despawn.older", "must be positive", "leave it out for no limit");
  c.not_negative(d.slower, "body.despawn.slower");
  if (!d.outside_box) return;
  c.is_vector(d.box_low, "body.despawn.box_low").is_vector(d.box_high, "body.despawn.box_high");
  c.require(d.box_low.x < d.box_high.x && d.box_low.y < d.box_high.y && d.box_low.z < d.box_high.z,
            "body.despawn.box_low", "must lie below box_high in every axis", "swap the corners");
}

}  // namespace

Status check(const Ground& g) {
  Checker c;
  c.named(g.mode, "ground.mode").is_number(g.height, "ground.height");
  c.require(g.restitution >= 0 && g.restitution <= 1, "ground.restitution", "must lie between 0 and 1");
  c.not_negative(g.friction, "ground.friction").also(check(g.combine, "ground.combine"));
  c.also(check(g.conveyor, "ground.conveyor"));
  return c.status();
}

Status check(const DetailRule& rule) {
  Checker c;
  c.require(rule.rungs.size() != 1 && rule.rungs.size() <= 3, "detail.rungs", "must be two or three", "none: no rule");
  c.require(rule.hysteresis >= 0 && rule.hysteresis < 1, "detail.hysteresis", "must lie between 0 and 1");
  for (const DetailRung& rung : rule.rungs) {
    c.require(rung.within > 0, "detail.rungs.within", "must be positive");
    c.require(rung.younger > 0, "detail.rungs.younger", "must be positive");
    c.also(check(Tolerance{}, rung.fidelity));
  }
  return c.status();
}

Status check(Axes axes, const char* place) {  // a set: each number up to that of all is one
  return Checker().require((axes | Axes::all) == Axes::all, place, "is none of the named values").status();
}
Status check(Smoothing smoothing, const char* place) { return Checker().named(smoothing, place).status(); }

Status check(const WorldDef& def) {
  Checker c;
  c.also(check(def.environment)).also(check(def.ground)).also(check(def.detail));
  c.require(def.step > 0 && def.step <= 10, "world.step", "must lie above 0 and not above 10 s", "1/60 s is usual");
  c.require(def.step >= kShortestStep, "world.step", "is shorter than 1e-9 s", "1/60 s is usual");
  c.require(def.max_steps > 0, "world.max_steps", "must be positive");
  c.require(def.time_scale >= 0 && def.time_scale <= 1000, "world.time_scale", "must lie between 0 and 1000");
  c.also(check(def.tolerance, Fidelity{}));
  c.require(def.max_projectiles > 0, "world.max_projectiles", "must be positive");
  c.require(def.threading.threads <= kMostThreads, "world.threading.threads", "must not be above 1024",
            "0: all there are");
  for (const PoolDef& pool : def.pools) {
    c.require(pool.maximum > 0, "world.pools.maximum", "must be positive");
    c.named(pool.when_full, "world.pools.when_full");
  }
  return c.status();
}

Status check(const BodyDef& b, const WorldDef& def, std::size_t environments) {
  Checker c;
  c.is_number(b.gravity_scale, "body.gravity_scale").not_negative(b.drag_scale, "body.drag_scale");
  c.not_negative(b.angular_drag, "body.angular_drag").is_vector(b.angular_velocity, "body.angular_velocity");
  c.not_negative(b.sleep_speed, "body.sleep_speed").not_negative(b.sleep_time, "body.sleep_time");
  c.require(b.restitution >= 0 && b.restitution <= 1, "body.restitution", "must lie between 0 and 1");
  c.not_negative(b.friction, "body.friction").not_negative(b.rolling_resistance, "body.rolling_resistance");
  c.also(check(b.combine, "body.combine")).also(check(b.collision, "body.collision"));
  c.require(b.pool < std::max<std::size_t>(def.pools.size(), 1), "body.pool", "there is no such pool",
            "WorldDef::pools lists them");
  c.require(b.environment < environments, "body.environment", "there is no such environment",
            "World::add_environment() makes one");
  c.not_negative(b.cheapest_within, "body.cheapest_within").positive(b.within_time, "body.within_time");
  c.also(check(b.frozen, "body.frozen")).also(check(b.frozen_rotation, "body.frozen_rotation"));
  c.also(check(b.smoothing, "body.smoothing"));
  check_rules(c, b.despawn);
  return c.status();
}

}  // namespace physim
