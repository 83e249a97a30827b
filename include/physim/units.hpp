// Unit literals: 168_gr, 800_mps, 2_deg, 0.243_lb_in2. Every literal is a double in SI units.
#pragma once

namespace physim::units {

constexpr double operator""_kg(long double v) { return static_cast<double>(v) * (1.0); }  // mass [kg]
constexpr double operator""_kg(unsigned long long v) { return static_cast<double>(v) * (1.0); }
constexpr double operator""_g(long double v) { return static_cast<double>(v) * (1e-3); }
constexpr double operator""_g(unsigned long long v) { return static_cast<double>(v) * (1e-3); }
constexpr double operator""_gr(long double v) {
  return static_cast<double>(v) * (6.479891e-5);
}  // grain, exact: 64.79891 mg
constexpr double operator""_gr(unsigned long long v) { return static_cast<double>(v) * (6.479891e-5); }
constexpr double operator""_lb(long double v) { return static_cast<double>(v) * (0.45359237); }  // pound, exact
constexpr double operator""_lb(unsigned long long v) { return static_cast<double>(v) * (0.45359237); }
constexpr double operator""_oz(long double v) { return static_cast<double>(v) * (0.028349523125); }  // ounce, exact
constexpr double operator""_oz(unsigned long long v) { return static_cast<double>(v) * (0.028349523125); }
constexpr double operator""_m(long double v) { return static_cast<double>(v) * (1.0); }  // length [m]
constexpr double operator""_m(unsigned long long v) { return static_cast<double>(v) * (1.0); }
constexpr double operator""_mm(long double v) { return static_cast<double>(v) * (1e-3); }
constexpr double operator""_mm(unsigned long long v) { return static_cast<double>(v) * (1e-3); }
constexpr double operator""_cm(long double v) { return static_cast<double>(v) * (1e-2); }
constexpr double operator""_cm(unsigned long long v) { return static_cast<double>(v) * (1e-2); }
constexpr double operator""_km(long double v) { return static_cast<double>(v) * (1e3); }
constexpr double operator""_km(unsigned long long v) { return static_cast<double>(v) * (1e3); }
constexpr double operator""_in(long double v) { return static_cast<double>(v) * (0.0254); }
constexpr double operator""_in(unsigned long long v) { return static_cast<double>(v) * (0.0254); }
constexpr double operator""_ft(long double v) { return static_cast<double>(v) * (0.3048); }
constexpr double operator""_ft(unsigned long long v) { return static_cast<double>(v) * (0.3048); }
constexpr double operator""_yd(long double v) { return static_cast<double>(v) * (0.9144); }
constexpr double operator""_yd(unsigned long long v) { return static_cast<double>(v) * (0.9144); }
constexpr double operator""_mi(long double v) { return static_cast<double>(v) * (1609.344); }
constexpr double operator""_mi(unsigned long long v) { return static_cast<double>(v) * (1609.344); }
constexpr double operator""_mps(long double v) { return static_cast<double>(v) * (1.0); }  // speed [m/s]
constexpr double operator""_mps(unsigned long long v) { return static_cast<double>(v) * (1.0); }
constexpr double operator""_kmh(long double v) { return static_cast<double>(v) * (1.0 / 3.6); }
constexpr double operator""_kmh(unsigned long long v) { return static_cast<double>(v) * (1.0 / 3.6); }
constexpr double operator""_fps(long double v) { return static_cast<double>(v) * (0.3048); }
constexpr double operator""_fps(unsigned long long v) { return static_cast<double>(v) * (0.3048); }
constexpr double operator""_mph(long double v) { return static_cast<double>(v) * (0.44704); }
constexpr double operator""_mph(unsigned long long v) { return static_cast<double>(v) * (0.44704); }
constexpr double operator""_kn(long double v) { return static_cast<double>(v) * (1852.0 / 3600.0); }
constexpr double operator""_kn(unsigned long long v) { return static_cast<double>(v) * (1852.0 / 3600.0); }
constexpr double operator""_rad(long double v) { return static_cast<double>(v) * (1.0); }  // angle [rad]
constexpr double operator""_rad(unsigned long long v) { return static_cast<double>(v) * (1.0); }
constexpr double operator""_deg(long double v) { return static_cast<double>(v) * (3.14159265358979323846 / 180.0); }
constexpr double operator""_deg(unsigned long long v) {
  return static_cast<double>(v) * (3.14159265358979323846 / 180.0);
}
constexpr double operator""_mrad(long double v) { return static_cast<double>(v) * (1e-3); }
constexpr double operator""_mrad(unsigned long long v) { return static_cast<double>(v) * (1e-3); }
constexpr double operator""_moa(long double v) {
  return static_cast<double>(v) * (3.14159265358979323846 / 10800.0);
}  // minute of angle
constexpr double operator""_moa(unsigned long long v) {
  return static_cast<double>(v) * (3.14159265358979323846 / 10800.0);
}
constexpr double operator""_s(long double v) { return static_cast<double>(v) * (1.0); }  // time [s]
constexpr double operator""_s(unsigned long long v) { return static_cast<double>(v) * (1.0); }
constexpr double operator""_ms(long double v) { return static_cast<double>(v) * (1e-3); }
constexpr double operator""_ms(unsigned long long v) { return static_cast<double>(v) * (1e-3); }
constexpr double operator""_min(long double v) { return static_cast<double>(v) * (60.0); }
constexpr double operator""_min(unsigned long long v) { return static_cast<double>(v) * (60.0); }
constexpr double operator""_Pa(long double v) { return static_cast<double>(v) * (1.0); }  // pressure [Pa]
constexpr double operator""_Pa(unsigned long long v) { return static_cast<double>(v) * (1.0); }
constexpr double operator""_hPa(long double v) { return static_cast<double>(v) * (100.0); }
constexpr double operator""_hPa(unsigned long long v) { return static_cast<double>(v) * (100.0); }
constexpr double operator""_kPa(long double v) { return static_cast<double>(v) * (1000.0); }
constexpr double operator""_kPa(unsigned long long v) { return static_cast<double>(v) * (1000.0); }
constexpr double operator""_inHg(long double v) {
  return static_cast<double>(v) * (3386.389);
}  // inch of mercury at 0 degC
constexpr double operator""_inHg(unsigned long long v) { return static_cast<double>(v) * (3386.389); }
constexpr double operator""_K(long double v) { return static_cast<double>(v) * (1.0); }  // temperature [K]
constexpr double operator""_K(unsigned long long v) { return static_cast<double>(v) * (1.0); }
constexpr double operator""_kg_m2(long double v) {
  return static_cast<double>(v) * (1.0);
}  // ballistic coefficient [kg/m^2]
constexpr double operator""_kg_m2(unsigned long long v) { return static_cast<double>(v) * (1.0); }
constexpr double operator""_lb_in2(long double v) { return static_cast<double>(v) * (0.45359237 / (0.0254 * 0.0254)); }
constexpr double operator""_lb_in2(unsigned long long v) {
  return static_cast<double>(v) * (0.45359237 / (0.0254 * 0.0254));
}
constexpr double operator""_kg_m3(long double v) { return static_cast<double>(v) * (1.0); }  // density [kg/m^3]
constexpr double operator""_kg_m3(unsigned long long v) { return static_cast<double>(v) * (1.0); }
constexpr double operator""_N(long double v) { return static_cast<double>(v) * (1.0); }  // force [N]
constexpr double operator""_N(unsigned long long v) { return static_cast<double>(v) * (1.0); }

// Temperatures with an offset.
constexpr double operator""_degC(long double v) { return static_cast<double>(v) + 273.15; }
constexpr double operator""_degC(unsigned long long v) { return static_cast<double>(v) + 273.15; }
constexpr double operator""_degF(long double v) { return (static_cast<double>(v) + 459.67) * 5.0 / 9.0; }
constexpr double operator""_degF(unsigned long long v) { return (static_cast<double>(v) + 459.67) * 5.0 / 9.0; }

}  // namespace physim::units
