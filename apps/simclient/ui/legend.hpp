// The legend of trails in colours of a scale.
#pragma once

#include <imgui.h>

#include "simclient/core/layout.hpp"
#include "simclient/core/scene.hpp"

namespace physim::client {

/// Draws a bar of the scale with its ends and what it means, with its upper right corner there, in the font of the
/// list. Returns its place, which labels leave free.
Box draw_legend(ImDrawList& list, const SceneLegend& legend, float right, float top, float scale);

}  // namespace physim::client
