#include "simclient/core/hiding.hpp"

#include <algorithm>
#include <cmath>

namespace physim::client {

HidingMap::HidingMap(const Camera& camera, double cell)
    : camera_(camera),
      cell_(cell),
      columns_(static_cast<int>(std::ceil(camera.width() / cell))),
      rows_(static_cast<int>(std::ceil(camera.height() / cell))),
      nearness_(static_cast<std::size_t>(columns_) * static_cast<std::size_t>(rows_)) {}

/// Sensors are seen through, so they hide nothing; nor does what reaches behind the eye.
void HidingMap::add(const Scenery& scenery) {
  const Projector view = camera_.projector();
  for (std::size_t i = 0; i + 2 < scenery.solid; i += 3) {
    Corner corners[3];
    bool is_seen = true;
    for (std::size_t k = 0; k < 3; ++k) {
      const float(&p)[3] = scenery.vertices[i + k].at;
      const Vec3d at = scenery.origin + Vec3d{p[0], p[1], p[2]};
      const auto pixel = view.project(at);
      is_seen = is_seen && pixel;
      if (pixel) corners[k] = {pixel->x / cell_, pixel->y / cell_, 1 / view.depth(at)};
    }
    if (is_seen) add(corners[0], corners[1], corners[2]);
  }
}

void HidingMap::add(const Corner& a, const Corner& b, const Corner& c) {
  const double area = (b.x - a.x) * (c.y - a.y) - (c.x - a.x) * (b.y - a.y);
  if (area == 0) return;
  // Parts of b and c, and with them the nearness, change by as much from each cell to the next.
  const double b_by_x = (c.y - a.y) / area, b_by_y = (a.x - c.x) / area;
  const double c_by_x = (a.y - b.y) / area, c_by_y = (b.x - a.x) / area;
  const double by_x = b_by_x * (b.nearness - a.nearness) + c_by_x * (c.nearness - a.nearness);
  const double by_y = b_by_y * (b.nearness - a.nearness) + c_by_y * (c.nearness - a.nearness);
  const double slant = (std::abs(by_x) + std::abs(by_y)) / 2;
  const auto first = [](double x) { return std::max(std::ceil(x - 0.5), 0.0); };
  const auto last = [](double x, int count) { return std::min(std::floor(x - 0.5), count - 1.0); };
  for (double row = first(std::min({a.y, b.y, c.y})); row <= last(std::max({a.y, b.y, c.y}), rows_); ++row) {
    for (double k = first(std::min({a.x, b.x, c.x})); k <= last(std::max({a.x, b.x, c.x}), columns_); ++k) {
      const double x = k + 0.5 - a.x, y = row + 0.5 - a.y;
      const double of_b = b_by_x * x + b_by_y * y, of_c = c_by_x * x + c_by_y * y;
      if (of_b < 0 || of_c < 0 || of_b + of_c > 1) continue;
      double& here = nearness_[static_cast<std::size_t>(row * columns_ + k)];
      here = std::max(here, a.nearness + by_x * x + by_y * y - slant);
    }
  }
}

bool HidingMap::hides(const Pixel& at, double nearness) const {
  constexpr double kEqual = 1 - 1e-4;
  const double column = std::floor(at.x / cell_), row = std::floor(at.y / cell_);
  if (!(column >= 0 && row >= 0 && column < columns_ && row < rows_)) return false;
  return nearness < kEqual * nearness_[static_cast<std::size_t>(row * columns_ + column)];
}

}  // namespace physim::client
