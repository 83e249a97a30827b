// Other people's scenes, behind plain classes: their files are compiled with every instruction of this machine, so
// nothing of the library may be instantiated in them.
#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <vector>

namespace physim::bench {

/// Triangles with corners in W.
struct CastMesh {
  std::vector<float> vertices;           // x, y, z of each [m]
  std::vector<std::uint32_t> triangles;  // three corners of each
};
/// Where a mesh stands: turned about the y axis, then moved.
struct CastPlace {
  float position[3];   // [m]
  float cosine, sine;  // of its turn
};
struct CastSegment {
  float from[3], to[3];  // [m]
};

class CastPeer {
 public:
  virtual ~CastPeer() = default;
  /// Part of each segment's way at which it meets something first; 2 where it meets nothing.
  virtual void cast(const std::vector<CastSegment>& segments, std::vector<float>& parts) = 0;
};

/// A mesh at each of some places; without places, where it is.
[[nodiscard]] std::unique_ptr<CastPeer> bullet_scene(const CastMesh& mesh, const std::vector<CastPlace>& places);
/// Embree 3; nothing where it was not found when this was built.
[[nodiscard]] std::unique_ptr<CastPeer> embree_scene(const CastMesh& mesh, const std::vector<CastPlace>& places,
                                                     bool packets);

}  // namespace physim::bench
