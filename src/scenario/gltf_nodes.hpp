// Nodes of glTF files, in double. Assimp keeps their matrices as floats, which are 31 mm apart at 500 km.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "physim/math.hpp"

namespace physim {

/// v -> x v.x + y v.y + z v.z + origin.
struct Affine {
  Vec3d x{1, 0, 0}, y{0, 1, 0}, z{0, 0, 1}, origin{};

  [[nodiscard]] Vec3d linear(const Vec3d& v) const { return x * v.x + y * v.y + z * v.z; }
  [[nodiscard]] Vec3d operator()(const Vec3d& v) const { return linear(v) + origin; }
  [[nodiscard]] Affine after(const Affine& inner) const {
    return {linear(inner.x), linear(inner.y), linear(inner.z), (*this)(inner.origin)};
  }
  [[nodiscard]] bool mirrors() const { return dot(cross(x, y), z) < 0; }
};

/// A file of glTF, text or binary, whose nodes have no transforms and are named by numbers.
struct GltfNodes {
  std::string text{};           ///< the file so changed
  std::vector<Affine> nodes{};  ///< from each node's frame into the file's

  /// The transform of a node by its name in the changed file; null if it has none.
  [[nodiscard]] const Affine* find(const std::string& name) const;
};

/// Nothing if the text is no glTF, or one whose nodes are not as the format wants them.
[[nodiscard]] std::optional<GltfNodes> gltf_nodes(const std::string& text);

}  // namespace physim
