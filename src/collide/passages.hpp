// What a point goes through on its way: sensors, and whatever it passes.
//
// A way is looked at chord by chord, step by step. A surface that lies where two chords meet belongs to one of them,
// and to no other: each chord is cast a little longer than it is, and which of the two a surface there belongs to is a
// question to the place where they meet, which both ask alike.
#pragma once

#include <vector>

#include "physim/scene.hpp"

namespace physim::collide {

/// The surfaces that a point goes through along a chord, in order; `SceneHit::part` is of the chord. Parts of a
/// compound that touch or overlap and have one material are one body, whose inner surfaces do not count.
[[nodiscard]] std::vector<SceneHit> passages(const Scene& scene, const SceneFilter& filter, const SceneSegment& chord);

}  // namespace physim::collide
