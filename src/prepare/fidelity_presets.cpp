// Presets: rungs of the ladder of fidelity that go well together.
#include <array>

#include "physim/fidelity.hpp"
#include "physim/names.hpp"

namespace physim {

Fidelity Fidelity::arcade() {
  return {.motion = Motion::closed_form,
          .integrator = Integrator::semi_implicit_euler,  // not used by a closed form
          .gravity = GravityModel::constant,
          .drag = DragModel::off,
          .air = AirModel::vacuum,
          .wind = WindModel::off,
          .rotation = RotationModel::none,
          .precision = Precision::float32};
}

Fidelity Fidelity::game() {
  return {.integrator = Integrator::automatic,
          .drag = DragModel::linear_quadratic,
          .air = AirModel::constant,
          .wind = WindModel::constant,
          .rotation = RotationModel::automatic_point,
          .precision = Precision::float32,
          .tolerance = 1e-4};
}

Fidelity Fidelity::constant_air() {
  Fidelity fidelity = small_arms();
  fidelity.air = AirModel::constant;
  fidelity.wind = WindModel::constant;
  fidelity.tolerance = 1e-6;
  return fidelity;
}

Fidelity Fidelity::small_arms() { return {}; }

Fidelity Fidelity::artillery() {
  Fidelity fidelity = small_arms();
  fidelity.gravity = GravityModel::inverse_square;
  fidelity.earth = EarthModel::flat_coriolis;
  fidelity.interpolation = Interpolation::cubic;
  return fidelity;
}

Fidelity Fidelity::simulation() {
  Fidelity fidelity = artillery();
  fidelity.rotation = RotationModel::automatic;
  fidelity.tolerance = 2e-9;
  return fidelity;
}

Fidelity Fidelity::reference() {
  Fidelity fidelity = simulation();
  fidelity.integrator = Integrator::dop853;
  fidelity.tolerance = 1e-15;
  return fidelity;
}

Fidelity Fidelity::classic() {
  return {.motion = Motion::velocity,
          .integrator = Integrator::classic,
          .drag = DragModel::damping,
          .air = AirModel::vacuum,
          .wind = WindModel::off,
          .rotation = RotationModel::none,
          .precision = Precision::float32};
}

namespace {

constexpr std::array<std::string_view, 8> kPresetNames = {"arcade",    "game",       "constant_air", "small_arms",
                                                          "artillery", "simulation", "reference",    "classic"};
using Preset = Fidelity (*)();
constexpr std::array<Preset, kPresetNames.size()> kPresets = {
    Fidelity::arcade,    Fidelity::game,       Fidelity::constant_air, Fidelity::small_arms,
    Fidelity::artillery, Fidelity::simulation, Fidelity::reference,    Fidelity::classic};

}  // namespace

std::optional<Fidelity> fidelity_preset(std::string_view text) {
  for (std::size_t i = 0; i < kPresetNames.size(); ++i)
    if (kPresetNames[i] == text) return kPresets[i]();
  return std::nullopt;
}

std::span<const std::string_view> fidelity_presets() { return kPresetNames; }

}  // namespace physim
