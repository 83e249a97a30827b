#include "world/core/registry.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "base/archive.hpp"
#include "base/assert.hpp"
#include "flight/under_way.hpp"
#include "math/elementary.hpp"
#include "prepare/check.hpp"
#include "prepare/conditions.hpp"
#include "prepare/grant.hpp"
#include "prepare/launch.hpp"
#include "prepare/watch_list.hpp"
#include "world/core/slots.hpp"

namespace physim {

Result<ProjectileDef> with_drag_scaled(ProjectileDef p, double scale) {
  if (scale == 1) return p;
  PHYSIM_ASSERT(scale >= 0);
  DragDef& drag = p.drag;
  drag.k1 *= scale;
  drag.k2 *= scale;
  drag.form_factor *= scale;
  if (drag.ballistic_coefficient > 0) drag.ballistic_coefficient /= scale;
  for (BallisticBand& band : drag.bands) band.ballistic_coefficient /= scale;
  for (AeroPoint& point : p.aero.drag_yaw) point.value *= scale;
  drag.damping = pow(drag.damping, scale);
  const bool finite =
      std::isfinite(half_area_per_mass(p)) && std::isfinite(drag.k1) && std::isfinite(drag.k2) && drag.damping > 0 &&
      std::ranges::all_of(drag.bands, [](const BallisticBand& b) { return b.ballistic_coefficient > 0; }) &&
      std::ranges::all_of(p.aero.drag_yaw, [](const AeroPoint& a) { return std::isfinite(a.value); });
  if (!finite) return Error{"makes the drag of this projectile infinite", "body.drag_scale", "1 changes nothing"};
  return p;
}

namespace {

/// Switches of a new projectile.
std::uint32_t flags_of(const BodyDef& body) {
  Slot slot;
  slot.set(kKinematic, body.kinematic);
  slot.set(kInfiniteMass, body.infinite_mass);
  slot.set(kSleepless, !body.can_sleep);
  for (const OwnPart& part : kOwnParts) slot.set(part.flag, part.differs(own_of(body)));
  slot.set_smoothing(body.smoothing);
  return slot.flags;
}

/// The events that are looked for inside a step.
WatchList watch_of(const WorldDef& def, const Conditions<double>& c) {
  Until frames;
  frames.time = std::numeric_limits<double>::infinity();
  frames.ground = def.ground.mode == GroundMode::none ? std::nullopt : std::optional(def.ground.height);
  return prepare_watch(frames, c, def.apex_events ? Watcher::world_with_apexes : Watcher::world);
}

/// Frames are steps of their own length, divided a limited number of times.
template <class S>
StepPlan<S> frame_plan(const WorldDef& def, const Fidelity& granted) {
  StepPlan<S> plan = prepare_plan<S>(def.tolerance, granted, 0);
  plan.max_step = S(1e30);
  plan.max_tries = S(kMostPartsOfFrame);
  return plan;
}

}  // namespace

Result<std::uint32_t> Registry::find_or_add_kind(const ProjectileDef& projectile, const BodyDef& body,
                                                 std::uint64_t moment) {
  const std::uint32_t last = kinds.find(KindId{last_given_});
  if (last != 0 && kinds.is(last, projectile, body)) return last;  // as a gun keeps firing
  Kind added;
  added.hash = hash_of(projectile, body);
  std::uint32_t index = kinds.find(added.hash, projectile, body);
  if (index == 0) {
    if (const Status status = check(projectile); !status) return status.error();
    if (const Status status = check(body, def_, environments_.size()); !status) return status.error();
    if (kinds.is_full()) return Error{"there are too many kinds of projectiles", "world", "reuse kinds"};
    Result<ProjectileDef> flown = with_drag_scaled(projectile, body.drag_scale);
    if (!flown) return flown.error();
    added.projectile = projectile;
    added.body = body;
    added.flown = std::move(*flown);
    added.flags = flags_of(body);
    added.born = moment;
    index = kinds.add(std::move(added));
    rung(index, projectile.fidelity);
  }
  last_given_ = kind(index).number;
  return index;
}

void Registry::add_saved_kind(Kind saved) {
  saved.hash = hash_of(saved.projectile, saved.body);
  saved.flown = with_drag_scaled(saved.projectile, saved.body.drag_scale).value();
  saved.flags = flags_of(saved.body);
  Kind& k = kind(kinds.add(std::move(saved)));
  for (Prepared& r : k.rungs) {
    r.hash = hash_of(k.projectile, k.body, r.asked);
    if (has_environment_of(k)) prepare(k, r);
  }
}

std::size_t Registry::bytes() const {
  std::size_t numbers = 0;
  for (const TablePool& pool : tables_) numbers += pool.size();
  return kinds.bytes() + cohorts_.size() * sizeof(WorldCohort) + numbers * sizeof(double) +
         environments_.capacity() * sizeof(Environment);
}

std::optional<std::uint16_t> Registry::rung(std::uint32_t index, const Fidelity& asked, const FidelityNote* why) {
  Kind& k = kind(index);
  const auto same_choice = [why](const std::optional<FidelityNote>& known) {
    return why ? known && known->reason == why->reason : !known;
  };
  for (std::size_t i = 0; i < k.rungs.size(); ++i)
    if (k.rungs[i].asked == asked && same_choice(k.rungs[i].chosen)) return static_cast<std::uint16_t>(i);
  if (k.rungs.size() >= kMostRungs) return std::nullopt;
  Prepared& added = k.rungs.emplace_back();
  added.asked = asked;
  added.hash = hash_of(k.projectile, k.body, asked);
  if (why) added.chosen = *why;
  prepare(k, added);
  return static_cast<std::uint16_t>(k.rungs.size() - 1);
}

void Registry::prepare(Kind& k, Prepared& r) {
  const Environment& environment = environments_[k.body.environment];
  r.in_use = grant_in_world(r.asked, k.flown, environment);
  if (r.chosen) r.in_use.notes.push_back(*r.chosen);
  const Fidelity& granted = r.in_use.fidelity;
  ProfileTables profiles;
  Conditions<double> probe = prepare_conditions(environment, granted, profiles);
  TablePool& pool = tables(granted.interpolation);
  const std::size_t size_before = pool.size();
  r.body = prepare_body(k.flown, Launch{}, 0, pool, probe);
  r.rotor = nullptr;
  if (turns(granted))
    r.rotor = std::make_unique<Rotor<double>>(prepare_rotor(k.flown, Launch{}, 0, r.body, pool, probe));
  if (pool.size() != size_before)
    for (WorldCohort& cohort : cohorts_) point_to_tables(cohort);
  const bool equivalent = granted.drag == DragModel::linear_quadratic && k.flown.drag.k1 == 0 && k.flown.drag.k2 == 0;
  auto& curves = equivalent_[static_cast<unsigned>(granted.interpolation)];
  if (!curves) curves = std::make_shared<TablePool>();
  r.equivalent_drag =
      equivalent ? std::make_unique<EquivalentDrag>(k.flown, r.body, probe, curves, std::move(profiles)) : nullptr;
  r.features = probe;
  std::fill(std::begin(r.cohort), std::end(r.cohort), kNoCohort);
}

std::uint16_t Registry::cohort(std::uint32_t index, std::uint16_t rung, const Variant& variant) {
  const Kind& k = kind(index);
  PHYSIM_ASSERT(rung < k.rungs.size());
  Prepared& r = kind(index).rungs[rung];
  PHYSIM_ASSERT(variant.index() < kVariants);
  std::uint16_t& known = r.cohort[variant.index()];
  if (known != kNoCohort) return known;
  CohortKey key;
  key.environment = k.body.environment;
  key.fidelity = r.in_use.fidelity;
  key.features = r.features;
  for (std::size_t i = 0; i < kOwnParts.size(); ++i) key.features.*kOwnParts[i].feature |= (variant.own >> i & 1u) != 0;
  key.features.has_rail = variant.railed && flies_motors(key.fidelity);
  key.launch_place = std::isfinite(k.body.despawn.farther);
  key.rules.despawn = k.body.despawn;
  if (k.body.can_sleep && !variant.sleepless) {
    key.rules.sleep_speed = k.body.sleep_speed;
    key.rules.sleep_time = k.body.sleep_time;
  }
  key.meets = has_scene_ && k.body.collision.layers != 0;
  key.forced = variant.forced;
  key.still = variant.still;
  known = find_or_add(key);
  if (known == kNoCohort) return known;
  double& radius = cohorts_[known].most_radius;
  radius = std::max(radius, k.body.collision.radius);
  return known;
}

std::uint16_t Registry::find_or_add(const CohortKey& key) {
  for (std::size_t i = 0; i < cohorts_.size(); ++i)
    if (cohorts_[i].key == key) return static_cast<std::uint16_t>(i);
  if (cohorts_.size() >= kMostCohorts) return kNoCohort;
  WorldCohort& added = cohorts_.emplace_back();
  added.key = key;
  added.layout = layout_of(key.fidelity, key.features, key.launch_place, key.meets);
  prepare(added);
  return static_cast<std::uint16_t>(cohorts_.size() - 1);
}

void Registry::prepare(WorldCohort& cohort) {
  const CohortKey& key = cohort.key;
  PHYSIM_ASSERT(key.environment < environments_.size());
  cohort.conditions = prepare_conditions(environments_[key.environment], key.fidelity, cohort.profiles);
  const bool has_air_profile = cohort.conditions.has_air_profile;
  static_cast<Features&>(cohort.conditions) = key.features;
  cohort.conditions.has_air_profile = has_air_profile;  // as rows on their way out have the new environment, too
  cohort.conditions.has_applied = cohort.conditions.has_applied || key.forced;
  // Rows on their way out, of an environment that has lost its functions.
  if (!cohort.conditions.wind_function) cohort.conditions.has_wind_function = false;
  if (!cohort.conditions.force_function) cohort.conditions.has_force_function = false;
  cohort.static_rung = static_rung_of(key.fidelity, cohort.features());
  cohort.conditions_float = to_float(cohort.conditions, cohort.profiles);
  const WatchList watch = watch_of(def_, cohort.conditions);
  const NumberRuns flown = parts_flown(key.fidelity, cohort.conditions).runs();
  const bool corners = corners_matter(cohort.conditions);
  cohort.course_float = {
      &cohort.conditions_float, &cohort.conditions, flown, frame_plan<float>(def_, key.fidelity), watch, corners};
  cohort.course_double = {
      &cohort.conditions, &cohort.conditions, flown, frame_plan<double>(def_, key.fidelity), watch, corners};
  point_to_tables(cohort);
}

void Registry::point_to_tables(WorldCohort& cohort) {
  TablePool& pool = tables(cohort.key.fidelity.interpolation);
  pool.point(cohort.conditions);
  pool.point(cohort.conditions_float);
}

Result<std::uint32_t> Registry::add_environment(const Environment& environment) {
  if (const Status status = check(environment); !status) return status.error();
  if (environments_.size() >= 4096) return Error{"there are too many environments", "world", "at most 4096"};
  const auto index = static_cast<std::uint32_t>(environments_.size());
  environments_.push_back(environment);
  if (const Status status = set_environment(index, environment); !status)
    return status.error();  // for kinds of before a restore
  return index;
}

Status Registry::set_environment(std::uint32_t index, const Environment& environment) {
  if (index >= environments_.size()) return Error{"there is no such environment", "environment", "add it first"};
  if (Status status = check(environment); !status) return status;
  environments_[index] = environment;
  for (WorldCohort& cohort : cohorts_)
    if (cohort.key.environment == index) prepare(cohort);
  kinds.each([&](Kind& k) {
    if (k.body.environment != index) return;
    for (Prepared& r : k.rungs) prepare(k, r);
  });
  return {};
}

void Registry::meet_scene(bool there) {
  if (std::exchange(has_scene_, there) == there) return;
  kinds.each([](Kind& k) {
    for (Prepared& r : k.rungs) std::fill(std::begin(r.cohort), std::end(r.cohort), kNoCohort);
  });
}

void Registry::restore_environments(const std::vector<Environment>& then) {
  const std::size_t known = environments_.size();
  environments_.resize(then.size());
  for (std::uint32_t i = 0; i < then.size(); ++i)
    if (i >= known || !(then[i] == environments_[i])) {
      [[maybe_unused]] const Status status = set_environment(i, then[i]);
      PHYSIM_ASSERT(status.ok());  // what a snapshot holds was checked when it was set
    }
}

}  // namespace physim
