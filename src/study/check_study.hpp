// What can be wrong with a study.
#pragma once

#include "study/plan.hpp"

namespace physim {

/// All but what flights refuse. `of_flights`: its inputs are those of study_paths(). `all`: filled with every mistake
/// where it is not null; the first is returned.
[[nodiscard]] Status check(const Study& study, bool of_flights, std::vector<Error>* all = nullptr);
/// Inputs that are drawn together; an error for correlations that cannot be.
[[nodiscard]] Result<std::vector<InputGroup>> groups_of(const Study& study);

}  // namespace physim
