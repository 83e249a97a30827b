// Lists that are filled and emptied step after step: they keep their memory, but for what one step alone needed.
#pragma once

#include <algorithm>
#include <cstddef>
#include <vector>

namespace physim {

/// How much of a list is in use, step after step.
class ListUse {
 public:
  static constexpr int kSteps = 256;         ///< that a list is watched for
  static constexpr std::size_t kFew = 1024;  ///< bytes that are not worth giving back

  /// Empties it. Memory of which no step of late needed a quarter is given back.
  template <class T>
  void empty(std::vector<T>& list) {
    most_ = std::max(most_, list.size());
    list.clear();
    if (++steps_ < kSteps) return;
    if (list.capacity() > 4 * most_ && list.capacity() * sizeof(T) > kFew) {
      std::vector<T> smaller;
      smaller.reserve(most_);
      list.swap(smaller);
    }
    most_ = 0;
    steps_ = 0;
  }

 private:
  std::size_t most_ = 0;
  int steps_ = 0;
};

/// A list that knows its use.
template <class T>
class StepList : public std::vector<T> {
 public:
  void clear() { use_.empty<T>(*this); }

 private:
  ListUse use_;
};

}  // namespace physim
