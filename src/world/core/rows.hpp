// Rows: the projectiles of one cohort, a column for each of their numbers, so that packs load them side by side.
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <utility>
#include <vector>

#include "base/prefetch.hpp"
#include "model/body.hpp"
#include "model/rotor.hpp"
#include "world/core/clear_tube.hpp"

namespace physim {

/// Rows are stored in multiples of the widest pack, so that packs never read past a column's end.
inline constexpr std::size_t kRowsPerWord = 32;

/// Which columns the projectiles of a cohort have.
struct RowLayout {
  bool float32 = false;
  bool clocked = false;              // time since launch: closed forms, forces that end
  bool carried = false;              // the original loop's acceleration register
  bool launched = false;             // the place of launch
  bool turning = false;              // a Turn and RotorConstants
  bool meeting = false;              // what is clear of the things of the scene about it
  std::vector<std::uint8_t> fields;  // members of Body that the models read, as indices of its numbers
  std::vector<std::uint8_t> own;     // those of them that do not follow from the kind and the rung
  bool burning = false;              // a motor: which piece of its table a projectile is in is its own, too

  bool operator==(const RowLayout&) const = default;
  /// What its numbers are rounded by [-].
  [[nodiscard]] double epsilon() const {
    return float32 ? double{std::numeric_limits<float>::epsilon()} : std::numeric_limits<double>::epsilon();
  }
};

/// The columns of a cohort, each an array of float or double. Current and previous positions change places in every
/// step, which saves copying them.
template <class S>
struct RowColumns {
  S* position[3];
  S* previous[3];
  S* velocity[3];
  S* carried[3];
  S* launch[3];
  S* offset;                     // of the clock: time since launch = offset + (now - born) h
  S* born;                       // step at which the clock started
  S* clear;                      // distance it may fly; at or below 0: not looked at [m]
  S* tube[kNumbers<ClearTube>];  // in which nothing stands
  S* started[3];                 // velocity at the start of the step at hand, of rows that came near
  S* field[kNumbers<Body>];
  S* turn[kNumbers<Turn>];
  S* rotor[kNumbers<RotorConstants>];
};

/// What a row number is taken with before a column of Body's numbers is read: ~0, or 0 where all rows have the same
/// number. Such a column is read in its first rows only, which stay in the nearest cache.
using RowMasks = std::array<std::uint32_t, kNumbers<Body>>;

/// What rows are copied by; the columns point into it.
struct RowMemory {
  struct alignas(64) Line {
    std::byte bytes[64];
  };
  RowLayout layout_;
  unsigned numbers_ = 0;  // columns of numbers; one of slots follows
  std::vector<Line> lines_;
  std::size_t stride_ = 0;  // from column to column [bytes]
  std::uint32_t capacity_ = 0;
  std::uint32_t size_ = 0;
  bool swapped_ = false;
  RowMasks field_masks_{};
  bool notes_changes_ = false;
  std::vector<std::uint64_t> changed_;  // bit i of word w: row 64 w + i
};

class Rows : RowMemory {
 public:
  explicit Rows(RowLayout layout);
  Rows(const Rows& other);
  Rows& operator=(const Rows& other);
  Rows(Rows&&) noexcept = default;
  Rows& operator=(Rows&&) noexcept = default;
  ~Rows() = default;

  [[nodiscard]] const RowLayout& layout() const { return layout_; }
  [[nodiscard]] std::uint32_t size() const { return size_; }
  [[nodiscard]] std::size_t bytes() const {
    return lines_.size() * sizeof(Line) + changed_.capacity() * sizeof(std::uint64_t);
  }
  [[nodiscard]] std::size_t row_bytes() const { return numbers_ * number_size() + sizeof(std::uint32_t); }
  void reserve(std::size_t rows);
  /// One more row, to be filled in: all of its columns.
  std::uint32_t push(std::uint32_t slot) {
    if (size_ == capacity_) grow();
    PHYSIM_ASSERT(size_ < capacity_);
    column_of<std::uint32_t>(numbers_)[size_] = slot;
    note_change(size_);
#if PHYSIM_ASSERTS
    mark_unset(size_);
#endif
    return size_++;
  }
  /// Takes a row out; the last one takes its place. Returns the slot of the row that moved, or of none: 0.
  std::uint32_t swap_remove(std::uint32_t row);
  /// Copies a row of equal layout here, as a new last row.
  std::uint32_t push_copy(const Rows& from, std::uint32_t row);
  /// Makes a row what it was in a copy that these rows were.
  void put_back(std::uint32_t row, const Rows& copy);
  void clear() { size_ = 0; }

  // ------------------------------------------------------------------------------------------- changes of hands
  /// From now on notes rows with another projectile than before, or with one that has lost its emitter.
  void begin_changes() {
    notes_changes_ = true;
    changed_.clear();
  }
  void note_change(std::uint32_t row) {
    if (!notes_changes_) return;
    if (changed_.size() <= row / 64) changed_.resize(row / 64 + 1);
    changed_[row / 64] |= std::uint64_t{1} << row % 64;
  }
  /// Calls f with each of them once, in order.
  template <class F>
  void take_changes(const F& f) {
    PHYSIM_ASSERT(notes_changes_);
    for (std::uint32_t word = 0; word < changed_.size(); ++word) {
      for (std::uint64_t left = std::exchange(changed_[word], 0); left != 0; left &= left - 1) {
        const std::uint32_t row = 64 * word + static_cast<std::uint32_t>(__builtin_ctzll(left));
        if (row < size_) f(row);
      }
    }
  }

  /// Whether every number of a row was filled in since it was pushed; always true in builds without asserts.
  [[nodiscard]] bool is_filled(std::uint32_t row) const;
  /// The row's numbers will be used soon.
  void prefetch(std::uint32_t row) const {
    const std::byte* number = column(0) + row * number_size();
    for (unsigned k = numbers_; k > 0; --k, number += stride_) prefetch_at(number);
    prefetch_at(&slots()[row]);
  }

  [[nodiscard]] std::uint32_t slot(std::uint32_t row) const {
    PHYSIM_ASSERT(row < size_);
    return slots()[row];
  }
  [[nodiscard]] const std::uint32_t* slots() const { return column_of<std::uint32_t>(numbers_); }
  template <class S>
  [[nodiscard]] const RowColumns<S>& columns() const {
    PHYSIM_ASSERT((sizeof(S) == sizeof(float)) == layout_.float32);
    if constexpr (sizeof(S) == 4) return float_;
    if constexpr (sizeof(S) == 8) return double_;
  }
  /// After a step: what was written as the next position is the current one.
  void swap_positions();

  /// Calls f with the columns, of float or of double.
  template <class F>
  decltype(auto) visit(F&& f) const {
    return layout_.float32 ? f(float_) : f(double_);
  }
  /// What was written as the next position of one row is its current one.
  void swap_positions(std::uint32_t row) const {
    PHYSIM_ASSERT(row < size_);
    visit([row](const auto& c) {
      for (int axis = 0; axis < 3; ++axis) std::swap(c.position[axis][row], c.previous[axis][row]);
    });
  }
  [[nodiscard]] Vec3d position(std::uint32_t row) const {
    PHYSIM_ASSERT(row < size_);
    return visit([row](const auto& c) { return at(c.position, row); });
  }
  [[nodiscard]] Vec3d previous(std::uint32_t row) const {
    return visit([row](const auto& c) { return at(c.previous, row); });
  }
  [[nodiscard]] Vec3d velocity(std::uint32_t row) const {
    PHYSIM_ASSERT(row < size_);
    return visit([row](const auto& c) { return at(c.velocity, row); });
  }
  /// The numbers of a row that the models read.
  void read_fields(std::uint32_t row, Body<double>& body) const {
    PHYSIM_ASSERT(row < size_);
    visit([&](const auto& c) {
      double* number = numbers(body);
      for (const std::uint8_t field : layout_.fields) number[field] = static_cast<double>(c.field[field][row]);
    });
  }
  /// Fills in the numbers of a row that the models read.
  void write_fields(std::uint32_t row, const Body<double>& body);
  [[nodiscard]] const RowMasks& field_masks() const { return field_masks_; }
  /// Drops what is known of the clear space about a row.
  void forget_clear(std::uint32_t row) const {
    PHYSIM_ASSERT(row < size_);
    if (!layout_.meeting) return;
    visit([row](const auto& c) {
      c.clear[row] = 0;
      put(c.tube, row, ClearTube<double>{});
      put(c.started, row, {});
    });
  }
  /// The rotation of a row of a rung that turns.
  [[nodiscard]] Turn<double> turn(std::uint32_t row) const {
    PHYSIM_ASSERT(layout_.turning && row < size_);
    Turn<double> t;
    visit([&](const auto& c) { get(c.turn, row, t); });
    return t;
  }
  void put_turn(std::uint32_t row, const Turn<double>& t) const {
    PHYSIM_ASSERT(layout_.turning && row < size_);
    visit([&](const auto& c) { put(c.turn, row, t); });
  }
  /// Its rotor; of the launch nothing is kept.
  [[nodiscard]] Rotor<double> rotor(std::uint32_t row) const {
    PHYSIM_ASSERT(layout_.turning && row < size_);
    Rotor<double> r{};
    visit([&](const auto& c) { get<RotorConstants>(c.rotor, row, r); });
    return r;
  }
  void put_rotor(std::uint32_t row, const Rotor<double>& r) const {
    visit([&](const auto& c) { put<RotorConstants>(c.rotor, row, r); });
  }
  /// A structure of a row's numbers, from columns or into them.
  template <template <class> class Struct, class S, class To, std::size_t N>
  static void get(S* const (&columns)[N], std::uint32_t row, Struct<To>& into) {
    static_assert(N == kNumbers<Struct>);
    for (std::size_t i = 0; i < N; ++i) numbers(into)[i] = static_cast<To>(columns[i][row]);
  }
  template <template <class> class Struct, class S, class From, std::size_t N>
  static void put(S* const (&columns)[N], std::uint32_t row, const Struct<From>& from) {
    static_assert(N == kNumbers<Struct>);
    for (std::size_t i = 0; i < N; ++i) columns[i][row] = static_cast<S>(numbers(from)[i]);
  }
  template <class S>
  [[nodiscard]] static Vec3<S> numbers_at(S* const (&column)[3], std::uint32_t row) {
    return {column[0][row], column[1][row], column[2][row]};
  }
  template <class S>
  [[nodiscard]] static Vec3d at(S* const (&column)[3], std::uint32_t row) {
    return vec_cast<double>(numbers_at(column, row));
  }
  template <class S>
  static void put(S* const (&column)[3], std::uint32_t row, const Vec3d& v) {
    column[0][row] = rounded<S>(v.x), column[1][row] = rounded<S>(v.y), column[2][row] = rounded<S>(v.z);
  }
  /// A number in a row's precision; the largest there is where it is larger, as places of before may be.
  template <class S>
  [[nodiscard]] static S rounded(double x) {
    constexpr double kMost = std::numeric_limits<S>::max();
    return static_cast<S>(std::min(std::max(x, -kMost), kMost));
  }

 private:
  [[nodiscard]] std::byte* column(unsigned k) const {
    PHYSIM_ASSERT(k <= numbers_ && !lines_.empty());
    return const_cast<std::byte*>(lines_.data()->bytes) + k * stride_;
  }
  template <class T>
  [[nodiscard]] T* column_of(unsigned k) const {
    return static_cast<T*>(static_cast<void*>(column(k)));
  }
  [[nodiscard]] std::size_t number_size() const { return layout_.float32 ? sizeof(float) : sizeof(double); }
  void grow();
  /// So that builds with asserts find unwritten numbers.
  void mark_unset(std::uint32_t row);
  /// Copies the numbers of a row over those of another one.
  template <class S>
  void copy_numbers(std::uint32_t from, std::uint32_t to);
  /// Looks which numbers of a row just filled in differ from those of the others.
  void compare_fields(std::uint32_t row);
  template <class S>
  void find_columns(RowColumns<S>& c) const;
  void find_columns();

  RowColumns<float> float_{};  // one of them is in use
  RowColumns<double> double_{};
};

}  // namespace physim
