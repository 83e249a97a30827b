// Launches and weather of columns, computed in the lanes that fly them: what preparing shots one by one gives
// elsewhere.
#pragma once

#include "flight/batch_job.hpp"
#include "model/sight.hpp"

PHYSIM_ISA_BEGIN

/// A column's numbers of the shots from `first` on; lanes without a shot repeat the last one.
template <class W>
PHYSIM_INLINE W take_column(const NumberColumn& column, std::size_t first, int filled) {
  if (column.of_shots == nullptr) return W(column.common);
  const double* from = column.of_shots + first;
  if constexpr (kLanes<W> == 1) {
    return *from;
  } else {
    if (filled == kLanes<W>) return W::load(from);
    double padded[kLanes<W>];
    for (int lane = 0; lane < kLanes<W>; ++lane) padded[lane] = from[lane < filled ? lane : filled - 1];
    return W::load(padded);
  }
}

/// put_launch() (prepare/launch.hpp) for a pack of launches without rail and spin.
template <class R>
void put_launches(const LaunchSource& from, std::size_t first, int filled, Body<R>& into) {
  using W = Cast<double, R>;
  using S = ScalarOf<R>;
  const auto take = [&](const NumberColumn& column) { return take_column<W>(column, first, filled); };
  const SightAxes<W> axes(sincos_of(take(from.azimuth)), sincos_of(W(from.look_angle)), sincos_of(W(from.cant)));
  const Vec3<W> v = axes.bore(sincos_of(take(from.elevation) - W(from.look_angle))) * take(from.speed);
  into.launch.x = {cast<S>(take(from.x)), cast<S>(take(from.y)), cast<S>(take(from.z))};
  cast_numbers(v, into.launch.v);
  cast_numbers(axes.right, into.plane);
  cast_numbers(axes.forward, into.sight);
  if (from.half_areas) into.half_area_per_mass = cast<S>(take({from.half_areas, 0}));
}

/// What prepare_air_numbers() (model/standard_atmosphere.hpp) gives, for a pack of shots with air of their own.
template <class W>
PHYSIM_NOINLINE void put_air(const WeatherSource& from, std::size_t first, int filled, AirNumbers<W>& air) {
  const auto take = [&](const NumberColumn& column) { return take_column<W>(column, first, filled); };
  if (!from.has_station || from.place.model != AirModel::isa) {
    const double* no_station = numbers(*from.no_station);
    for (unsigned i = 0; i < kNumbers<AirNumbers>; ++i) numbers(air)[i] = W(no_station[i]);
  }
  if (from.has_station)
    put_air(from.place, Readings<W>{take(from.temperature), take(from.pressure), take(from.humidity)}, air);
  if (from.has_density) air.density = take(from.density);
  if (from.has_sound_speed) air.per_sound_speed = W(from.per_sound_speed);
}

template <class R, class S>
void put_weather(const WeatherSource& from, const Conditions<S>& c, std::size_t first, int filled, Body<R>& into) {
  using W = Cast<double, R>;
  const auto wind = [&](const NumberColumn& column, double beside) {
    return cast<S>(take_column<W>(column, first, filled) + W(beside));
  };
  const Vec3d& beside = from.wind_less_column;
  if (c.has_own_wind)
    into.wind = {wind(from.wind_x, beside.x), wind(from.wind_y, beside.y), wind(from.wind_z, beside.z)};
  if (!c.has_own_air) return;
  if constexpr (std::is_same_v<W, R>) {
    put_air(from, first, filled, into.air);
  } else {
    AirNumbers<W> air;
    put_air(from, first, filled, air);
    constexpr unsigned kLow = kBodyNumber.air.low_density[0] - kBodyNumber.air.density;
    constexpr unsigned kLayers = kBodyNumber.air.layer[0].lapse - kBodyNumber.air.density;
    NumberRuns wanted;  // what is not stays what the batch has in its place: no numbers
    from.place.low_alone ? wanted.add(kLow, kLayers - kLow) : wanted.add(0, kNumbers<AirNumbers>);
    cast_numbers(air, into.air, wanted);
  }
}

PHYSIM_ISA_END
