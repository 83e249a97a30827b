// A scenario flown: its scene, the hits of its flights, and its world run step by step.
#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "physim/math.hpp"
#include "physim/world.hpp"
#include "scenario/scenario.hpp"

namespace physim {

// ---------------------------------------------------------------------------------------------------------------------
// SceneParts: the scene of a scenario, and by which ids it knows the scenario's parts.

/// The scene of a scenario and the ids of its parts.
struct SceneParts {
  Scene scene{};                        ///< as scene_of() makes it [-]
  std::vector<MaterialId> materials{};  ///< of Scenario::materials, in their order [-]
  std::vector<InstanceId> things{};     ///< of Scenario::things, in their order [-]
};

/// An error names the shape, material or thing that is wrong.
[[nodiscard]] Result<SceneParts> scene_parts(const Scenario& scenario);

// ---------------------------------------------------------------------------------------------------------------------
// WorldRun: a scenario with a [world], run step by step.

/// Many numbers in short.
struct Series {
  std::uint64_t count = 0;   ///< [-]
  double mean = 0;           ///< [unit of the numbers]
  double low = kInfinity;    ///< [unit of the numbers]
  double high = -kInfinity;  ///< [unit of the numbers]
  double squares = 0;        ///< of the distances from the mean, summed [unit squared]

  void add(double value);
  /// The standard deviation of the numbers themselves (divided by their count).
  [[nodiscard]] double spread() const;
};

/// Hits of one group, on one thing or on all.
struct ThingHits {
  std::string thing{};             ///< its name; empty: all things [-]
  std::uint64_t count = 0;         ///< [-]
  std::uint64_t bounces = 0;       ///< ... that threw it back [-]
  std::uint64_t ricochets = 0;     ///< ... that threw it off, as it came in flat [-]
  std::uint64_t penetrations = 0;  ///< ... that let it through [-]
  std::uint64_t stops = 0;         ///< ... that it stayed in or at, or ended at [-]
  Series time{};                   ///< of the world [s]
  Series x{}, y{}, z{};            ///< [m]
  Series speed{}, speed_after{};   ///< as seen from the surface [m/s]
  Series obliquity{};              ///< [rad]
  Series depth{};                  ///< of what went in [m]
};

/// How often something went into what is passed: into sensors, and into things with a projectile's on_hit "pass".
struct Passages {
  std::uint64_t count = 0;                                        ///< [-]
  std::vector<std::pair<std::string, std::uint64_t>> by_thing{};  ///< ... by the name of the thing [-]

  /// Those of a thing; of all where the name is empty.
  [[nodiscard]] std::uint64_t of(std::string_view thing) const;
};

/// The fate of all that one [[volley]] or [[emitter]] fired, or of one [[shot]] that was fired alone.
struct WorldGroup {
  std::string name{};         ///< of the volley, emitter or shot [-]
  std::size_t shot = 0;       ///< index in Scenario::shots; of an emitter that of its kind, not of its tracers [-]
  KindId kind{};              ///< in the world [-]
  std::uint64_t spawned = 0;  ///< launched [-]
  std::uint64_t refused = 0;  ///< not launched: a full pool, emitter or world [-]
  std::string refusal{};      ///< why the first of these was not [-]
  std::uint64_t landed = 0;   ///< ended on the ground [-]
  std::uint64_t bounces = 0;  ///< off the ground, of all together [-]
  std::uint64_t slept = 0;    ///< times that one came to rest [-]
  std::uint64_t expired = 0;  ///< left by their rules [-]
  std::uint64_t retired = 0;  ///< taken out [-]
  std::uint64_t hits = 0;     ///< on the wall, on things of the scene and on others [-]
  std::uint64_t alive = 0;    ///< at the end [-]
  Series range{};             ///< horizontal distance to the impact: first touch of the ground, wall or a thing [m]
  Series time{};              ///< from launch to impact [s]
  Series speed{};             ///< at impact [m/s]
  Series apex{};              ///< height of the highest points, if the world reports them [m]
  Series hit_y{}, hit_z{};    ///< on the wall [m]
  ThingHits on_things{};      ///< all hits on things of the scene [-]
  std::vector<ThingHits> by_thing{};  ///< those of each thing that was hit, in the order of the first [-]
  Vec3d position{};                   ///< mean of those alive at the end [m]
  Vec3d velocity{};                   ///< mean of those alive at the end [m/s]
  double mean_speed = 0;              ///< mean speed of those alive at the end [m/s]
  EmitterId emitter{};                ///< in the world; none: it is a volley or shot [-]
  EmitterCounts counts{};             ///< of the emitter: emitted, refused, landed, expired ones [-]
};

/// Which launch a projectile was.
struct Launched {
  std::size_t group = 0;     ///< index in WorldRun::groups() [-]
  std::uint64_t number = 0;  ///< of its launch in the run, from 1 [-]
};

/// An event of one of the run's projectiles.
struct RunEvent {
  Launched launched{};  ///< [-]
  Event event{};        ///< [-]
};

/// Where a projectile met the wall.
struct WallHit {
  Launched launched{};  ///< [-]
  ProjectileId id{};    ///< [-]
  double time = 0;      ///< of the world [s]
  Vec3d position{};     ///< [m]
  Vec3d velocity{};     ///< [m/s]
};

/// What a projectile did with a thing of the scene: it hit it, or went through what it passes. A lasting contact,
/// of what slides, rolls or rests on a thing, is no hit.
struct ThingHit {
  static constexpr std::size_t kNone = ~std::size_t{0};

  Launched launched{};           ///< [-]
  ProjectileId id{};             ///< [-]
  double time = 0;               ///< of the world [s]
  Vec3d position{};              ///< [m]
  Vec3d velocity{};              ///< before, in W [m/s]
  Vec3d velocity_after{};        ///< in W [m/s]
  Vec3d surface_velocity{};      ///< of the surface, where it was touched, in W [m/s]
  double obliquity = 0;          ///< between its way, as seen from the surface, and the normal [rad]
  InstanceId instance{};         ///< in the scene of the world [-]
  std::uint32_t primitive = 0;   ///< of it, as SceneHit::primitive [-]
  std::size_t thing = kNone;     ///< index in Scenario::things [-]
  std::size_t material = kNone;  ///< index in Scenario::materials; kNone: that of every scene [-]
  /// bounced, ricocheted, penetrated or stopped; entered, left or sensed for what is passed.
  EventKind outcome = EventKind::hit;  ///< [-]
  double depth = 0;                    ///< how far it went in [m]
  double energy = 0;                   ///< that it lost by what the material did to it [J]

  /// As seen from the surface, which is what materials go by [m/s].
  [[nodiscard]] double speed() const;
  /// As speed(), after the hit; 0 for what it stayed in or at [m/s].
  [[nodiscard]] double speed_after() const;
};

struct RunState;

/// A frozen moment of a run: of its world, of what is still to be fired and of all that was counted.
class RunSnapshot {
 public:
  RunSnapshot() = default;
  [[nodiscard]] double time() const { return world_.time(); }  ///< of the world [s]
  explicit operator bool() const { return state_ != nullptr; }

 private:
  friend class WorldRun;
  Snapshot world_;
  std::shared_ptr<const RunState> state_;
};

/// Fires the shots and volleys of a scenario, takes its steps and keeps count.
class WorldRun {
 public:
  /// An error where the scenario has no [world], or where the world refuses part of it. With a path the run is recorded
  /// into that file (record_to_file()), which must be none of Scenario::files.
  [[nodiscard]] static Result<WorldRun> create(Scenario scenario, const std::string& recording = "");
  WorldRun(WorldRun&&) noexcept;
  WorldRun& operator=(WorldRun&&) noexcept;
  ~WorldRun();

  /// Fires what is due and takes one step. The last step within the scenario's duration ends with that.
  void step();
  /// Steps within the scenario's duration.
  [[nodiscard]] std::uint64_t steps() const;

  [[nodiscard]] World& world();
  [[nodiscard]] const World& world() const;
  [[nodiscard]] const Scenario& scenario() const;
  /// The ids of Scenario::things in the scene of the world, in their order.
  [[nodiscard]] std::span<const InstanceId> things() const;
  /// The ids of Scenario::joints in the world, in their order: by index.
  [[nodiscard]] std::span<const JointId> joints() const;
  /// What happened in the last step, launches included.
  [[nodiscard]] std::span<const RunEvent> events() const;
  [[nodiscard]] std::span<const WallHit> hits() const;  ///< of the last step
  /// What happened with things of the scene in the last step.
  [[nodiscard]] std::span<const ThingHit> thing_hits() const;
  /// Counted up to now; the standing state is the current one.
  [[nodiscard]] std::vector<WorldGroup> groups() const;
  /// Which launch a projectile was; none for a stranger.
  [[nodiscard]] std::optional<Launched> launched(ProjectileId id) const;

  /// All of this run as bytes: of its world (World::save()), of what is still to be fired and of all that was counted.
  [[nodiscard]] Result<std::vector<std::byte>> save() const;
  /// Continues a run of the same scenario; refused if the save is of another one, or damaged.
  [[nodiscard]] static Result<WorldRun> load(Scenario scenario, std::span<const std::byte> save,
                                             const std::string& recording = "");

  [[nodiscard]] RunSnapshot snapshot() const;
  /// Back to a moment of this run, bit for bit; false for a snapshot of another run.
  bool restore(const RunSnapshot& snapshot);

 private:
  struct Impl;
  explicit WorldRun(std::unique_ptr<Impl> impl);
  std::unique_ptr<Impl> impl_;
};

/// The value of an expectation on a group at the end of a run [SI unit of the quantity], or why it has no value.
[[nodiscard]] Result<double> measure(const WorldGroup& group, const Expectation& expectation);
/// ... of a group with the passages of its projectiles.
[[nodiscard]] Result<double> measure(const WorldGroup& group, const Passages& passages, const Expectation& expectation);

// ---------------------------------------------------------------------------------------------------------------------
// FlightHits: what the flight of a scenario's shot did with the scenario's things.

/// Hits of one flight. A lasting contact, of what slides, rolls or rests on a thing, is no hit.
struct FlightHits {
  /// In order of time, with what is passed or left; ThingHit::time is since launch, Launched::group the index of the
  /// shot in Scenario::shots, 0 if it is not one of them, Launched::number 1, and there is no ThingHit::id [-]
  std::vector<ThingHit> all{};
  ThingHits on_things{};              ///< those that hit something [-]
  std::vector<ThingHits> by_thing{};  ///< ... of each thing, in the order of its first [-]
  Passages passages{};                ///< of those that hit nothing [-]
};

/// Puts the events of a flight together to hits: of a shot of a scenario that flew through the scenario's scene, as
/// fly_shot() flies it.
[[nodiscard]] FlightHits flight_hits(const Scenario& scenario, const ScenarioShot& shot, const Flight& flight,
                                     const SceneParts& parts);

/// Says which shots begin inside of solid things of the scenario's scene, such as: shot "b" begins inside of the thing
/// "t". Left out are rounds of emitters, sensors, and things of layers that a shot does not meet. `things`: as
/// SceneParts::things.
[[nodiscard]] std::vector<std::string> notes_of_beginnings(const Scenario& scenario, const Scene& scene,
                                                           std::span<const InstanceId> things);

/// The value of an expectation on a flown shot and its hits [SI unit of the quantity], or why it has none: figures of
/// hits ("hits", "hit_depth", ...) on Expectation::thing, or on all things; all others as measure() of the flight.
[[nodiscard]] Result<double> measure(const Flight& flight, const FlightHits& hits, const Expectation& expectation);

}  // namespace physim
