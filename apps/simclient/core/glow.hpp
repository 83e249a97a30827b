// Glow: the light that hot particles throw about themselves on the screen, as a coarse picture that is laid over it.
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "simclient/core/camera.hpp"
#include "simclient/core/hiding.hpp"
#include "simclient/core/palette.hpp"

namespace physim::client {

/// A source of light: a particle, or its streak from one frame to the next.
struct Light {
  Vec3d from, to;
  Colour colour = 0xFFFFFFFF;
  float pixels = 0;  // its diameter [pixels]
};

/// The apparent heat of a colour [-], 0..1: above 0 for colours of fire, 0 for those of water, smoke and paper.
[[nodiscard]] double heat(Colour colour);

/// The colour of the middle of what has this colour: hot things are brighter there.
[[nodiscard]] Colour core_of(Colour colour);

/// The part of a picture that has any light, in cells of `cell` pixels.
struct GlowMap {
  double cell = 5;                  // [pixels]
  int left = 0, top = 0;            // [cells]
  int columns = 0, rows = 0;        // [cells]; 0: nothing shines
  std::vector<std::uint8_t> light;  // red, green and blue of each cell, rows from the top

  void clear() { columns = rows = 0; }
};

/// Adds up the light of all. `scale`: of the screen; `haze`: the distance at which half of a light is left [m];
/// `scenery`: what hides lights; null: nothing does.
class GlowMaker {
 public:
  GlowMaker(const Camera& camera, double scale, double haze, const Scenery* scenery = nullptr);
  void add(const Light& light);
  void make(GlowMap& map);

 private:
  void add_at(double x, double y, double heat, const float (&colour)[3]);

  const Camera& camera_;
  Projector view_;
  Vec3d eye_;
  double cell_, haze_;
  int columns_, rows_;
  int left_, right_ = -1, top_, bottom_ = -1;  // of the cells that have light
  std::vector<float> sums_;
  std::optional<HidingMap> hiding_;
};

}  // namespace physim::client
