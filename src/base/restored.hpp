// Restored: a variable that has another value for as long as a scope lasts.
#pragma once

#include <utility>

namespace physim {

template <class T>
class Restored {
 public:
  Restored(T& variable, T meanwhile) : variable_(variable), before_(std::exchange(variable, std::move(meanwhile))) {}
  Restored(const Restored&) = delete;
  Restored& operator=(const Restored&) = delete;
  ~Restored() { variable_ = std::move(before_); }

 private:
  T& variable_;
  T before_;
};

}  // namespace physim
