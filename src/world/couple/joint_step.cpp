// A step of held projectiles: nets of joints, which projectiles wake and sleep together, and where each is put.
#include <algorithm>
#include <cmath>

#include "base/assert.hpp"
#include "base/checker.hpp"
#include "base/joint_table.hpp"
#include "model/turning.hpp"
#include "world/core/joints.hpp"
#include "world/couple/joint_contacts.hpp"
#include "world/couple/world_impl.hpp"
#include "world/step/force_field.hpp"

namespace physim {
namespace {

/// Whether joints pass through it: not where nothing moves it.
[[nodiscard]] bool passes_on(const Slot& slot) { return !slot.is(kStill & ~kAsleep); }

// ------------------------------------------------------------------------------------------- nets
/// Joints that hold together, each net in the order in which a search finds them that begins at an end of it.
class NetSearch {
 public:
  explicit NetSearch(const WorldState& state) : state_(state), seen_(state.joints.size()) {}

  void run(std::vector<std::vector<std::uint32_t>>& nets) {
    nets.clear();
    state_.joints.each([&](std::uint32_t index) {
      if (seen_[index]) return;
      const std::vector<std::uint32_t> found = search(index);
      for (const std::uint32_t each : found) seen_[each] = false;
      nets.push_back(search(found.back()));
    });
  }

 private:
  std::vector<std::uint32_t> search(std::uint32_t from) {
    PHYSIM_ASSERT(!seen_[from] && state_.joints[from].active);
    std::vector<std::uint32_t> found{from};
    seen_[from] = true;
    for (std::size_t at = 0; at < found.size(); ++at) {
      const Joint& joint = state_.joints[found[at]].def;
      for (const ProjectileId end : {joint.a, joint.b}) {
        if (!end || !passes_on(state_.slots[end.index])) continue;
        for (const std::uint32_t next : *state_.joints.of_slot(end.index)) {
          if (seen_[next]) continue;
          seen_[next] = true;
          found.push_back(next);
        }
      }
    }
    return found;
  }

  const WorldState& state_;
  std::vector<bool> seen_;
};

/// Calls f with the slot of each end of a net's joints, maybe several times.
template <class F>
void each_end(const WorldState& state, const std::vector<std::uint32_t>& net, const F& f) {
  for (const std::uint32_t index : net) {
    const Joint& joint = state.joints[index].def;
    f(joint.a.index);
    if (joint.b) f(joint.b.index);
  }
}

/// An end of it that a call put elsewhere pulls at sleeping projectiles.
[[nodiscard]] bool is_strained(const WorldState& state, const Joint& joint) {
  constexpr double kStrain = 1e-6;  // of its length and of how far out it is: more than float32 rounds [-]
  const Vec3d a = state.state_of(state.slots[joint.a.index]).position;
  const Vec3d b = joint.b ? state.state_of(state.slots[joint.b.index]).position
                          : point_of(state, joint, state.clock.time(), 0).position;
  const double off = length(a - b) - *joint.length;
  const double slack = kStrain * (*joint.length + length(a) + length(b));
  return breaks(joint.kind, off, slack);
}

/// Whether its point moves in the coming step.
[[nodiscard]] bool is_carried(const WorldState& state, const Joint& joint, double dt) {
  if (joint.b || (joint.velocity == Vec3d{} && !joint.thing)) return false;
  const double now = state.clock.time();
  return point_of(state, joint, now, 0).position != point_of(state, joint, now + dt, dt).position;
}

/// Wakes all projectiles of a net if one of it moves.
void wake_net(WorldImpl& world, const std::vector<std::uint32_t>& net, double dt) {
  WorldState& state = world.state;
  bool moves = std::ranges::any_of(net, [&](std::uint32_t index) {
    const Joint& joint = state.joints[index].def;
    return is_strained(state, joint) || is_carried(state, joint, dt);
  });
  std::vector<std::uint32_t> asleep;
  each_end(state, net, [&](std::uint32_t slot) {
    if (state.slots[slot].is(kAsleep)) asleep.push_back(slot);
    moves = moves || !state.slots[slot].is(kStill);
  });
  if (!moves) return;
  for (const std::uint32_t slot : asleep)
    if (state.slots[slot].is(kAsleep)) world.wake(slot);
}

// ------------------------------------------------------------------------------------------- one net
class NetStep {
 public:
  NetStep(WorldImpl& world, const std::vector<std::uint32_t>& net, double dt)
      : w_(world), state_(world.state), net_(net), dt_(dt) {}

  void run() {
    for (const std::uint32_t index : net_)
      if (state_.joints[index].active) add(state_.joints[index].def, index);
    if (rows_.empty() || std::ranges::none_of(slots_, [](std::uint32_t slot) { return slot != 0; })) return;
    const bool moves = std::ranges::any_of(bodies_, [](const NetBody& body) { return body.mobility != Vec3d{}; });
    if (!moves) return;
    const NetReport report = solve();
    JointCounts& counts = state_.joints.counts;
    counts.rounds = std::max(counts.rounds, report.rounds);
    counts.residual = std::max(counts.residual, report.residual);
    if (!report.solved) ++counts.unsolved;
    put();
    tell();
    rest();
  }

 private:
  void add(const Joint& joint, std::uint32_t index) {
    NetRow& row = rows_.emplace_back();
    joints_.push_back(index);
    row.pulls = row_of(joint.kind).pulls;
    row.pushes = row_of(joint.kind).pushes;
    row.a = body_of(joint.a);
    row.b = joint.b ? body_of(joint.b) : anchor(joint);
    row.length = *joint.length;
    row.restitution = joint.restitution;
    row.stiffness = joint.stiffness;
    row.damping = joint.damping;
  }
  std::uint32_t anchor(const Joint& joint) {
    const BodyState start = point_of(state_, joint, w_.jointed.began, 0);
    const BodyState end = point_of(state_, joint, state_.clock.time(), dt_);
    const std::uint32_t at = point(start.position);
    bodies_[at].x = end.position;
    bodies_[at].start_velocity = start.velocity;
    bodies_[at].v = end.velocity;
    bodies_[at].is_carried = true;
    carried_ = carried_ || start.position != end.position;
    return at;
  }
  std::uint32_t point(const Vec3d& at) {
    PHYSIM_ASSERT(bodies_.size() == slots_.size());
    NetBody& body = bodies_.emplace_back();
    body.start = body.x = at;
    slots_.push_back(0);
    return static_cast<std::uint32_t>(bodies_.size() - 1);
  }
  std::uint32_t body_of(ProjectileId id) {
    const auto [at, is_new] = places_.try_emplace(id.index, static_cast<std::uint32_t>(bodies_.size()));
    if (!is_new) return at->second;
    const Slot& slot = state_.slots[id.index];
    const BodyState now = state_.state_of(slot);
    NetBody& body = bodies_.emplace_back();
    slots_.push_back(id.index);
    body.x = now.position;
    body.v = now.velocity;
    const HeldBody* held = held_of(id);
    body.start = held ? held->start.position : now.position;
    body.start_velocity = held ? held->start.velocity : now.velocity;
    body.spacing = length(body.x) * state_.rows_of(slot).layout().epsilon();
    if (slot.is(kStill)) {
      body.start = body.x;
      return at->second;
    }
    const Own* own = state_.extras.find_own(id.index);
    const Axes frozen = own ? own->frozen : w_.registry.kind(slot.kind).body.frozen;
    body.mobility = free_axes(frozen) * (1 / mass_of(w_.registry, state_, slot));
    return at->second;
  }
  [[nodiscard]] const HeldBody* held_of(ProjectileId id) const {
    const auto& held = w_.jointed.held;
    const auto at = std::ranges::lower_bound(held, id.index, {}, [](const HeldBody& body) { return body.id.index; });
    return at != held.end() && at->id == id ? &*at : nullptr;
  }

  /// A body that would be moved into the ground or a thing stays in front of it, and the net is solved once more.
  NetReport solve() {
    constexpr int kMostTimes = 8;
    const std::vector<NetBody> flown = bodies_;
    const std::size_t joints = rows_.size();
    NetReport report = hold_net(bodies_, rows_, dt_);
    for (int time = 1; time < kMostTimes && add_contacts(flown); ++time) {
      std::ranges::copy(flown, bodies_.begin());
      for (std::size_t i = 0; i < joints; ++i) rows_[i].impulse = 0, rows_[i].came_taut = false;
      report = hold_net(bodies_, rows_, dt_);
    }
    rows_.resize(joints);
    for (std::size_t i = 0; i < flown.size(); ++i)
      while_it_meets(i, flown[i].x, bodies_[i], [&](const NetContact& contact) {
        stop_at(bodies_[i], contact);
        return true;
      });
    return report;
  }
  /// Calls f for what a body meets on its way from where it flew to, as long as that says that it was moved out of it:
  /// behind a floor that it is in by a rounding there may be a wall.
  template <class F>
  void while_it_meets(std::size_t index, const Vec3d& from, const NetBody& body, const F& f) const {
    constexpr int kMostSides = 6;  // more than three things seldom meet
    if (slots_[index] == 0 || body.mobility == Vec3d{}) return;
    for (int side = 0; side < kMostSides && finite(body.x); ++side) {
      const auto contact = contact_on_way(w_, slots_[index], from, body.x);
      if (!contact || !f(*contact)) return;
    }
  }
  bool add_contacts(const std::vector<NetBody>& flown) {
    const std::size_t before = rows_.size();
    for (std::size_t i = 0; i < flown.size(); ++i) {
      NetBody body = bodies_[i];
      while_it_meets(i, flown[i].x, body, [&](const NetContact& contact) {
        if (!is_shallow(body, contact)) return keep_before(i, contact), false;
        stop_at(body, contact);
        return true;
      });
    }
    return rows_.size() > before;
  }
  /// The body stays in front of what it meets, however its net is solved.
  void keep_before(std::size_t body, const NetContact& contact) {
    if (!origin_) origin_ = point({});
    NetRow& row = rows_.emplace_back();
    row.pulls = false;
    row.has_normal = true;
    row.a = static_cast<std::uint32_t>(body);
    row.b = *origin_;
    row.normal = contact.normal;
    row.length = contact.offset;
  }
  [[nodiscard]] static double depth(const NetBody& body, const NetContact& contact) {
    return contact.offset - dot(contact.normal, body.x);
  }
  /// So little that it is moved out without another look at its net.
  [[nodiscard]] static bool is_shallow(const NetBody& body, const NetContact& contact) {
    return depth(body, contact) < 1e-12 * (1 + length(body.x)) + 16 * body.spacing;
  }
  /// If the net and its contacts contradict each other, no body enters anything.
  static void stop_at(NetBody& body, const NetContact& contact) {
    body.x = is_shallow(body, contact) ? body.x + contact.normal * depth(body, contact) : contact.place;
    const double into = dot(contact.normal, body.v);
    if (into < 0) body.v -= contact.normal * into;
  }

  void put() {
    for (std::size_t i = 0; i < bodies_.size(); ++i) {
      const NetBody& body = bodies_[i];
      if (slots_[i] == 0 || body.mobility == Vec3d{}) continue;
      const Slot& slot = state_.slots[slots_[i]];
      const BodyState to{body.x, body.v};
      // Beyond what a number holds it stays as it flew; the next step retires it.
      if (to == state_.state_of(slot) || !std::isfinite(length(body.x) + length(body.v)) || !w_.fits(slot, to))
        continue;
      const Vec3d previous = state_.rows_of(slot).previous(slot.row);
      w_.placement.set_row_state(slots_[i], to);
      state_.rows_of(slot).visit([&](const auto& c) { Rows::put(c.previous, slot.row, previous); });
    }
  }

  void tell() {
    PHYSIM_ASSERT(rows_.size() == joints_.size());
    for (std::size_t i = 0; i < rows_.size(); ++i) {
      HeldJoint& joint = state_.joints[joints_[i]];
      const NetRow& row = rows_[i];
      joint.tension = row.impulse / dt_;
      joint.is_taut = row.came_taut || row.impulse > 0;
      if (row.came_taut)
        state_.joints.events.push_back(
            {JointEventKind::came_taut, state_.joints.id_of(joints_[i]), joint.def.a, state_.clock.time(), row.speed});
      if (joint.def.break_force && std::abs(joint.tension) > *joint.def.break_force)
        w_.jointed.broken.push_back(joints_[i]);
    }
  }

  // ------------------------------------------------------------------------------------------- rest
  /// Those of a net rest together: when all have done so for long enough, all sleep.
  void rest() {
    bool all = !carried_;
    for (std::size_t i = 0; i < bodies_.size(); ++i)
      if (slots_[i] != 0 && !state_.slots[slots_[i]].is(kStill)) all = has_rested(slots_[i], bodies_[i].v) && all;
    if (!all) return;
    for (const std::uint32_t slot : slots_)
      if (slot != 0) w_.put_to_sleep(slot);
  }
  /// Counts its time at rest.
  [[nodiscard]] bool has_rested(std::uint32_t index, const Vec3d& v) {
    const Slot& slot = state_.slots[index];
    const BodyDef& body = w_.registry.kind(slot.kind).body;
    const std::uint64_t step = state_.clock.steps - 1;  // the one just taken
    Rest& rest = state_.slots.rest(index);
    const bool may_fire = w_.registry.cohort(slot.cohort).conditions.has_motor;
    if (slot.is(kSleepless) || may_fire || !(length(v) < body.sleep_speed)) {
      rest.time = 0;
      return false;
    }
    if (rest.step != static_cast<std::uint32_t>(step)) rest.count(step, dt_);
    return static_cast<double>(rest.time) >= body.sleep_time;
  }

  WorldImpl& w_;
  WorldState& state_;
  const std::vector<std::uint32_t>& net_;
  double dt_;
  std::vector<NetBody> bodies_;
  std::vector<std::uint32_t> slots_;  // of bodies; 0: a fixed point
  std::vector<NetRow> rows_;
  bool carried_ = false;                                     // a point moves
  std::optional<std::uint32_t> origin_;                      // body that planes are relative to
  std::vector<std::uint32_t> joints_;                        // of rows
  std::unordered_map<std::uint32_t, std::uint32_t> places_;  // of slots among the bodies
};

}  // namespace

void begin_joints(WorldImpl& world, double dt) {
  JointScratch& s = world.jointed;
  s.began = world.state.clock.time();
  s.held.clear();
  s.nets.clear();
  WorldState& state = world.state;
  state.joints.counts.rounds = 0;
  state.joints.counts.residual = 0;
  if (state.joints.empty()) return;
  NetSearch(state).run(s.nets);
  for (const std::vector<std::uint32_t>& net : s.nets) {
    wake_net(world, net, dt);
    each_end(state, net, [&](std::uint32_t slot) {
      if (!state.slots[slot].is(kStill)) s.held.push_back({state.slots.id_of(slot), state.state_of(state.slots[slot])});
    });
  }
  std::ranges::sort(s.held, {}, [](const HeldBody& body) { return body.id.index; });
  const auto same = [](const HeldBody& a, const HeldBody& b) { return a.id == b.id; };
  s.held.erase(std::unique(s.held.begin(), s.held.end(), same), s.held.end());
}

void hold_joints(WorldImpl& world, double dt) {
  PHYSIM_ASSERT(dt > 0);
  std::vector<std::uint32_t>& broken = world.jointed.broken;
  broken.clear();
  for (const std::vector<std::uint32_t>& net : world.jointed.nets) NetStep(world, net, dt).run();
  std::ranges::sort(broken);
  for (const std::uint32_t index : broken) break_joint(world, index);
  Joints& joints = world.state.joints;
  joints.each([&](std::uint32_t index) {
    const Joint& joint = joints[index].def;
    if (joint.velocity != Vec3d{}) joints.move_point(index, joint.point + joint.velocity * dt);
  });
}

}  // namespace physim
