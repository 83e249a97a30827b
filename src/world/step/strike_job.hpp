// What the kernel for rows that strike the ground is given, and what it finds: plain data, the same for every
// instruction set.
#pragma once

#include <array>

#include "world/step/world_job.hpp"

namespace physim {

/// Rows of one cohort that a step left where they were, gathered side by side.
template <class S>
struct StrikeJob {
  static constexpr unsigned kRows = 32;
  using Column = std::array<double, kRows>;

  WorldJob<S> rows;  // its columns are those of the gathered rows
  unsigned count = 0;

  double dt;              // [s]
  double frame;           // by which a bounce is judged [s]
  double ground;          // its height [m]
  bool bounces;           // else what strikes it stays there
  double below, slowest;  // rules: lower or slower rows want more than a strike [m, m/s]
  Column restitution, friction;

  unsigned plain = 0;            // a bit for each that strikes once, and to which nothing else happens in the step
  Column passed;                 // when it does [s]
  std::array<Column, 3> at, go;  // its place, and its velocity after
};

}  // namespace physim
