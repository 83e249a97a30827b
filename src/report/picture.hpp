// Pictures as scripts for gnuplot, and the parts that all of them are made of.
#pragma once

#include <array>
#include <string>
#include <string_view>
#include <variant>

namespace physim::report {

struct Picture {
  int width = 1600;   // [px]
  int height = 1200;  // [px]
  std::string script;
};

/// What a format makes of a result: the text of a file, or a picture that is still to be drawn.
using Content = std::variant<std::string, Picture>;

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

}  // namespace physim::report
