#include "physim/scene.hpp"

#include "base/ieee_mode.hpp"
#include "collide/content.hpp"
#include "math/elementary.hpp"

namespace physim {
namespace collide {
namespace {

constexpr int kSides = 16;       // of what is round
constexpr int kPathPieces = 32;  // of a path
constexpr double kTurn = 6.283185307179586;

/// Draws triangles of a thing, and tells what they are made of where that changes.
class ThingDraw {
 public:
  ThingDraw(const Placement& at, SceneInk ink, MaterialId own, SceneCanvas& canvas)
      : at_(at), ink_(ink), own_(own), last_(own), canvas_(canvas) {
    canvas_.material(own);
  }
  void of(std::optional<MaterialId> material) {
    const MaterialId next = material.value_or(own_);
    if (next != last_) canvas_.material(last_ = next);
  }
  void operator()(const Vec3d& a, const Vec3d& b, const Vec3d& c) const {
    canvas_.triangle(at_.outside(a), at_.outside(b), at_.outside(c), ink_);
  }

 private:
  const Placement& at_;
  const SceneInk ink_;
  const MaterialId own_;
  MaterialId last_;
  SceneCanvas& canvas_;
};
/// Likewise of a part of it.
struct PartDraw {
  const Compound::Part& part;
  ThingDraw& draw;

  void of(std::optional<MaterialId> material) { draw.of(material ? material : part.definition.material); }
  void operator()(const Vec3d& a, const Vec3d& b, const Vec3d& c) const {
    draw(part.placement.outside(a), part.placement.outside(b), part.placement.outside(c));
  }
};

/// Calls draw(a, b, c) for triangles about the y axis, between circles from below upwards.
template <class Draw>
void draw_turned(const std::vector<std::pair<double, double>>& circles, Draw& draw) {
  const auto at = [&](std::size_t circle, int side) {
    const SinCos<double> angle = sincos(kTurn * (side % kSides) / kSides);
    PHYSIM_ASSERT(circle < circles.size() && side <= kSides);
    const auto [radius, y] = circles[circle];
    return Vec3d{radius * angle.cos, y, radius * angle.sin};
  };
  for (std::size_t i = 0; i + 1 < circles.size(); ++i)
    for (int side = 0; side < kSides; ++side) {
      const Vec3d a = at(i, side), b = at(i, side + 1), c = at(i + 1, side), d = at(i + 1, side + 1);
      if (circles[i].first > 0) draw(a, c, b);
      if (circles[i + 1].first > 0) draw(b, c, d);
    }
}

/// Two half balls with a cylinder between them.
template <class Draw>
void draw_capsule(double radius, double half_height, Draw& draw) {
  constexpr int kRings = kSides / 4;
  std::vector<std::pair<double, double>> circles;
  for (int i = -kRings; i <= kRings; ++i) {
    const SinCos<double> angle = sincos(kTurn / 4 * i / kRings);
    const double across = std::abs(i) == kRings ? 0 : radius * angle.cos;
    if (i <= 0) circles.emplace_back(across, radius * angle.sin - half_height);
    if (i >= 0) circles.emplace_back(across, radius * angle.sin + half_height);
  }
  draw_turned(circles, draw);
}

template <class Draw>
void draw_triangles(const HalfSpace&, Draw&) {}
template <class Draw>
void draw_triangles(const Sphere& s, Draw& draw) {
  draw_capsule(s.radius, 0, draw);
}
template <class Draw>
void draw_triangles(const Capsule& c, Draw& draw) {
  draw_capsule(c.radius, c.half_height, draw);
}
template <class Draw>
void draw_triangles(const Cylinder& c, Draw& draw) {
  draw_turned({{0, -c.half_height}, {c.radius, -c.half_height}, {c.radius, c.half_height}, {0, c.half_height}}, draw);
}
template <class Draw>
void draw_triangles(const Box& box, Draw& draw) {
  for (std::size_t axis = 0; axis < 3; ++axis)
    for (const double side : {-1.0, 1.0}) {
      const auto corner = [&](double u, double v) {
        Vec3d p;
        p[axis] = side * box.half[axis];
        p[(axis + 1) % 3] = u * box.half[(axis + 1) % 3];
        p[(axis + 2) % 3] = side * v * box.half[(axis + 2) % 3];
        return p;
      };
      draw(corner(-1, -1), corner(1, -1), corner(1, 1));
      draw(corner(-1, -1), corner(1, 1), corner(-1, 1));
    }
}
template <class Draw>
void draw_triangles(const Mesh& mesh, Draw& draw) {
  for (std::uint32_t i = 0; i < mesh.size(); ++i) {
    draw.of(mesh.material(mesh.number(i)));
    draw(mesh.triangle(i).a, mesh.triangle(i).b, mesh.triangle(i).c);
  }
}
template <class Draw>
void draw_triangles(const HeightField& field, Draw& draw) {
  for (std::uint32_t row = 0; row + 1 < field.rows(); ++row)
    for (std::uint32_t column = 0; column + 1 < field.columns(); ++column)
      for (std::uint32_t half = 0; half < 2; ++half) {
        const Triangle t = field.triangle(column, row, half);
        draw(t.a, t.b, t.c);
      }
}
template <class Draw>
void draw_triangles(const ConvexHull& hull, Draw& draw) {
  for (const auto& t : hull.triangles()) draw(hull.corners()[t[0]], hull.corners()[t[1]], hull.corners()[t[2]]);
}
void draw_triangles(const Compound& compound, ThingDraw& draw) {
  for (const Compound::Part& part : compound.parts) {
    PartDraw of_part{part, draw};
    of_part.of(std::nullopt);
    std::visit(
        [&](const auto& one) {
          if constexpr (!std::is_same_v<std::remove_cvref_t<decltype(one)>, Compound>) draw_triangles(one, of_part);
        },
        *part.shape);
  }
}

void draw_shape(const Shape& shape, const Placement& at, SceneInk ink, MaterialId own, const SceneDrawing& what,
                SceneCanvas& canvas) {
  ThingDraw draw(at, ink, own, canvas);
  if (std::holds_alternative<HalfSpace>(shape)) {
    const double size = what.plane_size / at.scale();
    const Vec3d corners[] = {{-size, 0, -size}, {-size, 0, size}, {size, 0, size}, {size, 0, -size}};
    if (what.plane_faces) {
      for (const std::size_t i : {0u, 2u}) draw(corners[i], corners[i + 1], corners[(i + 2) % 4]);
      return;
    }
    for (std::size_t i = 0; i < 4; ++i) canvas.line(at.outside(corners[i]), at.outside(corners[(i + 1) % 4]), ink);
    return canvas.line(at.outside(corners[0]), at.outside(corners[2]), ink);
  }
  std::visit([&](const auto& one) { draw_triangles(one, draw); }, shape);
}

void draw_box(const Bounds& box, SceneCanvas& canvas) {
  const auto corner = [&](unsigned i) {
    return Vec3d{(i & 1 ? box.high : box.low).x, (i & 2 ? box.high : box.low).y, (i & 4 ? box.high : box.low).z};
  };
  for (unsigned i = 0; i < 8; ++i)
    for (const unsigned axis : {1u, 2u, 4u})
      if (!(i & axis)) canvas.line(corner(i), corner(i | axis), SceneInk::box);
}

}  // namespace
}  // namespace collide

void SceneCanvas::ball(const Vec3d& middle, double radius, SceneInk ink) {
  for (std::size_t axis = 0; axis < 3; ++axis) {
    const auto on_circle = [&](int side) {
      const double turn = collide::kTurn * side / collide::kSides;
      Vec3d place = middle;
      place[(axis + 1) % 3] += radius * cos(turn);
      place[(axis + 2) % 3] += radius * sin(turn);
      return place;
    };
    for (int side = 0; side < collide::kSides; ++side) line(on_circle(side), on_circle(side + 1), ink);
  }
}

void Scene::draw(SceneCanvas& canvas, const SceneDrawing& what) const {
  const IeeeMode mode;
  if (!(std::abs(what.time) <= collide::kLatest && what.ahead >= 0 && what.ahead <= collide::kLatest)) return;
  for (std::uint32_t index = 0; index < impl_->instances.size(); ++index) {
    const Impl::InstanceSlot& slot = impl_->instances[index];
    if (!slot.alive || !slot.is_asked(what.filter)) continue;
    canvas.begin({index, slot.generation});
    const SceneInk ink = slot.def.sensor ? SceneInk::sensor : SceneInk::solid;
    if (what.shapes)
      collide::draw_shape(*slot.shape, slot.placement_at(what.time), ink, slot.def.material, what, canvas);
    const Vec3d origin = slot.state_at(what.time).position;
    if (what.names && !slot.def.name.empty()) canvas.text(origin, slot.def.name);
    Vec3d before = origin;
    for (int i = 1; i <= collide::kPathPieces && slot.path && what.ahead > 0; ++i) {
      const Vec3d next = slot.state_at(what.time + what.ahead * i / collide::kPathPieces).position;
      canvas.line(before, next, SceneInk::path);
      before = next;
    }
  }
  if (!what.boxes) return;
  const auto draw_box = [&](const collide::Bounds& box) { collide::draw_box(box, canvas); };
  impl_->resting.boxes(draw_box);
  impl_->moving.boxes(draw_box);
}

}  // namespace physim
