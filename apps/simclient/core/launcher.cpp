#include "simclient/core/launcher.hpp"

#include <algorithm>
#include <cmath>

#include "base/assert.hpp"
#include "base/text.hpp"
#include "math/angles.hpp"
#include "physim/body.hpp"
#include "simclient/core/session.hpp"

namespace physim::client {
namespace {

constexpr int kMaxSetting = 5;
constexpr double kElevationStep = 5 * kDegree, kMaxElevation = 45 * kDegree;
constexpr double kSteepest = 89.9 * kDegree;

// In motion `force` of the original a constant force pushes every shot from rest, and gravity is the world's.
constexpr double kPushForward = 10;           // [m/s^2]
constexpr double kWorldGravity = 4;           // [m/s^2]
constexpr double kStandardGravity = 9.80665;  // [m/s^2]

OriginalEffect next(OriginalEffect effect) {
  switch (effect) {
    case OriginalEffect::off: return OriginalEffect::constant;
    case OriginalEffect::constant: return OriginalEffect::force;
    case OriginalEffect::force: return OriginalEffect::off;
  }
  return OriginalEffect::off;
}

ShotType type_of(std::string_view name) {
  const ProjectilePreset preset = *projectile_preset(name);
  ShotType type{std::string(name), preset.doc, {}, 0, 0};
  type.shot.projectile = preset.projectile;
  type.shot.body = preset.body;
  type.shot.launch.position = {0, 1.5, 0};
  type.shot.launch.speed = preset.speed;
  if (name == "artillery") type.forward = 40, type.up = 2;
  if (name == "bullet" || name == "laser") type.forward = 35, type.up = 1;
  return type;
}

}  // namespace

std::string_view name(OriginalEffect effect) {
  switch (effect) {
    case OriginalEffect::off: return "off";
    case OriginalEffect::constant: return "constant";
    case OriginalEffect::force: return "force";
  }
  return "";
}

Launcher::Launcher(const Scenario& scenario, std::uint64_t version) : version_(version) {
  for (const std::string_view name : projectile_presets()) types_.push_back(type_of(name));
  const std::size_t presets = types_.size();
  for (const ScenarioShot& shot : scenario.shots)
    types_.push_back({shot.projectile.name, "of the scenario", shot, 0, 0});
  select(types_.size() > presets ? presets : 0);
}

void Launcher::select(std::size_t type) {
  type_ = std::min(type, types_.size() - 1);
  shot_ = types_[type_].shot;
  ++version_;
  if (types_[type_].is_original()) set_original_elevation(setting_), put_original(), push();
}

bool Launcher::select(std::string_view name) {
  for (std::size_t i = types_.size(); i-- > 0;)  // those of the scenario win
    if (types_[i].name == name) return select(i), true;
  return false;
}

void Launcher::set_shot(const ScenarioShot& shot) {
  const bool was_pushed = is_pushed() && shot.projectile.force == shot_.projectile.force;
  shot_ = shot;
  ++version_;
  if (!is_original()) return;
  follow_hand();
  if (was_pushed) push();  // another mass
}

void Launcher::bring_back(const Launcher& from) {
  const std::uint64_t next = version_ + 1;
  *this = from;
  version_ = next;
}

// ------------------------------------------------------------------------------------------------ the original's mode
bool Launcher::is_original() const {
  return types_[type_].is_original() && shot_.projectile.fidelity.integrator == Integrator::classic;
}

Vec3d Launcher::original_start() const {
  const ShotType& type = types_[type_];
  return motion_ == Motion::force ? Vec3d{kPushForward, static_cast<double>(setting_), 0}
                                  : Vec3d{type.forward, type.up * setting_, 0};
}

bool Launcher::is_pushed() const {
  return is_original() && motion_ == Motion::force && shot_.projectile.force == original_push();
}

void Launcher::push() {
  if (motion_ == Motion::force) shot_.projectile.force = original_push();
}

/// Along the barrel.
Vec3d Launcher::original_push() const {
  Vec3d push = original_start();
  if (!elevation_setting()) {
    const double size = length(push);
    push = {size * std::cos(elevation()), size * std::sin(elevation()), 0};
  }
  return Vec3d{push.x * std::cos(azimuth()), push.y, push.x * std::sin(azimuth())} * shot_.projectile.mass;
}

void Launcher::set_original_elevation(int setting) {
  setting_ = setting;
  use_angles();
  const Vec3d start = original_start();
  shot_.launch.speed = motion_ == Motion::force ? 0 : length(start);
  shot_.launch.elevation = std::atan2(start.y, start.x);
}

/// Gives the shot what motion, gravity and drag of the original mean.
void Launcher::put_original() {
  const bool by_force = motion_ == Motion::force;
  ProjectileDef& projectile = shot_.projectile;
  Fidelity& f = projectile.fidelity;
  f.motion = motion_;
  const bool falls = gravity_ == OriginalEffect::constant || (gravity_ == OriginalEffect::force && by_force);
  f.gravity = falls ? GravityModel::constant : GravityModel::off;
  projectile.gravity_scale = gravity_ == OriginalEffect::force ? kWorldGravity / kStandardGravity
                                                               : types_[type_].shot.projectile.gravity_scale;
  f.drag = DragModel::off;
  if (drag_ == OriginalEffect::constant) f.drag = DragModel::damping;
  if (drag_ == OriginalEffect::force && by_force) f.drag = DragModel::linear_quadratic;
  ++version_;
}

/// Settings that were changed by hand, one by one, are those of the original that come nearest.
void Launcher::follow_hand() {
  const Fidelity& f = shot_.projectile.fidelity;
  const bool by_force = f.motion == Motion::force;
  motion_ = by_force ? Motion::force : Motion::velocity;
  const bool may_be_idle = !by_force && gravity_ == OriginalEffect::force;
  if (f.gravity != GravityModel::off && gravity_ == OriginalEffect::off) gravity_ = OriginalEffect::constant;
  if (f.gravity == GravityModel::off && !may_be_idle) gravity_ = OriginalEffect::off;
  if (f.drag == DragModel::damping)
    drag_ = OriginalEffect::constant;
  else if (f.drag != DragModel::off)
    drag_ = OriginalEffect::force;
  else if (by_force || drag_ != OriginalEffect::force)
    drag_ = OriginalEffect::off;
}

void Launcher::cycle_motion() {
  if (!is_original()) return cycle(&Fidelity::motion);
  if (is_pushed()) shot_.projectile.force = {};
  motion_ = motion_ == Motion::velocity ? Motion::force : Motion::velocity;
  put_original();
  set_original_elevation(setting_);
  push();
}

void Launcher::cycle_gravity() {
  if (!is_original()) return cycle(&Fidelity::gravity);
  gravity_ = next(gravity_);
  put_original();
}

void Launcher::cycle_drag() {
  if (!is_original()) return cycle(&Fidelity::drag);
  drag_ = next(drag_);
  put_original();
}

// ------------------------------------------------------------------------------------------------------------- the aim
/// Speed and angles instead of a velocity, which leaves no room for a barrel that turns.
void Launcher::use_angles() {
  ++version_;
  Launch& launch = shot_.launch;
  if (!launch.velocity) return;
  const Vec3d v = *launch.velocity;
  launch.velocity.reset();
  launch.speed = length(v);
  launch.elevation = launch.speed > 0 ? std::asin(v.y / launch.speed) : 0;
  launch.azimuth = v.x != 0 || v.z != 0 ? std::atan2(v.z, v.x) : 0;
}

void Launcher::cycle_elevation() {
  const bool was_pushed = is_pushed();
  if (elevation_setting()) {
    set_original_elevation((setting_ + 1) % (kMaxSetting + 1));
  } else {
    use_angles();
    double& elevation = is_zeroed() ? shot_.launch.sight.dial : shot_.launch.elevation;
    const double steps = std::floor(elevation / kElevationStep + 1e-6) + 1;
    elevation = steps * kElevationStep > kMaxElevation + 1e-6 ? 0 : steps * kElevationStep;
  }
  if (was_pushed) push();
}

void Launcher::point(double azimuth, double elevation) {
  const bool was_pushed = is_pushed();
  use_angles();
  shot_.launch.azimuth = std::remainder(azimuth, 360 * kDegree);
  (is_zeroed() ? shot_.launch.sight.dial : shot_.launch.elevation) = std::clamp(elevation, -kSteepest, kSteepest);
  if (was_pushed) push();
}

void Launcher::set_speed(double speed) {
  PHYSIM_ASSERT(speed >= 0);
  const bool was_pushed = is_pushed();
  use_angles();
  shot_.launch.speed = speed;
  if (was_pushed) push();
}

std::optional<int> Launcher::elevation_setting() const {
  if (!types_[type_].is_original()) return std::nullopt;
  const Vec3d start = original_start();
  const double wanted = motion_ == Motion::force ? 0 : length(start);
  const bool in_force =
      std::abs(elevation() - std::atan2(start.y, start.x)) < 1e-12 && std::abs(speed() - wanted) < 1e-9;
  return in_force ? std::optional(setting_) : std::nullopt;
}

double Launcher::elevation() const {
  const Launch& launch = shot_.launch;
  if (is_zeroed()) return launch.sight.dial;
  if (!launch.velocity) return launch.elevation;
  const double v = length(*launch.velocity);
  return v > 0 ? std::asin(launch.velocity->y / v) : 0;
}

double Launcher::azimuth() const {
  const Launch& launch = shot_.launch;
  return launch.velocity ? std::atan2(launch.velocity->z, launch.velocity->x) : launch.azimuth;
}

double Launcher::speed() const { return shot_.launch.velocity ? length(*shot_.launch.velocity) : shot_.launch.speed; }

std::string Launcher::elevation_text() const {
  const double degrees = elevation() / kDegree, zero = shot_.launch.sight.zero_range;
  const std::string above = raised() != 0 ? formatted(", %+.2f\u00b0", degrees) : "";
  if (zero > 0) return formatted("zeroed at %.6g m", zero) + above;
  if (const auto setting = elevation_setting()) return formatted("e = %d (%.1f\u00b0)", *setting, degrees);
  return formatted("%.2f\u00b0", degrees);
}

}  // namespace physim::client
