// World: many projectiles in real time, with forces, joints, snapshots and recordings.
#pragma once

#include <array>
#include <compare>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <variant>
#include <vector>

#include "physim/body.hpp"
#include "physim/emitter.hpp"
#include "physim/event.hpp"
#include "physim/flight.hpp"
#include "physim/math.hpp"
#include "physim/result.hpp"
#include "physim/scene.hpp"

namespace physim {

// ---------------------------------------------------------------------------------------------------------------------
// Forces: generators that push projectiles of a world until they are removed or their time is over.

/// F = force.
struct ConstantForce {
  Vec3d force{};  ///< [N]
};
/// F = m a: the same acceleration for every mass.
struct ConstantAcceleration {
  Vec3d acceleration{};  ///< [m/s^2]
};
/// F = m g in any direction: a gravity generator beside or instead of the world's own.
struct GravityForce {
  Vec3d gravity{0, -9.80665, 0};  ///< [m/s^2]
};
/// F = -(k1 + k2 |u|) u, with u the velocity relative to `wind`.
struct LinearQuadraticDragForce {
  double k1 = 0;  ///< [kg/s]
  double k2 = 0;  ///< [kg/m]
  Vec3d wind{};   ///< [m/s]
};
/// Hooke's spring between the projectile and a fixed point, with damping along the spring.
struct AnchoredSpring {
  Vec3d anchor{};          ///< [m]
  double stiffness = 1;    ///< [N/m]
  double rest_length = 0;  ///< [m]
  double damping = 0;      ///< of the rate at which its length changes [kg/s]
};
/// Hooke's spring between the projectile and another one, which feels the opposite force where it can move.
struct Spring {
  ProjectileId other{};    ///< [-]
  double stiffness = 1;    ///< [N/m]
  double rest_length = 0;  ///< [m]
  double damping = 0;      ///< [kg/s]
};
/// A spring that only pulls: nothing below its rest length. Between the projectile and `other`, or `anchor` where there
/// is no other.
struct Bungee {
  ProjectileId other{};    ///< null: anchored [-]
  Vec3d anchor{};          ///< [m]
  double stiffness = 1;    ///< [N/m]
  double rest_length = 0;  ///< [m]
  double damping = 0;      ///< [kg/s]
};
/// Archimedes' lift of a liquid with a level surface, and its resistance. The projectile goes under between depth above
/// and depth below the surface.
struct Buoyancy {
  double surface = 0;        ///< height of the liquid [m]
  double volume = 0;         ///< of the projectile; 0: the sphere of its diameter [m^3]
  double depth = 0;          ///< half the height of an upright cylinder or box; 0: a sphere of its diameter [m]
  double density = 1000;     ///< of the liquid [kg/m^3]
  double damping = 0;        ///< of the velocity in the liquid, times the part under it [kg/s]
  double gravity = 9.80665;  ///< that weighs the liquid; 0: no lift [m/s^2]
};
/// Attraction to a point (repulsion where the strength is negative): F = m strength r / (r^2 + softening^2)^(3/2).
struct PointAttractor {
  Vec3d centre{};        ///< [m]
  double strength = 1;   ///< G M of the attracting mass [m^3/s^2]
  double softening = 0;  ///< keeps the force finite near the centre [m]
};
/// A box of moving air: inside, it takes the place of the air around, with the drag equation and the projectile's own
/// area and Cd (by the Mach number in air of 15 degrees Celsius). Corners may be infinite.
struct WindZone {
  Vec3d velocity{};        ///< of the air [m/s]
  Vec3d low{};             ///< corner of the box [m]
  Vec3d high{};            ///< opposite corner [m]
  double density = 1.225;  ///< of its air [kg/m^3]
};
/// A blast: an outward force that falls linearly from the centre to the radius, over the time it lasts.
struct Explosion {
  Vec3d centre{};     ///< [m]
  double force = 0;   ///< at the centre [N]
  double radius = 1;  ///< [m]
};
/// Thrust along the velocity (nothing at rest), or along a fixed direction, from a table of thrust over time.
struct Thrust {
  struct Point {
    double time = 0;   ///< since the generator was added, or from each launch for kinds [s]
    double force = 0;  ///< [N]
  };
  std::vector<Point> curve{};  ///< straight lines between rising times; nothing before and after [N]
  Vec3d direction{};           ///< in W, of any length; zero: along the velocity [-]
};

/// Input and output of a force function: arrays with one element per projectile that it acts on.
struct ForceBatch {
  double time = 0;                     ///< of the world [s]
  std::span<const ProjectileId> id{};  ///< [-]
  std::span<const Vec3d> position{};   ///< [m]
  std::span<const Vec3d> velocity{};   ///< [m/s]
  std::span<const double> mass{};      ///< [kg]
  std::span<Vec3d> force{};            ///< to be added to [N]
};
/// The user's own force. Called once per stage for all projectiles of a batch that it acts on, from one thread. It must
/// be a function of what it sees. It may read its world, as that was when the step began, but not change it (see
/// World), and must not throw: of a call that does, nothing is felt.
struct CustomForce {
  std::function<void(const ForceBatch&)> function{};  ///< [-]
};

using ForceLaw =
    std::variant<ConstantForce, ConstantAcceleration, GravityForce, LinearQuadraticDragForce, AnchoredSpring, Spring,
                 Bungee, Buoyancy, PointAttractor, WindZone, Explosion, Thrust, CustomForce>;

/// The targets of a generator: projectiles one by one, or everything of a kind, or of some layers.
struct ForceTarget {
  std::vector<ProjectileId> ids{};  ///< these [-]
  KindId kind{};                    ///< all of this kind, now and later [-]
  std::uint32_t layers = 0;         ///< all with one of these layer bits, now and later [-]

  static ForceTarget everything() { return {{}, {}, 0xffffffffu}; }
};

struct ForceDef {
  ForceLaw law{};               ///< [-]
  ForceTarget target{};         ///< [-]
  double delay = 0;             ///< before it starts [s]
  double duration = kInfinity;  ///< then it removes itself [s]
};

// ---------------------------------------------------------------------------------------------------------------------
// Joint: a rod, cable, spring, hinge or slider that holds a projectile of a world to another one, or to a point that
// rests, moves or is fixed to a thing of the scene.

enum class JointKind : std::uint8_t {
  rod,     ///< keeps the distance of its ends: it pulls and pushes
  cable,   ///< lets them come nearer, and not farther apart: it only pulls
  spring,  ///< Hooke's law with damping; it is stable however stiff it is
  hinge,   ///< lets an end go round an axis through the other one, in a plane circle
  slider,  ///< lets an end go along an axis through the other one
};

/// A link of two projectiles, or of one to a point. It has no mass, is straight, meets nothing, and ends in the middles
/// of projectiles, which it does not turn.
struct Joint {
  JointKind kind = JointKind::rod;  ///< [-]
  ProjectileId a{};                 ///< one end [-]
  ProjectileId b{};                 ///< the other end; null: `point` [-]
  Vec3d point{};                    ///< where there is no b: of the world, or of `thing` in its own frame [m]
  std::optional<double> length{};   ///< of a rod, a taut cable, radius of a hinge: above 0; of a spring at rest: 0 or
                                    ///< more; none: as far as its ends are apart when it is added [m]
  double restitution = 0;           ///< of a cable: speed kept when it comes taut, 0..1; 0: its ends go on together [-]
  double stiffness = 1;             ///< of a spring [N/m]
  double damping = 0;               ///< of a spring: of the rate at which its length changes [kg/s]
  std::optional<double> break_force{};  ///< it ends if it pulls or pushes with more, on the mean of a step; above 0;
                                        ///< none: it never breaks [N]
  Vec3d velocity{};                     ///< of a point of the world, at most 1e9 [m/s]
  InstanceId thing{};                   ///< of the scene, where there is no b: it takes the point along [-]
  Vec3d axis{};                         ///< of a hinge or slider, of any length but zero: in W, or in the frame of
                                        ///< `thing`, with which it turns [-]
  Vec3d reference{};                    ///< of a hinge: direction of angle 0, as the axis; zero: where a is when it is
                                        ///< added [-]
  std::optional<double> low_angle{};    ///< of a hinge, -pi to pi, about its axis; none: -pi, or no limits [rad]
  std::optional<double> high_angle{};   ///< above low_angle; none: pi, and without both it turns freely [rad]
  std::optional<double> low{};          ///< of a slider, from b or the point along its axis; none: it goes freely [m]
  std::optional<double> high{};         ///< above low [m]

  bool operator==(const Joint&) const = default;
};

/// The present state of a joint.
struct JointState {
  double length = 0;     ///< distance of its ends [m]
  double tension = 0;    ///< with which it pulled them together, on the mean of the last step; negative: it pushed [N]
  bool is_taut = false;  ///< all but cables: always; a cable that is as long as it can be [-]
  double force = 0;      ///< with which it acted on its ends, on the mean of the last step [N]
  double angle = 0;      ///< of a hinge, from its reference about its axis, -pi to pi [rad]
  double way = 0;        ///< of a slider, from b or its point along its axis [m]
};

enum class JointEventKind : std::uint8_t {
  came_taut,  ///< a cable that hung loose
  ended,      ///< a projectile at one of its ends left the world, or the thing of its point the scene
  broke,      ///< it pulled or pushed with more than its break_force
};

struct JointEvent {
  JointEventKind kind = JointEventKind::ended;  ///< [-]
  JointId joint{};                              ///< [-]
  ProjectileId projectile{};                    ///< the one that left, else the first end of the joint [-]
  double time = 0;                              ///< the end of the step in which it was [s]
  double speed = 0;                             ///< at which the ends of a cable parted before [m/s]
};

/// Counts and residual of the joint solver.
struct JointCounts {
  std::size_t joints = 0;      ///< there are now [-]
  std::uint32_t rounds = 0;    ///< most that one net of joints took in the last step [-]
  double residual = 0;         ///< the farthest that a rod or a taut cable was from its length after it [m]
  std::uint64_t unsolved = 0;  ///< nets in a step that were not found within their rounds, since the world was made [-]
};

// ---------------------------------------------------------------------------------------------------------------------
// Drawing of a world for debugging.

/// The options of World::draw().
struct WorldDrawing {
  SceneDrawing scene{};               ///< of its things; `time` is not read: they stand where they are now [-]
  bool things = true;                 ///< its scene is drawn [-]
  double point_size = 0.05;           ///< half of the cross of a point; 0: none [m]
  double ahead = 0;                   ///< duration of the drawn lines of velocities; 0: none [s]
  double normals = 0;                 ///< length of the drawn normals of contacts; 0: none [m]
  bool joints = true;                 ///< a line for each [-]
  bool labels = false;                ///< at projectiles that have one [-]
  std::uint32_t layers = 0xffffffff;  ///< projectiles of these layers [-]
};

// ---------------------------------------------------------------------------------------------------------------------
// A world's projectiles as they lie in memory: for renderers and others that read all of them in every frame.

/// Projectiles of one rung, a column for each coordinate; the i-th number of each column is of the i-th of them. R is
/// the precision in which they fly. Spans of the world's own memory: they hold until it is changed or steps.
template <class R>
struct ColumnsOf {
  std::span<const std::uint32_t> index{};        ///< ProjectileId::index; World::id_at() makes it one [-]
  std::array<std::span<const R>, 3> position{};  ///< x, y and z [m]
  std::array<std::span<const R>, 3> previous{};  ///< at the start of the last step, see segments() [m]
  std::array<std::span<const R>, 3> velocity{};  ///< [m/s]
};

using WorldColumns = std::variant<ColumnsOf<float>, ColumnsOf<double>>;

// ---------------------------------------------------------------------------------------------------------------------
// Projectile: a projectile of a world, by its id. What it does, and how to change it.

/// The place and velocity of a projectile.
struct BodyState {
  Vec3d position{};  ///< [m]
  Vec3d velocity{};  ///< [m/s]

  bool operator==(const BodyState&) const = default;
};

struct WorldImpl;

/// A projectile of a world, to be read: `world[id]`. It is an id and a place to look it up, as cheap to make as to
/// copy, and holds as long as its world. Of a projectile that is gone all is zero.
class ProjectileView {
 public:
  ProjectileView(const WorldImpl* world, ProjectileId id) : world_(world), id_(id) {}

  [[nodiscard]] ProjectileId id() const { return id_; }
  [[nodiscard]] bool is_alive() const;
  /// Also of one that is gone, until its slot is used again.
  [[nodiscard]] LifeStatus status() const;
  [[nodiscard]] bool is_asleep() const;
  [[nodiscard]] bool is_kinematic() const;

  [[nodiscard]] Vec3d position() const { return position_of(world_, id_); }  ///< [m]
  [[nodiscard]] Vec3d velocity() const { return velocity_of(world_, id_); }  ///< [m/s]
  [[nodiscard]] BodyState state() const { return state_of(world_, id_); }
  [[nodiscard]] Vec3d previous_position() const;  ///< before the last step [m]
  /// To draw, by its Smoothing: between steps by the leftover fraction of World::advance() [m].
  [[nodiscard]] Vec3d render_position() const;
  [[nodiscard]] Quatd orientation() const;       ///< takes body axes into W [-]
  [[nodiscard]] Vec3d angular_velocity() const;  ///< [rad/s]
  [[nodiscard]] double age() const;              ///< since launch [s]
  [[nodiscard]] double mach() const;             ///< 0 where it flies in no air, as Sample::mach [-]
  [[nodiscard]] double mass() const;             ///< infinite where nothing moves it [kg]
  [[nodiscard]] double inverse_mass() const;     ///< [1/kg]
  /// Mass times acceleration now: of all models and generators, as accelerations() [N].
  [[nodiscard]] Vec3d resultant_force() const;
  /// Acceleration by effect now; `applied` holds the generators too, `constraint` what surfaces do to a projectile that
  /// rests, rolls or slides (inside a step of its world, without custom forces and surfaces).
  [[nodiscard]] Accelerations accelerations() const;
  /// Rate of change of the acceleration along the path now, as Flight::jerk(); generators count by place and velocity
  /// [m/s^3].
  [[nodiscard]] Vec3d jerk() const;

  [[nodiscard]] KindId kind() const;
  [[nodiscard]] const ProjectileDef* definition() const;  ///< null where it is gone
  /// The fidelity that it really uses, and the reasons.
  [[nodiscard]] FidelityInUse fidelity_in_use() const;
  /// Its present properties in the world: those of its kind, but for what was changed since.
  [[nodiscard]] BodyDef body() const;
  [[nodiscard]] std::uint64_t user_data() const;
  [[nodiscard]] std::uint32_t layers() const;
  [[nodiscard]] std::uint32_t colour() const;
  [[nodiscard]] std::string label() const;

 private:
  // The values that are read most, so that the view itself need not be in memory.
  static Vec3d position_of(const WorldImpl* world, ProjectileId id);
  static Vec3d velocity_of(const WorldImpl* world, ProjectileId id);
  static BodyState state_of(const WorldImpl* world, ProjectileId id);

 protected:
  const WorldImpl* world_;
  ProjectileId id_;
};

/// A projectile of a world, to be changed too. What cannot be done is refused, with a reason: the projectile is gone,
/// or the value makes no sense. A change of how it moves wakes it.
class Projectile : public ProjectileView {
 public:
  Projectile(WorldImpl* world, ProjectileId id) : ProjectileView(world, id) {}

  Status despawn();
  /// A jump: it meets nothing on the way, and render_position() continues after it as before [m].
  Status set_position(const Vec3d& position);
  Status set_velocity(const Vec3d& velocity);
  Status set_state(const BodyState& state);
  Status apply_impulse(const Vec3d& impulse);  ///< [N s]
  Status set_angular_velocity(const Vec3d& omega);
  /// Moves it to another rung with its state unchanged.
  Status set_fidelity(const Fidelity& fidelity);
  /// Changes all that ProjectileDef marks (live) at once: it becomes a projectile of another kind, and generators of
  /// its former kind act on it no more. Place, velocity, spin and attitude stay, its momentum does not. A k2 that
  /// stands in for the drag equation is fitted again at its place. Refused if `projectile` differs from definition() in
  /// anything else or makes no sense, and for one with a motor: its tables say how its mass and its drag change.
  Status set_projectile(const ProjectileDef& projectile);
  Status set_mass(double mass);          ///< [kg]; drag by a ballistic coefficient stays: it contains its own mass
  Status set_drag(const DragDef& drag);  ///< all of it: table, coefficients, damping, k1 and k2
  Status set_damping(double damping);    ///< DragDef::damping alone, above 0 and not above 1 [-]
  /// Changes all that BodyDef marks (live) at once; refused where `body` differs from body() in anything else.
  Status set_body(const BodyDef& body);
  Status set_gravity_scale(double scale);
  Status set_use_gravity(bool use);
  Status set_kinematic(bool kinematic);
  Status set_frozen(Axes position_axes, Axes rotation_axes);
  Status set_can_sleep(bool can);
  Status sleep();  ///< an error where it stands still already
  Status wake();   ///< an error where it neither sleeps nor sticks
  Status set_smoothing(Smoothing smoothing);
  Status set_user_data(std::uint64_t data);
  Status set_layers(std::uint32_t layers);
  Status set_colour(std::uint32_t rgba);
  Status set_label(const std::string& label);
  /// A generator that acts on this one alone, until it is removed; or for a duration [s].
  Result<ForceId> add_force(ForceLaw law);
  Result<ForceId> add_force(ForceLaw law, double duration);
  /// Takes it out of a generator's targets.
  Status remove_force(ForceId force);

 private:
  [[nodiscard]] WorldImpl& world() const { return const_cast<WorldImpl&>(*world_); }
};

// ---------------------------------------------------------------------------------------------------------------------
// World: many projectiles in real time, stepped by frame. Each is on its own rung; all are named by ids.

/// The way of a projectile in the last step: the input of a scene query.
struct Segment {
  ProjectileId id{};  ///< [-]
  Vec3d from{};       ///< [m]
  Vec3d to{};         ///< [m]
};

/// A projectile that a cast touches.
struct ProjectileHit {
  ProjectileId id{};  ///< [-]
  double part = 0;    ///< of the way, 0 to 1, up to where it is touched; 0: it is touched from the start [-]
  Vec3d position{};   ///< of the point, or of the middle of the ball that is cast, then [m]
  Vec3d normal{};     ///< from the projectile's middle to that, of length 1; zero if they coincide [-]
};

/// Counters of what was dropped, since the world was made.
struct WorldCounters {
  std::uint64_t steps = 0;             ///< taken [-]
  std::uint64_t projectile_steps = 0;  ///< of moving projectiles [-]
  std::uint64_t refused = 0;           ///< projectiles not spawned [-]
  std::uint64_t retired = 0;           ///< by something that was not a number [-]
  double dropped_time = 0;             ///< that advance() could not keep up with [s]
  std::uint64_t dropped_events = 0;    ///< of calls between steps, see World::events() [-]
};

/// Projectiles of one rung that are computed together.
struct CohortInfo {
  Fidelity fidelity{};      ///< granted [-]
  std::uint32_t count = 0;  ///< projectiles [-]
  bool moving = true;       ///< false: asleep, kinematic, pending [-]
  bool forced = false;      ///< generators act on it, or its emitter [-]
};

/// Events of calls between two steps that a world keeps: this number, or twice that of its projectiles if it is larger.
inline constexpr std::size_t kMostEventsOfCalls = 1u << 16;

/// Takes the bytes of a recording, piece by piece: before and after each step, when 64 KiB have gathered, and in
/// World::stop_recording(), with an empty last piece. An error ends the recording. The sink may read the world, but not
/// change it (see World). The end of its world does not call it, since what it refers to may be gone by then, unless
/// RecordOptions::complete_at_end says so.
using RecordSink = std::function<Status(std::span<const std::byte>)>;

struct RecordOptions {
  std::uint32_t hash_every = 1;  ///< steps; 0: no hashes, and a replay compares ids only [-]
  bool from_now = false;         ///< the recording begins with World::save(), and the world need not be new [-]
  bool complete_at_end = false;  ///< the end of the world completes the recording as stop_recording() does: all that
                                 ///< the sink refers to must outlive the world [-]
};

inline constexpr char kSaveMagic[8] = {'P', 'H', 'Y', 'S', 'I', 'M', 'S', '\n'};
/// The format of a save's bytes; others are refused.
inline constexpr std::uint32_t kSaveFormat = 17;

/// Parts that a save lacks: functions are no data. They are given again: custom forces in the order they were added;
/// those of environments in the order of these, each once, however many have it. A scene has one engine, if any.
struct LoadOptions {
  Threading threading{};                      ///< it changes no result [-]
  std::vector<CustomForce> custom_forces{};   ///< of ForceDef [-]
  std::vector<WindFunction> wind_fields{};    ///< of Wind::field [-]
  std::vector<ForceFunction> force_fields{};  ///< of Environment::force [-]
  std::vector<EngineQuery> engine_queries{};  ///< of each scene with an engine that was given, in order [-]
  HitFunction hit_function{};  ///< of kinds that ask, where the save has some; a replay has the answers itself [-]
};

class WorldState;
class Recorder;

/// A frozen moment of a world; cheap to copy.
class Snapshot {
 public:
  Snapshot() = default;
  [[nodiscard]] double time() const;  ///< of the world [s]
  explicit operator bool() const { return state_ != nullptr; }

 private:
  friend class World;
  explicit Snapshot(std::shared_ptr<const WorldState> state) : state_(std::move(state)) {}
  std::shared_ptr<const WorldState> state_;
};

/// Many projectiles in real time. Nothing throws; what cannot be done is refused, with a reason.
///
/// Threads: calls that change a world are made from one thread at a time, and while none is made any number of threads
/// may read (all that is const, hash(), snapshot() and save() too).
///
/// Callbacks: from inside its own step (a CustomForce, an EngineQuery, a HitFunction, a TaskRunner) and from its
/// RecordSink a world can be read, but not changed: every call that would is refused, those that return numbers return
/// 0, snapshot() is empty, and accelerations() are without custom forces. A world that is destroyed or moved there ends
/// its step first.
///
/// A world that was moved away is as World() makes it.
class World {
 public:
  World();  ///< with WorldDef{}
  /// An error where the definition makes no sense.
  [[nodiscard]] static Result<World> create(const WorldDef& def);
  World(World&&) noexcept;
  World& operator=(World&&) noexcept;
  ~World();

  // ------------------------------------------------------------------------------------------- kinds and environments
  /// Prepares a kind of projectile, so that each of it is spawned quickly. Definitions that are equal to the bit give
  /// the same kind. It stays as long as its world; a kind that spawn() makes of a definition is let go some time after
  /// the last projectile of it.
  Result<KindId> add_kind(const ProjectileDef& projectile, const BodyDef& body = {});
  /// Another place to fly in; its index for BodyDef::environment.
  Result<std::uint32_t> add_environment(const Environment& environment);
  /// Changes an environment from the next step on (a gust, a new day).
  Status set_environment(std::uint32_t index, const Environment& environment);

  // ------------------------------------------------------------------------------------------- coming and going
  /// A projectile of a kind. `delay` [s]: it is pending until then, and flies from that moment on, also inside a step.
  Result<ProjectileId> spawn(KindId kind, const Launch& launch, double delay = 0);
  /// A projectile of a definition that need not be a kind yet.
  Result<ProjectileId> spawn(const ProjectileDef& projectile, const Launch& launch, const BodyDef& body = {},
                             double delay = 0);
  /// Many of one kind; ids in the order of the launches, null where one is refused. Returns how many were spawned.
  std::size_t spawn(KindId kind, std::span<const Launch> launches, std::span<ProjectileId> ids);
  /// Continues the projectile of a flight in this world, from a time of the flight [s]: place, velocity, attitude and
  /// spin, with its motor burnt until then, at the fidelity that was granted to it. An error for a flight that was
  /// refused, and on a launch rail.
  Result<ProjectileId> spawn(const Flight& flight, double time, const BodyDef& body = {});
  /// A projectile that is on its way already.
  Result<ProjectileId> spawn_departed(const ProjectileDef& projectile, const Departure& from, const BodyDef& body = {});
  /// Reserves room for `count` more, so that spawning does not allocate; an error if there is no memory for them, or if
  /// they would be more than WorldDef::max_projectiles.
  Status reserve(KindId kind, std::size_t count);
  /// Takes many out; returns how many were there.
  std::size_t despawn(std::span<const ProjectileId> ids);
  void clear();  ///< despawns all

  [[nodiscard]] std::size_t size() const;               ///< alive
  [[nodiscard]] std::vector<ProjectileId> ids() const;  ///< of all alive, by index
  void ids(std::vector<ProjectileId>& into) const;      ///< of all alive, into memory of before

  // ------------------------------------------------------------------------------------------- one of them
  /// To read and change one: `world[id].position()`, `world[id].set_fidelity(...)`.
  [[nodiscard]] Projectile operator[](ProjectileId id) { return {impl_ ? impl_.get() : &impl(), id}; }
  [[nodiscard]] ProjectileView operator[](ProjectileId id) const { return {impl_ ? impl_.get() : &impl(), id}; }

  // ------------------------------------------------------------------------------------------- prediction
  /// The flight from now on, its time 0, by steps of `step` [s] (0: WorldDef::step): attitude, spin, what its motor
  /// has burnt, its own gravity and other settings, and generators as they are now. At the end of each step it is, to
  /// the bit, where step() would bring it, as long as nothing changes it: rules that despawn, put to sleep or move it
  /// to another rung are left out, and so are joints and springs to others; its notes name them. It meets the things of
  /// the world's scene as it will, those that move too, and records its hits; with OnHit::ask it ends at the first. It
  /// ends where it first meets `until`, such as the ground: there it does not bounce. Range and sight are level, along
  /// its velocity. Refused for one that is gone, stands still (asleep, kinematic, of infinite mass, stuck) or is
  /// pending, for events of kind `time` in `until`, and for another scene there. Costs about as much as fly().
  [[nodiscard]] Flight predict(ProjectileId id, const Until& until, double step = 0) const;
  /// ... until the ground of this world, or for a time [s].
  [[nodiscard]] Flight predict(ProjectileId id, double time, double step = 0) const;
  /// The ends of many of them, in their order; paths are not kept. Returns how many are not refused.
  std::size_t predict(std::span<const ProjectileId> ids, const Until& until, std::span<ShotResult> into,
                      double step = 0) const;

  // ------------------------------------------------------------------------------------------- all or many of them
  void states(std::span<const ProjectileId> ids, std::span<BodyState> into) const;
  void render_positions(std::span<const ProjectileId> ids, std::span<Vec3d> into) const;  ///< to draw them at [m]
  /// Segments of the last step, of all that moved, by cohort; `into` is cleared.
  void segments(std::vector<Segment>& into) const;
  /// All that are alive as they lie in memory, some columns for each rung; nothing is copied. `into` is cleared.
  void columns(std::vector<WorldColumns>& into) const;
  /// The projectile that is alive at an index; null where none is.
  [[nodiscard]] ProjectileId id_at(std::uint32_t index) const;
  // Queries that see projectiles: all that are alive and launched, asleep or not, of some BodyDef::layers, as balls of
  // their CollisionDef::radius at their present places. A query reads the place of each; things of the scene are not in
  // its way.
  /// Those that a sphere touches, by index: who is in a blast?
  [[nodiscard]] Result<std::vector<ProjectileId>> projectiles_in(const Vec3d& middle, double radius,
                                                                 std::uint32_t layers = 0xffffffff) const;
  /// Those that a box touches, by index; `half`: half of its edges, before the transform's scale [m].
  [[nodiscard]] Result<std::vector<ProjectileId>> projectiles_in(const Transform& at, const Vec3d& half,
                                                                 std::uint32_t layers = 0xffffffff) const;
  /// Those that a ray, or a ball on a straight way, touches, in order of part, then of index. Points are touched by a
  /// ball only.
  [[nodiscard]] Result<std::vector<ProjectileHit>> projectiles_along(const Vec3d& from, const Vec3d& to,
                                                                     double radius = 0,
                                                                     std::uint32_t layers = 0xffffffff) const;
  /// Moves projectiles to another rung, as they are; returns how many.
  std::size_t set_fidelity(std::span<const ProjectileId> ids, const Fidelity& fidelity);
  Status set_detail(const DetailRule& rule);
  Status set_observer(const Vec3d& position);  ///< of DetailRule distances [m]

  // ------------------------------------------------------------------------------------------- forces
  /// A generator. Only projectiles in motion `force` feel it: felt_by() counts them.
  Result<ForceId> add_force(const ForceDef& force);
  Status remove_force(ForceId force);
  [[nodiscard]] bool is_active(ForceId force) const;
  [[nodiscard]] std::size_t force_count() const;
  /// Number of its present targets in motion `force`; 0: it acts, and nothing feels it.
  [[nodiscard]] std::size_t felt_by(ForceId force) const;

  // ------------------------------------------------------------------------------------------- joints
  /// From now on it holds its ends, whatever they fly by, on their centres. An end that is kinematic, pending, stuck or
  /// of infinite mass stands still. It ends when a projectile that it holds leaves the world. Ends that are not as far
  /// apart as a rod or a taut cable lets them be come there in the next step, without a speed.
  /// Refused where both ends are one, where an end is gone or held by 64 joints, and where a number makes no sense.
  Result<JointId> add_joint(const Joint& joint);
  /// Frees the projectiles that it held; those asleep wake.
  Status remove_joint(JointId joint);
  [[nodiscard]] std::vector<JointId> joints() const;  ///< of all there are, by index
  /// Puts the point of a joint at a place now. From there it goes on straight at a velocity, until it is moved again;
  /// the end of a rod follows it exactly. Refused if the joint holds two projectiles, or its point is that of a thing.
  Status move_joint(JointId joint, const BodyState& to);
  [[nodiscard]] const Joint* joint(JointId joint) const;      ///< with its length and present point; null: it is gone
  [[nodiscard]] JointState joint_state(JointId joint) const;  ///< zeros: it is gone
  /// The events of joints in the last step() or advance(), and by calls since, as events() of projectiles.
  [[nodiscard]] std::vector<JointEvent> joint_events() const;
  [[nodiscard]] JointCounts joint_counts() const;

  // ------------------------------------------------------------------------------------------- scene
  /// Sets the scene that projectiles meet from now on, as BodyDef::on_hit says: a copy of it with its ids, and the
  /// engine that answers beside it. Projectiles asleep wake.
  Status set_scene(const Scene& scene);
  /// They meet nothing any more.
  Status remove_scene();
  /// The scene; null: none. It stays until the next call that changes it.
  [[nodiscard]] const Scene* scene() const;
  // Changes of the scene, as Scene has them, at the cost of what they change; refused if there is no scene.
  Result<ShapeId> add_shape(const ShapeDef& shape);
  Status remove_shape(ShapeId shape);
  Result<MaterialId> add_material(const Material& material);
  Result<InstanceId> add_instance(const InstanceDef& instance);
  Status remove_instance(InstanceId instance);
  Status move_instance(InstanceId instance, const Transform& to);
  /// Times of motions are those of the world.
  Status set_instance_motion(InstanceId instance, const SceneMotion& motion);
  Status set_instance_layers(InstanceId instance, std::uint32_t layers);
  Status set_instance_conveyor(InstanceId instance, const ConveyorDef& conveyor);
  /// The function that decides what hits of kinds with OnHit::ask do: called in the thread that steps, with all hits of
  /// a step until then, then with those that follow in the rest of it. What is emitted or dies inside the step, and
  /// what met another projectile in it, asks alone. It may read the world, which then stands where the step began, but
  /// not change it. An answer decides and promises nothing, since another projectile may be met before: events report
  /// what happened. An answer that makes no sense, and all of a call that throws, count as OnHit::stop; hit_counts()
  /// counts them. Refused if it is empty while there are kinds that ask; without it such kinds are refused.
  Status set_hit_function(HitFunction function);
  [[nodiscard]] HitCounts hit_counts() const;
  /// The error of the last answer that was refused; empty: none was.
  [[nodiscard]] std::string refused_answer() const;

  // ------------------------------------------------------------------------------------------- emitters
  /// From now on it fires, at its own moments inside steps. What is emitted flies the rest of that step; what is
  /// emitted, when, where and how fast follows from the definition alone, however long steps are.
  Result<EmitterId> add_emitter(const EmitterDef& def);
  /// Projectiles that it fired stay, without an emitter from then on.
  Status remove_emitter(EmitterId emitter);
  /// It begins again, with the delay before its first cycle; the numbers of particles continue.
  Status play_emitter(EmitterId emitter);
  /// It no longer fires on its own.
  Status stop_emitter(EmitterId emitter);
  /// In the course of the next step it goes straight to that place, and turns; later it stays there. Its scale does not
  /// count. Refused for one that follows a projectile or has a motion.
  Status move_emitter(EmitterId emitter, const Transform& to);
  /// It goes straight to that place, and turns, at steady rates, and is there by that time of the world [s]; then it
  /// stays. Further calls add legs that begin where and when the last one ends, so that a polyline is given a leg or
  /// more ahead; the first leg begins where it is now. Unlike that of move_emitter() this way does not depend on steps:
  /// what is emitted on it is equal to the bit at any frame rate. A leg takes 1e-6 s or more, up to time 1e9 s and at
  /// up to 1e9 m/s. move_emitter() and jump_emitter() end the way where it is then. Refused as move_emitter() is.
  Status lead_emitter(EmitterId emitter, const Transform& to, double time);
  /// It stands there from now on, without a way to it: nothing is emitted by distance, and rain fills the part of its
  /// box that is new. Refused as move_emitter() is.
  Status jump_emitter(EmitterId emitter, const Transform& to);
  /// As if it had begun to play this time ago, 0 to 1e9 s: its particles are replaced by those that would exist, as
  /// with EmitterCycle::prewarm; numbers and draws are those of the present play, so that the result is that of waiting
  /// for this time. Rain begins now. Of the past 2^26 births and 2^24 steps of particles are flown; an emitter with a
  /// longer one stops there, and EmitterCounts::cut counts it.
  Status seek_emitter(EmitterId emitter, double time);
  /// It fires `count` now, up to 1e6, besides what it fires on its own; returns how many were emitted.
  Result<std::size_t> emit(EmitterId emitter, std::uint32_t count);
  /// Its sub-emitters that wait for SubEvent::trigger fire now, at each of its particles.
  Status trigger_emitter(EmitterId emitter);
  [[nodiscard]] std::vector<EmitterId> emitters() const;                ///< of all there are, by index
  [[nodiscard]] const EmitterDef* emitter(EmitterId emitter) const;     ///< null: it is gone
  [[nodiscard]] bool is_playing(EmitterId emitter) const;               ///< it may fire on its own
  [[nodiscard]] EmitterCounts emitter_counts(EmitterId emitter) const;  ///< zeros: it is gone
  /// Its particles, by the index of their ids or from far to near; returns how many there are. Columns that are shorter
  /// get the first ones.
  std::size_t particles(EmitterId emitter, const ParticleColumns& into) const;
  /// The past places of its particles (TrailDef), in their order; returns how many there are.
  TrailCounts trails(EmitterId emitter, const TrailColumns& into) const;

  // ------------------------------------------------------------------------------------------- time
  /// One step of dt [s], now; 1e-9 at least and below 1e6. Fastest where dt stays the same. Integrators with fixed
  /// steps take it as their step, whatever its error; where the ground bounces, steps of more than 0.1 s are flown in
  /// parts.
  Status step(double dt);
  /// Real time has passed: takes as many steps of WorldDef::step as fit; returns how many. None while paused, nor for a
  /// time that is NaN, negative or 1e9 s or more.
  int advance(double real_dt);
  void set_paused(bool paused);
  [[nodiscard]] bool is_paused() const;
  /// One fixed step, paused or not.
  void single_step();
  Status set_time_scale(double scale);
  [[nodiscard]] double time_scale() const;
  [[nodiscard]] double time() const;      ///< of the simulation [s]
  [[nodiscard]] double fraction() const;  ///< of a step that advance() has left over, 0..1 [-]

  /// The events of the last step() or advance(), in order of time, then of id, and then those of calls since. The
  /// returned span stays unchanged until the next step(), advance(), single_step() or forget_events(), whatever is
  /// changed: spawning and despawning in a loop over it is fine, and the next call of events() returns their events. Of
  /// calls between two steps kMostEventsOfCalls or more are kept; counters() returns how many were dropped.
  [[nodiscard]] std::span<const Event> events() const;
  void forget_events();  ///< events() is empty then
  [[nodiscard]] const WorldCounters& counters() const;
  [[nodiscard]] std::vector<CohortInfo> cohorts() const;
  /// Draws it on a canvas: its things, its projectiles as they are drawn between steps, joints, and what was hit in the
  /// last step. Nothing for numbers below 0 or above 1e9.
  void draw(SceneCanvas& canvas, const WorldDrawing& what = {}) const;
  /// Memory that grows with use: projectiles, kinds, rungs and cohorts, tables, forces, events. Snapshots have their
  /// own [bytes].
  [[nodiscard]] std::size_t memory() const;

  // ------------------------------------------------------------------------------------------- moments
  [[nodiscard]] Snapshot snapshot() const;
  /// Back to a moment of this world, bit for bit; an error for a snapshot of another world.
  Status restore(const Snapshot& snapshot);
  /// A hash of all that decides what happens next, and of what is carried along; not of what is only shown, nor of how
  /// the world came here. The same on every machine, with any kernel and number of threads. Costs about 15 ns per
  /// projectile.
  [[nodiscard]] std::uint64_t hash() const;

  // ------------------------------------------------------------------------------------------- saves
  /// All of this world as bytes: load() makes of them a world that continues with the same hash and ids, on any
  /// machine. Snapshots, events and threads are not in it; functions of your own are handed in again. An error inside a
  /// step.
  [[nodiscard]] Result<std::vector<std::byte>> save() const;
  /// The world of a save. Bytes that are damaged, cut, of another format, or that lack functions are refused.
  [[nodiscard]] static Result<World> load(std::span<const std::byte> save, const LoadOptions& options = {});

  // ------------------------------------------------------------------------------------------- recordings
  /// Every call that changes this world goes to `sink` from now on, until stop_recording(); Replay makes them again. A
  /// world that ends before leaves a recording of all up to its last step, without its end. For a world to which
  /// nothing was done yet, or from a save on (RecordOptions::from_now). If the sink fails, the world continues without
  /// it.
  [[nodiscard]] Status record(RecordSink sink, const RecordOptions& options = {});
  /// Completes the recording; an error where part of it was lost.
  [[nodiscard]] Status stop_recording();
  [[nodiscard]] bool is_recording() const;  ///< and it has not failed

  // ------------------------------------------------------------------------------------------- threads
  /// Work goes to this instead of the world's own threads; null: back to those. It must outlive the world.
  void set_task_runner(TaskRunner* runner);

  [[nodiscard]] const WorldDef& def() const;

 private:
  explicit World(const WorldDef& def);
  explicit World(std::shared_ptr<WorldImpl> impl);
  friend class Recorder;
  /// Its parts: new ones where they were moved away, or, to be read, those of an empty world.
  [[nodiscard]] WorldImpl& impl();
  [[nodiscard]] const WorldImpl& impl() const;
  std::shared_ptr<WorldImpl> impl_;
};

// ---------------------------------------------------------------------------------------------------------------------
// Recordings: every call that changed a world, to be made again. Replay: makes them, and compares.

inline constexpr char kRecordingMagic[8] = {'P', 'H', 'Y', 'S', 'I', 'M', 'R', '\n'};
/// The format of a recording's bytes; others are refused.
inline constexpr std::uint32_t kRecordingFormat = 17;

/// Keeps a recording in memory: world.record(record_into(bytes)). The bytes must outlive the recording.
[[nodiscard]] RecordSink record_into(std::vector<std::byte>& bytes);

/// The first difference of a replay from its recording.
struct ReplayDifference {
  std::uint64_t step = 0;  ///< the step in which it was seen, from 1; of a call between steps: the last one before [-]
  double time = 0;         ///< of the replayed world [s]
  std::string call{};      ///< the call that was made, "advance" [-]
  std::string what{};      ///< one sentence [-]
  std::uint64_t recorded_hash = 0;  ///< if hashes differ [-]
  std::uint64_t replayed_hash = 0;  ///< if hashes differ [-]
  std::uint64_t place = 0;          ///< in the recording [bytes]
};

/// The progress of a replay, and whether it agrees.
struct ReplayReport {
  std::string made_by{};       ///< version of the library that recorded [-]
  bool complete = false;       ///< the recording has its end; else it was cut [-]
  std::uint64_t bytes = 0;     ///< of the recording that are used: all, or up to where it was cut [bytes]
  std::uint64_t calls = 0;     ///< made [-]
  std::uint64_t steps = 0;     ///< taken, also those that restore() took back [-]
  std::uint64_t hashes = 0;    ///< compared, and equal [-]
  std::uint64_t restores = 0;  ///< made [-]
  std::uint64_t spawned = 0;   ///< projectiles handed out [-]
  std::optional<ReplayDifference> difference{};  ///< the first; the replay stops there [-]
};

/// Functions are those of the save that the recording begins with, or those of WorldDef::environment, then those that
/// came while it was recorded: of each call that sets an environment again. What a HitFunction said is recorded.
using ReplayOptions = LoadOptions;

/// A recording played call by call, for callers that look at the world in between.
class Replay {
 public:
  /// Checks all of the recording before anything is played. One that was cut, as by a crash, is played as far as it
  /// goes; one that is damaged, of another format, or lacks functions is refused. Errors name the byte.
  [[nodiscard]] static Result<Replay> open(std::vector<std::byte> recording, const ReplayOptions& options = {});
  Replay(Replay&&) noexcept;
  Replay& operator=(Replay&&) noexcept;
  ~Replay();

  /// Makes the next call; false at the end, and at the first difference.
  bool next();
  /// Makes calls up to and with the next one that took steps; false if there is no such call.
  bool next_frame();
  /// Goes to where ReplayReport::steps is `steps`, back or forwards: behind the call that took that step; 0: to the
  /// beginning. The report and the world are those of a replay that was played up to there. False if the recording ends
  /// or differs before. Keeps saves of worlds on its way, up to 64 MB, so that going back is short; a recording with
  /// snapshots or functions is played again from its beginning.
  bool seek(std::uint64_t steps);
  [[nodiscard]] const World& world() const;
  [[nodiscard]] const ReplayReport& report() const;
  /// The hash after every step of the last call, as far as the recording has them.
  [[nodiscard]] std::span<const std::uint64_t> hashes() const;

 private:
  struct Impl;
  explicit Replay(std::unique_ptr<Impl> impl);
  std::unique_ptr<Impl> impl_;
};

/// Plays all of a recording.
[[nodiscard]] Result<ReplayReport> replay(std::span<const std::byte> recording, const ReplayOptions& options = {});

}  // namespace physim
