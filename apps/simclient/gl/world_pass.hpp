// World pass: the sky, and the ground or the globe below it, in one look along each pixel's line of sight.
#pragma once

#include "simclient/core/scene.hpp"
#include "simclient/gl/scenery_pass.hpp"
#include "simclient/gl/shader.hpp"

namespace physim::client {

class WorldPass {
 public:
  WorldPass() = default;
  WorldPass(const WorldPass&) = delete;
  WorldPass& operator=(const WorldPass&) = delete;
  ~WorldPass();
  [[nodiscard]] Status make();
  /// Fills the viewport. `has_depth`: how far away the ground is goes into the depth buffer.
  void draw(const Scene& scene, const Camera& camera, const SceneryPass& scenery, bool has_depth) const;

 private:
  void place_ground(const Shader& shader, const Scene& scene, const Camera& camera) const;
  void place_globe(const Shader& shader, const SceneGlobe& globe, const Camera& camera) const;
  void draw_part(const Shader& shader, const Scene& scene, const Camera& camera, const SceneryPass& scenery,
                 double from, double part) const;

  Shader sky_, ground_, deep_ground_, shadowed_ground_, globe_;
  void make_stars();
  void draw_stars(const Scene& scene, const Camera& camera, bool has_depth) const;

  Shader star_;
  GLuint array_ = 0, corners_ = 0, unevenness_ = 0, star_array_ = 0, star_places_ = 0;
};

/// The part of the air that is left about the eye: high above the ground the sky is dark.
[[nodiscard]] double air_about(const Scene& scene, const Camera& camera);

}  // namespace physim::client
