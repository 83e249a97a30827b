// Refuses force generators that make no sense.
#include <type_traits>
#include <variant>

#include "base/checker.hpp"
#include "model/force_laws.hpp"
#include "world/step/force_eval.hpp"

namespace physim {
namespace {

void check_value(Checker& c, double value, Limit limit, const std::string& place, std::string_view hint) {
  switch (limit) {
    case Limit::any: c.is_number(value, place); return;
    case Limit::not_negative: c.not_negative(value, place, hint); return;
    case Limit::positive: c.positive(value, place, hint); return;
    case Limit::infinite:
    case Limit::needed: return;
  }
}

/// What the row of a law says of its members.
template <class Law>
void check_members(Checker& c, const Law& law, const ForceTarget& target) {
  for_each_member<Law>([&](const auto& member) {
    const auto& value = law.*member.pointer;
    using T = std::decay_t<decltype(value)>;
    const std::string place = "force." + std::string(member.name);
    if constexpr (std::is_same_v<T, double>) check_value(c, value, member.limit, place, member.hint);
    if constexpr (std::is_same_v<T, Vec3d>)
      if (member.limit != Limit::infinite) c.is_vector(value, place);
    if constexpr (std::is_same_v<T, ProjectileId>) {
      c.require(member.limit != Limit::needed || bool(value), place, "is nobody", member.hint);
      for (std::size_t i = 0; value && i < target.ids.size(); ++i)
        c.require(target.ids[i] != value, place, "is a target too", "a spring joins two different projectiles");
    }
  });
}

/// What goes beyond single members.
struct LawCheck {
  Checker& c;

  template <class Law>
  void operator()(const Law&) const {}
  void operator()(const WindZone& law) const {
    // Written so that NaN fails too.
    const bool in_order = law.low.x < law.high.x && law.low.y < law.high.y && law.low.z < law.high.z;
    c.require(in_order, "force.low", "must lie below force.high in all three components", "swap what is swapped");
  }
  void operator()(const Thrust& law) const {
    c.require(law.curve.size() >= 2, "force.curve", "needs two points or more", "thrust is zero outside of its points");
    for (std::size_t i = 0; i < law.curve.size(); ++i) {
      const std::string place = "force.curve[" + std::to_string(i) + "]";
      c.not_negative(law.curve[i].time, place + ".time", "times start at 0").is_number(law.curve[i].force, place);
      if (i > 0) c.require(law.curve[i].time > law.curve[i - 1].time, place, "times must rise", "sort the points");
    }
  }
  void operator()(const CustomForce& law) const {
    c.require(bool(law.function), "force.function", "is empty", "give a function of a ForceBatch");
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
  c.require(!force.law.valueless_by_exception(), "force.law", "is none", "an exception took it");
  if (!c.status_so_far()) return c.status();
  std::visit([&](const auto& law) { check_members(c, law, force.target); }, force.law);
  std::visit(LawCheck{c}, force.law);
  check_target(c, force.target);
  c.not_negative(force.delay, "force.delay", "in s");
  c.require(force.duration > 0, "force.duration", "must be positive, not " + short_text(force.duration),
            "infinity is for ever; a kick is an impulse");
  return c.status();
}

}  // namespace physim
