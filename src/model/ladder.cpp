// The names and texts of rungs, out of their rows. Source: none.
#include "model/ladder.hpp"

#include "physim/names.hpp"

namespace physim {
namespace {

template <class Enum>
constexpr std::array<std::string_view, kRungCount<Enum>> kNames = [] {
  std::array<std::string_view, kRungCount<Enum>> names;
  for (std::size_t i = 0; i < names.size(); ++i) names[i] = row(static_cast<Enum>(i)).name;
  return names;
}();

template <class Enum>
constexpr std::array<RungInfo, kRungCount<Enum>> kInOrder = [] {
  std::array<RungInfo, kRungCount<Enum>> rungs;
  for (std::size_t i = 0; i < rungs.size(); ++i) rungs[i] = row(all_rungs<Enum>()[i]);
  return rungs;
}();

/// Levels are compared, so no two rungs of an effect share one.
template <class Enum>
consteval bool has_distinct_levels() {
  for (std::size_t i = 1; i < kRungCount<Enum>; ++i)
    if (kInOrder<Enum>[i - 1].level == kInOrder<Enum>[i].level) return false;
  return true;
}

}  // namespace

#define PHYSIM_RUNGS(Enum)                                                            \
  static_assert(has_distinct_levels<Enum>(), "two rungs of " #Enum " share a level"); \
  template <>                                                                         \
  std::span<const std::string_view> names_of<Enum>() {                                \
    return kNames<Enum>;                                                              \
  }                                                                                   \
  template <>                                                                         \
  std::span<const RungInfo> rungs_of<Enum>() {                                        \
    return kInOrder<Enum>;                                                            \
  }
PHYSIM_RUNGS(Motion)
PHYSIM_RUNGS(Integrator)
PHYSIM_RUNGS(GravityModel)
PHYSIM_RUNGS(DragModel)
PHYSIM_RUNGS(AirModel)
PHYSIM_RUNGS(WindModel)
PHYSIM_RUNGS(EarthModel)
PHYSIM_RUNGS(RotationModel)
PHYSIM_RUNGS(BodyForm)
PHYSIM_RUNGS(Precision)
PHYSIM_RUNGS(Interpolation)
#undef PHYSIM_RUNGS

std::span<const EffectRungs> all_effects() {
  static const std::vector<EffectRungs> all = [] {
    std::vector<EffectRungs> effects;
    for_each_effect([&]<class Enum>(std::string_view place, Enum Fidelity::*) {
      effects.push_back({place.substr(place.find('.') + 1), rungs_of<Enum>()});
    });
    return effects;
  }();
  return all;
}

}  // namespace physim
