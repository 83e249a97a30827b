// Living: which snapshots of a world still have an owner. What only a released snapshot could bring back
// need not be kept.
#pragma once

#include <cstdint>
#include <map>
#include <memory>

namespace physim {

class WorldState;

class Living {
 public:
  void add(std::uint64_t number, const std::shared_ptr<const WorldState>& snapshot) {
    if (moments_.size() >= look_at_) {
      std::erase_if(moments_, [](const auto& each) { return each.second.expired(); });
      look_at_ = 2 * moments_.size() + kFew;
    }
    moments_.emplace(number, snapshot);
  }
  /// Whether a snapshot lives with a number above `after` and not above `upto`.
  [[nodiscard]] bool has_one(std::uint64_t after, std::uint64_t upto) const {
    for (auto at = moments_.upper_bound(after); at != moments_.end() && at->first <= upto; ++at)
      if (!at->second.expired()) return true;
    return false;
  }

 private:
  static constexpr std::size_t kFew = 64;

  std::map<std::uint64_t, std::weak_ptr<const WorldState>> moments_;
  std::size_t look_at_ = kFew;  // expired ones, at this number of entries
};

}  // namespace physim
