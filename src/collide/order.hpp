// The order in which a batch of segments is cast: neighbours one after the other.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "physim/scene.hpp"

namespace physim::collide {

/// The numbers of segments, such that those that begin near each other mostly follow each other: what of a scene they
/// look at is in the cache then. By places along a curve that fills a cube about all of them.
/// Source: G. M. Morton, "A computer oriented geodetic data base and a new technique in file sequencing", IBM (1966).
[[nodiscard]] std::vector<std::uint32_t> order_by_place(std::span<const SceneSegment> segments);

}  // namespace physim::collide
