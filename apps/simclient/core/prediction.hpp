// Prediction: the flight that a shot would have, flown in a world of its own that is like the session's.
#pragma once

#include <optional>
#include <vector>

#include "simclient/core/session.hpp"

namespace physim::client {

struct Prediction {
  std::optional<Error> error;  // why the shot would be refused
  Vec3d muzzle, velocity;      // at launch
  FidelityInUse granted;
  std::vector<TrackSample> path;  // one for each step, up to the end or the limit
  std::optional<TrackSample> apex, impact;
  std::uint64_t steps = 0;
  double seconds = 0;     // that the steps took on this machine
  bool complete = false;  // the flight ends within the limit
};

/// Flies a shot from now on until it leaves, or for `max_time` [s].
[[nodiscard]] Prediction predict(const Session& session, const ScenarioShot& shot, double max_time = 200);

}  // namespace physim::client
