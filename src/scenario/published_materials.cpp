#include "scenario/published_materials.hpp"

#include <iterator>

namespace physim {
namespace {

constexpr double kUsualConcrete = 30e6;  // its compressive strength, where nothing is said [Pa]

constexpr std::string_view kPublishedNames[] = {"water",        "concrete",      "fir",      "oak",
                                                "nickel_steel", "rolled_armour", "aluminium"};
constexpr Material (*kPublished[])() = {materials::water,        [] { return materials::concrete(kUsualConcrete); },
                                        materials::fir,          materials::oak,
                                        materials::nickel_steel, materials::rolled_armour,
                                        materials::aluminium};
static_assert(std::size(kPublishedNames) == std::size(kPublished));

}  // namespace

std::span<const std::string_view> published_materials() { return kPublishedNames; }

std::optional<Material> published_material(std::string_view name) {
  for (std::size_t i = 0; i < std::size(kPublishedNames); ++i)
    if (kPublishedNames[i] == name) return kPublished[i]();
  return std::nullopt;
}

}  // namespace physim
