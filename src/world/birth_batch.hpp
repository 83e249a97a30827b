// Birth batches: births of one emitter put into the world column by column, where nothing happens to them in the step
// that they are born in, and where nothing about them needs a look of its own. All others are born one by one, through
// a launch as a caller would give it; both do the same to the world, to the bit.
#pragma once

#include <memory>
#include <optional>
#include <span>
#include <vector>

#include "world/birth_turn.hpp"

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
  [[nodiscard]] std::size_t shared_room(const BirthPlan& plan) const;
  /// Draws, places and flies them.
  void prepare(const BirthPlan& plan, BirthColumns& births) const;
  /// How many of the next ones may be born side by side, as far as they go.
  [[nodiscard]] std::size_t plain(const BirthPlan& plan, const BirthColumns& births) const;
  /// The next ones of lines are born, in that order of lines: no more of each than plain() says. How many those were.
  std::size_t bear(std::span<BirthLine> lines, std::span<const std::uint8_t> order);
  /// The next ones of one emitter are born, at most so many. `like` has what they inherit.
  std::size_t bear(const BirthPlan& plan, BirthColumns& births, std::size_t most, const Particle& like);

 private:
  [[nodiscard]] BirthPlan find(std::uint32_t emitter) const;
  std::size_t take_places(std::span<BirthLine> lines, std::span<const std::uint8_t> order);
  void come_alive(const BirthLine& line);
  template <class S>
  void put_rows(const BirthLine& line, const NewbornFlights<S>& flights);
  void join(const BirthLine& line);
  void tell(std::span<BirthLine> lines, std::span<const std::uint8_t> order);

  WorldImpl& w_;
  const SettleContext& context_;
  double end_;
  std::vector<std::optional<BirthPlan>> plans_;  // by emitter, as far as they were asked for
  BirthLine alone_;                              // of a turn of one emitter
};

}  // namespace physim
