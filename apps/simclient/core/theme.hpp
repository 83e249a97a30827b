// Themes: the light in the scene, and the colours of panels that go with it.
#pragma once

#include <array>
#include <span>
#include <string_view>

#include "physim/math.hpp"
#include "simclient/core/palette.hpp"

namespace physim::client {

struct Theme {
  std::string_view name, doc;
  double sun_height = 0, sun_azimuth = 0;     // of the sun: above the horizon, from x towards z [rad]
  Colour zenith = 0, horizon = 0, below = 0;  // of the sky; below: of what is under the horizon without a ground
  Colour glow = 0;                            // of the sky about the sun
  Colour ground = 0, grid = 0, sea = 0;       // sea: of a globe
  Colour sunlight = 0, skylight = 0, earthlight = 0;  // on things, from the sun, from above and from below
  double grain = 0;                                   // unevenness of the ground, in parts of its colour
  double shadow = 0;                                  // part of the ground's light that is left in a shadow
  Colour cloud = 0;                                   // its opacity is that of the densest
  double stars = 0;                                   // part of their light that the sky leaves
  double glow_cover = 0;                              // part of what is behind a glow that it covers
  Colour casing = 0;                                  // about lines and arrows
  bool is_light = false;                              // dark ink on light panels
  Colour panel = 0, popup = 0, bar = 0, field = 0, hovered = 0, active = 0;  // bar: menus and titles
  Colour button = 0, accent = 0, separator = 0, plot = 0, plot_lines = 0, label = 0;

  /// The way to the sun, of length one.
  [[nodiscard]] Vec3d to_sun() const;
};

/// day, dusk, chart, night.
[[nodiscard]] std::span<const Theme> themes();
/// Null: no theme has this name.
[[nodiscard]] const Theme* find_theme(std::string_view name);

/// The contrast of two colours, from 1 to 21 (W3C, Web Content Accessibility Guidelines 2.1, 1.4.3).
[[nodiscard]] double contrast(Colour a, Colour b);
/// A colour made lighter or darker, as far as a contrast with a ground asks for.
[[nodiscard]] Colour readable(Colour colour, Colour ground, double wanted);
/// A colour of lines and marks as a theme draws it: inks for dark grounds turn dark on light ones.
[[nodiscard]] Colour ink(const Theme& theme, Colour colour);
/// A colour of letters as a theme writes it on any of its grounds.
[[nodiscard]] Colour letters(const Theme& theme, Colour colour);
/// The grounds of letters of any colour: panels, bars, fields, rows under the mouse, plots, and labels over the scene.
/// On buttons, tabs and grabs stand letters of plain text alone.
[[nodiscard]] std::array<Colour, 9> grounds_of_letters(const Theme& theme);
/// The grab of a slider, under its value.
[[nodiscard]] Colour grab(const Theme& theme);
/// Letters that are selected stand on this, as part of a field.
[[nodiscard]] Colour selected_letters(const Theme& theme);

}  // namespace physim::client
