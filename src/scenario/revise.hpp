// A scenario's changes put into the text of its file.
#pragma once

#include <optional>
#include <string>

#include "scenario/as_written.hpp"
#include "scenario/scenario.hpp"

namespace physim {

/// Every setting of the two has the same value, and every shot the same body.
[[nodiscard]] bool say_the_same(const Scenario& a, const Scenario& b);

/// The text of a scenario's file with what is different in `now`: settings and shots at the end. All else stays as it
/// is written. What is different has the units that it was typed with, else those that the file has it in. Nothing if
/// that cannot express it: removed shots, a motor with a file that is not beside `file`. `file` is where the text is to
/// stand.
[[nodiscard]] std::optional<std::string> revised_text(const std::string& text, const std::string& file,
                                                      const Scenario& now, const TypedNumbers& typed = {});

}  // namespace physim
