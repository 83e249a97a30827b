// The scenes that casts and worlds are timed in: hills, and a town.
#pragma once

#include <cmath>

#include "cast_peers.hpp"
#include "physim/scene.hpp"
#include "random_shots.hpp"

namespace physim::bench {

inline constexpr std::uint32_t kPoints = 225;  // along a side of the terrain: 100 352 triangles
inline constexpr float kSpacing = 4.5f;        // [m]

/// Height of the terrain at a point of its grid [m].
[[nodiscard]] float ground(std::uint32_t column, std::uint32_t row);
/// A terrain of so many points along each side.
[[nodiscard]] CastMesh terrain(std::uint32_t points);
/// Four walls and a roof with a ridge.
[[nodiscard]] CastMesh house();
/// Where so many houses stand, 22 m from each other or a little more.
[[nodiscard]] std::vector<CastPlace> streets(int houses);

[[nodiscard]] MeshShape as_shape(const CastMesh& mesh);
[[nodiscard]] Transform as_transform(const CastPlace& place);
/// A mesh at each of some places; without places, where it is.
[[nodiscard]] Scene scene_of(const CastMesh& mesh, const std::vector<CastPlace>& places);
/// The terrain as heights over a grid.
[[nodiscard]] Scene field_scene();

/// Segments of 5 to 15 m about places; `height(x, z)` is what they fly over.
template <class Height>
[[nodiscard]] std::vector<CastSegment> segments_over(std::size_t count, double width, double depth,
                                                     const Height& height) {
  test::Random r(9);
  std::vector<CastSegment> list;
  while (list.size() < count) {
    const double x = r.in(20, width - 20), z = r.in(20, depth - 20), y = height(x, z) + r.in(0.2, 9);
    const Vec3d way = normalized(Vec3d{r.in(-1, 1), r.in(-0.7, 0.3), r.in(-1, 1)}) * r.in(5, 15);
    list.push_back({{static_cast<float>(x), static_cast<float>(y), static_cast<float>(z)},
                    {static_cast<float>(x + way.x), static_cast<float>(y + way.y), static_cast<float>(z + way.z)}});
  }
  return list;
}

}  // namespace physim::bench
