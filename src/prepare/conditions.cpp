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

void put_profile(std::span<const WindPoint> points, WindProfile<double>& profile) {
  PHYSIM_ASSERT(points.size() <= std::size_t(kMaxWindPoints));
  for (int i = 0; i < static_cast<int>(points.size()); ++i) {
    const WindPoint& p = points[static_cast<std::size_t>(i)];
    PHYSIM_ASSERT(i == 0 || p.at > profile.at[i - 1]);
    profile.at[i] = p.at;
    profile.velocity[i] = p.velocity;
    profile.slope[i] = Vec3d{}, profile.per_length[i] = 0;
    if (i == 0) continue;
    profile.per_length[i - 1] = 1 / (p.at - profile.at[i - 1]);
    profile.slope[i - 1] = (p.velocity - Vec3d(profile.velocity[i - 1])) * profile.per_length[i - 1];
  }
}

/// Into a field that is all zero.
void put_wind(const Wind& wind, WindModel model, WindField<double>& field, WindProfile<double>& profile) {
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
  put_profile(wind.profile, profile);
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

void put_conditions(const Environment& environment, const Fidelity& granted, Conditions<double>& c) {
  std::construct_at(static_cast<ConditionsWithoutProfile<double>*>(&c));  // where it is: it is large
  c.fidelity = granted;
  prepare_earth(environment, granted, c);
  put_air(environment, granted.air, c.air);
  put_wind(environment.wind, granted.wind, c.wind, *c.profile);
  c.wind_function = environment.wind.field.get();
  c.force_function = environment.force.get();
  c.has_wind_function = c.wind_function != nullptr && granted.wind == WindModel::profile;
  c.has_force_function = c.force_function != nullptr && granted.motion == Motion::force;
}

Conditions<double> prepare_conditions(const Environment& environment, const Fidelity& granted) {
  Conditions<double> c;
  put_conditions(environment, granted, c);
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

Conditions<float> to_float(const Conditions<double>& c) {
  Conditions<float> f{};
  static_cast<Features&>(f) = c;
  static_cast<FunctionPointers&>(f) = c;
  cast_members(static_cast<const EnvironmentNumbers<double>&>(c), static_cast<EnvironmentNumbers<float>&>(f));
  f.globe = to_float(c.globe);
  for (int i = 0; i < c.wind.points; ++i) {
    cast_members(c.profile->at[i], f.profile->at[i]);
    cast_members(c.profile->velocity[i], f.profile->velocity[i]);
    cast_members(c.profile->slope[i], f.profile->slope[i]);
    cast_members(c.profile->per_length[i], f.profile->per_length[i]);
  }
  return f;
}

}  // namespace physim
