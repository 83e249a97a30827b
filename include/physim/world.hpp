// World: many projectiles in real time, stepped by frame. Each is on its own rung; all are named by ids.
#pragma once

#include <cstddef>
#include <functional>
#include <memory>
#include <span>
#include <string>
#include <vector>

#include "physim/accelerations.hpp"
#include "physim/departure.hpp"
#include "physim/emitter.hpp"
#include "physim/flight.hpp"
#include "physim/forces.hpp"
#include "physim/hit_question.hpp"
#include "physim/joint.hpp"
#include "physim/result.hpp"
#include "physim/scene.hpp"
#include "physim/task_runner.hpp"
#include "physim/world_columns.hpp"
#include "physim/world_def.hpp"
#include "physim/world_projectile.hpp"

namespace physim {

/// Where a projectile went in the last step: what a scene query needs.
struct Segment {
  ProjectileId id{};  ///< [-]
  Vec3d from{};       ///< [m]
  Vec3d to{};         ///< [m]
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

/// Events of calls between two steps that a world keeps: so many, or twice as many as it has projectiles.
inline constexpr std::size_t kMostEventsOfCalls = 1u << 16;

/// Takes the bytes of a recording, piece by piece: before and after each step, when 64 KiB have gathered, and in
/// World::stop_recording(), whose last piece is empty. An error ends the recording. The sink may read the world, but
/// not change it (see World). The end of its world does not call it, since what it refers to may be gone by then,
/// unless RecordOptions::complete_at_end says so.
using RecordSink = std::function<Status(std::span<const std::byte>)>;

struct RecordOptions {
  std::uint32_t hash_every = 1;  ///< steps; 0: no hashes, and a replay compares ids only [-]
  bool from_now = false;         ///< the recording begins with World::save(), and the world need not be new [-]
  bool complete_at_end = false;  ///< the end of the world completes the recording as stop_recording() does: all that
                                 ///< the sink refers to must outlive the world [-]
};

inline constexpr char kSaveMagic[8] = {'P', 'H', 'Y', 'S', 'I', 'M', 'S', '\n'};
/// The format of a save's bytes; others are refused.
inline constexpr std::uint32_t kSaveFormat = 12;

/// What a save does not hold: functions are no data. They are given again: custom forces in the order they were added;
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

  // ------------------------------------------------------------------------------------------- what there is
  /// Prepares a kind of projectile, so that each of it is spawned quickly. Definitions that are equal to the bit give
  /// the same kind. It stays as long as its world; a kind that spawn() makes of a definition is let go some time after
  /// the last projectile of it.
  Result<KindId> add_kind(const ProjectileDef& projectile, const BodyDef& body = {});
  /// Another place to fly in; its index for BodyDef::environment.
  Result<std::uint32_t> add_environment(const Environment& environment);
  /// Changes an environment from the next step on (a gust, a new day).
  Status set_environment(std::uint32_t index, const Environment& environment);

  // ------------------------------------------------------------------------------------------- coming and going
  /// A projectile of a kind. `delay` [s]: it is pending until then.
  Result<ProjectileId> spawn(KindId kind, const Launch& launch, double delay = 0);
  /// A projectile of a definition that need not be a kind yet.
  Result<ProjectileId> spawn(const ProjectileDef& projectile, const Launch& launch, const BodyDef& body = {},
                             double delay = 0);
  /// Many of one kind; ids in the order of the launches, null where one is refused. Returns how many were spawned.
  std::size_t spawn(KindId kind, std::span<const Launch> launches, std::span<ProjectileId> ids);
  /// What was on its way in a flight goes on in this world, from a time of it [s] on: place, velocity, attitude and
  /// spin, with its motor burnt so far, at the fidelity that was granted to it. An error for a flight that was refused,
  /// and on a launch rail.
  Result<ProjectileId> spawn(const Flight& flight, double time, const BodyDef& body = {});
  /// What is on its way already.
  Result<ProjectileId> spawn_departed(const ProjectileDef& projectile, const Departure& from, const BodyDef& body = {});
  /// Room for so many more, so that spawning does not allocate; an error where there is no memory for them, or where
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

  // ------------------------------------------------------------------------------------------- what comes next
  /// The flight from now on, its time 0, by steps of `step` [s] (0: WorldDef::step): attitude, spin, what its motor
  /// has burnt, its own gravity and other settings, and generators as they are now. At the end of each step it is, to
  /// the bit, where step() would bring it, as long as nothing changes it: rules that despawn, put to sleep or move it
  /// to another rung are left out, and so are joints and springs to others, which its notes tell. It meets the things
  /// of the world's scene as it will, those that move too, and tells its hits; who asks (OnHit::ask) ends at the first.
  /// It ends where it first meets `until`, such as the ground: there it does not bounce. Range and sight are level,
  /// along its velocity. Refused for one that is gone, stands still (asleep, kinematic, of infinite mass, stuck) or is
  /// pending, for events of kind `time` in `until`, and for another scene there. Costs about as much as fly().
  [[nodiscard]] Flight predict(ProjectileId id, const Until& until, double step = 0) const;
  /// ... until the ground of this world, or for a time [s].
  [[nodiscard]] Flight predict(ProjectileId id, double time, double step = 0) const;
  /// How many of them end, in their order; paths are not kept. Returns how many are not refused.
  std::size_t predict(std::span<const ProjectileId> ids, const Until& until, std::span<ShotResult> into,
                      double step = 0) const;

  // ------------------------------------------------------------------------------------------- all or many of them
  void states(std::span<const ProjectileId> ids, std::span<BodyState> into) const;
  void render_positions(std::span<const ProjectileId> ids, std::span<Vec3d> into) const;  ///< where to draw them [m]
  /// Segments of the last step, of all that moved, by cohort; `into` is cleared.
  void segments(std::vector<Segment>& into) const;
  /// All that are alive as they lie in memory, some columns for each rung; nothing is copied. `into` is cleared.
  void columns(std::vector<WorldColumns>& into) const;
  /// The projectile that is alive at an index; null where none is.
  [[nodiscard]] ProjectileId id_at(std::uint32_t index) const;
  /// Moves projectiles to another rung, as they are; returns how many.
  std::size_t set_fidelity(std::span<const ProjectileId> ids, const Fidelity& fidelity);
  Status set_detail(const DetailRule& rule);
  Status set_observer(const Vec3d& position);  ///< of DetailRule distances [m]

  // ------------------------------------------------------------------------------------------- forces
  /// A generator. Only projectiles in motion `force` feel it: felt_by() tells how many do.
  Result<ForceId> add_force(const ForceDef& force);
  Status remove_force(ForceId force);
  [[nodiscard]] bool is_active(ForceId force) const;
  [[nodiscard]] std::size_t force_count() const;
  /// Its targets of now that are in motion `force`; nobody: it acts, and nothing feels it.
  [[nodiscard]] std::size_t felt_by(ForceId force) const;

  // ------------------------------------------------------------------------------------------- joints
  /// From now on it holds its ends, whatever they fly by, on their centres. An end that is kinematic, pending, stuck or
  /// of infinite mass stands still. It ends when a projectile that it holds leaves the world. Ends that are not as far
  /// apart as a rod or a taut cable lets them be come there in the next step, without a speed.
  /// Refused where both ends are one, where an end is gone or held by 64 joints, and where a number makes no sense.
  Result<JointId> add_joint(const Joint& joint);
  /// Who it held is free; who slept wakes.
  Status remove_joint(JointId joint);
  [[nodiscard]] std::vector<JointId> joints() const;          ///< of all there are, by index
  [[nodiscard]] const Joint* joint(JointId joint) const;      ///< with its length; null: it is gone
  [[nodiscard]] JointState joint_state(JointId joint) const;  ///< zeros: it is gone
  /// What became of joints in the last step() or advance(), and by calls since, as events() of projectiles.
  [[nodiscard]] std::vector<JointEvent> joint_events() const;
  [[nodiscard]] JointCounts joint_counts() const;

  // ------------------------------------------------------------------------------------------- scene
  /// What projectiles meet from now on, as BodyDef::on_hit says: a copy of this scene, whose ids it keeps, and the
  /// engine that answers beside it. Who sleeps wakes.
  Status set_scene(const Scene& scene);
  /// They meet nothing any more.
  Status remove_scene();
  /// What there is; null: no scene. It stays until the next call that changes it.
  [[nodiscard]] const Scene* scene() const;
  // Changes of the scene that cost what they change, as Scene has them; refused where there is none.
  Result<ShapeId> add_shape(const ShapeDef& shape);
  Status remove_shape(ShapeId shape);
  Result<MaterialId> add_material(const Material& material);
  Result<InstanceId> add_instance(const InstanceDef& instance);
  Status remove_instance(InstanceId instance);
  Status move_instance(InstanceId instance, const Transform& to);
  /// Times of motions are those of the world.
  Status set_instance_motion(InstanceId instance, const SceneMotion& motion);
  Status set_instance_layers(InstanceId instance, std::uint32_t layers);
  /// Who answers what hits of kinds with OnHit::ask do: called in the thread that steps, with all hits that a step has
  /// so far, then with those that follow in the rest of it. What is born or dies inside of the step, and what met
  /// another projectile in it, asks by itself. It may read the world, which then stands where the step began, but not
  /// change it. An answer decides and promises nothing, since another projectile may be met before: events tell what
  /// happened. One that makes no sense, and all of a call that throws, count as OnHit::stop; hit_counts() tells.
  /// Refused where it is empty while there are kinds that ask; without it such kinds are refused.
  Status set_hit_function(HitFunction function);
  [[nodiscard]] HitCounts hit_counts() const;
  /// What was wrong with the last answer that was refused; empty: none was.
  [[nodiscard]] std::string refused_answer() const;

  // ------------------------------------------------------------------------------------------- emitters
  /// From now on it fires, at moments of its own inside of steps. What is born flies the rest of that step; who is
  /// born, when, where and how fast follows from the definition alone, however long steps are.
  Result<EmitterId> add_emitter(const EmitterDef& def);
  /// What it fired stays, and is nobody's from then on.
  Status remove_emitter(EmitterId emitter);
  /// It begins anew, with the delay before its first cycle; particles are numbered on.
  Status play_emitter(EmitterId emitter);
  /// It fires no more by itself.
  Status stop_emitter(EmitterId emitter);
  /// In the course of the next step it goes straight to that place, and turns; later it stays there. Its scale does not
  /// count. Refused for one that follows a projectile or has a motion.
  Status move_emitter(EmitterId emitter, const Transform& to);
  /// It goes straight to that place, and turns, at steady rates, and is there by that time of the world [s]; then it
  /// stays. Further calls add legs that begin where and when the last one ends, so that a polyline is told a leg or
  /// more ahead; the first leg begins where it is now. Unlike that of move_emitter() this way does not depend on steps:
  /// what is born on it is equal to the bit at any frame rate. A leg takes 1e-6 s or more, up to time 1e9 s and at up
  /// to 1e9 m/s. move_emitter() and jump_emitter() end the way where it is then. Refused as move_emitter() is.
  Status lead_emitter(EmitterId emitter, const Transform& to, double time);
  /// It stands there from now on, without a way to it: nothing is born by distance, and rain fills its box anew where
  /// it was not before. Refused as move_emitter() is.
  Status jump_emitter(EmitterId emitter, const Transform& to);
  /// As if it had begun to play so long ago, 0 to 1e9 s: its particles go, and those are there that would be, as
  /// EmitterCycle::prewarm has them; numbers and what is drawn are those of the play at hand, so that it is what
  /// waiting so long would have given. Rain begins now.
  Status seek_emitter(EmitterId emitter, double time);
  /// It fires so many now, beside what it does by itself, up to 1e6; how many were born.
  Result<std::size_t> emit(EmitterId emitter, std::uint32_t count);
  /// Its sub-emitters that wait for SubEvent::trigger fire now, at each of its particles.
  Status trigger_emitter(EmitterId emitter);
  [[nodiscard]] std::vector<EmitterId> emitters() const;                ///< of all there are, by index
  [[nodiscard]] const EmitterDef* emitter(EmitterId emitter) const;     ///< null: it is gone
  [[nodiscard]] bool is_playing(EmitterId emitter) const;               ///< it may fire by itself
  [[nodiscard]] EmitterCounts emitter_counts(EmitterId emitter) const;  ///< zeros: it is gone
  /// Its particles, by the index of their ids or from far to near; returns how many there are. Columns that are shorter
  /// get the first ones.
  std::size_t particles(EmitterId emitter, const ParticleColumns& into) const;
  /// Where its particles have been (TrailDef), in their order; returns how many there are.
  TrailCounts trails(EmitterId emitter, const TrailColumns& into) const;

  // ------------------------------------------------------------------------------------------- time
  /// One step of dt [s], now; 1e-9 at least and below 1e6. Fastest where dt stays the same. Integrators with fixed
  /// steps take it as their step, whatever its error; where the ground bounces, steps of more than 0.1 s are flown in
  /// parts.
  Status step(double dt);
  /// Real time has passed: takes as many steps of WorldDef::step as fit; returns how many. None while paused, nor of
  /// time that is no number, runs backwards or is 1e9 s or more.
  int advance(double real_dt);
  void set_paused(bool paused);
  [[nodiscard]] bool is_paused() const;
  /// One fixed step, paused or not.
  void single_step();
  Status set_time_scale(double scale);
  [[nodiscard]] double time_scale() const;
  [[nodiscard]] double time() const;      ///< of the simulation [s]
  [[nodiscard]] double fraction() const;  ///< of a step that advance() has left over, 0..1 [-]

  /// What happened in the last step() or advance(), in order of time, then of id, and then what calls did since. What
  /// was given stays as it is until the next step(), advance(), single_step() or forget_events(), whatever is changed:
  /// spawning and despawning in a loop over it is fine, and their events are seen by who asks again. Of calls between
  /// two steps kMostEventsOfCalls or more are kept; counters() tells how many were dropped.
  [[nodiscard]] std::span<const Event> events() const;
  void forget_events();  ///< events() is empty then
  [[nodiscard]] const WorldCounters& counters() const;
  [[nodiscard]] std::vector<CohortInfo> cohorts() const;
  /// What grows with use: projectiles, kinds, rungs and cohorts, tables, forces, events. Snapshots have their
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
  /// All of this world as bytes: load() makes of them a world that goes on with the same hash and ids, on any machine.
  /// Snapshots, events and threads are not in it; functions of your own are handed in again. An error inside a step.
  [[nodiscard]] Result<std::vector<std::byte>> save() const;
  /// The world of a save. Bytes that are damaged, cut, of another format, or that lack functions are refused.
  [[nodiscard]] static Result<World> load(std::span<const std::byte> save, const LoadOptions& options = {});

  // ------------------------------------------------------------------------------------------- recordings
  /// Every call that changes this world goes to `sink` from now on, until stop_recording(); Replay makes them again. A
  /// world that ends before leaves a recording of all up to its last step, without its end. For a world to which
  /// nothing was done yet, or from a save on (RecordOptions::from_now). Where the sink fails the world goes on without.
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

}  // namespace physim
