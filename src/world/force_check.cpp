// Refuses force generators that make no sense.
#include <variant>

#include "base/checker.hpp"
#include "world/force_eval.hpp"

namespace physim {
namespace {

/// The numbers that springs of every kind have.
template <class Law>
void check_elastic(Checker& c, const Law& law) {
  c.not_negative(law.stiffness, "force.stiffness", "a spring pulls back when it is stretched");
  c.not_negative(law.rest_length, "force.rest_length", "in m");
  c.not_negative(law.damping, "force.damping", "negative damping would feed energy in");
}

struct LawCheck {
  Checker& c;
  const ForceTarget& target;

  void operator()(const ConstantForce& law) const { c.is_vector(law.force, "force.force"); }
  void operator()(const ConstantAcceleration& law) const { c.is_vector(law.acceleration, "force.acceleration"); }
  void operator()(const GravityForce& law) const { c.is_vector(law.gravity, "force.gravity"); }
  void operator()(const LinearQuadraticDragForce& law) const {
    c.not_negative(law.k1, "force.k1", "negative drag would feed energy in");
    c.not_negative(law.k2, "force.k2", "negative drag would feed energy in");
    c.is_vector(law.wind, "force.wind");
  }
  void operator()(const AnchoredSpring& law) const {
    c.is_vector(law.anchor, "force.anchor");
    check_elastic(c, law);
  }
  void operator()(const Spring& law) const {
    c.require(bool(law.other), "force.other", "is nobody", "a spring to a fixed point is an AnchoredSpring");
    not_to_itself(law.other);
    check_elastic(c, law);
  }
  void operator()(const Bungee& law) const {
    not_to_itself(law.other);
    c.is_vector(law.anchor, "force.anchor");
    check_elastic(c, law);
  }
  void operator()(const Buoyancy& law) const {
    c.is_number(law.surface, "force.surface").not_negative(law.volume, "force.volume", "0: that of a sphere");
    c.not_negative(law.depth, "force.depth", "0: a sphere").not_negative(law.density, "force.density", "in kg/m^3");
    c.not_negative(law.damping, "force.damping", "negative damping would feed energy in");
    c.not_negative(law.gravity, "force.gravity", "its size, downwards");
  }
  void operator()(const PointAttractor& law) const {
    c.is_vector(law.centre, "force.centre").is_number(law.strength, "force.strength");
    c.not_negative(law.softening, "force.softening", "in m");
  }
  void operator()(const WindZone& law) const {
    c.is_vector(law.velocity, "force.velocity").not_negative(law.density, "force.density", "in kg/m^3");
    // Written so that NaN fails too.
    const bool in_order = law.low.x < law.high.x && law.low.y < law.high.y && law.low.z < law.high.z;
    c.require(in_order, "force.low", "must lie below force.high in all three components", "swap what is swapped");
  }
  void operator()(const Explosion& law) const {
    c.is_vector(law.centre, "force.centre").is_number(law.force, "force.force");
    c.positive(law.radius, "force.radius", "in m");
  }
  void operator()(const Thrust& law) const {
    c.require(law.curve.size() >= 2, "force.curve", "needs two points or more", "thrust is zero outside of its points");
    for (std::size_t i = 0; i < law.curve.size(); ++i) {
      const std::string place = "force.curve[" + std::to_string(i) + "]";
      c.not_negative(law.curve[i].time, place + ".time", "times start at 0").is_number(law.curve[i].force, place);
      if (i > 0) c.require(law.curve[i].time > law.curve[i - 1].time, place, "times must rise", "sort the points");
    }
    c.is_vector(law.direction, "force.direction");
  }
  void operator()(const CustomForce& law) const {
    c.require(bool(law.function), "force.function", "is empty", "give a function of a ForceBatch");
  }

  void not_to_itself(ProjectileId other) const {
    for (std::size_t i = 0; other && i < target.ids.size(); ++i)
      c.require(target.ids[i] != other, "force.other", "is a target too", "a spring joins two different projectiles");
  }
};

void check_target(Checker& c, const ForceTarget& target) {
  const bool somebody = !target.ids.empty() || target.kind || target.layers != 0;
  c.require(somebody, "force.target", "is nobody", "give ids, a kind or layers, or ForceTarget::everything()");
  for (std::size_t i = 0; i < target.ids.size(); ++i)
    c.require(bool(target.ids[i]), "force.target.ids[" + std::to_string(i) + "]", "is nobody", "");
}

}  // namespace

Status check(const ForceDef& force) {
  Checker c;
  std::visit(LawCheck{c, force.target}, force.law);
  check_target(c, force.target);
  c.not_negative(force.delay, "force.delay", "in s");
  c.require(force.duration > 0, "force.duration", "must be positive, not " + short_text(force.duration),
            "infinity is for ever; a kick is an impulse");
  return c.status();
}

}  // namespace physim
