// What shards of a study come to, in a form that can be joined: memory stays the same however many shots there are.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "physim/study.hpp"
#include "study/moments.hpp"

namespace physim {

inline constexpr std::size_t kWorstShots = 10;

/// Distances from a point, or spreads of groups.
struct DistanceSums {
  SampleMoments moments;
  CountedCells cells;
};

struct SumOfShot {
  std::uint64_t shot = 0;
  double distance = 0;  // from the aim [m]
};

/// Sums of Sobol indices over the shots of which all flights arrived; see study/indices.hpp.
struct IndexSums {
  std::vector<std::uint64_t> counts;  // of each group of inputs
  std::vector<double> first;          // of each group and quantity
  std::vector<double> total;
};

/// One of the parts of a study from which errors are estimated.
struct Replicate {
  std::uint64_t shots = 0;
  SampleMoments moments;
  std::vector<std::uint64_t> hits;  // of each target
  IndexSums indices;
};

/// What the shots of some shards from the first on came to.
struct StageSums {
  std::uint64_t shots = 0;
  std::vector<std::uint64_t> hits;  // of each target
  SampleMoments distance;           // from the aim; without a plane the first quantity
};

/// The first shot that was refused.
struct FirstRefusal {
  std::uint64_t shot = 0;
  std::string message, place, hint;
};

/// Shots and hits by the part of an input's distribution that the shot's number lies in; see study/over_inputs.hpp.
struct PartSums {
  std::vector<std::uint64_t> shots;  // of each input, each part
  std::vector<std::uint64_t> hits;   // ... each target
};

/// What every part of a study holds.
struct CommonSums {
  std::uint64_t shots = 0;
  std::uint64_t refused = 0;
  std::uint64_t not_arrived = 0;
  std::optional<FirstRefusal> refusal;
  SampleMoments moments;  // of all quantities
  std::vector<CountedCells> cells;
  DistanceSums from_aim, from_centre, in_space;
  std::vector<DistanceSums> spreads;  // of each group size
  std::vector<std::uint64_t> hits;    // of each target
  std::vector<SumOfShot> worst;       // the worst first
  std::vector<double> reach;          // farthest in each direction of the zone; none: no shot arrived
  std::vector<Replicate> replicates;  // kReplicates of them
  std::vector<StageSums> stages;      // the last of them is of all shots
};

/// Distances of a replicate, and spreads: the errors of their means are estimated from them.
struct ReplicateDistances {
  SampleMoments from_aim, from_centre, in_space;
  std::vector<SampleMoments> spreads;  // of each group size
};

struct ShardSums : CommonSums {
  std::vector<PartSums> over_inputs;          // of each replicate; empty: not asked for
  std::vector<ReplicateDistances> distances;  // of each replicate; empty: shots know nothing of each other
  std::vector<ShardSums> places;              // of each of Study::at
};

/// Takes in the shards that follow.
void join(ShardSums& all, const ShardSums& later);
/// Puts a shot behind all that are as bad, and keeps the worst.
void put_worst(std::vector<SumOfShot>& shots, const SumOfShot& shot);
/// Keeps the worst, in order.
void keep_worst(std::vector<SumOfShot>& shots);

}  // namespace physim
