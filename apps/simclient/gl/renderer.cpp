#include "simclient/gl/renderer.hpp"

#include <algorithm>
#include <initializer_list>
#include <iterator>
#include <vector>

#include "simclient/gl/shaders.hpp"

namespace physim::client {
namespace {

constexpr float kCasing = 1.3F;  // about lines [pixels]
constexpr float kSquare[8] = {-1, -1, 1, -1, -1, 1, 1, 1}, kStrip[8] = {0, -1, 1, -1, 0, 1, 1, 1};

// Instances as the shaders read them; positions are relative to the eye.
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
struct SpriteInstance {
  float at[3];
  std::uint8_t colour[4];
  float half_width, half_height, turn, half_pixels;
};
struct DotInstance {
  float at[3];
  std::uint8_t colour[4];
};

void relative(const Vec3d& point, const Camera& camera, const Vec3d& eye, float (&out)[3]) {
  const Vec3d way = camera.shown(point) - eye;
  out[0] = static_cast<float>(way.x), out[1] = static_cast<float>(way.y), out[2] = static_cast<float>(way.z);
}

void bytes(Colour colour, std::uint8_t (&out)[4]) {
  for (int i = 0; i < 4; ++i) out[i] = static_cast<std::uint8_t>(colour >> (24 - 8 * i));
}

/// Attributes one behind the other, from number `first` on: so many floats each; four are the bytes of a colour.
void read_as(GLuint first, std::initializer_list<GLint> attributes, GLuint divisor) {
  const auto size = [](GLint count) { return count == 4 ? 4 : count * static_cast<GLsizei>(sizeof(float)); };
  GLsizei stride = 0;
  for (const GLint count : attributes) stride += size(count);
  const char* at = nullptr;
  for (const GLint count : attributes) {
    glEnableVertexAttribArray(first);
    glVertexAttribPointer(first, count, count == 4 ? GL_UNSIGNED_BYTE : GL_FLOAT, count == 4 ? GL_TRUE : GL_FALSE,
                          stride, at);
    glVertexAttribDivisor(first++, divisor);
    at += size(count);
  }
}

/// Instances of a quad; without one, points.
void make_arrays(Pass& pass, const float (*quad)[8], std::initializer_list<GLint> attributes) {
  glGenVertexArrays(1, &pass.array);
  glBindVertexArray(pass.array);
  if (quad != nullptr) {
    glGenBuffers(1, &pass.corners);
    glBindBuffer(GL_ARRAY_BUFFER, pass.corners);
    glBufferData(GL_ARRAY_BUFFER, sizeof *quad, *quad, GL_STATIC_DRAW);
    read_as(0, {2}, 0);
  }
  glGenBuffers(1, &pass.instances);
  glBindBuffer(GL_ARRAY_BUFFER, pass.instances);
  read_as(quad != nullptr ? 1 : 0, attributes, quad != nullptr ? 1 : 0);
  glBindVertexArray(0);
}

void begin(const Pass& pass, const Camera& camera, const Mat4& matrix) {
  pass.shader.use();
  glUniformMatrix4fv(pass.shader.uniform("matrix"), 1, GL_FALSE, matrix.data());
  glUniform2f(pass.shader.uniform("size"), static_cast<float>(camera.width()), static_cast<float>(camera.height()));
  glBindVertexArray(pass.array);
}

/// Hands instances of things to a pass; how many there are.
template <class Instance, class Thing, class Fill>
GLsizei upload(const Pass& pass, const std::vector<Thing>& things, const Fill& fill) {
  std::vector<Instance> data(things.size());
  for (std::size_t i = 0; i < things.size(); ++i) fill(things[i], data[i]);
  glBindBuffer(GL_ARRAY_BUFFER, pass.instances);
  glBufferData(GL_ARRAY_BUFFER, static_cast<GLsizeiptr>(data.size() * sizeof(Instance)), data.data(), GL_STREAM_DRAW);
  return static_cast<GLsizei>(data.size());
}

GLsizei upload_lines(const Pass& pass, const Scene& scene, const std::vector<SceneLine>& lines, const Camera& camera) {
  const auto fill = [&camera, &scene, eye = camera.eye()](const SceneLine& line, LineInstance& out) {
    relative(line.a, camera, eye, out.a);
    relative(line.b, camera, eye, out.b);
    bytes(ink(*scene.theme, line.colour), out.colour);
    out.width = line.width, out.fog = line.fog;
  };
  return upload<LineInstance>(pass, lines, fill);
}

/// Casings of all lines first, so that none lies over another line. Few lines have one.
void draw_lines(const Pass& pass, const Scene& scene, const std::vector<SceneLine>& lines, const Camera& camera,
                const Mat4& matrix, float part) {
  const Shader& shader = pass.shader;
  begin(pass, camera, matrix);
  glUniform1f(shader.uniform("part"), part);
  glUniform1f(shader.uniform("near"), static_cast<float>(camera.near_plane()));
  const auto of_casing = [&](int shift) { return static_cast<float>(scene.theme->casing >> shift & 0xFFU) / 255; };
  glUniform4f(shader.uniform("casing"), of_casing(24), of_casing(16), of_casing(8), of_casing(0));
  const auto draw_all = [&](const std::vector<SceneLine>& all, float casing) {
    if (all.empty()) return;
    glUniform1f(shader.uniform("casing_width"), casing);
    glDrawArraysInstanced(GL_TRIANGLE_STRIP, 0, 4, upload_lines(pass, scene, all, camera));
  };
  std::vector<SceneLine> cased;
  if (part >= 1)
    std::ranges::copy_if(lines, std::back_inserter(cased), [](const SceneLine& line) { return line.fog < 0; });
  draw_all(cased, kCasing);
  draw_all(lines, 0);
}

void draw_discs(const Pass& pass, const Scene& scene, const Camera& camera, const Mat4& matrix) {
  if (scene.discs.empty()) return;
  begin(pass, camera, matrix);
  glUniform1f(pass.shader.uniform("focal"), static_cast<float>(camera.focal()));
  const auto fill = [&camera, eye = camera.eye()](const SceneBall& disc, BallInstance& out) {
    relative(disc.at, camera, eye, out.at);
    bytes(disc.colour, out.colour);
    out.radius = disc.radius, out.pixels = disc.pixels;
  };
  glDrawArraysInstanced(GL_TRIANGLE_STRIP, 0, 4, upload<BallInstance>(pass, scene.discs, fill));
}

/// Opaque squares of a few pixels: software rendering draws them many times as fast as anything rounder, which is for
/// pictures.
void draw_crowd(const Pass& pass, bool is_round, const Scene& scene, const Camera& camera, const Mat4& matrix) {
  if (scene.crowd.empty()) return;
  begin(pass, camera, matrix);
  glUniform1f(pass.shader.uniform("pixels"), (is_round ? 1.25F : 1.0F) * scene.crowd_size);
  glUniform1f(pass.shader.uniform("middle"), static_cast<float>(camera.distance));
  glUniform1f(pass.shader.uniform("haze"), static_cast<float>(haze_of(camera)));
  hand_colour(pass.shader, "horizon", scene.theme->horizon);
  glEnable(GL_PROGRAM_POINT_SIZE);
  if (!is_round) glDisable(GL_BLEND);
  const auto fill = [&camera, &scene, eye = camera.eye()](const SceneDot& dot, DotInstance& out) {
    relative(dot.at, camera, eye, out.at);
    bytes(scene.theme->is_light ? ink(*scene.theme, dot.colour) : dot.colour, out.colour);
  };
  glDrawArrays(GL_POINTS, 0, upload<DotInstance>(pass, scene.crowd, fill));
  glEnable(GL_BLEND);
}

GLsizei upload_balls(const Pass& pass, const Scene& scene, const Camera& camera) {
  const auto fill = [&camera, &scene, eye = camera.eye()](const SceneBall& ball, BallInstance& out) {
    relative(ball.at, camera, eye, out.at);
    bytes(ink(*scene.theme, ball.colour), out.colour);
    out.radius = ball.radius, out.pixels = ball.pixels;
  };
  return upload<BallInstance>(pass, scene.balls, fill);
}

void draw_balls(const Pass& pass, const Scene& scene, const Camera& camera, const Mat4& matrix, float part) {
  begin(pass, camera, matrix);
  glUniform1f(pass.shader.uniform("focal"), static_cast<float>(camera.focal()));
  glUniform1f(pass.shader.uniform("part"), part);
  glDrawArraysInstanced(GL_TRIANGLE_STRIP, 0, 4, upload_balls(pass, scene, camera));
}

void draw_sprites(const Pass& pass, const Scene& scene, const Camera& camera, const Mat4& matrix) {
  if (scene.sprites.empty()) return;
  begin(pass, camera, matrix);
  glUniform1f(pass.shader.uniform("focal"), static_cast<float>(camera.focal()));
  const auto fill = [&camera, eye = camera.eye()](const SceneSprite& sprite, SpriteInstance& out) {
    relative(sprite.at, camera, eye, out.at);
    bytes(sprite.colour, out.colour);
    out.half_width = sprite.width / 2, out.half_height = sprite.height / 2;
    out.turn = sprite.turn, out.half_pixels = sprite.pixels / 2;
  };
  glDrawArraysInstanced(GL_TRIANGLE_STRIP, 0, 4, upload<SpriteInstance>(pass, scene.sprites, fill));
}

}  // namespace

Pass::~Pass() {
  if (array == 0) return;
  glDeleteVertexArrays(1, &array);
  glDeleteBuffers(1, &corners);
  glDeleteBuffers(1, &instances);
}

Status Renderer::make() {
  const struct {
    const char *name, *vertex, *fragment;
    Pass& pass;
  } passes[] = {{"line", kLineVertex, kLineFragment, line_},
                {"ball", kBallVertex, kBallFragment, ball_},
                {"crowd", kCrowdVertex, kCrowdFragment, crowd_},
                {"round crowd", kCrowdVertex, kRoundCrowdFragment, round_crowd_},
                {"disc", kDiscVertex, kDiscFragment, disc_},
                {"sprite", kSpriteVertex, kSpriteFragment, sprite_},
                {"ball shadow", kBallShadowVertex, kBallShadowFragment, ball_shadow_}};
  for (const auto& each : passes)
    if (Status status = each.pass.shader.make(each.name, each.vertex, each.fragment); !status) return status;
  make_arrays(disc_, &kSquare, {3, 4, 2});
  make_arrays(line_, &kStrip, {3, 3, 4, 2});
  make_arrays(ball_, &kSquare, {3, 4, 2});
  make_arrays(crowd_, nullptr, {3, 4});
  make_arrays(round_crowd_, nullptr, {3, 4});
  make_arrays(sprite_, &kSquare, {3, 4, 2, 2});
  make_arrays(ball_shadow_, &kSquare, {3, 4, 2});
  if (Status status = world_.make(); !status) return status;
  if (Status status = backdrop_.make(); !status) return status;
  if (Status status = bodies_.make(); !status) return status;
  if (Status status = glow_.make(); !status) return status;
  return scenery_.make();
}

/// Into the sun's map. Balls that mark a place throw none: those of projectiles have a size.
void Renderer::draw_shadows(const Scene& scene, const Camera& camera) {
  GLint target = 0;
  glGetIntegerv(GL_DRAW_FRAMEBUFFER_BINDING, &target);
  scenery_.begin_shadows(*scene.scenery, camera, scene.theme->to_sun());
  begin(ball_shadow_, camera, camera.matrix());
  const Shader& shader = ball_shadow_.shader;
  const ShadowMap& map = scenery_.shadows();
  glUniformMatrix4fv(shader.uniform("sun"), 1, GL_FALSE, map.matrix.data());
  glUniform1f(shader.uniform("focal"), static_cast<float>(camera.focal()));
  glUniform1f(shader.uniform("metres"), static_cast<float>(map.metres));
  Scene with_size;
  with_size.theme = scene.theme;
  for (const SceneBall& ball : scene.balls)
    if (ball.radius > 0) with_size.balls.push_back(ball);
  for (const SceneBody& body : scene.bodies) {
    const double radius = 0.5 * std::min(body.look.size.x, body.look.size.z) * enlargement(body, camera);
    with_size.balls.push_back({body.at, body.colour, static_cast<float>(radius), 0});
  }
  glDrawArraysInstanced(GL_TRIANGLE_STRIP, 0, 4, upload_balls(ball_shadow_, with_size, camera));
  scenery_.end_shadows(static_cast<GLuint>(target));
}

/// Sky and ground. Without depth they are kept from frame to frame, as software rendering takes its time for them.
void Renderer::draw_world(const Scene& scene, const Camera& camera, const Viewport& viewport) {
  if (scene.has_depth()) return world_.draw(scene, camera, scenery_, true);
  GLint target = 0;
  glGetIntegerv(GL_DRAW_FRAMEBUFFER_BINDING, &target);
  const GLboolean is_cut = glIsEnabled(GL_SCISSOR_TEST);
  const double part = scene.quality == Quality::low ? 0.5 : 1;
  if (backdrop_.begin(scene, camera, viewport.width, viewport.height, part)) {
    world_.draw(scene, camera, scenery_, false);
    glBindFramebuffer(GL_FRAMEBUFFER, static_cast<GLuint>(target));
    glViewport(viewport.x, viewport.y, viewport.width, viewport.height);
    if (is_cut == GL_TRUE) glEnable(GL_SCISSOR_TEST);
  }
  backdrop_.put(viewport.x, viewport.y);
}

/// Without things nothing hides anything, but for a globe.
void Renderer::draw_in(const Scene& scene, const Camera& camera, const Viewport& viewport) {
  const bool has_things = scene.scenery != nullptr, has_depth = scene.has_depth();
  glDepthMask(GL_TRUE);
  glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
  glDisable(GL_DEPTH_TEST);
  glEnable(GL_BLEND);
  glBlendFuncSeparate(GL_SRC_ALPHA, GL_ONE_MINUS_SRC_ALPHA, GL_ONE, GL_ONE_MINUS_SRC_ALPHA);
  const Mat4 matrix = camera.matrix();
  if (has_depth) glEnable(GL_DEPTH_TEST), glDepthFunc(GL_LEQUAL);
  glDisable(GL_BLEND);
  draw_world(scene, camera, viewport);
  glEnable(GL_BLEND);
  if (has_things) scenery_.draw(scene, camera, haze_of(camera));
  glDepthMask(GL_FALSE);
  draw_discs(disc_, scene, camera, matrix);
  if (has_depth) glDisable(GL_DEPTH_TEST);
  glow_.draw(scene, camera);
  if (has_depth) glEnable(GL_DEPTH_TEST);
  const bool is_round = scene.quality == Quality::high;
  draw_crowd(is_round ? round_crowd_ : crowd_, is_round, scene, camera, matrix);
  draw_sprites(sprite_, scene, camera, matrix);
  if (has_depth) {
    constexpr float kShowsThrough = 0.25F;
    glDepthFunc(GL_GREATER);
    draw_lines(line_, scene, scene.lines, camera, matrix, kShowsThrough);
    draw_balls(ball_, scene, camera, matrix, kShowsThrough);
    glDepthFunc(GL_LEQUAL);
  }
  draw_lines(line_, scene, scene.lines, camera, matrix, 1);
  draw_balls(ball_, scene, camera, matrix, 1);
  bodies_.draw(scene, camera, has_depth);
  draw_lines(line_, scene, scene.on_top, camera, matrix, 1);
  glDepthMask(GL_TRUE);
  glDisable(GL_DEPTH_TEST);
  glBindVertexArray(0);
}

void Renderer::draw(const Scene& scene, const Camera& camera, const Viewport& viewport) {
  if (scene.scenery != nullptr) scenery_.upload(*scene.scenery);
  if (scene.has_shadows()) draw_shadows(scene, camera);
  GLint target = 0;
  glGetIntegerv(GL_DRAW_FRAMEBUFFER_BINDING, &target);
  // Lines and balls have smooth edges of their own.
  constexpr int kMostSmoothed = 1 << 24;  // four samples of each pixel are in memory there
  const bool is_small = viewport.width * viewport.height <= kMostSmoothed;
  constexpr std::size_t kCrowd = 1000;  // is drawn often rather than smoothly
  const bool has_edges = scene.scenery != nullptr || (!scene.bodies.empty() && scene.crowd.size() < kCrowd);
  const bool is_smoothed =
      scene.quality == Quality::high && has_edges && is_small && canvas_.bind(viewport.width, viewport.height);
  if (is_smoothed) {
    glViewport(0, 0, viewport.width, viewport.height);
    draw_in(scene, camera, {0, 0, viewport.width, viewport.height});
    canvas_.put_into(static_cast<GLuint>(target), viewport.x, viewport.y);
    return;
  }
  glViewport(viewport.x, viewport.y, viewport.width, viewport.height);
  glScissor(viewport.x, viewport.y, viewport.width, viewport.height);
  glEnable(GL_SCISSOR_TEST);
  draw_in(scene, camera, viewport);
  glDisable(GL_SCISSOR_TEST);
}

}  // namespace physim::client
