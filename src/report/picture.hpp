// Pictures as scripts for gnuplot, and the parts that all of them are made of.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <string>
#include <string_view>
#include <variant>

#include "report/plot_labels.hpp"
#include "report/text.hpp"

namespace physim::report {

struct Picture {
  int width = 1600;   // [px]
  int height = 1200;  // [px]
  std::string script;
};

/// What a format makes of a result: the text of a file, or a picture that is still to be drawn. A text reads the result
/// when it is written.
using Content = std::variant<Text, Picture>;

// ------------------------------------------------------------------------------------------- parts of scripts

/// A colour-blind-safe palette (Okabe and Ito), without its yellow, which is lost on white.
inline constexpr std::array<std::string_view, 7> kPalette = {"#0072B2", "#D55E00", "#009E73", "#CC79A7",
                                                             "#E69F00", "#56B4E9", "#000000"};
inline constexpr std::string_view kInk = "#303030";      // text
inline constexpr std::string_view kQuiet = "#707070";    // second-rank text and axes
inline constexpr std::string_view kGridInk = "#E4E4E4";  // grid lines

/// A script's text literal; nothing in it is ever interpreted. A single quote, which would end it, becomes ’.
[[nodiscard]] std::string literal(std::string_view text);
/// The house's look of axes, tics and grid.
[[nodiscard]] std::string axes_style();
/// Text on the whole picture, from (0, 0) bottom left to (1, 1) top right, its left end at x and centred on y.
[[nodiscard]] std::string text_at(double x, double y, std::string_view text, int font_size, std::string_view colour,
                                  bool bold = false);
/// The picture's title at its top left: smaller where it is long, shortened where it would be too small.
[[nodiscard]] std::string title_at(double x, double y, const std::string& title, int picture_width);
/// The place of the next panel on the whole picture.
[[nodiscard]] std::string panel_at(double left, double right, double bottom, double top);
/// Where panels of one size stand on a picture, up to three in a row, the first one at its top left [px].
struct PanelGrid {
  std::size_t panels = 1;
  PixelBox area;
  double gap_across = 0, gap_down = 0;
  int width = 0, height = 0;  // of the picture

  /// panel_at() of one of them.
  [[nodiscard]] std::string panel(std::size_t i) const;
};
/// A line on the whole picture.
[[nodiscard]] std::string line_at(double x, double y, double to_x, double to_y, const std::string& style);
/// " lw 2.5 dt 1 lc rgb ...": the line of a curve; those of the second round of the palette are dashed.
[[nodiscard]] std::string curve_style(const char* width, std::size_t index, std::string_view colour);
/// Rows of numbers under a name, "$path0", that plots read.
[[nodiscard]] std::string datablock(const std::string& name, const std::string& rows);

inline constexpr double kLegendGap = 26;  // between entries of a legend [px]
/// How wide an entry is [px].
[[nodiscard]] double legend_width(const std::string& name);
/// A line and what it stands for, at x [px] and at a height from 0 to 1.
[[nodiscard]] std::string legend_entry(double x, double y, const std::string& name, const std::string& style,
                                       int picture_width);

/// How figures that a scenario expects are drawn over curves.
inline constexpr std::string_view kPublishedMark = "pt 6 ps 1.5 lw 1.6 lc rgb '#303030'";  // a ring
inline constexpr std::string_view kExpectedMark = "pt 1 ps 1.6 lw 1.5 lc rgb '#303030'";   // a cross
/// A mark and what it stands for, as legend_entry().
[[nodiscard]] std::string legend_mark(double x, double y, const std::string& name, std::string_view mark,
                                      int picture_width);

// ------------------------------------------------------------------------------- what parts of its axes a panel shows

struct Extent {
  double low = INFINITY, high = -INFINITY;  // of nothing
  void add(double value) {
    if (std::isfinite(value)) low = std::min(low, value), high = std::max(high, value);
  }
  /// From 0 to 0 where nothing was added.
  [[nodiscard]] Extent or_zero() const { return low <= high ? *this : Extent{0, 0}; }
  [[nodiscard]] double span() const { return high - low; }
};

/// A value that does not change but for rounding errors.
[[nodiscard]] bool is_constant(Extent extent);
/// Room around the data; a constant is shown in the middle of a range of its size.
[[nodiscard]] Extent padded(Extent extent);
/// "set xrange [low:high]"
[[nodiscard]] std::string range_of(const char* axis, Extent extent);

/// What the axes of a panel are called in the singular or plural: "vertical axis".
struct AxisNames {
  const char *across, *up;
};
/// Makes a metre as long across as upwards in a panel of `width` by `height` pixels, if both axes keep a visible part;
/// `part_below` of the room that is left lies below the data. Else they stay stretched. Gives what the title says of
/// it.
[[nodiscard]] std::string to_scale(Extent& across, Extent& up, double width, double height, double part_below,
                                   AxisNames names);

/// What a panel shows, above its vertical axis, where it takes no width.
[[nodiscard]] std::string panel_title(const std::string& text);

}  // namespace physim::report
