// Body pass: meshes of bodies, lit, each at its attitude.
#pragma once

#include <array>

#include "simclient/core/scene.hpp"
#include "simclient/gl/shader.hpp"

namespace physim::client {

class BodyPass {
 public:
  BodyPass() = default;
  BodyPass(const BodyPass&) = delete;
  BodyPass& operator=(const BodyPass&) = delete;
  ~BodyPass();
  [[nodiscard]] Status make();
  /// Into a framebuffer with depth, which is tested and written. `has_depth`: it knows how far away other things are.
  void draw(const Scene& scene, const Camera& camera, bool has_depth) const;

 private:
  struct Range {
    GLint first = 0;
    GLsizei count = 0;
  };
  Shader shader_;
  GLuint array_ = 0, vertices_ = 0;
  std::array<Range, kBodyShapes> ranges_;
};

/// The factor by which a body is drawn larger than it is, at least 1.
[[nodiscard]] double enlargement(const SceneBody& body, const Camera& camera);

}  // namespace physim::client
