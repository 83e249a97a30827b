// Scene: materials, shapes, things that stand and move, and impacts on them.
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
#include <string_view>
#include <variant>
#include <vector>

#include "physim/environment.hpp"
#include "physim/event.hpp"
#include "physim/math.hpp"
#include "physim/result.hpp"

namespace physim {

// ---------------------------------------------------------------------------------------------------------------------
// Material: what a surface is made of, and what it does to what hits it.

/// The ricochet of what meets a surface flat (docs/models/ricochet.md). The default throws nothing off.
struct RicochetDef {
  double critical_angle = 0;  ///< from the surface; what comes in flatter is thrown off; 0 to below pi/2 [rad]
  double restitution = 0;     ///< part of the speed along the normal that is left, 0 to 1 [-]
  double friction = 0;        ///< impulse along the surface over that along the normal [-]
  bool liquid = false;        ///< angle and loss are those of spheres off a liquid of Material::density; the three
                              ///< numbers above are not looked at [-]

  bool operator==(const RicochetDef&) const = default;
};

// Penetration: the depth that a projectile reaches, and its speed where it comes out behind.

/// Nothing goes in.
struct ImpenetrableDef {
  bool operator==(const ImpenetrableDef&) const = default;
};
/// A resistance that does not change with depth: wood, concrete, soil, liquids (docs/models/poncelet.md).
struct PonceletDef {
  double strength = 0;  ///< resistance to what moves slowly; 0: a liquid, which stops nothing [Pa]
  double inertia = 0;   ///< resistance by the speed is inertia N density v^2, N by the nose; solids 1, liquids 1/2 [-]
  double crater = 0;    ///< depth over which the resistance grows from 0, in diameters; concrete 2 [-]

  bool operator==(const PonceletDef&) const = default;
};
/// Soil, rock and concrete hit by heavy penetrators (docs/models/young.md).
struct YoungDef {
  double s_number = 0;  ///< penetrability: concrete about 1, soils more; above 0 [-]
  bool hard = false;    ///< rock or concrete: the correction for light penetrators is theirs, not that of soil [-]

  bool operator==(const YoungDef&) const = default;
};
/// Steel armour against solid shot (docs/models/de_marre.md).
struct DeMarreDef {
  double quality = 1;  ///< limit speed over that of nickel steel; above 0 [-]
  double plug = 0;     ///< part of a plug of Material::density, as wide as the shot, that it drives out, 0 to 1 [-]

  bool operator==(const DeMarreDef&) const = default;
};
/// Metal plates against long rods (docs/models/lambert_jonas.md); needs Material::density.
struct LambertDef {
  double coefficient = 4000;  ///< rolled homogeneous armour 4000, aluminium 1750 [m/s g^1/2 cm^-3/2]

  bool operator==(const LambertDef&) const = default;
};
/// A plate with a measured ballistic limit: v_r = a (v^p - limit^p)^(1/p) (docs/models/recht_ipson.md).
struct BallisticLimitDef {
  double speed = 0;  ///< the limit, straight on; above 0 [m/s]
  double a = 1;      ///< part of the speed that is left at high speed, 0 to 1 [-]
  double p = 2;      ///< 1 to 100; 2: a constant energy is lost [-]

  bool operator==(const BallisticLimitDef&) const = default;
};
using PenetrationDef = std::variant<ImpenetrableDef, PonceletDef, YoungDef, DeMarreDef, LambertDef, BallisticLimitDef>;

/// Random deflection of what exits behind, or ricochets (docs/models/exit_spread.md). The default: none.
struct SpreadDef {
  double deflection = 0;  ///< standard deviation of its direction, in each of two planes, below pi/2 [rad]
  double yaw = 0;         ///< that of the angle between its axis and its direction, below pi/2 [rad]

  bool operator==(const SpreadDef&) const = default;
};

/// The material of a surface. Effects that are left out are not known, and then do not happen.
struct Material {
  std::string name{};            ///< for tables [-]
  double restitution = 0.5;      ///< part of the speed along the normal that is left after a bounce, 0 to 1 [-]
  double friction = 0.5;         ///< Coulomb's, of what slides on it [-]
  CombineDef combine{};          ///< of restitution and friction with those of the projectile [-]
  double grip_restitution = 0;   ///< part of the slip that comes back after a ball gripped, 0 to 1 [-]
  double density = 0;            ///< 0: not known [kg/m^3]
  RicochetDef ricochet{};        ///< [-]
  PenetrationDef penetration{};  ///< [-]
  SpreadDef spread{};            ///< [-]

  bool operator==(const Material&) const = default;
};

/// Materials with published numbers; restitution and friction are those of any material. Sources:
/// docs/models/README.md#materials.
namespace materials {

/// Balls skip off it, and lose speed in it.
[[nodiscard]] Material water();
/// Concrete of a compressive strength [Pa], 13 to 100 MPa.
[[nodiscard]] Material concrete(double compressive_strength);
/// Softwood, as it met the cannon balls of Metz.
[[nodiscard]] Material fir();
/// Oak, as it met the cannon balls of Metz.
[[nodiscard]] Material oak();
/// Nickel steel armour against solid shot.
[[nodiscard]] Material nickel_steel();
/// Rolled homogeneous armour against long rods.
[[nodiscard]] Material rolled_armour();
/// Aluminium against long rods.
[[nodiscard]] Material aluminium();

}  // namespace materials

// ---------------------------------------------------------------------------------------------------------------------
// The motion of things in a scene: with a steady velocity and turn, or from key to key.

/// Stands where its transform puts it.
struct AtRest {
  bool operator==(const AtRest&) const = default;
};

/// Moves and turns steadily, before `start` too; where its transform puts it, it is at `start`.
struct SteadyMotion {
  double start = 0;          ///< within 1e9 s [s]
  Vec3d velocity{};          ///< of its origin, in W, up to 1e9 m/s [m/s]
  Vec3d angular_velocity{};  ///< about its own origin, in W, up to 1e6 rad/s [rad/s]

  bool operator==(const SteadyMotion&) const = default;
};

/// The place of a thing at a time.
struct MotionKey {
  double time = 0;   ///< later than the key before, within 1e9 s [s]
  Vec3d position{};  ///< of its origin in W [m]
  Quatd rotation{};  ///< from its own frame to W; of any length but zero [-]
  Vec3d velocity{};  ///< of its origin, read by MotionCurve::smooth, up to 1e9 m/s [m/s]

  bool operator==(const MotionKey&) const = default;
};

/// The path of a thing from one key to the next. It turns at a steady rate, the shorter way round, in either case.
enum class MotionCurve {
  straight,  ///< at a steady velocity
  smooth,    ///< along the cubic (Hermite's) that has the positions and velocities of the keys
};

/// Goes from key to key; stands before the first and after the last one. Of its transform only the scale counts.
struct KeyedMotion {
  std::vector<MotionKey> keys{};              ///< one at least, 1e6 at most [-]
  MotionCurve curve = MotionCurve::straight;  ///< [-]

  bool operator==(const KeyedMotion&) const = default;
};

using SceneMotion = std::variant<AtRest, SteadyMotion, KeyedMotion>;

/// The place and motion of a thing at one time.
struct MotionState {
  Vec3d position{};          ///< of its origin in W [m]
  Quatd rotation{};          ///< from its own frame to W [-]
  Vec3d velocity{};          ///< of its origin [m/s]
  Vec3d angular_velocity{};  ///< in W [rad/s]
};

/// The velocity of the point of a thing that is at a place in W [m/s].
[[nodiscard]] Vec3d velocity_at(const MotionState& state, const Vec3d& place);

// ---------------------------------------------------------------------------------------------------------------------
// Scene: solid things that segments and spheres are cast into: shapes, where they stand, what they are made of.

class SceneCanvas;
class SceneByMotion;
class SharedShape;
struct SceneDrawing;

/// The placement of a thing: scaled, then turned, then moved.
struct Transform {
  Vec3d position{};  ///< of its origin in W [m]
  Quatd rotation{};  ///< from its own frame to W; of any length but zero [-]
  double scale = 1;  ///< above 0, the same along all axes [-]

  bool operator==(const Transform&) const = default;
};

// Definitions of shapes, each in its own frame.

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
/// Triangles, counterclockwise as seen from outside. They are surfaces that are met from both sides; if they close a
/// body, its inside and outside are distinguished.
struct MeshShape {
  std::vector<Vec3d> vertices{};                          ///< [m]
  std::vector<std::array<std::uint32_t, 3>> triangles{};  ///< indices of vertices; those without area are left out [-]
  std::vector<MaterialId> materials{};                    ///< of each triangle; empty: that of the instance [-]
};
/// Heights over a grid of x and z, from the origin on; two triangles to each cell, which meet along the diagonal from
/// its corner of the greater x to that of the greater z.
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
    /// The material of triangles without one of their own; none: that of the instance [-].
    std::optional<MaterialId> material{};
  };
  std::vector<Part> parts{};  ///< [-]
};
using ShapeDef = std::variant<PlaneShape, SphereShape, BoxShape, CapsuleShape, CylinderShape, MeshShape,
                              HeightFieldShape, CompoundShape, ConvexHullShape>;

/// How a thing lets projectiles through.
struct PassageDef {
  Vec3d front{};            ///< of a one-way thing, in its own frame, of any length: it stops what comes against this
                            ///< direction to a surface that faces it within 60 degrees; all else passes it, and so does
                            ///< what is inside. Zero: it stops from all sides [-]
  bool tells_stay = false;  ///< of a sensor: EventKind::stayed in worlds [-]

  bool operator==(const PassageDef&) const = default;
};

/// A thing in a scene.
struct InstanceDef {
  ShapeId shape{};              ///< [-]
  Transform transform{};        ///< [-]
  MaterialId material{};        ///< of triangles and parts without one of their own [-]
  std::uint32_t layers = 1;     ///< bits; queries select some of them [-]
  bool sensor = false;          ///< reported, and passed [-]
  std::uint64_t user_data = 0;  ///< for the caller [-]
  std::string name{};           ///< for tables [-]
  SceneMotion motion{};         ///< from its transform on [-]
  ConveyorDef conveyor{};       ///< that its surface is [-]
  PassageDef passage{};         ///< of what comes from behind, or stays in it [-]
};

/// The input of a cast: the points from one end to the other, or spheres about them; steadily, while things move.
struct SceneSegment {
  Vec3d from{};         ///< [m]
  Vec3d to{};           ///< [m]
  double radius = 0;    ///< [m]
  double time = 0;      ///< at which it begins, within 1e9 s [s]
  double duration = 0;  ///< that its way takes, up to 1e9 s; 0: things stand as they do at that time [s]
};

/// Selects the things that a query considers.
struct SceneFilter {
  std::uint32_t layers = 0xffffffff;  ///< those that have one of these bits [-]
  bool sensors = true;                ///< with sensors [-]
  bool from_front = false;            ///< of one-way things only what stops projectiles: a front that is met from
                                      ///< before it. all_hits() and lower bounds have all of them [-]
};

/// The hit of a segment on a surface.
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

/// The point of a surface nearest to a given point.
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

/// A query to an engine: the first hit of each of some segments.
struct EngineBatch {
  std::span<const SceneSegment> segments{};  ///< none is without length; their times are those of the world [m]
  std::uint32_t layers = 0xffffffff;         ///< bits: things of these [-]
  std::span<SceneHit> hits{};  ///< of each segment, empty as it comes: to be filled where it meets something
                               ///< with `part`, `normal` and `instance.index`, above 0 and the engine's own;
                               ///< `velocity`, `primitive`, `material` (of the scene) and `entering` count
                               ///< if they are given, `starts_inside` as well, all else is known [-]
};
/// An engine's own physics, which answers. See EngineScene.
using EngineQuery = std::function<void(const EngineBatch&)>;

/// Things of an engine's own physics, which a scene's questions go to, too (docs/scenes.md#an-engines-own-scene).
///
/// A normal points outwards, of any length but zero. The solid in which a segment starts is best not met by it, as rays
/// of most engines have it. A surface that is met from its back says so by `entering`: the wall of a closed mesh from
/// within. One that never reports its back is a sheet: both sides are met at one place.
///
/// The answer must follow from the segment. Calls are made one after another by the caller of the scene, a world from
/// the thread that steps it; they may read that world, but not change it, nor query its scene about the engine's
/// things. An answer with a NaN, a part outside 0 to 1 or a normal without length, and a call that throws twice, are no
/// hit: EngineCounters::refused counts them.
struct EngineScene {
  EngineQuery query{};  ///< empty: no engine [-]
  double skin = 1e-3;   ///< things are met this far outside their surfaces: at least ten times the error of the
                        ///< engine's numbers there; 1e-6 to 0.1 [m]
};

/// Counts of the calls of an engine; copies of a scene count together.
struct EngineCounters {
  std::uint64_t calls = 0;     ///< of its query [-]
  std::uint64_t segments = 0;  ///< in these [-]
  std::uint64_t refused = 0;   ///< answers that made no sense, or threw: nothing was met [-]
};
/// InstanceId::generation of an engine's things.
inline constexpr std::uint32_t kEngineGeneration = 0xffffffff;

/// Properties of a shape as prepared.
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

  // ---- contents
  /// Shapes are prepared once, and stand in the scene as often as one likes. An error names the number that is wrong.
  [[nodiscard]] Result<ShapeId> add_shape(const ShapeDef& shape);
  /// Refused while something has this shape.
  Status remove_shape(ShapeId shape);
  [[nodiscard]] std::optional<ShapeInfo> info(ShapeId shape) const;
  [[nodiscard]] Result<MaterialId> add_material(const Material& material);
  /// The material; for an unknown id the one that every scene begins with.
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
  /// Lets the surface of a thing run, or stand.
  Status set_conveyor(InstanceId instance, const ConveyorDef& conveyor);
  /// Adds an engine that answers beside the things of this scene: first_hit(), first_hits(), any_hit() and all_hits()
  /// return what is met first of both. Its things are no sensors and not in motion to instance(), state() and others
  /// that name one; nearest(), overlaps() and is_reached() leave them out, clearance() and clear_part() are 0. An error
  /// if the skin is out of its range.
  Status set_engine(const EngineScene& engine);
  /// The engine; null: none.
  [[nodiscard]] const EngineScene* engine() const;
  [[nodiscard]] EngineCounters engine_counters() const;
  /// EngineScene::skin, or 0 [m].
  [[nodiscard]] double skin() const;
  /// The definition of a thing, at its present place; nothing where it is gone.
  [[nodiscard]] std::optional<InstanceDef> instance(InstanceId instance) const;
  /// Number of parts of a thing that is a compound; 0 if it is no compound, or gone [-].
  [[nodiscard]] std::size_t parts(InstanceId instance) const;
  /// Whether some of them are sensors.
  [[nodiscard]] bool has_sensors() const;
  /// Whether this one is; false where it is gone.
  [[nodiscard]] bool is_sensor(InstanceId instance) const;
  /// Whether some sensors tell who stays in them.
  [[nodiscard]] bool tells_stay() const;
  /// Whether this one stops only what comes from its front; false if it is gone.
  [[nodiscard]] bool is_one_way(InstanceId instance) const;
  /// Whether some of them move.
  [[nodiscard]] bool has_motion() const;
  /// The velocity, in W, with which the surface of a thing runs over it, where the surface has a normal, at a time
  /// within 1e9 s; zero if the thing is no conveyor, or gone [m/s].
  [[nodiscard]] Vec3d conveyor_velocity(InstanceId instance, const Vec3d& normal, double time = 0) const;
  /// The place and motion of a thing at a time within 1e9 s; nothing where it is gone.
  [[nodiscard]] std::optional<MotionState> state(InstanceId instance, double time = 0) const;
  /// Rises with each call that changed what may be met where: what was found out before may not hold any more [-].
  [[nodiscard]] std::uint64_t changes() const;
  /// Things that stand in it.
  [[nodiscard]] std::size_t size() const;
  /// Memory of shapes and things [bytes].
  [[nodiscard]] std::size_t bytes() const;

  /// Draws it on a canvas.
  void draw(SceneCanvas& canvas, const SceneDrawing& what) const;

  // ---- saves
  /// All of it as bytes, each shape once, however many things have it.
  [[nodiscard]] std::vector<std::byte> save() const;
  /// The scene that a save holds: with the same ids, now and of what is added later, and the same answers. An error
  /// where the bytes are none, cut, damaged or of another format, and where the scene had an engine and `query` is
  /// empty: functions are no data.
  [[nodiscard]] static Result<Scene> load(std::span<const std::byte> save, const EngineQuery& query = {});
  /// Hash of the content; what cover() covers does not count. A shape is hashed once [-].
  [[nodiscard]] std::uint64_t hash() const;

  // ---- queries; a segment with a NaN, or beyond 1e15 m, meets nothing. What moves straight without
  // turning is met exactly; what turns or moves along a curve may be missed where it is grazed by less than 1e-6 m, and
  // by more where it turns so often within a segment's duration that 65536 chords are not enough.
  /// The first hit of a segment.
  [[nodiscard]] SceneHit first_hit(const SceneSegment& segment, const SceneFilter& filter = {}) const;
  /// Whether it meets anything.
  [[nodiscard]] bool any_hit(const SceneSegment& segment, const SceneFilter& filter = {}) const;
  /// All that a segment's points meet, by part: entries and exits, so that the difference is a thickness. Its radius is
  /// not looked at.
  [[nodiscard]] std::vector<SceneHit> all_hits(const SceneSegment& segment, const SceneFilter& filter = {}) const;
  /// The first hit of each of many segments; `into` has the same length. The answers do not depend on `runner`, which
  /// only lends threads.
  void first_hits(std::span<const SceneSegment> segments, std::span<SceneHit> into, const SceneFilter& filter = {},
                  TaskRunner* runner = nullptr) const;
  /// The surface nearest to a point within 1e15 m, not farther than `within` [m], at a time [s].
  [[nodiscard]] SceneNearest nearest(const Vec3d& point, double within = kInfinity, const SceneFilter& filter = {},
                                     double time = 0) const;
  /// A distance from a point within 1e15 m, `reach` at most, that nothing is nearer than at any time between two [m]: a
  /// lower bound, found by a look at few boxes. It is half of the true distance to what rests at least, but for
  /// rounding; to what moves, less the way that it may go. 0 in a solid, and if a number is NaN.
  [[nodiscard]] double clearance(const Vec3d& point, double reach, const SceneFilter& filter = {}, double from = 0,
                                 double to = 0) const;
  /// A part of a segment, 0 to 1, up to which the spheres of its radius about its points touch nothing: a lower bound,
  /// wherever on it they are at any time between its own time and the end of its duration. 0 if it begins at a surface
  /// or in a solid, if a number is NaN, and if there is an engine.
  [[nodiscard]] double clear_part(const SceneSegment& segment, const SceneFilter& filter = {}) const;
  /// The things that a sphere touches at a time [s], by index.
  [[nodiscard]] std::vector<InstanceId> overlaps(const Vec3d& middle, double radius, const SceneFilter& filter = {},
                                                 double time = 0) const;
  /// Whether something that moves between two times touches a sphere that stands still, at any time between them [s].
  /// Things that rest meanwhile do not count.
  [[nodiscard]] bool is_reached(const Vec3d& middle, double radius, const SceneFilter& filter, double from,
                                double to) const;

 private:
  friend class SceneByMotion;
  friend class SharedShape;
  struct Impl;
  std::unique_ptr<Impl> impl_;
};

// ---------------------------------------------------------------------------------------------------------------------
// Drawing of scenes and worlds for debugging: lines, triangles, balls and texts, on a canvas of the caller.

/// The meaning of a drawn element; colours are the caller's.
enum class SceneInk {
  solid,   ///< a thing that is hit
  sensor,  ///< a thing that only reports
  path,    ///< the path of a thing
  box,     ///< of the trees

  // of a world
  flying,    ///< a projectile that moves
  asleep,    ///< a projectile that sleeps
  held,      ///< a projectile that calls move, or that nothing moves
  velocity,  ///< how far a projectile moves in a time
  contact,   ///< the normal of what was hit in the last step, there
  joint,     ///< between its ends
};

/// Draws. The calls come from the thread that asks, in the order of things.
class SceneCanvas {
 public:
  virtual ~SceneCanvas() = default;
  /// All that is drawn from now on is part of this thing.
  virtual void begin(InstanceId thing) { static_cast<void>(thing); }
  /// All that is drawn from now on is part of this projectile.
  virtual void begin_projectile(ProjectileId projectile) { static_cast<void>(projectile); }
  /// Triangles that are drawn from now on are made of this, up to the next thing.
  virtual void material(MaterialId of) { static_cast<void>(of); }
  /// Between two places in W [m].
  virtual void line(const Vec3d& a, const Vec3d& b, SceneInk ink) = 0;
  /// Counterclockwise as seen from outside [m].
  virtual void triangle(const Vec3d& a, const Vec3d& b, const Vec3d& c, SceneInk ink) = 0;
  /// About a middle in W [m]; without a ball of its own, three circles of 16 lines.
  virtual void ball(const Vec3d& middle, double radius, SceneInk ink);
  /// At a place in W [m].
  virtual void text(const Vec3d& place, std::string_view text) = 0;
};

/// The options of Scene::draw().
struct SceneDrawing {
  bool shapes = true;        ///< their surfaces; planes as a square of lines [-]
  bool plane_faces = false;  ///< planes as a square of two triangles instead [-]
  bool names = false;        ///< at the origin of each thing that has one [-]
  bool boxes = false;        ///< of the trees of things [-]
  double time = 0;           ///< at which things stand [s]
  double ahead = 0;          ///< duration of the drawn paths of things that move [s]
  double plane_size = 100;   ///< half of a plane's square [m]
  SceneFilter filter{};      ///< things that are drawn [-]
};

// ---------------------------------------------------------------------------------------------------------------------
// SharedShape: a mesh or a height field, prepared once and shared by all that hold it.

/// A mesh or a height field that particles come out of. Copies share it, and so do the world's snapshots; a save holds
/// it once, however many emitters have it.
class SharedShape {
 public:
  /// None.
  SharedShape() = default;
  /// Made of a MeshShape or a HeightFieldShape; its materials do not count. Errors are those of Scene::add_shape().
  [[nodiscard]] static Result<SharedShape> make(const ShapeDef& shape);
  /// The mesh or height field of a scene, which is not copied.
  [[nodiscard]] static Result<SharedShape> of(const Scene& scene, ShapeId shape);

  /// Whether there is one.
  explicit operator bool() const { return content_ != nullptr; }
  /// Its definition, without materials; a plane if it is null.
  [[nodiscard]] ShapeDef definition() const;
  /// Hash of the content; 0: null [-].
  [[nodiscard]] std::uint64_t hash() const;
  /// Equal in content.
  bool operator==(const SharedShape& other) const;

  /// All of it as bytes, for saves and recordings.
  [[nodiscard]] std::vector<std::byte> save() const;
  /// The shape of such bytes. An error where they are none.
  [[nodiscard]] static Result<SharedShape> load(std::span<const std::byte> save);

  struct Content;
  /// For the library; null: none.
  [[nodiscard]] const Content* content() const { return content_.get(); }

 private:
  std::shared_ptr<const Content> content_;
};

// ---------------------------------------------------------------------------------------------------------------------
// impact(): what happens to a projectile that meets a material.

/// A projectile as it meets a surface.
struct Impact {
  double mass = 0;           ///< 0 to 1e100; 1e-15 to 1e15 if the material lets things in, or is a liquid that throws
                             ///< them off [kg]
  double diameter = 0;       ///< 1e-15 to 1e15, or 0: a point, which nothing spins; 1e-9 to 1e6 for such materials [m]
  double length = 0;         ///< of a rod, for LambertDef, 0 to 1e15; 0: its diameter [m]
  double nose_length = 0.5;  ///< in diameters: 0 flat, 1/2 a hemisphere, more an ogive [-]
  double inertia = 0.4;      ///< moment of inertia over mass and radius squared: 2/5 a solid ball, 2/3 a hollow one [-]
  Vec3d velocity{};          ///< in W, at most 1e9 [m/s]
  Vec3d spin{};              ///< angular velocity in W, at most 1e15 [rad/s]
  Vec3d normal{0, 1, 0};     ///< of the surface, of length 1, on the side that the projectile comes from [-]
  Vec3d surface_velocity{};  ///< of the surface where it is met [m/s]
  double thickness = 0;      ///< of the material along the way; 0: not known, and without end [m]
  std::uint64_t seed = 0;    ///< of all spreads [-]
  std::uint32_t projectile = 0;  ///< its number [-]
  std::uint32_t hit = 0;         ///< the how many-th of its hits this is [-]
};

enum class ImpactKind {
  none,        ///< it does not move towards the surface
  bounced,     ///< thrown back by restitution
  ricocheted,  ///< thrown off, as it came in flat
  penetrated,  ///< came out behind
  stopped,     ///< stuck in the material
};

/// The result of an impact.
struct ImpactResult {
  ImpactKind kind = ImpactKind::none;  ///< [-]
  Vec3d velocity{};                    ///< at its present place: at the surface, behind the material, or in it [m/s]
  Vec3d spin{};                        ///< [rad/s]
  Vec3d nose{};          ///< of length 1: where its nose points now; {} where it was not turned by a yaw [-]
  double depth = 0;      ///< reached along its way; the thickness where it came out [m]
  double obliquity = 0;  ///< between its way and the normal; 0 straight on [rad]
  double energy = 0;     ///< kinetic energy that it lost, as seen from the surface [J]
};

/// Refuses a material with an impossible value, or one that gains energy; the error names the value.
[[nodiscard]] Status check_material(const Material& material);

/// The result of an impact, decided in this order:
/// 1. a projectile that does not move towards the surface continues: `none`;
/// 2. one that comes in flatter than the critical angle `ricocheted`;
/// 3. one that the material lets through its thickness `penetrated`;
/// 4. one that comes to rest in it, at least half its diameter deep, `stopped`;
/// 5. what is left `bounced`, by restitution, friction and spin.
/// The way through the material is straight and takes no time here. The same input gives the same bits everywhere; the
/// spread depends on seed, projectile and hit alone. An error names the number that is wrong.
[[nodiscard]] Result<ImpactResult> impact(const Impact& hit, const Material& material);

// ---------------------------------------------------------------------------------------------------------------------
// Terrain on the ellipsoid: heights over latitude and longitude, as a mesh of a scene.

/// Heights over a grid of latitude and longitude, from its south-west corner on.
struct GeodeticGrid {
  double latitude = 0;            ///< of the first point, north positive [rad]
  double longitude = 0;           ///< of the first point, east positive [rad]
  double latitude_step = 0;       ///< from row to row northwards; the last one not beyond the pole [rad]
  double longitude_step = 0;      ///< from column to column eastwards; all within once round [rad]
  std::uint32_t columns = 0;      ///< points along a parallel, at least 2 [-]
  std::uint32_t rows = 0;         ///< points along a meridian, at least 2 [-]
  std::vector<double> heights{};  ///< above the ellipsoid, within 1e5 m: heights[row * columns + column] [m]
  std::uint32_t impossible = 0;   ///< points of a file whose height no ground has, and that got another [-]
  double impossible_height = 0;   ///< the first such height, as the file has it [m]
};

/// Two triangles to each cell of a grid, in W as the frames of an environment have it: on a round Earth the terrain
/// falls away with it, 785 m below the tangent plane 100 km away. Errors name the member that is wrong.
[[nodiscard]] Result<MeshShape> terrain_mesh(const GeodeticGrid& grid, const EarthFrames& frames);

}  // namespace physim
