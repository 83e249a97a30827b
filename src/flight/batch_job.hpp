// What the batch kernels are given and what they give back: plain data, the same for every instruction set.
#pragma once

#include <cstddef>
#include <cstdint>

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

/// Launches that lanes compute themselves: columns from the first shot on, null where all have the number beside it.
struct LaunchSource {
  struct Column {
    const double* of_shots;
    double common;
  };
  Column x, y, z;           // [m]
  Column speed;             // [m/s]
  Column elevation;         // above the horizon [rad]
  Column azimuth;           // [rad]
  double look_angle, cant;  // [rad]
};

/// Shots to fly. Events go through a function, so that kernels hold no container code.
template <class S>
struct BatchJob {
  const Course<S>* course;
  const LaunchSource* launches;  // null: own_numbers has them
  const double* own_numbers;   // of each shot's Body, from its first one on; the kernel rounds them as it takes them in
  unsigned own_stride;         // from shot to shot
  NumberRuns own;              // those that lanes hold
  const Body<double>* common;  // has the others
  const Rotor<double>* rotors;  // where the rotation is flown
  const std::uint32_t* places;  // of the shots in the results; null: in their order
  std::size_t count;
  ShotResult* results;                              // how each ended, without spin drift
  Turn<double>* turns;                              // how each turned at its end; null where the rotation is not flown
  void (*emit)(void* sink, const RawEvent& event);  // null: nobody wants events
  void* sink;
};

}  // namespace physim
