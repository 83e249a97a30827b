// Layout: who has which part of the window. Nothing overlaps, at any size.
#pragma once

#include "simclient/core/client.hpp"

namespace physim::client {

/// A part of the window [pixels].
struct Box {
  float x = 0, y = 0, width = 0, height = 0;
};

struct Layout {
  Box menu, left, right, bottom, play, status, scene;
};

/// Lays out a window of this size. All sizes grow with `scale`. Panels that would be too narrow to read are left out.
[[nodiscard]] Layout make_layout(const Client& client, float width, float height, float scale);

}  // namespace physim::client
