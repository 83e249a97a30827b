#include "world/core/rows.hpp"

#include <algorithm>
#include <cstring>
#include <utility>

#include "base/assert.hpp"

namespace physim {
namespace {

#if PHYSIM_ASSERTS
/// Bytes of an unwritten number: a NaN that no computation gives.
constexpr unsigned char kUnset = 0xff;
#endif

/// One float or double. (clang would emit a call for a copy of this size.)
void copy_number(std::byte* to, const std::byte* from, std::size_t bytes) {
  PHYSIM_ASSERT(bytes == sizeof(float) || bytes == sizeof(double));
  if (bytes == sizeof(float))
    std::memcpy(to, from, sizeof(float));
  else
    std::memcpy(to, from, sizeof(double));
}

unsigned count_columns(const RowLayout& l) {
  return 9 + (l.carried ? 3u : 0) + (l.launched ? 3u : 0) + (l.clocked ? 2u : 0) +
         (l.meeting ? 4u + kNumbers<ClearTube> : 0) + (l.turning ? kNumbers<Turn> + kNumbers<RotorConstants> : 0) +
         static_cast<unsigned>(l.fields.size());
}

}  // namespace

Rows::Rows(RowLayout layout) {
  layout_ = std::move(layout);
  numbers_ = count_columns(layout_);
}

Rows::Rows(const Rows& o) : RowMemory(o) { find_columns(); }

Rows& Rows::operator=(const Rows& o) {
  static_cast<RowMemory&>(*this) = o;
  find_columns();
  return *this;
}

void Rows::reserve(std::size_t rows) {
  if (rows <= capacity_) return;
  const std::size_t capacity = (rows + kRowsPerWord - 1) / kRowsPerWord * kRowsPerWord;
  // Columns that begin at equal places of a page would all fall into the same few sets of the cache.
  const std::size_t stride = (capacity * number_size() + 63) / 64 * 64 + 3 * 64;
  std::vector<Line> lines((stride * (numbers_ + 1)) / 64);
  std::byte* const to = lines.data()->bytes;
  for (unsigned k = 0; k <= numbers_ && size_ > 0; ++k)
    std::memcpy(to + k * stride, column(k), size_ * (k == numbers_ ? sizeof(std::uint32_t) : number_size()));
  lines_ = std::move(lines);
  stride_ = stride;
  capacity_ = static_cast<std::uint32_t>(capacity);
  find_columns();
}

void Rows::grow() { reserve(std::max<std::size_t>(64, std::size_t(capacity_) * 3 / 2)); }

#if PHYSIM_ASSERTS
void Rows::mark_unset(std::uint32_t row) {
  for (unsigned k = 0; k < numbers_; ++k) std::memset(column(k) + row * number_size(), kUnset, number_size());
}
#endif

bool Rows::is_filled(std::uint32_t row) const {
  PHYSIM_ASSERT(row < size_);
#if PHYSIM_ASSERTS
  for (unsigned k = 0; k < numbers_; ++k) {
    const std::byte* const number = column(k) + row * number_size();
    if (std::all_of(number, number + number_size(), [](std::byte b) { return b == std::byte{kUnset}; })) return false;
  }
#endif
  return true;
}

std::uint32_t Rows::push_copy(const Rows& from, std::uint32_t row) {
  PHYSIM_ASSERT(row < from.size_ && from.layout_ == layout_);
  const std::uint32_t at = push(from.slot(row));
  const std::size_t bytes = number_size();
  const bool turned = from.swapped_ != swapped_;  // positions and previous ones lie the other way round
  for (unsigned k = 0; k < numbers_; ++k) {
    const unsigned source = turned && k < 6 ? (k + 3) % 6 : k;
    copy_number(column(k) + at * bytes, from.column(source) + row * bytes, bytes);
  }
  compare_fields(at);
  return at;
}

void Rows::put_back(std::uint32_t row, const Rows& copy) {
  PHYSIM_ASSERT(row < copy.size_ && copy.size_ == size_ && copy.swapped_ == swapped_ && copy.slot(row) == slot(row));
  const std::size_t bytes = number_size();
  for (unsigned k = 0; k < numbers_; ++k) copy_number(column(k) + row * bytes, copy.column(k) + row * bytes, bytes);
}

void Rows::write_fields(std::uint32_t row, const Body<double>& body) {
  PHYSIM_ASSERT(row < size_);
  const double* number = numbers(body);
  visit([&]<class S>(const RowColumns<S>& c) {
    for (const std::uint8_t field : layout_.fields) c.field[field][row] = static_cast<S>(number[field]);
  });
  compare_fields(row);
}

void Rows::compare_fields(std::uint32_t row) {
  // Closed forms write a new launch into their rows while they step.
  if (layout_.clocked) return field_masks_.fill(~0u);
  if (size_ == 1) return field_masks_.fill(0);
  const std::uint32_t other = row == 0 ? 1 : 0;
  visit([&](const auto& c) {
    for (const std::uint8_t field : layout_.fields)
      if (std::memcmp(c.field[field] + row, c.field[field] + other, sizeof(*c.field[field])) != 0)
        field_masks_[field] = ~0u;
  });
}

template <class S>
void Rows::copy_numbers(std::uint32_t from, std::uint32_t to) {
  const std::size_t stride = stride_ / sizeof(S);
  S* number = column_of<S>(0);
  for (unsigned left = numbers_; left > 0; --left, number += stride) number[to] = number[from];
}

std::uint32_t Rows::swap_remove(std::uint32_t row) {
  PHYSIM_ASSERT(row < size_);
  const std::uint32_t last = size_ - 1;
  size_ = last;
  if (row == last) return 0;
  if (layout_.float32)
    copy_numbers<float>(last, row);
  else
    copy_numbers<double>(last, row);
  note_change(row);
  auto* all = column_of<std::uint32_t>(numbers_);
  return all[row] = all[last];
}

void Rows::swap_positions() {
  swapped_ = !swapped_;
  for (int axis = 0; axis < 3; ++axis) {
    std::swap(float_.position[axis], float_.previous[axis]);
    std::swap(double_.position[axis], double_.previous[axis]);
  }
}

template <class S>
void Rows::find_columns(RowColumns<S>& c) const {
  c = {};
  if (lines_.empty()) return;
  unsigned k = 0;
  const auto next = [&] { return column_of<S>(k++); };
  for (S*& p : swapped_ ? c.previous : c.position) p = next();
  for (S*& p : swapped_ ? c.position : c.previous) p = next();
  for (S*& p : c.velocity) p = next();
  if (layout_.carried)
    for (S*& p : c.carried) p = next();
  if (layout_.launched)
    for (S*& p : c.launch) p = next();
  if (layout_.clocked) c.offset = next(), c.born = next();
  if (layout_.meeting) {
    c.clear = next();
    for (S*& p : c.tube) p = next();
    for (S*& p : c.started) p = next();
  }
  for (const std::uint8_t field : layout_.fields) c.field[field] = next();
  if (layout_.turning) {
    for (S*& p : c.turn) p = next();
    for (S*& p : c.rotor) p = next();
  }
  PHYSIM_ASSERT(k == numbers_);
}

void Rows::find_columns() {
  if (layout_.float32)
    find_columns(float_);
  else
    find_columns(double_);
}

}  // namespace physim
