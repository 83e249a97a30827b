// Labels of the scene: where each is written, so that all can be read.
#pragma once

#include <functional>
#include <vector>

#include "simclient/core/layout.hpp"
#include "simclient/core/scene.hpp"

namespace physim::client {

struct PlacedLabel {
  const SceneLabel* label = nullptr;
  float x = 0, y = 0;  // of its upper left corner, in the window [pixels]
};

/// How wide a text is written [pixels].
using TextWidth = std::function<float(const std::string&)>;

/// Places labels in the part of the window that shows the scene, as whole ones. Those of projectiles move by some
/// lines, or by half their width, if others stand in their way; those of scale lines, and those that say so, give way.
/// The last are placed first. `line`: height of a line of text [pixels]; `taken`: places for something else.
[[nodiscard]] std::vector<PlacedLabel> place_labels(const std::vector<SceneLabel>& labels, const Camera& camera,
                                                    const Box& scene, float line, float scale,
                                                    const TextWidth& width_of, std::vector<Box> taken = {});

}  // namespace physim::client
