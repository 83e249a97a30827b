// A step of held projectiles: nets of joints, which projectiles wake and sleep together, and where each is put.
#include <algorithm>
#include <array>
#include <cmath>

#include "base/assert.hpp"
#include "base/checker.hpp"
#include "base/joint_table.hpp"
#include "math/angles.hpp"
#include "math/elementary.hpp"
#include "math/quat.hpp"
#include "model/turning.hpp"
#include "world/core/apex.hpp"
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
  const JointRow& kind = row_of(joint.kind);
  const JointFrame frame = frame_of(state, joint, state.clock.time(), 0);
  const Vec3d a = state.state_of(state.slots[joint.a.index]).position;
  const Vec3d b = joint.b ? state.state_of(state.slots[joint.b.index]).position : frame.place;
  const double long_is = joint.length.value_or(0), slack = kStrain * (long_is + length(a) + length(b));
  const Vec3d axis = rotate(frame.rotation, joint.axis);
  const double along = dot(axis, a - b);
  return breaks(joint.kind, length(a - b) - long_is, slack) || (kind.turns && std::abs(along) > slack) ||
         (kind.slides && length(a - b - axis * along) > slack);
}

/// Whether its point or its axis moves in the coming step.
[[nodiscard]] bool is_carried(const WorldState& state, const Joint& joint, double dt) {
  if (joint.b || (joint.velocity == Vec3d{} && !joint.thing)) return false;
  const JointFrame now = frame_of(state, joint, state.clock.time(), 0);
  const JointFrame then = frame_of(state, joint, state.clock.time() + dt, dt);
  return now.place != then.place || now.rotation != then.rotation;
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

/// A projectile of the step at hand; null if it is not held.
[[nodiscard]] HeldBody* held_in(JointScratch& scratch, ProjectileId id) {
  const auto at =
      std::ranges::lower_bound(scratch.held, id.index, {}, [](const HeldBody& body) { return body.id.index; });
  return at != scratch.held.end() && at->id == id ? &*at : nullptr;
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
    const JointRow& kind = row_of(joint.kind);
    const std::array<JointFrame, 2> frames{frame_of(state_, joint, w_.jointed.began, 0),
                                           frame_of(state_, joint, state_.clock.time(), dt_)};
    const std::uint32_t a = body_of(joint.a), b = joint.b ? body_of(joint.b) : anchor(frames);
    carried_ = carried_ || frames[0].place != frames[1].place || frames[0].rotation != frames[1].rotation;
    if (!kind.slides) {
      NetRow& row = add_row(index, a, b);
      row.pulls = kind.pulls;
      row.pushes = kind.pushes;
      row.length = *joint.length;
      row.restitution = joint.restitution;
      row.stiffness = joint.stiffness;
      row.damping = joint.damping;
    }
    const auto guide = [&](const Vec3d& normal, double length, bool pulls) {
      NetRow& row = add_row(index, a, b);
      row.pulls = pulls;
      row.has_normal = true;
      row.start_normal = rotate(frames[0].rotation, normal);
      row.normal = rotate(frames[1].rotation, normal);
      row.normal_rate = cross(frames[1].turn, row.normal);
      row.length = length;
    };
    if (kind.turns) {
      guide(joint.axis, 0, true);
      const Vec3d between = rotate(conjugate(frames[0].rotation), bodies_[a].start - bodies_[b].start);
      stop_turning(joint, angle_of(joint, between), guide);
    }
    if (kind.slides) {
      const Vec3d across = across_of(joint.axis);
      guide(across, 0, true);
      guide(cross(joint.axis, across), 0, true);
      if (joint.low) guide(joint.axis, *joint.low, false);
      if (joint.high) guide(-joint.axis, -*joint.high, false);
    }
  }
  /// The stops of a hinge, as planes through its axis: each where it is less than a quarter of a turn away.
  template <class Guide>
  static void stop_turning(const Joint& joint, double angle, const Guide& guide) {
    if (!joint.low_angle && !joint.high_angle) return;
    const double low = joint.low_angle.value_or(-kPi), high = joint.high_angle.value_or(kPi);
    if (angle < low || angle > high) {  // it counts as at the stop that is nearer
      const double over = angle > high ? angle - high : angle + 2 * kPi - high;
      const double under = angle < low ? low - angle : low + 2 * kPi - angle;
      angle = over < under ? high : low;
    }
    PHYSIM_ASSERT(low < high);
    const Vec3d side = cross(joint.axis, joint.reference);
    const auto upwards = [&](double stop) { return side * cos(stop) - joint.reference * sin(stop); };
    if (angle - low < kPi / 2) guide(upwards(low), 0, false);
    if (high - angle < kPi / 2) guide(-upwards(high), 0, false);
  }
  /// A direction across another one, both of length one.
  static Vec3d across_of(const Vec3d& axis) {
    const bool is_along_x = std::abs(axis.x) > 0.5;
    return normalized(cross(axis, is_along_x ? Vec3d{0, 1, 0} : Vec3d{1, 0, 0}));
  }
  NetRow& add_row(std::uint32_t joint, std::uint32_t a, std::uint32_t b) {
    PHYSIM_ASSERT(a != b && std::max(a, b) < bodies_.size());
    joints_.push_back(joint);
    NetRow& row = rows_.emplace_back();
    row.a = a;
    row.b = b;
    return row;
  }
  std::uint32_t anchor(const std::array<JointFrame, 2>& frames) {
    const std::uint32_t at = point(frames[0].place);
    bodies_[at].x = frames[1].place;
    bodies_[at].start_velocity = frames[0].velocity;
    bodies_[at].v = frames[1].velocity;
    bodies_[at].is_carried = true;
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
    if (held && !held->meets_others && frozen == Axes::none) add_bounces(*held, at->second);
    return at->second;
  }
  [[nodiscard]] const HeldBody* held_of(ProjectileId id) const { return held_in(w_.jointed, id); }
  /// Adds the bounces of its flight alone. Its acceleration is the mean from the last one on; where that time is short,
  /// or the body lies there, it is the one that leads to the first.
  void add_bounces(const HeldBody& held, std::uint32_t index) {
    constexpr double kShort = 1.0 / 64, kLong = 1.0 / 4;  // of a step [-]
    constexpr double kLies = 1e-9, kUnknown = 1;          // [m/s], [m/s2]
    const auto number = static_cast<std::uint32_t>(&held - w_.jointed.held.data());
    const std::vector<HeldBounce>& bounces = w_.jointed.bounces;
    const auto begin = std::ranges::lower_bound(bounces, number, {}, &HeldBounce::held);
    const auto end = std::find_if(begin, bounces.end(), [&](const HeldBounce& each) { return each.held != number; });
    const std::span<const HeldBounce> all(begin, end);
    if (all.empty()) return;
    NetBody& body = bodies_[index];
    const HeldBounce &first = all.front(), &last = all.back();
    const double until = first.time - w_.jointed.began, left = w_.jointed.began + dt_ - last.time;
    const double rounding = 16 * body.spacing / (until * until);  // of an acceleration from places
    Vec3d a{};
    if (left > kShort * dt_) a = (body.v - last.velocity) * (1 / left);
    const bool lies = std::abs(dot(last.normal, last.velocity)) < kLies;
    if ((left <= kShort * dt_ || lies) && until > kLong * dt_ && rounding < kUnknown)
      a = (first.place - body.start - body.start_velocity * until) * (2 / (until * until));
    body.acceleration = a;
    const bool spins = w_.registry.kind(state_.slots[held.id.index].kind).body.collision.radius > 0;
    Vec3d v = body.start_velocity;
    double time = w_.jointed.began;
    for (const HeldBounce& each : all) {
      v += a * (each.time - time);
      NetBounce bounce{.body = index, .place = each.place, .normal = each.normal};
      bounce.speed = -dot(each.normal, v);
      if (bounce.speed > 0) {
        bounce.restitution = std::clamp(dot(each.normal, each.velocity) / bounce.speed, 0.0, 1.0);
        const Vec3d change = each.velocity - v;
        bounce.across = change - each.normal * dot(each.normal, change);
        const Vec3d slides = v + each.normal * bounce.speed;
        if (spins) bounce.rubbed = length_squared(slides) - length_squared(slides + bounce.across);
        bounces_.push_back(bounce);
      }
      v = each.velocity;
      time = each.time;
    }
  }

  /// A body that would be moved into the ground or a thing stays in front of it, and the net is solved once more.
  NetReport solve() {
    constexpr int kMostTimes = 8;
    const std::vector<NetBody> flown = bodies_;
    const std::size_t joints = rows_.size();
    NetEffort effort(joints);
    NetReport report = hold_net(bodies_, rows_, bounces_, dt_, effort);
    for (int time = 1; time < kMostTimes && !effort.is_spent() && add_contacts(flown); ++time) {
      std::ranges::copy(flown, bodies_.begin());
      for (std::size_t i = 0; i < joints; ++i) rows_[i].forget();
      report = hold_net(bodies_, rows_, bounces_, dt_, effort);
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
  /// A body that starts off a plane bounces off it, once in a step; a body that lies there, or comes again, stays in
  /// front of it. True if there is something new to solve for.
  bool add_contacts(const std::vector<NetBody>& flown) {
    bool found = false;
    for (std::size_t i = 0; i < flown.size(); ++i) {
      NetBody body = bodies_[i];
      while_it_meets(i, flown[i].x, body, [&](const NetContact& contact) {
        if (is_shallow(body, contact)) return stop_at(body, contact), true;
        found = true;
        const bool comes = -depth(flown[i].start, contact) > kAside * (1 + length(body.x));
        const auto number = static_cast<std::uint32_t>(i);
        const auto is_same = [&](const NetBounce& bounce) {
          return bounce.body == number && dot(bounce.normal, contact.normal) > kSamePlane;
        };
        if (comes && contact.rests && std::ranges::none_of(bounces_, is_same)) {
          bounces_.push_back(
              {.body = number, .place = contact.place, .normal = contact.normal, .restitution = contact.restitution});
        } else {
          keep_before(i, contact);
        }
        return false;
      });
    }
    return found;
  }
  /// The body stays in front of what it meets, however its net is solved.
  void keep_before(std::size_t body, const NetContact& contact) {
    if (!origin_) origin_ = point({});
    NetRow& row = rows_.emplace_back();
    row.pulls = false;
    row.has_normal = true;
    row.a = static_cast<std::uint32_t>(body);
    row.b = *origin_;
    row.start_normal = row.normal = contact.normal;
    row.length = contact.offset;
  }
  [[nodiscard]] static double depth(const Vec3d& place, const NetContact& contact) {
    return contact.offset - dot(contact.normal, place);
  }
  /// So little that it is moved out without another look at its net.
  [[nodiscard]] static bool is_shallow(const NetBody& body, const NetContact& contact) {
    return depth(body.x, contact) < 1e-12 * (1 + length(body.x)) + 16 * body.spacing;
  }
  /// If the net and its contacts contradict each other, no body enters anything.
  static void stop_at(NetBody& body, const NetContact& contact) {
    body.x = is_shallow(body, contact) ? body.x + contact.normal * depth(body.x, contact) : contact.place;
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
    for (std::size_t i = 0; i < rows_.size();) {
      const std::uint32_t index = joints_[i];
      HeldJoint& joint = state_.joints[index];
      const NetRow& first = rows_[i];
      joint.tension = first.has_normal ? 0 : first.impulse / dt_;
      joint.is_taut = first.came_taut || first.impulse > 0;
      double squares = 0;  // directions of the rows of a joint stand across each other
      for (; i < rows_.size() && joints_[i] == index; ++i) squares += rows_[i].impulse * rows_[i].impulse;
      joint.force = std::sqrt(squares) / dt_;
      if (first.came_taut)
        state_.joints.events.push_back(
            {JointEventKind::came_taut, state_.joints.id_of(index), joint.def.a, state_.clock.time(), first.speed});
      if (joint.def.break_force && joint.force > *joint.def.break_force) w_.jointed.broken.push_back(index);
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

  static constexpr double kSamePlane = 0.99;  // cosine [-]
  static constexpr double kAside = 1e-7;  // of a place: what is farther off a plane than that does not lie on it [-]

  WorldImpl& w_;
  WorldState& state_;
  const std::vector<std::uint32_t>& net_;
  double dt_;
  std::vector<NetBody> bodies_;
  std::vector<std::uint32_t> slots_;  // of bodies; 0: a fixed point
  std::vector<NetRow> rows_;
  std::vector<NetBounce> bounces_;
  bool carried_ = false;                                     // a point or an axis moves
  std::optional<std::uint32_t> origin_;                      // body that planes are relative to
  std::vector<std::uint32_t> joints_;                        // of rows, those of a joint one after the other
  std::unordered_map<std::uint32_t, std::uint32_t> places_;  // of slots among the bodies
};

/// Finds out where held projectiles bounced in the step at hand.
void note_bounces(WorldImpl& world) {
  JointScratch& s = world.jointed;
  s.bounces.clear();
  const Scene* scene = world.state.scene.get();
  world.state.events.each_of(EventKind::bounced, [&](const Event& e) {
    HeldBody* held = held_in(s, e.id);
    const Slot* slot = world.find(e.id);
    if (!held || !slot || e.time < s.began) return;
    const bool on_ground = !e.instance && !e.other;
    const bool is_flat = world.registry.cohort(slot->cohort).key.fidelity.earth == EarthModel::flat;
    const bool rests = on_ground ? is_flat : !e.other && scene && is_at_rest(*scene, e.instance);
    held->meets_others = held->meets_others || !rests;
    const auto number = static_cast<std::uint32_t>(held - s.held.data());
    s.bounces.push_back({number, e.time, e.position, e.velocity, on_ground ? Vec3d{0, 1, 0} : e.normal});
  });
  std::ranges::stable_sort(s.bounces, [](const HeldBounce& a, const HeldBounce& b) {
    return a.held != b.held ? a.held < b.held : a.time < b.time;
  });
}

/// Tells which held projectiles climbed when the step began and do not at its end. Their flights alone tell none.
void tell_apexes(WorldImpl& world, double dt) {
  JointScratch& s = world.jointed;
  for (const HeldBody& held : s.held) {
    const Slot* slot = world.find(held.id);
    if (!slot) continue;
    const BodyState now = world.state.state_of(*slot);
    const State<double> start{held.start.position, held.start.velocity}, end{now.position, now.velocity};
    const auto& c = world.registry.cohort(slot->cohort).conditions;
    const auto apex = apex_between(c, start, end, dt);
    if (!apex) continue;
    Event& event = s.apexes.emplace_back();
    put_plain({EventKind::apex, Reason::none, held.id, 0, s.began + apex->passed, apex->at.x, apex->at.v}, event);
    world.keep_event(event);
  }
}

}  // namespace

void begin_joints(WorldImpl& world, double dt) {
  JointScratch& s = world.jointed;
  s.apexes.clear();
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
  if (!world.jointed.held.empty()) note_bounces(world);
  for (const std::vector<std::uint32_t>& net : world.jointed.nets) NetStep(world, net, dt).run();
  if (world.def.apex_events) tell_apexes(world, dt);
  std::ranges::sort(broken);
  for (const std::uint32_t index : broken) break_joint(world, index);
  Joints& joints = world.state.joints;
  joints.each([&](std::uint32_t index) {
    const Joint& joint = joints[index].def;
    if (joint.velocity != Vec3d{}) joints.move_point(index, joint.point + joint.velocity * dt);
  });
}

}  // namespace physim
