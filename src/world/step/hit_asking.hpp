// Hits that ask: what the function of a world said about hits of the step at hand.
//
// A row that comes to a hit without a known answer is left as it was when the step began, and its question stays
// open. When all rows have reached this state, one call asks about all open hits, and those rows repeat their step
// with the same numbers up to the same hits, now with known answers. So the consequence of an answer is that
// of a kind that does the same, to the bit, and neither threads nor the order of rows matter.
#pragma once

#include <span>
#include <string>
#include <unordered_map>
#include <vector>

#include "physim/event.hpp"

namespace physim {

struct Gate;
struct SettleContext;
struct WorldImpl;

/// A hit of a row about which nothing is known, and where the row is.
struct OpenHit {
  std::uint16_t cohort = 0;
  std::uint32_t row = 0;
  HitQuestion question;
};

/// Hits of one projectile in a step that are asked about. Each is found by flying its step from the start again, so the
/// work grows with their square.
inline constexpr std::size_t kMostAsked = 256;

class HitAsking {
 public:
  explicit HitAsking(Gate& gate) : gate_(gate) {}

  void set_function(HitFunction function);
  [[nodiscard]] bool has_function() const { return static_cast<bool>(function_); }
  [[nodiscard]] const HitFunction& function() const { return function_; }
  [[nodiscard]] const HitCounts& counts() const { return counts_; }
  [[nodiscard]] const std::string& refused() const { return refused_; }

  /// The answer to an equal question, apart from what only informs; null: none. A row with kMostAsked in the step
  /// sticks at the next one. Any number of threads may look.
  [[nodiscard]] const HitAnswer* find(const HitQuestion& question) const;
  /// Asks about all of them in one call, and remembers.
  void ask(std::span<const HitQuestion> questions);
  void forget() { known_.clear(); }

 private:
  struct Known {
    HitQuestion question;
    HitAnswer answer;
  };

  [[nodiscard]] bool call(std::span<const HitQuestion> questions, std::span<HitAnswer> answers);

  Gate& gate_;
  HitFunction function_;
  std::unordered_map<std::uint32_t, std::vector<Known>> known_;  // by slots
  HitCounts counts_;
  std::string refused_;
};

/// Asks about what the rows of a step came to, as long as something is open, and settles them.
void settle_asked(WorldImpl& world, const SettleContext& context);

}  // namespace physim
