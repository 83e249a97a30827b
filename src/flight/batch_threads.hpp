// Flies the parts of a batch on the threads that are lent. Which thread flies which changes nothing.
#pragma once

#include <algorithm>
#include <atomic>

#include "base/ieee_mode.hpp"
#include "flight/batch_part.hpp"
#include "physim/result.hpp"

namespace physim {

/// Calls fly(BatchPart&, i) once for each i < parts, with a BatchPart of each thread; the caller's alone where no
/// runner is lent.
template <class Fly>
class BatchThreads {
 public:
  BatchThreads(const BatchTask& task, BatchSteps& steps, std::size_t parts, const Fly& fly)
      : task_(task), steps_(steps), parts_(parts), fly_(fly) {}

  void run(TaskRunner* runner) {
    const std::size_t threads = runner ? std::min<std::size_t>(runner->threads(), parts_) : 1;
    if (threads <= 1) return work();
    runner->run(
        threads, [](void* self, std::size_t) { static_cast<BatchThreads*>(self)->work(); }, this);
  }

 private:
  /// Work of one thread: any parts that no thread has begun.
  void work() {
    const IeeeMode mode;
    BatchPart part(task_, steps_);
    for (std::size_t i = next_++; i < parts_; i = next_++) fly_(part, i);
  }

  const BatchTask& task_;
  BatchSteps& steps_;
  const std::size_t parts_;
  const Fly& fly_;
  std::atomic<std::size_t> next_{0};
};

/// Bad input that all shots of a batch have in common.
[[nodiscard]] Status check_common(const BatchTask& task);

}  // namespace physim
