// What a scenario expects of its shots at times, as marks over the curves of a picture: rings where it was published,
// else crosses.
#pragma once

#include <array>
#include <span>
#include <string>

#include "report/flown.hpp"
#include "report/picture.hpp"
#include "report/trajectory.hpp"

namespace physim::report {

class PlotMarks {
 public:
  PlotMarks(std::span<const FlownShot> shots, std::span<const Expectation> expected);

  [[nodiscard]] bool has_rings() const { return has_rings_; }
  [[nodiscard]] bool has_crosses() const { return has_crosses_; }
  /// Returns the extent of the marks in a panel; columns count from 1, as in kSampleColumns.
  [[nodiscard]] Extent extent(int column) const {
    const auto c = static_cast<std::size_t>(column);
    return c < marks_.size() ? marks_[c].extent : Extent{};
  }
  /// The datablocks that plots() reads.
  [[nodiscard]] std::string blocks() const;
  /// Drawn over the curves of a panel; begins with a comma.
  [[nodiscard]] std::string plots(int column) const;

 private:
  struct Marks {
    std::string rings, crosses;  // rows of time and value
    Extent extent;
  };
  std::array<Marks, kSampleColumns.size() + 1> marks_;
  bool has_rings_ = false, has_crosses_ = false;
};

}  // namespace physim::report
