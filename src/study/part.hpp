// Sums of shards, joined in one tree whatever order they come in.
//
// Shards 2k and 2k + 1 are joined, then pairs of pairs, and so on: a node of 2^j shards begins at a multiple of 2^j.
// What the first n shards come to is the join, from left to right, of the largest nodes that these are made of. So the
// bits of a result depend on n alone, and no more than about log2(n) nodes are there when shards come in their order.
#pragma once

#include <cstdint>
#include <map>
#include <memory>

#include "physim/study.hpp"
#include "study/sums.hpp"

namespace physim {

struct StudyPartRecord {
  struct Node {
    std::uint64_t count = 0;  // of shards: a power of two
    std::shared_ptr<const ShardSums> sums;
  };
  std::uint64_t hash = 0;               // of the study; 0: of none yet
  std::map<std::uint64_t, Node> nodes;  // by their first shard

  [[nodiscard]] bool has(std::uint64_t shard) const;
  /// The first shard, from one on, that it does not have.
  [[nodiscard]] std::uint64_t missing_from(std::uint64_t shard) const;
  /// Takes in a node that overlaps none.
  void add(std::uint64_t first, Node node);
  /// The first node that has one of `count` shards from `first` on; the end if none has.
  [[nodiscard]] std::map<std::uint64_t, Node>::const_iterator first_in(std::uint64_t first, std::uint64_t count) const;
  /// Says which of the first n shards it does not have.
  [[nodiscard]] Error missing_of(std::uint64_t n) const;
  /// What the first n shards come to.
  [[nodiscard]] Result<std::shared_ptr<const ShardSums>> first_shards(std::uint64_t n) const;
};

/// The shards that either part has. Those that both have are the same: their bits follow from the study. An error for
/// parts of different studies.
[[nodiscard]] Result<StudyPart> united(const StudyPart& a, const StudyPart& b);

}  // namespace physim
