// The wind, and conditions put together from what the models prepare.
#include "prepare/conditions.hpp"

#include "model/earth.hpp"
#include "model/ladder.hpp"
#include "model/standard_atmosphere.hpp"

namespace physim {
namespace {

WindField<double> prepare_wind(const Wind& wind, WindModel model) {
  WindField<double> field{};
  field.points = 1;
  field.by_range = wind.by == WindAxis::range;
  field.stepped = wind.interpolation == WindInterpolation::step;
  switch (wind.profile.empty() ? lower_of(model, WindModel::constant) : model) {
    case WindModel::off: return field;
    case WindModel::constant:
      // A low rung has one wind: the profile's first point stands for it where no other is given.
      field.velocity[0] = wind.velocity;
      if (!wind.profile.empty() && wind.velocity == Vec3d{}) field.velocity[0] = wind.profile.front().velocity;
      return field;
    case WindModel::profile: break;
  }
  field.points = static_cast<int>(wind.profile.size());
  for (int i = 0; i < field.points; ++i) {
    const WindPoint& p = wind.profile[static_cast<std::size_t>(i)];
    field.at[i] = p.at;
    field.velocity[i] = p.velocity;
    if (i > 0) field.slope[i - 1] = (p.velocity - Vec3d(field.velocity[i - 1])) * (1 / (p.at - field.at[i - 1]));
  }
  return field;
}

}  // namespace

Conditions<double> prepare_conditions(const Environment& environment, const Fidelity& granted) {
  Conditions<double> c{};
  c.fidelity = granted;
  prepare_earth(environment, granted, c);
  c.air = prepare_air(environment, granted.air);
  c.wind = prepare_wind(environment.wind, granted.wind);
  return c;
}

Conditions<float> to_float(const Conditions<double>& c) {
  Conditions<float> f{};
  f.fidelity = c.fidelity;
  f.gravity = static_cast<float>(c.gravity);
  f.radius = static_cast<float>(c.radius);
  f.altitude = static_cast<float>(c.altitude);
  f.omega = vec_cast<float>(c.omega);
  f.globe = to_float(c.globe);
  const auto copy = [](const double* from, float* to, int count) {
    for (int i = 0; i < count; ++i) to[i] = static_cast<float>(from[i]);
  };
  f.air.density = static_cast<float>(c.air.density);
  f.air.per_sound_speed = static_cast<float>(c.air.per_sound_speed);
  f.air.kelvin_per_sound = static_cast<float>(c.air.kelvin_per_sound);
  f.air.low_middle = static_cast<float>(c.air.low_middle);
  f.air.low_scale = static_cast<float>(c.air.low_scale);
  f.air.low_top = static_cast<float>(c.air.low_top);
  copy(c.air.low_density, f.air.low_density, kDensityTerms);
  copy(c.air.low_per_sound, f.air.low_per_sound, kPerSoundTerms);
  f.air.temperature = static_cast<float>(c.air.temperature);
  f.air.per_scale_height = static_cast<float>(c.air.per_scale_height);
  f.air.layers = c.air.layers;
  copy(c.air.base, f.air.base, kAirLayers);
  copy(c.air.lapse, f.air.lapse, kAirLayers);
  copy(c.air.power, f.air.power, kAirLayers);
  copy(c.air.decay, f.air.decay, kAirLayers);
  copy(c.air.base_density, f.air.base_density, kAirLayers);
  copy(c.air.base_per_sound, f.air.base_per_sound, kAirLayers);
  f.wind.points = c.wind.points;
  f.wind.by_range = c.wind.by_range;
  f.wind.stepped = c.wind.stepped;
  copy(c.wind.at, f.wind.at, kMaxWindPoints);
  for (int i = 0; i < kMaxWindPoints; ++i) {
    f.wind.velocity[i] = vec_cast<float>(Vec3d(c.wind.velocity[i]));
    f.wind.slope[i] = vec_cast<float>(Vec3d(c.wind.slope[i]));
  }
  f.searched_curves = c.searched_curves;
  f.motor_pieces = c.motor_pieces;
  f.magnus_grids = c.magnus_grids;
  static_cast<Features&>(f) = c;
  return f;
}

}  // namespace physim
