// What a study came to: text for people, JSON for programs, figures as records.
#pragma once

#include <optional>
#include <span>

#include "physim/study.hpp"
#include "report/answer.hpp"
#include "report/records.hpp"

namespace physim::report {

/// A study that was flown.
struct FlownStudy {
  StudyPlan plan;
  StudyResult result;
  std::optional<LinearResult> linear;  // where it could be computed
};

/// The unit of an input's number; empty where the study is of a function.
[[nodiscard]] std::string unit_of(const StudyInput& input);
/// "shot.speed [m/s]"; "shot.speed += [m/s]" of what is added.
[[nodiscard]] std::string with_unit(const StudyInput& input);
/// "m", "s", "m/s".
[[nodiscard]] std::string_view unit_of(StudyQuantity quantity);
/// "right [m]"
[[nodiscard]] std::string with_unit(StudyQuantity quantity);

[[nodiscard]] Answer study_answer(const AskedShot& asked, const FlownStudy& flown, const Style& style);
/// A study with its plane of impact at a range [m].
struct StudyAtRange {
  double range;
  StudyResult result;
};
/// A line for each range: how far shots scatter, and how likely each target is hit.
[[nodiscard]] std::string over_range_text(std::span<const StudyAtRange> list);
/// ... as records, which read the list.
[[nodiscard]] Records records_of(std::span<const StudyAtRange> list);
/// A row for each figure: its name, its value and its standard error.
[[nodiscard]] Records records_of(const FlownStudy& flown);

}  // namespace physim::report
