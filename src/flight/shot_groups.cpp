#include "flight/shot_groups.hpp"

#include <algorithm>
#include <cmath>

#include "base/text.hpp"
#include "flight/pilot.hpp"
#include "flight/zero.hpp"
#include "model/drag_curves.hpp"
#include "model/standard_atmosphere.hpp"
#include "prepare/check.hpp"
#include "prepare/conditions.hpp"
#include "prepare/grant.hpp"
#include "prepare/launch.hpp"
#include "prepare/watch_list.hpp"

namespace physim {
namespace {

/// Whether a launch without a rail gives a Body only the first numbers: what else put_launch() sets is not read.
bool differ_by_launch_alone(const Conditions<double>& c) {
  return !spins(c.fidelity) && !is_in_repose(c.fidelity) && !c.has_motor && !c.has_force_end &&
         c.fidelity.drag != DragModel::linear_quadratic;
}

/// Whether the spline through a projectile's own curve overshoots. Fitting one costs more than a flight.
bool overshoots(const DragDef& drag, KnownCurve* known) {
  if (known == nullptr) return spline_overshoots(drag);
  if (!known->overshoots) known->overshoots = spline_overshoots(drag);
  return *known->overshoots;
}

unsigned rotation_key(const ProjectileDef& p) {
  return (has_inertia(p) ? 128u : 0) | (is_axisymmetric(p) ? 256u : 0) | (p.aero.pitching.empty() ? 0 : 2048u) |
         (p.aero.lift.empty() ? 0 : 4096u);
}

}  // namespace

// ------------------------------------------------------------------------------------------- one group
/// Lanes hold no more than models read; where the rotation is flown, answers about attitudes need more.
void ShotGroup::begin() {
  features_ = cohort.conditions;
  const Fidelity& granted = cohort.in_use.fidelity;
  own_stride_ = (turns(granted) ? own : own & parts_flown(granted, features_)).runs().end();
}

void ShotGroup::add(std::uint32_t shot, const Body<double>& body) {
  if (shots.empty()) begin();
  PHYSIM_ASSERT(features_ == static_cast<const Features&>(cohort.conditions));
  shots.push_back(shot);
  own_numbers.insert(own_numbers.end(), numbers(body), numbers(body) + own_stride());
}

Body<double> ShotGroup::body(std::size_t i) const {
  PHYSIM_ASSERT(i < shots.size() && own_numbers.size() == shots.size() * own_stride());
  Body<double> b = common;
  std::copy_n(own_numbers.data() + i * own_stride(), own_stride(), numbers(b));
  return b;
}

void ShotGroup::clear() {
  shots.clear();
  own_numbers.clear();
  rotors.clear();
  drifts.clear();
  events.clear();
}

// ------------------------------------------------------------------------------------------- all of them
/// Null for a standard curve, and for one that is not known.
KnownCurve* ShotGroups::known_curve(const DragDef& drag) {
  if (drag.table != DragTable::custom) return nullptr;
  for (KnownCurve& known : known_curves_)
    if (same_points(known.points, drag.curve)) return &known;
  return nullptr;
}

/// check() of a projectile, which looks at its own drag curve once; `curve` is that afterwards, if it has one.
Status ShotGroups::look_at_projectile(const ProjectileDef& projectile, KnownCurve*& curve) {
  const DragDef& drag = projectile.drag;
  curve = known_curve(drag);
  if (curve != nullptr) return check_but_curve(projectile);
  auto status = check(projectile);
  if (!status || drag.table != DragTable::custom) return status;
  if (known_curves_.size() == kMostKnownCurves) known_curves_.clear();
  curve = &known_curves_.emplace_back(KnownCurve{drag.curve});
  return status;
}

/// grant() looks at these of a projectile, so shots that agree in them are granted the same.
unsigned ShotGroups::grant_key(const ProjectileDef& p, KnownCurve* curve) const {
  const DragDef& d = p.drag;
  const Fidelity& asked = task_.fidelity;
  return (p.twist == 0 ? 1u : 0) | (p.length <= 0 ? 2u : 0) | (d.k1 == 0 ? 4u : 0) | (d.k2 == 0 ? 8u : 0) |
         (d.damping < 1 ? 16u : 0) | (p.force != Vec3d{} ? 32u : 0) |
         (asked.interpolation == Interpolation::cubic && overshoots(d, curve) ? 64u : 0) |
         (may_turn(asked) ? rotation_key(p) : 0) | (has_motor(p) ? 512u : 0) | (has_magnus(p) ? 1024u : 0);
}

ShotGroup& ShotGroups::group_of(const ProjectileDef& projectile, KnownCurve* curve) {
  const unsigned key = grant_key(projectile, curve);
  PHYSIM_ASSERT(key < group_by_key_.size());
  ShotGroup*& known = group_by_key_[key];
  if (known) return *known;
  const Environment environment = task_.granting();
  const Fidelity asked = by_steps(task_.fidelity, task_.tolerance.step > 0);
  const FidelityInUse in_use = grant(asked, projectile, environment);
  for (ShotGroup& group : groups_)
    if (group.cohort.in_use.fidelity == in_use.fidelity) return *(known = &group);
  known = &groups_.emplace_back();
  known->own = parts_of_shots();
  known->cohort.in_use = in_use;
  Conditions<double>& conditions = known->cohort.conditions;
  conditions = prepare_conditions(environment, in_use.fidelity, known->cohort.profiles);
  conditions.has_own_wind = task_.weather.has_wind() && in_use.fidelity.wind != WindModel::off;
  conditions.has_own_air = task_.weather.has_air();
  return *known;
}

PartSet ShotGroups::parts_of_shots() const {
  return task_.weather.empty() ? PartSet::all() - kWeatherParts : PartSet::all();
}

/// What is known of a shot's projectile.
ShotKind& ShotGroups::kind_of(std::size_t shot) {
  const ProjectileDef& projectile = projectiles_.of(shot);
  if (kind_.projectile == &projectile && !task_.shots.has_own_drag()) return kind_;
  kind_.projectile = &projectile;
  kind_.status = look_at_drag(shot);
  KnownCurve* curve = nullptr;
  if (kind_.status) kind_.status = look_at_projectile(projectile, curve);
  if (!kind_.status) return kind_;
  ShotGroup& group = group_of(projectile, curve);
  kind_.group = &group;
  Cohort& cohort = group.cohort;
  put_kind(projectile, cohort.pool, cohort.conditions, kind_.body);
  if (turns(cohort.in_use.fidelity)) kind_.rotor = prepare_rotor_kind(projectile, cohort.pool, cohort.conditions);
  if (steps_by_frames(cohort.in_use.fidelity)) cohort.finish();  // frame_step() looks at its drag
  if (!task_.shots.one_projectile || !group.shots.empty()) return kind_;
  group.common = kind_.body;
  if (!differ_by_launch_alone(cohort.conditions)) return kind_;
  group.own = kLaunchParts | (parts_of_shots() & kWeatherParts);
  group.own.add<AreaPart>(task_.shots.has_own_drag());
  return kind_;
}

/// check() knows a projectile alone, where 0 means that there is no ballistic coefficient.
Status ShotGroups::look_at_drag(std::size_t shot) const {
  if (!task_.shots.has_own_drag()) return {};
  const LaunchColumns& from = *task_.shots.columns;
  PHYSIM_ASSERT(shot < from.size());
  const auto check_column = [shot](std::span<const double> column, const char* place) -> Status {
    if (column.empty() || (std::isfinite(column[shot]) && column[shot] > 0)) return {};
    return Error{"must be a positive number, got " + short_text(column[shot]),
                 std::string(place) + "[" + std::to_string(shot) + "]", "leave the column out where all have one"};
  };
  if (auto status = check_column(from.ballistic_coefficient, "launches.ballistic_coefficient"); !status) return status;
  return check_column(from.form_factor, "launches.form_factor");
}

ShotState ShotGroups::refuse(Status why) {
  PHYSIM_ASSERT(!why);
  refusal_ = std::move(why);
  return ShotState::refused;
}

/// Takes a shot's launch and environment, and checks them.
Status ShotGroups::look_at(std::size_t shot, const ProjectileDef& projectile) {
  launch_ = &task_.shots.launch(shot, scratch_);
  environment_ = &environments_.of(shot);
  if (auto status = check(*launch_); !status) return status;
  if (auto status = check(projectile, *launch_); !status) return status;
  if (task_.weather.empty()) return {};
  if (auto status = check(*environment_); !status) return status;
  if (task_.weather.density.empty() || task_.weather.density[shot] > 0) return {};
  return Error{"must be above 0", "weather.density[" + std::to_string(shot) + "]", "fly vacuum in a batch of its own"};
}

ShotState ShotGroups::prepare(std::size_t shot) {
  ShotKind& kind = kind_of(shot);
  if (!kind.status) return refuse(kind.status);
  const ProjectileDef& projectile = *kind.projectile;
  if (auto status = look_at(shot, projectile); !status) return refuse(std::move(status));
  const Launch& launch = *launch_;
  double elevation = launch.elevation;
  if (launch.sight.zero_range > 0) {
    const auto found = elevation_of(projectile, launch, *environment_, task_.fidelity);
    if (!found) return refuse(found.error());
    elevation = *found;
  }
  Cohort& cohort = kind.group->cohort;
  const Fidelity& granted = cohort.in_use.fidelity;
  Body<double>& body = kind.body;
  if (task_.weather.has_wind()) {
    const Wind& common = task_.environment.wind;
    body.wind = task_.weather.wind(shot, common) + own_wind_less_column(task_.weather, common, granted.wind);
  }
  if (task_.weather.has_air()) body.air = prepare_air_numbers(*environment_, granted.air);
  put_launch(projectile, launch, sight_frame(launch), elevation, cohort.conditions, body);
  if (auto status = check_fits(body.launch.x, body.launch.v, granted.precision); !status)
    return refuse(std::move(status));
  jump_in_crosswind(projectile, *environment_, cohort.conditions, body);
  if (turns(granted)) put_launch(projectile, launch, elevation, body, cohort.conditions, kind.rotor);
  if (ends_at_once(cohort.conditions, body, task_.until, outcome_)) return ShotState::over;
  const bool by_frames = steps_by_frames(granted) && !step_given(granted, task_.tolerance);
  if (by_frames && frame_step(cohort, body, kind.rotor, task_.until) < kFrame) return ShotState::alone;
  return ShotState::flies;
}

}  // namespace physim
