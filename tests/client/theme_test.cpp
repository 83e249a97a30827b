// Themes: letters and lines can be read on every ground.
#include "simclient/core/theme.hpp"

#include <gtest/gtest.h>

#include <set>
#include <string>

namespace physim::client::client_theme {
namespace {

TEST(Themes, HaveNamesOfTheirOwn) {
  std::set<std::string_view> names;
  for (const Theme& theme : themes()) {
    EXPECT_TRUE(names.insert(theme.name).second);
    EXPECT_EQ(find_theme(theme.name), &theme);
  }
  EXPECT_EQ(names, (std::set<std::string_view>{"day", "dusk", "chart", "night"}));
  EXPECT_EQ(find_theme("noon"), nullptr);
}

/// The guidelines' own examples: black on white 21, grey 0x777777 on white 4.48.
TEST(Themes, ContrastIsThatOfTheGuidelines) {
  EXPECT_NEAR(contrast(0x000000FF, 0xFFFFFFFF), 21, 1e-9);
  EXPECT_NEAR(contrast(0x777777FF, 0xFFFFFFFF), 4.48, 0.005);
  EXPECT_EQ(contrast(0x123456FF, 0x123456FF), 1);
}

TEST(Themes, LettersOfEveryColourCanBeRead) {
  for (const Theme& theme : themes()) {
    for (const Colour colour : {colours::kText, colours::kDim, colours::kVelocity, colours::kAcceleration,
                                colours::kForce, colours::kWarning, Colour{0x555555FF}, Colour{0x444444FF},
                                Colour{0x0072B2FF}, Colour{0x000000FF}, Colour{0xFFFFFFFF}, Colour{0x00FF00FF}})
      EXPECT_GE(contrast(letters(theme, colour), theme.panel), 4.5) << theme.name << " " << std::hex << colour;
    for (const Colour colour : kPalette)
      EXPECT_GE(contrast(letters(theme, colour), theme.panel), 4.5) << theme.name << " " << std::hex << colour;
    EXPECT_GE(contrast(letters(theme, colours::kText), theme.button), 4.5) << theme.name;
    // Fields, plots and the labels over the brightest part of a scene are grounds of letters, too.
    const auto over_sky = [&](int shift) {
      const double part = static_cast<double>(theme.label & 0xFFU) / 255;
      const auto of = [shift](Colour c) { return static_cast<double>(c >> shift & 0xFFU); };
      return static_cast<Colour>(part * of(theme.label) + (1 - part) * of(theme.horizon)) << shift;
    };
    for (const Colour ground :
         {theme.field, theme.popup, theme.plot, over_sky(24) | over_sky(16) | over_sky(8) | 0xFFU})
      for (const Colour colour :
           {colours::kText, colours::kDim, colours::kWarning, colours::kAcceleration, kPalette[2]})
        EXPECT_GE(contrast(letters(theme, colour), ground), 4.45) << theme.name << " " << std::hex << ground;
    EXPECT_EQ(letters(theme, 0x11223344) & 0xFFU, 0x44U) << "as opaque as it was";
  }
}

TEST(Themes, LinesStandOutOnWhite) {
  const Theme& chart = *find_theme("chart");
  for (const Colour colour : kPalette) EXPECT_GE(contrast(ink(chart, colour), chart.ground), 3) << std::hex << colour;
  const Theme& night = *find_theme("night");
  EXPECT_GE(contrast(ink(night, 0x333333FF), night.ground), 2.2) << "rounds of a dark grey";
  EXPECT_EQ(ink(*find_theme("day"), kPalette[0]), kPalette[0]);
  EXPECT_NEAR(length(chart.to_sun()), 1, 1e-12);
}

}  // namespace
}  // namespace physim::client::client_theme
