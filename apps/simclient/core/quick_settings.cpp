#include "simclient/core/quick_settings.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include "base/assert.hpp"
#include "base/text.hpp"
#include "math/angles.hpp"
#include "physim/names.hpp"
#include "settings/units.hpp"
#include "simclient/core/scene.hpp"

namespace physim::client {
namespace {

constexpr AccuracyRung kRungs[] = {
    {"arcade", "arcade", "It falls; air does nothing. The cheapest step."},
    {"game", "game", "Linear and quadratic drag in the same air everywhere, in single precision."},
    {"constant_air", "constant air", "The full drag curve and spin, in the same air everywhere."},
    {"small_arms", "small arms", "Air that thins out with height, wind by height, spin drift."},
    {"artillery", "artillery", "The Earth turns, gravity falls off with height, smooth drag curves."},
    {"simulation", "simulation", "Six degrees of freedom where the data allow them."},
    {"reference", "reference", "As simulation, with the smallest errors that numbers have room for."},
};

double usual_speed(const Launcher& launcher) {
  const Launch& usual = launcher.types()[launcher.type()].shot.launch;
  return usual.velocity ? length(*usual.velocity) : usual.speed;
}

/// A round number that is not below another.
double round_above(double x) { return scale_step(x, 1); }

std::string with_digits(double value) { return formatted("%.9g", value); }

void hold(QuickSetting& setting) {
  setting.low = std::min(setting.low, setting.value), setting.high = std::max(setting.high, setting.value);
}

QuickSetting mass_of(const Launcher& launcher) {
  const double usual = launcher.types()[launcher.type()].shot.projectile.mass;
  const double unit = usual < 1 ? 1e-3 : 1;
  const double middle = round_above(usual / unit);
  return {Quick::mass,
          "mass",
          usual < 1 ? "g" : "kg",
          "mass at launch",
          middle / 10,
          middle * 10,
          launcher.shot().projectile.mass / unit,
          true,
          ""};
}

/// True if a preset's model of rotation grants another one for some data, or is the same.
bool is_meant_by(RotationModel of_preset, RotationModel rotation) {
  switch (rotation) {
    case RotationModel::rigid_body:
    case RotationModel::modified_point_mass: return of_preset == RotationModel::automatic;
    case RotationModel::magnus:
    case RotationModel::spin_drift: return of_preset == RotationModel::automatic_point;
    case RotationModel::none:
    case RotationModel::automatic_point:
    case RotationModel::automatic: break;
  }
  return of_preset == rotation;
}

}  // namespace

std::vector<QuickSetting> quick_settings(Client& client) {
  const Launcher& launcher = client.launcher;
  const ScenarioShot& shot = launcher.shot();
  const Fidelity& asked = shot.projectile.fidelity;  // what is granted leaves out a wind that does not blow yet
  const Environment& environment = client.session.scenario().environment;
  const bool is_in_vacuum = asked.air == AirModel::vacuum || environment.atmosphere.model == AirModel::vacuum;
  const std::string no_air = is_in_vacuum ? "does nothing: it flies without air" : "";
  const Wind& wind = environment.wind;
  const std::string no_wind = is_in_vacuum                   ? no_air
                              : asked.wind == WindModel::off ? "does nothing: this accuracy knows no wind"
                              : asked.drag == DragModel::off ? "does nothing: drag is off"
                              : !wind.profile.empty() || !(wind.field == WindFunction{})
                                  ? "does nothing: the scenario's wind has a profile"
                              : asked.drag == DragModel::damping ? "does nothing: damping knows no wind"
                                                                 : "";
  const double usual = usual_speed(launcher);
  std::vector<QuickSetting> all = {
      {Quick::speed, "speed", "m/s", "speed at the muzzle", 0, usual > 0 ? round_above(2 * usual) : 100,
       launcher.speed(), false, ""},
      {Quick::elevation, "elevation", "\u00b0",
       launcher.is_zeroed() ? "of the barrel, above the zero" : "of the barrel, above the horizon",
       launcher.is_zeroed() ? -5.0 : -30.0, launcher.is_zeroed() ? 45.0 : 89.0, launcher.elevation() / kDegree, false,
       ""},
      {Quick::azimuth, "direction", "\u00b0", "of the barrel, from downrange to the right", -180, 180,
       launcher.azimuth() / kDegree, false, ""},
      mass_of(launcher),
      {Quick::drag, "drag", "", "whether the air slows it down", 0, 1,
       shot.projectile.fidelity.drag == DragModel::off ? 0.0 : 1.0, false, no_air},
      {Quick::wind_along, "tail wind", "m/s", "velocity of the air downrange, everywhere", -20, 20, wind.velocity.x,
       false, no_wind},
      {Quick::wind_across, "wind from left", "m/s", "velocity of the air to the right, everywhere", -20, 20,
       wind.velocity.z, false, no_wind},
  };
  if (!std::isfinite(shot.projectile.mass)) std::erase_if(all, [](const auto& s) { return s.what == Quick::mass; });
  for (QuickSetting& setting : all) hold(setting);
  return all;
}

Status set_quick(Client& client, const QuickSetting& setting, double value) {
  PHYSIM_ASSERT(std::isfinite(value));
  Launcher& launcher = client.launcher;
  // A slider goes to numbers that there are in the unit of the file, in which they are saved.
  const auto in_file = [&](const char* path, const std::string& unit) {
    return client.units().restated(path, launcher.shot().projectile.name, with_digits(value) + " " + unit);
  };
  const auto rounded = [&](const char* path, const std::string& unit, Quantity quantity) {
    return parse_quantity(in_file(path, unit), quantity).value();
  };
  const Vec3d wind = client.session.scenario().environment.wind.velocity;
  // Parts that stay keep their digits; nothing is nothing in every unit.
  const auto kept = [&](double part) {
    const std::string text = quantity_text(part, Quantity::speed);
    const std::string& shot = launcher.shot().projectile.name;
    return part == 0 ? client.units().restated("environment.wind.velocity", shot, text) : text;
  };
  const auto set_wind = [&](const std::string& along, const std::string& across) {
    return client.set("environment.wind.velocity=" + along + ", " + kept(wind.y) + ", " + across);
  };
  switch (setting.what) {
    case Quick::speed:
      launcher.set_speed(std::max(rounded("shot.speed", "m/s", Quantity::speed), 0.0));
      return client.has_changed_settings(), Status();
    case Quick::elevation:
      launcher.point(launcher.azimuth(),
                     launcher.is_zeroed() ? value * kDegree : rounded("shot.elevation", "deg", Quantity::angle));
      return {};
    case Quick::azimuth:
      return launcher.point(rounded("shot.azimuth", "deg", Quantity::angle), launcher.elevation()), Status();
    case Quick::mass: return client.set("shot.mass=" + in_file("shot.mass", setting.unit));
    case Quick::drag: {
      const DragModel own = launcher.types()[launcher.type()].shot.projectile.fidelity.drag;
      const DragModel on = own == DragModel::off ? Fidelity{}.drag : own;
      return client.set("shot.fidelity.drag=" + std::string(name(value > 0.5 ? on : DragModel::off)));
    }
    case Quick::wind_along: return set_wind(in_file("environment.wind.velocity", "m/s"), kept(wind.z));
    case Quick::wind_across: return set_wind(kept(wind.x), in_file("environment.wind.velocity", "m/s"));
  }
  return {};
}

std::span<const AccuracyRung> accuracy_rungs() { return kRungs; }

Accuracy accuracy_of(const Fidelity& fidelity) {
  Accuracy best;
  int most = -1;
  for (std::size_t i = 0; i < std::size(kRungs); ++i) {
    const std::optional<Fidelity> preset = fidelity_preset(kRungs[i].preset);
    PHYSIM_ASSERT(preset.has_value());
    if (*preset == fidelity) return {i, true};
    const int same = (preset->motion == fidelity.motion) + (preset->gravity == fidelity.gravity) +
                     2 * (preset->drag == fidelity.drag) + (preset->air == fidelity.air) +
                     (preset->wind == fidelity.wind) + 2 * is_meant_by(preset->rotation, fidelity.rotation) +
                     (preset->earth == fidelity.earth) + (preset->integrator == fidelity.integrator) +
                     (preset->interpolation == fidelity.interpolation);
    if (same > most) most = same, best.rung = i;
  }
  return best;
}

Status set_accuracy(Client& client, std::size_t rung) {
  PHYSIM_ASSERT(rung < std::size(kRungs));
  return client.set("shot.fidelity.preset=" + std::string(kRungs[rung].preset));
}

}  // namespace physim::client
