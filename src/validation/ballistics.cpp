// Suite ballistics: published range tables, zeroes and air densities of exterior-ballistics tools.
#include <algorithm>
#include <array>
#include <cmath>

#include "physim/environment.hpp"
#include "physim/flight.hpp"
#include "physim/names.hpp"
#include "physim/units.hpp"
#include "report/number.hpp"
#include "validation/json_cases.hpp"

namespace physim::validation {
using nlohmann::json;
using report::significant;
namespace {

// --------------------------------------------------------------------------------------------------------------- cases
constexpr double kPoundPerSquareInch = units::operator""_lb_in2(1.0L);  // [kg/m^2]

/// A shot of exterior ballistics.
struct BallisticCase {
  ProjectileDef projectile;
  Launch launch;
  Environment environment;
  Fidelity fidelity;
  double impact_above_aim = 0;       ///< at the zero range [m]
  bool range_is_horizontal = false;  ///< else along the line of sight
};

bool has(const std::string& text, const char* part) { return text.find(part) != std::string::npos; }

DragPoint read_point(const CaseReader& reader, const json& item) {
  std::optional<double> mach, cd;
  if (is_numbers(item, 2)) {
    mach = item[0].get<double>();
    cd = item[1].get<double>();
  } else if (item.is_object()) {
    for (const auto& [name, value] : item.items())
      if (value.is_number()) (lower(name).starts_with("m") ? mach : cd) = value.get<double>();
  }
  if (!mach || !cd) reader.fail("\"drag_curve\": a Mach number and a coefficient were expected: " + item.dump());
  return {*mach, *cd};
}

void read_curve(const CaseReader& reader, DragDef& drag) {
  const json& curve = reader.raw("drag_curve");
  if (!curve.is_array() || curve.empty()) reader.fail("\"drag_curve\" is not a list of points");
  drag.table = DragTable::custom;
  for (const json& item : curve) drag.curve.push_back(read_point(reader, item));
}

/// The lowest speed of a band, and its ballistic coefficient. A band given only by its upper end is turned round later.
struct Band {
  std::optional<double> from, to;
  double bc = 0;  ///< [kg/m^2]
};

Band read_band(const CaseReader& reader, const json& item) {
  Band band;
  std::optional<double> bc;
  if (is_numbers(item, 2)) {
    band.from = item[0].get<double>();
    bc = item[1].get<double>() * kPoundPerSquareInch;
  } else if (is_numbers(item, 3)) {
    band.from = std::min(item[0].get<double>(), item[1].get<double>());
    bc = item[2].get<double>() * kPoundPerSquareInch;
  } else if (item.is_object()) {
    for (const auto& [key, value] : item.items()) {
      if (!value.is_number()) continue;
      const std::string name = lower(key);
      if (name.starts_with("bc") || has(name, "coefficient"))
        bc = value.get<double>() * (has(name, "kg") ? 1.0 : kPoundPerSquareInch);
      else if (has(name, "max") || has(name, "below") || has(name, "upto") || has(name, "up_to") ||
               has(name, "until") || name.starts_with("to"))
        band.to = value.get<double>();
      else
        band.from = value.get<double>();
    }
  }
  if (!bc || (!band.from && !band.to))
    reader.fail("\"bc_bands\": a speed and a coefficient were expected: " + item.dump());
  band.bc = *bc;
  return band;
}

void read_bands(const CaseReader& reader, DragDef& drag) {
  const json& list = reader.raw("bc_bands");
  if (!list.is_array() || list.empty()) reader.fail("\"bc_bands\" is not a list of bands");
  std::vector<Band> bands;
  for (const json& item : list) bands.push_back(read_band(reader, item));
  std::sort(bands.begin(), bands.end(), [](const Band& a, const Band& b) {
    return a.from.value_or(a.to.value_or(0)) < b.from.value_or(b.to.value_or(0));
  });
  for (std::size_t i = 0; i < bands.size(); ++i) {
    const double below = i > 0 && bands[i - 1].to ? *bands[i - 1].to : 0.0;
    // The lowest holds below as well.
    drag.bands.push_back({i == 0 ? 0.0 : bands[i].from.value_or(below), bands[i].bc});
  }
}

void read_drag(const CaseReader& reader, DragDef& drag) {
  const std::string table = reader.text("drag_table");
  if (!reader.raw("drag_curve").is_null()) {
    read_curve(reader, drag);
  } else if (!table.empty()) {
    const auto value = value_of<DragTable>(lower(table));
    if (!value || *value == DragTable::custom) reader.fail("no drag table \"" + table + "\"");
    drag.table = *value;
  } else if (const auto cd = reader.number("drag_coefficient")) {
    drag.coefficient = *cd;
  } else {
    reader.fail("a \"drag_table\" or a \"drag_curve\" is needed");
  }
  drag.form_factor = reader.number_or("form_factor", 1);
  if (const auto bc = reader.number("bc_lb_in2")) drag.ballistic_coefficient = *bc * kPoundPerSquareInch;
  if (const auto bc = reader.number("bc_kg_m2")) drag.ballistic_coefficient = *bc;
  if (!reader.raw("bc_bands").is_null()) read_bands(reader, drag);
}

void read_projectile(const CaseReader& reader, BallisticCase& out) {
  ProjectileDef& projectile = out.projectile;
  read_drag(reader, projectile.drag);
  const bool has_bc = projectile.drag.ballistic_coefficient > 0 || !projectile.drag.bands.empty();
  projectile.mass = has_bc ? reader.number_or("mass_kg", projectile.mass) : reader.needed("mass_kg");
  projectile.diameter = has_bc ? reader.number_or("diameter_m", projectile.diameter) : reader.needed("diameter_m");
  projectile.length = reader.number_or("length_m", 0);
  const bool left = lower(reader.text("twist")).starts_with("l");
  projectile.twist = reader.number_or("twist_m", 0) * (left ? -1 : 1);
  const json& spin = reader.raw("spin_drift");
  const bool drifts = spin.is_string() ? lower(spin) == "litz" : spin.is_boolean() && spin.get<bool>();
  if (spin.is_string() && !drifts && lower(spin) != "none")
    reader.fail("no spin drift \"" + spin.get<std::string>() + "\"");
  out.fidelity.rotation = drifts ? RotationModel::spin_drift : RotationModel::none;
}

void read_launch(const CaseReader& reader, BallisticCase& out) {
  Launch& launch = out.launch;
  launch.speed = reader.needed("muzzle_velocity_m_s");
  launch.sight.height = reader.number_or("sight_height_m", 0);
  launch.sight.look_angle = reader.number_or("look_angle_rad", 0);
  launch.sight.cant = reader.number("cant_rad").value_or(reader.number_or("cant_angle_rad", 0));
  launch.sight.zero_in_calm_air = reader.flag("zero_in_calm_air");
  if (const auto elevation = reader.number("elevation_rad"))
    launch.elevation = *elevation;
  else
    launch.sight.zero_range = reader.needed("zero_range_m");
  out.impact_above_aim = reader.number_or("impact_above_aim_m", 0);
  out.range_is_horizontal = has(lower(reader.text("range_is")), "horizontal");
}

/// Air from "temperature_K", "pressure_Pa", "relative_humidity", "altitude_m".
void read_air(const CaseReader& reader, Environment& environment) {
  Atmosphere& air = environment.atmosphere;
  air.temperature = reader.number("temperature_K");
  air.pressure = reader.number("pressure_Pa");
  air.humidity = reader.number("relative_humidity");
  environment.altitude = reader.number_or("altitude_m", 0);
}

BallisticCase read_ballistic_case(const CaseReader& reader) {
  BallisticCase out;
  out.fidelity = Fidelity::small_arms();
  read_projectile(reader, out);
  read_launch(reader, out);
  out.environment.gravity.model = GravityModel::constant;
  out.environment.wind.velocity = reader.vector("wind_W_m_s");
  read_air(reader.object("atmosphere"), out.environment);
  if (const auto altitude = reader.number("altitude_m")) out.environment.altitude = *altitude;
  return out;
}

/// A gate: its parts are added up.
struct Gate {
  double absolute = 0;
  double moa = 0;
  double relative = 0;
  [[nodiscard]] double of(double range, double expected) const {
    constexpr double kRadiansPerMinute = kPi / 10800.0;
    return absolute + moa * kRadiansPerMinute * std::abs(range) + relative * std::abs(expected);
  }
};
/// Reads {"abs_m": ..., "moa": ..., "rel": ...}; nothing where there is no such gate.
std::optional<Gate> read_gate(const CaseReader& gates, const char* key) {
  if (gates.raw(key).is_null()) return std::nullopt;
  const CaseReader reader = gates.object(key);
  Gate gate;
  for (const auto& [name, value] : gates.raw(key).items()) {
    if (!value.is_number()) reader.fail("\"" + name + "\" is not a number");
    const double part = value;
    if (name.starts_with("abs"))
      gate.absolute += part;
    else if (name.starts_with("moa"))
      gate.moa += part;
    else if (name.starts_with("rel"))
      gate.relative += part;
    else
      reader.fail("no part of a gate: \"" + name + "\"");
  }
  return gate;
}

// -------------------------------------------------------------------------------------------------------------- suites
/// The bore elevation that makes the bullet strike where it should, above the aim at the zero range.
Result<double> zero_of(const BallisticCase& shot, double zero_range) {
  Launch launch = shot.launch;
  launch.sight.height += shot.impact_above_aim;  // a line of sight this much higher, parallel to the true one
  launch.sight.zero_range = 0;
  return zero_elevation(shot.projectile, launch, shot.environment, shot.fidelity, zero_range);
}

template <class T>
std::string problem_of(const Result<T>& result) {
  return result ? std::string() : result.error().text();
}

/// What a row of a range table can show.
struct TableColumn {
  const char* column;
  const char* gate;
  double Sample::*value;
};
constexpr TableColumn kTableColumns[] = {
    {"drop_m", "drop", &Sample::drop},
    {"windage_m", "windage", &Sample::windage},
    {"velocity_m_s", "velocity", &Sample::speed},
    {"time_s", "time", &Sample::time},
    {"mach", "mach", &Sample::mach},
    {"energy_J", "energy", &Sample::energy},
};

/// A flown case that answers by the range as the case counts it.
class RangeTable {
 public:
  RangeTable(BallisticCase shot, double last_range) : shot_(std::move(shot)) {
    Launch launch = shot_.launch;
    if (shot_.impact_above_aim != 0 && launch.sight.zero_range > 0) {
      const auto elevation = zero_of(shot_, launch.sight.zero_range);
      if (!elevation) problem_ = elevation.error().text();
      launch.elevation = elevation ? *elevation : 0;
      launch.sight.zero_range = 0;
    }
    along_ = fly_to(launch, last_range);
    if (!shot_.range_is_horizontal || launch.sight.look_angle == 0) return;
    launch.elevation = along_->elevation();  // the same flight, with ranges counted along the horizon
    launch.sight = {};
    horizontal_ = fly_to(launch, last_range);
  }

  [[nodiscard]] Result<Sample> at(double range) const {
    if (!problem_.empty()) return Error{.message = problem_};
    if (const std::string why = complaint(*along_, shot_.fidelity); !why.empty()) return Error{.message = why};
    if (!horizontal_) return along_->at_range(range);
    const Result<Sample> there = horizontal_->at_range(range);
    return there ? Result<Sample>(along_->at(there->time)) : there;
  }

 private:
  [[nodiscard]] Flight fly_to(const Launch& launch, double range) const {
    const double slope = shot_.range_is_horizontal ? std::cos(launch.sight.look_angle) : 1.0;
    const Until until{.ground = std::nullopt, .time = 600, .range = range / slope * (1 + 1e-9)};
    return fly(shot_.projectile, launch, shot_.environment, shot_.fidelity, {}, until);
  }

  BallisticCase shot_;
  std::optional<Flight> along_, horizontal_;
  std::string problem_;
};

void compare_row(const CaseReader& row, const CaseReader& gates, const RangeTable& table, const std::string& case_name,
                 SuiteResult& result) {
  const double range = row.needed("range_m");
  const Result<Sample> sample = table.at(range);
  for (const TableColumn& quantity : kTableColumns) {
    const auto expected = row.number(quantity.column);
    const auto gate = read_gate(gates, quantity.gate);
    if (!expected || !gate) continue;
    result.compare(case_name, std::string(quantity.column) + " at " + significant(range, 6) + " m", *expected,
                   sample ? (*sample).*quantity.value : kNaN, gate->of(range, *expected), problem_of(sample));
  }
}

void compare_trajectory(const std::string& id, const CaseReader& reader, SuiteResult& result) {
  const auto& rows = reader.raw("rows");
  if (!rows.is_array() || rows.empty()) reader.fail("\"rows\" is not a list of rows");
  if (!reader.raw("gate").is_object()) reader.fail("\"gate\" is missing");
  double last_range = 0;
  for (std::size_t r = 0; r < rows.size(); ++r)
    last_range = std::max(last_range, reader.element("rows", r).needed("range_m"));
  const RangeTable table(read_ballistic_case(reader), last_range);
  for (std::size_t r = 0; r < rows.size(); ++r)
    compare_row(reader.element("rows", r), reader.object("gate"), table, id, result);
}

void compare_zero(const std::string& id, const CaseReader& reader, SuiteResult& result) {
  const BallisticCase shot = read_ballistic_case(reader);
  const double range = reader.needed("zero_range_m");
  const Result<double> elevation = zero_of(shot, range);
  const double expected = reader.needed("expected_elevation_rad"), gate = reader.needed("gate_rad");
  result.compare(id, "elevation_rad for " + significant(range, 6) + " m", expected, elevation ? *elevation : kNaN, gate,
                 problem_of(elevation));
}

/// "288.15 K, 101325 Pa, humidity 0.5"
std::string air_label(const CaseReader& reader) {
  std::string label;
  const auto add = [&](const char* key, const char* before, const char* after) {
    const auto value = reader.number(key);
    if (value) label += (label.empty() ? "" : ", ") + (before + significant(*value, 8) + after);
  };
  add("temperature_K", "", " K");
  add("pressure_Pa", "", " Pa");
  add("relative_humidity", "humidity ", "");
  add("altitude_m", "", " m");
  return label;
}

/// Density of the air of a case: of its station, or of the standard atmosphere through it.
Result<double> density_of(const CaseReader& reader) {
  const auto temperature = reader.number("temperature_K");
  const auto pressure = reader.number("pressure_Pa");
  if (temperature && pressure)
    return moist_air_density(*temperature, *pressure, reader.number_or("relative_humidity", 0));
  Environment environment;
  read_air(reader, environment);
  const auto air = air_at(environment, environment.altitude);
  return air ? Result<double>(air->density) : Result<double>(air.error());
}

void compare_air(const std::string& id, const CaseReader& reader, SuiteResult& result) {
  const double expected = reader.needed("expected_density_kg_m3");
  const Result<double> density = density_of(reader);
  result.compare(id, "density_kg_m3 at " + air_label(reader), expected, density ? *density : kNaN,
                 reader.number_or("gate_abs_kg_m3", 0) + reader.number_or("gate_rel", 0) * std::abs(expected),
                 problem_of(density));
}

constexpr std::string_view kBallisticsFiles[] = {"trajectories.json", "zero.json", "air.json"};
constexpr std::array kCompare = {compare_trajectory, compare_zero, compare_air};
static_assert(kCompare.size() == std::size(kBallisticsFiles));

void run_ballistics(const std::filesystem::path& folder, SuiteResult& result) {
  for (const auto& path : files_in(folder, kBallisticsFiles, ".json")) {
    const std::string name = path.filename().string();
    const auto known = std::ranges::find(kBallisticsFiles, name);
    if (known == std::end(kBallisticsFiles)) {
      result.skipped.push_back(name + ": neither trajectories.json, zero.json nor air.json");
      continue;
    }
    const JsonCases file(path);
    for (std::size_t i = 0; i < file.cases().size(); ++i) {
      result.sources.push_back({file.id(i), file.source(i)});
      kCompare[static_cast<std::size_t>(known - std::begin(kBallisticsFiles))](file.id(i), CaseReader(file, i), result);
    }
  }
}

}  // namespace

const Suite kBallisticsSuite = {"ballistics",
                                "Published range tables, zeroes and air densities of exterior-ballistics tools",
                                "each case's own: abs + moa of the range + rel of the value",
                                "ballistics",
                                kBallisticsFiles,
                                run_ballistics};

}  // namespace physim::validation
