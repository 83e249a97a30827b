// What comes next: flights that go on from where projectiles of a world are, and projectiles from flights.
#include <algorithm>
#include <cmath>

#include "base/checker.hpp"
#include "base/ieee_mode.hpp"
#include "base/restored.hpp"
#include "flight/under_way.hpp"
#include "flight/zero.hpp"
#include "math/elementary.hpp"
#include "model/sight.hpp"
#include "prepare/check.hpp"
#include "world/couple/world_impl.hpp"
#include "world/step/drive.hpp"

namespace physim {
namespace {

/// What the generators of a world, as they are now, will do to one projectile.
class WorldPushes final : public Pushes {
 public:
  WorldPushes(const WorldImpl& world, std::uint32_t slot, const Clock& clock)
      : clock_(clock), field_(world.registry, world.state, rows_, zones_) {
    rows_.add(world.registry, world.state, slot);
    drive_ = Drive(world.registry, world.state, slot);
    integrator_ = world.registry.cohort(world.state.slots[slot].cohort).key.fidelity.integrator;
    if (world.is_closed()) field_.leave_functions_out();
    field_.leave_pairs_out();
  }

  bool begin_frame(std::int64_t frame, double mass) override {
    PHYSIM_ASSERT(mass > 0);
    Clock then = clock_;
    then.run_steps += static_cast<std::uint64_t>(frame);
    rows_.mass[0] = mass;
    time_ = then.time();
    field_.begin_step(time_, then.dt);
    if (drive_) drive_.begin_step(integrator_, time_, then.dt);
    return field_.is_felt() || drive_;
  }
  Pushed<double> at(double place, const State<double>& s) override {
    rows_.position[0] = s.x;
    rows_.velocity[0] = s.v;
    rows_.sound = finite(s.x) && finite(s.v);
    field_.evaluate(place);
    const double per_mass = 1 / rows_.mass[0];
    const Pushed<double> pushed{rows_.force[0] * per_mass, rows_.drag_rate[0] * per_mass};
    return drive_ ? pushed + drive_.at(time_ + place * clock_.dt, s) : pushed;
  }

 private:
  Clock clock_;
  ForceRows rows_;
  ZoneDrag zones_;
  ForceField field_;
  Drive drive_;
  Integrator integrator_{};
  double time_ = 0;  // at the start of the frame [s]
};

/// Why there is no flight of a projectile from now on.
std::optional<Error> no_flight(const WorldImpl& w, ProjectileId id, const Until& until, double step) {
  const Slot* slot = w.find(id);
  if (!slot) return Error{"there is no such projectile", "id", "it is gone, or of another world"};
  if (slot->is(kPending)) return Error{"it is not launched yet", "id", "ask when its delay is over"};
  if (slot->is(kStill)) return Error{"it stands still", "id", "it sleeps, sticks, is kinematic or has infinite mass"};
  if (!(step >= 0 && step < 1e6)) return Error{"must be zero or positive, and below 1e6", "step", "in s"};
  if (until.scene) return Error{"predictions meet the scene of their world", "until.scene", "leave it out"};
  if (const Status status = check(until); !status) return status.error();
  for (const EventSpec& event : until.events)
    if (event.kind == EventKind::time)
      return Error{"predictions have no events by time", "until.events", "ask the flight at that time"};
  return std::nullopt;
}

/// What stands in its way, as the world will meet it.
Obstacles obstacles_of(const WorldImpl& w, const Slot& slot) {
  Obstacles obstacles;
  if (!w.registry.cohort(slot.cohort).key.meets) return obstacles;
  const BodyDef& body = w.registry.kind(slot.kind).body;
  obstacles.scene = w.state.scene.get();
  obstacles.contact = {.collision = body.collision,
                       .restitution = body.restitution,
                       .friction = body.friction,
                       .rolling_resistance = body.rolling_resistance,
                       .combine = body.combine,
                       .seed = slot.generation};
  if (body.collision.on_hit == OnHit::ask) obstacles.contact.collision.on_hit = OnHit::stop;  // nobody is asked yet
  obstacles.number = w.state.slots.index_of(slot);
  obstacles.turns = w.state.extras.turns(obstacles.number, body.frozen_rotation);
  if (const Turning* turning = w.state.extras.find_turning(obstacles.number))
    obstacles.shown_spin = turning->angular_velocity;
  return obstacles;
}

/// Where the flight starts, as the row has it.
FrameStart start_of(const WorldImpl& w, const Slot& slot, const Clock& clock) {
  const Rows& rows = w.state.rows_of(slot);
  const WorldCohort& cohort = w.registry.cohort(slot.cohort);
  const BodyState at = w.state.state_of(slot);
  FrameStart start;
  start.now = {at.position, at.velocity};
  start.dt = clock.dt;
  start.in_parts = flies_in_parts(w.def, clock.dt);
  start.has_own_force = cohort.key.features.has_applied;
  start.obstacles = obstacles_of(w, slot);
  start.run_start = clock.run_start;
  start.run_steps = clock.run_steps;
  if (rows.layout().turning) start.turn = rows.turn(slot.row);
  rows.visit([&]<class S>(const RowColumns<S>& c) {
    if (rows.layout().carried) start.carried = Rows::at(c.carried, slot.row);
    start.is_clocked = rows.layout().clocked;
    if (!start.is_clocked) return;
    const S steps = static_cast<S>(w.state.clock.now()) - c.born[slot.row];
    const bool same_frames = clock.dt == w.state.clock.dt;  // else rows count anew (Placement::rebase)
    start.clock = static_cast<double>(same_frames ? c.offset[slot.row]
                                                  : c.offset[slot.row] + steps * static_cast<S>(w.state.clock.dt));
    start.steps = same_frames ? static_cast<double>(steps) : 0;
  });
  return start;
}

/// Springs between two, which a prediction leaves out.
bool has_springs(const WorldImpl& w, ProjectileId id) {
  return std::ranges::any_of(w.state.generators.order(), [&](std::uint32_t index) {
    const Generator& g = w.state.generators[index];
    const ProjectileId other = other_end(g.def.law);
    const auto& ids = g.def.target.ids;
    return other && (other == id || std::find(ids.begin(), ids.end(), id) != ids.end() ||
                     is_in_group(g, w.registry, w.state, id.index));
  });
}

/// All of the record but its path.
void fill(FlightRecord& record, const WorldImpl& w, ProjectileId id, const FrameStart& start) {
  const Slot& slot = *w.find(id);
  const Kind& kind = w.registry.kind(slot.kind);
  const WorldCohort& cohort = w.registry.cohort(slot.cohort);
  record.projectile = kind.projectile;
  record.projectile.fidelity = cohort.key.fidelity;
  record.cohort.in_use = ProjectileView(&w, id).fidelity_in_use();
  if (has_springs(w, id))
    record.cohort.in_use.notes.push_back(
        {"forces", "spring", "none", "springs to other projectiles are left out: where those will be is not known"});
  if (w.state.joints.of_slot(id.index))
    record.cohort.in_use.notes.push_back({"joints", "held", "none", "joints are left out: they hold it in the world"});
  if (start.obstacles.scene && kind.body.collision.on_hit == OnHit::ask)
    record.cohort.in_use.notes.push_back(
        {"on_hit", "ask", "stop", "it ends where somebody will be asked what follows"});
  record.cohort.pool = w.registry.tables(cohort.key.fidelity.interpolation);
  record.cohort.conditions = cohort.conditions;
  record.cohort.conditions.has_applied = cohort.conditions.has_applied || start.pushes != nullptr;
  record.cohort.finish();
  record.keep(w.registry.environments()[cohort.key.environment]);
  Launch level;
  level.position = start.now.x;
  level.velocity = start.now.v;
  record.sight = sight_frame(level);
  record.body = w.placement.body_of(slot);
  record.body.sight = record.sight.forward;
  if (cohort.key.fidelity.motion != Motion::closed_form) record.body.launch = start.now;
  const Rows& rows = w.state.rows_of(slot);
  if (rows.layout().turning) {
    record.path.turn.emplace();
    record.rotor = rows.rotor(slot.row);
    record.rotor.launch = start.turn;
  }
  record.elevation = elevation_of(start.now.v);
  record.step = steps_itself(cohort.key.fidelity) ? 0 : start.dt;
  record.is_framed = true;
  if (start.is_clocked) record.clock = w.placement.clock_of(slot);
}

std::shared_ptr<FlightRecord> predicted(const WorldImpl& w, ProjectileId id, Until until, double step) {
  auto record = std::make_shared<FlightRecord>();
  if ((record->error = no_flight(w, id, until, step))) return record;
  const Slot& slot = *w.find(id);
  Clock clock = w.state.clock;
  if (step > 0 && step != clock.dt) clock.start_run(step);
  if (step == 0 && clock.dt != w.def.step) clock.start_run(w.def.step);
  FrameStart start = start_of(w, slot, clock);
  std::optional<WorldPushes> pushes;
  const bool feels = w.registry.cohort(slot.cohort).key.fidelity.motion == Motion::force;
  if (feels && (!w.state.generators.empty() || w.state.emitters.law_of(id.index)))
    start.pushes = &pushes.emplace(w, id.index, clock);
  fill(*record, w, id, start);
  // Closed forms know the place of their launch; ranges are from here.
  const double passed = dot(start.now.x - record->body.launch.x, record->body.sight);
  if (until.range) *until.range += passed;
  for (EventSpec& event : until.events)
    if (event.kind == EventKind::range) event.value += passed;
  const Restored<const Gate*> asking(Gate::in_question, &w);
  fly_on(*record, start, w.def.tolerance, until);
  for (Event& event : record->events)
    if (event.kind == EventKind::range) event.value -= passed;
  return record;
}

Status check(const Departure& from) {
  Checker check;
  check.is_vector(from.position, "departure.position").is_vector(from.velocity, "departure.velocity");
  check.is_vector(from.spin, "departure.spin").not_negative(from.age, "departure.age");
  if (!from.attitude) return check.status();
  const Quatd& q = from.attitude->orientation;
  const double length_squared = q.w * q.w + q.x * q.x + q.y * q.y + q.z * q.z;
  return check.require(abs(length_squared - 1) < 1e-6, "departure.attitude.orientation", "must be of length one")
      .is_vector(from.attitude->angular_velocity, "departure.attitude.angular_velocity")
      .status();
}

}  // namespace

Flight World::predict(ProjectileId id, const Until& until, double step) const {
  const IeeeMode mode;
  return Flight(predicted(impl(), id, until, step));
}

Flight World::predict(ProjectileId id, double time, double step) const {
  const Ground& ground = def().ground;
  Until until;
  until.ground = ground.mode == GroundMode::none ? std::nullopt : std::optional(ground.height);
  until.time = time;
  return predict(id, until, step);
}

std::size_t World::predict(std::span<const ProjectileId> ids, const Until& until, std::span<ShotResult> into,
                           double step) const {
  const IeeeMode mode;
  std::size_t flown = 0;
  for (std::size_t i = 0; i < std::min(ids.size(), into.size()); ++i) {
    const auto record = predicted(impl(), ids[i], until, step);
    into[i] = {.outcome = record->outcome};
    if (record->outcome == Outcome::refused) continue;
    const State<double> s = record->state(record->duration);
    into[i] = {record->outcome, record->duration, s.x, s.v, record->cost};
    ++flown;
  }
  return flown;
}

// ------------------------------------------------------------------------------------------- from flights
Result<ProjectileId> World::spawn(const Flight& flight, double time, const BodyDef& body) {
  const Result<Departure> from = flight.departure(time);
  if (!from) return from.error();
  return spawn_departed(flight.projectile(), *from, body);
}

Result<ProjectileId> World::spawn_departed(const ProjectileDef& projectile, const Departure& from,
                                           const BodyDef& body) {
  WorldImpl& w = impl();
  const Recorded<Call::spawn_departed> call(w, projectile, from, body);
  if (call.is_refused()) return call.refusal();
  const Result<ProjectileId> id = [&]() -> Result<ProjectileId> {
    if (const Status status = check(from); !status) return ++w.state.counters.refused, status.error();
    Launch launch;
    launch.position = from.position;
    launch.velocity = from.velocity;
    Result<ProjectileId> made = w.spawn(projectile, launch, body, {.age = from.age});
    if (made) w.placement.depart(made->index, from);
    return made;
  }();
  call.returns(id ? *id : ProjectileId{});
  return id;
}

}  // namespace physim
