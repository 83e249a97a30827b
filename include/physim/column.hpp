// Columns in the caller's memory: values that lie side by side, or as members of structs of the caller's own.
#pragma once

#include <cstddef>
#include <ranges>
#include <span>
#include <type_traits>

namespace physim {

/// Where values are to be written, one after the other: a span, vector or array of them, or a member of each struct in
/// one, as vertices of a renderer are. It owns nothing: what is gone before the column is used, as a vector without a
/// name, is refused.
template <class T>
class Column {
  static_assert(!std::is_const_v<T>, "columns are written");
  template <class R>
  static constexpr bool kStays = std::is_lvalue_reference_v<R> || std::ranges::borrowed_range<R>;

 public:
  constexpr Column() = default;
  /// Values side by side.
  template <class R>
  requires(!std::is_same_v<std::remove_cvref_t<R>, Column> && kStays<R> &&
           std::is_constructible_v<std::span<T>, R&>) constexpr Column(R&& values) {
    const std::span<T> all(values);
    first_ = all.data();
    size_ = all.size();
  }
  /// A member of each struct: Column<Vec3d>{sprites, &Sprite::position}.
  template <class R, class S>
  requires(kStays<R>&& std::is_constructible_v<std::span<S>, R&>) constexpr Column(R&& structs, T S::*member) {
    const std::span<S> all(structs);
    if (!all.empty()) first_ = &(all.front().*member);
    size_ = all.size();
    stride_ = sizeof(S);
  }
  /// So many values, each so many bytes behind the one before: a multiple of alignof(T), and at least sizeof(T).
  constexpr Column(T* first, std::size_t size, std::size_t stride = sizeof(T))
      : first_(first), size_(size), stride_(stride) {}

  [[nodiscard]] constexpr bool empty() const { return size_ == 0; }
  [[nodiscard]] constexpr std::size_t size() const { return size_; }
  /// Bytes from one value to the next.
  [[nodiscard]] constexpr std::size_t stride() const { return stride_; }
  [[nodiscard]] T& operator[](std::size_t i) const {
    void* const first = first_;
    void* const at = static_cast<std::byte*>(first) + i * stride_;
    return *static_cast<T*>(at);
  }

 private:
  T* first_ = nullptr;
  std::size_t size_ = 0;
  std::size_t stride_ = sizeof(T);
};

}  // namespace physim
