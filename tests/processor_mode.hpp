// Settings of the processor in which the library must not compute, and a check that it does not.
#pragma once

#include <gtest/gtest.h>

#include <cfenv>
#include <cstdint>
#include <cstring>
#include <functional>
#include <string>
#include <string_view>
#include <vector>

#if defined(__SSE2__)
#include <xmmintrin.h>
#endif

#include "physim/physim.hpp"

namespace physim::test {

/// A setting that a caller's thread may have.
enum class CallersMode { upward, downward, flush, traps };
inline constexpr CallersMode kCallersModes[] = {CallersMode::upward, CallersMode::downward, CallersMode::flush,
                                                CallersMode::traps};

/// Puts the thread into a mode, and back.
class InMode {
 public:
  explicit InMode(CallersMode mode) {
    std::fegetenv(&before_);
#if defined(__SSE2__)
    switch (mode) {
      case CallersMode::upward: _mm_setcsr(0x1f80 | 0x4000); break;
      case CallersMode::downward: _mm_setcsr(0x1f80 | 0x2000); break;
      case CallersMode::flush: _mm_setcsr(0x1f80 | 0x8040); break;   // flush to zero, denormals are zero
      case CallersMode::traps: _mm_setcsr(0x1f80 & ~0x0e80); break;  // invalid, division by zero, overflow, underflow
    }
#else
    std::fesetround(mode == CallersMode::upward     ? FE_UPWARD
                    : mode == CallersMode::downward ? FE_DOWNWARD
                                                    : FE_TONEAREST);
#endif
    set_ = setting();
  }
  ~InMode() { std::fesetenv(&before_); }
  InMode(const InMode&) = delete;
  InMode& operator=(const InMode&) = delete;

  /// The thread is still in it.
  [[nodiscard]] bool holds() const { return setting() == set_; }

 private:
  static unsigned setting() {
#if defined(__SSE2__)
    return _mm_getcsr() & ~0x3fu;
#else
    return static_cast<unsigned>(std::fegetround());
#endif
  }
  std::fenv_t before_{};
  unsigned set_ = 0;
};

/// Collects bits without any arithmetic of floating-point numbers.
class Bits {
 public:
  Bits& operator<<(std::uint64_t bits) {
    value_ = (value_ ^ bits) * 0x9e3779b97f4a7c15u;
    value_ ^= value_ >> 29;
    return *this;
  }
  Bits& operator<<(const double& x) {
    std::uint64_t bits = 0;
    std::memcpy(&bits, &x, sizeof bits);
    return *this << bits;
  }
  Bits& operator<<(const Vec3d& v) { return *this << v.x << v.y << v.z; }
  Bits& operator<<(const Quatd& q) { return *this << q.w << q.x << q.y << q.z; }
  Bits& operator<<(std::string_view text) {
    for (const char c : text) *this << std::uint64_t{static_cast<unsigned char>(c)};
    return *this;
  }
  Bits& operator<<(const Sample& s) {
    for (const Vec3d& v : {s.position, s.velocity, s.acceleration, s.angular_velocity}) *this << v;
    for (const double* x :
         {&s.time, &s.speed, &s.mach, &s.energy, &s.mass, &s.thrust, &s.range, &s.drop, &s.windage, &s.angle_of_attack})
      *this << *x;
    return *this << s.orientation;
  }
  Bits& operator<<(const Flight& flight) {
    for (const Event& e : flight.events()) *this << e.time << e.position << e.velocity;
    return *this << static_cast<std::uint64_t>(flight.outcome()) << flight.duration() << flight.elevation()
                 << flight.step() << flight.at(0.1) << flight.end();
  }
  [[nodiscard]] std::uint64_t value() const { return value_; }

 private:
  std::uint64_t value_ = 1;
};

/// A call, and the bits of what it answers.
struct Door {
  std::string name;
  std::function<void(Bits&)> call;
};

/// Wants the bits of each call to be the same in every mode, and the mode to be as it was behind it.
inline void expect_own_mode(const std::vector<Door>& doors) {
  for (const Door& door : doors) {
    Bits expected;
    door.call(expected);
    for (const CallersMode mode : kCallersModes) {
      Bits bits;
      bool holds = false;
      {
        const InMode in_mode(mode);
        door.call(bits);
        holds = in_mode.holds();
      }
      EXPECT_EQ(bits.value(), expected.value()) << door.name << " in mode " << static_cast<int>(mode);
      EXPECT_TRUE(holds) << door.name << " changes mode " << static_cast<int>(mode);
    }
  }
}

}  // namespace physim::test
