// The figures that an [[expect]] can ask for.
#include "scenario/expectation.hpp"

#include <array>

namespace physim {
namespace {

constexpr Figure kFigures[] = {
    {"drop", Quantity::length, [](const Sample& s) { return s.drop; }},
    {"windage", Quantity::length, [](const Sample& s) { return s.windage; }},
    {"range", Quantity::length, [](const Sample& s) { return s.range; }},
    {"speed", Quantity::speed, [](const Sample& s) { return s.speed; }},
    {"time", Quantity::time, [](const Sample& s) { return s.time; }},
    {"x", Quantity::length, [](const Sample& s) { return s.position.x; }},
    {"y", Quantity::length, [](const Sample& s) { return s.position.y; }},
    {"z", Quantity::length, [](const Sample& s) { return s.position.z; }},
    {"vx", Quantity::speed, [](const Sample& s) { return s.velocity.x; }},
    {"vy", Quantity::speed, [](const Sample& s) { return s.velocity.y; }},
    {"vz", Quantity::speed, [](const Sample& s) { return s.velocity.z; }},
    {"mach", Quantity::number, [](const Sample& s) { return s.mach; }},
    {"energy", Quantity::energy, [](const Sample& s) { return s.energy; }},
    {"latitude", Quantity::angle, nullptr, &Geodetic::latitude},
    {"longitude", Quantity::angle, nullptr, &Geodetic::longitude},
    {"altitude", Quantity::length, nullptr, &Geodetic::height},
    {"elevation", Quantity::angle, nullptr},
};

constexpr auto kNames = [] {
  std::array<std::string_view, std::size(kFigures)> names;
  for (std::size_t i = 0; i < names.size(); ++i) names[i] = kFigures[i].name;
  return names;
}();

}  // namespace

std::span<const Figure> figures() { return kFigures; }

std::span<const std::string_view> figure_names() { return kNames; }

const Figure* find_figure(std::string_view name) {
  for (const Figure& figure : kFigures)
    if (figure.name == name) return &figure;
  return nullptr;
}

}  // namespace physim
