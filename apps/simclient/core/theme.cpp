#include "simclient/core/theme.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "base/assert.hpp"
#include "math/angles.hpp"

namespace physim::client {
namespace {

constexpr double kLettersContrast = 4.5, kLinesContrast = 3;  // as the guidelines ask for
constexpr double kDark = 0.1, kDarkLinesContrast = 2.2;       // kDark: luminance of a ground

constexpr Theme kThemes[] = {
    {.name = "day",
     .doc = "blue sky, green ground",
     .sun_height = 44 * kDegree,
     .sun_azimuth = -144 * kDegree,
     .zenith = 0x3F74B5FF,
     .horizon = 0xC3D5E3FF,
     .below = 0x8C9BA6FF,
     .glow = 0xFFF2D8FF,
     .ground = 0x71854FFF,
     .grid = 0xE8F0D858,
     .sea = 0x2C5C86FF,
     .sunlight = 0xCCC2ADFF,
     .skylight = 0x6A7688FF,
     .earthlight = 0x454438FF,
     .grain = 0.24,
     .shadow = 0.58,
     .cloud = 0xF4F8FBB8,
     .glow_cover = 0.8,
     .casing = 0x0C1016A0,
     .panel = 0x1A1E24FF,
     .popup = 0x20252DFF,
     .bar = 0x14171CFF,
     .field = 0x2A313AFF,
     .hovered = 0x36404CFF,
     .active = 0x41505FFF,
     .button = 0x2F3945FF,
     .accent = 0x56B4E9FF,
     .separator = 0x38414CFF,
     .plot = 0x12151AFF,
     .plot_lines = 0x2C333CFF,
     .label = 0x101318DC},
    {.name = "dusk",
     .doc = "a low sun, long shadows",
     .sun_height = 7 * kDegree,
     .sun_azimuth = 38 * kDegree,
     .zenith = 0x26355EFF,
     .horizon = 0xD79A78FF,
     .below = 0x4E4450FF,
     .glow = 0xFFB060FF,
     .ground = 0x5A5646FF,
     .grid = 0xF0D8B84C,
     .sea = 0x24405FFF,
     .sunlight = 0xD69A62FF,
     .skylight = 0x6E6478FF,
     .earthlight = 0x3A3434FF,
     .grain = 0.2,
     .shadow = 0.62,
     .cloud = 0xF0B48C90,
     .stars = 0.12,
     .glow_cover = 0.45,
     .casing = 0x0E0A10A8,
     .panel = 0x211C22FF,
     .popup = 0x28222AFF,
     .bar = 0x18141AFF,
     .field = 0x352D37FF,
     .hovered = 0x443A47FF,
     .active = 0x544858FF,
     .button = 0x3B323EFF,
     .accent = 0xE8A860FF,
     .separator = 0x463C49FF,
     .plot = 0x171318FF,
     .plot_lines = 0x362E39FF,
     .label = 0x141016DC},
    {.name = "chart",
     .doc = "white, for projectors and print",
     .sun_height = 55 * kDegree,
     .sun_azimuth = -144 * kDegree,
     .zenith = 0xFFFFFFFF,
     .horizon = 0xF6F7F8FF,
     .below = 0xF0F1F2FF,
     .glow = 0x000000FF,
     .ground = 0xF2F3F1FF,
     .grid = 0x7F8B9690,
     .sea = 0xE3EBF2FF,
     .sunlight = 0x8C8C8CFF,
     .skylight = 0x8A8A8AFF,
     .earthlight = 0x6C6C6CFF,
     .grain = 0,
     .shadow = 0.8,
     .casing = 0xFFFFFFC0,
     .is_light = true,
     .panel = 0xFAFAFAFF,
     .popup = 0xFFFFFFFF,
     .bar = 0xECEEF0FF,
     .field = 0xE4E8ECFF,
     .hovered = 0xD3DAE2FF,
     .active = 0xC2CCD8FF,
     .button = 0xDDE3EAFF,
     .accent = 0x0072B2FF,
     .separator = 0xC4CBD3FF,
     .plot = 0xFFFFFFFF,
     .plot_lines = 0xDDE1E6FF,
     .label = 0xFFFFFFDC},
    {.name = "night",
     .doc = "dark, as instruments are",
     .sun_height = 30 * kDegree,
     .sun_azimuth = -144 * kDegree,
     .zenith = 0x080B14FF,
     .horizon = 0x233447FF,
     .below = 0x10141AFF,
     .glow = 0x202A38FF,
     .ground = 0x20262BFF,
     .grid = 0x9CB0C44A,
     .sea = 0x142434FF,
     .sunlight = 0x9AA4B4FF,
     .skylight = 0x68758AFF,
     .earthlight = 0x34373CFF,
     .grain = 0.1,
     .shadow = 0.6,
     .cloud = 0x34445880,
     .stars = 0.9,
     .glow_cover = 0.1,
     .casing = 0x000000A0,
     .panel = 0x14171CFF,
     .popup = 0x1A1E24FF,
     .bar = 0x0F1115FF,
     .field = 0x232930FF,
     .hovered = 0x303842FF,
     .active = 0x3B4653FF,
     .button = 0x28303AFF,
     .accent = 0x56B4E9FF,
     .separator = 0x303740FF,
     .plot = 0x0D0F13FF,
     .plot_lines = 0x262C34FF,
     .label = 0x0A0C10DC},
};

double channel(Colour colour, int shift) { return static_cast<double>(colour >> shift & 0xFFU) / 255; }

double luminance(Colour colour) {
  const auto linear = [](double c) { return c <= 0.03928 ? c / 12.92 : std::pow((c + 0.055) / 1.055, 2.4); };
  return 0.2126 * linear(channel(colour, 24)) + 0.7152 * linear(channel(colour, 16)) +
         0.0722 * linear(channel(colour, 8));
}

/// Part of the way from a colour to white or black.
Colour towards(Colour colour, bool white, double part) {
  Colour out = colour & 0xFFU;
  for (const int shift : {8, 16, 24}) {
    const double from = channel(colour, shift);
    out |= static_cast<Colour>(std::lround(255 * (from + ((white ? 1.0 : 0.0) - from) * part))) << shift;
  }
  return out;
}

/// Greys of dark themes, and what they are on white.
constexpr std::pair<Colour, Colour> kOnWhite[] = {{colours::kText, 0x16191DFF},
                                                  {colours::kDim, 0x56606AFF},
                                                  {colours::kGrid, 0x98A2ADFF},
                                                  {colours::kArrow, 0x111418FF}};

/// A colour that is not opaque, over another.
Colour over(Colour colour, Colour ground) {
  Colour out = 0xFF;
  const double part = channel(colour, 0);
  for (const int shift : {8, 16, 24})
    out |= static_cast<Colour>(std::lround(255 * std::lerp(channel(ground, shift), channel(colour, shift), part)))
           << shift;
  return out;
}

/// The ground of letters that is nearest to them.
Colour worst_ground(const Theme& theme) {
  const auto grounds = grounds_of_letters(theme);
  return theme.is_light ? *std::ranges::min_element(grounds, {}, luminance)
                        : *std::ranges::max_element(grounds, {}, luminance);
}

Colour on_white(Colour colour) {
  for (const auto& [from, to] : kOnWhite)
    if ((from | 0xFFU) == (colour | 0xFFU)) return (to & ~0xFFU) | (colour & 0xFFU);
  return colour;
}

}  // namespace

Vec3d Theme::to_sun() const {
  return {std::cos(sun_height) * std::cos(sun_azimuth), std::sin(sun_height),
          std::cos(sun_height) * std::sin(sun_azimuth)};
}

std::span<const Theme> themes() { return kThemes; }

const Theme* find_theme(std::string_view name) {
  const auto found = std::ranges::find(kThemes, name, &Theme::name);
  return found == std::end(kThemes) ? nullptr : found;
}

double contrast(Colour a, Colour b) {
  const double x = luminance(a), y = luminance(b);
  return (std::max(x, y) + 0.05) / (std::min(x, y) + 0.05);
}

Colour readable(Colour colour, Colour ground, double wanted) {
  PHYSIM_ASSERT(wanted >= 1 && wanted <= 21);
  constexpr int kSteps = 20;
  const bool white = luminance(ground) < 0.18;
  Colour out = colour;
  for (int i = 1; i <= kSteps && contrast(out, ground) < wanted; ++i)
    out = towards(colour, white, static_cast<double>(i) / kSteps);
  return out;
}

Colour ink(const Theme& theme, Colour colour) {
  if (theme.is_light) return readable(on_white(colour), theme.ground, kLinesContrast);
  const bool is_dark = luminance(theme.ground) < kDark;
  return is_dark ? readable(colour, theme.ground, kDarkLinesContrast) : colour;  // others have a casing
}

Colour letters(const Theme& theme, Colour colour) {
  static const auto kWorst = [] {
    std::array<Colour, std::size(kThemes)> worst{};
    std::ranges::transform(kThemes, worst.begin(), worst_ground);
    return worst;
  }();
  const std::ptrdiff_t number = &theme - std::begin(kThemes);
  PHYSIM_ASSERT(number >= 0 && number < std::ssize(kWorst));
  return readable(theme.is_light ? on_white(colour) : colour, kWorst[static_cast<std::size_t>(number)],
                  kLettersContrast);
}

std::array<Colour, 9> grounds_of_letters(const Theme& theme) {
  constexpr double kMessages = 0.9;  // of the opacity of panels
  const Colour scene = theme.is_light ? theme.ground : theme.horizon, faint = theme.is_light ? 0x00000008 : 0xFFFFFF08;
  return {theme.panel,
          over(faint, theme.panel),
          theme.popup,
          theme.bar,
          theme.field,
          theme.hovered,
          theme.plot,
          over(theme.label, scene),
          over(faded(theme.panel, kMessages), scene)};
}

Colour grab(const Theme& theme) { return readable(theme.accent, letters(theme, colours::kText), kLettersContrast); }

Colour selected_letters(const Theme& theme) { return over(faded(theme.accent, 0.3), theme.field); }

}  // namespace physim::client
