// Answers to one question about one shot: text for people, JSON for programs.
#pragma once

#include <span>
#include <string>

#include "physim/aim.hpp"
#include "physim/fit.hpp"
#include "report/flown.hpp"
#include "report/style.hpp"

namespace physim::report {

/// "title: shot", the line that answers begin with.
[[nodiscard]] std::string answer_heading(const AskedShot& asked, const Style& style);

[[nodiscard]] std::string aim_text(const AskedShot& asked, const Target& target, const Aim& aim, const Style& style);
[[nodiscard]] std::string aim_json(const AskedShot& asked, const Target& target, double tolerance, const Aim& aim);

/// `fits_speed`: the muzzle speed was fitted, too.
[[nodiscard]] std::string fit_text(const AskedShot& asked, std::span<const Measurement> measurements, bool fits_speed,
                                   const Fit& fit, const Style& style);
[[nodiscard]] std::string fit_json(const AskedShot& asked, bool fits_speed, const Fit& fit);

[[nodiscard]] std::string max_range_text(const AskedShot& asked, const MaxRange& far, const Style& style);
[[nodiscard]] std::string max_range_json(const AskedShot& asked, const MaxRange& far);

[[nodiscard]] std::string danger_space_text(const AskedShot& asked, double range, double height,
                                            const DangerSpace& space, const Style& style);
[[nodiscard]] std::string danger_space_json(const AskedShot& asked, double range, double height,
                                            const DangerSpace& space);

}  // namespace physim::report
