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
          .precision = Precision::float32};
}

Fidelity Fidelity::game() {
  return {.integrator = Integrator::semi_implicit_euler,
          .drag = DragModel::linear_quadratic,
          .air = AirModel::constant,
          .wind = WindModel::constant,
          .precision = Precision::float32};
}

Fidelity Fidelity::sport_ball() {
  return {.integrator = Integrator::rk4, .air = AirModel::constant, .wind = WindModel::constant};
}

Fidelity Fidelity::small_arms() { return {.rotation = RotationModel::spin_drift}; }

Fidelity Fidelity::artillery() {
  Fidelity fidelity = small_arms();
  fidelity.gravity = GravityModel::inverse_square;
  fidelity.earth = EarthModel::flat_coriolis;
  return fidelity;
}

Fidelity Fidelity::simulation() {
  Fidelity fidelity = artillery();
  fidelity.interpolation = Interpolation::cubic;
  return fidelity;
}

Fidelity Fidelity::reference() {
  Fidelity fidelity = simulation();
  fidelity.integrator = Integrator::dop853;
  return fidelity;
}

Fidelity Fidelity::classic() {
  return {.motion = Motion::velocity,
          .integrator = Integrator::classic,
          .drag = DragModel::damping,
          .air = AirModel::vacuum,
          .wind = WindModel::off,
          .precision = Precision::float32};
}

namespace {

constexpr std::array<std::string_view, 8> kPresetNames = {"arcade",    "game",       "sport_ball", "small_arms",
                                                          "artillery", "simulation", "reference",  "classic"};
using Preset = Fidelity (*)();
constexpr std::array<Preset, kPresetNames.size()> kPresets = {
    Fidelity::arcade,    Fidelity::game,       Fidelity::sport_ball, Fidelity::small_arms,
    Fidelity::artillery, Fidelity::simulation, Fidelity::reference,  Fidelity::classic};

}  // namespace

std::optional<Fidelity> fidelity_preset(std::string_view text) {
  for (std::size_t i = 0; i < kPresetNames.size(); ++i)
    if (kPresetNames[i] == text) return kPresets[i]();
  return std::nullopt;
}

std::span<const std::string_view> fidelity_presets() { return kPresetNames; }

}  // namespace physim
