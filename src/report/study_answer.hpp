// What a study came to: text for people, JSON for programs, figures as records.
#pragma once

#include <optional>
#include <span>
#include <string>
#include <vector>

#include "physim/study.hpp"
#include "report/answer.hpp"
#include "report/records.hpp"
#include "settings/units.hpp"
#include "study/quantities.hpp"

namespace physim::report {

/// A study that was flown.
struct FlownStudy {
  StudyPlan plan;
  StudyResult result;
  std::optional<LinearResult> linear{};  // where it could be computed
  std::size_t histogram_bars = 0;        // 0: no histograms are told
  std::vector<FlownStudy> at{};          // as it is at each of Study::at
  std::vector<const Unit*> units{};      // of each input, as it was written; null: that of SI
};
/// A flown study with its slopes, and the same at each place. `texts`: the inputs as the file and the options have
/// them, in any order.
[[nodiscard]] FlownStudy told_study(const StudyPlan& plan, StudyResult result, std::size_t histogram_bars,
                                    std::span<const std::string> texts = {});
/// "800 m", "height 100 m falling": what the i-th place is called.
[[nodiscard]] std::string name_of_place(const FlownStudy& flown, std::size_t i);

/// The unit of an input's number; empty where the study is of a function.
[[nodiscard]] std::string unit_of(const StudyInput& input);
/// "shot.speed [m/s]"; "shot.speed += [m/s]" of what is added.
[[nodiscard]] std::string with_unit(const StudyInput& input);
/// "right [m]"
[[nodiscard]] std::string with_unit(StudyQuantity quantity);

[[nodiscard]] Answer study_answer(const AskedShot& asked, const FlownStudy& flown, const Style& style);
/// True if a study ended before its figure was known to the width of --until-width.
[[nodiscard]] bool misses_width(const Study& study, const StudyResult& result);
/// A study with its plane of impact at a range [m].
struct StudyAtRange {
  double range;
  StudyResult result;
  PlanePoint held;  // how far the sight is held off for what is known of wind and drift [m]
};
/// The ranges among the places of a study, and its end where it has a range, in their order: those with a plane across
/// the line of sight.
[[nodiscard]] std::vector<StudyAtRange> ranges_of(const FlownStudy& flown);
/// A line for each range: how far shots scatter, and how likely each target is hit. Ranges have a unit of lengths,
/// null: metres. Beside yards, feet and miles other lengths are in inches, else in metres.
[[nodiscard]] std::string over_range_text(std::span<const StudyAtRange> list, const Unit* of_ranges = nullptr);
/// ... as records, which read the list.
[[nodiscard]] Records records_of(std::span<const StudyAtRange> list);
/// A row for each figure: its name, its value and its standard error.
[[nodiscard]] Records records_of(const FlownStudy& flown);

}  // namespace physim::report
