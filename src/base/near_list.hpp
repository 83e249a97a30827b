// Lists with their first items in the structure that has the list: short ones allocate no memory.
#pragma once

#include <cstddef>
#include <memory>
#include <type_traits>
#include <utility>
#include <vector>

#include "base/assert.hpp"

namespace physim {

/// Room for some items. It stays where it is, for lists point to it.
template <class T, std::size_t kItems>
class NearRoom {
 public:
  static_assert(std::is_trivially_copyable_v<T> && std::is_trivially_destructible_v<T>);

  NearRoom() {}  // NOLINT: its memory is not set to zero
  NearRoom(const NearRoom&) = delete;
  NearRoom& operator=(const NearRoom&) = delete;
  ~NearRoom() = default;

  /// Its memory; null where it is lent already, or smaller.
  T* lend(std::size_t items) {
    if (is_lent_ || items > kItems) return nullptr;
    is_lent_ = true;
    return items_;
  }
  /// Whether it was this memory, which is free again.
  bool take_back(const T* memory) {
    if (memory != items_) return false;
    PHYSIM_ASSERT(is_lent_);
    is_lent_ = false;
    return true;
  }

 private:
  union {
    T items_[kItems];
  };
  bool is_lent_ = false;
};

/// The allocator of a std::vector that begins in a room. resize() leaves new items uninitialised: the caller writes
/// them.
template <class T, std::size_t kItems>
class NearAllocator {
 public:
  using value_type = T;
  template <class Other>
  struct rebind {
    using other = NearAllocator<Other, kItems>;
  };

  explicit NearAllocator(NearRoom<T, kItems>& room) : room_(&room) {}

  T* allocate(std::size_t items) {
    if (T* const near = room_->lend(items)) return near;
    return std::allocator<T>().allocate(items);
  }
  void deallocate(T* memory, std::size_t items) {
    if (!room_->take_back(memory)) std::allocator<T>().deallocate(memory, items);
  }
  void construct(T*) {}
  template <class... From>
  void construct(T* at, From&&... from) {
    std::construct_at(at, std::forward<From>(from)...);
  }
  bool operator==(const NearAllocator&) const = default;

 private:
  NearRoom<T, kItems>* room_;
};

/// A list that begins in a room.
template <class T, std::size_t kItems>
using NearList = std::vector<T, NearAllocator<T, kItems>>;

}  // namespace physim
