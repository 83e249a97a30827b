// A range card: drop, windage and more at each range, in metric or customary units.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "report/flown.hpp"
#include "report/records.hpp"
#include "report/table.hpp"

namespace physim::report {

/// A unit to show numbers in: value in SI / size.
struct ShownUnit {
  const char* name;
  double size;
  int decimals;
};

/// The units of a card.
struct CardUnits {
  ShownUnit range, drop, speed, energy, angle;
};

constexpr ShownUnit kMil = {"mil", 1e-3, 2};  // a milliradian
constexpr ShownUnit kMoa = {"MOA", 2.908882086657216e-4, 1};
constexpr CardUnits kMetric = {{"m", 1, 0}, {"cm", 0.01, 1}, {"m/s", 1, 1}, {"J", 1, 0}, kMil};
constexpr CardUnits kCustomary = {
    {"yd", 0.9144, 0}, {"in", 0.0254, 1}, {"ft/s", 0.3048, 0}, {"ft lbf", 1.3558179483314004, 0}, kMoa};

/// A cross wind from the right.
struct AskedWind {
  std::string label;  // "10 mph"
  double speed = 0;   // [m/s]
};

/// What a card is to show.
struct CardWishes {
  CardUnits units = kMetric;
  bool scenario_ranges = true;  // those of the scenario; else only if whole numbers of the unit
  std::vector<AskedWind> winds;
};

/// A flight that tells the windage of one cross wind, against the same in calm air.
struct CrossWind {
  std::string label;
  Flight blown, calm;
};

/// What a card is made from.
struct Card {
  const AskedShot* asked;
  CardUnits units;
  Flight flight;
  std::optional<Flight> without_spin;
  std::vector<CrossWind> winds;
  std::vector<double> ranges;
};

/// Flies what a card needs.
[[nodiscard]] Result<Card> make_card(const AskedShot& asked, const CardWishes& wishes);
/// A row of text for each range; a range that the shot does not reach says so.
[[nodiscard]] Table table_of(const Card& card);
/// A row for each range, with all digits; cells are empty where the shot does not reach it.
[[nodiscard]] Records records_of(const Card& card);

}  // namespace physim::report
