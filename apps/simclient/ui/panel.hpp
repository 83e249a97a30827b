// What all panels are made with: colours, boxes, small pieces.
#pragma once

#include <imgui.h>

#include <string>

#include "simclient/core/layout.hpp"

namespace physim::client {

void set_theme(float scale);
[[nodiscard]] ImU32 shade(Colour colour);
[[nodiscard]] ImVec4 tint(Colour colour);

/// A panel that fills a box, with a title.
bool begin_panel(const char* title, const Box& box);
void end_panel();

void coloured_text(Colour colour, const std::string& text);  // wrapped
/// Shown while the mouse rests on the item before.
void tooltip(const std::string& text);

}  // namespace physim::client
