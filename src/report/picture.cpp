#include "report/picture.hpp"

#include <algorithm>

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
  return "set lmargin at screen " + shortest(left) + "\nset rmargin at screen " + shortest(right) +
         "\nset bmargin at screen " + shortest(bottom) + "\nset tmargin at screen " + shortest(top) + "\n";
}

}  // namespace physim::report
