#include <algorithm>
#include <cmath>
#include <fstream>
#include <sstream>

#include "base/assert.hpp"
#include "physim/names.hpp"
#include "physim/units.hpp"
#include "validation/ballistics.hpp"
#include "validation/csv.hpp"
#include "validation/suite.hpp"

namespace physim::validation {
using nlohmann::json;
namespace {

const json kNull;
const json kEmpty = json::object();
constexpr double kPoundPerSquareInch = units::operator""_lb_in2(1.0L);  // [kg/m^2]

bool has(const std::string& text, const char* part) { return text.find(part) != std::string::npos; }

bool is_numbers(const json& list, std::size_t count) {
  return list.is_array() && list.size() == count &&
         std::ranges::all_of(list, [](const json& v) { return v.is_number(); });
}

}  // namespace

// ---------------------------------------------------------------------------------------------------------- JSON files

JsonCases::JsonCases(const std::filesystem::path& path) : path_(path) {
  std::ifstream in(path);
  if (!in) throw DataError{{.message = "cannot be read", .place = path.string()}};
  std::stringstream buffer;
  buffer << in.rdbuf();
  text_ = buffer.str();
  try {
    cases_ = json::parse(text_);
  } catch (const json::parse_error& error) {
    std::string words = error.what();
    if (const auto at = words.find(": ", words.find("column")); at != std::string::npos) words = words.substr(at + 2);
    throw DataError{{.message = "not JSON: " + words, .place = place(std::min(error.byte, text_.size()))}};
  } catch (const json::exception& error) {  // a number beyond all doubles
    throw DataError{{.message = std::string("not JSON: ") + error.what(), .place = path.string()}};
  }
  if (!cases_.is_array()) throw DataError{{.message = "a list of cases was expected", .place = place(0)}};
  for (std::size_t i = 0; i < cases_.size(); ++i)
    if (!cases_[i].is_object()) fail(i, "an object was expected");
}

std::string JsonCases::id(std::size_t index) const {
  PHYSIM_ASSERT(index < cases_.size());
  const json& object = cases_[index];
  const std::string stem = path_.stem().string();
  if (object.is_object() && object.contains("id") && object["id"].is_string()) return object["id"];
  return format("%s %zu", stem.c_str(), index + 1);
}

void JsonCases::fail(std::size_t index, const std::string& message) const {
  const auto at = text_.find("\"" + id(index) + "\"");
  throw DataError{
      {.message = "case \"" + id(index) + "\": " + message, .place = place(at == std::string::npos ? 0 : at)}};
}

std::string JsonCases::place(std::size_t at) const {
  PHYSIM_ASSERT(at <= text_.size());
  const auto end = text_.begin() + static_cast<std::ptrdiff_t>(at);
  return format("%s:%td", path_.string().c_str(), 1 + std::count(text_.begin(), end, '\n'));
}

std::string JsonCases::source(std::size_t index) const {
  const json& object = cases_[index];
  if (!object.contains("source")) return {};
  const json& source = object["source"];
  if (source.is_string()) return source;
  std::string text;
  if (source.is_object())
    for (const auto& [key, value] : source.items())
      if (value.is_string()) text = value.get<std::string>() + (text.empty() ? "" : ", " + text);
  return text;
}

// -------------------------------------------------------------------------------------------------------------- fields

CaseReader::CaseReader(const JsonCases& file, std::size_t index, const json& object, std::string path)
    : file_(file), index_(index), object_(object.is_null() ? kEmpty : object), path_(std::move(path)) {
  if (!object_.is_object()) fail("an object was expected");
}

void CaseReader::fail(const std::string& message) const {
  file_.fail(index_, path_.empty() ? message : "\"" + path_ + "\": " + message);
}

const json& CaseReader::raw(const char* key) const {
  const auto at = object_.find(key);
  return at == object_.end() ? kNull : *at;
}

const json& CaseReader::checked(const char* key, bool (json::*fits)() const noexcept, const char* kind) const {
  const json& value = raw(key);
  if (!value.is_null() && !(value.*fits)()) fail(std::string("\"") + key + "\" is " + kind + ": " + value.dump());
  return value;
}

std::optional<double> CaseReader::number(const char* key) const {
  const json& value = checked(key, &json::is_number, "not a number");
  return value.is_null() ? std::nullopt : std::optional(value.get<double>());
}

double CaseReader::needed(const char* key) const {
  const auto value = number(key);
  if (!value) fail(std::string("\"") + key + "\" is missing");
  return *value;
}

std::string CaseReader::text(const char* key) const {
  const json& value = checked(key, &json::is_string, "not a text");
  return value.is_null() ? std::string() : value.get<std::string>();
}

bool CaseReader::flag(const char* key) const {
  const json& value = checked(key, &json::is_boolean, "neither true nor false");
  return !value.is_null() && value.get<bool>();
}

Vec3d CaseReader::vector(const char* key) const {
  const json& value = raw(key);
  if (value.is_null()) return {};
  if (!is_numbers(value, 3)) fail(std::string("\"") + key + "\" is not a list of three numbers: " + value.dump());
  return {value[0], value[1], value[2]};
}

CaseReader CaseReader::object(const char* key) const {
  return {file_, index_, raw(key), (path_.empty() ? "" : path_ + ".") + key};
}

CaseReader CaseReader::element(const char* list, std::size_t index) const {
  PHYSIM_ASSERT(raw(list).is_array());
  PHYSIM_ASSERT(index < raw(list).size());
  return {file_, index_, raw(list)[index], format("%s[%zu]", list, index)};
}

// --------------------------------------------------------------------------------------------------------------- cases
namespace {

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

}  // namespace

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

double Gate::of(double range, double expected) const {
  constexpr double kRadiansPerMinute = kPi / 10800.0;
  return absolute + moa * kRadiansPerMinute * std::abs(range) + relative * std::abs(expected);
}

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

}  // namespace physim::validation
