// Rows in saves: the numbers of a projectile that do not follow from its kind and its rung.
#include <cmath>

#include "solve/stops.hpp"
#include "world/core/placement.hpp"

namespace physim {
namespace {

/// Hands every number of a row that a save holds to f, as a reference to its column's, and whether it must be finite:
/// what the original's loop carries over need not be, where it retires its projectile in the next step.
template <class S, class F>
void each_number(const RowLayout& layout, const RowColumns<S>& c, std::uint32_t row, const F& f) {
  const auto each = [&](S* const* columns, std::size_t count, bool finite = true) {
    for (std::size_t i = 0; i < count; ++i) f(columns[i][row], finite);
  };
  each(c.position, 3), each(c.previous, 3), each(c.velocity, 3);
  if (layout.carried) each(c.carried, 3, false);
  if (layout.launched) each(c.launch, 3);
  if (layout.clocked) f(c.offset[row], true), f(c.born[row], true);
  if (layout.turning) each(c.turn, kNumbers<Turn>);
}

/// Gives a body the piece of its motor's table that comes `after` pieces after its first.
bool put_burn(const Conditions<double>& c, double after, Body<double>& body) {
  const auto first = static_cast<int>(body.burn_piece);
  if (after == 0) return true;
  if (!c.has_motor || !(after > 0 && after < 1e4) || after != std::floor(after)) return false;
  for (int piece = first; piece < first + static_cast<int>(after); ++piece)
    if (!std::isfinite(c.motor_pieces[piece].burn.end)) return false;  // the last one of its motor
  put_piece(c.motor_pieces, first + static_cast<int>(after), body, 0);
  return true;
}

/// Takes the force from a body whose save says that it is over; else it ends when that of its kind does.
bool put_force(const Body<double>& kind, Body<double>& body) {
  if (std::isfinite(body.applied_until)) return float(body.applied_until) == float(kind.applied_until);
  body.applied = {};
  return true;
}

/// Axes are frozen or free, and a plane of fire has a normal of length one.
bool constrains(const Conditions<double>& c, const Body<double>& body) {
  const auto is_switch = [](double x) { return x == 0 || x == 1; };
  const Vec3d& free = body.free;
  if (c.has_frozen && !(is_switch(free.x) && is_switch(free.y) && is_switch(free.z))) return false;
  return !c.fidelity.planar || std::abs(length_squared(body.plane) - 1) < 1e-5;
}

/// A fall in a vacuum has the horizontal velocity of its launch: kernels store the vertical one alone.
bool keeps_its_fall(const WorldCohort& cohort, const Rows& rows, std::uint32_t row) {
  if (cohort.static_rung == kNoStaticRung || cohort.key.fidelity.motion != Motion::closed_form || cohort.key.still)
    return true;
  return rows.visit([row](const auto& c) {
    const auto is_kept = [&](std::size_t axis) {
      return c.velocity[axis][row] == c.field[kBodyNumber.launch.v[static_cast<int>(axis)]][row];
    };
    return is_kept(0) && is_kept(2);
  });
}

}  // namespace

std::vector<double> Placement::saved_numbers(std::uint32_t index) const {
  const Slot& slot = state_.slots[index];
  const Rows& rows = state_.rows_of(slot);
  const RowLayout& layout = rows.layout();
  std::vector<double> numbers;
  rows.visit([&](const auto& c) {
    each_number(layout, c, slot.row, [&](auto& number, bool) { numbers.push_back(static_cast<double>(number)); });
    for (const std::uint8_t field : layout.own) numbers.push_back(static_cast<double>(c.field[field][slot.row]));
  });
  // The motor is stored as the piece of its table, counted from the first.
  const Body<double> body = body_of(slot);
  const double first = registry_.kind(slot.kind).rungs[slot.rung].body.burn_piece;
  if (layout.burning) numbers.push_back(body.burn_piece - first);
  return numbers;
}

bool Placement::put_saved(std::uint32_t index, const std::vector<double>& numbers) {
  const Slot& slot = state_.slots[index];
  const Rows& rows = state_.rows_of(slot);
  const RowLayout& layout = rows.layout();
  const Prepared& rung = registry_.kind(slot.kind).rungs[slot.rung];
  const Conditions<double>& c = registry_.cohort(slot.cohort).conditions;
  std::size_t at = 0;
  bool good = true;
  const auto next = [&] { return at < numbers.size() ? numbers[at++] : (good = false, 0.0); };
  rows.visit([&](const auto& columns) {
    each_number(layout, columns, slot.row, [&]<class S>(S& number, bool finite) {
      number = static_cast<S>(next());
      good = good && (!finite || std::isfinite(number));
    });
  });
  Body<double> body = rung.body;
  for (const std::uint8_t field : layout.own) good = !std::isnan(physim::numbers(body)[field] = next()) && good;
  if (c.has_force_end) good = put_force(rung.body, body) && good;
  if (layout.burning) good = put_burn(c, next(), body) && good;
  good = good && constrains(c, body);
  state_.rows_of(slot).write_fields(slot.row, body);
  good = good && keeps_its_fall(registry_.cohort(slot.cohort), rows, slot.row);
  if (layout.turning) rows.put_rotor(slot.row, *rung.rotor);
  rows.forget_clear(slot.row);
  return good && at == numbers.size();
}

}  // namespace physim
