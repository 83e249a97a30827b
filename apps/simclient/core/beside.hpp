// Beside: work on a thread of its own while frames are drawn. Of all that is asked the newest is done; what waited
// before it is not.
#pragma once

#include <condition_variable>
#include <functional>
#include <mutex>
#include <optional>
#include <thread>
#include <utility>

namespace physim::client {

template <class Answer>
class Beside {
 public:
  Beside() = default;
  Beside(const Beside&) = delete;
  Beside& operator=(const Beside&) = delete;
  /// Waits for the work at hand.
  ~Beside() {
    if (!thread_.joinable()) return;
    {
      const std::scoped_lock lock(mutex_);
      leaves_ = true;
    }
    changed_.notify_all();
    thread_.join();
  }

  void ask(std::function<Answer()> work) {
    {
      const std::scoped_lock lock(mutex_);
      asked_ = std::move(work);
    }
    if (!thread_.joinable()) thread_ = std::thread([this] { work_on(); });
    changed_.notify_all();
  }
  /// The last answer that was not taken yet.
  [[nodiscard]] std::optional<Answer> take() {
    const std::scoped_lock lock(mutex_);
    return std::exchange(answer_, std::nullopt);
  }
  /// Forgets what was asked and answered.
  void forget() {
    const std::scoped_lock lock(mutex_);
    asked_ = nullptr;
    answer_.reset();
    ++forgotten_;
  }

 private:
  void work_on() {
    std::unique_lock lock(mutex_);
    while (true) {
      changed_.wait(lock, [this] { return leaves_ || asked_; });
      if (leaves_) return;
      const std::function<Answer()> work = std::exchange(asked_, nullptr);
      const int forgotten = forgotten_;
      lock.unlock();
      Answer answer = work();
      lock.lock();
      if (forgotten == forgotten_) answer_ = std::move(answer);
    }
  }

  std::mutex mutex_;
  std::condition_variable changed_;
  std::function<Answer()> asked_;
  std::optional<Answer> answer_;
  int forgotten_ = 0;
  bool leaves_ = false;
  std::thread thread_;
};

}  // namespace physim::client
