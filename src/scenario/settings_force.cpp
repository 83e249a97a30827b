// Settings of [[force]]: a table for each law, of which a force has one.
#include <deque>
#include <iterator>
#include <type_traits>

#include "model/force_laws.hpp"
#include "scenario/settings_parts.hpp"

namespace physim {
namespace {

/// The law of a force as one of this kind; what else it was is forgotten.
template <class Law>
Law& law_of(const Scope& scope) {
  PHYSIM_ASSERT(scope.force != nullptr);
  ForceLaw& law = scope.force->law;
  if (!std::holds_alternative<Law>(law)) law.emplace<Law>();
  return std::get<Law>(law);
}

template <class Law>
bool is_law(const Scope& scope) {
  return std::holds_alternative<Law>(scope.force->law);
}

#define PHYSIM_FORCE(...) PHYSIM_ROW("force", force, __VA_ARGS__)

constexpr Entry kForceSettings[] = {
    setting("force", PHYSIM_FIELD(scenario->forces), "force generators; each has one law", at_most(10000)),
    PHYSIM_FORCE(name, "in messages; default: force-1, force-2, ..."),
    PHYSIM_FORCE(shots, "names of the shots that it acts on; neither shots nor layers: everything"),
    PHYSIM_FORCE(layers, "bits of shot.body.layers that it acts on", kBits),
    PHYSIM_FORCE(delay, "before it starts", Quantity::time, at_least(0)),
    PHYSIM_FORCE(duration, "then it ends", Quantity::time, or_infinite(above(0))),
};

constexpr Entry kThrustCurve[] = {
    PHYSIM_ROW("force.thrust.curve", thrust_point, time, "since the force started, or since each launch",
               Quantity::time, at_least(0)),
    PHYSIM_ROW("force.thrust.curve", thrust_point, force, "along the direction", Quantity::force),
};

constexpr Range range_of(Limit limit) {
  switch (limit) {
    case Limit::any:
    case Limit::needed: return {};
    case Limit::not_negative: return at_least(0);
    case Limit::positive: return above(0);
    case Limit::infinite: return or_infinite({});
  }
  return {};
}

template <class Law, auto kMember>
ValueRef member_slot(const Scope& scope) {
  auto& value = law_of<Law>(scope).*kMember;
  if constexpr (std::is_same_v<std::decay_t<decltype(value)>, ProjectileId>)
    return &scope.force->other;
  else
    return slot_of(scope, value);
}

/// The settings of a law, out of its row; `paths` keeps what the entries refer to.
template <class Law>
void add_law(std::vector<Entry>& list, std::deque<std::string>& paths) {
  for_each_member<Law>([&]<auto kMember>(const LawMember<kMember>& member) {
    paths.push_back("force." + std::string(kLaw<Law>.name) + "." + std::string(member.name));
    list.push_back({{.path = paths.back(),
                     .doc = member.doc,
                     .quantity = member.quantity,
                     .range = range_of(member.limit),
                     .required = member.limit == Limit::needed},
                    member_slot<Law, kMember>});
    list.back().is_there = is_law<Law>;
    if constexpr (std::is_same_v<Law, Thrust>)
      if (member.name == "curve") list.back().range = at_most(1000);
  });
}

std::vector<Entry> all_settings(std::deque<std::string>& paths) {
  std::vector<Entry> list(std::begin(kForceSettings), std::end(kForceSettings));
  for_each_law([&]<class Law>(const Law*) {
    if constexpr (!std::is_same_v<Law, CustomForce>) add_law<Law>(list, paths);  // no file can hold a function
  });
  PHYSIM_ASSERT(paths.size() + std::size(kForceSettings) == list.size());
  list.insert(list.end(), std::begin(kThrustCurve), std::end(kThrustCurve));
  return list;
}

}  // namespace

std::span<const Entry> force_settings() {
  static std::deque<std::string> paths;
  static const std::vector<Entry> all = all_settings(paths);
  return all;
}

}  // namespace physim
