// Scenery pass: the things of a scene, lit by a sun and the sky, and the shadows that they and the balls throw.
#pragma once

#include "simclient/core/scene.hpp"
#include "simclient/gl/shader.hpp"

namespace physim::client {

/// Where shadows fall: the sun's map of what is nearest to it, and the way from places relative to the eye into it.
struct ShadowMap {
  GLuint texture = 0, framebuffer = 0;
  Mat4 matrix{};
  double metres = 0;  // that the map is wide
};

class SceneryPass {
 public:
  static constexpr int kMapSize = 1024;  // pixels of the shadow map, along each side

  SceneryPass() = default;
  SceneryPass(const SceneryPass&) = delete;
  SceneryPass& operator=(const SceneryPass&) = delete;
  ~SceneryPass();
  [[nodiscard]] Status make();
  /// Before anything of a scenery is drawn.
  void upload(const Scenery& scenery);
  /// Begins the shadow map: things first; who draws more into it does so before end_shadows().
  /// `to_sun`: of length one.
  void begin_shadows(const Scenery& scenery, const Camera& camera, const Vec3d& to_sun);
  /// `framebuffer`: to draw into from now on.
  void end_shadows(GLuint framebuffer) const;
  /// Draws the things themselves. `haze`: where half of their colour is left [m].
  void draw(const Scene& scene, const Camera& camera, double haze) const;
  /// For shaders with the uniforms of kShadowLookup: where shadows fall, or that none do.
  void hand_shadows(const Shader& shader, bool are_there) const;
  [[nodiscard]] const ShadowMap& shadows() const { return map_; }

 private:
  void place(const Shader& shader, const Scenery& scenery, const Camera& camera) const;

  Shader lit_, dark_;
  GLuint array_ = 0, vertices_ = 0;
  std::uint64_t uploaded_ = 0;
  ShadowMap map_;
};

}  // namespace physim::client
