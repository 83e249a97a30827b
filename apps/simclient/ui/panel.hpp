// What all panels are made with: colours, boxes, small pieces; and the panels without a state of their own.
#pragma once

#include <imgui.h>

#include <initializer_list>
#include <string>

#include "simclient/core/layout.hpp"

namespace physim::client {

/// The house's face at a size [pixels], or what Dear ImGui brings.
ImFont* load_font(ImFontAtlas& atlas, float size);
void load_fonts(float scale);
/// Colours and sizes of all panels from now on.
void use_theme(const Theme& theme, float scale);
/// The theme in use.
[[nodiscard]] const Theme& theme_in_use();
/// A colour of letters and curves, as the theme in use writes it.
[[nodiscard]] ImU32 shade(Colour colour);
[[nodiscard]] ImVec4 tint(Colour colour);
/// A colour as it is: of grounds, and of what a theme says itself.
[[nodiscard]] ImU32 exact(Colour colour);
[[nodiscard]] ImVec4 exact_tint(Colour colour);

/// A panel that fills a box, with a title.
bool begin_panel(const char* title, const Box& box, bool has_title = true);
/// Puts the next window into the middle of a box, no larger than that.
void centre_window(const Box& box, float width, float height);
/// The next cell of a table.
template <class... Values>
void cell(const char* format, Values... values) {
  ImGui::TableNextColumn();
  ImGui::Text(format, values...);
}
/// The first row of a table.
void headings(std::initializer_list<const char*> titles);
void end_panel();
/// Puts the next item beside the previous one. The item starts a new line if a button with this label, wider by `more`
/// pixels, does not fit.
void go_beside(const char* label, float more = 0);

void coloured_text(Colour colour, const std::string& text);  // wrapped
/// Shown while the mouse rests on the item before.
void tooltip(const std::string& text);

void draw_statistics_panel(Client& client, const Box& box);
/// Under the scene: plots, comparison or performance.
void draw_bottom_panel(Client& client, const Box& box, bool bare);
/// A study: where shots end, how figures settle, what they are.
void draw_study(Client& client);
/// Bare: curves and axes alone, as pictures show them.
void draw_plots(Client& client, bool bare);

}  // namespace physim::client
