// The things of a scene as a vertical cut along a track goes through them, for pictures from the side.
#pragma once

#include <string>
#include <vector>

#include "physim/scene.hpp"
#include "report/picture.hpp"

namespace physim::report {

/// A place of a track: where pictures draw it, where its foot is, and when something passes there.
struct TrackPlace {
  double across = 0;  // [m]
  double x = 0;       // [m]
  double z = 0;       // [m]
  double time = 0;    // [s]
};

/// A track that continues straight at both ends, as far as a panel is wide, in steps that a picture does not show.
[[nodiscard]] std::vector<TrackPlace> extended(const std::vector<TrackPlace>& track, Extent across);

/// What a cut goes through, as rows of a datablock.
struct Section {
  std::string solids;    // upright lines inside of things: across, height, 0, how much higher
  std::string surfaces;  // points on surfaces: across, height
};

/// Things stand as they do when the track passes them.
[[nodiscard]] Section section_along(const Scene& scene, const std::vector<TrackPlace>& track, Extent heights);

/// The cut's part of a plot command, or nothing.
[[nodiscard]] std::string section_plots(const Section& section, const std::string& block);
[[nodiscard]] std::string section_blocks(const Section& section, const std::string& block);

}  // namespace physim::report
