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

/// On whatever stands under them, in every theme.
TEST(Themes, LettersOfEveryColourCanBeRead) {
  for (const Theme& theme : themes()) {
    for (const Colour colour : {colours::kText, colours::kDim, colours::kVelocity, colours::kAcceleration,
                                colours::kForce, colours::kWarning, Colour{0x555555FF}, Colour{0x444444FF},
                                Colour{0x0072B2FF}, Colour{0x000000FF}, Colour{0xFFFFFFFF}, Colour{0x00FF00FF}})
      for (const Colour ground : grounds_of_letters(theme))
        EXPECT_GE(contrast(letters(theme, colour), ground), 4.5)
            << theme.name << std::hex << " " << colour << " " << ground;
    for (const Colour colour : kPalette)
      for (const Colour ground : grounds_of_letters(theme))
        EXPECT_GE(contrast(letters(theme, colour), ground), 4.5)
            << theme.name << std::hex << " " << colour << " " << ground;
    for (const Colour ground : {theme.button, theme.hovered, theme.active, grab(theme), selected_letters(theme)})
      EXPECT_GE(contrast(letters(theme, colours::kText), ground), 4.5) << theme.name << " " << std::hex << ground;
    EXPECT_GE(contrast(grab(theme), theme.field), 1.5) << theme.name << ": a grab is seen";
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
