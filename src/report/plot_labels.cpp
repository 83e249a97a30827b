#include "report/plot_labels.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "base/assert.hpp"
#include "report/table.hpp"

namespace physim::report {
namespace {

constexpr double kCharacterWidth = 0.66, kLineHeight = 1.45;  // parts of the font size
constexpr double kBoldWidth = 1.13;                           // of a regular character
constexpr double kGap = 6;                                    // [px] between texts, so that two do not read as one
constexpr double kPointRadius = 7;                            // [px]
constexpr double kNear = 14;                                  // [px] from a point: no leader is needed
constexpr double kDistances[] = {10, 14, 28, 48, 74};

struct Candidate {
  PixelBox box;
  PixelPoint leader_end;
  double distance = 0;
  double dislike = 0;
};

bool overlap(const PixelBox& a, const PixelBox& b) {
  return a.left < b.right && b.left < a.right && a.bottom < b.top && b.bottom < a.top;
}

bool inside(const PixelBox& box, const PixelBox& area) {
  return box.left >= area.left && box.right <= area.right && box.bottom >= area.bottom && box.top <= area.top;
}

// Does a straight line pass through a box? Liang and Barsky's clipping.
bool crosses(const PixelPoint& a, const PixelPoint& b, const PixelBox& box) {
  double enter = 0, leave = 1;
  const auto clip = [&](double direction, double room) {
    if (direction == 0) return room >= 0;
    const double at = room / direction;
    if (direction < 0)
      enter = std::max(enter, at);
    else
      leave = std::min(leave, at);
    return enter <= leave;
  };
  const double dx = b.x - a.x, dy = b.y - a.y;
  return clip(-dx, a.x - box.left) && clip(dx, box.right - a.x) && clip(-dy, a.y - box.bottom) &&
         clip(dy, box.top - a.y);
}

// A box of this size beside a point: `side_x` and `side_y` are -1, 0 or 1.
Candidate candidate(const PixelPoint& at, double width, double height, int side_x, int side_y, double distance) {
  const double diagonal = side_x != 0 && side_y != 0 ? std::sqrt(0.5) : 1;
  const PixelPoint edge{at.x + side_x * distance * diagonal, at.y + side_y * distance * diagonal};
  const double left = edge.x - width * (1 - side_x) / 2, bottom = edge.y - height * (1 - side_y) / 2;
  return {{left, left + width, bottom, bottom + height}, edge, distance, 0};
}

std::vector<Candidate> candidates(const LabelRequest& request) {
  struct Side {
    int x, y;
    double dislike;
  };
  PHYSIM_ASSERT(request.font_size > 0);
  constexpr Side sides[] = {{1, 0, 0},  {1, 1, 1},  {1, -1, 1}, {0, 1, 2},
                            {0, -1, 2}, {-1, 0, 3}, {-1, 1, 3}, {-1, -1, 3}};
  const double width = static_cast<double>(display_width(request.text)) * request.font_size * kCharacterWidth *
                       (request.bold ? kBoldWidth : 1);
  const double height = request.font_size * kLineHeight;
  std::vector<Candidate> all;
  for (const double distance : kDistances)
    for (const Side& side : sides) {
      if (request.may_drop && distance > kNear) continue;
      all.push_back(candidate(request.at, width, height, side.x, side.y, distance));
      all.back().dislike = side.dislike + distance;
    }
  return all;
}

}  // namespace

std::vector<PlacedLabel> place_labels(const std::vector<LabelRequest>& requests, const std::vector<PixelPoint>& points,
                                      std::vector<PixelLine> lines, const PixelBox& area) {
  std::vector<PixelBox> taken, labels;
  PHYSIM_ASSERT(area.left < area.right);
  PHYSIM_ASSERT(area.bottom < area.top);
  for (const PixelPoint& p : points)
    taken.push_back({p.x - kPointRadius, p.x + kPointRadius, p.y - kPointRadius, p.y + kPointRadius});
  std::vector<PlacedLabel> placed;
  for (const LabelRequest& request : requests) {
    double best_dislike = std::numeric_limits<double>::infinity();
    Candidate best;
    for (const Candidate& each : candidates(request)) {
      if (!inside(each.box, area)) continue;
      if (std::ranges::any_of(taken, [&](const PixelBox& box) { return overlap(box, each.box); })) continue;
      const auto crossings =
          std::ranges::count_if(lines, [&](const auto& line) { return crosses(line.first, line.second, each.box); });
      if (request.may_drop && crossings > 0) continue;
      const bool needs_leader = each.distance > kNear;
      const auto leader_crosses = [&](const PixelBox& label) { return crosses(request.at, each.leader_end, label); };
      const auto covered = needs_leader ? std::ranges::count_if(labels, leader_crosses) : 0;
      const double dislike = each.dislike + 25 * static_cast<double>(crossings + covered);
      if (dislike < best_dislike) best_dislike = dislike, best = each;
    }
    PlacedLabel label;
    if (std::isfinite(best_dislike)) {
      const double middle = (best.box.bottom + best.box.top) / 2;
      label = {true, {best.box.left, middle}, best.distance > kNear, best.leader_end};
      taken.push_back({best.box.left - kGap, best.box.right + kGap, best.box.bottom, best.box.top});
      labels.push_back(best.box);
      PHYSIM_ASSERT(inside(best.box, area));
      if (label.has_leader) lines.emplace_back(request.at, best.leader_end);
    }
    placed.push_back(label);
  }
  PHYSIM_ASSERT(placed.size() == requests.size());
  return placed;
}

}  // namespace physim::report
