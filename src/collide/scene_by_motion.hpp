// What of a scene rests and what of it moves, for those who keep what they found out about the one and look at the
// other in every step.
#pragma once

#include <optional>
#include <span>
#include <vector>

#include "base/function_ref.hpp"
#include "collide/clear_batch.hpp"
#include "collide/content.hpp"

namespace physim {

class SceneByMotion {
 public:
  explicit SceneByMotion(const Scene& scene) : content_(*scene.impl_) {}

  [[nodiscard]] const collide::SceneContent& content() const { return content_; }

  /// Scene::clearance() of what rests.
  [[nodiscard]] double clearance(const Vec3d& point, double reach, const SceneFilter& filter) const;
  /// Scene::clear_part() of what rests.
  [[nodiscard]] double clear_part(const SceneSegment& segment, const SceneFilter& filter) const;
  /// That of several, which may be faster.
  void clear_parts(std::span<collide::ClearQuery> queries) const;
  /// Whether a segment meets anything that moves.
  [[nodiscard]] bool meets_mover(const SceneSegment& segment, const SceneFilter& filter) const;

  /// Calls f with the place of each thing that is nearest to a point, if it is no farther than `within`, in order of
  /// the things.
  void each_beside(const Vec3d& point, double within, const SceneFilter& filter, double time,
                   FunctionRef<void(const SceneNearest&)> f) const;

  /// Whether something moves that no box holds.
  [[nodiscard]] bool has_boundless_movers() const;
  /// Adds boxes that hold the ways of all else that moves over the time that is covered.
  void add_boxes_of_movers(std::vector<collide::Bounds>& boxes) const;

  /// What a thing that moves does from a time on, until its motion may change at once.
  struct Ride {
    const Carriage* by = nullptr;  // null: it rests, or is gone
    const collide::Path::Piece* piece = nullptr;
    double lasts = kInfinity;  // [s]

    [[nodiscard]] bool turns() const { return piece && piece->rate != 0; }
  };
  [[nodiscard]] Ride ride(std::uint32_t index, double time) const;
  /// The scale of a thing that is there [-].
  [[nodiscard]] double scale(InstanceId thing) const { return content_.instances[thing.index].def.transform.scale; }
  /// Whether something is there, and rests.
  [[nodiscard]] bool rests(std::uint32_t index) const;
  /// The box of something; none where it moves, is gone, or no box holds it.
  [[nodiscard]] std::optional<collide::Bounds> box_at_rest(std::uint32_t index) const;

 private:
  const collide::SceneContent& content_;
};

}  // namespace physim
