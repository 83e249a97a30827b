// Floors of two bodies that touch each other: whatever comes down on the seam is stopped by one of them.
#include <cstdio>
#include <string>

#include "collide/scene_support.hpp"
#include "hits/hits.hpp"
#include "math/quat.hpp"

namespace physim::test {
namespace {

constexpr int kMostTold = 20;

/// Bodies whose upper side is level at y = 0 and whose side at x = 0 touches another one's.
enum class Body { box, hull, cylinder, compound, mesh, field };
constexpr Body kBodies[] = {Body::box, Body::hull, Body::cylinder, Body::compound, Body::mesh, Body::field};
constexpr const char* kNames[] = {"box", "hull", "cylinder", "compound", "mesh", "height field"};

/// Places about a seam, in a frame that is turned and far away.
struct Frame {
  Vec3d origin;
  Quatd turn{1, 0, 0, 0};

  [[nodiscard]] Vec3d outside(const Vec3d& p) const { return origin + rotate(turn, p); }
};

struct Floor {
  Scene scene;
  bool thin = false;  // a point is all that the bodies share

  /// `side`: -1 or 1, where it lies along x.
  void add(Body body, double side, const Frame& frame, Random& r) {
    const Vec3d half{r.in(0.3, 3), r.in(0.1, 1), r.in(1.5, 4)};
    Vec3d middle{side * half.x, -half.y, 0};
    ShapeDef shape = BoxShape{half};
    if (body == Body::hull) {
      ConvexHullShape hull;
      for (const Vec3d& corner : closed_box(half).vertices) hull.points.push_back(corner);
      hull.points.push_back({side * half.x * 1.5, -half.y, 0});
      shape = hull;
    } else if (body == Body::cylinder) {
      shape = CylinderShape{half.x, half.y};
      thin = true;
    } else if (body == Body::mesh) {
      shape = closed_box(half);
    } else if (body == Body::field) {
      HeightFieldShape field{.columns = 5, .rows = 5, .spacing_x = 0.5 * half.x, .spacing_z = 0.5 * half.z};
      field.heights.assign(25, 0);
      shape = field;
      middle = {side < 0 ? -2 * half.x : 0, 0, -half.z};
    } else if (body == Body::compound) {
      const ShapeId part = scene.add_shape(BoxShape{{half.x, half.y, 0.5 * half.z}}).value();
      shape = CompoundShape{{{part, {.position = {0, 0, 0.5 * half.z}}}, {part, {.position = {0, 0, -0.5 * half.z}}}}};
    }
    const ShapeId added = scene.add_shape(shape).value();
    if (!scene.add({.shape = added, .transform = {.position = frame.outside(middle), .rotation = frame.turn}}))
      std::puts("no floor");
  }
};

/// Down on a place of the seam, straight or aslant.
Vec3d way_down(Random& r) {
  if (r.one_in(3)) return {0, -1, 0};
  const double slope = std::pow(10.0, r.in(-16, 0.5));
  const double turn = r.one_in(2) ? 0 : r.in(0, 6.283185307179586);
  return normalized(Vec3d{(r.one_in(2) ? slope : -slope) * std::cos(turn), -1, slope * std::sin(turn)});
}

struct Tried {
  long casts = 0, wrong = 0;
};

void tell(Tried& tried, const char* what, Body left, Body right, double far, const Vec3d& way, double radius) {
  if (++tried.wrong <= kMostTold)
    std::printf("%s beside %s at %g m: %s along (%.3g, %.3g, %.3g), radius %g\n", kNames[int(left)], kNames[int(right)],
                far, what, way.x, way.y, way.z, radius);
}

void cast(Tried& tried, const Floor& floor, const Frame& frame, Body left, Body right, double far, bool in_float,
          Random& r) {
  const Vec3d down = way_down(r);
  Vec3d aim = frame.outside({0, 0, floor.thin ? 0 : r.in(-1.4, 1.4)});
  if (in_float) aim = {double(float(aim.x)), double(float(aim.y)), double(float(aim.z))};
  const double ulp = 2.3e-16 * (1 + far);
  const double radius = r.one_in(2) ? 0 : std::pow(10.0, r.in(std::log10(8 * ulp), 0));
  const double high = r.in(0.01, 3);
  SceneSegment s{.from = aim - rotate(frame.turn, down) * high,
                 .to = aim + rotate(frame.turn, down) * r.in(0.05, 1),
                 .radius = radius};
  const double above = rotate(conjugate(frame.turn), s.from - frame.origin).y;  // floats have moved it
  const auto is_hollow = [](Body body) { return body == Body::field || body == Body::mesh; };
  // Triangles are met at their surfaces alone: what begins below those comes out below them, or meets nothing.
  if ((is_hollow(left) || is_hollow(right)) && above + radius < 0) return;
  if (rotate(conjugate(frame.turn), s.to - frame.origin).y > radius) return;  // it ends above the floor
  ++tried.casts;
  const SceneHit hit = floor.scene.first_hit(s);
  if (!hit) return tell(tried, "nothing is hit", left, right, far, down, radius);
  if (hit.starts_inside) {
    if (radius < above * (1 - 1e-9) - 8 * ulp) tell(tried, "it begins inside", left, right, far, down, radius);
    return;
  }
  const Vec3d at = rotate(conjugate(frame.turn), hit.position - frame.origin);
  const bool is_hull = left == Body::hull || right == Body::hull;  // whose slanting sides are within 1e-12
  const double rounding = (in_float ? 3e-7 : is_hull ? 1e-11 : 4e-15) * (4 + far) / -down.y;
  if (at.y < -rounding) tell(tried, "it is hit below its surface", left, right, far, down, radius);
}

}  // namespace

long wrong_seams(long count, long seed) {
  Random r(static_cast<std::uint64_t>(seed));
  long wrong = 0;
  for (const double far : {0.0, 1e3, 1e6}) {
    Tried all;
    for (const Body left : kBodies)
      for (const Body right : kBodies) {
        Tried tried;
        const long floors = std::max(1L, count / 2000);
        for (long i = 0; i < floors; ++i) {
          Frame frame{far * normalized(random_vector(r, 1))};
          if (i % 2 == 1) frame.turn = normalized(random_transform(r, 1).rotation);
          Floor floor;
          floor.add(left, -1, frame, r);
          floor.add(right, 1, frame, r);
          // At 1000 km floats are 6 cm apart: they leave the one point that thin floors share.
          const bool may_be_float = !floor.thin || far < 1e5;
          for (int k = 0; k < 100; ++k) cast(tried, floor, frame, left, right, far, may_be_float && k % 4 == 0, r);
        }
        all.casts += tried.casts;
        all.wrong += tried.wrong;
        if (tried.wrong > 0)
          std::printf("%s beside %s: %ld of %ld wrong\n", kNames[int(left)], kNames[int(right)], tried.wrong,
                      tried.casts);
      }
    std::printf("seams of %zu bodies at %7.0f m: %ld casts, %ld wrong\n", std::size(kBodies), far, all.casts,
                all.wrong);
    wrong += all.wrong;
  }
  return wrong;
}

}  // namespace physim::test
