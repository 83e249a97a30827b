// Joints as a world keeps them, and the calls that change them.
#include "world/core/joints.hpp"

#include <algorithm>

#include "base/archive.hpp"
#include "base/checker.hpp"
#include "base/ieee_mode.hpp"
#include "base/joint_table.hpp"
#include "collide/scene_by_motion.hpp"
#include "math/angles.hpp"
#include "math/elementary.hpp"
#include "math/quat.hpp"
#include "world/couple/world_impl.hpp"

namespace physim {
namespace {

/// Joints of one projectile: this many are solved quickly, as all of them feel each other.
constexpr std::size_t kMostJointsOfOne = 64;
constexpr std::size_t kMostJoints = 1u << 22;
constexpr double kFarthestJoint = 1e15;  // [m]

Error no_joint() { return {"there is no such joint", "joint", "it was removed, or a projectile that it held is gone"}; }

}  // namespace

// ------------------------------------------------------------------------------------------- the list
JointId Joints::add(const Joint& joint) {
  std::uint32_t index;
  if (free_.empty()) {
    index = size();
    all_.emplace_back();
  } else {
    index = free_.back();
    free_.pop_back();
  }
  PHYSIM_ASSERT(!all_[index].active && joint.a != joint.b && is_complete(joint));
  all_[index].active = true;
  all_[index].def = joint;
  join(index);
  return id_of(index);
}

void Joints::join(std::uint32_t index) {
  const Joint& joint = all_[index].def;
  PHYSIM_ASSERT(all_[index].active && joint.a);
  ++count_;
  for (const ProjectileId end : {joint.a, joint.b}) {
    if (!end) continue;
    std::vector<std::uint32_t>& all = of_slot_[end.index];
    all.insert(std::ranges::upper_bound(all, index), index);
  }
}

void Joints::erase(std::uint32_t index) {
  HeldJoint& joint = (*this)[index];
  PHYSIM_ASSERT(joint.active && count_ > 0);
  for (const ProjectileId end : {joint.def.a, joint.def.b}) {
    const auto at = of_slot_.find(end.index);
    if (!end || at == of_slot_.end()) continue;
    std::erase(at->second, index);
    if (at->second.empty()) of_slot_.erase(at);
  }
  joint = {.generation = joint.generation + 1, .active = false, .def = {}, .tension = 0, .is_taut = false, .force = 0};
  free_.push_back(index);
  --count_;
}

void Joints::move_point(std::uint32_t index, const Vec3d& to) {
  if (length(to) <= kFarthestJoint) (*this)[index].def.point = to;
}

bool Joints::restore(std::vector<HeldJoint> all, std::vector<std::uint32_t> free) {
  if (all.empty() || all[0].active) return false;
  std::vector<bool> seen(all.size());
  for (const std::uint32_t index : free) {
    if (index == 0 || index >= all.size() || seen[index] || all[index].active) return false;
    seen[index] = true;
  }
  const auto active = std::ranges::count_if(all, [](const HeldJoint& joint) { return joint.active; });
  if (free.size() + static_cast<std::size_t>(active) + 1 != all.size()) return false;
  all_ = std::move(all);
  free_ = std::move(free);
  of_slot_.clear();
  count_ = 0;
  each([this](std::uint32_t index) { join(index); });
  return true;
}

std::size_t Joints::bytes() const {
  return all_.capacity() * sizeof(HeldJoint) + of_slot_.size() * 64 + events.capacity() * sizeof(JointEvent);
}

void Joints::add_to(Hash& hash) const {
  if (all_.size() == 1) return;
  each([&](std::uint32_t index) {
    // What joints had from the first, and all of it only where there is more: a rod keeps its hash.
    const Joint& j = all_[index].def;
    const Joint first{j.kind, j.a, j.b, j.point, j.length, j.restitution, j.stiffness, j.damping};
    hash.add(hash_of(index, j.kind, j.a, j.b, j.point, j.length, j.restitution, j.stiffness, j.damping));
    if (j != first) hash.add(hash_of(j));
  });
  for (const HeldJoint& joint : all_) hash.add(std::uint64_t{joint.generation});
  for (const std::uint32_t index : free_) hash.add(std::uint64_t{index});
}

// ------------------------------------------------------------------------------------------- bad input
namespace {

void check_point(Checker& c, const Joint& joint) {
  constexpr double kFastest = 1e9;  // as things [m/s]
  c.is_vector(joint.point, "joint.point");
  c.require(length(joint.point) <= kFarthestJoint, "joint.point", "must lie within 1e15 m");
  c.require(!joint.thing || !joint.b, "joint.thing", "is given together with b", "a joint has two ends");
  c.is_vector(joint.velocity, "joint.velocity");
  c.require(length(joint.velocity) <= kFastest, "joint.velocity", "must not be above 1e9 m/s");
  c.require(joint.velocity == Vec3d{} || !(joint.b || joint.thing), "joint.velocity", "is that of a point of the world",
            joint.b ? "b moves by itself" : "the thing takes its point along");
}

void check_axis(Checker& c, const Joint& joint) {
  const JointRow& kind = row_of(joint.kind);
  const bool has_axis = kind.turns || kind.slides;
  for (const auto& [vector, place] :
       {std::pair(joint.axis, "joint.axis"), std::pair(joint.reference, "joint.reference")})
    c.is_vector(vector, place).require(std::isfinite(length(vector)), place, "is too long", "its direction counts");
  c.require(!has_axis || length(joint.axis) > 0, "joint.axis", "must have a length",
            "a hinge or slider has a direction");
  c.require(has_axis || joint.axis == Vec3d{}, "joint.axis", "is that of a hinge or slider");
  c.require(kind.turns || joint.reference == Vec3d{}, "joint.reference", "is that of a hinge");
  for (const auto& [angle, place] :
       {std::pair(joint.low_angle, "joint.low_angle"), std::pair(joint.high_angle, "joint.high_angle")})
    c.require(!angle || kind.turns, place, "is that of a hinge", "limits of sliders are low and high")
        .require(!angle || std::abs(*angle) <= kPi, place, "must lie between -180 and 180 degrees");
  for (const auto& [way, place] : {std::pair(joint.low, "joint.low"), std::pair(joint.high, "joint.high")})
    c.require(!way || kind.slides, place, "is that of a slider", "limits of hinges are low_angle and high_angle")
        .require(!way || std::abs(*way) <= kFarthestJoint, place, "must lie within 1e15 m");
  c.require(!joint.low_angle || !joint.high_angle || *joint.low_angle < *joint.high_angle, "joint.high_angle",
            "must be above low_angle");
  c.require(!joint.low || !joint.high || *joint.low < *joint.high, "joint.high", "must be above low");
}

}  // namespace

Status check(const Joint& joint) {
  Checker c;
  c.named(joint.kind, "joint.kind");
  if (!c.status_so_far()) return c.status();
  c.require(bool(joint.a), "joint.a", "is nobody", "a joint holds a projectile to another one, or to a point");
  c.require(joint.a != joint.b, "joint.b", "is joint.a too", "a joint holds two different projectiles");
  check_point(c, joint);
  if (joint.length) {
    c.require(!row_of(joint.kind).slides, "joint.length", "is given for a slider", "it has low and high");
    constexpr std::string_view kHint = "leave it out for the distance at which its ends are now";
    if (joint.kind == JointKind::spring)
      c.not_negative(*joint.length, "joint.length", kHint);
    else
      c.positive(*joint.length, "joint.length", kHint);
    c.require(*joint.length <= kFarthestJoint, "joint.length", "must not be above 1e15 m");
  }
  c.require(joint.restitution >= 0 && joint.restitution <= 1, "joint.restitution", "must lie between 0 and 1");
  c.require(joint.restitution == 0 || joint.kind == JointKind::cable, "joint.restitution", "is that of a cable",
            "rods and springs have none");
  if (joint.break_force)
    c.positive(*joint.break_force, "joint.break_force", "leave it out for a joint that never breaks");
  c.not_negative(joint.stiffness, "joint.stiffness", "in N/m").not_negative(joint.damping, "joint.damping", "in kg/s");
  check_axis(c, joint);
  return c.status();
}

bool is_complete(const Joint& joint) {
  constexpr double kRounding = 1e-9;
  const JointRow& kind = row_of(joint.kind);
  const auto has_length_one = [](const Vec3d& v) { return std::abs(length(v) - 1) < kRounding; };
  return (joint.length || kind.slides) && (!(kind.turns || kind.slides) || has_length_one(joint.axis)) &&
         (!kind.turns || has_length_one(joint.reference));
}

// ------------------------------------------------------------------------------------------- where it is
double angle_of(const Joint& joint, const Vec3d& between) {
  PHYSIM_ASSERT(row_of(joint.kind).turns && is_complete(joint));
  return atan2(dot(cross(joint.axis, joint.reference), between), dot(joint.reference, between));
}

JointFrame frame_of(const WorldState& state, const Joint& joint, double time, double ahead) {
  PHYSIM_ASSERT(!joint.b || !joint.thing);
  if (!joint.thing) return {joint.point + joint.velocity * ahead, joint.velocity, {}, {}};
  const double when = std::clamp(time, -collide::kLatest, collide::kLatest);
  const auto at = state.scene ? state.scene->state(joint.thing, when) : std::nullopt;
  if (!at) return {.place = joint.point};  // it ends with the call that took the thing away
  const Vec3d place = at->position + rotate(at->rotation, joint.point * SceneByMotion(*state.scene).scale(joint.thing));
  return {place, velocity_at(*at, place), at->rotation, at->angular_velocity};
}

namespace {

/// Whether there is room at an end.
Status refuses_end(const WorldImpl& w, ProjectileId end, const char* place) {
  if (!w.find(end)) return Error{"it is gone", place, "is_alive() tells"};
  const auto* joints = w.state.joints.of_slot(end.index);
  if (joints && joints->size() >= kMostJointsOfOne)
    return Error{"is held by 64 joints already", place, "spread them over several projectiles"};
  return {};
}

/// From its second end to its first, in the frame of its point.
Vec3d between_ends(const WorldState& state, const Joint& joint) {
  const JointFrame frame = frame_of(state, joint, state.clock.time(), 0);
  const Vec3d b = joint.b ? state.state_of(state.slots[joint.b.index]).position : frame.place;
  return rotate(conjugate(frame.rotation), state.state_of(state.slots[joint.a.index]).position - b);
}

/// A point of an axis is as good as any other one: that of a hinge goes to the nearest one to its first end.
void put_beside(const WorldState& state, Joint& joint) {
  if (!row_of(joint.kind).turns || joint.b) return;
  const double scale = joint.thing ? SceneByMotion(*state.scene).scale(joint.thing) : 1;
  joint.point += joint.axis * (dot(joint.axis, between_ends(state, joint)) / scale);
}

/// Adds what follows from where its ends are now.
Status complete(const WorldState& state, Joint& joint) {
  const JointRow& kind = row_of(joint.kind);
  if (kind.turns || kind.slides) joint.axis = normalized(joint.axis);
  put_beside(state, joint);
  Vec3d between = between_ends(state, joint);
  if (kind.turns) {
    between -= joint.axis * dot(joint.axis, between);
    if (joint.reference == Vec3d{}) joint.reference = between;
    joint.reference = normalized(joint.reference - joint.axis * dot(joint.axis, joint.reference));
    if (!(length(joint.reference) > 0.5))
      return Error{"has no direction across the axis", "joint.reference", "a stands on the axis, or it is along it"};
  }
  if (joint.length || kind.slides) return {};
  joint.length = length(between);
  if (!(*joint.length > 0) && joint.kind != JointKind::spring)
    return Error{"its ends are at one place", "joint.length", "say how long it is"};
  return {};
}

void wake_ends(WorldImpl& w, const Joint& joint) {
  for (const ProjectileId end : {joint.a, joint.b})
    if (end && w.find(end) && w.state.slots[end.index].is(kAsleep)) w.wake(end.index);
}

void tell_end(WorldState& state, std::uint32_t index, ProjectileId who) {
  if (state.joints.events.size() >= kMostEventsOfCalls) return;
  state.joints.events.push_back({JointEventKind::ended, state.joints.id_of(index), who, state.clock.time(), 0});
}

}  // namespace

// ------------------------------------------------------------------------------------------- calls
Result<JointId> World::add_joint(const Joint& joint) {
  WorldImpl& w = impl();
  const Recorded<Call::add_joint> call(w, joint);
  if (call.is_refused()) return call.refusal();
  if (const Status status = check(joint); !status) return status.error();
  if (const Status status = refuses_end(w, joint.a, "joint.a"); !status) return status.error();
  if (const Status status = joint.b ? refuses_end(w, joint.b, "joint.b") : Status(); !status) return status.error();
  if (w.state.joints.count() >= kMostJoints) return Error{"there are too many of them", "joint", "at most 4194304"};
  if (joint.thing && !(w.state.scene && w.state.scene->state(joint.thing)))
    return Error{"is not there", "joint.thing", "World::add_instance() gives an id of a thing of the scene"};
  Joint added = joint;
  if (const Status status = complete(w.state, added); !status) return status.error();
  // What is measured is held to the bounds of what is given: saves are.
  if (const Status status = check(added); !status) return status.error();
  const JointId id = w.state.joints.add(added);
  wake_ends(w, added);
  return call.returns(id);
}

Status World::remove_joint(JointId id) {
  WorldImpl& w = impl();
  const Recorded<Call::remove_joint> call(w, id);
  if (call.is_refused()) return call.refusal();
  const HeldJoint* joint = w.state.joints.find(id);
  if (!joint) return no_joint();
  wake_ends(w, joint->def);
  w.state.joints.erase(id.index);
  return {};
}

Status World::move_joint(JointId id, const BodyState& to) {
  WorldImpl& w = impl();
  const Recorded<Call::move_joint> call(w, id, to);
  if (call.is_refused()) return call.refusal();
  const HeldJoint* joint = w.state.joints.find(id);
  if (!joint) return no_joint();
  if (joint->def.b) return Error{"holds two projectiles, and has no point", "joint", "move one of these"};
  if (joint->def.thing) return Error{"has the point of a thing", "joint", "World::move_instance() moves that"};
  Joint moved = joint->def;
  moved.point = to.position, moved.velocity = to.velocity;
  if (Status status = check(moved); !status) return status;
  put_beside(w.state, moved);
  w.state.joints[id.index].def = moved;
  wake_ends(w, moved);
  return {};
}

void end_joints_at_gone_things(WorldImpl& w) {
  std::vector<std::uint32_t> gone;
  w.state.joints.each([&](std::uint32_t index) {
    const InstanceId thing = w.state.joints[index].def.thing;
    if (thing && !(w.state.scene && w.state.scene->state(thing))) gone.push_back(index);
  });
  for (const std::uint32_t index : gone) {
    const Joint joint = w.state.joints[index].def;
    tell_end(w.state, index, joint.a);
    w.state.joints.erase(index);
    wake_ends(w, joint);
  }
}

void break_joint(WorldImpl& w, std::uint32_t index) {
  PHYSIM_ASSERT(w.state.joints[index].active && w.state.joints[index].def.break_force);
  const Joint joint = w.state.joints[index].def;
  w.state.joints.events.push_back(
      {JointEventKind::broke, w.state.joints.id_of(index), joint.a, w.state.clock.time(), 0});
  w.state.joints.erase(index);
  wake_ends(w, joint);
}

void end_joints_of(WorldImpl& w, std::uint32_t slot) {
  PHYSIM_ASSERT(slot > 0);
  const auto* joints = w.state.joints.empty() ? nullptr : w.state.joints.of_slot(slot);
  if (!joints) return;
  const ProjectileId who = w.state.slots.id_of(slot);
  for (const std::uint32_t index : std::vector<std::uint32_t>(*joints)) {
    const Joint& joint = w.state.joints[index].def;
    const ProjectileId other = joint.a == who ? joint.b : joint.a;
    tell_end(w.state, index, who);
    w.state.joints.erase(index);
    if (other && w.find(other) && w.state.slots[other.index].is(kAsleep)) w.wake(other.index);
  }
}

std::vector<JointId> World::joints() const {
  const Joints& all = impl().state.joints;
  std::vector<JointId> ids;
  all.each([&](std::uint32_t index) { ids.push_back(all.id_of(index)); });
  return ids;
}
const Joint* World::joint(JointId id) const {
  const HeldJoint* joint = impl().state.joints.find(id);
  return joint ? &joint->def : nullptr;
}
JointState World::joint_state(JointId id) const {
  const IeeeMode mode;
  const WorldState& state = impl().state;
  const HeldJoint* joint = state.joints.find(id);
  if (!joint) return {};
  const Joint& def = joint->def;
  const JointRow& kind = row_of(def.kind);
  const Vec3d between = between_ends(state, def);
  JointState now{.length = length(between), .tension = joint->tension, .force = joint->force};
  now.is_taut = def.kind != JointKind::cable || joint->is_taut;
  if (kind.turns) now.angle = angle_of(def, between);
  if (kind.slides) now.way = dot(def.axis, between);
  return now;
}
std::vector<JointEvent> World::joint_events() const { return impl().state.joints.events; }
JointCounts World::joint_counts() const {
  JointCounts counts = impl().state.joints.counts;
  counts.joints = impl().state.joints.count();
  return counts;
}

}  // namespace physim
