// Birth batches: births of one emitter put into the world column by column, where nothing happens to them in the step
// that they are born in, and where nothing about them needs a look of its own. All others are born one by one, through
// a launch as a caller would give it; both do the same to the world, to the bit.
#pragma once

#include <array>
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
  /// How many more it may let out now, at least, by its own maximum and by what all share.
  [[nodiscard]] std::size_t room(const BirthPlan& plan, std::size_t departed) const;
  /// Draws, places and flies them.
  void prepare(const BirthPlan& plan, BirthColumns& births) const;
  /// How many of the next ones may be born side by side, as far as they go.
  [[nodiscard]] std::size_t plain(const BirthPlan& plan, const BirthColumns& births) const;
  /// The next ones of one emitter are born, at most so many. `like` has what they inherit.
  std::size_t bear(const BirthPlan& plan, BirthColumns& births, std::size_t most, const Particle& like);

 private:
  [[nodiscard]] BirthPlan find(std::uint32_t emitter) const;
  std::size_t take_places(const BirthPlan& plan, std::size_t most);
  void come_alive(const BirthPlan& plan, const BirthColumns& births, std::size_t count);
  template <class S>
  void put_rows(const BirthPlan& plan, const BirthColumns& births, const NewbornFlights<S>& flights, std::size_t count);
  void join(const BirthPlan& plan, const BirthColumns& births, Particle like, std::size_t count);
  template <class S>
  void tell(const BirthPlan& plan, const BirthColumns& births, const NewbornFlights<S>& flights, std::size_t count);

  WorldImpl& w_;
  const SettleContext& context_;
  double end_;
  std::vector<std::optional<BirthPlan>> plans_;                 // by emitter, as far as they were asked for
  std::array<std::uint32_t, BirthColumns::kLanes> slot_, row_;  // of the births at hand
};

}  // namespace physim
