#include "simclient/gl/body_pass.hpp"

#include <algorithm>

#include "simclient/gl/shaders.hpp"

namespace physim::client {
namespace {

float number(double x) { return static_cast<float>(x); }

void hand_way(const Shader& shader, const char* name, const Vec3d& v) {
  glUniform3f(shader.uniform(name), number(v.x), number(v.y), number(v.z));
}

}  // namespace

double enlargement(const SceneBody& body, const Camera& camera) {
  const double size = std::max({body.look.size.x, body.look.size.y, body.look.size.z, 1e-6});
  return std::max(1.0, static_cast<double>(body.pixels) * camera.pixel_size(body.at) / size);
}

BodyPass::~BodyPass() {
  if (array_ == 0) return;
  glDeleteVertexArrays(1, &array_);
  glDeleteBuffers(1, &vertices_);
}

Status BodyPass::make() {
  if (Status status = shader_.make("bodies", kBodyVertex, kBodyFragment); !status) return status;
  std::vector<LitVertex> all;
  for (std::size_t i = 0; i < kBodyShapes; ++i) {
    const std::span<const LitVertex> mesh = mesh_of(static_cast<BodyShape>(i));
    ranges_[i] = {static_cast<GLint>(all.size()), static_cast<GLsizei>(mesh.size())};
    all.insert(all.end(), mesh.begin(), mesh.end());
  }
  glGenVertexArrays(1, &array_);
  glGenBuffers(1, &vertices_);
  glBindVertexArray(array_);
  glBindBuffer(GL_ARRAY_BUFFER, vertices_);
  glBufferData(GL_ARRAY_BUFFER, static_cast<GLsizeiptr>(all.size() * sizeof(LitVertex)), all.data(), GL_STATIC_DRAW);
  read_lit_vertices();
  glBindVertexArray(0);
  return {};
}

void BodyPass::draw(const Scene& scene, const Camera& camera, bool has_depth) const {
  if (scene.bodies.empty()) return;
  const Theme& theme = *scene.theme;
  shader_.use();
  glUniformMatrix4fv(shader_.uniform("matrix"), 1, GL_FALSE, camera.matrix().data());
  hand_way(shader_, "to_sun", theme.to_sun());
  for (const auto& [name, colour] :
       {std::pair{"sunlight_colour", theme.sunlight}, {"skylight", theme.skylight}, {"earthlight", theme.earthlight}})
    hand_colour(shader_, name, colour);
  glBindVertexArray(array_);
  glEnable(GL_DEPTH_TEST);
  glDepthFunc(GL_LEQUAL);
  glDepthMask(GL_TRUE);
  glDisable(GL_BLEND);
  const Vec3d eye = camera.eye();
  for (const SceneBody& body : scene.bodies) {
    const Vec3d centre = camera.shown(body.at) - eye, extent = body.look.size * enlargement(body, camera);
    hand_way(shader_, "centre", centre);
    hand_way(shader_, "extent", extent);
    glUniform1f(shader_.uniform("reach"), number(0.5 * length(extent)));
    hand_colour(shader_, "track_colour", ink(theme, body.colour));
    const Vec3d x = rotate(body.attitude, Vec3d{1, 0, 0}), y = rotate(body.attitude, Vec3d{0, 1, 0}),
                z = rotate(body.attitude, Vec3d{0, 0, 1});
    const GLfloat turn[9] = {number(x.x), number(x.y), number(x.z), number(y.x), number(y.y),
                             number(y.z), number(z.x), number(z.y), number(z.z)};
    glUniformMatrix3fv(shader_.uniform("turn"), 1, GL_FALSE, turn);
    const Range& range = ranges_[static_cast<std::size_t>(body.look.shape)];
    glDrawArrays(GL_TRIANGLES, range.first, range.count);
  }
  glEnable(GL_BLEND);
  glDepthMask(GL_FALSE);
  if (!has_depth) glDisable(GL_DEPTH_TEST);
}

}  // namespace physim::client
