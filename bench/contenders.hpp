// The contenders of the benchmark, and the calibration that brings them to the same achieved error.
#pragma once

#include <functional>
#include <string>

#include "shots.hpp"

namespace physim::bench {

/// Steps that all flights of a run took together.
struct Work {
  std::int64_t steps = 0;        // accepted
  std::int64_t tries = 0;        // with the rejected ones; peers: as steps
  std::int64_t evaluations = 0;  // of the acceleration
};

struct Contender {
  std::string name;
  std::string kernel;       // instruction set; of peers, how they are compiled
  bool is_peer = false;     // another solver, not PhySim
  bool by_pilot = false;    // the setting is the error that a pilot flight aims at; else it is a tolerance
  double tightest = 1e-12;  // setting to start calibration from
  /// Flies the first `count` shots with a setting; `ends` gets their places at the range line unless it is null.
  std::function<Work(const ShotSet& set, std::size_t count, double setting, Vec3d* ends)> fly;
};

/// What a setting of PhySim's is.
[[nodiscard]] Tolerance tolerance_of(const Contender& contender, double setting);

[[nodiscard]] Contender peer(std::string name, std::string kernel, void (*fly)(PeerTask&), const PeerModel& model);
enum class BatchOf {
  launches,  // of one projectile
  shots,     // with a projectile each
  columns,   // fly_columns(): launches as columns, and the columns of kEnds out; the Work is that of the batch
};
/// fly_batch() or fly_columns() with one kernel.
[[nodiscard]] Contender batch(std::string name, std::string kernel, const Fidelity& fidelity, BatchOf what);
/// fly() for each shot, by the best kernel, with dense output and the place of the event that ends it.
[[nodiscard]] Contender single_flights(std::string name, const Fidelity& fidelity);

/// Worst and mean distance from the reference [m].
struct Miss {
  double worst = 0;
  double rms = 0;
};
[[nodiscard]] Miss miss(const Contender& contender, const ShotSet& set, std::size_t count, double setting);

struct Calibration {
  double setting = 0;
  double probe_error = 0;  // worst of the probes [m]
  bool reached = false;
};
/// The loosest setting of a grid such that it and every tighter one keeps all probes within the target: errors are not
/// monotone in the tolerance, and a lucky zero crossing is not an achievement.
[[nodiscard]] Calibration calibrate(const Contender& contender, const ShotSet& probes, double target, int per_decade);

}  // namespace physim::bench
