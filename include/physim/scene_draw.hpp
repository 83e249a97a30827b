// Scenes drawn for those who debug them: lines, triangles and texts, by whatever the caller draws with.
#pragma once

#include <string_view>

#include "physim/scene.hpp"

namespace physim {

/// What something that is drawn stands for; colours are the caller's.
enum class SceneInk {
  solid,   ///< a thing that is hit
  sensor,  ///< a thing that tells only
  path,    ///< where a thing goes
  box,     ///< of the trees
};

/// Draws. The calls come from the thread that asks, in the order of things.
class SceneCanvas {
 public:
  virtual ~SceneCanvas() = default;
  /// What is drawn from now on is part of this thing.
  virtual void begin(InstanceId thing) { static_cast<void>(thing); }
  /// Triangles that are drawn from now on are made of this, up to the next thing.
  virtual void material(MaterialId of) { static_cast<void>(of); }
  /// Between two places in W [m].
  virtual void line(const Vec3d& a, const Vec3d& b, SceneInk ink) = 0;
  /// Counterclockwise as seen from outside [m].
  virtual void triangle(const Vec3d& a, const Vec3d& b, const Vec3d& c, SceneInk ink) = 0;
  /// At a place in W [m].
  virtual void text(const Vec3d& place, std::string_view text) = 0;
};

/// What Scene::draw() draws.
struct SceneDrawing {
  bool shapes = true;        ///< their surfaces; planes as a square of lines [-]
  bool plane_faces = false;  ///< planes as a square of two triangles instead [-]
  bool names = false;        ///< at the origin of each thing that has one [-]
  bool boxes = false;        ///< of the trees of things [-]
  double time = 0;           ///< at which things stand [s]
  double ahead = 0;          ///< so long the paths of things that move are drawn on [s]
  double plane_size = 100;   ///< half of a plane's square [m]
  SceneFilter filter{};      ///< things that are drawn [-]
};

}  // namespace physim
