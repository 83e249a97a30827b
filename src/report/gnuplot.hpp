// Draws pictures with gnuplot: a child process that reads a script and returns the picture, so that no file name ever
// enters a script, and no shell is involved.
#pragma once

#include <string>

#include "physim/result.hpp"
#include "report/picture.hpp"

namespace physim::report {

/// Draws a picture into a .png or .svg file.
[[nodiscard]] Status draw(const std::string& path, const Picture& picture);

/// An error where no picture could be drawn at all, because gnuplot is missing.
[[nodiscard]] Status check_gnuplot();
/// An error where a picture could not be drawn to this path: a file name without .png or .svg, an unwritable place, no
/// gnuplot.
[[nodiscard]] Status check_plot(const std::string& path);

}  // namespace physim::report
