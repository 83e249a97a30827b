// What a study shows, as plain data: its face with ellipses and targets, how figures settle, and figures as texts.
#pragma once

#include <string>
#include <vector>

#include "simclient/core/plot_data.hpp"
#include "simclient/core/study_run.hpp"

namespace physim::client {

/// The plane of impact as it is drawn, in a frame of `aspect`, its width over its height.
struct StudyFace {
  PlotAxis across, up;  // of one quantity alone: `up` counts shots [%] in each cell, and there are no `cells_up`
  double stretch = 1;   // lengths upwards are drawn so many times as large as those across
  std::vector<std::vector<PlanePoint>> targets, ellipses;  // closed rims; of 1, 2 and 3 deviations
  std::vector<double> cells_across, cells_up;              // shots [%] in equal cells of each axis
  PlanePoint aim;

  [[nodiscard]] bool shows(const PlanePoint& p) const {
    return p.right >= across.low && p.right <= across.high && p.up >= up.low && p.up <= up.high;
  }
};
[[nodiscard]] StudyFace face_of(const Study& study, const StudyResult& result, double aspect);

/// In words, what a place has not that the end of its study has: a plane, targets, shots; empty: it has all.
[[nodiscard]] std::string lacking_at(const StudyTold& place, const Study& study);

/// A figure as shots add up, with its 95 % interval. Without one its ends are its value.
struct Settling {
  struct Point {
    double shots = 0, value = 0, low = 0, high = 0;
  };
  std::string label;  // "hits on plate [%]"
  std::vector<Point> points;
  PlotAxis shots, value;  // shots: powers of ten

  /// Where a count of shots lies on its axis, which is logarithmic.
  [[nodiscard]] double part(double count) const;
};
/// The hit probability of the first target, where there is one; then the mean distance from the aim, or the mean of the
/// first quantity.
[[nodiscard]] std::vector<Settling> settling_of(const StudyResult& result, int wanted_ticks);

/// A line of the list of figures.
struct StudyFigure {
  std::string what, value, error;  // error: standard error, or an interval; may be empty
};
/// Counts, means, CEP and R95, hits: the digits of `physim study`.
[[nodiscard]] std::vector<StudyFigure> figures_of(const StudyResult& result);

/// What one input does.
struct StudyInputRow {
  std::string path, deviation;
  std::string effect[2];     // of a deviation on the first two quantities; empty: there is none
  double share[2] = {0, 0};  // of their variance [-]
};
[[nodiscard]] std::vector<StudyInputRow> input_rows(const Study& study, const StudyResult& result,
                                                    const LinearResult& linear);

}  // namespace physim::client
