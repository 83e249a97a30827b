// How much memory a soak holds.
#pragma once

#include <unistd.h>
#if defined(__GLIBC__) && __GLIBC_PREREQ(2, 33)
#define PHYSIM_HAS_MALLINFO2 1
#include <malloc.h>
#endif
#if defined(__SANITIZE_ADDRESS__) || defined(__SANITIZE_THREAD__)
#define PHYSIM_SANITIZED 1
#elif defined(__has_feature)
#if __has_feature(address_sanitizer) || __has_feature(thread_sanitizer)
#define PHYSIM_SANITIZED 1
#endif
#endif

#include <cstddef>
#include <cstdio>

#ifdef PHYSIM_SANITIZED
extern "C" std::size_t __sanitizer_get_current_allocated_bytes();  // g++ has no header for it
#endif

namespace physim::soak {

/// Memory that the process takes from the system.
inline std::size_t resident_bytes() {
  std::FILE* statm = std::fopen("/proc/self/statm", "r");
  if (!statm) return 0;
  long size = 0;
  long resident = 0;
  const int read = std::fscanf(statm, "%ld %ld", &size, &resident);
  std::fclose(statm);
  return read == 2 ? static_cast<std::size_t>(resident) * static_cast<std::size_t>(sysconf(_SC_PAGESIZE)) : 0;
}

/// Memory that is held: what was allocated and not given back. A snapshot of a large world leaves holes when it goes,
/// which the allocator fills and makes as it likes; they are resident, and nobody's leak.
inline std::size_t held_bytes() {
#ifdef PHYSIM_SANITIZED
  return __sanitizer_get_current_allocated_bytes();
#elif defined(PHYSIM_HAS_MALLINFO2)
  const struct mallinfo2 heap = mallinfo2();
  return heap.uordblks + heap.hblkhd;
#else
  return resident_bytes();
#endif
}

/// Whether it stays as it is after a first third, in which kinds, rungs and cohorts meet for the first time.
class Memory {
 public:
  explicit Memory(double target) : target_(target) {}

  void look(double done) {
    now_ = held_bytes();
    if (done < target_ / 3) early_ = now_ > early_ ? now_ : early_;
    most_ = now_ > most_ ? now_ : most_;
  }
  [[nodiscard]] double held() const { return static_cast<double>(now_) / 1e6; }     ///< [MB]
  [[nodiscard]] double early() const { return static_cast<double>(early_) / 1e6; }  ///< most in the first third [MB]
  [[nodiscard]] double most() const { return static_cast<double>(most_) / 1e6; }    ///< [MB]
  [[nodiscard]] bool grows() const { return most() > 1.05 * early() + 1; }

 private:
  double target_;
  std::size_t early_ = 0, most_ = 0, now_ = 0;
};

}  // namespace physim::soak
