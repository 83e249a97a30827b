// Histograms of a study: of its quantities, of distances on the plane and in space, of extreme spreads.
#pragma once

#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "report/study_answer.hpp"

namespace physim::report {

struct NamedHistogram {
  std::string name, unit;  // "right", "radius.aim", "extreme_spread.5"
  std::vector<HistogramBar> bars;
};

/// Empty if FlownStudy::histogram_bars is zero.
[[nodiscard]] std::vector<NamedHistogram> histograms_of(const FlownStudy& flown);
/// Those of quantities, drawn with characters.
[[nodiscard]] std::string histograms_text(const FlownStudy& flown);
[[nodiscard]] nlohmann::ordered_json histograms_json(const FlownStudy& flown);

}  // namespace physim::report
