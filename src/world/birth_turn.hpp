// Birth turns: births of several emitters, each drawn ahead in columns of its own, in the order in which they come.
#pragma once

#include <algorithm>
#include <array>
#include <cstdint>
#include <span>

#include "world/birth_columns.hpp"

namespace physim {

/// The next births of one emitter in a turn.
struct BirthLine {
  const BirthPlan* plan = nullptr;
  BirthColumns* births = nullptr;
  Particle like;  // has what they inherit

  std::size_t count = 0;  // of them that were born in the turn
  std::array<std::uint32_t, BirthColumns::kLanes> slot, row;
};

class BirthTurn {
 public:
  void begin() { count_ = 0; }
  [[nodiscard]] bool is_full() const { return count_ == kMostLines; }
  [[nodiscard]] std::span<BirthLine> lines() { return std::span(lines_).first(count_); }
  /// The next ones of another emitter, so many at most may be born in this turn. If all that are drawn are, its next
  /// moment is `then`; infinite: it has none in the step [s].
  void add(const BirthPlan& plan, BirthColumns& births, std::size_t most, double then) {
    PHYSIM_ASSERT(!is_full() && births.next + most <= births.count);
    lines_[count_].plan = &plan, lines_[count_].births = &births, lines_[count_].like = {};
    heads_[count_] = {births.time[births.next],
                      then,
                      plan.emitter,
                      static_cast<std::uint8_t>(count_),
                      static_cast<std::uint8_t>(births.next),
                      static_cast<std::uint8_t>(births.next + most)};
    ++count_;
  }
  /// Lines by the time of their births, then by emitter: at most so many, as long as is_due(line, lane) says so of the
  /// next one.
  template <class F>
  std::span<const std::uint8_t> order(std::size_t most, const F& is_due) {
    for (std::size_t at = count_ / 2; at-- > 0;) sink(at);
    most = std::min(most, order_.size());
    std::size_t size = 0;
    while (size < most) {
      Head& head = heads_[0];
      const BirthLine& line = lines_[head.line];
      if (head.next == head.end || !is_due(line, std::size_t{head.next})) break;
      order_[size++] = head.line;
      ++head.next;
      head.time = head.next < line.births->count ? line.births->time[head.next] : head.then;
      sink(0);
    }
    return std::span(order_).first(size);
  }

 private:
  static constexpr std::size_t kMostLines = 32;
  /// Where a line has come to: the lane that is next, and the one that is not born in this turn.
  struct Head {
    double time, then;
    std::uint32_t emitter;
    std::uint8_t line, next, end;

    [[nodiscard]] bool comes_before(const Head& other) const {
      return time != other.time ? time < other.time : emitter < other.emitter;
    }
  };
  /// Heads are a heap but for that one, which may come later than those below it.
  void sink(std::size_t at) {
    const Head head = heads_[at];
    for (std::size_t below = 2 * at + 1; below < count_; below = 2 * at + 1) {
      if (below + 1 < count_ && heads_[below + 1].comes_before(heads_[below])) ++below;
      if (!heads_[below].comes_before(head)) break;
      heads_[at] = heads_[below];
      at = below;
    }
    heads_[at] = head;
  }

  std::size_t count_ = 0;
  std::array<BirthLine, kMostLines> lines_;
  std::array<Head, kMostLines> heads_;
  std::array<std::uint8_t, kMostLines * BirthColumns::kLanes> order_;  // by index of lines
};

}  // namespace physim
