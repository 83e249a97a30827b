// Correlations of the points of a list by their distance: a curve that was measured is off by much the same at points
// that are near each other.
//
// Symbols: C correlation of two points; d distance of their places; l length of correlation, both in their unit.
// Equation: C = exp(-d / l), which is positive definite for any points at different places.
// Source: C. E. Rasmussen, C. K. I. Williams, Gaussian Processes for Machine Learning (2006), sec. 4.2.1 (Matern class
//   with nu = 1/2, of an Ornstein-Uhlenbeck process).
#include <algorithm>
#include <cmath>

#include "base/checker.hpp"
#include "base/text.hpp"
#include "math/elementary.hpp"
#include "physim/study.hpp"
#include "study/paths.hpp"

namespace physim {
namespace {

struct DrawnPoint {
  std::size_t point;  // of the list
  std::size_t input;  // the first that is drawn for it
  double place;
};

Result<std::vector<DrawnPoint>> drawn_points(const Study& study, const PathRow& list, const PathRow& places) {
  Shot shot{study.projectile, study.launch};
  Environment environment = study.environment;
  std::vector<DrawnPoint> drawn;
  for (std::size_t i = 0; i < study.inputs.size(); ++i) {
    const std::string& name = study.inputs[i].path;
    const FoundPath path = find_path(name);
    if (path.row != &list || std::ranges::count(drawn, path.point, &DrawnPoint::point) > 0) continue;
    const double* place = FoundPath{&places, path.point}.point_of(shot, environment);
    if (!place) return Error{name + " names no point of its list", "list", ""};
    const auto there = std::ranges::find(drawn, *place, &DrawnPoint::place);
    if (there != drawn.end())
      return Error{name + " stands where " + study.inputs[there->input].path + " does", "list",
                   "points of one place have no distance; correlate them by their names"};
    drawn.push_back({path.point, i, *place});
  }
  if (drawn.size() < 2)
    return Error{"fewer than two points of " + list.path + " are drawn", "list", "draw more of them in the inputs"};
  return drawn;
}

}  // namespace

Result<StudyCorrelation> correlated_by_distance(const Study& study, std::string_view list, double length) {
  const auto places = places_of_list(list);
  if (!places) return places.error();
  Checker c;
  c.positive(length, "length", "at which correlations have fallen to 1/e");
  if (const Status status = c.status(); !status) return status.error();
  const auto points = drawn_points(study, *find_list(list), **places);
  if (!points) return points.error();
  StudyCorrelation with;
  for (const DrawnPoint& a : *points) {
    with.inputs.push_back(a.input);
    for (const DrawnPoint& b : *points) with.matrix.push_back(exp(-std::abs(a.place - b.place) / length));
  }
  return with;
}

}  // namespace physim
