// Birth batches: births of one emitter are put into the world column by column, if nothing happens to them in the step
// of their birth and nothing about them needs a separate check. All others are added one by one, through a launch as a
// caller would give it. Both have the same effect on the world, to the bit.
#pragma once

#include <array>
#include <optional>
#include <vector>

#include "world/couple/birth_columns.hpp"

namespace physim {

struct WorldImpl;

class BirthBatches {
 public:
  /// A step, or a moment between two steps, that ends at `end` [s].
  BirthBatches(WorldImpl& world, const SettleContext& context, double end);

  /// How births of an emitter go side by side; null: one by one.
  [[nodiscard]] const BirthPlan* plan(std::uint32_t emitter);
  /// A lower bound on how many more it may emit now, by its own maximum and the shared limits.
  [[nodiscard]] std::size_t room(const BirthPlan& plan, std::size_t departed) const;
  /// Draws, places and flies them.
  void prepare(const BirthPlan& plan, BirthColumns& births) const;
  /// How many of the next births may be processed side by side, among those present.
  [[nodiscard]] std::size_t plain(const BirthPlan& plan, const BirthColumns& births) const;
  /// Adds the next births of one emitter, at most `most`. `like` has what they inherit.
  std::size_t bear(const BirthPlan& plan, BirthColumns& births, std::size_t most, const Particle& like);

 private:
  [[nodiscard]] BirthPlan find(std::uint32_t emitter) const;
  std::size_t take_places(const BirthPlan& plan, std::size_t most);
  void come_alive(const BirthPlan& plan, const BirthColumns& births, std::size_t count);
  template <class S>
  void put_rows(const BirthPlan& plan, const BirthColumns& births, const FlownParts<S>& flights, std::size_t count);
  void join(const BirthPlan& plan, const BirthColumns& births, Particle like, std::size_t count);
  template <class S>
  void tell(const BirthPlan& plan, const BirthColumns& births, const FlownParts<S>& flights, std::size_t count);

  WorldImpl& w_;
  const SettleContext& context_;
  double end_;
  std::vector<std::optional<BirthPlan>> plans_;                 // by emitter, as far as they were asked for
  std::array<std::uint32_t, BirthColumns::kLanes> slot_, row_;  // of the births at hand
};

}  // namespace physim
