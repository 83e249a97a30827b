// Renderer: draws a scene with OpenGL 3.3. Lines and balls are instances of one quad each, a crowd is points: any
// number of them is one call. Things of the world's scene are lit triangles; without them nothing needs depth.
#pragma once

#include "simclient/core/scene.hpp"
#include "simclient/gl/backdrop.hpp"
#include "simclient/gl/body_pass.hpp"
#include "simclient/gl/canvas.hpp"
#include "simclient/gl/glow_pass.hpp"
#include "simclient/gl/scenery_pass.hpp"
#include "simclient/gl/shader.hpp"
#include "simclient/gl/world_pass.hpp"

namespace physim::client {

/// A part of the framebuffer, in pixels from its lower left corner.
struct Viewport {
  int x = 0, y = 0, width = 0, height = 0;
};

/// What draws one kind of thing: a shader, and the buffers that it reads.
struct Pass {
  Shader shader;
  GLuint array = 0, corners = 0, instances = 0;
  ~Pass();
};

class Renderer {
 public:
  /// Where there is a context; before anything is drawn.
  [[nodiscard]] Status make();
  /// Into the framebuffer in use, which has depth where there are things to be seen.
  void draw(const Scene& scene, const Camera& camera, const Viewport& viewport);

 private:
  void draw_shadows(const Scene& scene, const Camera& camera);
  void draw_world(const Scene& scene, const Camera& camera, const Viewport& viewport);
  void draw_in(const Scene& scene, const Camera& camera, const Viewport& viewport);

  Pass line_, ball_, crowd_, round_crowd_, sprite_, disc_, ball_shadow_;
  WorldPass world_;
  Backdrop backdrop_;
  SceneryPass scenery_;
  BodyPass bodies_;
  GlowPass glow_;
  Canvas canvas_;
};

}  // namespace physim::client
