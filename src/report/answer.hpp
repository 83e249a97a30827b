// Answers to one question about one shot: text for people, JSON for programs.
#pragma once

#include <nlohmann/json_fwd.hpp>
#include <span>
#include <string>

#include "physim/solve.hpp"
#include "report/flown.hpp"
#include "report/style.hpp"
#include "report/text.hpp"

namespace physim::report {

struct Answer {
  std::string text;
  Text json;  // reads the shot that was asked about
};

/// A unit in which figures were measured; a drop may be the angle at which it is seen.
struct FitUnit {
  std::string name;
  double size = 1;
  bool is_angle = false;
};
struct FitUnits {
  FitUnit range{"m"}, speed{"m/s"}, drop{"m"}, time{"s"};
};

/// What a shot and its scenario are called.
[[nodiscard]] std::string title_of_shot(const AskedShot& asked);
/// Under that title, and as JSON behind where the answer comes from.
[[nodiscard]] Answer about_shot(const AskedShot& asked, const Style& style, const std::string& text,
                                nlohmann::ordered_json members);

/// `options`: as aim() was asked; their scene is still there.
[[nodiscard]] Answer aim_answer(const AskedShot& asked, const Target& target, const AimOptions& options, const Aim& aim,
                                const Style& style);
/// `units`: those of the text, JSON is in SI. `fits_speed`: the muzzle speed was fitted, too.
[[nodiscard]] Answer fit_answer(const AskedShot& asked, std::span<const Measurement> measurements,
                                const FitUnits& units, bool fits_speed, const Fit& fit, const Style& style);
[[nodiscard]] Answer max_range_answer(const AskedShot& asked, const MaxRange& far, const Style& style);
[[nodiscard]] Answer danger_space_answer(const AskedShot& asked, const Flight& flight, double range, double height,
                                         const DangerSpace& space, const Style& style);

/// The motions that suvat() found.
[[nodiscard]] Answer suvat_answer(const SuvatGiven& given, std::span<const Suvat> motions);

}  // namespace physim::report
