// Many casts into one part of a scene: what a tube, the spheres about a segment, may touch is found once, and casts of
// what stays inside of it look at nothing else.
#pragma once

#include <array>
#include <cstdint>

#include "base/unset.hpp"
#include "collide/triangle.hpp"
#include "physim/scene.hpp"

namespace physim::collide {

class TubeCasts {
 public:
  /// Into a scene that does not change meanwhile; null: none. Before find() each cast asks the scene.
  TubeCasts(const Scene* scene, const SceneFilter& filter) : scene_(scene), filter_(filter) {}

  [[nodiscard]] const Scene& scene() const { return *scene_; }
  /// Finds what the spheres about a segment may touch. False where that is nothing.
  [[nodiscard]] bool find(const SceneSegment& tube);
  /// Scene::first_hit(), bit for bit. `is_wider`: spheres that are larger than what flies meet one-way things from all
  /// sides.
  [[nodiscard]] SceneHit first_hit(const SceneSegment& asked, bool is_wider = false) const;

 private:
  /// A triangle of a thing, in its frame.
  struct Near {
    Triangle triangle;
    Vec3d normal;  // zero where the triangle is too narrow for one
    std::uint32_t number;

    /// Whether no sphere about a segment comes to its plane: most triangles are told by that.
    [[nodiscard]] PHYSIM_INLINE bool is_apart(const Segment& s) const {
      const Vec3d off = s.from - triangle.a;
      const double one = dot(normal, off), other = one + dot(normal, s.along);
      // Thousands of times what all of this is rounded to.
      const double room = s.radius + 1e-9 * (s.extent() + std::abs(off.x) + std::abs(off.y) + std::abs(off.z));
      return std::min(one, other) > room || std::max(one, other) < -room;
    }
  };
  /// A thing, with those of its triangles that are near; others are asked whole.
  struct Thing {
    std::uint32_t index;
    std::uint32_t begin, end;
    bool is_whole;
  };
  static constexpr std::uint32_t kMostThings = 8, kMostTriangles = 32;

  [[nodiscard]] static Near near(const Triangle& triangle, std::uint32_t number);
  bool add(std::uint32_t index, const Segment& inside);
  [[nodiscard]] bool holds(const Vec3d& p, double radius) const;
  [[nodiscard]] bool holds(const SceneSegment& asked) const;

  const Scene* scene_;
  SceneFilter filter_;
  bool found_ = false;
  bool some_move_ = false;
  SceneSegment tube_;
  Vec3d along_;                  // of the tube
  double per_square_along_ = 0;  // 0 where that has no length [1/m^2]
  std::uint32_t things_ = 0, triangles_ = 0;
  Unset<std::array<Thing, kMostThings>> thing_;
  Unset<std::array<Near, kMostTriangles>> near_;
};

}  // namespace physim::collide
