// Inputs of studies that name files.
#pragma once

#include <string>
#include <string_view>

#include "physim/scenario_study.hpp"

namespace physim {

struct ScenarioShot;

/// As parse_study_input(); the files of columns are found from a folder. The shot, where it is known, decides units
/// that depend on another of its settings.
[[nodiscard]] Result<StudyInput> parse_study_input_in(const std::string& folder, std::string_view text,
                                                      const ScenarioShot* shot = nullptr);

}  // namespace physim
