// Generators: the force generators of a world, the order in which they act, and whom they name.
#pragma once

#include <unordered_map>
#include <vector>

#include "base/assert.hpp"
#include "base/hash.hpp"
#include "physim/body.hpp"
#include "physim/world.hpp"
#include "world/core/kinds.hpp"

namespace physim {

/// A force generator at work.
struct Generator {
  std::uint32_t generation = 1;
  bool active = false;
  bool begun = false;                // its targets are forced rows
  ForceDef def;                      // target.ids in order of slots, each once
  std::vector<ProjectileId> except;  // taken out of its kind or layers, in order of slots
  double start = 0;                  // [s]
  double end = 0;                    // [s]
};

class Generators {
 public:
  [[nodiscard]] bool empty() const { return order_.empty(); }
  /// Those that are active, in the order in which they were added and act.
  [[nodiscard]] const std::vector<std::uint32_t>& order() const { return order_; }
  /// Those begun that have a kind or layers.
  [[nodiscard]] const std::vector<std::uint32_t>& groups() const { return groups_; }
  [[nodiscard]] Generator& operator[](std::uint32_t index) {
    PHYSIM_ASSERT(index > 0 && index < all_.size());
    return all_[index];
  }
  [[nodiscard]] const Generator& operator[](std::uint32_t index) const {
    PHYSIM_ASSERT(index > 0 && index < all_.size());
    return all_[index];
  }
  [[nodiscard]] const Generator* find(ForceId id) const {
    if (id.index == 0 || id.index >= all_.size()) return nullptr;
    const Generator& g = all_[id.index];
    return g.active && g.generation == id.generation ? &g : nullptr;
  }

  ForceId add(const ForceDef& def, double now);
  /// A generator acts from now on; `in_group`: on a kind or on layers.
  void begin(std::uint32_t index, bool in_group);
  /// A generator is gone; its place is used again.
  void erase(std::uint32_t index);

  /// A generator that has begun names this slot, once more or once less.
  void count(std::uint32_t slot, bool on);
  [[nodiscard]] bool is_named(std::uint32_t slot) const { return named_.contains(slot); }
  /// The projectile of a slot is gone.
  void forget(std::uint32_t slot) {
    if (!named_.empty()) named_.erase(slot);
  }
  [[nodiscard]] const std::vector<Generator>& all() const { return all_; }  // the first is unused
  [[nodiscard]] const std::vector<std::uint32_t>& free() const { return free_; }
  /// As a save holds them; false if they are inconsistent. Generators that have begun are to be resumed then.
  bool restore(std::vector<Generator> all, std::vector<std::uint32_t> free, std::vector<std::uint32_t> order);
  /// One that has begun is in a group, or not.
  void resume(std::uint32_t index, bool in_group) {
    PHYSIM_ASSERT((*this)[index].begun);
    if (in_group) groups_.push_back(index);
  }
  [[nodiscard]] std::size_t bytes() const;
  /// In the order in which they act, and that in which their places are used again; kinds by what they are.
  void add_to(Hash& hash, const Kinds& kinds) const;

 private:
  std::vector<Generator> all_{1};  // 0 is unused
  std::vector<std::uint32_t> free_;
  std::vector<std::uint32_t> order_;
  std::vector<std::uint32_t> groups_;
  std::unordered_map<std::uint32_t, std::uint32_t> named_;  // by slot: how many begun ones name it
};

}  // namespace physim
