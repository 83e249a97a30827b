// A corner of a triangle that is lit, as the renderer reads it.
#pragma once

#include <cstdint>

#include "math/vec3.hpp"
#include "simclient/core/palette.hpp"

namespace physim::client {

struct LitVertex {
  float at[3];             // in the frame of the mesh [m]
  float normal[3];         // of the surface there; round things have those of what they stand for
  std::uint8_t colour[4];  // red, green, blue, opacity
};

[[nodiscard]] inline LitVertex lit_vertex(const Vec3d& at, const Vec3d& normal, Colour colour) {
  LitVertex out;
  const double places[] = {at.x, at.y, at.z}, ways[] = {normal.x, normal.y, normal.z};
  for (std::size_t i = 0; i < 3; ++i) {
    out.at[i] = static_cast<float>(places[i]);
    out.normal[i] = static_cast<float>(ways[i]);
  }
  for (std::size_t i = 0; i < 4; ++i) out.colour[i] = static_cast<std::uint8_t>(colour >> (24 - 8 * i));
  return out;
}

}  // namespace physim::client
