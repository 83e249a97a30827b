// Events of a world: those since the step before, their order, and the list of them for a reader.
//
// A step with many births and deaths has an event of each, and mostly no caller reads it. So an event that holds only
// id, time, place and velocity is kept in few bytes, all others whole. What is put in order are keys alone; the list is
// made when it is read.
#pragma once

#include <algorithm>
#include <array>
#include <compare>
#include <cstdint>
#include <span>
#include <utility>
#include <vector>

#include "base/append.hpp"
#include "base/assert.hpp"
#include "base/event_table.hpp"
#include "physim/event.hpp"
#include "world/core/step_list.hpp"

namespace physim {

/// What decides the order of events, and where one stands.
struct EventKey {
  double time = 0;
  std::uint32_t slot = 0, at = 0;
  std::uint32_t place = 0;  // of what is kept of it; decides nothing, as kind and reason
  std::uint8_t order = 0;
  EventKind kind = EventKind::spawned;
  Reason reason = Reason::none;

  /// No time is NaN, and two are seldom equal.
  std::weak_ordering operator<=>(const EventKey& other) const {
    if (time != other.time) return time < other.time ? std::weak_ordering::less : std::weak_ordering::greater;
    if (slot != other.slot) return slot <=> other.slot;
    return order != other.order ? order <=> other.order : at <=> other.at;
  }
  bool operator==(const EventKey& other) const { return (*this <=> other) == 0; }
};

/// An event whose other members have their defaults.
struct PlainEvent {
  EventKind kind = EventKind::spawned;
  Reason reason = Reason::none;
  ProjectileId id;
  std::uint32_t value = 0;
  double time = 0;           // [s]
  Vec3d position, velocity;  // [m], [m/s]
};

/// Puts what it says into a blank event.
inline void put_plain(const PlainEvent& plain, Event& event) {
  event.kind = plain.kind, event.reason = plain.reason, event.id = plain.id;
  event.value = plain.value, event.time = plain.time;
  event.position = plain.position, event.velocity = plain.velocity;
}

/// Lists that were given out and grew out of their memory, or are no more.
using GivenEvents = std::vector<std::vector<Event>>;

class EventList {
 public:
  static constexpr std::size_t kMost = std::size_t{1} << 30;  ///< events; places are counted in 30 bits

  EventList() = default;
  /// Copies have all events, and have shown nothing yet.
  EventList(const EventList& other) : keys_(other.keys_), plain_(other.plain_), whole_(other.whole_) {}
  EventList& operator=(const EventList& other) {
    if (this == &other) return *this;
    keys_ = other.keys_, plain_ = other.plain_, whole_ = other.whole_;
    shown_.clear();
    return *this;
  }
  EventList(EventList&&) = default;
  EventList& operator=(EventList&&) = default;
  ~EventList() = default;

  [[nodiscard]] std::size_t size() const { return keys_.size(); }
  /// Room for more plain ones; may end for lack of memory.
  void reserve(std::size_t more) {
    make_room(keys_, more);
    make_room(plain_, more);
  }
  void add(const Event& event) {
    append(whole_, event);
    append(keys_, key_of(event, keys_.size(), place_of(whole_.size() - 1, Form::whole)));
  }
  /// Inline: its numbers come in registers, and are not read in pairs where they were just written one by one.
  PHYSIM_INLINE_ALWAYS void add(const PlainEvent& event) {
    append(plain_, plain_of(event));
    append(keys_, key_of(event, keys_.size(), place_of(plain_.size() - 1, Form::plain)));
  }
  /// Adds `count` plain ones: event(i) gives each.
  template <class F>
  void add_each(std::size_t count, const F& event) {
    reserve(count);
    const std::size_t first = keys_.size(), first_plain = plain_.size();
    keys_.resize(first + count), plain_.resize(first_plain + count);
    EventKey* const keys = keys_.data() + first;
    Plain* const plains = plain_.data() + first_plain;
    for (std::size_t i = 0; i < count; ++i) {
      const PlainEvent& e = event(i);
      keys[i] = key_of(e, first + i, place_of(first_plain + i, Form::plain));
      plains[i] = plain_of(e);
    }
  }

  /// By time, projectile and kind; events of one projectile at one time stay in the order in which they were added.
  void put_in_order(std::vector<EventKey>& spare, GivenEvents& given);
  /// All of them. What was given stays where it is until these and `given` are cleared.
  [[nodiscard]] std::span<const Event> all(GivenEvents& given) const;
  /// Calls f with each of a kind, in their order.
  template <class F>
  void each_of(EventKind kind, const F& f) const {
    for (const EventKey& key : keys_)
      if (key.kind == kind) f(kept(key));
  }
  void clear() { keys_.clear(), plain_.clear(), whole_.clear(), shown_.clear(); }
  /// Others take its place: what it gave out stays.
  void leave(GivenEvents& given) const {
    if (!shown_.empty()) given.push_back(std::exchange(shown_, {}));
  }
  [[nodiscard]] std::size_t bytes() const;

 private:
  /// What is kept of a plain one beside its key.
  struct Plain {
    std::uint32_t generation, value;
    Vec3d position, velocity;
  };
  [[nodiscard]] PHYSIM_INLINE_ALWAYS static Plain plain_of(const PlainEvent& e) {
    return {e.id.generation, e.value, e.position, e.velocity};
  }
  /// In which list an event is kept, and where.
  enum class Form : std::uint32_t { plain, whole };
  [[nodiscard]] static bool is_whole(const EventKey& key) { return static_cast<Form>(key.place % 2) == Form::whole; }
  [[nodiscard]] static std::uint32_t place_of(std::size_t at, Form form) {
    return static_cast<std::uint32_t>(2 * at) | static_cast<std::uint32_t>(form);
  }

  template <class E>
  [[nodiscard]] PHYSIM_INLINE_ALWAYS static EventKey key_of(const E& e, std::size_t at, std::uint32_t place) {
    return {e.time, e.id.index, static_cast<std::uint32_t>(at), place, row_of(e.kind).order, e.kind, e.reason};
  }
  void add_shown(const EventKey& key) const;
  [[nodiscard]] PlainEvent plain_at(const EventKey& key) const {
    const Plain& p = plain_[key.place / 2];
    return {key.kind, key.reason, {key.slot, p.generation}, p.value, key.time, p.position, p.velocity};
  }
  [[nodiscard]] Event kept(const EventKey& key) const {
    if (is_whole(key)) return whole_[key.place / 2];
    Event event;
    put_plain(plain_at(key), event);
    return event;
  }

  StepList<EventKey> keys_;
  StepList<Plain> plain_;
  StepList<Event> whole_;
  mutable StepList<Event> shown_;  // the first of them, as a caller reads them
};

}  // namespace physim
