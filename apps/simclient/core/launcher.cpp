#include "simclient/core/launcher.hpp"

#include <algorithm>
#include <cmath>

#include "base/text.hpp"
#include "math/angles.hpp"
#include "physim/presets.hpp"
#include "simclient/core/session.hpp"

namespace physim::client {
namespace {

constexpr int kMaxSetting = 5;
constexpr double kElevationStep = 5 * kDegree, kMaxElevation = 45 * kDegree;
constexpr double kSteepest = 89.9 * kDegree;

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
  if (types_[type_].is_original()) set_original_elevation(setting_);
}

bool Launcher::select(std::string_view name) {
  for (std::size_t i = types_.size(); i-- > 0;)  // those of the scenario win
    if (types_[i].name == name) return select(i), true;
  return false;
}

void Launcher::set_shot(const ScenarioShot& shot) {
  shot_ = shot;
  ++version_;
}

void Launcher::set_original_elevation(int setting) {
  setting_ = setting;
  const ShotType& type = types_[type_];
  use_angles();
  shot_.launch.speed = std::hypot(type.forward, type.up * setting);
  shot_.launch.elevation = std::atan2(type.up * setting, type.forward);
}

/// Speed and angles instead of a velocity, which leaves no room for a barrel that turns.
void Launcher::use_angles() {
  ++version_;
  Launch& launch = shot_.launch;
  launch.sight.zero_range = 0;
  if (!launch.velocity) return;
  const Vec3d v = *launch.velocity;
  launch.velocity.reset();
  launch.speed = length(v);
  launch.elevation = launch.speed > 0 ? std::asin(v.y / launch.speed) : 0;
  launch.azimuth = v.x != 0 || v.z != 0 ? std::atan2(v.z, v.x) : 0;
}

void Launcher::cycle_elevation() {
  if (elevation_setting()) return set_original_elevation((setting_ + 1) % (kMaxSetting + 1));
  use_angles();
  double& elevation = shot_.launch.elevation;
  const double steps = std::floor(elevation / kElevationStep + 1e-6) + 1;
  elevation = steps * kElevationStep > kMaxElevation + 1e-6 ? 0 : steps * kElevationStep;
}

void Launcher::turn(double right, double up) {
  use_angles();
  shot_.launch.azimuth = std::remainder(shot_.launch.azimuth + right, 360 * kDegree);
  shot_.launch.elevation = std::clamp(shot_.launch.elevation + up, -kSteepest, kSteepest);
}

std::optional<int> Launcher::elevation_setting() const {
  const ShotType& type = types_[type_];
  if (!type.is_original()) return std::nullopt;
  const bool in_force = std::abs(elevation() - std::atan2(type.up * setting_, type.forward)) < 1e-12 &&
                        std::abs(speed() - std::hypot(type.forward, type.up * setting_)) < 1e-9;
  return in_force ? std::optional(setting_) : std::nullopt;
}

double Launcher::elevation() const {
  const Launch& launch = shot_.launch;
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
  if (zero > 0) return formatted("zeroed at %.6g m", zero);
  if (const auto setting = elevation_setting()) return formatted("e = %d (%.1f\u00b0)", *setting, degrees);
  return formatted("%.2f\u00b0", degrees);
}

}  // namespace physim::client
