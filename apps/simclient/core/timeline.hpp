// Timeline: the time that a session's flights take, with what happened in it, for the bar of play and the plots.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "simclient/core/session.hpp"

namespace physim::client {

class Client;

/// Something that happened to a projectile.
struct TimelineTick {
  enum class Kind { launch, burnout, apex, hit, end };

  double time = 0;  // of the world [s]
  Kind kind = Kind::launch;
  Colour colour = 0xFFFFFFFF;  // of the projectile
  std::string text;            // for people
};
[[nodiscard]] std::string_view name(TimelineTick::Kind kind);

/// From the first launch that is shown to the end of the last flight, as far as that is known or foreseen. Worlds of
/// scenarios count from 0, up to the duration of their run.
struct Timeline {
  double begin = 0, end = 0;        // of the world [s]
  double now = 0;                   // the moment at hand, within the two [s]
  double reachable = 0, known = 0;  // between these, steps were taken that come again to the bit [s]
  std::vector<TimelineTick> ticks;  // by time

  /// From 0 at its begin to 1 at its end.
  [[nodiscard]] double part(double time) const;
  /// The time of a part.
  [[nodiscard]] double time(double part) const { return begin + part * (end - begin); }
};

[[nodiscard]] Timeline timeline_of(Client& client);

/// The step of a session that is nearest to a time [s]; the first before 0.
[[nodiscard]] std::uint64_t step_at(const Session& session, double time);

/// A projectile at a time of the world [s]; nothing where its track does not reach.
[[nodiscard]] std::optional<TrackSample> sample_at(const Track& track, double time);

}  // namespace physim::client
