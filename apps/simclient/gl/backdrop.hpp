// Backdrop: sky and ground, which look the same as long as the eye stands still. They are drawn once and kept.
#pragma once

#include "simclient/core/scene.hpp"
#include "simclient/gl/shader.hpp"

namespace physim::client {

class Backdrop {
 public:
  Backdrop() = default;
  Backdrop(const Backdrop&) = delete;
  Backdrop& operator=(const Backdrop&) = delete;
  ~Backdrop();
  [[nodiscard]] Status make();
  /// Returns true if the kept picture is out of date. The caller then draws sky and ground into the framebuffer that
  /// this call binds, over its whole viewport. `part`: kept pixels over shown ones along each side, 0 < part <= 1.
  [[nodiscard]] bool begin(const Scene& scene, const Camera& camera, int width, int height, double part);
  /// Draws the kept picture into the bound framebuffer, whose viewport begins at (x, y) and is as large as at begin().
  void put(int x, int y) const;

 private:
  /// All that sky and ground depend on.
  struct Look {
    Mat4 matrix{};
    Vec3d eye, target, grid_origin;
    double distance = 0, stretch = 0, ground = 0, grid_step = 0;
    bool has_ground = false;
    const Theme* theme = nullptr;
    int width = 0, height = 0;  // [pixels]
    bool operator==(const Look&) const = default;
  };

  Shader shader_;
  GLuint array_ = 0, corners_ = 0, framebuffer_ = 0, texture_ = 0;
  Look look_;
  int width_ = 0, height_ = 0;  // of where it is put [pixels]
};

}  // namespace physim::client
