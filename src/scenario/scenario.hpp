// Scenario: all that a scenario file says, as it was read.
#pragma once

#include <cstddef>
#include <cstdint>
#include <map>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <variant>
#include <vector>

#include "physim/body.hpp"
#include "physim/emitter.hpp"
#include "physim/environment.hpp"
#include "physim/flight.hpp"
#include "physim/math.hpp"
#include "physim/projectile.hpp"
#include "physim/result.hpp"
#include "physim/scenario.hpp"
#include "physim/scene.hpp"
#include "physim/solve.hpp"
#include "physim/study.hpp"
#include "physim/units.hpp"
#include "physim/world.hpp"

namespace physim {

// ---------------------------------------------------------------------------------------------------------------------
// How a scenario says where things and emitters are, how they are turned and how they move.

/// How something is turned: about an axis, or by yaw, pitch and roll (quat_from_yaw_pitch_roll()), not by both.
struct ScenarioRotation {
  Vec3d axis{0, 1, 0};  ///< of any length but zero [-]
  double angle = 0;     ///< about the axis, right-handed [rad]
  double yaw = 0;       ///< of its x axis, to the right, first [rad]
  double pitch = 0;     ///< of its x axis, up, second [rad]
  double roll = 0;      ///< about its x axis, right side down, third [rad]

  /// From its own frame to W.
  [[nodiscard]] Quatd quaternion() const;
};

/// Where something is at a time.
struct ScenarioKey {
  double time = 0;              ///< of the world [s]
  Vec3d position{};             ///< [m]
  ScenarioRotation rotation{};  ///< [-]
  Vec3d velocity{};             ///< for MotionCurve::smooth [m/s]
};

/// How something moves: steadily, or from key to key. It rests where nothing is said.
struct ScenarioMotion {
  double start = 0;                           ///< at which a steady motion has it at its position [s]
  Vec3d velocity{};                           ///< steady [m/s]
  Vec3d angular_velocity{};                   ///< steady, in W [rad/s]
  std::vector<ScenarioKey> keys{};            ///< instead of a position and steady motion [-]
  MotionCurve curve = MotionCurve::straight;  ///< from key to key [-]
};

// ---------------------------------------------------------------------------------------------------------------------
// What a scenario says of its scene: shapes, and things that have them.

struct Scenario;

/// One of the shapes that a compound has.
struct ScenarioPart {
  std::string shape{};          ///< name of another [[shape]], no plane and no compound; it may come later [-]
  std::string material{};       ///< name of its material; empty: that of the thing [-]
  Vec3d position{};             ///< of its origin in the compound's frame [m]
  ScenarioRotation rotation{};  ///< from its own frame to the compound's [-]
  double scale = 1;             ///< along all axes, 1e-9 to 1e9 [-]
};

/// One [[shape]].
struct ScenarioShape {
  std::string name{};                    ///< [-]
  std::string file{};                    ///< that its mesh or heights were read from, as the scenario says it [-]
  double low = 0;                        ///< height of black in a file of heights [m]
  double high = 1;                       ///< height of white in a file of heights [m]
  std::string terrain{};                 ///< a file of terrain that its mesh was read from, as the scenario says it [-]
  TerrainCut cut{};                      ///< what of that, about the place of the environment [-]
  std::uint32_t impossible = 0;          ///< points of the terrain whose height no ground has [-]
  double impossible_height = 0;          ///< the first such height [m]
  double reached = kInfinity;            ///< how far the terrain goes on all sides, if less than TerrainCut::reach [m]
  std::vector<ScenarioPart> parts{};     ///< of a compound [-]
  std::vector<std::string> materials{};  ///< names, of each triangle of a mesh or one of all; empty: of the thing [-]
  ShapeDef shape = CompoundShape{};      ///< `parts` names a compound's parts; without parts it is no shape yet [-]

  /// Whether it is made of other shapes.
  [[nodiscard]] bool is_compound() const { return std::holds_alternative<CompoundShape>(shape) && !parts.empty(); }
};

/// One [[thing]] of the scene. It rests where nothing is said about its motion.
struct ScenarioThing {
  std::string name{};                         ///< in tables [-]
  std::string shape{};                        ///< name of its shape [-]
  std::string material{};                     ///< name of its material; empty: that of every scene [-]
  Vec3d position{};                           ///< [m]
  ScenarioRotation rotation{};                ///< [-]
  double scale = 1;                           ///< along all axes [-]
  std::uint32_t layers = 1;                   ///< bits [-]
  bool sensor = false;                        ///< contacts are reported, and passed through [-]
  double start = 0;                           ///< at which a steady motion has it at its position [s]
  Vec3d velocity{};                           ///< steady [m/s]
  Vec3d angular_velocity{};                   ///< steady, in W [rad/s]
  std::vector<ScenarioKey> keys{};            ///< instead of a steady motion [-]
  MotionCurve curve = MotionCurve::straight;  ///< from key to key [-]
  ConveyorDef conveyor{};                     ///< that its surface is [-]
  PassageDef passage{};                       ///< what it lets through [-]
};

/// Triangles of its mesh that are left out, as they have no area [-].
[[nodiscard]] std::size_t degenerate_triangles(const ScenarioShape& shape);

/// The scene of a scenario, its things in their order, each with its index as InstanceDef::user_data. An error names
/// the shape, material or thing that is wrong.
[[nodiscard]] Result<Scene> scene_of(const Scenario& scenario);

// ---------------------------------------------------------------------------------------------------------------------
// The [study] of a scenario: which of its numbers are uncertain, and what is asked of many shots.

struct Scenario;
struct ScenarioShot;

/// Where a setting is given: in a file, or in an option.
struct GivenSetting {
  std::string path{};   ///< "shot.NAME.mass"; of a text of a study "inputs[1]", "rounds" [-]
  std::string place{};  ///< "file:line:column", "--vary", or the override [-]
};

/// The [study] of a scenario, as written.
struct ScenarioStudy {
  std::vector<std::string> inputs{};      ///< "shot.speed = 800 m/s +- 3 m/s"; see parse_study_input() [-]
  std::vector<std::string> correlated{};  ///< "shot.speed with shot.mass = 0.5" [-]
  std::vector<std::string> targets{};  ///< "plate: rectangle 30 cm x 50 cm at 0 m, 1 m"; see parse_study_target() [-]
  std::vector<std::string> quantities{};  ///< "y", "time": StudyQuantity; empty: those of Study [-]
  std::vector<std::string> at{};          ///< "800 m", "apex: y, time"; see parse_study_place() [-]
  std::string aim{};                      ///< on the plane of impact, "0 m, 1 m"; empty: its origin [m]
  Sampling sampling = Sampling::random;   ///< [-]
  std::int64_t shots = 100'000;           ///< [-]
  std::optional<double> until_time{};     ///< fly for this time, however many shots that makes [s]
  std::int64_t seed = 1;                  ///< [-]
  std::int64_t rounds = 1;                ///< of an occasion [-]
  bool indices = false;                   ///< Sobol indices [-]
  std::int64_t over_inputs = 0;           ///< parts of each input over which hits are reported; 0: not reported [-]
  std::int64_t histograms = 0;            ///< bars of histograms; 0: not reported [-]
  std::vector<GivenSetting> places{};     ///< of those that are given [-]
  bool is_complete = true;                ///< options add nothing: it is checked with the file [-]
};

/// An error of the study of a shot in the place of the text that it is about; as it was where it is about none. What is
/// called "study.inputs[1]" is the text of that number; "inputs[1]" is an input that the study of the shot has.
[[nodiscard]] Error in_study(const Scenario& scenario, const ScenarioShot& shot, Error error);

/// "study.rounds" of what an error about a study calls "rounds"; as it was where it is no setting of a study.
[[nodiscard]] std::string setting_of_study(const std::string& place);

/// A number and its distribution from a text, PATH = DISTRIBUTION:
///   800 m/s +- 3 m/s                     normal
///   +- 3 m/s                             normal, added to what the scenario has
///   800 m/s +- 3 m/s within 790 m/s .. 805 m/s     normal, cut off; one end may be left out
///   -2 m/s .. 2 m/s                      uniform
///   -2 m/s .. 2 m/s peak 1 m/s           triangular
///   lognormal 2 m/s +- 0.5 m/s
///   one of 1 m/s, 2 m/s, 5 m/s, or of measurements in a CSV file: column speed of speeds.csv
/// "added" before it adds it to what the scenario has, "per occasion" behind it draws it once for each occasion.
[[nodiscard]] Result<StudyInput> parse_study_input(std::string_view text);
/// A target from a text, with a name and a place or without: "NAME: circle 10 cm at 0 m, 1 m" (its radius),
/// "rectangle 30 cm x 50 cm", "polygon 0 m, 0 m; 1 m, 0 m; 0 m, 1 m", "thing THE-NAME-OF-A-THING".
[[nodiscard]] Result<StudyTarget> parse_study_target(std::string_view text);
/// A place on the way from a text: "800 m" (of range), "apex", "height 100 m falling", "time 2 s", "speed 340 m/s",
/// "mach 1", "ground", "burnout", "ignition", "rail_exit"; behind a colon the quantities there: "apex: y, time".
[[nodiscard]] Result<StudyPlace> parse_study_place(std::string_view text);
/// The text of a place's event, which parse_study_place() reads.
[[nodiscard]] std::string place_text(const EventSpec& event);
/// The study of a shot of a scenario, at the shot's own fidelity. Without a [world] its shots meet the scenario's
/// things as fly_shot() does; things that have names are targets, too, unless their names are more than 32.
[[nodiscard]] Result<Study> study_of(const Scenario& scenario, const ScenarioShot& shot);

// ---------------------------------------------------------------------------------------------------------------------
// What a scenario with a [world] says beside its shots: the world, volleys, forces, joints and emitters.
//

/// The [world] of a scenario.
struct ScenarioWorld {
  bool given = false;            ///< the file has a [world]: its shots fly there instead of one by one [-]
  WorldDef def{};                ///< its environment and tolerance are those of the scenario [-]
  double duration = 10;          ///< of the run [s]
  std::optional<double> wall{};  ///< distance downrange of a wall that stops what reaches it; none: no wall [m]
  Vec3d observer{};              ///< of WorldDef::detail distances [m]
};

/// How the numbers of a spread are meant.
enum class SpreadShape {
  normal,   ///< they are standard deviations
  uniform,  ///< they are bounds, reached evenly (angles: within the ellipse)
};

/// How the launches of a volley scatter.
struct Spread {
  SpreadShape shape = SpreadShape::normal;  ///< [-]
  double horizontal = 0;                    ///< of the direction, to both sides [rad]
  double vertical = 0;                      ///< of the direction, up and down [rad]
  double speed = 0;                         ///< [m/s]
  Vec3d position{};                         ///< of the muzzle, by axis [m]

  bool operator==(const Spread&) const = default;
};

/// One [[volley]]: a shot fired many times.
struct Volley {
  std::string name{};      ///< in tables [-]
  std::string shot{};      ///< name of the shot [-]
  std::int64_t count = 1;  ///< launches [-]
  double interval = 0;     ///< between them; 0: all at once [s]
  double start = 0;        ///< of the first [s]
  Spread spread{};         ///< [-]
  std::int64_t seed = 1;   ///< of the spread; equal seeds scatter equally [-]
};

/// One [[force]]: a law, and what it acts on. Neither shots nor layers: everything.
struct ScenarioForce {
  std::string name{};                ///< in messages [-]
  std::vector<std::string> shots{};  ///< names of shots [-]
  std::uint32_t layers = 0;          ///< bits of BodyDef::layers [-]
  ForceLaw law{};                    ///< [-]
  std::string other{};               ///< of a spring or bungee: the shot at its other end, fired once [-]
  double delay = 0;                  ///< before it starts [s]
  double duration = kInfinity;       ///< then it ends [s]
};

/// One [[joint]], there from the start.
struct ScenarioJoint {
  std::string name{};   ///< in messages [-]
  std::string a{};      ///< name of the shot at one end, fired once [-]
  std::string b{};      ///< name of the shot at the other end, fired once; empty: a point [-]
  Joint def{};          ///< but for its ends [-]
  std::string thing{};  ///< name of the thing that takes its point along; empty: none [-]
};

/// One of the `sub` of an [[emitter]].
struct ScenarioSub {
  std::string emitter{};  ///< name of the emitter that fires; another one or itself [-]
  SubEmitter def{};       ///< but for the emitter [-]
};

/// One [[emitter]].
struct ScenarioEmitter {
  EmitterDef def{};                 ///< but for what the members below say, and for kind, launch and subs [-]
  std::string shot{};               ///< name of the shot that gives its projectile, body, rail, attitude and spin [-]
  std::string tracer{};             ///< of a gun: name of the shot that every tracer_every-th round is; empty: none [-]
  std::string surface_of{};         ///< name of the [[shape]] that its particles come out of; empty: none [-]
  std::string surface_file{};       ///< file of the mesh instead, as the scenario says it [-]
  std::string follows{};            ///< name of a shot, fired once, that it sits on; empty: none [-]
  ScenarioRotation rotation{};      ///< from its frame (x forward, y up, z right) to W [-]
  ScenarioMotion motion{};          ///< [-]
  std::vector<ScenarioSub> subs{};  ///< [-]
};

// ---------------------------------------------------------------------------------------------------------------------
// Scenarios: shots, environment and expectations read from a TOML file.

/// One [[shot]] of a scenario. Its fidelity is projectile.fidelity, its name projectile.name.
struct ScenarioShot {
  ProjectileDef projectile{};  ///< [-]
  Launch launch{};             ///< [-]
  BodyDef body{};              ///< how a world treats it; contact_of() it is how a flight meets things [-]
  std::string pool{};          ///< name of its pool in the world; empty: the first [-]
  /// Flies the cheapest fidelity that stays so close to projectile.fidelity at any time; none: that one itself [m]
  std::optional<double> cheapest_within{};
};

/// The [target] of a scenario: what `physim aim` aims at.
struct ScenarioTarget {
  std::optional<Vec3d> position{};  ///< at launch, in W; none: there is no target [m]
  Vec3d velocity{};                 ///< at launch [m/s]
  Vec3d acceleration{};             ///< constant [m/s^2]
  double tolerance = 0.01;          ///< a path that passes so near hits it [m]
  Arc arc = Arc::both;              ///< which solutions are looked for [-]
};

/// Where on a flight an expectation looks.
enum class ExpectAt {
  end,
  apex,       ///< the first
  rail_exit,  ///< the end of the launch rail
  burnout,    ///< of the motor
  time,       ///< since launch
  range,      ///< first crossing, along the line of sight
  height,     ///< first crossing, above the origin
};

/// One [[expect]] of a scenario: a figure that should come out, and why.
struct Expectation {
  std::string shot{};           ///< name; empty: every shot [-]
  std::string thing{};          ///< of figures of hits: name of what is hit; empty: all that is hit [-]
  ExpectAt at = ExpectAt::end;  ///< [-]
  double at_value = 0;          ///< time [s], range [m] or height [m]
  std::string quantity{};       ///< "drop", "windage", "range", "speed", "time", "x", "vy", "az", "mach", ... [-]
  double equals = 0;            ///< expected value [SI unit of the quantity]
  double within = 0;            ///< allowed distance [SI unit of the quantity]
  std::string source{};         ///< why it should be true [-]
  std::string place{};          ///< file:line:col [-]
  bool published = false;       ///< it was published: pictures over time show it as a ring, others as a cross [-]
};

/// A whole scenario.
struct Scenario {
  std::string file{};                       ///< path it was read from [-]
  std::vector<std::string> files{};         ///< paths of all files it comes from: itself, motors, meshes, ... [-]
  std::string title{};                      ///< [-]
  std::string source{};                     ///< where its figures come from [-]
  Environment environment{};                ///< [-]
  Tolerance tolerance{};                    ///< [-]
  Until until{};                            ///< [-]
  std::vector<double> ranges{};             ///< of the range card [m]
  ScenarioTarget target{};                  ///< [-]
  std::vector<ScenarioShot> shots{};        ///< [-]
  ScenarioWorld world{};                    ///< [-]
  std::vector<Volley> volleys{};            ///< [-]
  std::vector<ScenarioForce> forces{};      ///< [-]
  std::vector<ScenarioEmitter> emitters{};  ///< [-]
  std::vector<ScenarioJoint> joints{};      ///< [-]
  std::vector<Material> materials{};        ///< [-]
  std::vector<ScenarioShape> shapes{};      ///< [-]
  std::vector<ScenarioThing> things{};      ///< [-]
  std::vector<Expectation> expect{};        ///< [-]
  ScenarioStudy study{};                    ///< [-]
  std::vector<std::string> notes{};         ///< remarks about the file, with their place: former names [-]
  /// Places of the keys of each joint, such as "joint.length", and under "" of the joint: file:line:col [-]
  std::vector<std::map<std::string, std::string>> joint_places{};
  /// What the file and overrides give of shots and of all that is no list, in the order of paths [-]
  std::vector<GivenSetting> given{};
};

/// The emitter that fires the rounds or tracers of a shot by its name, which no volley fires; null: none.
[[nodiscard]] const ScenarioEmitter* emitter_alone_of(const Scenario& scenario, std::string_view shot);

/// Reads a scenario file. Each override is "path=value" as on the command line: "environment.gravity.model=off",
/// "shot.mass=170 gr" for every shot, "shot.NAME.mass=170 gr" for one. Overrides replace what the file says before it
/// is checked; later ones win. Errors carry file:line:col, or "--set path=value". A study that is not complete is
/// left for read_study() to check.
[[nodiscard]] Result<Scenario> load_scenario(const std::string& file, std::span<const std::string> overrides = {},
                                             bool has_complete_study = true);
/// The text of a scenario file, and a scenario from a text that was read from `file`.
[[nodiscard]] Result<std::string> read_scenario_text(const std::string& file);
[[nodiscard]] Result<Scenario> parse_scenario_file(const std::string& text, const std::string& file,
                                                   std::span<const std::string> overrides);
/// Reads a scenario from the text of a file; `file` only names it in errors.
[[nodiscard]] Result<Scenario> parse_scenario(const std::string& text, const std::string& file,
                                              std::span<const std::string> overrides = {});

/// A scenario as the text of a file: the settings that differ from their defaults, and of its shots from the presets
/// nearest to them. parse_scenario() reads it back as it was, bit for bit; but shots of a scenario without a [world]
/// have no settings of their own for worlds: of [shot.body] its colour, and those that contact_of() reads where there
/// are things.
[[nodiscard]] std::string scenario_text(const Scenario& scenario);

/// Flies a shot of a scenario by its settings, until the scenario ends it. Without a [world] it meets the scenario's
/// things as contact_of() the shot says; in one it flies alone, and meets nothing.
[[nodiscard]] Flight fly_shot(const Scenario& scenario, const ScenarioShot& shot);
/// ... through a scene that is there already, as scene_of() the scenario.
[[nodiscard]] Flight fly_shot(const Scenario& scenario, const ScenarioShot& shot, const Scene& scene);

/// The projectile of a shot in a separate flight: with what its body says of gravity and drag in a world.
[[nodiscard]] ProjectileDef projectile_of(const ScenarioShot& shot);

/// The shot with that projectile, and a body that says no more of it.
[[nodiscard]] ScenarioShot as_flown(ScenarioShot shot);

/// How a shot meets things in a separate flight: as its body says, from time 0 of the scene on.
[[nodiscard]] ContactDef contact_of(const ScenarioShot& shot);

/// The value of an expectation on a flown shot [SI unit of the quantity], or why it has no value.
[[nodiscard]] Result<double> measure(const Flight& flight, const Expectation& expectation);

/// Every setting of a scenario with the value it has, as path and text in SI: ("shot.308.mass", "0.010886 kg"). Given
/// back as overrides ("path=text") to a scenario with shots of the same names, they reproduce it bit for bit.
[[nodiscard]] std::vector<std::pair<std::string, std::string>> effective_settings(const Scenario& scenario);

}  // namespace physim
