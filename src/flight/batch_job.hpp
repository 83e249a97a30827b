// What the batch kernels are given and what they give back: plain data, the same for every instruction set.
#pragma once

#include <cstddef>
#include <cstdint>

#include "model/station.hpp"
#include "solve/judge.hpp"

namespace physim {

/// Without spin drift, as an event of a batch.
struct RawEvent {
  std::uint32_t shot;
  std::int16_t index;  // in the watch list
  bool rising;
  double time;
  State<double> state;
};

/// Numbers of shots, from the first one on; null: all have the number beside it.
struct NumberColumn {
  const double* of_shots;
  double common;
};

/// Weather that lanes compute themselves.
struct WeatherSource {
  NumberColumn wind_x, wind_y, wind_z;           // [m/s]
  Vec3d wind_less_column;                        // what the wind has beside these numbers [m/s]
  NumberColumn temperature, pressure, humidity;  // at the station [K], [Pa], [-]
  NumberColumn density;                          // at the origin, in the place of the station's [kg/m^3]
  bool has_station, has_density, has_sound_speed;
  double per_sound_speed;  // in the place of the station's [s/m]
  StationPlace place;
  const AirNumbers<double>* no_station;  // the air where no station measures
};

/// Launches that lanes compute themselves.
struct LaunchSource {
  NumberColumn x, y, z;          // [m]
  NumberColumn speed;            // [m/s]
  NumberColumn elevation;        // above the horizon [rad]
  NumberColumn azimuth;          // [rad]
  double look_angle, cant;       // [rad]
  const WeatherSource* weather;  // null: all have that of the environment
  const double* half_areas;      // over mass, of each shot [m^2/kg]; null: all have that of the projectile
};

/// Shots to fly. Events go through a function, so that kernels hold no container code.
template <class S>
struct BatchJob {
  const Course<S>* course;
  const LaunchSource* launches;  // null: own_numbers has them
  const double* own_numbers;   // of each shot's Body, from its first one on; the kernel rounds them as it takes them in
  unsigned own_stride;         // from shot to shot
  NumberRuns own;              // those that lanes hold
  NumberRuns judged;           // of these, those that judging a step reads
  const Body<double>* common;  // has the others
  const Rotor<double>* rotors;  // where the rotation is flown
  const std::uint32_t* places;  // of the shots in the results; null: in their order
  std::size_t count;
  ShotResult* results;                  // how each ended, without spin drift
  Turn<double>* turns;                  // how each turned at its end; null where the rotation is not flown
  RawEvent& (*next_event)(void* sink);  // room for one more, to be written where it stays; null: no events are wanted
  void* sink;
  /// Null: lanes hold all of the air of their shots. Else they hold the polynomials of its lowest layer, and all else
  /// of it is NaN; if a lane reads that, true is put here, and the job ends without results.
  bool* left_low_air;
};

}  // namespace physim
