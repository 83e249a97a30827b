#include "simclient/ui/legend.hpp"

#include <imgui_internal.h>

#include <algorithm>

#include "simclient/core/trail_colours.hpp"
#include "simclient/ui/panel.hpp"

namespace physim::client {

Box draw_legend(ImDrawList& list, const SceneLegend& legend, float right, float top, float scale) {
  const ImFont& font = *list._Data->Font;
  const float line = list._Data->FontSize, pad = 6 * scale, bar = 10 * scale;
  const auto width_of = [&](const std::string& text) { return font.CalcTextSizeA(line, 1e9F, 0, text.c_str()).x; };
  const float ends = width_of(legend.low) + width_of(legend.high) + 24 * scale;
  const float wide = std::max({180 * scale, ends, width_of(legend.what)});
  const float x = right - wide - 2 * pad - 10 * scale, y = top + 10 * scale;
  const Box box{x, y, wide + 2 * pad, 2 * line + bar + 2 * pad};
  list.AddRectFilled({x, y}, {x + box.width, y + box.height}, exact(theme_in_use().label), 3 * scale);
  const auto write = [&](float at_x, float at_y, const std::string& text) {
    list.AddText(&font, line, {at_x, at_y}, shade(colours::kText), text.c_str());
  };
  write(x + pad, y + pad / 2, legend.what);
  constexpr int kParts = 24;
  const float from = x + pad, bar_top = y + pad / 2 + line + 2 * scale;
  for (int i = 0; i < kParts; ++i)
    list.AddRectFilled({from + wide * static_cast<float>(i) / kParts, bar_top},
                       {from + wide * static_cast<float>(i + 1) / kParts, bar_top + bar},
                       exact(scale_colour((i + 0.5) / kParts)));
  write(from, bar_top + bar, legend.low);
  write(from + wide - width_of(legend.high), bar_top + bar, legend.high);
  return box;
}

}  // namespace physim::client
