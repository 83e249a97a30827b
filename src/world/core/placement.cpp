// Where projectiles lie: their rows in cohorts, and moves between them.
#include "world/core/placement.hpp"
#include "base/assert.hpp"
#include "base/checker.hpp"
#include "prepare/launch.hpp"

namespace physim {
namespace {

/// What is on its way already, as if it were launched now.
Launch launch_of(const BodyState& at) {
  Launch launch;
  launch.position = at.position;
  launch.velocity = at.velocity;
  return launch;
}

/// What a row is filled with beside its state and body.
struct RowNumbers {
  double now;  // number of the coming step
  double age;  // time since launch [s]
  const Vec3d& previous;
  const Rotor<double>* rotor;  // of a rung that turns
};

void put_row(Rows& rows, std::uint32_t row, const BodyState& at, const Body<double>& body, const RowNumbers& n) {
  PHYSIM_ASSERT(row < rows.size());
  const RowLayout& layout = rows.layout();
  rows.visit([&]<class S>(const RowColumns<S>& c) {
    Rows::put(c.position, row, at.position);
    Rows::put(c.previous, row, n.previous);
    Rows::put(c.velocity, row, at.velocity);
    if (layout.carried) Rows::put(c.carried, row, {});
    if (layout.launched) Rows::put(c.launch, row, at.position);
    if (layout.turning) rows.put_rotor(row, *n.rotor);
    rows.forget_clear(row);
    if (!layout.clocked) return;
    c.offset[row] = static_cast<S>(n.age);
    c.born[row] = static_cast<S>(n.now);
  });
  rows.write_fields(row, body);
}

}  // namespace

std::uint16_t Placement::cohort_for(const Slot& slot) {
  const std::uint16_t known = registry_.kind(slot.kind).on(slot.rung).cohort[slot.variant().index()];
  if (known < state_.rows.size()) return known;
  const std::uint16_t index = registry_.cohort(slot.kind, slot.rung, slot.variant());
  if (index == kNoCohort) return index;
  while (state_.rows.size() < registry_.cohorts())
    state_.rows.emplace_back(registry_.cohort(static_cast<std::uint16_t>(state_.rows.size())).layout);
  return index;
}

void Placement::place(std::uint32_t index, const BodyState& at, const Launch& launch, double elevation,
                      std::optional<double> birth) {
  Slot& slot = state_.slots[index];
  PHYSIM_ASSERT(slot.is(kAlive) && slot.cohort < state_.rows.size());
  slot.row = state_.rows[slot.cohort].push(index);
  write_row(index, at, {.previous = at.position, .launch = &launch, .elevation = elevation, .birth = birth});
  if (state_.rows_of(slot).layout().turning)
    set_attitude(index, attitude_at_launch(slot, at.velocity, launch, elevation));
  PHYSIM_ASSERT(state_.rows_of(slot).is_filled(slot.row));
}

void Placement::depart(std::uint32_t index, const Departure& from) {
  const Slot& slot = state_.slots[index];
  const Rows& rows = state_.rows_of(slot);
  const bool goes_on =
      rows.layout().clocked && registry_.cohort(slot.cohort).key.fidelity.motion != Motion::closed_form;
  Body<double> body = body_of(slot);
  body.spin = from.spin;
  write_row(index, {from.position, from.velocity},
            {.previous = from.position, .old = &body, .age = goes_on ? from.age : 0});
  if (rows.layout().turning)
    set_attitude(index, from.attitude ? Attitude{from.attitude->orientation, from.attitude->angular_velocity}
                                      : attitude_at_launch(slot, from.velocity, Launch{}, 0));
}

// ------------------------------------------------------------------------------------------- rotation
Attitude Placement::attitude_at_launch(const Slot& slot, const Vec3d& velocity, const Launch& launch,
                                       double elevation) const {
  return prepare_attitude(registry_.kind(slot.kind).flown, launch, elevation, velocity,
                          registry_.cohort(slot.cohort).conditions);
}

std::optional<Attitude> Placement::attitude(std::uint32_t index) const {
  const Slot& slot = state_.slots[index];
  const Rows& rows = state_.rows_of(slot);
  if (!rows.layout().turning) return std::nullopt;
  const BodyState now = state_.state_of(slot);
  return attitude_of(registry_.cohort(slot.cohort).conditions, body_of(slot), rows.rotor(slot.row), clock_of(slot),
                     {now.position, now.velocity}, rows.turn(slot.row));
}

void Placement::set_attitude(std::uint32_t index, const Attitude& attitude) {
  const Slot& slot = state_.slots[index];
  const Rows& rows = state_.rows_of(slot);
  rows.put_turn(slot.row, turn_of(registry_.cohort(slot.cohort).key.fidelity,
                                  *registry_.kind(slot.kind).on(slot.rung).rotor, attitude));
}

void Placement::stop_turning(std::uint32_t index) {
  if (auto now = attitude(index)) set_attitude(index, {now->q_WB, omega_of_W(state_.slots[index], now->q_WB)});
}

Vec3d Placement::omega_of_W(const Slot& slot, const Quatd& q_WB) const {
  const Conditions<double>& c = registry_.cohort(slot.cohort).conditions;
  return is_turning(c.fidelity.earth) ? rotate(conjugate(q_WB), c.omega) : Vec3d{};
}

void Placement::write_row(std::uint32_t index, const BodyState& given, const RowStart& start) {
  const Slot& slot = state_.slots[index];
  PHYSIM_ASSERT(slot.rung < registry_.kind(slot.kind).rungs.size());
  PHYSIM_ASSERT(finite(given.position) && finite(given.velocity));
  const Prepared& rung = registry_.kind(slot.kind).on(slot.rung);
  PHYSIM_ASSERT(state_.rows_of(slot).slot(slot.row) == index);
  const RowNumbers numbers{state_.clock.now(), start.age, start.previous, rung.rotor.get()};
  const bool special =
      slot.is(kOwn) || rung.in_use.fidelity.planar || rung.equivalent_drag || state_.rows_of(slot).layout().clocked;
  if (!special) return put_row(state_.rows_of(slot), slot.row, given, rung.body, numbers);
  BodyState at = given;
  const Body<double> body = special_body(index, at, start);
  put_row(state_.rows_of(slot), slot.row, at, body, numbers);
}

/// The numbers of a projectile that differ from others of its kind and rung: by its switches or by its launch. What of
/// its velocity its rung does not have is taken away. A rung that knows no spin or no rail forgets it.
Body<double> Placement::special_body(std::uint32_t index, BodyState& at, const RowStart& start) {
  const Slot& slot = state_.slots[index];
  const Prepared& rung = registry_.kind(slot.kind).on(slot.rung);
  const Conditions<double>& c = registry_.cohort(slot.cohort).conditions;
  const Own& mine = state_.extras.own_of(index);
  Body<double> body = rung.body;
  for (const OwnPart& part : kOwnParts)
    if (slot.is(part.flag)) part.put(mine, body);
  body.launch = {at.position, at.velocity};
  if (c.fidelity.planar || spins(c.fidelity) || has_stops(c)) {
    const Launch launch = start.launch ? *start.launch : launch_of(at);
    put_launch(launch, sight_frame(launch), start.elevation, c.fidelity, body);
  }
  at.velocity = body.launch.v = component_product(body.launch.v, body.free);
  body.birth = start.birth.value_or(state_.clock.time() - start.age);
  if (rung.equivalent_drag) body.k2_per_mass = rung.equivalent_drag->k2_per_mass(body.launch, body.birth);
  if (start.old) {
    body.spin = start.old->spin;
    body.rail = start.old->rail;
    body.rail_end = start.old->rail_end;
    body.rail_phase = start.old->rail_phase;
  }
  if (!has_stops(c)) return body;
  State<double> s{at.position, at.velocity};
  pass_stops(c, start.age, true, s, body);
  return body;
}

void Placement::set_row_state(std::uint32_t index, const BodyState& given) {
  const Slot& slot = state_.slots[index];
  BodyState at = given;
  if (slot.is(kOwn)) at.velocity = component_product(at.velocity, free_axes(state_.extras.own_of(index).frozen));
  const bool closed = registry_.cohort(slot.cohort).key.fidelity.motion == Motion::closed_form;
  if (closed) return refill_row(index, at, {.previous = at.position});  // the clock starts again
  state_.rows_of(slot).visit([&](const auto& c) {
    Rows::put(c.position, slot.row, at.position);
    Rows::put(c.velocity, slot.row, at.velocity);
  });
  state_.rows_of(slot).forget_clear(slot.row);
}

void Placement::jump(std::uint32_t index, const BodyState& to) {
  const Slot& slot = state_.slots[index];
  const Rows& rows = state_.rows_of(slot);
  const Vec3d way = rows.previous(slot.row) - rows.position(slot.row);
  set_row_state(index, to);
  rows.visit([&](const auto& c) { Rows::put(c.previous, slot.row, to.position + way); });
}

void Placement::refill_row(std::uint32_t index, const BodyState& at, const RowStart& start) {
  const Slot& slot = state_.slots[index];
  const Rows& rows = state_.rows_of(slot);
  if (!rows.layout().launched) return write_row(index, at, start);
  const Vec3d launch = rows.visit([&](const auto& c) { return Rows::at(c.launch, slot.row); });
  write_row(index, at, start);
  rows.visit([&](const auto& c) { Rows::put(c.launch, slot.row, launch); });
}

void Placement::take_out(Slot& slot) {
  PHYSIM_ASSERT(&state_.slots[state_.rows_of(slot).slot(slot.row)] == &slot);
  const std::uint32_t moved = state_.rows_of(slot).swap_remove(slot.row);
  if (moved != 0) state_.slots[moved].row = slot.row;
}

Status Placement::relocate(std::uint32_t index) {
  Slot& slot = state_.slots[index];
  const std::uint16_t to = cohort_for(slot);
  if (to == kNoCohort) return Error{"there are too many different rungs and rules", "world", "at most 65535"};
  if (to == slot.cohort) return {};
  const std::uint16_t from = slot.cohort;
  const std::uint32_t old_row = slot.row;
  Rows& source = state_.rows[from];
  // Each interpolation has its own curves: a row's place among them does not hold for another.
  const auto curves = [this](std::uint16_t cohort) { return registry_.cohort(cohort).key.fidelity.interpolation; };
  // Nor does a Turn for another rotation model.
  const auto rotation = [this](std::uint16_t cohort) {
    const Fidelity& f = registry_.cohort(cohort).key.fidelity;
    return std::pair(f.rotation, f.body_form);
  };
  const bool same_turn = !source.layout().turning || rotation(from) == rotation(to);
  if (source.layout() == state_.rows[to].layout() && curves(from) == curves(to) && same_turn) {
    const std::uint32_t row = state_.rows[to].push_copy(source, old_row);
    take_out(slot);
    slot.cohort = to;
    slot.row = row;
    if (ClosedFormLaw(registry_.cohort(from)) != ClosedFormLaw(registry_.cohort(to))) relaunch(index);
    return {};
  }
  const RowLayout& layout = state_.rows[to].layout();
  const bool goes_on = layout.clocked && registry_.cohort(to).key.fidelity.motion != Motion::closed_form;
  const double age = goes_on ? clock_of(slot) : 0;
  const Conditions<double>& there = registry_.cohort(to).conditions;
  Unset<Body<double>> body;  // not cleared: that alone would be a third of a move
  const Body<double>* old = nullptr;
  if (spins(there.fidelity) || has_stops(there)) *body = body_of(slot), old = &*body;  // spin and rail go along
  const BodyState at{source.position(old_row), source.velocity(old_row)};
  const Vec3d previous = source.previous(old_row);
  Vec3d launch{}, carried{};
  const std::optional<Attitude> turned = source.layout().turning ? attitude(index) : std::nullopt;
  if (source.layout().launched) launch = source.visit([&](const auto& c) { return Rows::at(c.launch, old_row); });
  if (source.layout().carried) carried = source.visit([&](const auto& c) { return Rows::at(c.carried, old_row); });
  take_out(slot);
  slot.cohort = to;
  slot.row = state_.rows[to].push(index);
  write_row(index, at, {.previous = previous, .old = old, .age = age});
  if (layout.turning) set_attitude(index, turned ? *turned : attitude_at_launch(slot, at.velocity, Launch{}, 0));
  if (layout.launched) state_.rows[to].visit([&](const auto& c) { Rows::put(c.launch, slot.row, launch); });
  if (layout.carried) state_.rows[to].visit([&](const auto& c) { Rows::put(c.carried, slot.row, carried); });
  PHYSIM_ASSERT(state_.rows_of(slot).is_filled(slot.row));
  return {};
}

/// Launches a closed form again at its place; from its launch it keeps what is not part of the law. Other motions
/// continue unchanged.
void Placement::relaunch(std::uint32_t index) {
  const Slot& slot = state_.slots[index];
  if (registry_.cohort(slot.cohort).key.fidelity.motion != Motion::closed_form) return;
  Rows& rows = state_.rows_of(slot);
  const BodyState at = state_.state_of(slot);
  Body<double> body = body_of(slot);
  body.launch = {at.position, at.velocity};
  body.damping_rate = registry_.kind(slot.kind).on(slot.rung).body.damping_rate;
  rows.visit([&]<class S>(const RowColumns<S>& c) {
    c.offset[slot.row] = S(0);
    c.born[slot.row] = static_cast<S>(state_.clock.now());
  });
  rows.write_fields(slot.row, body);
}

std::vector<ClosedFormLaw> Placement::closed_forms() const {
  std::vector<ClosedFormLaw> laws;
  for (std::uint16_t cohort = 0; cohort < state_.rows.size(); ++cohort) laws.emplace_back(registry_.cohort(cohort));
  return laws;
}

void Placement::follow_environment(std::uint32_t index, const std::vector<ClosedFormLaw>& before) {
  const Slot& slot = state_.slots[index];
  const std::uint16_t from = slot.cohort;
  relocate(index);
  if (before[from] != ClosedFormLaw(registry_.cohort(slot.cohort))) relaunch(index);
}

void Placement::rewrite_row(std::uint32_t index) {
  const Slot& slot = state_.slots[index];
  const bool goes_on =
      state_.rows_of(slot).layout().clocked && registry_.cohort(slot.cohort).key.fidelity.motion != Motion::closed_form;
  const Body<double> old = body_of(slot);
  const Rows& rows = state_.rows_of(slot);
  Vec3d carried{};
  if (rows.layout().carried) carried = rows.visit([&](const auto& c) { return Rows::at(c.carried, slot.row); });
  refill_row(index, state_.state_of(slot),
             {.previous = rows.previous(slot.row), .old = &old, .age = goes_on ? clock_of(slot) : 0});
  if (rows.layout().carried) rows.visit([&](const auto& c) { Rows::put(c.carried, slot.row, carried); });
}

Body<double> Placement::body_of(const Slot& slot) const {
  Body<double> body = registry_.kind(slot.kind).on(slot.rung).body;
  state_.rows_of(slot).read_fields(slot.row, body);
  if (registry_.cohort(slot.cohort).conditions.has_force_end) pass_force(clock_of(slot), true, body);  // it may rest
  return body;
}

double Placement::clock_of(const Slot& slot) const {
  return state_.rows_of(slot).layout().clocked ? state_.row_clock(slot)
                                               : state_.clock.time() - state_.slots.birth(state_.slots.index_of(slot));
}

/// Rows count steps of one length, as whole numbers that a float holds: when the length changes, or the numbers grow
/// too large, they count from now on.
void Placement::rebase(double new_dt) {
  Clock& clock = state_.clock;
  const bool new_length = new_dt != clock.dt;
  constexpr std::uint64_t kMostSteps = 1u << 22;
  const std::uint64_t shift = clock.steps - clock.epoch;
  if (!new_length && shift < kMostSteps) return;
  for (Rows& rows : state_.rows) {
    if (!rows.layout().clocked) continue;
    rows.visit([&]<class S>(const RowColumns<S>& c) {
      const S now = static_cast<S>(shift);
      for (std::uint32_t row = 0; row < rows.size(); ++row) {
        if (new_length) {
          c.offset[row] += (now - c.born[row]) * static_cast<S>(clock.dt);
          c.born[row] = S(0);
        } else {
          c.born[row] -= now;
        }
      }
    });
  }
  clock.start_epoch();
  if (new_length) clock.start_run(new_dt);
}

bool is_in_place(const Registry& registry, const WorldState& state, std::uint16_t cohort, std::uint32_t row) {
  const Slot& slot = state.slots[state.rows[cohort].slot(row)];
  const Prepared& rung = registry.kind(slot.kind).on(slot.rung);
  const std::uint16_t known = rung.cohort[slot.variant().index()];  // none if its environment was set again
  return slot.is(kAlive) && !slot.is(kStill) && slot.cohort == cohort && slot.row == row &&
         (known == cohort || known == kNoCohort);
}

}  // namespace physim
