// Prediction: the flight that a shot would have. It is fired into the session's own world, as that was saved, without
// other projectiles: bounces, things and forces act on it as they would. A shot that flies whole is computed as it will
// be played.
#pragma once

#include <limits>
#include <optional>
#include <vector>

#include "simclient/core/orbit.hpp"
#include "simclient/core/session.hpp"

namespace physim::client {

struct Prediction {
  std::optional<Error> error;  // why the shot would be refused
  Vec3d muzzle, velocity;      // at launch
  FidelityInUse granted;
  std::vector<TrackSample> path;  // up to the end or the limit; see thinning.hpp
  bool is_cut = false;            // by the limit: it flies on
  bool grows = false;             // Predictor::go_on() has more of it
  bool is_old = false;            // the path is that of a shot before, until that of this one is computed
  Apsides apsides;                // of the path over a round Earth
};

/// The prediction by a flight that was computed whole. It is cut if nothing that the scenario asks for ends it.
[[nodiscard]] Prediction prediction_of(const Flight& flight, const Scenario& scenario);
/// The start of a prediction: its launch and granted fidelity, with a path of one short flight.
[[nodiscard]] Prediction beginning_of(Scenario scenario, const ScenarioShot& shot);

/// Predicts the shots of one session.
class Predictor {
 public:
  /// The world is saved anew at the next prediction: the session was changed by more than steps and shots.
  void forget_world() { world_.reset(); }
  /// Flies a shot from now on until it leaves, for `max_time` [s] or a revolution about the Earth, or until it has met
  /// things a few times. Long flights are begun, with `patience` at most [s of the machine's clock]: go_on() flies on.
  [[nodiscard]] Prediction predict(const Session& session, const ScenarioShot& shot, double max_time = 200,
                                   double patience = std::numeric_limits<double>::infinity());
  /// More of the last prediction that was begun, as long as `patience` lasts [s of the machine's clock].
  void go_on(Prediction& prediction, double patience);

 private:
  [[nodiscard]] Status take_world(const Session& session);
  void fly(Prediction& prediction, std::uint64_t steps);
  void fly_at_once(Prediction& prediction, double patience);

  std::optional<World> world_;
  Snapshot empty_;  // of it, before anything is fired
  // The last prediction:
  ProjectileId id_;
  double start_ = 0;            // of the world [s]
  std::uint64_t left_ = 0;      // steps up to the limit
  std::optional<double> wall_;  // x of the wall that stops all [m]
  int hits_ = 0;                // steps in which it met things
  std::size_t thinned_ = 0;     // the number of the last sample that has been thinned out
};

}  // namespace physim::client
