// Emission: an emitter's definition, prepared: how each of its particles starts and looks. Pure functions of the
// definition, the seed and the particle; nothing here knows a world or a frame.
#pragma once

#include <cstdint>
#include <memory>

#include "physim/emitter.hpp"
#include "physim/result.hpp"

namespace physim {

/// The most births of one emitter, or of all sub-emitters, in a step of a world: more are cut.
inline constexpr std::uint32_t kMostBirthsInStep = 1u << 20;
/// The most births of a past, most of which need no flight.
inline constexpr std::uint32_t kMostBirthsOfPast = 1u << 26;
/// Steps that are flown at most of a past, of all of its particles together.
inline constexpr std::uint32_t kMostStepsOfPast = 1u << 24;

/// Which particle of an emitter, and when it is emitted.
struct Birth {
  std::uint64_t number = 0;     // among the particles of its emitter, from 0
  double time = 0;              // since the emitter began to play, by its own clock [s]
  double phase = 0;             // of the cycle, 0..1
  std::uint32_t of_moment = 0;  // its place among those of its moment
  std::uint32_t moment = 1;     // how many those are
  bool is_round = false;        // of the gun
  std::uint64_t round = 0;      // its number then, from 0
};

/// How a particle starts, in the frame of its emitter.
struct Newborn {
  Vec3d place{};             // [m]
  Vec3d direction{1, 0, 0};  // of length one
  double speed = 0;          // below 0: backwards [m/s]
  double lifetime = 0;       // [s]
  double gravity = 1;        // times that of its kind
  bool tracer = false;       // of GunDef::tracer's kind
};

/// How a particle is shown.
struct Look {
  Vec3d size{};      // [m]
  Vec3d rotation{};  // [rad]
  std::uint32_t colour = 0xffffffff;
};

class FlightLaw;
class Rain;
struct NewbornPack;

class Emission {
 public:
  /// `def` has passed check(); all that it draws follows from `seed`.
  Emission(const EmitterDef& def, std::uint64_t seed);
  ~Emission();
  Emission(const Emission&) = delete;
  Emission& operator=(const Emission&) = delete;

  [[nodiscard]] const EmitterDef& def() const;
  [[nodiscard]] std::uint64_t seed() const;

  [[nodiscard]] const Rain& rain() const;

  [[nodiscard]] Newborn newborn(const Birth& birth) const;
  /// Several at a time; their gravity is left unchanged.
  void newborns(NewbornPack& pack) const;
  /// Whether each feels the gravity of its kind.
  [[nodiscard]] bool leaves_gravity() const;
  /// The look of particle `number` with birth at `phase` of the cycle. `age` within 0..lifetime [s]; `speed` [m/s].
  [[nodiscard]] Look look(std::uint64_t number, double phase, double lifetime, double age, double speed) const;
  /// What acts on its particles in flight.
  [[nodiscard]] const FlightLaw& flight() const;
  /// How many a sub-emitter fires for a particle's event, the nth of it; 0 where its probability says no.
  [[nodiscard]] std::uint32_t fired_by(std::size_t sub, std::uint64_t number, std::uint64_t nth) const;

 private:
  friend class Timeline;
  friend class Looks;
  struct Parts;
  std::unique_ptr<const Parts> parts_;
};

/// Colours multiplied as parts of 255, rounded to the nearest.
[[nodiscard]] std::uint32_t times(std::uint32_t a, std::uint32_t b);

/// Refuses what makes no sense; places begin with "emitter.". Kinds, emitters and projectiles that it names are the
/// world's to check.
[[nodiscard]] Status check(const EmitterDef& def);

}  // namespace physim
