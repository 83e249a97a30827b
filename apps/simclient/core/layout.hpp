// Layout: who has which part of the window. Nothing overlaps, at any size.
#pragma once

#include <span>
#include <vector>

#include "simclient/core/client.hpp"

namespace physim::client {

/// A part of the window [pixels].
struct Box {
  float x = 0, y = 0, width = 0, height = 0;
};

struct Layout {
  Box menu, settings, statistics, bottom, play, status, scene;
};

/// Scale of letters and lines on a screen with a number of rows [pixels]: 1 up to 1600 rows, 2 at 2160 rows [-].
[[nodiscard]] double scale_of_screen(double height);

/// Lays out a window of this size. All sizes grow with `scale`. Settings and statistics stand one below the other at
/// the left, and leave three fifths of the window to the scene and the panel under it. They are left out where they
/// would be too narrow to read.
[[nodiscard]] Layout make_layout(const Client& client, float width, float height, float scale);

/// The columns of a table that fit into a width [pixels]: those of the highest rank give way first, of equal ones the
/// last; those of rank 0 stay.
[[nodiscard]] std::vector<std::size_t> columns_that_fit(std::span<const float> widths, std::span<const int> ranks,
                                                        float room);

}  // namespace physim::client
