// Scenario: files of scenarios by the paths of their settings, and of motors, meshes, terrain and recordings. Part of
// the library physim_scenario.
#pragma once

#include <cstddef>
#include <cstdint>
#include <limits>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "physim/flight.hpp"
#include "physim/projectile.hpp"
#include "physim/result.hpp"
#include "physim/scene.hpp"
#include "physim/units.hpp"
#include "physim/world.hpp"

namespace physim {

class WorldRun;

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
  std::string default_value{};           ///< as typed in an override; "" if there is no default [-]
  std::string range{};                   ///< "> 0", "0 .. 1", "off | constant | ..."; of lists: their length [-]
  std::string doc{};                     ///< one line [-]
  bool live = false;                     ///< worlds can change it for one projectile in flight [-]
};

/// The list of all settings of scenario files, in the order in which they are read. Settings of list elements have the
/// path of the list before them: "until.events.kind".
[[nodiscard]] std::span<const Setting> settings();

/// The world of a scenario file, run step by step: it fires shots, volleys and emitters when they are due.
class ScenarioRun {
 public:
  ScenarioRun(ScenarioRun&&) noexcept;
  ScenarioRun& operator=(ScenarioRun&&) noexcept;
  ~ScenarioRun();

  /// Fires what is due and takes one step.
  void step();
  /// Number of steps in the scenario's duration.
  [[nodiscard]] std::uint64_t steps() const;
  [[nodiscard]] World& world();
  [[nodiscard]] const World& world() const;

 private:
  friend class ScenarioFile;
  explicit ScenarioRun(std::unique_ptr<WorldRun> run);
  std::unique_ptr<WorldRun> run_;
};

/// A scenario file that could be read. Its settings are read and changed by their paths (docs/settings.md): those of a
/// shot as "shot.NAME.mass", or as "shot.mass" where there is one shot. Copies are cheap, and independent.
class ScenarioFile {
 public:
  /// Reads a file. An override is "path=value", as `--set` has it, and replaces what the file says. An error has the
  /// place in the file, or the override.
  [[nodiscard]] static Result<ScenarioFile> load(const std::string& file, std::span<const std::string> overrides = {});
  /// Reads the text of a file; `file` names it in errors, and other files are looked for beside it.
  [[nodiscard]] static Result<ScenarioFile> parse(const std::string& text, const std::string& file,
                                                  std::span<const std::string> overrides = {});

  /// Notes on the file, with their places: former names of settings.
  [[nodiscard]] std::span<const std::string> notes() const;
  /// Names of the shots, in the order of the file; "" for a shot without a name.
  [[nodiscard]] std::vector<std::string> shots() const;
  /// The value of a setting as text, in SI units, default or not: get("shot.mass") == "0.0109 kg".
  [[nodiscard]] Result<std::string> get(std::string_view path) const;
  /// Changes a setting: set("shot.mass", "170 gr"). After an error the scenario is as it was.
  Status set(std::string_view path, std::string_view value);
  /// The settings that differ from their defaults, as the text of a file.
  [[nodiscard]] std::string text() const;

  /// Flies a shot of the file: the first, or the named one.
  [[nodiscard]] Result<Flight> fly(std::string_view shot = {}) const;
  /// The world of the file, before its first step; an error if the file has no [world]. With `recording` every call is
  /// recorded into that file.
  [[nodiscard]] Result<ScenarioRun> run(const std::string& recording = {}) const;

 private:
  struct State;
  explicit ScenarioFile(std::shared_ptr<const State> state);
  std::shared_ptr<const State> state_;
};

// ---------------------------------------------------------------------------------------------------------------------
// Motor files: thrust curves in the RASP format (.eng), as motor makers and certifiers publish them.

/// A motor of a file. Its diameter, length and mass are what a rocket must carry; the rocket's own mass is beside.
struct MotorFileEntry {
  MotorDef motor{};              ///< name, thrust and propellant mass [-]
  double diameter = 0;           ///< [m]
  double length = 0;             ///< [m]
  double mass = 0;               ///< of the loaded motor [kg]
  std::string delays{};          ///< of the ejection charge, as written: "0-3-5-7" [-]
  std::string manufacturer{};    ///< [-]
  std::size_t line = 0;          ///< of its header in the file, from 1 [-]
  std::optional<Error> fault{};  ///< why it cannot be flown, with file:line; nothing where it can [-]
};

/// Reads the motors of a RASP file: lines of comment start with ';'; a motor is a header of seven words (name, diameter
/// in mm, length in mm, delays, propellant in kg, mass in kg, manufacturer) and lines of time in s and thrust in N, up
/// to a thrust of zero. Thrust rises from zero at time 0, which the format leaves out; two points at one time are a
/// step. A motor that cannot be flown is named by its MotorFileEntry::fault and does not affect the others. An error if
/// no motor can be flown, or if the file begins with something else. Errors carry file:line.
[[nodiscard]] Result<std::vector<MotorFileEntry>> read_motor_file(const std::string& file);
/// Reads motors from the text of a RASP file; `file` only names it in errors.
[[nodiscard]] Result<std::vector<MotorFileEntry>> parse_motor_file(const std::string& text, const std::string& file);
/// The motor of a name ("C6"), of a maker and a name ("Estes C6"), or the only one where the name is empty. An error if
/// it cannot be flown, or if several that differ have the name.
[[nodiscard]] Result<MotorFileEntry> pick_motor(const std::vector<MotorFileEntry>& motors, const std::string& name,
                                                const std::string& file);

// ---------------------------------------------------------------------------------------------------------------------
// Mesh files: triangles out of OBJ, STL, glTF and what else Assimp reads; heights out of pictures.

/// Whether this build reads meshes from files: true if Assimp was found when it was built.
[[nodiscard]] bool reads_mesh_files();

/// The triangles of all objects of a file, up to 256 MB of it, as they stand in it; equal corners are one vertex. A
/// number of the file is a metre, to float32; y is up, whatever the format says about axes. The error's place is the
/// file.
[[nodiscard]] Result<MeshShape> read_mesh_file(const std::string& file);

/// Whether this build reads heights from pictures: true if stb was found when it was built.
[[nodiscard]] bool reads_height_maps();

/// Heights out of a picture in grey, PNG of 8 or 16 bits best: black is `low` and white is `high` [m], columns go along
/// x and rows along z, from the upper left corner on; colours count by their brightness. Spacings stay 1 m. Up to 1e8
/// points; the error's place is the file.
[[nodiscard]] Result<HeightFieldShape> read_height_map(const std::string& file, double low, double high);

// ---------------------------------------------------------------------------------------------------------------------
// Terrain files: heights over latitude and longitude out of GeoTIFF, SRTM (.hgt) and what else GDAL reads.

/// The part of a terrain file that is read, and the reference of its heights.
struct TerrainCut {
  double latitude = 0;                                     ///< of the place about which it is cut [rad]
  double longitude = 0;                                    ///< of that place, east positive [rad]
  double reach = std::numeric_limits<double>::infinity();  ///< extent north, south, east and west of it, above 0 [m]
  std::uint32_t every = 1;                                 ///< of its points along both directions, at least 1 [-]
  double geoid = 0;                 ///< of sea level above the ellipsoid there, added to all heights, within 200 m [m]
  std::optional<double> missing{};  ///< height of points that have none, above sea level; none: they are an error [m]
};

/// Whether this build reads terrain from files: true if GDAL was found when it was built.
[[nodiscard]] bool reads_terrain_files();

/// The heights of the first band of a raster, in the unit that it names, brought to a grid of latitude and longitude on
/// WGS 84 if they lie in another projection or geographic system. A point has no height if the file's number for
/// nothing, its mask or its alpha band says so, or if its height is below -12 km or above 9.2 km. Points lie where the
/// file has them, the middles of its cells. Up to 2e7 points after the cut: a larger one is refused before it is read.
/// The error's place is the file, or the member of the cut that is wrong.
[[nodiscard]] Result<GeodeticGrid> read_terrain_file(const std::string& file, const TerrainCut& cut = {});

// ---------------------------------------------------------------------------------------------------------------------
// Recordings as files.

/// Records a world into a file, as World::record() does. What there is goes to `path`.part before every step, so that
/// a program that dies leaves a recording of all that it did; stop_recording(), or the end of the world, completes it
/// and gives it its name. What stood there before is replaced only then.
[[nodiscard]] Status record_to_file(World& world, const std::string& path, const RecordOptions& options = {});

/// Writes a recording whole or not at all.
[[nodiscard]] Status save_recording(const std::string& path, std::span<const std::byte> recording);

/// The bytes of a file, for Replay::open(), which looks whether they are a recording.
[[nodiscard]] Result<std::vector<std::byte>> load_recording(const std::string& path);

}  // namespace physim
