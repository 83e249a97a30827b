// Scene: solid things that segments and spheres are cast into: shapes, where they stand, what they are made of.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <limits>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <variant>
#include <vector>

#include "physim/ids.hpp"
#include "physim/infinity.hpp"
#include "physim/material.hpp"
#include "physim/quat.hpp"
#include "physim/result.hpp"
#include "physim/scene_motion.hpp"
#include "physim/task_runner.hpp"
#include "physim/vec3.hpp"

namespace physim {

class SceneCanvas;
class SceneByMotion;
class SharedShape;
struct SceneDrawing;

/// Where something stands: scaled, then turned, then moved.
struct Transform {
  Vec3d position{};  ///< of its own origin in W [m]
  Quatd rotation{};  ///< from its own frame to W; of any length but zero [-]
  double scale = 1;  ///< above 0, the same along all axes [-]

  bool operator==(const Transform&) const = default;
};

// What shapes are, each in a frame of its own.

/// Everything below the plane y = 0.
struct PlaneShape {};
/// About the origin.
struct SphereShape {
  double radius = 1;  ///< [m]
};
/// About the origin.
struct BoxShape {
  Vec3d half{0.5, 0.5, 0.5};  ///< half of its edges [m]
};
/// Along the y axis, round at both ends.
struct CapsuleShape {
  double radius = 0.5;       ///< [m]
  double half_height = 0.5;  ///< of the cylinder between the ends; 0: a sphere [m]
};
/// Along the y axis.
struct CylinderShape {
  double radius = 0.5;       ///< [m]
  double half_height = 0.5;  ///< [m]
};
/// The smallest convex body that holds some points. What it costs to meet it follows the number of its faces.
struct ConvexHullShape {
  std::vector<Vec3d> points{};  ///< four at least, not all in one plane; those within count for nothing [m]
};
/// Triangles, counterclockwise as seen from outside. They are surfaces that are met from both sides; where they close a
/// body, its inside is told from outside.
struct MeshShape {
  std::vector<Vec3d> vertices{};                          ///< [m]
  std::vector<std::array<std::uint32_t, 3>> triangles{};  ///< indices of vertices; those without area are left out [-]
  std::vector<MaterialId> materials{};                    ///< of each triangle; empty: that of the instance [-]
};
/// Heights over a grid of x and z, from the origin on; two triangles to each cell.
struct HeightFieldShape {
  std::uint32_t columns = 0;      ///< points along x, at least 2 [-]
  std::uint32_t rows = 0;         ///< points along z, at least 2 [-]
  double spacing_x = 1;           ///< between columns [m]
  double spacing_z = 1;           ///< between rows [m]
  std::vector<double> heights{};  ///< y of each point: heights[row * columns + column] [m]
};
/// Some shapes that move as one. Where parts of different materials overlap, the first one of them is there.
struct CompoundShape {
  /// One of them: no compound, and no plane.
  struct Part {
    ShapeId shape{};        ///< must stay as long as the compound [-]
    Transform transform{};  ///< in the compound's frame [-]
    /// Where its triangles have none of their own; none: that of the instance [-].
    std::optional<MaterialId> material{};
  };
  std::vector<Part> parts{};  ///< [-]
};
using ShapeDef = std::variant<PlaneShape, SphereShape, BoxShape, CapsuleShape, CylinderShape, MeshShape,
                              HeightFieldShape, CompoundShape, ConvexHullShape>;

/// A thing in a scene.
struct InstanceDef {
  ShapeId shape{};              ///< [-]
  Transform transform{};        ///< [-]
  MaterialId material{};        ///< where its triangles or parts have none of their own [-]
  std::uint32_t layers = 1;     ///< bits; queries ask for some of them [-]
  bool sensor = false;          ///< told of, and passed [-]
  std::uint64_t user_data = 0;  ///< for the caller [-]
  std::string name{};           ///< for tables [-]
  SceneMotion motion{};         ///< from its transform on [-]
};

/// What is cast: the points from one end to the other, or spheres about them; steadily, while things move.
struct SceneSegment {
  Vec3d from{};         ///< [m]
  Vec3d to{};           ///< [m]
  double radius = 0;    ///< [m]
  double time = 0;      ///< at which it begins, within 1e9 s [s]
  double duration = 0;  ///< that its way takes, up to 1e9 s; 0: things stand as they do at that time [s]
};

/// Which things a query asks for.
struct SceneFilter {
  std::uint32_t layers = 0xffffffff;  ///< those that have one of these bits [-]
  bool sensors = true;                ///< with sensors [-]
};

/// Where a segment meets a surface.
struct SceneHit {
  double part = 0;              ///< of the segment, 0 to 1 [-]
  Vec3d position{};             ///< of the point, or of the middle of the sphere, then [m]
  Vec3d normal{};               ///< of the surface, outwards [-]
  double time = 0;              ///< at which it is met [s]
  Vec3d velocity{};             ///< of the surface there, then [m/s]
  InstanceId instance{};        ///< none: nothing was met [-]
  std::uint32_t primitive = 0;  ///< triangle of a mesh or height field as they were given, part of a compound [-]
  MaterialId material{};        ///< [-]
  bool entering = true;         ///< from outside to inside; a mesh's triangle: against its normal [-]
  bool starts_inside =
      false;  ///< it begins in a solid, a sphere at any surface; part is 0, the normal against its way [-]

  explicit operator bool() const { return static_cast<bool>(instance); }
};

/// What of a surface is nearest to a point.
struct SceneNearest {
  double distance = kInfinity;  ///< 0 inside of a solid [m]
  Vec3d position{};             ///< on the surface, or the point itself inside of a solid [m]
  InstanceId instance{};        ///< none: nothing is that near [-]
  std::uint32_t primitive = 0;  ///< triangle of a mesh or height field as they were given, part of a compound [-]
  MaterialId material{};        ///< [-]
  Vec3d away{};                 ///< unit vector from the surface to the point, the normal if that lies on a triangle;
                                ///< zero inside of a solid [-]

  explicit operator bool() const { return static_cast<bool>(instance); }
};

/// What an engine is asked: what each of some segments meets first.
struct EngineBatch {
  std::span<const SceneSegment> segments{};  ///< none is without length; their times are those of the world [m]
  std::uint32_t layers = 0xffffffff;         ///< bits: things of these [-]
  std::span<SceneHit> hits{};  ///< of each segment, empty as it comes: to be filled where it meets something
                               ///< with `part`, `normal` and `instance.index`, above 0 and the engine's own;
                               ///< `velocity`, `primitive`, `material` (of the scene) and `entering` count
                               ///< where they are given, `starts_inside` as well, all else is known [-]
};
/// An engine's own physics, which answers. See EngineScene.
using EngineQuery = std::function<void(const EngineBatch&)>;

/// Things of an engine's own physics, which a scene's questions go to, too (docs/scenes.md#an-engines-own-scene).
///
/// A normal points outwards, of any length but zero. The solid in which a segment starts is best not met by it, as rays
/// of most engines have it. A surface that is met from its back says so by `entering`: the wall of a closed mesh from
/// within. One that tells nothing of its back is a sheet where both sides are met at one place.
///
/// The answer must follow from the segment. Calls are made one after another by whoever asks the scene, a world from
/// the thread that steps it; they may read that world, but not change it, nor ask its scene about the engine's things.
/// An answer with a number that is none, a part outside 0 to 1 or a normal without length, and what throws twice, is no
/// hit: EngineCounters::refused tells.
struct EngineScene {
  EngineQuery query{};  ///< empty: no engine [-]
  double skin = 1e-3;   ///< things are met so far outside of their surfaces: ten times as much, or more, as the
                        ///< engine's numbers may be off there; 1e-6 to 0.1 [m]
};

/// What an engine was asked so far; copies of a scene count together.
struct EngineCounters {
  std::uint64_t calls = 0;     ///< of its query [-]
  std::uint64_t segments = 0;  ///< in these [-]
  std::uint64_t refused = 0;   ///< answers that made no sense, or threw: nothing was met [-]
};
/// InstanceId::generation of an engine's things.
inline constexpr std::uint32_t kEngineGeneration = 0xffffffff;

/// What a shape came to be.
struct ShapeInfo {
  std::size_t triangles = 0;   ///< kept, or of a hull [-]
  std::size_t degenerate = 0;  ///< triangles left out, as they have no area [-]
  bool closed = false;         ///< a mesh: each edge belongs to two triangles, and it has an inside [-]
  std::size_t bytes = 0;       ///< of memory [-]
};

/// Shapes, materials and things, at rest or in motion. Queries may be asked from any number of threads at once, as long
/// as none changes the scene. The same calls make the same scene, and the same answers, on every machine.
class Scene {
 public:
  Scene();
  ~Scene();
  Scene(Scene&& other) noexcept;
  Scene& operator=(Scene&& other) noexcept;
  /// Shapes are shared by copies; what stands in them is not.
  Scene(const Scene& other);
  Scene& operator=(const Scene& other);

  // ---- what there is
  /// Shapes are prepared once, and stand in the scene as often as one likes. An error names the number that is wrong.
  [[nodiscard]] Result<ShapeId> add_shape(const ShapeDef& shape);
  /// Refused while something has this shape.
  Status remove_shape(ShapeId shape);
  [[nodiscard]] std::optional<ShapeInfo> info(ShapeId shape) const;
  [[nodiscard]] Result<MaterialId> add_material(const Material& material);
  /// The material; that which every scene begins with where there is none of this name.
  [[nodiscard]] const Material& material(MaterialId material) const;
  [[nodiscard]] Result<InstanceId> add(const InstanceDef& instance);
  Status remove(InstanceId instance);
  /// Moves a thing to another place, where it rests; this takes the time that the tree of things is deep.
  Status move(InstanceId instance, const Transform& to);
  /// Lets a thing move; AtRest leaves it where its transform puts it.
  Status set_motion(InstanceId instance, const SceneMotion& motion);
  /// Prepares for questions about times between two, both within 1e9 s: the boxes of what moves hold all of its way
  /// between them, in the time that all of these take. Questions about other times are answered as well, but look at
  /// each thing that moves. A scene begins with time 0 alone.
  Status cover(double from, double to);
  Status set_layers(InstanceId instance, std::uint32_t layers);
  /// Lets an engine answer beside the things that stand here: first_hit(), first_hits(), any_hit() and all_hits() tell
  /// what is met first of both. Its things are no sensors and not in motion to instance(), state() and others that name
  /// one; nearest(), overlaps() and is_reached() leave them out, clearance() and clear_part() are 0. An error where the
  /// skin is none.
  Status set_engine(const EngineScene& engine);
  /// The engine; null: none.
  [[nodiscard]] const EngineScene* engine() const;
  [[nodiscard]] EngineCounters engine_counters() const;
  /// EngineScene::skin, or 0 [m].
  [[nodiscard]] double skin() const;
  /// What a thing was made of, where it is now; nothing where it is gone.
  [[nodiscard]] std::optional<InstanceDef> instance(InstanceId instance) const;
  /// How many parts the compound has that a thing is; 0 where it is none, or gone [-].
  [[nodiscard]] std::size_t parts(InstanceId instance) const;
  /// Whether some of them are sensors.
  [[nodiscard]] bool has_sensors() const;
  /// Whether this one is; false where it is gone.
  [[nodiscard]] bool is_sensor(InstanceId instance) const;
  /// Whether some of them move.
  [[nodiscard]] bool has_motion() const;
  /// Where a thing is and how it moves at a time within 1e9 s; nothing where it is gone.
  [[nodiscard]] std::optional<MotionState> state(InstanceId instance, double time = 0) const;
  /// Rises with each call that changed what may be met where: what was found out before may not hold any more [-].
  [[nodiscard]] std::uint64_t changes() const;
  /// Things that stand in it.
  [[nodiscard]] std::size_t size() const;
  /// Memory of shapes and things [bytes].
  [[nodiscard]] std::size_t bytes() const;

  /// Shows it to whoever draws (physim/scene_draw.hpp).
  void draw(SceneCanvas& canvas, const SceneDrawing& what) const;

  // ---- saves
  /// All of it as bytes, each shape once, however many things have it.
  [[nodiscard]] std::vector<std::byte> save() const;
  /// The scene that a save holds: with the same ids, now and of what is added later, and the same answers. An error
  /// where the bytes are none, cut, damaged or of another format, and where the scene had an engine and `query` is
  /// empty: functions are no data.
  [[nodiscard]] static Result<Scene> load(std::span<const std::byte> save, const EngineQuery& query = {});
  /// Tells scenes of different content apart; what is covered does not count. A shape is looked at once [-].
  [[nodiscard]] std::uint64_t hash() const;

  // ---- questions; a segment with a number that is none, or beyond 1e15 m, meets nothing. What moves straight without
  // turning is met exactly; what turns or moves along a curve may be missed where it is grazed by less than 1e-6 m, and
  // by more where it turns so often within a segment's duration that 65536 chords are not enough.
  /// What a segment meets first.
  [[nodiscard]] SceneHit first_hit(const SceneSegment& segment, const SceneFilter& filter = {}) const;
  /// Whether it meets anything.
  [[nodiscard]] bool any_hit(const SceneSegment& segment, const SceneFilter& filter = {}) const;
  /// All that a segment's points meet, by part: entries and exits, so that the difference is a thickness. Its radius is
  /// not looked at.
  [[nodiscard]] std::vector<SceneHit> all_hits(const SceneSegment& segment, const SceneFilter& filter = {}) const;
  /// What each of many segments meets first; `into` is as long as they are many. The answers do not depend on `runner`,
  /// whose threads are lent.
  void first_hits(std::span<const SceneSegment> segments, std::span<SceneHit> into, const SceneFilter& filter = {},
                  TaskRunner* runner = nullptr) const;
  /// The surface nearest to a point within 1e15 m, not farther than `within` [m], at a time [s].
  [[nodiscard]] SceneNearest nearest(const Vec3d& point, double within = kInfinity, const SceneFilter& filter = {},
                                     double time = 0) const;
  /// A distance from a point within 1e15 m, `reach` at most, that nothing is nearer than at any time between two [m]: a
  /// lower bound, found by a look at few boxes. It is half of the true distance to what rests at least, but for
  /// rounding; to what moves, less the way that it may go. 0 in a solid, and where a number is none.
  [[nodiscard]] double clearance(const Vec3d& point, double reach, const SceneFilter& filter = {}, double from = 0,
                                 double to = 0) const;
  /// A part of a segment, 0 to 1, up to which the spheres of its radius about its points touch nothing: a lower bound,
  /// wherever on it they are at any time between its own time and the end of its duration. 0 where it begins at a
  /// surface or in a solid, where a number is none, and where an engine answers.
  [[nodiscard]] double clear_part(const SceneSegment& segment, const SceneFilter& filter = {}) const;
  /// The things that a sphere touches at a time [s], by index.
  [[nodiscard]] std::vector<InstanceId> overlaps(const Vec3d& middle, double radius, const SceneFilter& filter = {},
                                                 double time = 0) const;
  /// Whether something that moves between two times touches a sphere that stands still, at any time between them [s].
  /// What rests meanwhile does not count.
  [[nodiscard]] bool is_reached(const Vec3d& middle, double radius, const SceneFilter& filter, double from,
                                double to) const;

 private:
  friend class SceneByMotion;
  friend class SharedShape;
  struct Impl;
  std::unique_ptr<Impl> impl_;
};

}  // namespace physim
