// Colours that people with any colour vision can tell apart.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

namespace physim::client {

/// 0xRRGGBBAA, as BodyDef::colour.
using Colour = std::uint32_t;

/// M. Okabe and K. Ito, Color Universal Design (2008), without the two that are hard to see on a dark ground; white
/// stands for their black.
inline constexpr std::array<Colour, 7> kPalette = {0xE69F00FF, 0x56B4E9FF, 0x009E73FF, 0xF0E442FF,
                                                   0xD55E00FF, 0xCC79A7FF, 0xFFFFFFFF};

constexpr Colour palette(std::size_t i) { return kPalette[i % kPalette.size()]; }

/// A colour made less opaque.
constexpr Colour faded(Colour colour, double opacity) {
  return (colour & 0xFFFFFF00U) | static_cast<Colour>(static_cast<double>(colour & 0xFFU) * opacity);
}

namespace colours {
inline constexpr Colour kText = 0xE6E9EDFF;
inline constexpr Colour kDim = 0x9AA3ADFF;
inline constexpr Colour kGrid = 0x5A6470FF;
inline constexpr Colour kArrow = 0xFFFFFFFF;
inline constexpr Colour kVelocity = 0x56B4E9FF;
inline constexpr Colour kAcceleration = 0xD55E00FF;
inline constexpr Colour kForce = 0xF0E442FF;
inline constexpr Colour kWarning = 0xE69F00FF;
}  // namespace colours

}  // namespace physim::client
