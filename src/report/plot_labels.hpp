// Places the labels of a picture's points so that they cover neither each other nor the points.
#pragma once

#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace physim::report {

/// A place in pixels; y upwards.
struct PixelPoint {
  double x = 0, y = 0;
};

struct PixelBox {
  double left = 0, right = 0, bottom = 0, top = 0;
};

struct LabelRequest {
  std::string text;
  std::string_view colour;
  PixelPoint at;         // of the point that is labelled
  double font_size = 0;  // [pt], as drawn by gnuplot
  bool bold = false;
  bool may_drop = false;  // where there is no room
};

struct PlacedLabel {
  bool shown = false;
  PixelPoint at;            // left end of the text, middle of its height
  bool has_leader = false;  // the label is far enough off that a line should lead to its point
  PixelPoint leader_end;    // on the label's side
};

using PixelLine = std::pair<PixelPoint, PixelPoint>;

/// Labels that cover no point, no other label and better no line, in the order asked: earlier requests choose first.
[[nodiscard]] std::vector<PlacedLabel> place_labels(const std::vector<LabelRequest>& requests,
                                                    const std::vector<PixelPoint>& points, std::vector<PixelLine> lines,
                                                    const PixelBox& area);

}  // namespace physim::report
