// What an emission has prepared of its definition.
#pragma once

#include <vector>

#include "emit/emission.hpp"
#include "emit/flight_law.hpp"
#include "emit/gun.hpp"
#include "emit/moments.hpp"
#include "emit/rain.hpp"

namespace physim {

/// How a particle starts and is shown.
struct EmitStart {
  explicit EmitStart(const EmitterDef& def);

  EmitNumber lifetime, speed, size, size_y, size_z, rotation, rotation_y, rotation_z, gravity;
  EmitColour colour;
};
struct EmitLife {
  explicit EmitLife(const EmitterDef& def);

  EmitNumber size, turn;
  EmitColour colour;
  EmitCurve size_by_speed;
  EmitGradient colour_by_speed;
};

/// When it fires.
struct EmitWhen {
  EmitWhen(const EmitterDef& def, std::uint64_t seed);

  EmitNumber delay;
  BirthRate rate;
  std::vector<BurstMoments> bursts;
};

struct Emission::Parts {
  Parts(const EmitterDef& of, std::uint64_t drawn_by);

  EmitterDef def;
  std::uint64_t seed;
  EmitWhen when;
  ShapeOutlets outlets;
  Gun gun;
  Rain rain;
  EmitStart start;
  EmitLife life;
  FlightLaw flight;
  std::vector<EmitNumber> sub_counts;
};

}  // namespace physim
