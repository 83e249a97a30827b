// Events of a world: those since the step before, their order, and the list of them for a reader.
//
// A step with many births and deaths has an event of each, and mostly no caller reads it. So an event that holds only
// id, time, place and velocity is kept in few bytes, in fewer if float32 holds its numbers, all others whole. What is
// put in order are keys alone; the list is made when it is read.
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
  std::uint32_t slot = 0, order = 0, at = 0;
  std::uint32_t place = 0;  // of what is kept of it; decides nothing

  /// No time is NaN, and two are seldom equal.
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

/// Such an event with its numbers, in float or double.
template <class S>
struct Told {
  PlainEvent event;
  Vec3<S> x, v;  // [m], [m/s]
};

/// Puts what it says into a blank event.
template <class S>
void put_told(const Told<S>& told, Event& event) {
  event.kind = told.event.kind, event.reason = told.event.reason, event.id = told.event.id;
  event.value = told.event.value, event.time = told.event.time;
  event.position = vec_cast<double>(told.x), event.velocity = vec_cast<double>(told.v);
}

/// Lists that were given out and grew out of their memory, or are no more.
using GivenEvents = std::vector<std::vector<Event>>;

class EventList {
 public:
  static constexpr std::size_t kMost = std::size_t{1} << 30;  ///< events; places are counted in 30 bits

  EventList() = default;
  /// Copies have all events, and have shown nothing yet.
  EventList(const EventList& other)
      : keys_(other.keys_), in_float_(other.in_float_), in_double_(other.in_double_), whole_(other.whole_) {}
  EventList& operator=(const EventList& other) {
    if (this == &other) return *this;
    keys_ = other.keys_, in_float_ = other.in_float_, in_double_ = other.in_double_, whole_ = other.whole_;
    shown_.clear();
    return *this;
  }
  EventList(EventList&&) = default;
  EventList& operator=(EventList&&) = default;
  ~EventList() = default;

  [[nodiscard]] std::size_t size() const { return keys_.size(); }
  /// Room for more plain ones: `in_float` of float, `in_double` of double, which float32 may hold, too; may end
  /// for lack of memory.
  void reserve(std::size_t in_float, std::size_t in_double) {
    make_room(keys_, in_float + in_double);
    make_room(in_float_, in_float + in_double);
    make_room(in_double_, in_double);
  }
  void add(const Event& event) {
    append(whole_, event);
    add_key(event.kind, event.id.index, event.time, place_of(whole_.size() - 1, Form::whole));
  }
  /// A plain one, with a place [m] and a velocity [m/s] in float or double.
  template <class S>
  PHYSIM_INLINE void add(const PlainEvent& e, const Vec3<S>& x, const Vec3<S>& v) {
    add_numbers(e, x.x, x.y, x.z, v.x, v.y, v.z);
  }

  /// Adds `count` plain ones: told(i) gives each, as a Told<S>. They are kept in numbers of that type.
  template <class S, class F>
  void add_each(std::size_t count, const F& told) {
    make_room(keys_, count), make_room(plain<S>(), count);
    const std::size_t first = keys_.size(), first_plain = plain<S>().size();
    keys_.resize(first + count), plain<S>().resize(first_plain + count);
    EventKey* const keys = keys_.data() + first;
    Plain<S>* const plains = plain<S>().data() + first_plain;
    for (std::size_t i = 0; i < count; ++i) {
      const Told<S>& t = told(i);
      const PlainEvent& e = t.event;
      keys[i] = {e.time, e.id.index, row_of(e.kind).order, static_cast<std::uint32_t>(first + i),
                 place_of(first_plain + i, kForm<S>)};
      plains[i] = plain_of(e, t.x, t.v);
    }
  }

  /// By time, projectile and kind; events of one projectile at one time stay in the order in which they were added.
  void put_in_order(std::vector<EventKey>& spare, GivenEvents& given);
  /// All of them. What was given stays where it is until these and `given` are cleared.
  [[nodiscard]] std::span<const Event> all(GivenEvents& given) const;
  void clear() { keys_.clear(), in_float_.clear(), in_double_.clear(), whole_.clear(), shown_.clear(); }
  /// Others take its place: what it gave out stays.
  void leave(GivenEvents& given) const {
    if (!shown_.empty()) given.push_back(std::exchange(shown_, {}));
  }
  [[nodiscard]] std::size_t bytes() const;

 private:
  /// What is kept of a plain one beside its key.
  template <class S>
  struct Plain {
    std::uint32_t generation, value;
    std::array<S, 3> position, velocity;
    EventKind kind;
    Reason reason;
  };
  template <class S>
  [[nodiscard]] static Plain<S> plain_of(const PlainEvent& e, const Vec3<S>& x, const Vec3<S>& v) {
    return {e.id.generation, e.value, {x.x, x.y, x.z}, {v.x, v.y, v.z}, e.kind, e.reason};
  }
  template <class S>
  [[nodiscard]] StepList<Plain<S>>& plain() {
    if constexpr (sizeof(S) == sizeof(float))
      return in_float_;
    else
      return in_double_;
  }
  /// In which list an event is kept, and where.
  enum class Form : std::uint32_t { in_float, in_double, whole };
  template <class S>
  static constexpr Form kForm = sizeof(S) == sizeof(float) ? Form::in_float : Form::in_double;
  [[nodiscard]] static std::uint32_t place_of(std::size_t at, Form form) {
    return static_cast<std::uint32_t>(4 * at) | static_cast<std::uint32_t>(form);
  }

  /// Six numbers come in registers. Of vectors, which come in memory, compilers read in pairs what was just written one
  /// by one.
  template <class S>
  [[gnu::noinline, gnu::flatten]] void add_numbers(const PlainEvent& e, S x, S y, S z, S vx, S vy, S vz) {
    const Vec3<S> at{x, y, z}, v{vx, vy, vz};
    if (sizeof(S) > sizeof(float) && fits_float32(at) && fits_float32(v))
      add_plain(e, vec_cast<float>(at), vec_cast<float>(v));
    else
      add_plain(e, at, v);
  }
  template <class S>
  void add_plain(const PlainEvent& e, const Vec3<S>& x, const Vec3<S>& v) {
    append(plain<S>(), plain_of(e, x, v));
    add_key(e.kind, e.id.index, e.time, place_of(plain<S>().size() - 1, kForm<S>));
  }
  void add_key(EventKind kind, std::uint32_t slot, double time, std::uint32_t place) {
    append(keys_, {time, slot, row_of(kind).order, static_cast<std::uint32_t>(keys_.size()), place});
  }
  template <class S>
  [[nodiscard]] static bool fits_float32(const Vec3<S>& v) {
    const auto fits = [](S x) { return static_cast<S>(static_cast<float>(x)) == x; };
    return fits(v.x) && fits(v.y) && fits(v.z);
  }
  template <class S>
  [[nodiscard]] static Told<S> told_of(const EventKey& key, const Plain<S>& p) {
    const auto vector = [](const std::array<S, 3>& of) { return Vec3<S>{of[0], of[1], of[2]}; };
    return {{p.kind, p.reason, {key.slot, p.generation}, p.value, key.time}, vector(p.position), vector(p.velocity)};
  }
  void add_shown(const EventKey& key) const;

  StepList<EventKey> keys_;
  StepList<Plain<float>> in_float_;
  StepList<Plain<double>> in_double_;
  StepList<Event> whole_;
  mutable StepList<Event> shown_;  // the first of them, as a caller reads them
};

}  // namespace physim
