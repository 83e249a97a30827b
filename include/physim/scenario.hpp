// Scenarios: shots, environment and expectations read from a TOML file. Part of the library physim_scenario.
#pragma once

#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "physim/aim.hpp"
#include "physim/environment.hpp"
#include "physim/flight.hpp"
#include "physim/projectile.hpp"
#include "physim/quantity.hpp"
#include "physim/result.hpp"
#include "physim/scenario_scene.hpp"
#include "physim/scenario_study.hpp"
#include "physim/scenario_world.hpp"

namespace physim {

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
  std::vector<std::string> notes{};         ///< what a reader should know of the file, with its place: former names [-]
};

/// Reads a scenario file. Each override is "path=value" as on the command line: "environment.gravity.model=off",
/// "shot.mass=170 gr" for every shot, "shot.NAME.mass=170 gr" for one. Overrides replace what the file says before it
/// is checked; later ones win. Errors carry file:line:col, or "--set path=value".
[[nodiscard]] Result<Scenario> load_scenario(const std::string& file, std::span<const std::string> overrides = {});
/// Reads a scenario from the text of a file; `file` only names it in errors.
[[nodiscard]] Result<Scenario> parse_scenario(const std::string& text, const std::string& file,
                                              std::span<const std::string> overrides = {});

/// A scenario as the text of a file: the settings that differ from their defaults, and of its shots from the presets
/// nearest to them. parse_scenario() reads it back as it was, bit for bit; but shots of a scenario without a [world]
/// have no settings of their own for worlds: of [shot.body] its colour, and those that contact_of() reads where there
/// are things.
[[nodiscard]] std::string scenario_text(const Scenario& scenario);

/// Flies a shot of a scenario as it asks for, until the scenario ends it. Without a [world] it meets the scenario's
/// things as contact_of() the shot says; in one it flies by itself, and meets nothing.
[[nodiscard]] Flight fly_shot(const Scenario& scenario, const ScenarioShot& shot);
/// ... through a scene that is there already, as scene_of() the scenario.
[[nodiscard]] Flight fly_shot(const Scenario& scenario, const ScenarioShot& shot, const Scene& scene);

/// The projectile of a shot in a flight of its own: with what its body says of gravity and drag in a world.
[[nodiscard]] ProjectileDef projectile_of(const ScenarioShot& shot);

/// The shot with that projectile, and a body that says no more of it.
[[nodiscard]] ScenarioShot as_flown(ScenarioShot shot);

/// How a shot meets things in a flight of its own: as its body says, from time 0 of the scene on.
[[nodiscard]] ContactDef contact_of(const ScenarioShot& shot);

/// The value of an expectation on a flown shot [SI unit of the quantity], or why there is none.
[[nodiscard]] Result<double> measure(const Flight& flight, const Expectation& expectation);

/// The units that are accepted for a quantity, the SI unit first; "%" for plain numbers.
[[nodiscard]] std::vector<std::string> units_of(Quantity quantity);

/// Parses "168 gr", "2600 ft/s", "0.218 lb/in^2", "15 degC", "-3.10 m" or a plain number (SI) into SI.
/// May be infinite ("inf"), never NaN.
[[nodiscard]] Result<double> parse_quantity(std::string_view text, Quantity quantity);

/// One public setting, declared once. Files, overrides, docs, panels and error messages are made from this list.
struct Setting {
  std::string path{};  ///< "shot.drag.ballistic_coefficient" [-]
  /// quantity, integer, boolean, text, choice, vector, points, list, drawn (a number that emitters draw), colour (that
  /// they draw) or gradient [-]
  std::string type{};
  Quantity quantity = Quantity::number;  ///< of quantities, vectors and lists of numbers [-]
  std::string unit{};                    ///< SI unit, "" for none, "of the kind" where another setting decides [-]
  std::string default_value{};           ///< as typed in an override; "" where there is none [-]
  std::string range{};                   ///< "> 0", "0 .. 1", "off | constant | ..."; of lists: their length [-]
  std::string doc{};                     ///< one line [-]
  bool live = false;                     ///< worlds can change it for one projectile in flight [-]
};

/// The list of all settings of scenario files, in the order in which they are read. Settings of list elements have the
/// path of the list before them: "until.events.kind".
[[nodiscard]] std::span<const Setting> settings();

/// Every setting of a scenario with the value it has, as path and text in SI: ("shot.308.mass", "0.010886 kg"). Given
/// back as overrides ("path=text") to a scenario with shots of the same names, they reproduce it bit for bit.
[[nodiscard]] std::vector<std::pair<std::string, std::string>> effective_settings(const Scenario& scenario);

}  // namespace physim
