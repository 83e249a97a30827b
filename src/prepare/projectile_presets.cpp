// Presets of projectiles, each with the source of its numbers.
#include "physim/body.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include "base/assert.hpp"
#include "base/ieee_mode.hpp"
#include "math/angles.hpp"
#include "math/elementary.hpp"
#include "physim/units.hpp"

namespace physim {
namespace presets {
namespace {

using namespace units;

constexpr double kStandardGravity = 9.80665;  // [m/s^2]
constexpr double kRpm = kPi / 30;             // [rad/s]

// The original had one drag force for all of its shots. Its coefficients are not published: our choice. k2 is that of
// the corrected test 3; k1 is felt where a shot begins to move.
constexpr double kOriginalK1 = 0.1;  // [kg/s]
constexpr double kOriginalK2 = 0.4;  // [kg/m]

/// A shot of the original at its elevation setting 2, removed where the original removed it.
ProjectilePreset original(const char* name, double mass, double damping, double gravity, double speed, const char* doc,
                          const char* source) {
  const IeeeMode mode;
  return {.projectile = {.name = name,
                         .mass = mass,
                         .drag = {.damping = damping, .k1 = kOriginalK1, .k2 = kOriginalK2},
                         .gravity_scale = gravity / kStandardGravity,
                         .fidelity = Fidelity::classic()},
          .body = {.despawn = {.below = -5, .farther = 100}},
          .speed = speed,
          .doc = doc,
          .source = std::string("client of the original PhySim (2017): ") + source};
}

/// Cd and Cl at one speed [m/s] and 2000, 3000, 4000, 5000 and 6000 rpm.
struct GolfRow {
  double speed;
  double at[5][2];
};
// P. W. Bearman, J. K. Harvey, "Golf ball aerodynamics", Aeronautical Quarterly 27 (1976) 112-122, fig. 7 and 8: a ball
// with hexagonal dimples in a wind tunnel.
constexpr GolfRow kGolf[] = {
    {13.7, {{0.3624, 0.104}, {0.4203, 0.3624}, {0.4288, 0.4005}, {0.4848, 0.413}, {0.518, 0.4644}}},
    {21.6, {{0.2885, 0.1846}, {0.3658, 0.3362}, {0.4003, 0.364}, {0.4314, 0.3894}, {0.4406, 0.4227}}},
    {29.9, {{0.2765, 0.246}, {0.3169, 0.3049}, {0.349, 0.3347}, {0.3728, 0.3496}, {0.3882, 0.3724}}},
    {38.4, {{0.2529, 0.1984}, {0.2822, 0.2475}, {0.3084, 0.2862}, {0.3316, 0.3119}, {0.3517, 0.3393}}},
    {46.9, {{0.2472, 0.1762}, {0.2655, 0.2073}, {0.2852, 0.2384}, {0.3062, 0.2695}, {0.3285, 0.3005}}},
    {55.2, {{0.2481, 0.1538}, {0.2578, 0.1856}, {0.271, 0.2149}, {0.2876, 0.2418}, {0.3076, 0.2662}}},
    {63.1, {{0.2467, 0.1418}, {0.256, 0.1702}, {0.2659, 0.1977}, {0.2765, 0.2246}, {0.2877, 0.2507}}},
    {71.9, {{0.247, 0.136}, {0.255, 0.1584}, {0.263, 0.1807}, {0.271, 0.2031}, {0.279, 0.2254}}},
    {80.2, {{0.247, 0.128}, {0.2538, 0.1485}, {0.2605, 0.169}, {0.2673, 0.1895}, {0.274, 0.21}}},
    {88.1, {{0.247, 0.1276}, {0.2538, 0.1464}, {0.2605, 0.1582}, {0.2673, 0.1791}, {0.274, 0.2}}},
};

constexpr double kGolfDiameter = 42.67_mm;  // the least that the rules of golf allow [m]

struct GolfCoefficients {
  double cd;  // [-]
  double cl;  // [-]
};

/// Linear between points, held outside of them.
template <std::size_t N>
double on_line(const double (&points)[N][2], double x) {
  std::size_t i = 1;
  while (i + 1 < N && x > points[i][0]) ++i;
  const auto& [x0, y0] = points[i - 1];
  const auto& [x1, y1] = points[i];
  return y0 + (y1 - y0) * clamp((x - x0) / (x1 - x0), 0.0, 1.0);
}

/// Balls of today at little spin: the mean of two sets of measurements on flying balls. B. Lieberman et al., US patent
/// 6 186 002 (2001), the indoor range of the USGA: regressions over Re 0.8e5 to 2e5 and S 0.04 to 0.22. B. Lyu et al.,
/// "Aerodynamics of golf balls in still air", Proceedings 2 (2018) 238, fig. 3a and 4a: the mean of 13 models, read
/// off, with the growth of Cd with S of the former. By speed [m/s] and spin parameter.
GolfCoefficients golf_ball_of_today(double speed, double parameter) {
  constexpr double kViscosity = 1.5e-5;  // kinematic, of air [m^2/s]
  const double s = parameter, re = speed * kGolfDiameter / kViscosity / 1e5;
  constexpr double kDrag[][2] = {{0.5, 0.477}, {0.75, 0.302}, {1, 0.215},   {1.26, 0.205},
                                 {1.5, 0.196}, {1.75, 0.199}, {2.2, 0.199}, {2.5, 0.21}};
  constexpr double kLift[][2] = {{0, 0}, {0.045, 0.1}, {0.075, 0.13}, {0.105, 0.17}, {0.185, 0.25}, {0.32, 0.315}};
  const double by_spin = 2.8466 * s * s - 0.2159 * s;
  const double cd = 0.2028 + 0.0165 * re + by_spin, cl = 0.0860 + 0.6463 * s - 0.0122 / (re * re) + 1.4789 * s * s;
  return {0.5 * (cd + on_line(kDrag, re) + max(by_spin, 0.0)), 0.5 * (cl + on_line(kLift, s))};
}

/// The table of Bearman and Harvey for spin parameters over 0.15, balls of today below 0.1 where Re is over 80 000.
void add_golf_table(MagnusDef& m) {
  for (const GolfRow& row : kGolf)
    for (const double rpm : {1000.0, 1500.0, 2000.0, 2500.0, 3000.0, 3500.0, 4000.0, 5000.0, 6000.0}) {
      const double place = max(rpm / 1000 - 2, 0.0), part = place - floor(place);
      const auto at = static_cast<int>(place);
      const auto& [cd, cl] = row.at[at];
      const auto& [cd_next, cl_next] = row.at[std::min(at + 1, 4)];
      const double parameter = rpm * kRpm * (kGolfDiameter / 2) / row.speed;
      const auto [cd_today, cl_today] = golf_ball_of_today(row.speed, parameter);
      constexpr double kSlowest = 28;  // Re 80 000 [m/s]
      const double today = row.speed < kSlowest ? 0 : clamp((0.15 - parameter) / 0.05, 0.0, 1.0);
      const double drag = cd + part * (cd_next - cd), lift = (cl + part * (cl_next - cl)) * min(rpm / 2000, 1.0);
      m.table.push_back({row.speed, rpm * kRpm, drag + today * (cd_today - drag), lift + today * (cl_today - lift)});
    }
}

/// J. E. Goff, M. J. Carre, "Soccer ball lift coefficients via trajectory analysis", European Journal of Physics 31
/// (2010) 775-784: the fall of Cd at the drag crisis, and its growth with the spin parameter above it.
double football_drag(double speed, double parameter) {
  if (speed > 12.19 && parameter > 0.05) return 0.4127 * pow(parameter, 0.3056);
  return 0.155 + 0.346 / (1 + exp((speed - 12.19) / 1.309));
}

/// Between two numbers that stand at x0 and x1, held outside.
double between(double x, double x0, double y0, double x1, double y1) {
  PHYSIM_ASSERT(x0 < x1);
  return y0 + (y1 - y0) * std::clamp((x - x0) / (x1 - x0), 0.0, 1.0);
}

// C. Conti, B. Yang, A. Sigrist, L. Miele, Y. Saraiji, P. Duerr, N. Takahashi, "Physics Models for Sim-to-Real Transfer
// in Professional-Level Robot Table Tennis" (2026), arXiv:2606.28805: fits to balls in play. Straight lines between.

/// Cd at one speed [m/s] by the spin parameter.
struct TableTennisDrag {
  double speed;
  double parameter[6];
  double cd[6];

  [[nodiscard]] double at(double s) const {
    int i = 0;
    while (i < 4 && s > parameter[i + 1]) ++i;
    return between(s, parameter[i], cd[i], parameter[i + 1], cd[i + 1]);
  }
};
constexpr TableTennisDrag kTableTennisDrag[] = {
    {2.5, {0, 0.3, 0.7, 0.95, 1.5, 2}, {0.55, 0.55, 0.55, 0.55, 0.55, 0.55}},
    {7.5, {0, 0.4, 0.75, 1.1, 1.3, 2}, {0.49, 0.49, 0.55, 0.48, 0.53, 0.53}},
    {12.5, {0, 0.4, 0.62, 0.95, 1.3, 2}, {0.47, 0.47, 0.53, 0.41, 0.48, 0.48}},
    {17.5, {0, 0.4, 0.5, 0.84, 1.2, 2}, {0.47, 0.47, 0.51, 0.37, 0.45, 0.45}},
};

/// CM at one speed [m/s] by the spin [rad/s]: level + slope spin up to `until`, then (square spin + linear) spin +
/// rest, above 0. The lift is CM rho V omega x u, V the volume, so that Cl = 8/3 CM S.
struct TableTennisLift {
  double speed;
  double level, slope, until;
  double square, linear, rest;

  [[nodiscard]] double at(double spin) const {
    return std::max(spin < until ? level + slope * spin : (square * spin + linear) * spin + rest, 0.0);
  }
};
constexpr TableTennisLift kTableTennisLift[] = {
    {2, 0.080, 0, 150, -1.852e-7, -1.296e-4, 0.0983},
    {3.5, 0.310, -1.10e-3, 200, -1.667e-7, -3.333e-5, 0.1000},
    {7.5, 0.370, -8.00e-4, 350, -2.000e-7, 1.700e-4, 0.0587},
    {10.5, 0.375, -6.58e-4, 440, -2.604e-7, 3.646e-4, -0.0225},
    {13.5, 0.383, -5.60e-4, 550, -3.571e-7, 5.357e-4, -0.0893},
    {17, 0.371, -4.48e-4, 650, -1.000e-7, 2.300e-4, -0.0375},
};

/// At any speed, `x` being the spin or the spin parameter.
template <class Row, std::size_t kRows>
double at_speed(const Row (&rows)[kRows], double speed, double x) {
  std::size_t i = 0;
  while (i + 2 < kRows && speed > rows[i + 1].speed) ++i;
  return between(speed, rows[i].speed, rows[i].at(x), rows[i + 1].speed, rows[i + 1].at(x));
}

}  // namespace

ProjectilePreset artillery() {
  return original("artillery", 200, 0.9, 20, std::hypot(4.0, 40.0),
                  "the original's artillery shell: 200 kg, gravity 20 m/s^2, damping 0.9",
                  "(0, 2 e, 40) m/s at elevation setting e = 2");
}

ProjectilePreset bullet() {
  return original("bullet", 2, 0.9, 2, std::hypot(2.0, 35.0),
                  "the original's bullet: 2 kg, gravity 2 m/s^2, damping 0.9",
                  "(0, e, 35) m/s at elevation setting e = 2");
}

ProjectilePreset laser() {
  return original("laser", 1, 1, 0, std::hypot(2.0, 35.0), "the original's laser: neither gravity nor drag",
                  "(0, e, 35) m/s at elevation setting e = 2");
}

ProjectilePreset sphere() {
  return {.projectile = {.name = "sphere", .drag = {.table = DragTable::sphere}},
          .speed = 40,
          .doc = "a plain smooth ball of 1 kg and 10 cm",
          .source = "mass, size and speed: the library's own; Cd by Reynolds number: Morrison (2013)"};
}

ProjectilePreset rifle_bullet() {
  return {
      .projectile = {.name = "rifle_bullet",
                     .mass = 168_gr,
                     .diameter = 0.308_in,
                     .length = 1.226_in,
                     .twist = 12_in,
                     .drag = {.table = DragTable::g7, .ballistic_coefficient = 0.218_lb_in2}},
      .body = {.restitution = 0.2},
      .speed = 2700_fps,
      .doc = ".308 Winchester, 168 gr match bullet",
      .source = "G7: B. Litz, Applied Ballistics for Long-Range Shooting (2009); size and twist: McCoy (1999), ch. 9"};
}

ProjectilePreset arrow() {
  return {.projectile = {.name = "arrow", .mass = 18.5_g, .diameter = 5.2_mm, .drag = {.coefficient = 2.05}},
          .body = {.restitution = 0},
          .speed = 56.4,
          .doc = "Olympic recurve arrow with large vanes",
          .source = "Cd and speed: Ortiz et al., Proceedings 49 (2020) 56; mass and diameter: typical, our choice"};
}

ProjectilePreset grenade() {
  return {
      .projectile = {.name = "grenade", .mass = 14_oz, .diameter = 2.5_in, .drag = {.table = DragTable::sphere}},
      .body = {.restitution = 0.3, .friction = 0.3, .rolling_resistance = 0.1, .despawn = {.older = 4.5}},
      .speed = 18.5,
      .doc = "hand grenade, 14 oz, gone after 4.5 s",
      .source =
          "mass, diameter, fuze of 4 to 5 s and a throw of about 35 m: M67, US Army FM 3-23.30; bounces: our choice"};
}

ProjectilePreset paintball() {
  return {.projectile = {.name = "paintball", .mass = 3_g, .diameter = 0.68_in, .drag = {.table = DragTable::sphere}},
          .body = {.restitution = 0},
          .speed = 280_fps,
          .doc = "paintball of calibre .68",
          .source = "mass and speed: typical, our choice; Cd by Reynolds number: Morrison (2013)"};
}

ProjectilePreset tennis_ball() {
  return {.projectile = {.name = "tennis_ball",
                         .mass = 57.7_g,
                         .diameter = 66.1_mm,
                         .drag = {.coefficient = 0.507},
                         .magnus = {.lift = 1, .lift_base = 1, .lift_saturation = 2}},
          // Less friction than of a ball that slides: it soon rolls, which a point mass does not know.
          .body = {.restitution = 0.745, .friction = 0.2},
          .speed = 120_mph,
          .doc = "tennis ball, served",
          .source =
              "Cd: Cross and Lindsey (2014); Cl 1 / (2 + v / (r omega)): Stepanek (1988), Cross and Lindsey; mass, "
              "size and bounce (141 cm from 254 cm): middle of the rules of tennis"};
}

ProjectilePreset golf_ball() {
  const IeeeMode mode;
  ProjectilePreset p;
  p.projectile = {.name = "golf_ball", .mass = 45.93_g, .diameter = kGolfDiameter, .drag = {.coefficient = 0.25}};
  MagnusDef& m = p.projectile.magnus;
  add_golf_table(m);
  m.decay_time = 24;
  p.body = {.restitution = 0.6, .friction = 0.4};
  p.speed = 167_mph;
  p.doc = "golf ball off a driver; its spin by the launch";
  p.source =
      "Cd and Cl: Bearman and Harvey (1976), below a spin parameter of 0.15 Lieberman et al. (2001) and Lyu et al. "
      "(2018); spin decay 2e-5 v / r at 45 m/s: Smits and Smith (1994); mass and size: "
      "the rules of golf; speed: tour average (TrackMan); bounces: our choice";
  return p;
}

ProjectilePreset baseball() {
  const IeeeMode mode;
  return {.projectile = {.name = "baseball",
                         .mass = 5.125_oz,
                         .diameter = 9.125_in / kPi,
                         .drag = {.coefficient = 0.3008},
                         .magnus = {.lift = 1.120,
                                    .lift_base = 0.583,
                                    .lift_saturation = 2.333,
                                    .drag_per_spin = 0.0292 / 1000 / kRpm}},
          .body = {.restitution = 0.5, .friction = 0.4},
          .speed = 103_mph,
          .doc = "baseball, batted; its spin by the launch",
          .source =
              "Cd, Cl, mass and size: A. M. Nathan's trajectory calculator and Am. J. Phys. 76 (2008) 119; bounces: "
              "our choice"};
}

ProjectilePreset football() {
  const IeeeMode mode;
  ProjectilePreset p;
  p.projectile = {.name = "football", .mass = 0.43, .diameter = 0.22, .drag = {.coefficient = 0.155}};
  MagnusDef& m = p.projectile.magnus;
  m.measure = SpinMeasure::parameter;
  for (const double speed : {5.0, 7.0, 9.0, 10.0, 11.0, 12.0, 12.19, 12.2, 13.0, 14.0, 15.0, 17.0, 20.0, 40.0})
    for (const double s : {0.0, 0.05, 0.0501, 0.1, 0.15, 0.2, 0.3, 0.4})
      m.table.push_back({speed, s, football_drag(speed, s), 1.04 * s});
  p.body = {.restitution = 0.7, .friction = 0.5};
  p.speed = 25;
  p.doc = "football (soccer), kicked; its spin by the launch";
  p.source =
      "Cd: Goff and Carre (2010); Cl 1.04 S, which is 0.26 at the 0.23-0.29 of Bray and Kerwin (2003) for free kicks; "
      "mass and size: the laws of the game; bounces: our choice";
  return p;
}

ProjectilePreset table_tennis_ball() {
  const IeeeMode mode;
  ProjectilePreset p;
  p.projectile = {.name = "table_tennis_ball", .mass = 2.7_g, .diameter = 40_mm, .drag = {.coefficient = 0.47}};
  MagnusDef& m = p.projectile.magnus;
  for (const double speed :
       {2.0, 2.5, 3.0, 3.5, 4.25, 5.0, 6.0, 7.5, 9.0, 10.5, 12.5, 13.5, 15.0, 17.0, 17.5, 20.0, 25.0, 30.0, 35.0})
    for (double spin = 0; spin <= 1200; spin += 50) {
      const double parameter = 0.5 * p.projectile.diameter * spin / speed;
      m.table.push_back({speed, spin, at_speed(kTableTennisDrag, speed, parameter),
                         8.0 / 3 * at_speed(kTableTennisLift, speed, spin) * parameter});
    }
  p.body = {.restitution = 0.905, .friction = 0.25};
  p.speed = 15;
  p.doc = "table-tennis ball, played; its spin by the launch";
  p.source =
      "Cd and Cl with the lift crisis, and friction: Conti et al. (2026), arXiv:2606.28805; mass, size and bounce "
      "(25 cm from 30.5 cm): the rules of table tennis; speed: our choice";
  return p;
}

}  // namespace presets

namespace {

struct Named {
  std::string_view name;
  ProjectilePreset (*make)();
};

constexpr Named kProjectiles[] = {
    {"artillery", presets::artillery},
    {"bullet", presets::bullet},
    {"laser", presets::laser},
    {"sphere", presets::sphere},
    {"rifle_bullet", presets::rifle_bullet},
    {"arrow", presets::arrow},
    {"grenade", presets::grenade},
    {"paintball", presets::paintball},
    {"tennis_ball", presets::tennis_ball},
    {"golf_ball", presets::golf_ball},
    {"baseball", presets::baseball},
    {"football", presets::football},
    {"table_tennis_ball", presets::table_tennis_ball},
};

}  // namespace

std::span<const std::string_view> projectile_presets() {
  static constexpr auto names = [] {
    std::array<std::string_view, std::size(kProjectiles)> all;
    for (std::size_t i = 0; i < all.size(); ++i) all[i] = kProjectiles[i].name;
    return all;
  }();
  return names;
}

std::optional<ProjectilePreset> projectile_preset(std::string_view name) {
  const IeeeMode mode;
  for (const Named& preset : kProjectiles)
    if (preset.name == name) return preset.make();
  return std::nullopt;
}

}  // namespace physim
