// What is flown: the .308 shot to 1000 m with small variations, probes around it, and a mixed company.
#pragma once

#include <memory>
#include <vector>

#include "peers.hpp"
#include "physim/study.hpp"
#include "prepare/cohort.hpp"
#include "prepare/conditions.hpp"
#include "prepare/grant.hpp"
#include "prepare/launch.hpp"
#include "prepare/watch_list.hpp"

namespace physim::bench {

inline constexpr double kRange = 1000;  // where all flights end, and where their error is measured [m]

/// Shots with the exact place where each crosses the range line.
struct ShotSet {
  std::vector<Shot> shots;
  std::vector<Launch> launches;      // the same, of .308 sets only
  std::vector<PeerShot> peer_shots;  // of .308 sets only
  std::vector<Vec3d> reference;      // dop853 at 1e-13 [m]
};

/// Gravity and air are those of all benchmarks: constant, US Standard Atmosphere 1976, no wind.
[[nodiscard]] Environment bench_environment();
/// Ends at the range line; no ground.
[[nodiscard]] Until bench_until();
/// Constant gravity, drag curves by natural cubic splines.
[[nodiscard]] Fidelity bench_fidelity(Integrator integrator, Precision precision = Precision::float64);

[[nodiscard]] ShotSet probe_shots();                     ///< 64 shots, 700 to 900 m/s, 0 to 1 degree
[[nodiscard]] ShotSet uniform_shots(std::size_t count);  ///< 823 +- 15 m/s, 0.7 +- 0.3 degrees
/// Calibres 4.5 to 155 mm, 300 to 1000 m/s, 0 to 5 degrees, ballistic coefficients 0.15 to 1.0 lb/in^2, the nine
/// standard drag functions and four curves of our own. With `searched`, those have points at odd Mach numbers.
[[nodiscard]] ShotSet mixed_shots(std::size_t count, bool searched = false);

/// A rocket of the class that students fly, figures of our own: 20 kg, 3 m long, 3 s of 1500 N, fins that make two
/// calibres of stability.
[[nodiscard]] Study rocket_study();
/// The .308 with seven uncertain inputs: speed, elevation, azimuth, wind across and along, temperature, ballistic
/// coefficient. Four shards of 4096 shots.
[[nodiscard]] Study uncertain_308(const Fidelity& fidelity, const Tolerance& tolerance);

/// The .308's numbers for the peers; `cohort` owns the curve.
struct PeerData {
  Cohort cohort;
  PeerModel model;
};
[[nodiscard]] std::unique_ptr<PeerData> peer_data();

}  // namespace physim::bench
