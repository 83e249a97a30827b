#include "simclient/gl/glow_pass.hpp"

#include "simclient/gl/shaders.hpp"

namespace physim::client {

GlowPass::~GlowPass() {
  if (array_ == 0) return;
  glDeleteVertexArrays(1, &array_);
  glDeleteBuffers(1, &corners_);
  glDeleteTextures(1, &texture_);
}

Status GlowPass::make() {
  if (Status status = shader_.make("glow", kGlowVertex, kGlowFragment); !status) return status;
  glGenVertexArrays(1, &array_);
  glBindVertexArray(array_);
  glGenBuffers(1, &corners_);
  glBindBuffer(GL_ARRAY_BUFFER, corners_);
  constexpr float kUnit[8] = {0, 0, 1, 0, 0, 1, 1, 1};
  glBufferData(GL_ARRAY_BUFFER, sizeof kUnit, kUnit, GL_STATIC_DRAW);
  glEnableVertexAttribArray(0);
  glVertexAttribPointer(0, 2, GL_FLOAT, GL_FALSE, 0, nullptr);
  glBindVertexArray(0);
  glGenTextures(1, &texture_);
  glBindTexture(GL_TEXTURE_2D, texture_);
  for (const GLenum which : {GL_TEXTURE_MIN_FILTER, GL_TEXTURE_MAG_FILTER})
    glTexParameteri(GL_TEXTURE_2D, which, GL_LINEAR);
  for (const GLenum wrap : {GL_TEXTURE_WRAP_S, GL_TEXTURE_WRAP_T})
    glTexParameteri(GL_TEXTURE_2D, wrap, GL_CLAMP_TO_EDGE);
  glBindTexture(GL_TEXTURE_2D, 0);
  return {};
}

void GlowPass::draw(const Scene& scene, const Camera& camera) const {
  const GlowMap& map = scene.glow;
  if (map.columns == 0) return;
  const auto part = [](double cells, double cell, double size) { return static_cast<float>(cells * cell / size); };
  shader_.use();
  glActiveTexture(GL_TEXTURE0);
  glBindTexture(GL_TEXTURE_2D, texture_);
  glPixelStorei(GL_UNPACK_ALIGNMENT, 1);
  glTexImage2D(GL_TEXTURE_2D, 0, GL_RGB8, map.columns, map.rows, 0, GL_RGB, GL_UNSIGNED_BYTE, map.light.data());
  glUniform1i(shader_.uniform("light"), 0);
  glUniform1f(shader_.uniform("cover"), static_cast<float>(scene.theme->glow_cover));
  glUniform4f(shader_.uniform("box"), part(map.left, map.cell, camera.width()),
              part(map.top, map.cell, camera.height()), part(map.columns, map.cell, camera.width()),
              part(map.rows, map.cell, camera.height()));
  glBlendFuncSeparate(GL_ONE, GL_ONE_MINUS_SRC_ALPHA, GL_ZERO, GL_ONE);
  glBindVertexArray(array_);
  glDrawArrays(GL_TRIANGLE_STRIP, 0, 4);
  glBlendFuncSeparate(GL_SRC_ALPHA, GL_ONE_MINUS_SRC_ALPHA, GL_ONE, GL_ONE_MINUS_SRC_ALPHA);
  glBindTexture(GL_TEXTURE_2D, 0);
}

}  // namespace physim::client
