// Live settings: what of a BodyDef can change for one projectile at any time, and which numbers of its Body follow.
#pragma once

#include <array>

#include "model/body.hpp"
#include "physim/body.hpp"

namespace physim {

/// Live settings that models read. Few projectiles have others than their cohort.
struct Own {
  double gravity_scale = 1;
  Axes frozen = Axes::none;
  Axes frozen_rotation = Axes::none;

  bool operator==(const Own&) const = default;
};

/// What a body starts with.
[[nodiscard]] inline Own own_of(const BodyDef& body) {
  return {body.use_gravity ? body.gravity_scale : 0.0, body.frozen, body.frozen_rotation};
}
/// Into a body, the other way round.
inline void put_own(const Own& own, BodyDef& body) {
  body.use_gravity = own.gravity_scale != 0;
  if (body.use_gravity) body.gravity_scale = own.gravity_scale;
  body.frozen = own.frozen;
  body.frozen_rotation = own.frozen_rotation;
}
/// Members that are live and no model reads.
inline void copy_switches(const BodyDef& from, BodyDef& to) {
  to.kinematic = from.kinematic;
  to.can_sleep = from.can_sleep;
  to.smoothing = from.smoothing;
  to.layers = from.layers;
  to.colour = from.colour;
  to.label = from.label;
}

/// 1 along the axes that are free, 0 along frozen ones.
[[nodiscard]] inline Vec3d free_axes(Axes frozen) {
  return {has(frozen, Axes::x) ? 0.0 : 1.0, has(frozen, Axes::y) ? 0.0 : 1.0, has(frozen, Axes::z) ? 0.0 : 1.0};
}

/// A part of Body that only cohorts read in which a projectile differs from the rest.
struct OwnPart {
  std::uint32_t flag;  // in Slot::flags: it differs
  bool Features::*feature;
  bool (*differs)(const Own& own);
  void (*put)(const Own& own, Body<double>& body);
};

inline constexpr std::array kOwnParts = {
    OwnPart{1u << 7, &Features::has_gravity_scale, [](const Own& own) { return own.gravity_scale != 1; },
            [](const Own& own, Body<double>& body) { body.gravity_scale *= own.gravity_scale; }},
    OwnPart{1u << 8, &Features::has_frozen, [](const Own& own) { return own.frozen != Axes::none; },
            [](const Own& own, Body<double>& body) { body.free = free_axes(own.frozen); }},
};

/// The flags of all parts.
inline constexpr std::uint32_t kOwn = [] {
  std::uint32_t flags = 0;
  for (const OwnPart& part : kOwnParts) flags |= part.flag;
  return flags;
}();

}  // namespace physim
