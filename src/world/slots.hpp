// Slots: what a world keeps of each projectile that its models do not read, at a place that never moves.
#pragma once

#include <cstdint>

#include "physim/world_def.hpp"
#include "world/registry.hpp"

namespace physim {

/// Bits of Slot::flags.
enum SlotFlag : std::uint32_t {
  kAlive = 1u << 0,
  kAsleep = 1u << 1,
  kKinematic = 1u << 2,
  kInfiniteMass = 1u << 3,
  kPending = 1u << 4,
  kStuck = 1u << 5,  // landed where it stays
  kForced = 1u << 6,
  kScaled = 1u << 7,
  kFrozen = 1u << 8,
  kSleepless = 1u << 9,
  kTurning = 1u << 10,  // has an orientation of its own
  kRailed = 1u << 11,   // started on a rail
  kStill = kAsleep | kKinematic | kInfiniteMass | kPending | kStuck,
};
inline constexpr unsigned kStatusShift = 16;     // LifeStatus, 3 bits
inline constexpr unsigned kSmoothingShift = 20;  // Smoothing, 2 bits

struct Slot {
  std::uint32_t generation = 0;
  std::uint32_t row = 0;  // in its cohort; of a free slot: the next free one
  std::uint32_t kind = 0;
  std::uint32_t flags = 0;
  std::uint16_t cohort = 0;
  std::uint16_t rung = 0;

  [[nodiscard]] bool is(std::uint32_t flag) const { return (flags & flag) != 0; }
  void set(std::uint32_t flag, bool on) { flags = on ? flags | flag : flags & ~flag; }
  [[nodiscard]] LifeStatus status() const { return static_cast<LifeStatus>(flags >> kStatusShift & 7u); }
  void set_status(LifeStatus s) {
    flags = (flags & ~(7u << kStatusShift)) | static_cast<std::uint32_t>(s) << kStatusShift;
  }
  [[nodiscard]] Smoothing smoothing() const { return static_cast<Smoothing>(flags >> kSmoothingShift & 3u); }
  void set_smoothing(Smoothing s) {
    flags = (flags & ~(3u << kSmoothingShift)) | static_cast<std::uint32_t>(s) << kSmoothingShift;
  }
  [[nodiscard]] Variant variant() const {
    return {is(kForced), is(kStill), is(kScaled), is(kFrozen), is(kSleepless), is(kRailed)};
  }
};

/// How long a projectile has been at rest.
struct Rest {
  std::uint32_t step = 0;  // the last one in which it rested (low bits)
  float time = 0;          // [s]
};

/// 1 along the axes that are free, 0 along frozen ones.
[[nodiscard]] inline Vec3d free_axes(Axes frozen) {
  return {has(frozen, Axes::x) ? 0.0 : 1.0, has(frozen, Axes::y) ? 0.0 : 1.0, has(frozen, Axes::z) ? 0.0 : 1.0};
}

/// What few projectiles have of their own, others by their kind.
struct Own {
  double gravity_scale = 1;
  Axes frozen = Axes::none;
  Axes frozen_rotation = Axes::none;
};

/// Carried along for the user.
struct Tags {
  std::uint64_t user_data = 0;
  std::uint32_t layers = 1;
  std::uint32_t colour = 0xffffffff;
  std::string label;
};

}  // namespace physim
