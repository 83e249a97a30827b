// The figures that an [[expect]] can check.
#pragma once

#include <span>
#include <string_view>

#include "scenario/scenario.hpp"
#include "scenario/world_run.hpp"

namespace physim {

/// A figure: of a flight at one time, by its sample, by its place on the Earth or by more of the flight; of a flight as
/// a whole if it is none of these; and of a group of projectiles at the end of a world's run, of its hits on things, or
/// of what it passed.
struct Figure {
  std::string_view name;
  Quantity quantity;
  double (*value)(const Sample&) = nullptr;
  double Geodetic::*place = nullptr;
  std::optional<double> (*of_group)(const WorldGroup&) = nullptr;              // nothing: nothing there to measure
  std::optional<double> (*of_moment)(const Flight&, const Sample&) = nullptr;  // nothing: rotation was not flown
  std::optional<double> (*of_hits)(const ThingHits&) = nullptr;                // nothing: nothing there to measure
  bool is_of_emitters = false;                                                 // of groups, those that emitters fire
  bool is_of_passages = false;                                                 // Passages::of()

  [[nodiscard]] bool is_of_things() const { return of_hits != nullptr || is_of_passages; }
  [[nodiscard]] bool is_of_worlds() const { return of_group != nullptr || is_of_things(); }
  [[nodiscard]] bool is_of_flights() const {
    return value != nullptr || place != nullptr || of_moment != nullptr || !is_of_worlds();
  }
};

[[nodiscard]] std::span<const Figure> figures();
[[nodiscard]] std::span<const std::string_view> figure_names();
[[nodiscard]] std::vector<std::string_view> group_figure_names();
[[nodiscard]] std::vector<std::string_view> hit_figure_names();
/// Heights of all hits of a group, and their places to the right: on the wall of the world and on things of its scene.
[[nodiscard]] Series hit_heights(const WorldGroup& group);
[[nodiscard]] Series hit_sides(const WorldGroup& group);
/// The figure of a name; null if not found.
[[nodiscard]] const Figure* find_figure(std::string_view name);

}  // namespace physim
