// TaskRunner: the one interface through which a world uses threads, so that an engine can lend its own.
#pragma once

#include <cstddef>
#include <memory>

namespace physim {

/// Runs independent pieces of work. A world's results do not depend on how.
class TaskRunner {
 public:
  virtual ~TaskRunner() = default;
  /// Calls task(context, i) for every i < count, in any order, on any threads, and returns when all are done.
  virtual void run(std::size_t count, void (*task)(void* context, std::size_t i), void* context) = 0;
  [[nodiscard]] virtual unsigned threads() const = 0;  ///< that may work at the same time
};

/// Threads of one pool at most.
inline constexpr unsigned kMostThreads = 1024;

/// A pool of threads that sleep until there is work; `threads` counts the caller's, 0: all that the machine has. It has
/// fewer where more than kMostThreads are asked for, or the system gives no more: threads() tells.
[[nodiscard]] std::unique_ptr<TaskRunner> make_thread_pool(unsigned threads = 0);

}  // namespace physim
