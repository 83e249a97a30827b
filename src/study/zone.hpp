// A zone that holds next to all shots: a polygon with edges that each touch the farthest shot in one direction.
//
// Symbols: K directions n_k evenly around, h_k = largest n_k . p over N shots p. The polygon is n_k . p <= h_k for all
// k;
//   e the part of all shots to come that lies outside. Its K numbers are the solution of a linear program with N random
//   constraints, so P(e > lambda / N) <= sum_{i < K} C(N, i) (lambda / N)^i (1 - lambda / N)^(N - i), which for
//   lambda > K is below exp(-lambda) sum_{i < K} lambda^i / i!. Lambda is chosen so that this is 5 %.
// When wrong: shots that depend on each other (occasions, Latin hypercubes, Sobol's sequence).
// Source: M. C. Campi, S. Garatti, "The Exact Feasibility of Randomized Solutions of Uncertain Convex Programs", SIAM
// J.
//   Optim. 19 (2008) 1211, theorem 1; T. W. Anderson, S. M. Samuels, "Some Inequalities among Binomial and Poisson
//   Probabilities", Proc. 5th Berkeley Symp. 1 (1967) 1, for the second bound.
#pragma once

#include <optional>
#include <span>
#include <vector>

#include "physim/study.hpp"

namespace physim {

inline constexpr std::size_t kZoneDirections = 16;

/// The farthest of some impacts in each direction; empty where there are none.
[[nodiscard]] std::vector<double> reach_of(std::span<const double> right, std::span<const double> up);
/// The zone of `shots` random shots that arrived; nothing if they are too few to say anything.
[[nodiscard]] std::optional<ZoneResult> zone_of(std::span<const double> reach, std::uint64_t shots);

}  // namespace physim
