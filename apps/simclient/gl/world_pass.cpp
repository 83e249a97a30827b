#include "simclient/gl/world_pass.hpp"

#include <algorithm>
#include <cmath>
#include <random>
#include <vector>

#include "math/angles.hpp"
#include "simclient/gl/shaders.hpp"

namespace physim::client {
namespace {

constexpr int kStars = 2600;
constexpr int kGrains = 128;  // of the texture of unevenness, along each side
constexpr float kWholeView[8] = {-1, -1, 1, -1, -1, 1, 1, 1};

float f(double x) { return static_cast<float>(x); }

void hand(const Shader& shader, const char* name, const Vec3d& v) {
  glUniform3f(shader.uniform(name), f(v.x), f(v.y), f(v.z));
}

/// Noise between places of a lattice that repeats itself after `period` of them.
double noise(double x, double y, int period) {
  const auto at = [period](int i, int k) {
    auto h = static_cast<std::uint32_t>((i % period) * 73856093) ^ static_cast<std::uint32_t>((k % period) * 19349663) ^
             static_cast<std::uint32_t>(period * 83492791);
    h = (h ^ (h >> 13)) * 1274126177U;
    return static_cast<double>((h ^ (h >> 16)) & 0xFFFFU) / 65535;
  };
  const auto smooth = [](double t) { return t * t * (3 - 2 * t); };
  const int i = static_cast<int>(x), k = static_cast<int>(y);
  const double s = smooth(x - i), t = smooth(y - k);
  return std::lerp(std::lerp(at(i, k), at(i + 1, k), s), std::lerp(at(i, k + 1), at(i + 1, k + 1), s), t);
}

/// Three octaves.
std::vector<std::uint8_t> grains() {
  std::vector<std::uint8_t> out;
  for (int y = 0; y < kGrains; ++y)
    for (int x = 0; x < kGrains; ++x) {
      double sum = 0;
      for (const auto& [period, weight] : {std::pair{6, 0.5}, {17, 0.3}, {41, 0.2}})
        sum += weight *
               noise(static_cast<double>(x) * period / kGrains, static_cast<double>(y) * period / kGrains, period);
      out.push_back(static_cast<std::uint8_t>(std::lround(255 * sum)));
    }
  return out;
}

}  // namespace

double air_about(const Scene& scene, const Camera& camera) {
  constexpr double kThinner = 12e3;  // the sky's light halves so often on the way up [m]
  const double up =
      scene.globe ? length(camera.eye() - scene.globe->centre) - scene.globe->radius : camera.eye().y - scene.ground;
  return std::exp2(-std::max(up, 0.0) / kThinner);
}

WorldPass::~WorldPass() {
  if (array_ == 0) return;
  glDeleteVertexArrays(1, &array_);
  glDeleteBuffers(1, &corners_);
  glDeleteTextures(1, &unevenness_);
  glDeleteVertexArrays(1, &star_array_);
  glDeleteBuffers(1, &star_places_);
}

Status WorldPass::make() {
  const struct {
    Shader& shader;
    const char *name, *head;
  } programs[] = {{sky_, "sky", kSkyHead},
                  {ground_, "ground", kGroundHead},
                  {deep_ground_, "ground with depth", kDeepGroundHead},
                  {shadowed_ground_, "ground with shadows", kShadowedGroundHead},
                  {globe_, "globe", kGlobeHead}};
  for (const auto& each : programs)
    if (Status status = each.shader.make(each.name, kWorldVertex, kWorldFragment, each.head); !status) return status;
  glGenVertexArrays(1, &array_);
  glBindVertexArray(array_);
  glGenBuffers(1, &corners_);
  glBindBuffer(GL_ARRAY_BUFFER, corners_);
  glBufferData(GL_ARRAY_BUFFER, sizeof kWholeView, kWholeView, GL_STATIC_DRAW);
  glEnableVertexAttribArray(0);
  glVertexAttribPointer(0, 2, GL_FLOAT, GL_FALSE, 0, nullptr);
  glBindVertexArray(0);
  const std::vector<std::uint8_t> rough = grains();
  glGenTextures(1, &unevenness_);
  glBindTexture(GL_TEXTURE_2D, unevenness_);
  glPixelStorei(GL_UNPACK_ALIGNMENT, 1);
  glTexImage2D(GL_TEXTURE_2D, 0, GL_R8, kGrains, kGrains, 0, GL_RED, GL_UNSIGNED_BYTE, rough.data());
  glGenerateMipmap(GL_TEXTURE_2D);
  glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_LINEAR_MIPMAP_NEAREST);
  glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, GL_LINEAR);
  glBindTexture(GL_TEXTURE_2D, 0);
  make_stars();
  return star_.make("stars", kStarVertex, kStarFragment);
}

/// Spread evenly over all directions; few are bright.
void WorldPass::make_stars() {
  std::mt19937 draw(1);
  const auto unit = [&draw] { return static_cast<double>(draw()) / 4294967296.0; };
  std::vector<float> stars;
  for (int i = 0; i < kStars; ++i) {
    const double up = 2 * unit() - 1, turn = 2 * kPi * unit(), wide = std::sqrt(1 - up * up), faint = unit();
    for (const double each : {wide * std::cos(turn), up, wide * std::sin(turn), 0.2 + 0.8 * std::pow(faint, 12)})
      stars.push_back(f(each));
  }
  glGenVertexArrays(1, &star_array_);
  glBindVertexArray(star_array_);
  glGenBuffers(1, &star_places_);
  glBindBuffer(GL_ARRAY_BUFFER, star_places_);
  glBufferData(GL_ARRAY_BUFFER, static_cast<GLsizeiptr>(stars.size() * sizeof(float)), stars.data(), GL_STATIC_DRAW);
  const char* const start = nullptr;
  glEnableVertexAttribArray(0);
  glVertexAttribPointer(0, 3, GL_FLOAT, GL_FALSE, 4 * sizeof(float), start);
  glEnableVertexAttribArray(1);
  glVertexAttribPointer(1, 1, GL_FLOAT, GL_FALSE, 4 * sizeof(float), start + 3 * sizeof(float));
  glBindVertexArray(0);
}

/// Above the horizon; above the air all about, but for where the globe is.
void WorldPass::draw_stars(const Scene& scene, const Camera& camera, bool has_depth) const {
  const double space = scene.theme->is_light ? 0 : 1 - air_about(scene, camera);
  const double part = std::max(scene.theme->stars, 0.9 * space);
  if (!(part > 0)) return;
  star_.use();
  glUniformMatrix4fv(star_.uniform("matrix"), 1, GL_FALSE, camera.matrix().data());
  glUniform1f(star_.uniform("pixels"), f(std::max(2.4 * camera.height() / 720, 1.5)));
  glUniform1f(star_.uniform("part"), f(part));
  glUniform1f(star_.uniform("lowest"), scene.globe ? -2.0F : 0.0F);
  glEnable(GL_PROGRAM_POINT_SIZE);
  glEnable(GL_BLEND);
  glBindVertexArray(star_array_);
  if (has_depth) glDepthFunc(GL_LEQUAL);
  glDepthMask(GL_FALSE);
  glDrawArrays(GL_POINTS, 0, kStars);
  glDepthMask(GL_TRUE);
  glDisable(GL_BLEND);
}

void WorldPass::place_ground(const Shader& shader, const Scene& scene, const Camera& camera) const {
  const Vec3d eye = camera.eye();
  constexpr double kPeriod = 100;  // steps of the grid after which its unevenness repeats itself
  const auto in_steps = [&](double at) { return f(std::fmod(at / scene.grid_step, kPeriod)); };
  glUniform1f(shader.uniform("height"), f(camera.shown({0, scene.ground, 0}).y - eye.y));
  glUniform1f(shader.uniform("grid_step"), f(scene.grid_step));
  glUniform2f(shader.uniform("grid_at"), in_steps(eye.x - scene.grid_origin.x), in_steps(eye.z - scene.grid_origin.z));
}

void WorldPass::place_globe(const Shader& shader, const SceneGlobe& globe, const Camera& camera) const {
  glUniform1f(shader.uniform("globe"), f(globe.radius));
  const Vec3d centre = globe.centre - camera.eye();
  hand(shader, "centre", centre);
  glUniform1f(shader.uniform("beyond"), f(length_squared(centre) - globe.radius * globe.radius));
  float turn[9];
  for (std::size_t i = 0; i < 9; ++i) turn[i] = f(globe.to_geographic[i]);
  glUniformMatrix3fv(shader.uniform("to_geographic"), 1, GL_FALSE, turn);
}

/// `from`, `part`: of the view's height, from below.
void WorldPass::draw_part(const Shader& shader, const Scene& scene, const Camera& camera, const SceneryPass& scenery,
                          double from, double part) const {
  if (!(part > 0)) return;
  const Theme& theme = *scene.theme;
  shader.use();
  scenery.hand_shadows(shader, scene.has_shadows());
  glUniformMatrix4fv(shader.uniform("matrix"), 1, GL_FALSE, camera.matrix().data());
  glUniform2f(shader.uniform("part"), f(from), f(part));
  const double high = camera.height() / (2 * camera.focal()), wide = high * camera.width() / camera.height();
  hand(shader, "forward", camera.forward());
  hand(shader, "right", camera.right() * wide);
  hand(shader, "up", camera.up() * high);
  hand(shader, "to_sun", theme.to_sun());
  const double air = theme.is_light ? 1 : air_about(scene, camera);
  hand_colour(shader, "zenith", theme.zenith, 0.12 + 0.88 * air);
  for (const auto& [name, colour] : {std::pair{"horizon", theme.horizon},
                                     {"below", theme.below},
                                     {"glow", theme.glow},
                                     {"ground", theme.ground},
                                     {"sea", theme.sea}})
    hand_colour(shader, name, colour);
  for (const auto& [name, colour] : {std::pair{"grid", theme.grid}, {"cloud", theme.cloud}}) {
    const auto of = [colour = colour](int shift) { return f(static_cast<double>(colour >> shift & 0xFFU) / 255); };
    glUniform4f(shader.uniform(name), of(24), of(16), of(8), of(0));
  }
  glUniform1f(shader.uniform("air"), f(air));
  glUniform1f(shader.uniform("haze"), f(haze_of(camera)));
  glUniform1f(shader.uniform("grain"), f(theme.grain));
  glUniform1f(shader.uniform("shadow_left"), f(theme.shadow));
  glUniform1i(shader.uniform("unevenness"), 1);
  if (scene.globe)
    place_globe(shader, *scene.globe, camera);
  else
    place_ground(shader, scene, camera);
  glDrawArrays(GL_TRIANGLE_STRIP, 0, 4);
}

/// The eye does not roll: the horizon is level, with the ground below it.
void WorldPass::draw(const Scene& scene, const Camera& camera, const SceneryPass& scenery, bool has_depth) const {
  glActiveTexture(GL_TEXTURE1);
  glBindTexture(GL_TEXTURE_2D, unevenness_);
  glActiveTexture(GL_TEXTURE0);
  glBindVertexArray(array_);
  if (has_depth) glDepthFunc(GL_ALWAYS);
  if (scene.globe) {
    draw_part(globe_, scene, camera, scenery, 0, 1);
  } else {
    const double high = camera.height() / (2 * camera.focal());
    const double horizon = 0.5 - 0.5 * camera.forward().y / (camera.up().y * high);
    const bool is_seen = scene.has_ground && camera.eye().y > camera.shown({0, scene.ground, 0}).y;
    const double below = is_seen ? std::clamp(horizon, 0.0, 1.0) : 0;
    draw_part(scene.has_shadows() ? shadowed_ground_
              : has_depth         ? deep_ground_
                                  : ground_,
              scene, camera, scenery, 0, below);
    glDepthMask(GL_FALSE);
    draw_part(sky_, scene, camera, scenery, below, 1 - below);
    glDepthMask(GL_TRUE);
  }
  if (has_depth) glDepthFunc(GL_LEQUAL);
  draw_stars(scene, camera, has_depth);
}

}  // namespace physim::client
