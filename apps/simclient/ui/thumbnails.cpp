#include "simclient/ui/thumbnails.hpp"

#include <algorithm>
#include <chrono>
#include <cmath>

#include "simclient/gl/target.hpp"

namespace physim::client {
namespace {

int pixels(int size, float scale) { return static_cast<int>(std::lround(static_cast<float>(size) * scale)); }

GLuint texture_of(const Picture& picture) {
  GLuint texture = 0;
  glGenTextures(1, &texture);
  glBindTexture(GL_TEXTURE_2D, texture);
  glPixelStorei(GL_UNPACK_ALIGNMENT, 1);
  glTexImage2D(GL_TEXTURE_2D, 0, GL_RGB8, picture.width, picture.height, 0, GL_RGB, GL_UNSIGNED_BYTE,
               picture.pixels.data());
  for (const GLenum filter : {GL_TEXTURE_MIN_FILTER, GL_TEXTURE_MAG_FILTER})
    glTexParameteri(GL_TEXTURE_2D, filter, GL_LINEAR);
  for (const GLenum wrap : {GL_TEXTURE_WRAP_S, GL_TEXTURE_WRAP_T})
    glTexParameteri(GL_TEXTURE_2D, wrap, GL_CLAMP_TO_EDGE);
  glBindTexture(GL_TEXTURE_2D, 0);
  return texture;
}

/// Thicker than in a window of this size: a picture is small.
constexpr double kThickness = 1.1;

GLuint drawn(Pose& pose, Renderer& renderer, const Theme& theme, float scale) {
  Client& client = pose.client;
  client.theme = &theme;
  Scene scene;
  build_scene(client, scale * kThickness, scene);
  scene.labels.clear();
  for (std::size_t i = 0; i < pose.paths.size(); ++i)
    scene.polyline(pose.paths[i], client.camera, palette(i), 2.4 * kThickness * static_cast<double>(scale));
  const int width = static_cast<int>(client.camera.width()), height = static_cast<int>(client.camera.height());
  const Target target(width, height);
  target.bind();
  renderer.draw(scene, client.camera, {0, 0, width, height});
  const GLuint texture = texture_of(read_picture(0, 0, width, height));
  glBindFramebuffer(GL_FRAMEBUFFER, 0);
  return texture;
}

}  // namespace

Thumbnails::~Thumbnails() {
  for (const auto& [name, texture] : textures_)
    if (texture != 0) glDeleteTextures(1, &texture);
}

GLuint Thumbnails::of(std::string_view scenario) {
  if (const auto found = textures_.find(scenario); found != textures_.end()) return found->second;
  if (name_ != scenario && std::ranges::count(wanted_, scenario) == 0) wanted_.emplace_back(scenario);
  return 0;
}

void Thumbnails::begin_next(float scale) {
  if (flying_.valid() || wanted_.empty()) return;
  name_ = wanted_.front();
  wanted_.erase(wanted_.begin());
  flying_ = std::async(std::launch::async, [name = name_, width = pixels(kWidth, scale),
                                            height = pixels(kHeight, scale)] { return pose_of(name, width, height); });
}

void Thumbnails::take(Renderer& renderer, const Theme& theme, float scale) {
  Result<Pose> pose = flying_.get();
  textures_[name_] = pose ? drawn(*pose, renderer, theme, scale) : 0;  // 0: its file is not there, or is broken
  name_.clear();
}

bool Thumbnails::advance(Renderer& renderer, const Theme& theme, float scale, bool waits) {
  if (theme_ != &theme) {  // drawn anew in other light, when they are looked at
    for (const auto& [name, texture] : textures_)
      if (texture != 0) glDeleteTextures(1, &texture);
    textures_.clear();
    theme_ = &theme;
  }
  bool has_come = false;
  do {
    begin_next(scale);
    if (!flying_.valid()) break;
    const bool is_ready = waits || flying_.wait_for(std::chrono::seconds(0)) == std::future_status::ready;
    if (!is_ready) break;
    take(renderer, theme, scale);
    has_come = true;
  } while (waits);
  begin_next(scale);
  return has_come;
}

}  // namespace physim::client
