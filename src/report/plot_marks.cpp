#include "report/plot_marks.hpp"

#include <algorithm>

#include "base/assert.hpp"
#include "report/number.hpp"

namespace physim::report {
namespace {

/// The column of a quantity, from 1; 0: none.
std::size_t column_of(const std::string& quantity) {
  for (std::size_t c = 0; c < kSampleColumns.size(); ++c)
    if (kSampleColumns[c].starts_with(quantity + " [")) return c + 1;
  return 0;
}

std::string block(const char* kind, std::size_t column) { return "$" + (kind + std::to_string(column)); }

std::string plot(const std::string& block, std::string_view mark) {
  return ", " + block + " using 1:2 with points " + std::string(mark) + " notitle";
}

}  // namespace

PlotMarks::PlotMarks(std::span<const FlownShot> shots, std::span<const Expectation> expected) {
  for (const Expectation& e : expected) {
    const bool is_drawn = e.shot.empty() || std::ranges::count(shots, e.shot, &FlownShot::name) > 0;
    const std::size_t column = column_of(e.quantity);
    if (e.at != ExpectAt::time || !is_drawn || column == 0) continue;
    PHYSIM_ASSERT(column < marks_.size());
    Marks& marks = marks_[column];
    (e.published ? marks.rings : marks.crosses) += significant(e.at_value, 9) + " " + significant(e.equals, 9) + "\n";
    (e.published ? has_rings_ : has_crosses_) = true;
    marks.extent.add(e.equals);
  }
}

std::string PlotMarks::blocks() const {
  std::string out;
  for (std::size_t c = 0; c < marks_.size(); ++c) {
    if (!marks_[c].rings.empty()) out += datablock(block("rings", c), marks_[c].rings);
    if (!marks_[c].crosses.empty()) out += datablock(block("crosses", c), marks_[c].crosses);
  }
  return out;
}

std::string PlotMarks::plots(int column) const {
  PHYSIM_ASSERT(column >= 1);
  const auto c = static_cast<std::size_t>(column);
  if (c >= marks_.size()) return "";
  std::string out;
  if (!marks_[c].crosses.empty()) out += plot(block("crosses", c), kExpectedMark);
  if (!marks_[c].rings.empty()) out += plot(block("rings", c), kPublishedMark);
  return out;
}

}  // namespace physim::report
