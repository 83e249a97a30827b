// Joints: the rods, cables, springs, hinges and sliders of a world; what they hold, and their state in the last step.
//
// All fly their step as if alone, with their contacts. Then each net of joints is solved (world/core/joint_solver.hpp),
// in the order of its joints, on one thread, and what it holds is put where it holds it. From step to step nothing
// is kept but the joints themselves, so snapshots and saves hold no more. Those of a net sleep and wake together.
#pragma once

#include <unordered_map>
#include <vector>

#include "base/assert.hpp"
#include "base/hash.hpp"
#include "physim/event.hpp"
#include "physim/result.hpp"
#include "physim/world.hpp"
#include "world/core/joint_solver.hpp"

namespace physim {

/// A joint of a world.
struct HeldJoint {
  std::uint32_t generation = 1;
  bool active = false;
  Joint def;  // with its length
  // What the last step came to, to be shown only.
  double tension = 0;  // [N]
  bool is_taut = false;
  double force = 0;  // of all that it keeps [N]
};

/// What carries the point and the axis of a joint: the world, or a thing of its scene.
struct JointFrame {
  Vec3d place{};     // of the point; none if the joint has a second projectile [m]
  Vec3d velocity{};  // [m/s]
  Quatd rotation{};  // from the frame of `thing` to W [-]
  Vec3d turn{};      // [rad/s]
};

class Joints {
 public:
  [[nodiscard]] bool empty() const { return count_ == 0; }
  [[nodiscard]] std::size_t count() const { return count_; }
  [[nodiscard]] std::uint32_t size() const { return static_cast<std::uint32_t>(all_.size()); }
  [[nodiscard]] HeldJoint& operator[](std::uint32_t index) {
    PHYSIM_ASSERT(index > 0 && index < all_.size());
    return all_[index];
  }
  [[nodiscard]] const HeldJoint& operator[](std::uint32_t index) const {
    PHYSIM_ASSERT(index > 0 && index < all_.size());
    return all_[index];
  }
  [[nodiscard]] const HeldJoint* find(JointId id) const {
    if (id.index == 0 || id.index >= all_.size()) return nullptr;
    const HeldJoint& joint = all_[id.index];
    return joint.active && joint.generation == id.generation ? &joint : nullptr;
  }
  [[nodiscard]] JointId id_of(std::uint32_t index) const { return {index, (*this)[index].generation}; }
  /// Indices of the joints of a slot, in order; null: none.
  [[nodiscard]] const std::vector<std::uint32_t>* of_slot(std::uint32_t slot) const {
    const auto at = of_slot_.find(slot);
    return at == of_slot_.end() ? nullptr : &at->second;
  }

  JointId add(const Joint& joint);
  void erase(std::uint32_t index);
  /// At the end of a step; beyond what a save may hold it stays.
  void move_point(std::uint32_t index, const Vec3d& to);
  /// Calls f with the index of every joint that there is, in order.
  template <class F>
  void each(const F& f) const {
    for (std::uint32_t index = 1; index < all_.size(); ++index)
      if (all_[index].active) f(index);
  }

  [[nodiscard]] std::size_t bytes() const;
  /// Nothing where there never was any.
  void add_to(Hash& hash) const;

  // ------------------------------------------------------------------------------------------- as a save tells it
  [[nodiscard]] const std::vector<HeldJoint>& all() const { return all_; }  // the first is unused
  [[nodiscard]] const std::vector<std::uint32_t>& free() const { return free_; }
  /// False where that makes no sense.
  bool restore(std::vector<HeldJoint> all, std::vector<std::uint32_t> free);

  std::vector<JointEvent> events;  // since the last step began
  JointCounts counts;              // but for the joints

 private:
  void join(std::uint32_t index);

  std::vector<HeldJoint> all_{1};  // 0 is unused
  std::vector<std::uint32_t> free_;
  std::size_t count_ = 0;
  std::unordered_map<std::uint32_t, std::vector<std::uint32_t>> of_slot_;
};

/// A bounce of a held projectile, flown without its joints, in the step at hand.
struct HeldBounce {
  std::uint32_t held;             // among those held
  double time = 0;                // of the world [s]
  Vec3d place, velocity, normal;  // after it [m], [m/s], [-]
};

/// A held projectile, in the step at hand.
struct HeldBody {
  ProjectileId id;
  BodyState start;            // when the step began
  bool meets_others = false;  // it bounced off things that move, or off projectiles
};

/// Memory that steps use again and again.
struct JointScratch {
  double began = 0;                              // time of the step at hand [s]
  std::vector<HeldBody> held;                    // in order of slots
  std::vector<HeldBounce> bounces;               // in order of those held, then of time
  std::vector<std::vector<std::uint32_t>> nets;  // joints that hold together, neighbours near each other
  std::vector<std::uint32_t> broken;             // joints that pulled or pushed with more than their break_force
  std::vector<Event> apexes;                     // of those held
};

struct WorldImpl;
class WorldState;

[[nodiscard]] Status check(const Joint& joint);
/// Whether it has all that add_joint() adds to what it is given.
[[nodiscard]] bool is_complete(const Joint& joint);
/// Where the point of a joint is at a time of the world, `ahead` after the moment that Joint::point is of [s].
[[nodiscard]] JointFrame frame_of(const WorldState& state, const Joint& joint, double time, double ahead);
/// The angle of a hinge whose ends are so apart, in the frame of its point [rad].
[[nodiscard]] double angle_of(const Joint& joint, const Vec3d& between);
/// Before a step: stores the state of held projectiles; nets with a moving member or point wake as a whole.
void begin_joints(WorldImpl& world, double dt);
/// After it: puts held projectiles where joints hold them.
void hold_joints(WorldImpl& world, double dt);
/// Ends a joint that broke, with an event, and wakes what it held.
void break_joint(WorldImpl& world, std::uint32_t index);
/// Ends the joints of a projectile that leaves, with events.
void end_joints_of(WorldImpl& world, std::uint32_t slot);
/// Ends the joints at things that are gone, with events.
void end_joints_at_gone_things(WorldImpl& world);

}  // namespace physim
