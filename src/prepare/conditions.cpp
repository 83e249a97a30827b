// The wind, and conditions put together from what the models prepare.
#include "prepare/conditions.hpp"

#include <algorithm>
#include <memory>
#include <span>
#include <vector>

#include "base/ieee_mode.hpp"
#include "base/text.hpp"
#include "model/earth.hpp"
#include "model/ladder.hpp"
#include "model/standard_atmosphere.hpp"
#include "prepare/check.hpp"

namespace physim {
namespace {

/// Into a field that is all zero.
void put_wind(const Wind& wind, WindModel model, WindField<double>& field, ProfileTables& tables) {
  if (wind.field && model == WindModel::profile) return;  // its function is asked
  field.by_range = wind.by == WindAxis::range;
  field.stepped = wind.interpolation == WindInterpolation::step;
  switch (wind.profile.empty() ? lower_of(model, WindModel::constant) : model) {
    case WindModel::off: return;
    case WindModel::constant:
      // A low rung has one wind: the profile's first point stands for it where no other is given.
      field.velocity = wind.velocity;
      if (!wind.profile.empty() && wind.velocity == Vec3d{}) field.velocity = wind.profile.front().velocity;
      return;
    case WindModel::profile: break;
  }
  field.points = static_cast<int>(wind.profile.size());
  field.velocity = wind.profile.front().velocity;
  tables.put_wind(wind.profile);
}

/// A function that is called with times later by `delay` [s].
template <class Batch>
FieldFunction<Batch> later_by(double delay, const FieldFunction<Batch>& function) {
  if (!function || delay == 0) return function;
  return [function, delay](const Batch& asked) {
    std::vector<double> times(asked.time.begin(), asked.time.end());
    for (double& time : times) time = delay + time;
    Batch later = asked;
    later.time = times;
    (*function.get())(later);
  };
}

}  // namespace

Conditions<double> prepare_conditions(const Environment& environment, const Fidelity& granted, ProfileTables& tables) {
  Conditions<double> c{};
  c.fidelity = granted;
  prepare_earth(environment, granted, c);
  const std::vector<AirLevel> levels = air_levels(environment.atmosphere);
  put_air(environment, granted.air, levels, c.air);
  c.has_air_profile = granted.air == AirModel::isa && !levels.empty();
  if (c.has_air_profile) tables.put_air(levels);
  put_wind(environment.wind, granted.wind, c.wind, tables);
  c.wind_function = environment.wind.field.get();
  c.force_function = environment.force.get();
  c.has_wind_function = c.wind_function != nullptr && granted.wind == WindModel::profile;
  c.has_force_function = c.force_function != nullptr && granted.motion == Motion::force;
  tables.point(c);
  return c;
}

Conditions<double> prepare_conditions(const Environment& environment, const Fidelity& granted) {
  ProfileTables none;
  const Conditions<double> c = prepare_conditions(environment, granted, none);
  PHYSIM_ASSERT(c.wind.points == 0 && !c.has_air_profile);
  return c;
}

Environment as_launched_at(double time, const Environment& environment) {
  Environment from_launch = environment;
  from_launch.wind.field = later_by(time, environment.wind.field);
  from_launch.force = later_by(time, environment.force);
  return from_launch;
}

Result<AirSample> air_at(const Environment& environment, double altitude) {
  const IeeeMode mode;
  if (const Status status = check(environment); !status) return status.error();
  if (!(altitude >= kLowestAltitude && altitude <= kHighestAltitude))
    return Error{"altitude " + short_text(altitude) + " m lies outside the standard atmosphere", "altitude",
                 "give a height from -5000 m to 86000 m"};
  return air_sample(environment, altitude);
}

Result<AirSample> air_at_origin(const Environment& environment) {
  return air_at(environment, std::clamp(environment.altitude, kLowestAltitude, kHighestAltitude));
}

Vec3d own_wind_less_column(const Weather& weather, const Wind& common, WindModel granted) {
  constexpr Vec3d nothing{-0.0, -0.0, -0.0};
  if (!weather.moves_profile || common.profile.empty()) return nothing;
  if (granted == WindModel::profile) return -common.velocity;
  return common.velocity == Vec3d{} ? common.profile.front().velocity : nothing;
}

Conditions<float> to_float(const Conditions<double>& c, const ProfileTables& tables) {
  Conditions<float> f{};
  static_cast<Features&>(f) = c;
  static_cast<FunctionPointers&>(f) = c;
  cast_members(static_cast<const EnvironmentNumbers<double>&>(c), static_cast<EnvironmentNumbers<float>&>(f));
  f.globe = to_float(c.globe);
  tables.point(f);
  return f;
}

}  // namespace physim
