// Scene: what is to be drawn in the world, as lines, balls and labels; the renderer only draws it.
#pragma once

#include <array>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "base/text.hpp"
#include "simclient/core/client.hpp"
#include "simclient/core/glow.hpp"
#include "simclient/core/quality.hpp"
#include "simclient/core/theme.hpp"

namespace physim::client {

/// `fog` of lines with a dark casing, which are seen on any ground.
inline constexpr double kCased = -1;

struct SceneLine {
  Vec3d a, b;
  Colour colour = 0xFFFFFFFF;
  float width = 1;  // [pixels]
  float fog = 0;    // > 0: fades with distance; kCased: has a casing
};

struct SceneBall {
  Vec3d at;
  Colour colour = 0xFFFFFFFF;
  float radius = 0;  // [m]; never smaller than `pixels`
  float pixels = 5;  // [pixels]
};

/// A body with a mesh, at its attitude.
struct SceneBody {
  Vec3d at;
  Quatd attitude;
  BodyLook look;
  Colour colour = 0xFFFFFFFF;  // of its track
  float pixels = 14;           // it is never drawn shorter [pixels]
};

/// One of very many: a few pixels of one colour.
struct SceneDot {
  Vec3d at;
  Colour colour = 0xFFFFFFFF;
};

/// A soft disc that faces the eye.
struct SceneSprite {
  Vec3d at;
  Colour colour = 0xFFFFFFFF;
  float width = 0, height = 0;  // [m]
  float turn = 0;               // about the way to the eye [rad]
  float pixels = 3.5F;          // it is never smaller, but fainter [pixels]
};

struct SceneLabel {
  Vec3d at;
  std::string text;
  Colour colour = 0xFFFFFFFF;
  bool centred = true;
  double line = 0;         // below the first, where several labels share a place
  bool gives_way = false;  // it is left out where another stands in its place
  double side = 0;         // moved by so much of half its width, to the right
};

/// The legend of the colours of trails.
struct SceneLegend {
  std::string what;       // the quantity: "speed"
  std::string low, high;  // its least and largest value, with units
};

/// The Earth as a ball.
struct SceneGlobe {
  Vec3d centre;
  double radius = 0;                      // [m]
  std::array<double, 9> to_geographic{};  // by columns: takes ways in W to those in E
};

/// The colour of a path at a sample, or between two.
using SampleColour = std::function<Colour(const TrackSample&)>;

struct Scene {
  const Theme* theme = &themes()[0];
  Quality quality = Quality::high;
  std::vector<SceneLine> lines, on_top;  // on_top: over balls
  std::vector<SceneBall> balls;
  std::vector<SceneBody> bodies;
  std::vector<SceneBall> discs;  // that lie on the ground
  std::vector<SceneDot> crowd;
  std::vector<SceneSprite> sprites;  // from far to near
  std::vector<Light> lights;         // of sprites and streaks; dots of the crowd shine by their colour
  GlowMap glow;                      // of all of them
  std::vector<ProjectileId> drawn;   // those that emitters fired, in order
  std::vector<SceneLabel> labels;
  const Scenery* scenery = nullptr;  // the client's; null: there is none to be seen
  float crowd_size = 3;              // of each of the crowd [pixels]
  double ground = 0;                 // [m]
  bool has_ground = true;            // there is one to land on
  bool has_scale = true;             // distances stand along the line of fire
  Vec3d grid_origin;                 // of the grid on the ground
  double grid_step = 1;              // between its lines [m]
  double contour_step = 1;           // between lines of equal height on terrain [m]
  std::optional<SceneLegend> legend;
  std::optional<SceneGlobe> globe;  // in the place of a ground, seen from far away

  void clear();
  /// Something in it hides what is behind.
  [[nodiscard]] bool has_depth() const { return scenery != nullptr || globe.has_value(); }
  [[nodiscard]] bool has_shadows() const { return scenery != nullptr && quality != Quality::low; }
  void line(const Vec3d& a, const Vec3d& b, Colour colour, double width, double fog = 0);
  void ball(const Vec3d& at, Colour colour, double pixels, double radius = 0);
  /// A path as the camera sees it, smooth from near and far.
  void polyline(const std::vector<TrackSample>& samples, const Camera& camera, Colour colour, double width,
                double fog = kCased);
  /// A path in colours by what `colour_of` says of its samples; such colours change in steps.
  void ribbon(const std::vector<TrackSample>& samples, const Camera& camera, const SampleColour& colour_of,
              double opacity, double width, double fog = kCased);
  void dots(const std::vector<TrackSample>& samples, const Camera& camera, Colour colour, double scale);
  void arrow(const Vec3d& from, const Vec3d& to, Colour colour, double width, const Camera& camera);
  void label(const Vec3d& at, const std::string& text, Colour colour, double line = 0, bool gives_way = false);
};

/// The distance at which haze leaves half of a colour [m].
[[nodiscard]] double haze_of(const Camera& camera);

/// All of it. `scale` is that of the screen: 2 draws everything twice as thick.
void build_scene(Client& client, double scale, Scene& scene);

// Its parts.
void build_ground(const Client& client, double scale, Scene& scene);
void build_depth(const Client& client, double scale, Scene& scene);
/// Nothing over a flat Earth, or from near.
[[nodiscard]] std::optional<SceneGlobe> globe_of(const Client& client);
void build_globe(Client& client, double scale, Scene& scene);
void build_comparison(Client& client, double scale, Scene& scene);
void build_aim(Client& client, double scale, Scene& scene);
/// Leaves out dots of the crowd beyond the view, and those behind another on the same few pixels.
void thin_crowd(const Camera& camera, Scene& scene);
/// The glow of what is hot; on white it could not be seen, and there is none.
void build_glow(const Camera& camera, double scale, Scene& scene);
/// An emitter that says nothing about sizes lets out dots.
[[nodiscard]] bool has_sizes(const EmitterDef& def);
void build_particles(const Client& client, double scale, Scene& scene);
void build_projectiles(const Client& client, double scale, Scene& scene);
void build_bodies(Client& client, double scale, Scene& scene);
void build_dust(const Client& client, double scale, Scene& scene);
void build_misses(Client& client, double scale, Scene& scene);
void build_vectors(const Client& client, double scale, Scene& scene);
void build_cursor(const Client& client, double scale, Scene& scene);
void build_tools(Client& client, double scale, Scene& scene);
void build_things(Client& client, double scale, Scene& scene);

/// "plank: penetrated, 780 to 778 m/s".
[[nodiscard]] std::string hit_text(const Hit& hit);
/// The distance between scale lines, 1, 2 or 5 times a power of ten, so that about `wanted` of them fit into `length`.
[[nodiscard]] double scale_step(double length, double wanted);
/// A length as people write it: "0.5 m", "200 m", "1.2 km".
[[nodiscard]] std::string distance_text(double metres);

}  // namespace physim::client
