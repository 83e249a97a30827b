// Kinds: the kinds of projectiles of a world, each on the rungs that it was asked for.
//
// A kind that was asked for by add_kind() stays as long as its world. One that a spawn() made is idle when its last
// projectile is gone; when there are many idle ones the one idle for the longest is forgotten: its number means nothing
// any more. Which are forgotten follows from the calls alone, so that replays and saves agree. What a forgotten kind
// holds is let go when no snapshot is left in which it has a projectile.
#pragma once

#include <deque>
#include <memory>
#include <optional>
#include <unordered_map>
#include <vector>

#include "base/assert.hpp"
#include "physim/body.hpp"
#include "prepare/cohort.hpp"
#include "prepare/equivalent_drag.hpp"
#include "world/core/live.hpp"
#include "world/core/living.hpp"

namespace physim {

inline constexpr std::size_t kMostKinds = 1u << 20;  // at once
inline constexpr std::size_t kMostIdleKinds = 256;
inline constexpr unsigned kVariants = 16u << kOwnParts.size();
inline constexpr std::uint16_t kNoCohort = 0xffff;

/// A kind on one rung.
struct Prepared {
  Fidelity asked;
  std::optional<FidelityNote> chosen;  // why, where it was not asked for by name
  FidelityInUse in_use;
  Features features;
  Body<double> body;                                // of everything but the launch
  std::unique_ptr<Rotor<double>> rotor;             // the same, of rungs that turn
  std::unique_ptr<EquivalentDrag> equivalent_drag;  // where k2 is that of the drag equation at launch
  std::uint64_t hash = 0;                           // of the kind and the rung asked for
  std::uint16_t cohort[kVariants];
};

struct Kind {
  ProjectileDef projectile;
  BodyDef body;
  ProjectileDef flown;         // the projectile with its drag scaled as its body says: what the models are given
  std::uint32_t flags = 0;     // SlotFlags that its body sets
  std::deque<Prepared> rungs;  // the first is its own

  /// Most are on the first, which is found without dividing.
  [[nodiscard]] const Prepared& on(std::uint16_t rung) const {
    PHYSIM_ASSERT(rung < rungs.size());
    return rung == 0 ? rungs.front() : rungs[rung];
  }

  std::uint32_t number = 0;       // as in KindId
  std::uint64_t hash = 0;         // of projectile and body
  std::uint32_t alive = 0;        // projectiles of it
  bool stays = false;             // add_kind() was asked for it
  bool forgotten = false;         // its number means nothing any more
  std::uint64_t idle_since = 0;   // counts the times that a kind became idle; 0: it is not
  std::uint64_t born = 0;         // snapshots taken before
  std::uint64_t last_needed = 0;  // the last snapshot that may hold a projectile of it
};

class Kinds {
 public:
  [[nodiscard]] const Kind& operator[](std::uint32_t index) const {
    PHYSIM_ASSERT(index > 0 && index <= all_.size() && all_[index - 1]);
    return *all_[index - 1];
  }
  [[nodiscard]] Kind& operator[](std::uint32_t index) { return const_cast<Kind&>(std::as_const(*this)[index]); }
  /// The index of a kind with this number; 0 if not found.
  [[nodiscard]] std::uint32_t find(KindId id) const {
    // Indices are numbers until a kind was let go.
    if (id.index > 0 && id.index <= all_.size()) {
      const Kind* const kind = all_[id.index - 1].get();
      if (kind && kind->number == id.index && !kind->forgotten) return id.index;
    }
    const auto at = by_number_.find(id.index);
    return at == by_number_.end() ? 0 : at->second;
  }
  /// The hash of the definitions of a kind; 0 where its number means nothing.
  [[nodiscard]] std::uint64_t hash_of(KindId id) const {
    const std::uint32_t index = find(id);
    return index == 0 ? 0 : (*this)[index].hash;
  }
  /// The index of a kind with equal definitions; 0 if not found.
  [[nodiscard]] std::uint32_t find(std::uint64_t hash, const ProjectileDef& projectile, const BodyDef& body) const;
  [[nodiscard]] bool is(std::uint32_t index, const ProjectileDef& projectile, const BodyDef& body) const {
    return (*this)[index].projectile == projectile && (*this)[index].body == body;
  }
  [[nodiscard]] bool is_full() const { return by_number_.size() >= kMostKinds; }
  [[nodiscard]] bool is_new() const { return last_number_ == 0; }
  /// Whether there ever was one that meets other projectiles.
  [[nodiscard]] bool meet_others() const { return meet_others_; }

  /// Adds a kind with a new number, or one from a save; returns its index. It is idle.
  std::uint32_t add(Kind kind);
  /// Keeps it, whether it is in use or not.
  void keep(std::uint32_t index);
  /// Counts `count` new projectiles of it, or one that left; `moment`: snapshots taken before.
  void join(std::uint32_t index, std::uint32_t count = 1) {
    Kind& kind = (*this)[index];
    PHYSIM_ASSERT(!kind.forgotten && count > 0);
    kind.alive += count;
    if (kind.idle_since != 0) become_busy(kind);
  }
  void leave(std::uint32_t index, std::uint64_t moment, const Living& living) {
    Kind& kind = (*this)[index];
    PHYSIM_ASSERT(kind.alive > 0);
    kind.last_needed = moment;
    if (--kind.alive > 0 || kind.stays) return;
    become_idle(index);
    forget_idle(living);
  }
  /// Lets idle kinds go where there are too many.
  void forget_idle(const Living& living);
  /// After a restore: counts the projectiles. `count` calls its argument with the index of the kind of each projectile.
  template <class F>
  void recount(std::uint64_t moment, const F& count) {
    begin_recount();
    count([this](std::uint32_t index) { ++(*this)[index].alive; });
    end_recount(moment);
  }

  /// Calls f with every kind that is held, forgotten or not.
  template <class F>
  void each(const F& f) {
    for (auto& kind : all_)
      if (kind) f(*kind);
  }
  /// Those that are known, by number; those of them that are idle, the longest first.
  [[nodiscard]] std::vector<const Kind*> known() const;
  [[nodiscard]] std::vector<std::uint32_t> idle_numbers() const;
  [[nodiscard]] std::uint32_t last_number() const { return last_number_; }
  void go_on_from(std::uint32_t last_number, const std::vector<std::uint32_t>& idle);
  [[nodiscard]] std::size_t bytes() const;

 private:
  struct Idle {
    std::uint32_t index;
    std::uint64_t since;
  };

  void become_idle(std::uint32_t index);
  void become_busy(Kind& kind);
  void remember(std::uint32_t index);
  void forget(std::uint32_t index);
  void let_go(const Living& living);
  void begin_recount();
  void end_recount(std::uint64_t moment);
  [[nodiscard]] bool is_stale(const Idle& idle) const {
    const auto& kind = all_[idle.index - 1];
    return !kind || kind->idle_since != idle.since;
  }

  std::vector<std::unique_ptr<Kind>> all_;  // by index - 1; null where one was let go
  std::vector<std::uint32_t> free_;
  std::unordered_map<std::uint32_t, std::uint32_t> by_number_;
  std::unordered_multimap<std::uint64_t, std::uint32_t> by_hash_;
  std::uint32_t last_number_ = 0;
  bool meet_others_ = false;
  std::deque<Idle> idle_;  // the longest first; some are idle no more
  std::size_t idle_count_ = 0;
  std::uint64_t idle_turns_ = 0;
  std::vector<std::uint32_t> forgotten_;  // and still held
  std::size_t look_at_ = 64;              // forgotten ones, at this number of them
};

}  // namespace physim
