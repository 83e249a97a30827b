// Renderer: draws a scene with OpenGL 3.3. Lines and balls are instances of one quad each, a crowd is points: any
// number of them is one call.
#pragma once

#include <vector>

#include "simclient/core/scene.hpp"
#include "simclient/gl/shader.hpp"

namespace physim::client {

/// A part of the framebuffer, in pixels from its lower left corner.
struct Viewport {
  int x = 0, y = 0, width = 0, height = 0;
};

class Renderer {
 public:
  [[nodiscard]] static Result<Renderer> make();
  Renderer(Renderer&& other) noexcept;
  Renderer& operator=(Renderer&&) = delete;
  ~Renderer();

  void draw(const Scene& scene, const Camera& camera, const Viewport& viewport);

 private:
  // As the shaders read them; positions are relative to the eye.
  struct LineInstance {
    float a[3], b[3];
    std::uint8_t colour[4];
    float width, fog;
  };
  struct BallInstance {
    float at[3];
    std::uint8_t colour[4];
    float radius, pixels;
  };
  struct DotInstance {
    float at[3];
    std::uint8_t colour[4];
  };
  struct Mesh {
    GLuint array = 0, corners = 0, instances = 0;
  };

  Renderer() = default;
  void make_meshes();
  void draw_ground(const Scene& scene, const Camera& camera, const Mat4& matrix);
  void draw_lines(const Scene& scene, const Camera& camera, const Mat4& matrix);
  void draw_crowd(const Scene& scene, const Camera& camera, const Mat4& matrix);
  void draw_balls(const Scene& scene, const Camera& camera, const Mat4& matrix);

  Shader ground_shader_, line_shader_, ball_shader_, crowd_shader_;
  Mesh ground_, line_, ball_, crowd_;
  std::vector<LineInstance> line_data_;
  std::vector<BallInstance> ball_data_;
  std::vector<DotInstance> crowd_data_;
};

}  // namespace physim::client
