#include "simclient/gl/renderer.hpp"

#include <cmath>
#include <cstddef>
#include <utility>

#include "simclient/gl/shaders.hpp"

namespace physim::client {
namespace {

constexpr float kSky[3] = {0.075F, 0.086F, 0.105F};
constexpr float kNear[3] = {0.135F, 0.150F, 0.160F}, kFar[3] = {0.085F, 0.096F, 0.115F};

void relative(const Vec3d& point, const Camera& camera, const Vec3d& eye, float (&out)[3]) {
  const Vec3d way = camera.shown(point) - eye;
  out[0] = static_cast<float>(way.x), out[1] = static_cast<float>(way.y), out[2] = static_cast<float>(way.z);
}

void bytes(Colour colour, std::uint8_t (&out)[4]) {
  for (int i = 0; i < 4; ++i) out[i] = static_cast<std::uint8_t>(colour >> (24 - 8 * i));
}

void attribute(GLuint index, GLint count, GLenum type, GLsizei stride, std::size_t offset) {
  glEnableVertexAttribArray(index);
  glVertexAttribPointer(index, count, type, type == GL_UNSIGNED_BYTE ? GL_TRUE : GL_FALSE, stride,
                        static_cast<const char*>(nullptr) + offset);
  if (index > 0) glVertexAttribDivisor(index, 1);
}

template <class Instance>
void upload(GLuint buffer, const std::vector<Instance>& data) {
  glBindBuffer(GL_ARRAY_BUFFER, buffer);
  glBufferData(GL_ARRAY_BUFFER, static_cast<GLsizeiptr>(data.size() * sizeof(Instance)), data.data(), GL_STREAM_DRAW);
}

void set_common(const Shader& shader, const Mat4& matrix, const Camera& camera) {
  shader.use();
  glUniformMatrix4fv(shader.uniform("matrix"), 1, GL_FALSE, matrix.data());
  glUniform2f(shader.uniform("size"), static_cast<float>(camera.width()), static_cast<float>(camera.height()));
}

}  // namespace

Result<Renderer> Renderer::make() {
  Renderer renderer;
  const struct {
    const char *name, *vertex, *fragment;
    Shader* shader;
  } shaders[] = {{"ground", kGroundVertex, kGroundFragment, &renderer.ground_shader_},
                 {"line", kLineVertex, kLineFragment, &renderer.line_shader_},
                 {"ball", kBallVertex, kBallFragment, &renderer.ball_shader_},
                 {"crowd", kCrowdVertex, kCrowdFragment, &renderer.crowd_shader_}};
  for (const auto& each : shaders) {
    Result<Shader> made = Shader::make(each.name, each.vertex, each.fragment);
    if (!made) return made.error();
    *each.shader = std::move(*made);
  }
  renderer.make_meshes();
  return renderer;
}

void Renderer::make_meshes() {
  static constexpr float kSquare[] = {-1, -1, 1, -1, -1, 1, 1, 1};
  static constexpr float kStrip[] = {0, -1, 1, -1, 0, 1, 1, 1};
  for (Mesh* mesh : {&ground_, &line_, &ball_}) {
    glGenVertexArrays(1, &mesh->array);
    glBindVertexArray(mesh->array);
    glGenBuffers(1, &mesh->corners);
    glBindBuffer(GL_ARRAY_BUFFER, mesh->corners);
    glBufferData(GL_ARRAY_BUFFER, sizeof kSquare, mesh == &line_ ? kStrip : kSquare, GL_STATIC_DRAW);
    attribute(0, 2, GL_FLOAT, 2 * sizeof(float), 0);
    glGenBuffers(1, &mesh->instances);
    glBindBuffer(GL_ARRAY_BUFFER, mesh->instances);
    if (mesh == &line_) {
      attribute(1, 3, GL_FLOAT, sizeof(LineInstance), offsetof(LineInstance, a));
      attribute(2, 3, GL_FLOAT, sizeof(LineInstance), offsetof(LineInstance, b));
      attribute(3, 4, GL_UNSIGNED_BYTE, sizeof(LineInstance), offsetof(LineInstance, colour));
      attribute(4, 2, GL_FLOAT, sizeof(LineInstance), offsetof(LineInstance, width));
    } else if (mesh == &ball_) {
      attribute(1, 3, GL_FLOAT, sizeof(BallInstance), offsetof(BallInstance, at));
      attribute(2, 4, GL_UNSIGNED_BYTE, sizeof(BallInstance), offsetof(BallInstance, colour));
      attribute(3, 2, GL_FLOAT, sizeof(BallInstance), offsetof(BallInstance, radius));
    }
  }
  glGenVertexArrays(1, &crowd_.array);
  glBindVertexArray(crowd_.array);
  glGenBuffers(1, &crowd_.instances);
  glBindBuffer(GL_ARRAY_BUFFER, crowd_.instances);
  attribute(0, 3, GL_FLOAT, sizeof(DotInstance), offsetof(DotInstance, at));
  attribute(1, 4, GL_UNSIGNED_BYTE, sizeof(DotInstance), offsetof(DotInstance, colour));
  glVertexAttribDivisor(1, 0);
  glBindVertexArray(0);
}

Renderer::Renderer(Renderer&& other) noexcept
    : ground_shader_(std::move(other.ground_shader_)),
      line_shader_(std::move(other.line_shader_)),
      ball_shader_(std::move(other.ball_shader_)),
      crowd_shader_(std::move(other.crowd_shader_)),
      ground_(std::exchange(other.ground_, {})),
      line_(std::exchange(other.line_, {})),
      ball_(std::exchange(other.ball_, {})),
      crowd_(std::exchange(other.crowd_, {})) {}

Renderer::~Renderer() {
  for (const Mesh& mesh : {ground_, line_, ball_, crowd_}) {
    if (mesh.array == 0) continue;
    glDeleteVertexArrays(1, &mesh.array);
    glDeleteBuffers(1, &mesh.corners);
    glDeleteBuffers(1, &mesh.instances);
  }
}

void Renderer::draw(const Scene& scene, const Camera& camera, const Viewport& viewport) {
  glViewport(viewport.x, viewport.y, viewport.width, viewport.height);
  glScissor(viewport.x, viewport.y, viewport.width, viewport.height);
  glEnable(GL_SCISSOR_TEST);
  glClearColor(kSky[0], kSky[1], kSky[2], 1);
  glClear(GL_COLOR_BUFFER_BIT);
  glDisable(GL_DEPTH_TEST);
  glEnable(GL_BLEND);
  glBlendFuncSeparate(GL_SRC_ALPHA, GL_ONE_MINUS_SRC_ALPHA, GL_ONE, GL_ONE_MINUS_SRC_ALPHA);
  const Mat4 matrix = camera.matrix();
  if (scene.has_ground) draw_ground(scene, camera, matrix);
  draw_crowd(scene, camera, matrix);
  draw_lines(scene, camera, matrix);
  draw_balls(scene, camera, matrix);
  glBindVertexArray(0);
  glDisable(GL_SCISSOR_TEST);
}

void Renderer::draw_ground(const Scene& scene, const Camera& camera, const Mat4& matrix) {
  set_common(ground_shader_, matrix, camera);
  glUniform1f(ground_shader_.uniform("height"),
              static_cast<float>(camera.shown({0, scene.ground, 0}).y - camera.eye().y));
  glUniform1f(ground_shader_.uniform("reach"), static_cast<float>(camera.distance * 100));
  glUniform3fv(ground_shader_.uniform("near_colour"), 1, kNear);
  glUniform3fv(ground_shader_.uniform("far_colour"), 1, kFar);
  glBindVertexArray(ground_.array);
  glDrawArrays(GL_TRIANGLE_STRIP, 0, 4);
}

void Renderer::draw_lines(const Scene& scene, const Camera& camera, const Mat4& matrix) {
  const Vec3d eye = camera.eye();
  line_data_.resize(scene.lines.size());
  for (std::size_t i = 0; i < scene.lines.size(); ++i) {
    const SceneLine& line = scene.lines[i];
    relative(line.a, camera, eye, line_data_[i].a);
    relative(line.b, camera, eye, line_data_[i].b);
    bytes(line.colour, line_data_[i].colour);
    line_data_[i].width = line.width, line_data_[i].fog = line.fog;
  }
  set_common(line_shader_, matrix, camera);
  glUniform1f(line_shader_.uniform("near"), static_cast<float>(camera.near_plane()));
  upload(line_.instances, line_data_);
  glBindVertexArray(line_.array);
  glDrawArraysInstanced(GL_TRIANGLE_STRIP, 0, 4, static_cast<GLsizei>(line_data_.size()));
}

/// Opaque squares of a few pixels: software rendering draws them many times as fast as anything rounder.
void Renderer::draw_crowd(const Scene& scene, const Camera& camera, const Mat4& matrix) {
  if (scene.crowd.empty()) return;
  const Vec3d eye = camera.eye();
  crowd_data_.resize(scene.crowd.size());
  for (std::size_t i = 0; i < scene.crowd.size(); ++i) {
    relative(scene.crowd[i].at, camera, eye, crowd_data_[i].at);
    bytes(scene.crowd[i].colour, crowd_data_[i].colour);
  }
  crowd_shader_.use();
  glUniformMatrix4fv(crowd_shader_.uniform("matrix"), 1, GL_FALSE, matrix.data());
  glUniform1f(crowd_shader_.uniform("pixels"), scene.crowd_size);
  upload(crowd_.instances, crowd_data_);
  glEnable(GL_PROGRAM_POINT_SIZE);
  glDisable(GL_BLEND);
  glBindVertexArray(crowd_.array);
  glDrawArrays(GL_POINTS, 0, static_cast<GLsizei>(crowd_data_.size()));
  glEnable(GL_BLEND);
}

void Renderer::draw_balls(const Scene& scene, const Camera& camera, const Mat4& matrix) {
  const Vec3d eye = camera.eye();
  ball_data_.resize(scene.balls.size());
  for (std::size_t i = 0; i < scene.balls.size(); ++i) {
    const SceneBall& ball = scene.balls[i];
    relative(ball.at, camera, eye, ball_data_[i].at);
    bytes(ball.colour, ball_data_[i].colour);
    ball_data_[i].radius = ball.radius, ball_data_[i].pixels = ball.pixels;
  }
  set_common(ball_shader_, matrix, camera);
  glUniform1f(ball_shader_.uniform("focal"), static_cast<float>(camera.focal()));
  upload(ball_.instances, ball_data_);
  glBindVertexArray(ball_.array);
  glDrawArraysInstanced(GL_TRIANGLE_STRIP, 0, 4, static_cast<GLsizei>(ball_data_.size()));
}

}  // namespace physim::client
