#include "study/targets.hpp"

#include "base/checker.hpp"

namespace physim {
namespace {

bool covers(const CircleTarget& c, double right, double up) {
  const double x = right - c.centre.right, y = up - c.centre.up;
  return x * x + y * y <= c.radius * c.radius;
}

bool covers(const RectangleTarget& r, double right, double up) {
  const double x = right - r.centre.right, y = up - r.centre.up;
  return x >= -0.5 * r.width && x < 0.5 * r.width && y >= -0.5 * r.height && y < 0.5 * r.height;
}

bool covers(const PolygonTarget& p, double right, double up) {
  PHYSIM_ASSERT(p.corners.size() >= 3);
  bool inside = false;
  for (std::size_t i = 0, before = p.corners.size() - 1; i < p.corners.size(); before = i++) {
    const PlanePoint &a = p.corners[i], &b = p.corners[before];
    if ((a.up > up) != (b.up > up) && right < a.right + (b.right - a.right) * (up - a.up) / (b.up - a.up))
      inside = !inside;
  }
  return inside;
}

void check_point(Checker& c, const PlanePoint& point, const std::string& place) {
  c.is_number(point.right, place + ".right").is_number(point.up, place + ".up");
}

}  // namespace

Status check(const StudyTarget& target, const std::string& place) {
  Checker c;
  if (const auto* circle = std::get_if<CircleTarget>(&target.shape)) {
    check_point(c, circle->centre, place + ".centre");
    c.positive(circle->radius, place + ".radius");
  } else if (const auto* rectangle = std::get_if<RectangleTarget>(&target.shape)) {
    check_point(c, rectangle->centre, place + ".centre");
    c.positive(rectangle->width, place + ".width").positive(rectangle->height, place + ".height");
  } else {
    const auto& corners = std::get<PolygonTarget>(target.shape).corners;
    c.require(corners.size() >= 3, place + ".corners", "must be three or more");
    for (const PlanePoint& corner : corners) check_point(c, corner, place + ".corners");
  }
  return c.status();
}

std::uint64_t hits_of(const StudyTarget& target, std::span<const double> right, std::span<const double> up) {
  PHYSIM_ASSERT(right.size() == up.size());
  return std::visit(
      [&](const auto& shape) {
        std::uint64_t hits = 0;
        for (std::size_t i = 0; i < right.size(); ++i) hits += covers(shape, right[i], up[i]) ? 1 : 0;
        return hits;
      },
      target.shape);
}

}  // namespace physim
