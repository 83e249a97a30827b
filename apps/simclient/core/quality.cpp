#include "simclient/core/quality.hpp"

#include <algorithm>

#include "base/assert.hpp"

namespace physim::client {

std::string_view name(Quality quality) {
  switch (quality) {
    case Quality::low: return "low";
    case Quality::medium: return "medium";
    case Quality::high: return "high";
  }
  return "";
}

std::string QualityChoice::text() const { return std::string(name(now)) + (by_hand ? "" : " (picked)"); }

void QualityPicker::change(int by) {
  const int next = static_cast<int>(now_) + by;
  PHYSIM_ASSERT(next >= static_cast<int>(Quality::low) && next <= static_cast<int>(Quality::high));
  if (by < 0) {
    const bool has_held = since_ >= kProof;
    if (has_risen_ || has_held) wait_ = has_held ? kFirstWait : std::min(2 * wait_, kLongestWait);
    after_lowering_.reset();
  }
  now_ = static_cast<Quality>(next);
  has_risen_ = by > 0;
  since_ = sum_ = 0;
  frames_ = 0;
}

/// It is raised when it has waited, or at once when frames take half of what they took after it was lowered: there is
/// less to draw then.
void QualityPicker::add(double seconds) {
  PHYSIM_ASSERT(seconds >= 0);
  sum_ += seconds;
  since_ += seconds;
  if (++frames_ < kFrames) return;
  const double mean = sum_ / frames_;
  sum_ = 0;
  frames_ = 0;
  if (mean > kTooLong) {
    if (now_ != Quality::low) change(-1);
    return;
  }
  if (!has_risen_ && !after_lowering_) after_lowering_ = mean;
  const bool has_less = after_lowering_ && mean < 0.5 * *after_lowering_;
  if (now_ != Quality::high && mean < kRoom && (since_ >= wait_ || has_less)) change(+1);
}

}  // namespace physim::client
