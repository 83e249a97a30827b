// The ladder of fidelity as a table for people, as records and as JSON.
#pragma once

#include <string>

#include "report/ladder.hpp"
#include "report/picture.hpp"
#include "report/records.hpp"
#include "report/style.hpp"

namespace physim::report {

[[nodiscard]] std::string ladder_text(const LadderOfShot& subject, const Style& style);
/// A row for each rung.
[[nodiscard]] Records records_of(const LadderOfShot& subject);
[[nodiscard]] Content ladder_json(const LadderOfShot& subject);

}  // namespace physim::report
