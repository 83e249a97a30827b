// Events of a world: what was told since the step before, in which order, and the list of it that somebody reads.
//
// A step with many births and deaths tells an event of each, and mostly nobody reads it. So an event that says who,
// when, where and how fast, in numbers that float32 holds, is kept in few bytes, all others whole. What is put in order
// are keys alone; the list is made when it is asked for.
#pragma once

#include <algorithm>
#include <array>
#include <compare>
#include <cstdint>
#include <span>
#include <utility>
#include <vector>

#include "base/assert.hpp"
#include "base/event_table.hpp"
#include "physim/event.hpp"
#include "world/step_list.hpp"

namespace physim {

/// What decides the order of events, and where one stands.
struct EventKey {
  double time = 0;
  std::uint32_t slot = 0, order = 0, at = 0;
  std::uint32_t place = 0;  // of what is kept of it; decides nothing

  /// No time is none, and two are seldom equal.
  std::weak_ordering operator<=>(const EventKey& other) const {
    if (time != other.time) return time < other.time ? std::weak_ordering::less : std::weak_ordering::greater;
    if (slot != other.slot) return slot <=> other.slot;
    return order != other.order ? order <=> other.order : at <=> other.at;
  }
  bool operator==(const EventKey& other) const { return (*this <=> other) == 0; }
};

/// What an event says that says no more, beside place and velocity.
struct PlainEvent {
  EventKind kind = EventKind::spawned;
  Reason reason = Reason::none;
  ProjectileId id;
  std::uint32_t value = 0;
  double time = 0;  // [s]
};

/// Such an event in numbers of float32.
struct ToldInFloat {
  PlainEvent event;
  Vec3<float> x, v;  // [m], [m/s]
};

/// Lists that were given out and grew out of their memory, or are no more.
using GivenEvents = std::vector<std::vector<Event>>;

class EventList {
 public:
  static constexpr std::size_t kMost = std::size_t{1} << 31;  ///< events; places are counted in 32 bits

  EventList() = default;
  /// Copies have what was told, and have shown nothing yet.
  EventList(const EventList& other) : keys_(other.keys_), brief_(other.brief_), whole_(other.whole_) {}
  EventList& operator=(const EventList& other) {
    if (this == &other) return *this;
    keys_ = other.keys_, brief_ = other.brief_, whole_ = other.whole_;
    shown_.clear();
    return *this;
  }
  EventList(EventList&&) = default;
  EventList& operator=(EventList&&) = default;
  ~EventList() = default;

  [[nodiscard]] std::size_t size() const { return keys_.size(); }
  /// Room for so many more plain ones of numbers in float, and so many in double, which float32 may hold, too; may end
  /// for lack of memory.
  void reserve(std::size_t in_float, std::size_t in_double) {
    make_room(keys_, in_float + in_double);
    make_room(brief_, in_float + in_double);
    make_room(whole_, in_double);
  }
  void add(const Event& event) {
    make_room(keys_, 1), make_room(whole_, 1);
    // Told that there is room, compilers write the event in place. A copy, for which clang calls memcpy(), would read
    // in wide pieces what was just written in narrow ones, and wait until it is in the cache.
    if (whole_.size() == whole_.capacity()) __builtin_unreachable();
    whole_.push_back(event);
    add_key(event.kind, event.id.index, event.time, 2 * whole_.size() - 1);
  }
  /// A plain one, with a place [m] and a velocity [m/s] in float or double.
  template <class S>
  void add(const PlainEvent& e, const Vec3<S>& x, const Vec3<S>& v) {
    if (!fits_float32(x) || !fits_float32(v)) return add(whole_of(e, vec_cast<double>(x), vec_cast<double>(v)));
    make_room(keys_, 1), make_room(brief_, 1);
    const auto numbers = [](const Vec3<S>& of) {
      return std::array{static_cast<float>(of.x), static_cast<float>(of.y), static_cast<float>(of.z)};
    };
    if (brief_.size() == brief_.capacity()) __builtin_unreachable();  // it is written in place, as a whole one is
    brief_.push_back({e.id.generation, e.value, numbers(x), numbers(v), e.kind, e.reason});
    add_key(e.kind, e.id.index, e.time, 2 * brief_.size() - 2);
  }

  /// So many plain ones in numbers of float32, for which there is room: told(i) says which.
  template <class F>
  void add_each(std::size_t count, const F& told) {
    const std::size_t first = keys_.size(), first_brief = brief_.size();
    keys_.resize(first + count), brief_.resize(first_brief + count);
    EventKey* const keys = keys_.data() + first;
    Brief* const briefs = brief_.data() + first_brief;
    for (std::size_t i = 0; i < count; ++i) {
      const ToldInFloat t = told(i);
      const PlainEvent& e = t.event;
      keys[i] = {e.time, e.id.index, row_of(e.kind).order, static_cast<std::uint32_t>(first + i),
                 static_cast<std::uint32_t>(2 * (first_brief + i))};
      briefs[i] = {e.id.generation, e.value, {t.x.x, t.x.y, t.x.z}, {t.v.x, t.v.y, t.v.z}, e.kind, e.reason};
    }
  }

  /// By time, projectile and kind; what one tells at one time stays in the order in which it was told.
  void put_in_order(std::vector<EventKey>& spare, GivenEvents& given);
  /// All of them. What was given stays where it is until these and `given` are cleared.
  [[nodiscard]] std::span<const Event> all(GivenEvents& given) const;
  void clear() { keys_.clear(), brief_.clear(), whole_.clear(), shown_.clear(); }
  /// Others take its place: what it gave out stays.
  void leave(GivenEvents& given) const {
    if (!shown_.empty()) given.push_back(std::exchange(shown_, {}));
  }
  [[nodiscard]] std::size_t bytes() const;

 private:
  struct Brief {
    std::uint32_t generation, value;
    std::array<float, 3> position, velocity;
    EventKind kind;
    Reason reason;
  };

  template <class T>
  static void make_room(std::vector<T>& list, std::size_t more) {
    if (list.capacity() - list.size() < more)
      list.reserve(std::max({list.size() + more, 2 * list.capacity(), std::size_t{16}}));
  }
  template <class S>
  [[nodiscard]] static bool fits_float32(const Vec3<S>& v) {
    const auto fits = [](S x) { return sizeof(S) == sizeof(float) || static_cast<S>(static_cast<float>(x)) == x; };
    return fits(v.x) && fits(v.y) && fits(v.z);
  }
  [[nodiscard]] static Event whole_of(const PlainEvent& e, const Vec3d& position, const Vec3d& velocity);
  [[nodiscard]] Event event_of(const EventKey& key) const;
  void add_key(EventKind kind, std::uint32_t slot, double time, std::size_t place) {
    if (keys_.size() == keys_.capacity()) __builtin_unreachable();
    keys_.push_back(
        {time, slot, row_of(kind).order, static_cast<std::uint32_t>(keys_.size()), static_cast<std::uint32_t>(place)});
  }

  StepList<EventKey> keys_;
  StepList<Brief> brief_;          // at places 0, 2, 4 ...
  StepList<Event> whole_;          // at places 1, 3, 5 ...
  mutable StepList<Event> shown_;  // the first of them, as somebody reads them
};

}  // namespace physim
