// Source: model/aero_tables.hpp, which also describes the layout.
#include "model/aero_tables.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace physim {
namespace {

using Row = std::array<double, 4>;

constexpr double kNever = std::numeric_limits<double>::quiet_NaN();  // a border that nothing passes, not infinity
constexpr int kFinest = 14;                                          // buckets are 2^-14 wide at most finely

const std::array<AeroCoefficient AeroDef::*, 10> kCoefficients = {
    &AeroDef::drag_yaw,       &AeroDef::lift,         &AeroDef::lift_cubic,    &AeroDef::pitching,
    &AeroDef::pitching_cubic, &AeroDef::roll_damping, &AeroDef::pitch_damping, &AeroDef::yaw_damping,
    &AeroDef::magnus_force,   &AeroDef::magnus_moment};

/// A body without yaw damping has that in pitch.
const AeroCoefficient& coefficient(const AeroDef& aero, std::size_t i) {
  const AeroCoefficient& own = aero.*kCoefficients[i];
  return &own == &aero.yaw_damping && own.empty() ? aero.pitch_damping : own;
}

std::vector<double> mach_borders(const AeroDef& aero) {
  std::vector<double> all;
  for (const auto member : kCoefficients)
    for (const AeroPoint& p : aero.*member) all.push_back(p.mach);
  return rising(std::move(all));
}
std::vector<double> angle_borders(const AeroCoefficient& c) {
  std::vector<double> all;
  for (const AeroPoint& p : c) all.push_back(p.angle_squared);
  return rising(std::move(all));
}

std::optional<ClosePair> too_close(const std::vector<double>& borders) {
  for (std::size_t i = 1; i < borders.size(); ++i)
    if (borders[i] - borders[i - 1] < kClosestAeroPoints) return ClosePair{borders[i - 1], borders[i]};
  return std::nullopt;
}

bool holds_two(const std::vector<double>& borders, double scale) {
  for (std::size_t i = 1; i < borders.size(); ++i)
    if (std::floor(borders[i] * scale) == std::floor(borders[i - 1] * scale)) return true;
  return false;
}

/// Buckets from 0 on that lead to the number of borders passed.
Buckets<double> add_buckets(const std::vector<double>& borders, TablePool& pool) {
  double scale = 1;
  for (int power = 0; power < kFinest && holds_two(borders, scale); ++power) scale *= 2;
  PHYSIM_ASSERT(!holds_two(borders, scale));
  const double last = borders.empty() ? 0 : std::floor(borders.back() * scale) + 1;
  std::vector<Row> rows;
  std::size_t passed = 0;
  for (double bucket = 0; bucket <= last; ++bucket) {
    const double start = bucket / scale, end = (bucket + 1) / scale;
    while (passed < borders.size() && borders[passed] <= start) ++passed;
    const bool inside = passed < borders.size() && borders[passed] < end;
    rows.push_back({static_cast<double>(passed), inside ? borders[passed] : kNever, 0, 0});
  }
  return {pool.add_rows(rows), scale, last};
}

/// a + b x through the values of f at the ends of cell i of some borders; constant in the first and the last cell.
struct Line {
  double a, b;
};
Line line_in_cell(const std::vector<double>& borders, std::size_t i, const auto& f) {
  PHYSIM_ASSERT(i <= borders.size());
  if (borders.empty()) return {f(0.0), 0};
  if (i == 0 || i == borders.size()) return {f(i == 0 ? borders.front() : borders.back()), 0};
  const double x0 = borders[i - 1], x1 = borders[i];
  const double slope = (f(x1) - f(x0)) / (x1 - x0);
  return {f(x0) - slope * x0, slope};
}

AngleTable<double> add_angle_table(const AeroCoefficient& c, const std::vector<double>& mach, TablePool& pool) {
  const auto angles = angle_borders(c);
  AngleTable<double> table;
  table.buckets = add_buckets(angles, pool);
  table.cells = static_cast<double>(angles.size() + 1);
  std::vector<Row> rows;
  for (std::size_t i = 0; i <= mach.size(); ++i)
    for (std::size_t j = 0; j <= angles.size(); ++j) {
      const auto at = [&](double m) {
        return line_in_cell(angles, j, [&](double a) { return coefficient_at(c, m, a); });
      };
      const Line constant = line_in_cell(mach, i, [&](double m) { return at(m).a; });
      const Line slope = line_in_cell(mach, i, [&](double m) { return at(m).b; });
      rows.push_back({constant.a, slope.a, constant.b, slope.b});
    }
  PHYSIM_ASSERT(rows.size() == (mach.size() + 1) * (angles.size() + 1));
  table.row = pool.add_rows(rows);
  return table;
}

/// The points of one Mach number, first to last.
struct Section {
  std::size_t first, last;
};
Section section_of(const AeroCoefficient& c, std::size_t first) {
  std::size_t last = first;
  while (last + 1 < c.size() && c[last + 1].mach == c[first].mach) ++last;
  return {first, last};
}
double in_section(const AeroCoefficient& c, const Section& s, double angle_squared) {
  PHYSIM_ASSERT(s.first <= s.last && s.last < c.size());
  if (angle_squared <= c[s.first].angle_squared) return c[s.first].value;
  for (std::size_t i = s.first; i < s.last; ++i) {
    const AeroPoint &p = c[i], &q = c[i + 1];
    if (angle_squared < q.angle_squared)
      return p.value + (q.value - p.value) * ((angle_squared - p.angle_squared) / (q.angle_squared - p.angle_squared));
  }
  return c[s.last].value;
}

}  // namespace

double coefficient_at(const AeroCoefficient& c, double mach, double angle_squared) {
  if (c.empty()) return 0;
  Section below = section_of(c, 0);
  if (mach <= c.front().mach) return in_section(c, below, angle_squared);
  while (below.last + 1 < c.size()) {
    const Section above = section_of(c, below.last + 1);
    const double m0 = c[below.first].mach, m1 = c[above.first].mach;
    if (mach < m1) {
      const double v0 = in_section(c, below, angle_squared), v1 = in_section(c, above, angle_squared);
      return v0 + (v1 - v0) * ((mach - m0) / (m1 - m0));
    }
    below = above;
  }
  return in_section(c, below, angle_squared);
}

std::optional<ClosePair> mach_numbers_too_close(const AeroDef& aero) { return too_close(mach_borders(aero)); }
std::optional<ClosePair> angles_too_close(const AeroCoefficient& c) { return too_close(angle_borders(c)); }

bool has_aero(const AeroDef& aero) {
  return std::any_of(kCoefficients.begin(), kCoefficients.end(), [&](auto c) { return !(aero.*c).empty(); });
}
bool has_aero_tables(const AeroDef& aero) {
  return std::any_of(kCoefficients.begin(), kCoefficients.end(), [&](auto c) { return (aero.*c).size() > 1; });
}
bool has_aero_angles(const AeroDef& aero, const Fidelity& rung) {
  const bool moment = !is_in_repose(rung) && angle_borders(aero.magnus_moment).size() > 1;
  return moment || angle_borders(aero.magnus_force).size() > 1;
}

PHYSIM_COLD void add_aero(const AeroDef& aero, TablePool& pool, Rotor<double>& r) {
  static_assert(kCoefficients.size() == kNumbers<physim::AeroCoefficients>);
  double* constants = numbers(r.coefficient);
  for (std::size_t i = 0; i < kCoefficients.size(); ++i) constants[i] = coefficient_at(coefficient(aero, i), 0, 0);
  if (const AeroPlace* known = pool.find(aero)) {
    r.mach = known->mach, r.mach_row = known->mach_row;
    r.magnus_force = known->magnus_force, r.magnus_moment = known->magnus_moment;
    return;
  }
  const auto mach = mach_borders(aero);
  r.mach = add_buckets(mach, pool);
  std::vector<Row> rows;
  for (std::size_t cell = 0; cell <= mach.size(); ++cell)
    for (std::size_t pair = 0; pair < kNumbers<RowCoefficients>; pair += 2) {
      const auto line = [&](std::size_t i) {
        return line_in_cell(mach, cell, [&](double m) { return coefficient_at(coefficient(aero, i), m, 0); });
      };
      const Line first = line(pair), second = line(pair + 1);
      rows.push_back({first.a, first.b, second.a, second.b});
    }
  PHYSIM_ASSERT(rows.size() == (mach.size() + 1) * kNumbers<RowCoefficients> / 2);
  r.mach_row = pool.add_rows(rows);
  r.magnus_force = add_angle_table(aero.magnus_force, mach, pool);
  r.magnus_moment = add_angle_table(aero.magnus_moment, mach, pool);
  pool.remember(aero, {r.mach, r.mach_row, r.magnus_force, r.magnus_moment});
}

}  // namespace physim
