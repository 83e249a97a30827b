// What the batch kernels are given and what they give back: plain data, the same for every instruction set.
#pragma once

#include <cstddef>

#include "flight/judge.hpp"

namespace physim {

/// How a shot ended, before spin drift is added.
struct RawEnd {
  Outcome outcome;
  double time;
  State<double> state;
  double steps;
  double tries;
  Turn<double> turn;  // of rungs that turn
};

struct RawEvent {
  std::size_t shot;
  int index;  // in the watch list
  bool rising;
  double time;
  State<double> state;
};

/// Shots to fly. Events go through a function, so that kernels hold no container code.
template <class S>
struct BatchJob {
  const Course<S>* course;
  const double* own_numbers;    // the first ones of each shot's Body, which the kernel rounds as it takes them in
  unsigned own_count;           // so many of each shot
  const Body<double>* common;   // has the others
  const Rotor<double>* rotors;  // of rungs that turn
  std::size_t count;
  RawEnd* ends;
  void (*emit)(void* sink, const RawEvent& event);
  void* sink;
};

}  // namespace physim
