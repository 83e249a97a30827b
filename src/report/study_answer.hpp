// What a study came to: text for people, JSON for programs, figures as records.
#pragma once

#include <cstdint>
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

/// The notes of a plan, with its settings by their paths in files.
[[nodiscard]] std::vector<std::string> notes_of(const StudyPlan& plan);

/// The unit of an input's number; empty where the study is of a function.
[[nodiscard]] std::string unit_of(const StudyInput& input);
/// "shot.speed [m/s]"; "shot.speed += [m/s]" of what is added.
[[nodiscard]] std::string with_unit(const StudyInput& input);
/// "right [m]"
[[nodiscard]] std::string with_unit(StudyQuantity quantity);

[[nodiscard]] Answer study_answer(const AskedShot& asked, const FlownStudy& flown, const Style& style);
/// True if a study ended before its figure was known to the width of --until-width.
[[nodiscard]] bool misses_width(const Study& study, const StudyResult& result);
/// One shot, by its number: what it drew and where it ended. Its shard is flown again; the numbers of shots and threads
/// do not change the result.
[[nodiscard]] Answer study_shot_answer(const AskedShot& asked, const StudyPlan& plan, std::uint64_t shot,
                                       const Style& style);
/// Points of impact of its shots as KML for globes: launch, mean impact, ellipses of 1, 2 and 3 deviations, the safety
/// zone, targets and a thousand shots, all on the ground. An error where shots end elsewhere, or the Earth is flat.
[[nodiscard]] Result<Text> study_kml(const AskedShot& asked, const FlownStudy& flown);

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
/// null: metres. Beside yards, feet and miles other lengths are in inches, else in metres. Ranges that were missed come
/// behind, without figures.
[[nodiscard]] std::string over_range_text(std::span<const StudyAtRange> list, const Unit* of_ranges = nullptr,
                                          std::span<const double> missed = {});
/// ... as records, which read the lists.
[[nodiscard]] Records records_of(std::span<const StudyAtRange> list, std::span<const double> missed = {});
struct Figure {
  std::string name;
  double value, error;  // NaN: not known
};
/// The names of a group of inputs.
[[nodiscard]] std::string names_of_inputs(const Study& study, const std::vector<std::size_t>& inputs);
/// Every figure of its end, without those over inputs.
[[nodiscard]] std::vector<Figure> figures_of(const FlownStudy& flown);
/// A row for each figure, with those over inputs, of histograms and of places.
[[nodiscard]] Records records_of(const FlownStudy& flown);

struct NamedHistogram {
  std::string name, unit;  // "right", "radius.aim", "extreme_spread.5"
  std::vector<HistogramBar> bars;
};
/// Histograms of quantities, of distances on the plane and in space, of extreme spreads; none if
/// FlownStudy::histogram_bars is zero.
[[nodiscard]] std::vector<NamedHistogram> histograms_of(const FlownStudy& flown);
/// Those of quantities, drawn with characters.
[[nodiscard]] std::string histograms_text(const FlownStudy& flown);

}  // namespace physim::report
