// Trail colours: by shot, or by speed, Mach number or energy along each path.
#pragma once

#include <optional>
#include <string_view>

#include "simclient/core/scene.hpp"

namespace physim::client {

[[nodiscard]] std::string_view name(TrailColour by);

/// A colour of a scale from dark blue to yellow that becomes lighter all the way, for people with any colour vision.
/// `part`: from 0 to 1, in 24 steps.
[[nodiscard]] Colour scale_colour(double part);

/// Colours by what the client asks for, over all that its paths span, and their legend; nothing where it asks for
/// colours of shots, or where nothing differs.
struct TrailScale {
  TrailColour by = TrailColour::shot;
  double low = 0, high = 0;
  [[nodiscard]] Colour operator()(const TrackSample& sample) const;
  [[nodiscard]] SceneLegend legend() const;
};
[[nodiscard]] std::optional<TrailScale> trail_scale(const Client& client);

}  // namespace physim::client
