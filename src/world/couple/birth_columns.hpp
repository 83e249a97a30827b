// Births of one emitter, several side by side: each is drawn, placed, checked and flown as one alone would be, with the
// same bits, but all of them at a time.
#pragma once

#include <array>
#include <cstdint>
#include <tuple>

#include "world/core/emitters.hpp"
#include "world/couple/emitter_pose.hpp"
#include "world/step/part_flights.hpp"

namespace physim {

/// What is known of the births of an emitter before they are drawn.
struct BirthPlan {
  const Emission* emission = nullptr;
  std::uint32_t emitter = 0;  // index
  std::uint32_t kind = 0;     // index
  std::uint32_t flags = 0;    // of the slots
  std::uint32_t pool = 0;
  std::uint16_t cohort = 0;
  const Body<double>* body = nullptr;  // of the kind's own rung
  bool float32 = false;
  const FlightLaw* law = nullptr;  // that acts on them; it reads no masses and no gravity, and adds no velocity
};

struct BirthColumns {
  static constexpr std::size_t kLanes = FlownParts<float>::kLanes;
  template <class T>
  using Column = std::array<T, kLanes>;

  // ------------------------------------------------------------------------------------------- given
  std::size_t count = 0;
  std::size_t next = 0;            // the first one that is not yet in the world
  Column<std::uint64_t> number;    // as Birth has it
  Column<double> own_time, phase;  // as Birth has it [s]
  Column<std::uint32_t> of_moment, moment;
  Column<double> time;  // of the world [s]
  Column<Pose> pose;    // of the emitter; the first holds for all where they have one
  bool one_pose = true;
  double inherited = 0;  // part of the emitter's velocity

  // ------------------------------------------------------------------------------------------- what follows
  std::uint32_t plain = 0;  // a bit for each that may be added side by side: nothing happens to it
  Column<double> dies;      // [s]
  Column<double> age;       // at the end of the step [s]
  std::tuple<FlownParts<float>, FlownParts<double>> flights;  // one of them is in use

  [[nodiscard]] bool is_over() const { return next >= count; }
  void begin() { count = next = 0, plain = 0; }
};

/// Draws them, places them, and flies those to the end of the step to whom nothing happens before.
void prepare_births(const BirthPlan& plan, const SettleContext& context, double end, PartFlights& known,
                    BirthColumns& births);

}  // namespace physim
