// Flies a part of a batch: a run of its shots, on one thread.
#pragma once

#include <optional>
#include <vector>

#include "flight/batch_steps.hpp"
#include "flight/plain_shots.hpp"
#include "flight/shot_groups.hpp"
#include "model/attitude.hpp"

namespace physim {

/// Orders events by shot; those of one shot already are in order of time. Counting places needs one pass, not a sort.
class ByShot {
 public:
  /// The numbers of the events, in order.
  template <class AnyEvent>
  const std::vector<std::uint32_t>& order(const std::vector<AnyEvent>& events, std::size_t shots) {
    place_.assign(shots + 1, 0);
    for (const AnyEvent& e : events) {
      PHYSIM_ASSERT(e.shot < shots);
      ++place_[e.shot + 1];
    }
    for (std::size_t i = 0; i < shots; ++i) place_[i + 1] += place_[i];
    order_.resize(events.size());
    for (std::uint32_t i = 0; i < events.size(); ++i) order_[place_[events[i].shot]++] = i;
    return order_;
  }

 private:
  std::vector<std::uint32_t> place_;  // memory for one order after another
  std::vector<std::uint32_t> order_;
};

/// What a part gives. Shots count from its first.
struct PartResult {
  std::span<ShotResult> shots{};        // how they ended
  std::span<ShotAttitude> attitudes{};  // of rungs that turn, else empty; some may stay as they were
  bool wants_events = true;
  std::vector<ShotEvent> events{};  // by shot, then by time
  std::size_t refused = 0;
  std::optional<Error> error{};           // the first of a shot refused
  std::optional<FidelityInUse> in_use{};  // of the first shot accepted
  bool turned = false;                    // some of its shots have attitudes
};

/// One thread's; parts that it flies one after another share what is known of projectiles.
class BatchPart {
 public:
  BatchPart(const BatchTask& task, BatchSteps& steps) : task_(task), steps_(steps), groups_(task) {}

  /// Memory for the ends of `count` shots, used again by the next part.
  [[nodiscard]] std::vector<ShotResult>& own_shots(std::size_t count) {
    own_shots_.resize(count);
    return own_shots_;
  }
  /// Shots from `first` on, as many as there is room for in into.shots.
  void fly(std::size_t first, PartResult& into);

 private:
  void fly_or_gather(std::uint32_t i);
  void refuse(std::size_t i, const Error& error);
  void order_events();
  void put_attitude(std::uint32_t i, const Attitude& attitude);
  void end_at_once(std::uint32_t i);
  void fly_alone(std::uint32_t i);
  [[nodiscard]] bool asks_for(EventKind kind) const;
  [[nodiscard]] Status put_step(ShotGroup& group);
  [[nodiscard]] bool fly_as_columns();
  void fly(ShotGroup& group);
  /// Flies a group's shots, or launches that lanes compute: all of the part.
  void run_kernel(ShotGroup& group, const LaunchSource* launches);
  /// Flies launches with the lowest layer of their air alone, where that may do; false: nothing is flown yet, as some
  /// need more.
  [[nodiscard]] bool run_kernel_in_low_air(ShotGroup& group, PlainShots& plain);
  template <class S>
  void run_kernel(ShotGroup& group, const LaunchSource* launches, void (*kernel)(const BatchJob<S>&));
  void keep(const ShotGroup& group, const RawEvent& e);
  void add_drift(const ShotGroup& group);
  void keep_attitudes(const ShotGroup& group);

  const BatchTask& task_;
  BatchSteps& steps_;
  ShotGroups groups_;
  WatchList watch_{};
  ByShot by_shot_;
  PartResult* part_ = nullptr;
  std::vector<ShotResult> own_shots_;
  std::size_t first_ = 0;         // shot of the part
  bool* left_low_air_ = nullptr;  // for the kernel
};

}  // namespace physim
