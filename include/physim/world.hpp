// World: many projectiles in real time, stepped by frame. Each is on its own rung; all are named by ids.
#pragma once

#include <cstddef>
#include <functional>
#include <memory>
#include <span>
#include <string>
#include <vector>

#include "physim/accelerations.hpp"
#include "physim/forces.hpp"
#include "physim/result.hpp"
#include "physim/task_runner.hpp"
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
};

/// Projectiles of one rung that are computed together.
struct CohortInfo {
  Fidelity fidelity{};      ///< granted [-]
  std::uint32_t count = 0;  ///< projectiles [-]
  bool moving = true;       ///< false: asleep, kinematic, pending [-]
  bool forced = false;      ///< generators act on it [-]
};

/// Takes the bytes of a recording, piece by piece; an empty piece after the last. An error ends the recording.
using RecordSink = std::function<Status(std::span<const std::byte>)>;

struct RecordOptions {
  std::uint32_t hash_every = 1;  ///< steps; 0: no hashes, and a replay compares ids only [-]
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

/// Many projectiles in real time. Nothing throws; what cannot be done is refused, with a reason. Not to be used from
/// two threads at once.
class World {
 public:
  World();  ///< with WorldDef{}
  /// An error where the definition makes no sense.
  [[nodiscard]] static Result<World> create(const WorldDef& def);
  World(World&&) noexcept;
  World& operator=(World&&) noexcept;
  ~World();

  // ------------------------------------------------------------------------------------------- what there is
  /// Prepares a kind of projectile, so that each of it is spawned quickly. Definitions that are
  /// equal to the bit give the same kind.
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
  /// Room for so many more, so that spawning does not allocate.
  Status reserve(KindId kind, std::size_t count);
  /// Takes many out; returns how many were there.
  std::size_t despawn(std::span<const ProjectileId> ids);
  void clear();  ///< despawns all

  [[nodiscard]] std::size_t size() const;               ///< alive
  [[nodiscard]] std::vector<ProjectileId> ids() const;  ///< of all alive, by index

  // ------------------------------------------------------------------------------------------- one of them
  /// To read and change one: `world[id].position()`, `world[id].set_fidelity(...)`.
  [[nodiscard]] Projectile operator[](ProjectileId id) { return {impl_.get(), id}; }
  [[nodiscard]] ProjectileView operator[](ProjectileId id) const { return {impl_.get(), id}; }

  // ------------------------------------------------------------------------------------------- all or many of them
  void states(std::span<const ProjectileId> ids, std::span<BodyState> into) const;
  /// Segments of the last step, of all that moved, by cohort; `into` is cleared.
  void segments(std::vector<Segment>& into) const;
  /// Moves projectiles to another rung, as they are; returns how many.
  std::size_t set_fidelity(std::span<const ProjectileId> ids, const Fidelity& fidelity);
  Status set_detail(const DetailRule& rule);
  Status set_observer(const Vec3d& position);  ///< of DetailRule distances [m]

  // ------------------------------------------------------------------------------------------- forces
  /// A generator. Only projectiles in motion `force` feel it.
  Result<ForceId> add_force(const ForceDef& force);
  Status remove_force(ForceId force);
  [[nodiscard]] bool is_active(ForceId force) const;
  [[nodiscard]] std::size_t force_count() const;

  // ------------------------------------------------------------------------------------------- time
  /// One step of dt [s], now. Fastest where dt stays the same.
  Status step(double dt);
  /// Real time has passed: takes as many steps of WorldDef::step as fit; returns how many. None while paused, nor of
  /// time that is no number or runs backwards.
  int advance(double real_dt);
  void set_paused(bool paused);
  [[nodiscard]] bool is_paused() const;
  /// One fixed step, paused or not.
  void single_step();
  Status set_time_scale(double scale);
  [[nodiscard]] double time_scale() const;
  [[nodiscard]] double time() const;      ///< of the simulation [s]
  [[nodiscard]] double fraction() const;  ///< of a step that advance() has left over, 0..1 [-]

  /// What happened in the last step() or advance(), and in calls since, in order of time, then of id.
  [[nodiscard]] std::span<const Event> events() const;
  [[nodiscard]] const WorldCounters& counters() const;
  [[nodiscard]] std::vector<CohortInfo> cohorts() const;
  [[nodiscard]] std::size_t memory() const;  ///< of all projectiles [bytes]

  // ------------------------------------------------------------------------------------------- moments
  [[nodiscard]] Snapshot snapshot() const;
  /// Back to a moment of this world, bit for bit; an error for a snapshot of another world.
  Status restore(const Snapshot& snapshot);
  /// A hash of all that decides what happens next, and of what is carried along; not of what is only shown, nor of how
  /// the world came here. The same on every machine, with any kernel and number of threads. Costs about 15 ns per
  /// projectile.
  [[nodiscard]] std::uint64_t hash() const;

  // ------------------------------------------------------------------------------------------- recordings
  /// Every call that changes this world goes to `sink` from now on, until stop_recording() or its end; Replay makes
  /// them again. Only for a world to which nothing was done yet. Where the sink fails the world goes on without.
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
  friend class Recorder;
  std::unique_ptr<WorldImpl> impl_;
};

}  // namespace physim
