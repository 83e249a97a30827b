// Units with their values in SI. Exact by definition unless a comment says otherwise: the international yard and pound
// agreement (1959), the grain as 1/7000 lb, BIPM SI Brochure (9th ed.), NIST SP 811 (2008) for the rest.
#include "settings/units.hpp"

#include <array>
#include <charconv>
#include <cmath>
#include <iterator>

#include "base/assert.hpp"
#include "math/angles.hpp"

namespace physim {
namespace {

using units::operator""_in, units::operator""_lb;
constexpr double kUnitGravity = 9.80665;             // by which weights are forces, exact [m/s^2]
constexpr double kPoundForce = 1_lb * kUnitGravity;  // [N]

constexpr Unit kNumber[] = {{""}, {"%", 1, 0, 100}};
constexpr Unit kLength[] = {{"m"},        {"um", 1e-6},   {"mm", 1e-3},   {"cm", 1e-2},     {"km", 1e3},
                            {"in", 1_in}, {"ft", 0.3048}, {"yd", 0.9144}, {"mi", 1609.344}, {"nmi", 1852}};
constexpr Unit kMass[] = {{"kg"},
                          {"g", 1e-3},
                          {"mg", 1e-6},
                          {"gr", 6.479891e-5},
                          {"lb", 1_lb},
                          {"oz", 0.028349523125},
                          {"slug", kPoundForce / 0.3048},
                          {"t", 1000}};
constexpr Unit kTime[] = {{"s"}, {"ms", 1e-3}, {"us", 1e-6}, {"min", 60}, {"h", 3600}};
constexpr Unit kSpeed[] = {
    {"m/s"},       {"km/h", 1.0 / 3.6},        {"ft/s", 0.3048}, {"mph", 0.44704}, {"kn", 1852.0 / 3600.0},
    {"km/s", 1e3}, {"fps", 0.3048, 0, 1, true}};
constexpr Unit kAngle[] = {{"rad"},
                           {"deg", kPi / 180},
                           {"mrad", 1e-3},
                           {"mil", 1e-3},  // the milliradian of rifle scopes, not the 6400th of a turn
                           {"moa", kPi / 10800},
                           {"MOA", kPi / 10800, 0, 1, true}};
constexpr Unit kAcceleration[] = {{"m/s^2"}, {"ft/s^2", 0.3048}, {"g0", kUnitGravity}, {"g", kUnitGravity, 0, 1, true}};
constexpr Unit kForce[] = {{"N"}, {"kN", 1e3}, {"lbf", kPoundForce}, {"kgf", kUnitGravity}};
constexpr Unit kPressure[] = {{"Pa"},
                              {"hPa", 100},
                              {"kPa", 1000},
                              {"MPa", 1e6},
                              {"bar", 1e5},
                              {"mbar", 100},
                              {"atm", 101325},
                              {"inHg", 3386.389},       // at 0 degC, NIST SP 811
                              {"mmHg", 133.322387415},  // at 0 degC
                              {"psi", kPoundForce / (1_in * 1_in)}};
constexpr Unit kTemperature[] = {{"K"}, {"degC", 1, 273.15}, {"degF", 5, 459.67, 9}, {"degR", 5, 0, 9}};
constexpr Unit kDensity[] = {{"kg/m^3"}, {"g/cm^3", 1000}, {"lb/ft^3", 1_lb / (0.3048 * 0.3048 * 0.3048)}};
constexpr Unit kBallisticCoefficient[] = {{"kg/m^2"}, {"lb/in^2", 1_lb / (1_in * 1_in)}};
constexpr Unit kLinearDrag[] = {{"kg/s"}, {"N s/m", 1, 0, 1, true}};
constexpr Unit kQuadraticDrag[] = {{"kg/m"}};
constexpr Unit kAngularRate[] = {{"rad/s"}, {"deg/s", kPi / 180}, {"rpm", kPi / 30}};
constexpr Unit kEnergy[] = {
    {"J"}, {"kJ", 1e3}, {"ft lbf", 0.3048 * kPoundForce}, {"ft-lbf", 0.3048 * kPoundForce, 0, 1, true}};
constexpr Unit kFrequency[] = {{"1/s"}, {"Hz", 1, 0, 1, true}, {"1/min", 1, 0, 60}, {"rpm", 1, 0, 60}};
constexpr Unit kStiffness[] = {{"N/m"}, {"N/mm", 1e3}, {"lbf/in", kPoundForce / 1_in}};
constexpr Unit kVolume[] = {{"m^3"}, {"l", 1e-3}, {"cm^3", 1e-6}, {"in^3", 1_in * 1_in * 1_in}};
constexpr Unit kAttraction[] = {{"m^3/s^2"}, {"km^3/s^2", 1e9}};

constexpr Unit kMomentOfInertia[] = {{"kg m^2"},
                                     {"g cm^2", 1e-7},
                                     {"g mm^2", 1e-9},
                                     {"lb in^2", 1_lb * 1_in * 1_in},
                                     {"lb ft^2", 1_lb * 0.3048 * 0.3048},
                                     {"slug ft^2", kPoundForce * 0.3048}};

constexpr Unit kArea[] = {{"m^2"}, {"cm^2", 1e-4}, {"mm^2", 1e-6}, {"in^2", 1_in * 1_in}, {"ft^2", 0.3048 * 0.3048}};

constexpr Unit kJerk[] = {{"m/s^3"}, {"ft/s^3", 0.3048}};

constexpr std::array kQuantities = {
    QuantityInfo{Quantity::number, "a plain number", "0.5", kNumber},
    QuantityInfo{Quantity::length, "a length", "7.82 mm", kLength},
    QuantityInfo{Quantity::mass, "a mass", "168 gr", kMass},
    QuantityInfo{Quantity::time, "a time", "2.5 s", kTime},
    QuantityInfo{Quantity::speed, "a speed", "800 m/s", kSpeed},
    QuantityInfo{Quantity::angle, "an angle", "2 deg", kAngle},
    QuantityInfo{Quantity::acceleration, "an acceleration", "9.80665 m/s^2", kAcceleration},
    QuantityInfo{Quantity::force, "a force", "10 N", kForce},
    QuantityInfo{Quantity::pressure, "a pressure", "1013.25 hPa", kPressure},
    QuantityInfo{Quantity::temperature, "a temperature", "15 degC", kTemperature},
    QuantityInfo{Quantity::density, "a density", "1.225 kg/m^3", kDensity},
    QuantityInfo{Quantity::ballistic_coefficient, "a ballistic coefficient", "0.243 lb/in^2", kBallisticCoefficient},
    QuantityInfo{Quantity::linear_drag, "a linear drag factor", "0.1 kg/s", kLinearDrag},
    QuantityInfo{Quantity::quadratic_drag, "a quadratic drag factor", "0.001 kg/m", kQuadraticDrag},
    QuantityInfo{Quantity::angular_rate, "an angular rate", "7.292115e-5 rad/s", kAngularRate},
    QuantityInfo{Quantity::energy, "an energy", "3500 J", kEnergy},
    QuantityInfo{Quantity::frequency, "a rate", "600 rpm", kFrequency},
    QuantityInfo{Quantity::stiffness, "a stiffness", "50 N/m", kStiffness},
    QuantityInfo{Quantity::volume, "a volume", "2.5 l", kVolume},
    QuantityInfo{Quantity::attraction, "an attraction (G M)", "2000 m^3/s^2", kAttraction},
    QuantityInfo{Quantity::moment_of_inertia, "a moment of inertia", "0.02326 kg m^2", kMomentOfInertia},
    QuantityInfo{Quantity::area, "an area", "45 mm^2", kArea},
    QuantityInfo{Quantity::jerk, "a jerk", "2 m/s^3", kJerk},
};

constexpr bool in_order_of_values() {
  for (std::size_t i = 0; i < kQuantities.size(); ++i)
    if (kQuantities[i].quantity != static_cast<Quantity>(i)) return false;
  return kQuantities.size() == static_cast<std::size_t>(kLastQuantity) + 1;
}
static_assert(in_order_of_values(), "info() reads this table by the value of the quantity");

}  // namespace

std::span<const QuantityInfo> all_quantities() { return kQuantities; }

bool is_named(Quantity quantity) { return static_cast<std::size_t>(quantity) < kQuantities.size(); }

const QuantityInfo& info(Quantity quantity) {
  PHYSIM_ASSERT(is_named(quantity));
  return kQuantities[static_cast<std::size_t>(quantity)];
}

std::string number_text(double value) {
  char buffer[64];
  const double size = std::abs(value);
  const bool readable = value == 0 || (size >= 1e-3 && size < 1e9);  // without an exponent
  const bool is_long = size >= 0x1p63;                               // TOML refuses such digits without an exponent
  const auto done = readable  ? std::to_chars(buffer, std::end(buffer), value, std::chars_format::fixed)
                    : is_long ? std::to_chars(buffer, std::end(buffer), value, std::chars_format::scientific)
                              : std::to_chars(buffer, std::end(buffer), value);
  PHYSIM_ASSERT(done.ec == std::errc());
  return {buffer, done.ptr};
}

std::string quantity_text(double value, Quantity quantity) {
  const std::string_view unit = si_unit(quantity);
  return unit.empty() ? number_text(value) : number_text(value) + " " + std::string(unit);
}

std::string quantity_in_words(double value, Quantity quantity) {
  constexpr int kDigits = 9;
  char buffer[64];
  const auto done = std::to_chars(buffer, std::end(buffer), value, std::chars_format::general, kDigits);
  double rounded = value;
  std::from_chars(buffer, done.ptr, rounded);
  return quantity_text(rounded, quantity);
}

}  // namespace physim
