#include "simclient/gl/backdrop.hpp"

#include <algorithm>
#include <cmath>

#include "base/assert.hpp"
#include "simclient/gl/shaders.hpp"

namespace physim::client {

Backdrop::~Backdrop() {
  if (array_ == 0) return;
  glDeleteVertexArrays(1, &array_);
  glDeleteBuffers(1, &corners_);
  glDeleteFramebuffers(1, &framebuffer_);
  glDeleteTextures(1, &texture_);
}

Status Backdrop::make() {
  if (Status status = shader_.make("backdrop", kBackdropVertex, kBackdropFragment); !status) return status;
  glGenVertexArrays(1, &array_);
  glBindVertexArray(array_);
  glGenBuffers(1, &corners_);
  glBindBuffer(GL_ARRAY_BUFFER, corners_);
  constexpr float kWholeView[8] = {-1, -1, 1, -1, -1, 1, 1, 1};
  glBufferData(GL_ARRAY_BUFFER, sizeof kWholeView, kWholeView, GL_STATIC_DRAW);
  glEnableVertexAttribArray(0);
  glVertexAttribPointer(0, 2, GL_FLOAT, GL_FALSE, 0, nullptr);
  glBindVertexArray(0);
  glGenFramebuffers(1, &framebuffer_);
  glGenTextures(1, &texture_);
  return {};
}

bool Backdrop::begin(const Scene& scene, const Camera& camera, int width, int height, double part) {
  PHYSIM_ASSERT(part > 0 && part <= 1);
  width_ = width, height_ = height;
  const auto pixels = [part](int count) { return std::max(1, static_cast<int>(std::lround(count * part))); };
  Look look{camera.matrix(), camera.eye(),    camera.target,    scene.grid_origin, camera.distance, camera.stretch,
            scene.ground,    scene.grid_step, scene.has_ground, scene.theme,       pixels(width),   pixels(height)};
  if (look == look_) return false;
  const bool has_size = look.width == look_.width && look.height == look_.height;
  look_ = look;
  glBindTexture(GL_TEXTURE_2D, texture_);
  if (!has_size) {
    glTexImage2D(GL_TEXTURE_2D, 0, GL_RGBA8, look.width, look.height, 0, GL_RGBA, GL_UNSIGNED_BYTE, nullptr);
    const GLint filter = look.width == width && look.height == height ? GL_NEAREST : GL_LINEAR;
    for (const GLenum which : {GL_TEXTURE_MIN_FILTER, GL_TEXTURE_MAG_FILTER})
      glTexParameteri(GL_TEXTURE_2D, which, filter);
    for (const GLenum wrap : {GL_TEXTURE_WRAP_S, GL_TEXTURE_WRAP_T})
      glTexParameteri(GL_TEXTURE_2D, wrap, GL_CLAMP_TO_EDGE);
  }
  glBindTexture(GL_TEXTURE_2D, 0);
  glBindFramebuffer(GL_FRAMEBUFFER, framebuffer_);
  glFramebufferTexture2D(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_TEXTURE_2D, texture_, 0);
  glViewport(0, 0, look.width, look.height);
  glDisable(GL_SCISSOR_TEST);
  return true;
}

void Backdrop::put(int x, int y) const {
  shader_.use();
  glUniform2f(shader_.uniform("corner_at"), static_cast<float>(x), static_cast<float>(y));
  glUniform2f(shader_.uniform("size"), static_cast<float>(width_), static_cast<float>(height_));
  glUniform1i(shader_.uniform("kept"), 0);
  glActiveTexture(GL_TEXTURE0);
  glBindTexture(GL_TEXTURE_2D, texture_);
  glBindVertexArray(array_);
  glDrawArrays(GL_TRIANGLE_STRIP, 0, 4);
  glBindTexture(GL_TEXTURE_2D, 0);
}

}  // namespace physim::client
