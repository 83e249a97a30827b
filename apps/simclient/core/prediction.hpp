// Prediction: the flight that a shot would have. It is fired into the session's own world, as that was saved, with
// nobody else in it: what the world would do to it, bounces, things and forces included, is done.
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
  bool is_cut = false;            // by the limit: it flies on
};

/// Predicts the shots of one session.
class Predictor {
 public:
  /// The world is saved anew at the next prediction: the session was changed by more than steps and shots.
  void forget_world() { world_.reset(); }
  /// Flies a shot from now on until it leaves, for `max_time` [s], or until it has met things a few times.
  [[nodiscard]] Prediction predict(const Session& session, const ScenarioShot& shot, double max_time = 200);

 private:
  [[nodiscard]] Status take_world(const Session& session);

  std::optional<World> world_;
  Snapshot empty_;  // of it, before anything is fired
};

}  // namespace physim::client
