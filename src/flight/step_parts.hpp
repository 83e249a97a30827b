// A step that is flown in parts: it restarts at each contact, and takes short parts near what was touched.
#pragma once

#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>

#include "base/assert.hpp"
#include "collide/scene_contact.hpp"

namespace physim {

/// Where a flight is on its way through a step. All times are into the step [s].
class StepParts {
 public:
  /// `short_ones`: from the start, and not only once something was touched.
  StepParts(double length, bool short_ones) : length_(length), short_ones_(short_ones) { PHYSIM_ASSERT(length >= 0); }

  /// The length of the first part of such a step, if nothing is touched before.
  [[nodiscard]] static double first(double length, bool short_ones) {
    PHYSIM_ASSERT(length >= 0);
    return short_ones ? length / std::max(std::ceil(length / kLongestPart - 1e-9), 1.0) : length;
  }

  /// Where the part at hand ends; before the first one, where that begins.
  [[nodiscard]] double end() const { return end_; }
  [[nodiscard]] bool is_last() const { return end_ == length_; }
  /// Before the first part: it is not under way before that time.
  void start_at(double passed) {
    PHYSIM_ASSERT(end_ == 0 && passed >= 0 && passed <= length_);
    end_ = passed;
  }
  /// A part begins. Before the first contact most steps are one part.
  void begin(double from) {
    bounces_ = 0;
    end_ = length_;
    if (!is_near_ && !short_ones_) return;
    const double parts = std::ceil((length_ - from) / kLongestPart - 1e-9);  // equal ones
    if (parts > 1) end_ = from + (length_ - from) / parts;
    PHYSIM_ASSERT(end_ > from || from == length_);
  }
  /// Where the part at hand is over, another one begins.
  void come_to(double passed) {
    if (passed >= end_) begin(passed);
  }
  /// It touched something.
  void come_near(double passed) {
    if (!std::exchange(is_near_, true)) begin(passed);
  }
  /// The part at hand goes to the end of the step.
  void make_last() { end_ = length_; }

  /// It flies on from a contact, within the part at hand.
  void go_on(double from) {
    PHYSIM_ASSERT(from >= 0 && from <= length_);
    resume_ = from;
  }
  /// From where it flies on: from the last contact, or into the next part. None: the step is over.
  [[nodiscard]] std::optional<double> next() {
    if (resume_) return std::exchange(resume_, std::nullopt);
    if (!(end_ < length_)) return std::nullopt;
    const double from = end_;
    begin(from);
    return from;
  }

  /// Counts a contact with the ground; false where it is one too many, and it lies there.
  [[nodiscard]] bool may_bounce() {
    constexpr int kMostBounces = 16;  // in one part
    return bounces_++ < kMostBounces;
  }

 private:
  double length_;
  bool short_ones_;
  bool is_near_ = false;  // it touched something
  double end_ = 0;
  std::optional<double> resume_;
  int bounces_ = 0;
};

}  // namespace physim
