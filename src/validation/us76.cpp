// Suite us76: the US Standard Atmosphere 1976, against exact values and a published table.
#include <algorithm>
#include <cmath>
#include <optional>

#include "physim/environment.hpp"
#include "report/number.hpp"
#include "validation/suite.hpp"

namespace physim::validation {
using report::significant;
namespace {

constexpr double kExact = 1e-10;             // relative gate against exact values
constexpr double kPublishedRounding = 5e-7;  // relative; see printed_gate()

constexpr double AirSample::*kGravity = nullptr;  // no property of the air

/// All names that columns have in the files of this suite.
constexpr std::pair<const char*, double AirSample::*> kAirColumns[] = {{"T_molecular_K", &AirSample::temperature},
                                                                       {"T_base_K", &AirSample::temperature},
                                                                       {"T_K", &AirSample::temperature},
                                                                       {"P_Pa", &AirSample::pressure},
                                                                       {"P_base_Pa", &AirSample::pressure},
                                                                       {"rho_kg_m3", &AirSample::density},
                                                                       {"a_m_s", &AirSample::sound_speed},
                                                                       {"mu_Pa_s", &AirSample::viscosity},
                                                                       {"g_m_s2", kGravity}};

/// Newton's gravity at a height, as a flight feels it.
double gravity_at(double height) {
  const Fidelity fidelity{.gravity = GravityModel::inverse_square, .drag = DragModel::off, .air = AirModel::vacuum};
  const Launch launch{.position = {0, height, 0}, .velocity = Vec3d{}};
  const Flight flight = fly({}, launch, {}, fidelity, {}, {.ground = std::nullopt, .time = 0.01});
  return flight.error() ? kNaN : length(flight.accelerations(0).gravity);
}

/// Viscosity of air at a temperature.
double viscosity_at(double temperature) {
  Environment environment;
  environment.atmosphere.model = AirModel::constant;
  environment.atmosphere.temperature = temperature;
  const auto air = air_at(environment, 0);
  return air ? air->viscosity : kNaN;
}

/// "Five significant digits" in the comments: how many digits a published table shows; it drops zeros at the end.
std::optional<int> significant_digits(const std::string& comments) {
  static constexpr std::string_view kWords[] = {"zero", "one", "two",   "three", "four",
                                                "five", "six", "seven", "eight", "nine"};
  const std::string text = lower(comments);
  const auto at = text.find(" significant digit");
  if (at == std::string::npos) return std::nullopt;
  const auto first = text.find_last_of(" .,(", at - 1) + 1;  // 0 if no such character precedes it
  const std::string word = text.substr(first, at - first);
  const auto found = std::find(std::begin(kWords), std::end(kWords), word);
  if (found != std::end(kWords)) return static_cast<int>(found - std::begin(kWords));
  const auto number = parse_number(word);
  return number && *number >= 1 && *number <= 17 ? std::optional(static_cast<int>(*number)) : std::nullopt;
}

/// Half of the last printed digit, and the published arithmetic's own error: two of its 225 figures (the pressures at
/// 68 and 72 km) are not the exact values rounded, and miss half a digit by 3e-7 of their value.
double printed_gate(const std::string& printed, double value, std::optional<int> digits) {
  double unit = last_digit_unit(printed);
  if (digits && value != 0) unit = std::pow(10.0, std::floor(std::log10(std::abs(value))) - (*digits - 1));
  return 0.5 * unit + kPublishedRounding * std::abs(value);
}

bool is_published(const CsvFile& file) {
  return file.name().find("published") != std::string::npos ||
         file.comments().find("ublished table") != std::string::npos;
}

bool compare_air_file(const CsvFile& file, SuiteResult& result) {
  if (!file.name().starts_with("us76") && !file.has("Z_geometric_m")) return false;
  const char* place = file.has("Z_base_m") ? "Z_base_m" : "Z_geometric_m";
  file.require({place});
  const bool published = is_published(file);
  const auto digits = significant_digits(file.comments());
  for (const CsvRow& row : file.rows()) {
    const double z = file.needed(row, place);
    const auto air = air_at({}, z);
    // PhySim's temperature is the molecular one; viscosity follows the kinetic one where a table has both.
    const auto kinetic = file.number(row, "T_kinetic_K");
    for (const auto& [column, property] : kAirColumns) {
      const auto expected = file.number(row, column);
      if (!expected) continue;
      const bool is_kinetic = property == &AirSample::viscosity && kinetic;
      const double actual = !air                   ? kNaN
                            : is_kinetic           ? viscosity_at(*kinetic)
                            : property == kGravity ? gravity_at(z)
                                                   : (*air).*property;
      result.compare(file.stem(), std::string(column) + " at " + significant(z, 8) + " m", *expected, actual,
                     published ? printed_gate(file.text(row, column), *expected, digits) : kExact * std::abs(*expected),
                     air ? "" : air.error().text());
    }
  }
  return true;
}

constexpr std::string_view kUs76Files[] = {"us76_exact.csv", "us76_layers.csv", "us76_published_pdas_2km.csv"};

void run_us76(const std::filesystem::path& folder, SuiteResult& result) {
  compare_tables(folder, kUs76Files, "not a table of the standard atmosphere", result, compare_air_file);
}

}  // namespace

const Suite kUs76Suite = {
    "us76",
    "US Standard Atmosphere 1976, -5 to 86 km",
    "1e-10 of exact values; half of the last printed digit of published ones, plus 5e-7 of the value "
    "for the published table's own rounding",
    "atmosphere",
    kUs76Files,
    run_us76};

}  // namespace physim::validation
