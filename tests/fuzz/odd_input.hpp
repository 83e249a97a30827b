// Random input for every public call: mostly sensible, now and then what nobody should hand in.
#pragma once

#include <utility>

#include "fuzz/extremes.hpp"

namespace physim::test {

/// How many enumerators there are; the numbers beyond are no values.
template <class Enum>
int count_of() {
  return static_cast<int>(names_of<Enum>().size());
}

class Odd : public Random {
 public:
  /// One number in `rarity` is odd; 0: none.
  Odd(std::uint64_t seed, int rarity) : Random(seed), rarity_(rarity) {}

  bool is_odd() { return rarity_ > 0 && one_in(rarity_); }
  bool coin() { return one_in(2); }
  double number(double low, double high) {
    constexpr double kInf = std::numeric_limits<double>::infinity();
    constexpr double kOdd[] = {std::numeric_limits<double>::quiet_NaN(),
                               kInf,
                               -kInf,
                               0,
                               -0.0,
                               -1,
                               1e308,
                               -1e308,
                               1e18,
                               -1e9,
                               std::numeric_limits<double>::min(),
                               std::numeric_limits<double>::denorm_min(),
                               1e-30,
                               1e300};
    if (!is_odd()) return in(low, high);
    return coin() ? kOdd[below(std::size(kOdd))] : extreme(*this, in(low, high));
  }
  Vec3d vector3(double size) { return {number(-size, size), number(-size, size), number(-size, size)}; }
  std::optional<double> maybe(double low, double high) {
    return one_in(3) ? std::optional(number(low, high)) : std::nullopt;
  }
  std::uint32_t count(int most) {
    constexpr std::uint32_t kOdd[] = {0xffffffffu, 0x80000000u, 0x7fffffffu, 0};
    return is_odd() ? kOdd[below(std::size(kOdd))] : static_cast<std::uint32_t>(below(most + 1));
  }
  template <class Enum>
  Enum any() {
    const int n = count_of<Enum>();
    const int odd[] = {-1, n, 255, 128, n + 1};
    return static_cast<Enum>(is_odd() ? odd[below(std::size(odd))] : below(n));
  }
  std::string text() {
    const char* const texts[] = {"", "a ball", "\xff\xfe", "g7", "nan", "line\nbreak", "game"};
    return one_in(50) ? std::string(1000, 'x') : texts[below(std::size(texts))];
  }

  Fidelity fidelity() {
    const auto names = fidelity_presets();
    if (!one_in(3)) return *fidelity_preset(names[static_cast<std::size_t>(below(static_cast<int>(names.size())))]);
    return {.motion = any<Motion>(),
            .integrator = any<Integrator>(),
            .gravity = any<GravityModel>(),
            .drag = any<DragModel>(),
            .air = any<AirModel>(),
            .wind = any<WindModel>(),
            .earth = any<EarthModel>(),
            .rotation = any<RotationModel>(),
            .body_form = any<BodyForm>(),
            .precision = any<Precision>(),
            .interpolation = any<Interpolation>(),
            .planar = one_in(8),
            .aerodynamic_jump = one_in(8),
            .original_one_shot_forces = one_in(8)};
  }
  DragDef drag() {
    DragDef d = random_drag(*this);
    if (!one_in(3)) return d;
    d.table = any<DragTable>();
    d.coefficient = number(0, 1);
    for (int i = 0, n = below(4); i < n; ++i) d.curve.push_back({number(i, i + 1), number(0, 1)});
    d.ballistic_coefficient = coin() ? 0 : number(50, 300);
    for (int i = 0, n = one_in(4) ? below(12) : 0; i < n; ++i) d.bands.push_back({number(i, i + 1), number(50, 300)});
    d.form_factor = number(0.5, 2);
    d.damping = number(0.5, 1);
    d.k1 = number(0, 0.02), d.k2 = number(0, 0.001);
    return d;
  }
  AeroCoefficient aero(double size) {
    AeroCoefficient c;
    for (int i = 0, n = below(4); i < n; ++i)
      c.push_back({number(i, i + 1), one_in(5) ? number(0, 1) : 0, number(-size, size)});
    return c;
  }
  void add_body(ProjectileDef& p) {
    const double i = p.mass * p.diameter * p.diameter;
    p.inertia.moments = {number(0.1, 0.2) * i, number(1, 2) * i, number(1, 2) * i};
    if (one_in(4)) p.inertia.moments.z = p.inertia.moments.y;
    if (one_in(5)) p.inertia.products = vector3(0.01 * i);
    p.aero = {.area = one_in(4) ? number(0, 0.01) : 0,
              .length = one_in(4) ? number(0, 1) : 0,
              .span = one_in(4) ? number(0, 1) : 0,
              .rate_norm = any<RateNorm>(),
              .damping_frame = any<DampingFrame>(),
              .drag_yaw = aero(5),
              .lift = aero(3),
              .lift_cubic = aero(3),
              .pitching = aero(4),
              .pitching_cubic = aero(4),
              .pitch_damping = aero(20),
              .yaw_damping = aero(5),
              .roll_damping = aero(0.1),
              .magnus_force = aero(1),
              .magnus_moment = aero(1)};
  }
  MotorDef motor() {
    MotorDef m{.name = text(), .propellant_mass = number(0, 0.05)};
    for (int i = 0, n = 1 + below(5); i < n; ++i) m.thrust.push_back({number(0.1 * i, 0.1 * i + 0.1), number(0, 20)});
    if (coin()) m.thrust[0].time = 0;
    for (int i = 0, n = one_in(3) ? below(4) : 0; i < n; ++i)
      m.propellant.push_back({number(0.1 * i, 0.1 * i + 0.1), number(0, 0.05)});
    m.ignition_delay = number(0, 0.2), m.drag_factor = number(0.5, 1);
    return m;
  }
  MagnusDef magnus() {
    MagnusDef m{.lift = number(0, 1),
                .lift_base = number(0.5, 2),
                .lift_saturation = number(0, 3),
                .drag_per_spin = number(0, 1e-3),
                .measure = any<SpinMeasure>(),
                .decay_time = one_in(3) ? number(1, 20) : kInfinity};
    for (int i = 0, n = one_in(4) ? 1 + below(3) : 0; i < n; ++i)
      for (int k = 0; k < 2; ++k) m.table.push_back({number(10 * i, 10 * i), number(k, k), number(0, 1), number(0, 1)});
    return m;
  }
  ProjectileDef projectile() {
    ProjectileDef p = random_projectile(*this);
    p.name = text(), p.fidelity = fidelity();
    if (one_in(3))
      p.mass = number(0.01, 5), p.diameter = number(0.01, 0.2), p.length = number(0, 0.5), p.twist = number(-0.5, 0.5);
    if (one_in(3)) p.drag = drag();
    if (one_in(4)) p.magnus = magnus();
    if (one_in(4)) add_body(p);
    if (one_in(5)) p.motor = motor();
    if (one_in(4)) p.force = vector3(3), p.force_duration = number(0, 2);
    return p;
  }
  Launch launch() {
    Launch l = random_launch(*this);
    if (one_in(3)) l.position = vector3(50);
    if (one_in(3)) l.speed = number(0, 300), l.elevation = number(-1.5, 1.5), l.azimuth = number(-4, 4);
    if (one_in(6)) l.velocity = vector3(300);
    if (one_in(8)) l.rail_length = number(0, 2);
    if (one_in(8)) l.sight = {number(0, 0.1), number(-1, 1), number(-1, 1), one_in(4) ? number(20, 200) : 0, coin()};
    if (one_in(6))
      l.attitude = {any<AttitudeFrame>(), number(-1, 1), number(-1, 1), number(-1, 1), any<RateFrame>(), vector3(20)};
    if (one_in(6)) l.spin = {number(-300, 300), number(-300, 300), number(-300, 300)};
    return l;
  }
  Environment environment() {
    Environment e = random_environment(*this);
    if (!one_in(3)) return e;
    e.altitude = number(-400, 20000);
    e.gravity = {any<GravityModel>(), number(1, 20), number(6e6, 7e6)};
    e.atmosphere = {any<AirModel>(), maybe(250, 310), maybe(60000, 104000), maybe(0, 1),
                    maybe(0, 3000),  maybe(0.5, 2),   maybe(280, 360),      number(6000, 9000)};
    for (int i = 0, n = one_in(4) ? below(30) : 0; i < n; ++i)
      e.atmosphere.profile.push_back({number(300 * i, 300 * i + 280), number(200, 310), {}, maybe(0, 1)});
    e.wind = {vector3(10), {}, any<WindAxis>(), any<WindInterpolation>()};
    for (int i = 0, n = one_in(20) ? 40 : below(4); i < n; ++i)
      e.wind.profile.push_back({number(10 * i, 10 * i + 5), vector3(10)});
    e.earth = {number(-1.5, 1.5), number(-3, 3), number(-3, 3), number(-1e-4, 1e-4)};
    return e;
  }
  /// Never so many steps that it takes long.
  Tolerance tolerance() {
    return {.relative = maybe(1e-9, 1e-3),
            .absolute = number(1e-9, 1e-3),
            .step = coin() ? number(0.01, 0.1) : 0,
            .position_error = number(0.01, 0.1),
            .max_step = one_in(3) ? number(0.01, 1) : kInfinity,
            .max_steps = is_odd() ? -below(2) : 20 + below(400)};
  }
  Until until() {
    Until u{.ground = coin() ? maybe(-10, 0) : std::optional(0.0),
            .time = number(0, 5),
            .range = one_in(4) ? maybe(1, 300) : std::nullopt};
    for (int i = 0, n = one_in(30) ? 30 : below(4); i < n; ++i)
      u.events.push_back({any<EventKind>(), number(0, 50), any<Crossing>(), one_in(5)});
    return u;
  }
  Axes axes() { return static_cast<Axes>(is_odd() ? 8 + below(248) : below(8)); }
  BodyDef body() {
    BodyDef b;
    if (coin()) return b;
    b.gravity_scale = number(0, 2), b.use_gravity = !one_in(6), b.drag_scale = number(0, 2);
    b.angular_drag = number(0, 1), b.angular_velocity = vector3(9);
    b.kinematic = one_in(12), b.infinite_mass = one_in(15);
    if (one_in(3)) b.frozen = axes(), b.frozen_rotation = axes();
    b.can_sleep = !one_in(4), b.sleep_speed = number(0, 0.1), b.sleep_time = number(0, 0.2);
    b.restitution = number(0, 1), b.friction = number(0, 1), b.rolling_resistance = number(0, 0.1);
    if (one_in(3))
      b.despawn = {number(-20, -5), number(50, 150), number(0, 3), one_in(4) ? number(0, 1) : 0,
                   one_in(4),       vector3(20),     vector3(80)};
    b.smoothing = any<Smoothing>();
    b.pool = one_in(3) ? count(2) : 0, b.environment = one_in(3) ? count(2) : 0;
    if (one_in(600)) b.cheapest_within = number(0.1, 1), b.within_time = number(0.1, 0.5);
    b.layers = count(3), b.label = text();
    if (coin()) b.collision = {any<OnHit>(), one_in(3) ? number(0, 0.5) : 0, number(0.4, 0.7), count(3), count(3)};
    return b;
  }
  Transform transform() {
    return {vector3(20), {number(-1, 1), number(-1, 1), number(-1, 1), number(0, 1)}, one_in(3) ? number(0.3, 3) : 1};
  }
  Material material() {
    Material m;
    m.restitution = number(0, 1), m.friction = number(0, 1), m.grip_restitution = one_in(3) ? number(0, 1) : 0;
    m.density = one_in(3) ? number(500, 2000) : 0;
    if (one_in(3)) m.ricochet = {number(0.1, 1), number(0, 1), number(0, 1), one_in(4)};
    switch (below(8)) {
      case 0: m.penetration = PonceletDef{number(1e6, 1e8), number(0, 1), number(0, 2)}; break;
      case 1: m.penetration = YoungDef{number(1, 10), coin()}; break;
      case 2: m.penetration = DeMarreDef{number(0.5, 1), number(0, 1)}; break;
      case 3: m.penetration = LambertDef{number(1000, 4000)}; break;
      case 4: m.penetration = BallisticLimitDef{number(1, 100), number(0, 1), number(1, 3)}; break;
      default: break;
    }
    if (one_in(3)) m.spread = {number(0, 0.1), number(0, 0.1)};
    return m;
  }
  ShapeDef shape() {
    switch (below(8)) {
      case 0: return PlaneShape{};
      case 1: return SphereShape{number(0.5, 5)};
      case 2: return CapsuleShape{number(0.5, 5), number(0, 5)};
      case 3: return CylinderShape{number(0.5, 5), number(0.1, 5)};
      case 4: {
        MeshShape m;
        for (int i = 0, n = below(8); i < n; ++i) m.vertices.push_back(vector3(10));
        for (int i = 0, n = below(8); i < n; ++i) m.triangles.push_back({count(8), count(8), count(8)});
        return m;
      }
      case 5: {
        HeightFieldShape f{
            .columns = count(5), .rows = count(5), .spacing_x = number(1, 10), .spacing_z = number(1, 10)};
        for (int i = 0, n = below(26); i < n; ++i) f.heights.push_back(number(-3, 3));
        return f;
      }
      case 6: {
        ConvexHullShape h;
        for (int i = 0, n = below(12); i < n; ++i) h.points.push_back(vector3(5));
        return h;
      }
      default: return BoxShape{vector3(5)};
    }
  }
  SceneMotion motion() {
    if (one_in(3)) return SteadyMotion{number(0, 5), vector3(20), vector3(3)};
    if (coin()) return AtRest{};
    KeyedMotion k{.curve = any<MotionCurve>()};
    for (int i = 0, n = below(5); i < n; ++i)
      k.keys.push_back({number(i, i + 1), vector3(20), {number(-1, 1), number(-1, 1), 0, 1}, vector3(5)});
    return k;
  }
  DetailRule detail() {
    DetailRule rule{.hysteresis = number(0, 0.5), .layers = count(3)};
    for (int i = 0, n = below(5); i < n; ++i)
      rule.rungs.push_back({fidelity(), number(10 * i, 100 * i + 10), one_in(3) ? number(0, 2) : kInfinity});
    return rule;
  }
  WorldDef world() {
    WorldDef d;
    d.threading = {.threads = static_cast<unsigned>(one_in(20) ? 3 : 1),
                   .rows_per_thread = is_odd() ? 0 : static_cast<std::uint32_t>(1 + below(8))};
    d.max_projectiles = is_odd() ? count(3) : static_cast<std::uint32_t>(20 + below(40));
    if (one_in(4)) return d;
    d.environment = environment();
    d.ground = {any<GroundMode>(), number(-2, 2), number(0, 1), number(0, 1)};
    d.step = number(0.004, 0.05), d.max_steps = is_odd() ? 0 : static_cast<std::uint32_t>(below(6)),
    d.time_scale = number(0.2, 3);
    d.tolerance = tolerance(), d.apex_events = coin();
    for (int i = 0, n = below(4); i < n; ++i) d.pools.push_back({text(), count(15), any<WhenFull>()});
    if (one_in(4)) d.detail = detail();
    return d;
  }
  /// A law of a generator; `some` gives the other end of a spring, `own` is the custom one.
  template <class Some>
  ForceLaw law(const Some& some, const CustomForce& own) {
    switch (below(15)) {
      case 0: return ConstantForce{vector3(9)};
      case 1: return ConstantAcceleration{vector3(9)};
      case 2: return GravityForce{vector3(9)};
      case 3: return LinearQuadraticDragForce{number(0, 0.1), number(0, 0.1), vector3(5)};
      case 4: return AnchoredSpring{vector3(9), number(0, 9), number(0, 2), number(0, 1)};
      case 5: return Spring{some(), number(0, 9), number(0, 2), number(0, 1)};
      case 6: return Bungee{some(), vector3(9), number(0, 9), number(0, 2), number(0, 1)};
      case 7: return Buoyancy{number(-1, 3), number(0, 1), number(0, 1), number(1, 1000), number(0, 1), number(0, 10)};
      case 8: return PointAttractor{vector3(9), number(-50, 50), number(0, 1)};
      case 9: return WindZone{vector3(9), vector3(30), vector3(30), number(0, 2)};
      case 10: return Explosion{vector3(9), number(0, 90), number(0, 30)};
      case 11: return Thrust{{{number(0, 0.1), number(0, 9)}, {number(0.1, 1), number(0, 9)}}, vector3(1)};
      case 12: return CustomForce{};
      default: return own;
    }
  }
  AimOptions aim_options() { return {any<Arc>(), number(0.001, 1), maybe(-10, 0), number(1, 30), tolerance()}; }
  Purpose purpose() {
    return {.error = number(0.1, 10),
            .time = number(0.1, 0.5),
            .step = number(0.01, 0.1),
            .ground = maybe(-10, 0),
            .least_motion = any<Motion>(),
            .least_precision = any<Precision>(),
            .truth = fidelity(),
            .tolerance = tolerance()};
  }

 private:
  int rarity_;
};

}  // namespace physim::test
