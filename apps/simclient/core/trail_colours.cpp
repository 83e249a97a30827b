#include "simclient/core/trail_colours.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include "base/assert.hpp"

namespace physim::client {
namespace {

constexpr std::array<std::string_view, 4> kNames = {"shot", "speed", "mach", "energy"};
// Seven colours of the scale viridis (S. van der Walt, N. Smith 2015), without its dark end.
constexpr std::array<Colour, 7> kScale = {0x3E4A89FF, 0x31688EFF, 0x26828EFF, 0x1F9E89FF,
                                          0x35B779FF, 0x8FD744FF, 0xFDE725FF};
constexpr int kSteps = 24;

double quantity_of(TrailColour by, const TrackSample& s) {
  const double speed = length(s.velocity);
  switch (by) {
    case TrailColour::shot: return 0;
    case TrailColour::speed: return speed;
    case TrailColour::mach: return s.mach;
    case TrailColour::energy: return std::isfinite(s.mass) ? 0.5 * s.mass * speed * speed : 0;
  }
  return 0;
}

std::string value_text(TrailColour by, double value) {
  if (by == TrailColour::mach) return formatted("Mach %.3g", value);
  if (by == TrailColour::speed) return formatted("%.4g m/s", value);
  constexpr std::pair<double, const char*> kUnits[] = {{1e9, "GJ"}, {1e6, "MJ"}, {1e3, "kJ"}, {1, "J"}};
  for (const auto& [unit, name] : kUnits)
    if (value >= unit) return formatted("%.3g %s", value / unit, name);
  return formatted("%.3g J", value);
}

}  // namespace

std::string_view name(TrailColour by) { return kNames[static_cast<std::size_t>(by)]; }

Colour scale_colour(double part) {
  PHYSIM_ASSERT(part >= 0 && part <= 1);
  const double at = std::round(part * kSteps) / kSteps * (kScale.size() - 1);
  const auto i = std::min(static_cast<std::size_t>(at), kScale.size() - 2);
  Colour out = 0xFF;
  for (const int shift : {8, 16, 24}) {
    const double from = kScale[i] >> shift & 0xFFU, to = kScale[i + 1] >> shift & 0xFFU;
    out |= static_cast<Colour>(std::lround(std::lerp(from, to, at - static_cast<double>(i)))) << shift;
  }
  return out;
}

Colour TrailScale::operator()(const TrackSample& sample) const {
  return scale_colour(std::clamp((quantity_of(by, sample) - low) / (high - low), 0.0, 1.0));
}

SceneLegend TrailScale::legend() const { return {std::string(name(by)), value_text(by, low), value_text(by, high)}; }

std::optional<TrailScale> trail_scale(const Client& client) {
  if (client.show.trails_by == TrailColour::shot) return std::nullopt;
  TrailScale scale{client.show.trails_by, 0, 0};
  bool is_first = true;
  for (const Track& track : client.session.known_tracks())
    for (const TrackSample& s : track.samples) {
      const double value = quantity_of(scale.by, s);
      scale.low = is_first ? value : std::min(scale.low, value);
      scale.high = is_first ? value : std::max(scale.high, value);
      is_first = false;
    }
  return scale.high > scale.low ? std::optional(scale) : std::nullopt;
}

}  // namespace physim::client
