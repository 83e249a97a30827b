#include "flight/plain_shots.hpp"

#include <algorithm>
#include <cmath>

#include "base/assert.hpp"
#include "math/pack.hpp"
#include "model/standard_atmosphere.hpp"
#include "prepare/conditions.hpp"
#include "prepare/projectile.hpp"

namespace physim {
namespace {

using Some = Pack<double, 8>;

/// Whether `holds` is true of all shots: it is asked for packs of them, and for each of the last ones.
template <class F>
bool holds_of_all(std::size_t count, const F& holds) {
  bool holds_so_far = true;
  std::size_t i = 0;
  for (; holds_so_far && i + kLanes<Some> <= count; i += kLanes<Some>)
    holds_so_far = all(holds(i, std::type_identity<Some>()));
  for (; holds_so_far && i < count; ++i) holds_so_far = holds(i, std::type_identity<double>());
  return holds_so_far;
}

template <class R>
R take(const NumberColumn& column, std::size_t i) {
  return column.of_shots == nullptr ? R(column.common) : load_lanes<R>(column.of_shots + i);
}

}  // namespace

PlainShots::PlainShots(const BatchTask& task, const Fidelity& granted, std::size_t first, std::size_t count)
    : task_(task), first_(first), count_(count) {
  PHYSIM_ASSERT(task.shots.columns != nullptr && first + count <= task.shots.size());
  const LaunchColumns& from = *task.shots.columns;
  const Launch& common = from.common;
  launches_ = {column(from.x, common.position.x),
               column(from.y, common.position.y),
               column(from.z, common.position.z),
               column(from.speed, common.speed),
               column(from.elevation, common.elevation),
               column(from.azimuth, common.azimuth),
               common.sight.look_angle,
               common.sight.cant,
               nullptr,
               nullptr};
  if (!task.weather.empty()) put_weather(granted);
  if (task.shots.has_own_drag() && task.shots.one_projectile->drag.bands.empty()) put_drag();
}

void PlainShots::put_drag() {
  PHYSIM_ASSERT(task_.shots.has_own_drag() && half_areas_.empty());
  const LaunchColumns& from = *task_.shots.columns;
  const auto part = [&](std::span<const double> of_all) {
    return of_all.empty() ? of_all : of_all.subspan(first_, count_);
  };
  half_areas_.resize(count_);
  put_half_areas(*task_.shots.one_projectile, part(from.ballistic_coefficient), part(from.form_factor), half_areas_);
  launches_.half_areas = half_areas_.data();
}

void PlainShots::put_weather(const Fidelity& granted) {
  const Weather& own = task_.weather;
  const Environment& common = task_.environment;
  const Atmosphere& air = common.atmosphere;
  const Readings<double> station = station_air(common);
  const bool is_simple = granted.air == AirModel::constant || granted.air == AirModel::exponential;
  if (own.has_air()) no_station_ = prepare_air_numbers(common, granted.air);
  weather_ = {.wind_x = column(own.wind_x, common.wind.velocity.x),
              .wind_y = column(own.wind_y, common.wind.velocity.y),
              .wind_z = column(own.wind_z, common.wind.velocity.z),
              .wind_less_column = own_wind_less_column(own, common.wind, granted.wind),
              .temperature = column(own.temperature, station.temperature),
              .pressure = column(own.pressure, station.pressure),
              .humidity = column(own.humidity, station.humidity),
              .density = column(own.density, air.density.value_or(0)),
              .has_station = own.has_station(),
              .has_density = is_simple && (air.density || !own.density.empty()),
              .has_sound_speed = granted.air != AirModel::isa && air.sound_speed,
              .per_sound_speed = 1 / air.sound_speed.value_or(1),
              .place = station_place(common, granted.air),
              .no_station = &no_station_};
  launches_.weather = &weather_;
}

NumberColumn PlainShots::column(std::span<const double> numbers, double common) const {
  return {numbers.empty() ? nullptr : numbers.data() + first_, common};
}

bool PlainShots::within(std::span<const double> numbers, double low, double high) const {
  if (numbers.empty()) return true;
  return holds_of_all(count_, [&]<class R>(std::size_t i, std::type_identity<R>) {
    const R x = take<R>({numbers.data() + first_, 0}, i);
    return (x >= R(low)) & (x <= R(high));
  });
}

bool PlainShots::are_all() const { return plain_launches() && plain_weather() && plain_drag(); }

bool PlainShots::plain_launches() const {
  constexpr double kFar = 1e15, kFast = 1e15, kTurn = 3.14;
  // Lower ones are looked at one by one: they may end where they begin.
  const double domain = kLowestAltitude - task_.environment.altitude + 1;
  const double above = std::max(domain, std::nextafter(task_.until.ground.value_or(domain), kInfinity));
  const LaunchColumns& from = *task_.shots.columns;
  if (from.y.empty() && from.common.position.y < above) return false;
  return within(from.x, -kFar, kFar) && within(from.y, above, kFar) && within(from.z, -kFar, kFar) &&
         within(from.speed, 0, kFast) && within(from.elevation, -kTurn, kTurn) && within(from.azimuth, -kFast, kFast);
}

bool PlainShots::seem_to_stay_low(const Conditions<double>& c) const {
  if (launches_.weather == nullptr || !weather_.has_station || weather_.place.model != AirModel::isa) return false;
  const double room = c.air.base[1] - c.altitude, per_square = 1 / (2 * c.gravity);
  return holds_of_all(count_, [&]<class R>(std::size_t i, std::type_identity<R>) {
    const R upwards = take<R>(launches_.speed, i) * min(abs(take<R>(launches_.elevation, i)), R(1.0));  // or more
    return take<R>(launches_.y, i) + upwards * upwards * R(per_square) < R(room);
  });
}

bool PlainShots::plain_drag() const {
  constexpr double kLight = 1e-6, kHeavy = 1e12, kThin = 1e-6, kThick = 1e6, kLargest = 1e30;
  const LaunchColumns& from = *task_.shots.columns;
  return within(from.ballistic_coefficient, kLight, kHeavy) && within(from.form_factor, kThin, kThick) &&
         holds_of_all(half_areas_.size(), [&]<class R>(std::size_t i, std::type_identity<R>) {
           return take<R>({half_areas_.data(), 0}, i) <= R(kLargest);
         });
}

/// Days on Earth. Among them no vapour is more than the air can hold.
bool PlainShots::plain_weather() const {
  const Weather& own = task_.weather;
  if (own.empty()) return true;
  constexpr double kStorm = 1e3, kThin = 1e-30, kThick = 1e30;
  const bool may_be_moist = !own.humidity.empty() || weather_.humidity.common > 0;
  const double coldest = 200, warmest = 320, lowest = may_be_moist ? 4e4 : 100, highest = 1.2e5;
  const auto station = [&](std::span<const double> numbers, double common, double low, double high) {
    return numbers.empty() ? !own.has_station() || (common >= low && common <= high) : within(numbers, low, high);
  };
  return within(own.wind_x, -kStorm, kStorm) && within(own.wind_y, -kStorm, kStorm) &&
         within(own.wind_z, -kStorm, kStorm) && within(own.density, kThin, kThick) &&
         station(own.temperature, weather_.temperature.common, coldest, warmest) &&
         station(own.pressure, weather_.pressure.common, lowest, highest) && within(own.humidity, 0, 1);
}

}  // namespace physim
