// Inputs of studies that name files.
#pragma once

#include <string>
#include <string_view>

#include "physim/scenario_study.hpp"

namespace physim {

/// As parse_study_input(); the files of columns are found from a folder.
[[nodiscard]] Result<StudyInput> parse_study_input_in(const std::string& folder, std::string_view text);

}  // namespace physim
