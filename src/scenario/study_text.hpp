// Texts of studies, as the library and its clients read them: inputs that name files, and places.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "scenario/scenario.hpp"

namespace physim {

struct ScenarioShot;

/// As parse_study_input(); the files of columns are found from a folder. The shot, where it is known, decides units
/// that depend on another of its settings.
[[nodiscard]] Result<StudyInput> parse_study_input_in(const std::string& folder, std::string_view text,
                                                      const ScenarioShot* shot = nullptr);
/// study_of() as far as its texts can be read. What is wrong with them goes into `errors`, in places such as
/// "study.inputs[1]".
[[nodiscard]] Study read_study(const Scenario& scenario, const ScenarioShot& shot, std::vector<Error>& errors);
/// The input that a text gives to the study of a shot; nothing where it is of another shot. Its path is as files and
/// the library have it, "shot.speed".
struct InputOfShot {
  std::size_t text = 0;      // among ScenarioStudy::inputs
  std::string written = {};  // without the name of the shot
  std::string path = {};
};
/// All of them, as read_study() numbers them.
[[nodiscard]] std::vector<InputOfShot> inputs_of(const Scenario& scenario, const ScenarioShot& shot);

/// The places of a study; an error names the text that is no place.
[[nodiscard]] Result<std::vector<StudyPlace>> study_places_of(const ScenarioStudy& texts);

}  // namespace physim
