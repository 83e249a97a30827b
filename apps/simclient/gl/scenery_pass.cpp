#include "simclient/gl/scenery_pass.hpp"

#include <algorithm>
#include <cmath>

#include "simclient/gl/shaders.hpp"

namespace physim::client {
namespace {

constexpr double kShadowReach = 1.4;  // half of the map's width, in distances of the eye from its target

GLsizei count_of(std::size_t vertices) { return static_cast<GLsizei>(vertices); }

/// From places relative to the eye to the sun's map, about the camera's target.
Mat4 sun_matrix(const Scenery& scenery, const Camera& camera, const Vec3d& sun, double reach) {
  const Vec3d right = normalized(cross(Vec3d{0, 1, 0}, sun)), up = cross(sun, right);
  // Whole pixels of the map stay where they are in the world, so that edges of shadows do not crawl as the eye moves.
  const double pixel = 2 * reach / SceneryPass::kMapSize;
  const auto snapped = [&](const Vec3d& axis) {
    const double at = dot(camera.target, axis);
    return dot(camera.target - camera.eye(), axis) + std::floor(at / pixel) * pixel - at;
  };
  double depth = 3 * reach;
  if (scenery.has_size)
    depth += length(camera.shown(scenery.low) - camera.target) + length(camera.shown(scenery.high) - camera.target);
  const double middle = dot(camera.target - camera.eye(), sun);
  const auto g = [](double x) { return static_cast<float>(x); };
  const double x = 1 / reach, z = -1 / depth;
  return {g(right.x * x), g(up.x * x), g(sun.x * z), 0, g(right.y * x),         g(up.y * x),         g(sun.y * z),   0,
          g(right.z * x), g(up.z * x), g(sun.z * z), 0, g(-snapped(right) * x), g(-snapped(up) * x), g(-middle * z), 1};
}

}  // namespace

SceneryPass::~SceneryPass() {
  if (array_ == 0) return;
  glDeleteVertexArrays(1, &array_);
  glDeleteBuffers(1, &vertices_);
  glDeleteFramebuffers(1, &map_.framebuffer);
  glDeleteTextures(1, &map_.texture);
}

Status SceneryPass::make() {
  if (Status status = lit_.make("things", kThingVertex, kThingFragment); !status) return status;
  if (Status status = dark_.make("shadows", kThingVertex, kShadowFragment); !status) return status;
  glGenVertexArrays(1, &array_);
  glGenBuffers(1, &vertices_);
  glBindVertexArray(array_);
  glBindBuffer(GL_ARRAY_BUFFER, vertices_);
  read_lit_vertices();
  glBindVertexArray(0);
  glGenTextures(1, &map_.texture);
  glBindTexture(GL_TEXTURE_2D, map_.texture);
  glTexImage2D(GL_TEXTURE_2D, 0, GL_DEPTH_COMPONENT24, kMapSize, kMapSize, 0, GL_DEPTH_COMPONENT, GL_FLOAT, nullptr);
  for (const GLenum filter : {GL_TEXTURE_MIN_FILTER, GL_TEXTURE_MAG_FILTER})
    glTexParameteri(GL_TEXTURE_2D, filter, GL_LINEAR);
  for (const GLenum wrap : {GL_TEXTURE_WRAP_S, GL_TEXTURE_WRAP_T})
    glTexParameteri(GL_TEXTURE_2D, wrap, GL_CLAMP_TO_EDGE);
  glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_COMPARE_MODE, GL_COMPARE_REF_TO_TEXTURE);
  glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_COMPARE_FUNC, GL_LEQUAL);
  glBindTexture(GL_TEXTURE_2D, 0);
  glGenFramebuffers(1, &map_.framebuffer);
  return {};
}

void SceneryPass::upload(const Scenery& scenery) {
  if (uploaded_ == scenery.version) return;
  uploaded_ = scenery.version;
  glBindBuffer(GL_ARRAY_BUFFER, vertices_);
  glBufferData(GL_ARRAY_BUFFER, static_cast<GLsizeiptr>(scenery.vertices.size() * sizeof(LitVertex)),
               scenery.vertices.data(), GL_DYNAMIC_DRAW);
}

/// Vertices are relative to the scenery's origin, and what is drawn is relative to the eye.
void SceneryPass::place(const Shader& shader, const Scenery& scenery, const Camera& camera) const {
  const Vec3d way = camera.shown(scenery.origin) - camera.eye();
  glUniform3f(shader.uniform("origin"), static_cast<float>(way.x), static_cast<float>(way.y),
              static_cast<float>(way.z));
  glUniform1f(shader.uniform("stretch"), static_cast<float>(camera.stretch));
}

void SceneryPass::begin_shadows(const Scenery& scenery, const Camera& camera, const Vec3d& to_sun) {
  const double reach = kShadowReach * camera.distance;
  map_.matrix = sun_matrix(scenery, camera, to_sun, reach);
  map_.metres = 2 * reach;
  glBindFramebuffer(GL_FRAMEBUFFER, map_.framebuffer);
  glFramebufferTexture2D(GL_FRAMEBUFFER, GL_DEPTH_ATTACHMENT, GL_TEXTURE_2D, map_.texture, 0);
  glDrawBuffer(GL_NONE);
  glViewport(0, 0, kMapSize, kMapSize);
  glDisable(GL_SCISSOR_TEST);
  glEnable(GL_DEPTH_TEST);
  glDepthMask(GL_TRUE);
  glDepthFunc(GL_LEQUAL);
  glClear(GL_DEPTH_BUFFER_BIT);
  glEnable(GL_POLYGON_OFFSET_FILL);
  glPolygonOffset(2.5F, 6);
  dark_.use();
  glUniformMatrix4fv(dark_.uniform("matrix"), 1, GL_FALSE, map_.matrix.data());
  place(dark_, scenery, camera);
  glBindVertexArray(array_);
  glDrawArrays(GL_TRIANGLES, 0, count_of(scenery.solid));
}

void SceneryPass::end_shadows(GLuint framebuffer) const {
  glDisable(GL_POLYGON_OFFSET_FILL);
  glDisable(GL_DEPTH_TEST);
  glBindFramebuffer(GL_FRAMEBUFFER, framebuffer);
}

void SceneryPass::hand_shadows(const Shader& shader, bool are_there) const {
  glUniform1i(shader.uniform("has_shadows"), are_there ? 1 : 0);
  glUniform1i(shader.uniform("shadow_map"), 0);
  glUniformMatrix4fv(shader.uniform("sun"), 1, GL_FALSE, map_.matrix.data());
  glActiveTexture(GL_TEXTURE0);
  glBindTexture(GL_TEXTURE_2D, are_there ? map_.texture : 0);
}

void SceneryPass::draw(const Scene& scene, const Camera& camera, double haze) const {
  const Scenery& scenery = *scene.scenery;
  const Theme& theme = *scene.theme;
  lit_.use();
  glUniformMatrix4fv(lit_.uniform("matrix"), 1, GL_FALSE, camera.matrix().data());
  place(lit_, scenery, camera);
  const Vec3d sun = theme.to_sun();
  glUniform3f(lit_.uniform("to_sun"), static_cast<float>(sun.x), static_cast<float>(sun.y), static_cast<float>(sun.z));
  for (const auto& [name, colour] : {std::pair{"sunlight_colour", theme.sunlight},
                                     {"skylight", theme.skylight},
                                     {"earthlight", theme.earthlight},
                                     {"horizon", theme.horizon}})
    hand_colour(lit_, name, colour);
  glUniform1f(lit_.uniform("map_pixel"), static_cast<float>(map_.metres / kMapSize));
  glUniform1f(lit_.uniform("haze"), static_cast<float>(haze));
  // Heights are measured from the ground or the origin, as they are drawn.
  const double contour = scene.contour_step * camera.stretch;
  const double eye = camera.eye().y - camera.shown({0, scene.ground, 0}).y;
  glUniform1f(lit_.uniform("contour_step"), static_cast<float>(contour));
  glUniform1f(lit_.uniform("contour_at"), static_cast<float>(std::fmod(eye / contour, 1.0)));
  hand_shadows(lit_, scene.has_shadows());
  glBindVertexArray(array_);
  glEnable(GL_POLYGON_OFFSET_FILL);
  glPolygonOffset(1, 4);  // lines that lie on things are seen
  glDrawArrays(GL_TRIANGLES, 0, count_of(scenery.solid));
  glDepthMask(GL_FALSE);
  glDrawArrays(GL_TRIANGLES, static_cast<GLint>(scenery.solid), count_of(scenery.vertices.size() - scenery.solid));
  glDepthMask(GL_TRUE);
  glDisable(GL_POLYGON_OFFSET_FILL);
}

}  // namespace physim::client
