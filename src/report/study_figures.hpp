// Figures of a study, each under its own name.
#pragma once

#include <string>
#include <vector>

#include "report/study_answer.hpp"

namespace physim::report {

struct Figure {
  std::string name;
  double value, error;  // NaN: not known
};

/// The names of a group of inputs.
[[nodiscard]] std::string names_of_inputs(const Study& study, const std::vector<std::size_t>& inputs);
/// Every figure of its end, without those over inputs.
[[nodiscard]] std::vector<Figure> figures_of(const FlownStudy& flown);

}  // namespace physim::report
