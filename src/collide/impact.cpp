#include "physim/scene.hpp"

#include <cmath>

#include "base/checker.hpp"
#include "base/ieee_mode.hpp"
#include "collide/seen_hit.hpp"
#include "math/angles.hpp"
#include "math/elementary.hpp"
#include "math/pack.hpp"
#include "math/vec3.hpp"
#include "model/ball_contact.hpp"
#include "model/contact.hpp"
#include "model/de_marre.hpp"
#include "model/exit_spread.hpp"
#include "model/lambert_jonas.hpp"
#include "model/nose.hpp"
#include "model/poncelet.hpp"
#include "model/recht_ipson.hpp"
#include "model/ricochet.hpp"
#include "model/young.hpp"

namespace physim {
namespace {

// Within these the squares and products of numbers stay numbers.
constexpr double kFastest = 1e9;       // [m/s]
constexpr double kFastestSpin = 1e15;  // [rad/s]
constexpr double kHeaviest = 1e100;    // [kg]
constexpr double kThinnest = 1e-15;    // of what has a diameter [m]
constexpr double kThickest = 1e15;     // [m]
constexpr double kStillLeft = 0.01;    // part of the speed at which a projectile in a liquid has stopped [-]

Status check_impact(const Impact& i, const Material& m) {
  Checker c;
  c.is_vector(i.velocity, "impact.velocity").is_vector(i.spin, "impact.spin").is_vector(i.normal, "impact.normal");
  c.is_vector(i.surface_velocity, "impact.surface_velocity");
  if (!c.status_so_far()) return c.status();
  c.require(length(i.velocity) <= kFastest && length(i.surface_velocity) <= kFastest, "impact.velocity",
            "must not exceed 1e9 m/s")
      .require(abs(length_squared(i.normal) - 1) <= 1e-6, "impact.normal", "must have length 1")
      .require(length(i.spin) <= kFastestSpin, "impact.spin", "must not exceed 1e15 rad/s")
      .require(i.mass >= 0 && i.mass <= kHeaviest, "impact.mass", "must lie between 0 and 1e100 kg")
      .require(i.diameter == 0 || (i.diameter >= kThinnest && i.diameter <= kThickest), "impact.diameter",
               "must be zero, or lie between 1e-15 and 1e15 m", "0: a point, which nothing spins")
      .require(i.length >= 0 && i.length <= kThickest, "impact.length", "must lie between 0 and 1e15 m",
               "0: the diameter")
      .require(i.nose_length >= 0 && i.nose_length <= 100, "impact.nose_length", "must lie between 0 and 100",
               "in diameters; 0.5: round")
      .require(i.inertia >= 1e-6 && i.inertia <= 1e6, "impact.inertia", "must lie between 1e-6 and 1e6",
               "2/5 a solid ball, 2/3 a hollow one")
      .require(i.thickness == 0 || i.thickness >= 1e-9, "impact.thickness", "must be zero, or 1e-9 m at least",
               "0: not known, and without end");
  const bool weighed = m.ricochet.liquid || !std::holds_alternative<ImpenetrableDef>(m.penetration);
  if (weighed) {
    constexpr std::string_view why = "the material's laws need one";
    c.require(i.mass >= 1e-15 && i.mass <= 1e15, "impact.mass", "must lie between 1e-15 and 1e15 kg", why);
    c.require(i.diameter >= 1e-9 && i.diameter <= 1e6, "impact.diameter", "must lie between 1e-9 and 1e6 m", why);
  }
  return c.status();
}

/// What a material does to what goes into it.
struct Bored {
  bool through;
  double speed;  // behind it [m/s]
  double depth;  // where it stops [m]
};

/// A projectile and a material, seen from the surface.
class Meeting {
 public:
  Meeting(const Impact& impact, const Material& material)
      : i_(impact),
        m_(material),
        velocity_(impact.velocity - impact.surface_velocity),
        speed_(length(velocity_)),
        sine_(speed_ > 0 ? min(-dot(velocity_, impact.normal) / speed_, 1.0) : 0.0) {}

  ImpactResult result() const {
    ImpactResult r{.velocity = i_.velocity, .spin = i_.spin};
    if (!(sine_ > 0)) return r;
    r.obliquity = obliquity_of(velocity_, i_.normal);
    const double angle = max(kRightAngle - r.obliquity, 0.0);
    if (angle < critical_angle()) {
      ricochet(angle, r);
    } else if (!enter(r)) {
      const BallMotion after = bounce();
      r.kind = ImpactKind::bounced;
      r.velocity = after.velocity;
      r.spin = after.spin;
    }
    const Vec3d seen = r.velocity;
    const double before = energy(velocity_, i_.spin);
    r.energy = before - energy(seen, r.spin);
    PHYSIM_ASSERT(!(r.energy < -1e-9 * before));  // no contact gives energy
    r.velocity = seen + i_.surface_velocity;
    return r;
  }

 private:
  [[nodiscard]] double energy(const Vec3d& velocity, const Vec3d& spin) const {
    const double radius = 0.5 * i_.diameter;
    return 0.5 * i_.mass * (length_squared(velocity) + i_.inertia * radius * radius * length_squared(spin));
  }
  [[nodiscard]] double area() const { return 0.5 * kRightAngle * i_.diameter * i_.diameter; }

  // ---- ricochet
  [[nodiscard]] double specific_gravity() const {
    const double volume = area() * i_.diameter * (2.0 / 3);
    return i_.mass / (volume * m_.density);
  }
  [[nodiscard]] double critical_angle() const {
    return m_.ricochet.liquid ? liquid_critical_angle(specific_gravity()) : m_.ricochet.critical_angle;
  }
  void ricochet(double angle, ImpactResult& r) const {
    r.kind = ImpactKind::ricocheted;
    if (m_.ricochet.liquid) {
      const Vec3d mirrored = velocity_ - i_.normal * (2 * dot(velocity_, i_.normal));
      r.velocity = mirrored * liquid_speed_kept(specific_gravity(), angle);
    } else {
      r.velocity = bounced(velocity_, i_.normal, Surface{m_.ricochet.restitution, m_.ricochet.friction, 0});
    }
    spread(1, r);
  }

  // ---- into the material
  /// Whether it comes through or is held; else it bounces.
  bool enter(ImpactResult& r) const {
    if (std::holds_alternative<ImpenetrableDef>(m_.penetration)) return false;
    const double end = i_.thickness > 0 ? i_.thickness : kInfinity;
    const Bored passage = std::visit([&](const auto& law) { return passed(law, end); }, m_.penetration);
    PHYSIM_ASSERT(passage.speed >= 0 && passage.speed <= speed_ * (1 + 1e-12));
    if (passage.through) {
      r.kind = ImpactKind::penetrated;
      r.depth = passage.depth;
      r.velocity = velocity_ * (passage.speed / speed_);
      spread(-1, r);
      return true;
    }
    if (passage.depth < 0.5 * i_.diameter) return false;
    r.kind = ImpactKind::stopped;
    r.depth = passage.depth;
    r.velocity = r.spin = {};
    return true;
  }

  Bored passed(const ImpenetrableDef&, double) const { return {false, 0, 0}; }
  Bored passed(const PonceletDef& law, double end) const {
    const Bore bore{.mass = i_.mass,
                    .area = area(),
                    .strength = law.strength,
                    .inertia = law.inertia * nose_factor(i_.nose_length) * m_.density,
                    .crater = law.crater * i_.diameter};
    double depth = poncelet_depth(bore, speed_);
    if (depth == kInfinity)  // a liquid: v = v_0 exp(-A q x / m)
      depth = bore.crater - log(kStillLeft) * bore.mass / (bore.area * bore.inertia);
    if (end < depth) return {true, min(poncelet_speed(bore, speed_, end), speed_), end};
    return {false, 0, depth};
  }
  Bored passed(const YoungDef& law, double end) const {
    const double reach = young_reach(law.s_number, i_.nose_length, i_.mass, area(), law.hard);
    const double depth = young_depth(reach, speed_);
    if (end < depth) return {true, min(young_speed(reach, depth - end), speed_), end};
    return {false, 0, depth};
  }
  Bored passed(const DeMarreDef& law, double end) const {
    const double depth = de_marre_thickness(law.quality, i_.diameter, i_.mass, speed_, sine_) / sine_;
    if (!(end < depth)) return {false, 0, depth};
    const double limit = de_marre_limit(law.quality, i_.diameter, i_.mass, end * sine_, sine_);
    return behind(limit, plug_share(i_.mass, law.plug * m_.density * area() * end), 2, end);
  }
  Bored passed(const LambertDef& law, double end) const {
    const LongRod rod{i_.mass, i_.diameter, i_.length > 0 ? i_.length : i_.diameter};
    const double most = lambert_passed(law.coefficient, rod, speed_);
    const double depth = most / lambert_z(1, i_.diameter, sine_);
    if (!(end < depth)) return {false, 0, depth};
    const double z = lambert_z(end, i_.diameter, sine_);
    const LambertResidual residual = lambert_residual(rod, m_.density, z);
    return behind(lambert_limit(law.coefficient, rod, z), residual.a, residual.p, end);
  }
  Bored passed(const BallisticLimitDef& law, double end) const {
    const double limit = law.speed / sine_;
    if (speed_ > limit) return behind(limit, law.a, law.p, end < kInfinity ? end : 0);
    const double part = speed_ / limit;  // as if the plate resisted with a constant force
    return {false, 0, end < kInfinity ? end * part * part : 0};
  }
  [[nodiscard]] Bored behind(double limit, double a, double p, double end) const {
    return {true, residual_speed(speed_, min(limit, speed_), a, p), end};
  }

  // ---- off the surface
  [[nodiscard]] BallMotion bounce() const {
    if (i_.diameter == 0) return {bounced(velocity_, i_.normal, Surface{m_.restitution, m_.friction, 0}), i_.spin};
    return bounced(BallMotion{velocity_, i_.spin}, i_.normal, Ball{0.5 * i_.diameter, i_.inertia},
                   BallSurface{m_.restitution, m_.friction, m_.grip_restitution});
  }

  /// Turns what leaves on a side of the surface, where it stays.
  void spread(double side, ImpactResult& r) const {
    if (m_.spread.deflection == 0 && m_.spread.yaw == 0) return;
    const double speed = length(r.velocity);
    if (!(speed > 0)) return;
    const HitNumbers numbers = hit_numbers(i_.seed, i_.projectile, i_.hit);
    Vec3d direction = normalized(r.velocity);
    if (m_.spread.deflection > 0) {
      direction = normalized(turned_off(direction, m_.spread.deflection * numbers.angle[0], numbers.about[0]));
      const double off = dot(direction, i_.normal);
      if (off * side < 0) direction -= i_.normal * (2 * off);  // mirrored, where it would go back through the surface
      r.velocity = direction * speed;
    }
    if (m_.spread.yaw > 0) r.nose = turned_off(direction, m_.spread.yaw * numbers.angle[1], numbers.about[1]);
  }

  const Impact& i_;
  const Material& m_;
  Vec3d velocity_;  // [m/s]
  double speed_;    // [m/s]
  double sine_;     // of the angle between way and surface, the cosine of the obliquity; not above 0: it goes away [-]
};

}  // namespace

Result<ImpactResult> impact(const Impact& hit, const Material& material) {
  const IeeeMode mode;
  if (auto status = check_material(material); !status) return status.error();
  if (auto status = check_impact(hit, material); !status) return status.error();
  const ImpactResult result = Meeting(hit, material).result();
  PHYSIM_ASSERT(finite(result.velocity) && finite(result.spin));
  return result;
}

}  // namespace physim
