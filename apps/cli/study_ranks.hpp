// Ranks of an MPI job (`mpirun -n 64 physim study FILE`) that fly one study: the first hands out shards, a few at a
// time to whoever asks and to itself, and joins what comes back. Shards are joined in the tree that threads join
// them in, so the bits are theirs.
#pragma once

#include <functional>

#include "study/engine.hpp"

namespace physim::cli {

/// This program's place in its job: alone where none was started, or MPI was not there when it was built.
class Ranks {
 public:
  /// Joins the job.
  Ranks();
  /// Leaves it; the first rank lets the others go.
  ~Ranks();
  Ranks(const Ranks&) = delete;
  Ranks& operator=(const Ranks&) = delete;

  /// An error where there is a job and this build knows no MPI.
  [[nodiscard]] Status status() const;
  [[nodiscard]] int number() const { return number_; }
  [[nodiscard]] unsigned count() const { return static_cast<unsigned>(count_); }

  /// The first rank: flies what is missing before `end` with all others; stopped by `options`, or by what failed()
  /// tells.
  [[nodiscard]] Flown fly(const StudyPlan& plan, StudyPartRecord& part, std::uint64_t end, const StudyOptions& options);
  [[nodiscard]] const Status& failed() const { return failed_; }
  /// The job was ended from outside while fly() was at it. The launcher kills what is left of it within a second, and a
  /// thread is still at its shard: keep what there is, and end the program without looking back.
  [[nodiscard]] bool was_ended() const { return was_ended_; }

  /// Another rank: flies what it is told to, until it is let go.
  void serve(const StudyPlan& plan);
  /// Another rank that cannot: tells the first why.
  void give_up(const Error& error);

 private:
  struct Round;
  /// So many shards from one on; none: it is over.
  struct Order {
    std::uint64_t first = 0, count = 0;
  };
  [[nodiscard]] bool hear(Round& round);
  void take_in(Round& round, int from, std::span<const std::byte> bytes);
  void keep(Round& round, const StudyPart& flown);
  void order(int rank, const Order& order);

  int number_ = 0, count_ = 1;
  bool joined_ = false, was_ended_ = false;
  std::vector<int> idle_;  // ranks that wait for an order
  Status failed_;
};

}  // namespace physim::cli
