// What a SharedShape holds.
#pragma once

#include <atomic>
#include <memory>

#include "collide/shape.hpp"
#include "physim/scene.hpp"

namespace physim {

struct SharedShape::Content {
  std::shared_ptr<const collide::Shape> shape;    // a mesh or a height field
  mutable std::atomic<std::uint64_t> hash_of{0};  // of its definition; 0: nobody has asked yet

  [[nodiscard]] const collide::Mesh* mesh() const { return std::get_if<collide::Mesh>(shape.get()); }
  [[nodiscard]] const collide::HeightField* field() const { return std::get_if<collide::HeightField>(shape.get()); }
};

}  // namespace physim
