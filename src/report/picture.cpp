#include "report/picture.hpp"

#include "base/assert.hpp"
#include "report/number.hpp"
#include "report/table.hpp"

namespace physim::report {

std::string literal(std::string_view text) {
  std::string out = "'";
  for (const char c : text) {
    const bool is_control = static_cast<unsigned char>(c) < 0x20 || c == 0x7f;
    out += c == '\'' ? std::string("’") : std::string(1, is_control ? ' ' : c);
  }
  return out + "'";
}

std::string axes_style() {
  const std::string quiet = " rgb " + literal(kQuiet), grid = " rgb " + literal(kGridInk);
  return "set border 3 lw 1 lc" + quiet + "\nset tics nomirror out scale 0.6 font ',12' textcolor rgb " +
         literal(kInk) + "\nset grid back lt 1 lw 1 lc" + grid + "\nunset key\n";
}

std::string text_at(double x, double y, std::string_view text, int font_size, std::string_view colour, bool bold) {
  PHYSIM_ASSERT(font_size > 0);
  return "set label " + literal(text) + " at screen " + shortest(x) + "," + shortest(y) + " left font " +
         literal("DejaVu Sans" + std::string(bold ? " Bold" : "") + "," + std::to_string(font_size)) +
         " textcolor rgb " + literal(colour) + " front\n";
}

std::string title_at(double x, double y, const std::string& title, int picture_width) {
  constexpr double kCharacterWidth = 0.77;  // of bold text, a part of the font size
  constexpr int kLargest = 22, kSmallest = 15;
  const std::string text = one_line(title);
  const double room = picture_width * (1 - 2 * x) / kCharacterWidth;
  const double fitting = room / static_cast<double>(std::max<std::size_t>(display_width(text), 1));
  const int font_size = static_cast<int>(std::clamp<double>(fitting, kSmallest, kLargest));
  return text_at(x, y, shortened(text, static_cast<std::size_t>(room / font_size)), font_size, kInk, true);
}

std::string panel_at(double left, double right, double bottom, double top) {
  PHYSIM_ASSERT(left < right);
  PHYSIM_ASSERT(bottom < top);
  return "set lmargin at screen " + shortest(left) + "\nset rmargin at screen " + shortest(right) +
         "\nset bmargin at screen " + shortest(bottom) + "\nset tmargin at screen " + shortest(top) + "\n";
}

std::string PanelGrid::panel(std::size_t i) const {
  PHYSIM_ASSERT(i < panels && width > 0 && height > 0);
  const std::size_t columns = panels == 4 ? 2 : std::min<std::size_t>(panels, 3);
  const std::size_t rows = (panels + columns - 1) / columns;
  const auto across = static_cast<double>(columns), down = static_cast<double>(rows);
  const double wide = (area.right - area.left - gap_across * (across - 1)) / across;
  const double high = (area.top - area.bottom - gap_down * (down - 1)) / down;
  const double left = area.left + static_cast<double>(i % columns) * (wide + gap_across);
  const double top = area.top - static_cast<double>(i / columns) * (high + gap_down);
  return panel_at(left / width, (left + wide) / width, (top - high) / height, top / height);
}

std::string line_at(double x, double y, double to_x, double to_y, const std::string& style) {
  return "set arrow from screen " + shortest(x) + "," + shortest(y) + " to screen " + shortest(to_x) + "," +
         shortest(to_y) + " nohead" + style + "\n";
}

std::string curve_style(const char* width, std::size_t index, std::string_view colour) {
  PHYSIM_ASSERT(colour.starts_with('#'));
  const char* dash = index >= kPalette.size() ? "(14,6)" : "1";
  return std::string(" lw ") + width + " dt " + dash + " lc rgb " + literal(colour);
}

std::string datablock(const std::string& name, const std::string& rows) {
  PHYSIM_ASSERT(name.starts_with('$'));
  return name + " << EndOfData\n" + rows + "EndOfData\n";
}

namespace {
constexpr int kLegendFont = 13;
constexpr double kLegendLine = 40, kLegendCharacter = kLegendFont * 0.72;  // [px]
}  // namespace

double legend_width(const std::string& name) {
  return kLegendLine + static_cast<double>(display_width(name)) * kLegendCharacter;
}

std::string legend_entry(double x, double y, const std::string& name, const std::string& style, int picture_width) {
  return line_at(x / picture_width, y, (x + kLegendLine - 8) / picture_width, y, style) +
         text_at((x + kLegendLine) / picture_width, y, name, kLegendFont, kInk);
}

std::string legend_mark(double x, double y, const std::string& name, std::string_view mark, int picture_width) {
  return "set label '' at screen " + shortest((x + kLegendLine / 2) / picture_width) + "," + shortest(y) + " point " +
         std::string(mark) + " front\n" + text_at((x + kLegendLine) / picture_width, y, name, kLegendFont, kInk);
}

bool is_constant(Extent extent) {
  const double size = std::max(std::abs(extent.low), std::abs(extent.high));
  return extent.span() <= std::max(1e-9, 1e-9 * size);
}

Extent padded(Extent extent) {
  PHYSIM_ASSERT(extent.low <= extent.high);
  if (is_constant(extent)) {
    const double middle = std::abs(extent.low) < 1e-9 ? 0 : (extent.low + extent.high) / 2;
    const double room = middle == 0 ? 1 : std::abs(middle) / 2;
    return {middle - room, middle + room};
  }
  return {extent.low - 0.07 * extent.span(), extent.high + 0.07 * extent.span()};
}

std::string range_of(const char* axis, Extent extent) {
  PHYSIM_ASSERT(extent.low != extent.high);
  return std::string("set ") + axis + "range [" + significant(extent.low, 9) + ":" + significant(extent.high, 9) +
         "]\n";
}

std::string to_scale(Extent& across, Extent& up, double width, double height, double part_below, AxisNames names) {
  PHYSIM_ASSERT(width > 0);
  PHYSIM_ASSERT(height > 0);
  const double metres_per_pixel = std::max(across.span() / width, up.span() / height);
  const double part_across = across.span() / (metres_per_pixel * width);
  const double part_up = up.span() / (metres_per_pixel * height);
  if (!(part_across > 0.25 && part_up > 0.25))
    return std::string(", ") + (part_up < part_across ? names.up : names.across) + " stretched " +
           readable(std::max(part_across / part_up, part_up / part_across), 2) + " times";
  const auto widened = [&](const Extent& extent, double size) {
    const double room = metres_per_pixel * size - extent.span();
    return Extent{extent.low - part_below * room, extent.high + (1 - part_below) * room};
  };
  across = widened(across, width);
  up = widened(up, height);
  return ", to scale";
}

std::string panel_title(const std::string& text) {
  return "set label " + literal(text) + " at graph 0,1 left offset 0,0.75 font ',14' textcolor rgb " + literal(kInk) +
         "\n";
}

}  // namespace physim::report
