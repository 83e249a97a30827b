// SharedShape: a mesh or a height field, prepared once and shared by all that hold it.
#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <span>
#include <vector>

#include "physim/result.hpp"
#include "physim/scene.hpp"

namespace physim {

/// A mesh or a height field that particles come out of. Copies share it, and so do the world's snapshots; a save holds
/// it once, however many emitters have it.
class SharedShape {
 public:
  /// None.
  SharedShape() = default;
  /// Made of a MeshShape or a HeightFieldShape; its materials do not count. Errors are those of Scene::add_shape().
  [[nodiscard]] static Result<SharedShape> make(const ShapeDef& shape);
  /// The mesh or height field of a scene, which is not copied.
  [[nodiscard]] static Result<SharedShape> of(const Scene& scene, ShapeId shape);

  /// Whether there is one.
  explicit operator bool() const { return content_ != nullptr; }
  /// What it was made of, without materials; a plane where there is none.
  [[nodiscard]] ShapeDef definition() const;
  /// Tells shapes of different content apart; 0: none [-].
  [[nodiscard]] std::uint64_t hash() const;
  /// Equal in content.
  bool operator==(const SharedShape& other) const;

  /// All of it as bytes, for saves and recordings.
  [[nodiscard]] std::vector<std::byte> save() const;
  /// The shape of such bytes. An error where they are none.
  [[nodiscard]] static Result<SharedShape> load(std::span<const std::byte> save);

  struct Content;
  /// For the library; null: none.
  [[nodiscard]] const Content* content() const { return content_.get(); }

 private:
  std::shared_ptr<const Content> content_;
};

}  // namespace physim
