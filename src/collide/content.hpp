// What a scene holds: shapes, materials and things, and the trees in which these are found.
#pragma once

#include <atomic>
#include <memory>
#include <string>
#include <vector>

#include "collide/engine.hpp"
#include "collide/path.hpp"
#include "collide/question.hpp"
#include "collide/resting.hpp"
#include "collide/shape.hpp"
#include "collide/tree.hpp"

namespace physim::collide {

struct SceneContent {
  struct ShapeSlot {
    std::uint32_t generation = 0;
    std::uint32_t uses = 0;  // instances and compounds that have it
    std::shared_ptr<const Shape> shape;
    std::shared_ptr<std::atomic<std::uint64_t>> hash;  // of its definition; 0: nobody has asked yet
    std::vector<std::uint32_t> parts;                  // of a compound: the shapes that it uses
  };
  struct InstanceSlot {
    // What questions look at comes first.
    std::shared_ptr<const Shape> shape;
    std::uint32_t layers = 0;  // as in `def`
    bool sensor = false;       // as in `def`
    bool one_way = false;      // `def.passage.front` is a direction
    bool alive = false;
    std::uint32_t generation = 0;
    std::uint32_t leaf = Tree::kNone;  // of `moving`
    Placement placement;               // where it stands at rest
    std::shared_ptr<const Path> path;  // none: it rests
    InstanceDef def;

    /// Has what questions look at brought from memory.
    void prefetch() const {
      prefetch_at(this);
      prefetch_at(this, 64);
      prefetch_at(this, 128);
    }
    [[nodiscard]] bool is_asked(const SceneFilter& filter) const {
      return (layers & filter.layers) != 0 && (filter.sensors || !sensor);
    }
    /// Whether a surface of a normal, in the thing's frame, faces the front of a one-way thing.
    [[nodiscard]] bool is_front(const Vec3d& normal) const {
      constexpr double kFacing = 0.5;  // cosine
      return dot(normal, def.passage.front) > kFacing * length(def.passage.front);
    }
    /// Whether a one-way thing lets a segment through, by which it is crossed so.
    [[nodiscard]] bool lets_through(const SceneFilter& filter, const Crossing& crossing) const {
      if (!one_way || !filter.from_front) return false;
      return crossing.starts_inside || !crossing.entering || !is_front(crossing.normal);
    }
    [[nodiscard]] Placement placement_at(double time) const { return path ? path->placement(time) : placement; }
    [[nodiscard]] MotionState state_at(double time) const {
      return path ? path->at(time) : MotionState{def.transform.position, normalized(def.transform.rotation), {}, {}};
    }
  };

  std::vector<ShapeSlot> shapes{1};
  std::vector<InstanceSlot> instances{1};
  std::vector<std::uint32_t> free_shapes, free_instances;
  std::vector<std::uint32_t> unbounded;  // instances that no box holds, in order
  std::vector<std::uint32_t> movers;     // the others that move, in order
  std::vector<std::uint32_t> fields;     // height fields that rest, in order
  std::vector<Material> materials{Material{}};
  RestingThings resting;
  Tree moving;                              // its boxes hold the way of what moves over the time that is covered
  double covered_from = 0, covered_to = 0;  // [s]
  std::size_t alive = 0;
  std::size_t sensors = 0, in_motion = 0;                   // of those
  std::size_t meshes = 0;                                   // of those
  std::size_t conveyors = 0, one_ways = 0, tells_stay = 0;  // of those
  std::uint64_t changes = 0;
  std::shared_ptr<const Engine> engine;  // null: none

  [[nodiscard]] const ShapeSlot* find(ShapeId id) const {
    if (id.index == 0 || id.index >= shapes.size()) return nullptr;
    const ShapeSlot& slot = shapes[id.index];
    return slot.shape && slot.generation == id.generation ? &slot : nullptr;
  }
  [[nodiscard]] const InstanceSlot* find(InstanceId id) const {
    if (id.index == 0 || id.index >= instances.size()) return nullptr;
    const InstanceSlot& slot = instances[id.index];
    return slot.alive && slot.generation == id.generation ? &slot : nullptr;
  }
  [[nodiscard]] InstanceSlot* find(InstanceId id) { return const_cast<InstanceSlot*>(std::as_const(*this).find(id)); }

  /// A shape, ready to be met; of a compound, also the shapes that it uses.
  [[nodiscard]] Result<Shape> prepare(const ShapeDef& def, std::vector<std::uint32_t>& parts) const;
  /// Keeps a shape in a slot that is free.
  void put(ShapeSlot& slot, Shape&& shape, std::vector<std::uint32_t>&& parts);
  /// The path of what moves, none of what rests; an error where the definition is none of this scene.
  [[nodiscard]] Result<std::shared_ptr<const Path>> check(const InstanceDef& def) const;
  /// Lets a thing stand in a slot that is free.
  void put(std::uint32_t index, const InstanceDef& def, std::shared_ptr<const Path>&& path);
  void remove(std::uint32_t index);
  /// Gives a thing another transform, motion and path.
  void set_motion(std::uint32_t index, const Transform& at, const SceneMotion& motion,
                  std::shared_ptr<const Path>&& path);
  void cover(double from, double to);

 private:
  void enter_tree(std::uint32_t index);
  void leave_tree(std::uint32_t index);
};

[[nodiscard]] Status check(const Transform& t, const std::string& place);

/// Takes a slot that is free, or a new one.
template <class Slots>
[[nodiscard]] std::uint32_t take_slot(Slots& slots, std::vector<std::uint32_t>& free) {
  if (free.empty()) {
    slots.emplace_back();
    return static_cast<std::uint32_t>(slots.size() - 1);
  }
  const std::uint32_t index = free.back();
  free.pop_back();
  return index;
}

}  // namespace physim::collide

namespace physim {

struct Scene::Impl : collide::SceneContent {};

}  // namespace physim
