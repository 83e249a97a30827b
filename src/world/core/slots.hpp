// Slots: what a world keeps of each projectile that its models do not read, at a place that never moves.
#pragma once

#include <cstdint>
#include <map>
#include <string>
#include <unordered_map>
#include <utility>
#include <vector>

#include "base/assert.hpp"
#include "base/prefetch.hpp"
#include "model/turning.hpp"
#include "physim/body.hpp"
#include "world/core/live.hpp"
#include "world/core/registry.hpp"

namespace physim {

/// Bits of Slot::flags.
enum SlotFlag : std::uint32_t {
  kAlive = 1u << 0,
  kAsleep = 1u << 1,
  kKinematic = 1u << 2,
  kInfiniteMass = 1u << 3,
  kPending = 1u << 4,
  kStuck = 1u << 5,  // landed where it stays
  kForced = 1u << 6,
  // bits 7, 8: kOwnParts
  kSleepless = 1u << 9,
  kTurning = 1u << 10,  // has an orientation of its own
  kRailed = 1u << 11,   // started on a rail
  kPiled = 1u << 22,    // went to sleep in a pile, or below it
  kStill = kAsleep | kKinematic | kInfiniteMass | kPending | kStuck,
};
static_assert((kOwn & (kStill | kAlive | kForced | kSleepless | kTurning | kRailed | kPiled)) == 0,
              "each flag has a bit");
inline constexpr unsigned kStatusShift = 16;     // LifeStatus, 3 bits
inline constexpr unsigned kSmoothingShift = 20;  // Smoothing, 2 bits
inline constexpr std::uint32_t kAllFlags = kStill | kAlive | kForced | kOwn | kSleepless | kTurning | kRailed | kPiled |
                                           7u << kStatusShift | 3u << kSmoothingShift;

struct Slot {
  std::uint32_t generation = 0;
  std::uint32_t row = 0;  // in its cohort
  std::uint32_t kind = 0;
  std::uint32_t flags = 0;
  std::uint16_t cohort = 0;
  std::uint16_t rung = 0;

  [[nodiscard]] bool is(std::uint32_t flag) const { return (flags & flag) != 0; }
  void set(std::uint32_t flag, bool on) { flags = on ? flags | flag : flags & ~flag; }
  [[nodiscard]] LifeStatus status() const { return static_cast<LifeStatus>(flags >> kStatusShift & 7u); }
  void set_status(LifeStatus s) {
    flags = (flags & ~(7u << kStatusShift)) | static_cast<std::uint32_t>(s) << kStatusShift;
  }
  [[nodiscard]] Smoothing smoothing() const { return static_cast<Smoothing>(flags >> kSmoothingShift & 3u); }
  void set_smoothing(Smoothing s) {
    flags = (flags & ~(3u << kSmoothingShift)) | static_cast<std::uint32_t>(s) << kSmoothingShift;
  }
  [[nodiscard]] Variant variant() const {
    const auto own = [this]<std::size_t... I>(std::index_sequence<I...>) {
      return ((is(kOwnParts[I].flag) ? 1u << I : 0u) | ...);
    };
    return {is(kForced), is(kStill), is(kSleepless), is(kRailed), own(std::make_index_sequence<kOwnParts.size()>())};
  }
};

/// How long a projectile has been at rest.
struct Rest {
  std::uint32_t step = 0;  // the last one in which it rested (low bits)
  float time = 0;          // in steps without a break [s]

  /// It rested in a step, too.
  void count(std::uint64_t steps, double dt) {
    const auto now = static_cast<std::uint32_t>(steps);
    if (step + 1 != now) time = 0;
    step = now;
    time += static_cast<float>(dt);
  }
};

/// Slots that are free, in the order in which they became so. A ring: those that are used soon can be seen ahead.
class FreeSlots {
 public:
  [[nodiscard]] std::uint32_t size() const { return count_; }
  /// The one that is used when so many others have been.
  [[nodiscard]] std::uint32_t ahead(std::uint32_t others) const {
    PHYSIM_ASSERT(others < count_);
    return ring_[(first_ + others) & (ring_.size() - 1)];
  }
  std::uint32_t take() {
    const std::uint32_t slot = ahead(0);
    first_ = (first_ + 1) & (ring_.size() - 1);
    --count_;
    return slot;
  }
  /// There is room, see reserve().
  void add(std::uint32_t slot) {
    PHYSIM_ASSERT(count_ < ring_.size());
    ring_[(first_ + count_++) & (ring_.size() - 1)] = slot;
  }
  /// Room for so many in all.
  void reserve(std::size_t slots);
  [[nodiscard]] std::size_t bytes() const { return ring_.capacity() * sizeof(std::uint32_t); }

 private:
  std::vector<std::uint32_t> ring_;  // as long as a power of two, or empty
  std::size_t first_ = 0;
  std::uint32_t count_ = 0;
};

/// The slots of a world: who is there, who was, and which are free. Index 0 is nobody's.
class SlotTable {
 public:
  [[nodiscard]] std::uint32_t size() const { return static_cast<std::uint32_t>(slots_.size()); }
  [[nodiscard]] std::uint32_t alive() const { return alive_; }
  [[nodiscard]] Slot& operator[](std::uint32_t index) {
    PHYSIM_ASSERT(index > 0 && index < slots_.size());
    return slots_[index];
  }
  [[nodiscard]] const Slot& operator[](std::uint32_t index) const {
    PHYSIM_ASSERT(index > 0 && index < slots_.size());
    return slots_[index];
  }
  /// The slot of a projectile that is alive; null otherwise.
  [[nodiscard]] const Slot* find(ProjectileId id) const {
    if (id.index >= slots_.size()) return nullptr;
    const Slot& slot = slots_[id.index];
    return slot.generation == id.generation && slot.is(kAlive) ? &slot : nullptr;
  }
  [[nodiscard]] ProjectileId id_of(std::uint32_t index) const { return {index, (*this)[index].generation}; }
  [[nodiscard]] std::uint32_t index_of(const Slot& slot) const {
    PHYSIM_ASSERT(&slot > slots_.data() && &slot < slots_.data() + slots_.size());
    return static_cast<std::uint32_t>(&slot - slots_.data());
  }
  /// Time of launch [s].
  [[nodiscard]] double& birth(std::uint32_t index) {
    PHYSIM_ASSERT(index < birth_.size());
    return birth_[index];
  }
  [[nodiscard]] double birth(std::uint32_t index) const {
    PHYSIM_ASSERT(index < birth_.size());
    return birth_[index];
  }
  [[nodiscard]] Rest& rest(std::uint32_t index) {
    PHYSIM_ASSERT(index < rest_.size());
    return rest_[index];
  }
  [[nodiscard]] const Rest& rest(std::uint32_t index) const {
    PHYSIM_ASSERT(index < rest_.size());
    return rest_[index];
  }

  /// A slot for a new projectile, of a new generation. It is not alive before come_alive().
  std::uint32_t take() {
    constexpr std::uint32_t kAhead = 8;
    if (free_.size() == 0) return take_new();
    const std::uint32_t index = free_.take();
    PHYSIM_ASSERT(!slots_[index].is(kAlive));
    if (free_.size() > kAhead) prefetch_free(free_.ahead(kAhead));  // they lie all over the memory
    ++slots_[index].generation;
    return index;
  }
  /// `flags` of a projectile that is there from now on.
  void come_alive(std::uint32_t index, std::uint32_t flags) {
    Slot& slot = (*this)[index];
    PHYSIM_ASSERT(!slot.is(kAlive) && (flags & kAlive) == 0);
    slot.flags = kAlive | flags;
    ++alive_;
  }
  /// Its projectile is gone, or never came alive. Slots are used again in the order they became free, so that what
  /// became of a projectile is known for long.
  void release(std::uint32_t index, LifeStatus status) {
    Slot& slot = (*this)[index];
    if (slot.is(kAlive)) {
      PHYSIM_ASSERT(alive_ > 0);
      --alive_;
    }
    slot.flags = 0;
    slot.set_status(status);
    slot.row = 0;
    free_.add(index);
  }
  void reserve(std::size_t more);
  [[nodiscard]] std::size_t bytes() const;
  void prefetch(std::uint32_t index) const {
    if (index < slots_.size()) prefetch_at(&slots_[index]);
  }
  /// What is written where a projectile comes.
  void prefetch_free(std::uint32_t index) const {
    prefetch_at(&slots_[index]);
    prefetch_at(&birth_[index]);
    prefetch_at(&rest_[index]);
  }
  void prefetch_birth(std::uint32_t index) const {
    if (index < birth_.size()) prefetch_at(&birth_[index]);
  }

  /// Calls f with the index of every slot that is alive, in order.
  template <class F>
  void each_alive(const F& f) const {
    for (std::uint32_t index = 1; index < slots_.size(); ++index)
      if (slots_[index].is(kAlive)) f(index);
  }
  /// As a save tells them: all slots, the first nobody's, and the free ones in the order in which they are used again.
  void restore(std::vector<Slot> slots, const std::vector<std::uint32_t>& free);
  /// Calls f with the index of every free slot, in the order in which they are used again.
  template <class F>
  void each_free(const F& f) const {
    for (std::uint32_t i = 0; i < free_.size(); ++i) f(free_.ahead(i));
  }

 private:
  std::uint32_t take_new();

  std::vector<Slot> slots_{1};
  std::vector<double> birth_{0.0};
  std::vector<Rest> rest_{1};
  FreeSlots free_;
  std::uint32_t alive_ = 0;
};

/// Carried along for the user.
struct Tags {
  std::uint64_t user_data = 0;
  std::uint32_t layers = 1;
  std::uint32_t colour = 0xffffffff;
  std::string label;
};

/// What few projectiles have of their own, by slot.
struct Extras {
  std::unordered_map<std::uint32_t, Own> own;
  std::unordered_map<std::uint32_t, Tags> tags;
  std::map<std::uint32_t, Turning> turning;  // in order

  [[nodiscard]] const Own* find_own(std::uint32_t slot) const { return find(own, slot); }
  /// Its own, or none.
  [[nodiscard]] const Own& own_of(std::uint32_t slot) const {
    static const Own none{};
    const Own* found = find_own(slot);
    return found ? *found : none;
  }
  [[nodiscard]] const Tags* find_tags(std::uint32_t slot) const { return find(tags, slot); }
  [[nodiscard]] const Turning* find_turning(std::uint32_t slot) const { return find(turning, slot); }
  [[nodiscard]] std::size_t bytes() const {
    constexpr std::size_t kNode = 48;  // of a table
    return own.size() * (sizeof(Own) + kNode) + tags.size() * (sizeof(Tags) + kNode) +
           turning.size() * (sizeof(Turning) + kNode);
  }
  /// 1 along axes about which a projectile turns, 0 along others [-]; `usual`: frozen axes of its kind.
  [[nodiscard]] Vec3d turns(std::uint32_t slot, Axes usual) const {
    const Own* found = find_own(slot);
    return free_axes(found ? found->frozen_rotation : usual);
  }
  void forget(std::uint32_t slot) {
    if (!own.empty()) own.erase(slot);
    if (!tags.empty()) tags.erase(slot);
    if (!turning.empty()) turning.erase(slot);
  }

 private:
  template <class Map>
  static const typename Map::mapped_type* find(const Map& map, std::uint32_t slot) {
    const auto found = map.find(slot);
    return found == map.end() ? nullptr : &found->second;
  }
};

}  // namespace physim
