// Where a step of a row crosses heights over a flat Earth, found by heights alone: the same search on the same numbers
// as solve/watch.hpp, without those of a state that it does not read.
#pragma once

#include "solve/judge.hpp"

namespace physim {

/// The dense output of a step as far as a search for heights reads it: of states their height and climb.
template <class S>
struct DenseHeight {
  const DenseLanes<S>& whole;
  const Body<double>& body = whole.body;
  const Node& n0 = whole.n0;
  const Node& n1 = whole.n1;

  /// Whether it gives the same results as `whole` for steps under these conditions.
  [[nodiscard]] static bool holds(const Conditions<double>& c) {
    const Fidelity& f = c.fidelity;
    return !is_round(f.earth) && f.motion != Motion::closed_form && f.integrator != Integrator::classic &&
           dense_coefficient_count(f.integrator) == 0;
  }
  /// As dense_state().
  PHYSIM_INLINE State<double> operator()(double theta) const {
    const double part = stagger(whole.conditions->fidelity);
    const State<double> inside = part != 0 ? staggered_hermite(part, n0, n1, theta) : hermite(n0, n1, theta);
    State<double> s{};
    s.x.y = select(theta == 0.0, n0.y.x.y, select(theta == 1.0, n1.y.x.y, inside.x.y));
    s.v.y = select(theta == 0.0, n0.y.v.y, select(theta == 1.0, n1.y.v.y, inside.v.y));
    return s;
  }
  PHYSIM_INLINE double time(double theta) const { return whole.time(theta); }
  /// The rate of a height does not read it.
  PHYSIM_INLINE Vec3d acceleration(double, const State<double>&) const { return {}; }
  PHYSIM_INLINE double watched_at_start(const EventSpec& spec) const { return whole.watched_at_start(spec); }
  PHYSIM_INLINE double watched_at_end(const EventSpec& spec) const { return whole.watched_at_end(spec); }
};

PHYSIM_INLINE bool is_by_height(const EventSpec& spec) {
  const Watch watch = row_of(spec.kind).watch;
  return watch == Watch::height || watch == Watch::climb_rate;
}

/// Whether a row's step crosses something, as far as that shows before its dense output is there: heights and climbs
/// are equal numbers in both precisions.
template <class S>
[[nodiscard]] bool may_cross(const Course<S>& course, const Lanes<S>& l) {
  const Conditions<S>& c = *course.conditions;
  if (!DenseHeight<S>::holds(*course.conditions_double)) return true;
  for (int i = 0; i < course.watch.count; ++i)
    if (!is_by_height(course.watch.item[i].spec)) return true;
  const Vec3<S>& last = l.step.slope[last_slope(c.fidelity)].v;
  return detect(c, l.body, course.watch, l.step, l.step.slope[0].v, last).some;
}

/// As find_crossings() finds them, of a row's step that is sound.
template <class S>
void find_row_crossings(const Course<S>& course, Judgement<S>& j) {
  const Conditions<double>& c = *course.conditions_double;
  if (!DenseHeight<S>::holds(c)) return find_crossings<S>(course, true, j);
  CrossingList& list = j.crossings[0];
  list.count = 0;
  const DenseHeight<S> heights{j.at};
  for (int i = 0; i < course.watch.count; ++i) {
    const EventSpec& spec = course.watch.item[i].spec;
    if (is_by_height(spec))
      CrossingFinder<double, DenseHeight<S>>{c, spec, i, heights, &list}.find(true);
    else
      CrossingFinder<double, DenseLanes<S>>{c, spec, i, j.at, &list}.find(true);
  }
  list.put_in_order(course.watch);
}

}  // namespace physim
