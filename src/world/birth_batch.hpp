// Birth batches: births of one emitter put into the world column by column, where nothing happens to them in the step
// that they are born in, and where nothing about them needs a look of its own. All others are born one by one, through
// a launch as a caller would give it; both do the same to the world, to the bit.
#pragma once

#include <memory>
#include <optional>
#include <vector>

#include "world/birth_columns.hpp"

namespace physim {

struct WorldImpl;

class BirthBatches {
 public:
  /// A step, or a moment between two steps, that ends at `end` [s].
  BirthBatches(WorldImpl& world, const SettleContext& context, double end);

  /// How births of an emitter go side by side; null: one by one.
  [[nodiscard]] const BirthPlan* plan(std::uint32_t emitter);
  /// How many more it may let out now, at least.
  [[nodiscard]] std::size_t room(const BirthPlan& plan, std::size_t departed) const;
  /// Draws, places and flies them.
  void prepare(const BirthPlan& plan, BirthColumns& births) const;
  /// The next ones are born, at most so many, as long as each may be born side by side; how many those were. `like` has
  /// what they inherit.
  std::size_t bear(const BirthPlan& plan, BirthColumns& births, std::size_t most, const Particle& like);

 private:
  [[nodiscard]] BirthPlan find(std::uint32_t emitter) const;
  void take_places(const BirthPlan& plan, std::size_t count);
  void come_alive(const BirthPlan& plan, const BirthColumns& births);
  template <class S>
  void put_rows(const BirthPlan& plan, const BirthColumns& births, const NewbornFlights<S>& flights);
  template <class S>
  void tell(const BirthPlan& plan, const BirthColumns& births, const NewbornFlights<S>& flights);

  WorldImpl& w_;
  const SettleContext& context_;
  double end_;
  std::vector<std::optional<BirthPlan>> plans_;            // by emitter, as far as they were asked for
  std::array<std::uint32_t, BirthColumns::kLanes> slots_;  // of those that are being born
  std::size_t count_ = 0;                                  // how many those are
};

}  // namespace physim
