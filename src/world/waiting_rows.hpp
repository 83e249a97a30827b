// Which rows of a cohort of closed forms wait: nothing can happen to them before a known step, and nobody has read
// where they are since some step. They are known by words of 32 rows, as the marks of a step are.
#pragma once

#include <cstdint>
#include <limits>
#include <vector>

#include "base/assert.hpp"

namespace physim {

struct WorldCohort;

/// Whether rows may wait at all; they always may but in tests that compare with worlds where every row is stepped.
bool rows_may_wait();
void let_rows_wait(bool may);

/// Whether the rows of a cohort may, as far as it alone decides: they fly by a closed form, alone, and a step watches
/// nothing of them that quiet_packs_of() does not bound.
[[nodiscard]] bool may_wait(const WorldCohort& cohort);

/// What the clocks of a word's rows show, where all of them show the same: see RowColumns.
struct WordClock {
  double offset = 0;
  double born = std::numeric_limits<double>::quiet_NaN();

  /// Else each row has its own.
  [[nodiscard]] PHYSIM_INLINE bool is_one() const { return born == born; }
};

/// What is known of the words of one cohort. Steps are counted as rows count them (Clock::now()).
class WaitingRows {
 public:
  /// By what rows are brought up to date; null: none waits.
  [[nodiscard]] const WorldCohort* cohort() const { return cohort_; }
  /// From the coming step on, which has this number and length [s].
  void begin(const WorldCohort& cohort, std::uint32_t now, double dt, std::uint32_t rows);
  void end() { cohort_ = nullptr; }
  /// Whether steps of that length go on.
  [[nodiscard]] bool goes_on(const WorldCohort* cohort, double dt) const { return cohort_ == cohort && dt_ == dt; }

  [[nodiscard]] std::uint32_t now() const { return now_; }
  [[nodiscard]] double dt() const { return dt_; }
  void tick() { ++now_; }

  /// The step at whose start a word's columns are right.
  [[nodiscard]] std::uint32_t right_at(std::uint32_t word) const {
    PHYSIM_ASSERT(word < right_at_.size());
    return __atomic_load_n(&right_at_[word], __ATOMIC_ACQUIRE);
  }
  [[nodiscard]] bool is_stale(std::uint32_t word) const { return right_at(word) < now_; }
  /// To be said after the columns were written.
  void set_right(std::uint32_t word, std::uint32_t step) {
    PHYSIM_ASSERT(word < right_at_.size());
    __atomic_store_n(&right_at_[word], step, __ATOMIC_RELEASE);
  }
  /// The step at hand took it along: its rows may have been launched anew.
  void set_stepped(std::uint32_t word) {
    set_right(word, now_ + 1);
    clock_[word] = {};
  }
  /// Whether the coming step has to take it along.
  [[nodiscard]] bool is_due(std::uint32_t word) const { return due_[word] <= now_; }
  [[nodiscard]] bool any_due(std::uint32_t first, std::uint32_t last) const;
  /// One of its rows was changed: nothing is known of it.
  void forget(std::uint32_t word);
  /// A row that another word's rows end with comes into it.
  void join(std::uint32_t word, std::uint32_t other);
  /// A word more.
  void add(std::uint32_t word);

  /// Whether it is time to ask how long a word that was stepped may wait.
  [[nodiscard]] bool wants_look(std::uint32_t word) const { return look_[word] <= now_ + 1; }
  /// Asks `quiet(steps)`, whether nothing happens to a word in so many steps after the one at hand. Whether it waits.
  template <class Quiet>
  bool look(std::uint32_t word, const Quiet& quiet) {
    int reach = reach_[word] < kMostReach ? reach_[word] + 1 : kMostReach;
    while (reach >= 0 && !quiet(steps_of(reach))) --reach;
    if (reach >= 0) {
      reach_[word] = static_cast<std::uint8_t>(reach), failed_[word] = 0;
      due_[word] = now_ + 1 + steps_of(reach);
      look_[word] = 0;
    } else {
      reach_[word] = 0;
      due_[word] = 0;
      look_[word] = now_ + 1 + (kLeastSteps << failed_[word]);
      if (failed_[word] < kMostFailed) ++failed_[word];
    }
    return reach >= 0;
  }
  /// Clocks of words that wait, by word; others may be those of each row.
  [[nodiscard]] const WordClock* clocks() const { return clock_.data(); }
  void set_clock(std::uint32_t word, const WordClock& clock) { clock_[word] = clock; }
  [[nodiscard]] std::size_t bytes() const {
    return right_at_.capacity() * (3 * sizeof(std::uint32_t) + 2 + sizeof(WordClock));
  }

 private:
  /// A wait shorter than that does not pay for the look; waits are so long times a power of four.
  static constexpr std::uint32_t kLeastSteps = 16;
  static constexpr int kMostReach = 4;
  static constexpr std::uint8_t kMostFailed = 2;
  /// Steps that a changed word is taken along before anybody asks.
  static constexpr std::uint32_t kStepsAfterChange = 8;
  [[nodiscard]] static std::uint32_t steps_of(int reach) { return kLeastSteps << (2 * reach); }

  const WorldCohort* cohort_ = nullptr;
  std::uint32_t now_ = 0;
  double dt_ = 0;
  // By word:
  std::vector<std::uint32_t> right_at_;
  std::vector<std::uint32_t> due_;    // the first step that has to take it along
  std::vector<std::uint32_t> look_;   // the first step after which to ask how long it may wait
  std::vector<std::uint8_t> reach_;   // how far the last look reached
  std::vector<std::uint8_t> failed_;  // looks one after the other
  std::vector<WordClock> clock_;
};

}  // namespace physim
