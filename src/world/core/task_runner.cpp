// The world's own threads: a pool that sleeps between steps.
#include "physim/result.hpp"

#include <algorithm>
#include <atomic>
#include <condition_variable>
#include <exception>
#include <mutex>
#include <new>
#include <system_error>
#include <thread>
#include <utility>
#include <vector>

namespace physim {
namespace {

class ThreadPool final : public TaskRunner {
 public:
  explicit ThreadPool(unsigned threads) {
    helpers_.reserve(threads);
    try {
      for (unsigned i = 1; i < threads; ++i) helpers_.emplace_back([this] { help(); });
    } catch (const std::system_error&) {  // the system gives no more: those that there are do the work
    } catch (const std::bad_alloc&) {     // nor does memory last for more
    }
  }
  ThreadPool(const ThreadPool&) = delete;
  ThreadPool& operator=(const ThreadPool&) = delete;
  ~ThreadPool() override {
    {
      const std::lock_guard lock(mutex_);
      stopping_ = true;
    }
    work_.notify_all();
    for (std::thread& helper : helpers_) helper.join();
  }

  void run(std::size_t count, void (*task)(void*, std::size_t), void* context) override {
    if (helpers_.empty() || count <= 1) {
      for (std::size_t i = 0; i < count; ++i) task(context, i);
      return;
    }
    {
      const std::lock_guard lock(mutex_);
      task_ = task;
      context_ = context;
      count_ = count;
      next_.store(0, std::memory_order_relaxed);
      busy_ = helpers_.size();
      ++round_;
    }
    work_.notify_all();
    take_tasks();
    std::unique_lock lock(mutex_);
    done_.wait(lock, [this] { return busy_ == 0; });
    const std::exception_ptr thrown = std::exchange(thrown_, nullptr);
    lock.unlock();
    if (thrown) std::rethrow_exception(thrown);
  }
  [[nodiscard]] unsigned threads() const override { return static_cast<unsigned>(helpers_.size()) + 1; }

 private:
  /// A task may run out of memory: the first exception goes to the caller when all threads are done with the context.
  void take_tasks() {
    for (std::size_t i = next_.fetch_add(1); i < count_; i = next_.fetch_add(1)) try {
        task_(context_, i);
      } catch (...) {
        const std::lock_guard lock(mutex_);
        if (!thrown_) thrown_ = std::current_exception();
      }
  }
  void help() {
    std::unique_lock lock(mutex_);
    for (std::size_t seen = 0;;) {
      work_.wait(lock, [&] { return stopping_ || round_ != seen; });
      if (stopping_) return;
      seen = round_;
      lock.unlock();
      take_tasks();
      lock.lock();
      if (--busy_ == 0) done_.notify_one();
    }
  }

  std::vector<std::thread> helpers_;
  std::mutex mutex_;
  std::condition_variable work_;
  std::condition_variable done_;
  void (*task_)(void*, std::size_t) = nullptr;
  void* context_ = nullptr;
  std::size_t count_ = 0;
  std::atomic<std::size_t> next_{0};
  std::size_t busy_ = 0;
  std::exception_ptr thrown_;  // by a task of this round
  std::size_t round_ = 0;
  bool stopping_ = false;
};

}  // namespace

std::unique_ptr<TaskRunner> make_thread_pool(unsigned threads) {
  if (threads == 0) threads = std::thread::hardware_concurrency();
  return std::make_unique<ThreadPool>(std::clamp(threads, 1u, kMostThreads));
}

}  // namespace physim
