// What commands that answer one question answer, as JSON for programs.
#pragma once

#include <string>

#include "asked.hpp"
#include "physim/aim.hpp"
#include "physim/fit.hpp"
#include "physim/recording.hpp"

namespace physim::cli {

[[nodiscard]] std::string aim_json(const AskedShot& asked, const Target& target, double tolerance, const Aim& aim);
/// `fits_speed`: the muzzle speed was fitted, too.
[[nodiscard]] std::string fit_json(const AskedShot& asked, bool fits_speed, const Fit& fit);
[[nodiscard]] std::string max_range_json(const AskedShot& asked, const MaxRange& far);
[[nodiscard]] std::string danger_space_json(const AskedShot& asked, double range, double height,
                                            const DangerSpace& space);
/// Of a recording that was played to its end.
[[nodiscard]] std::string replay_json(const std::string& file, const Replay& player);

}  // namespace physim::cli
