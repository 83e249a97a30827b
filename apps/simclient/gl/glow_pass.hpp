// Glow pass: lays the light of hot particles over the picture.
#pragma once

#include "simclient/core/scene.hpp"
#include "simclient/gl/shader.hpp"

namespace physim::client {

class GlowPass {
 public:
  GlowPass() = default;
  GlowPass(const GlowPass&) = delete;
  GlowPass& operator=(const GlowPass&) = delete;
  ~GlowPass();
  [[nodiscard]] Status make();
  /// Into a viewport as large as the camera's. Blending is on, and as it was afterwards.
  void draw(const Scene& scene, const Camera& camera) const;

 private:
  Shader shader_;
  GLuint array_ = 0, corners_ = 0, texture_ = 0;
};

}  // namespace physim::client
