#include "collide/shape.hpp"

namespace physim::collide {

Placement::Placement(const Transform& t) : position_(t.position), scale_(t.scale), per_scale_(1 / t.scale) {
  PHYSIM_ASSERT(t.scale > 0 && norm_squared(t.rotation) > 0);
  const Vec3d& p = position_;
  extent_ = std::max({std::abs(p.x), std::abs(p.y), std::abs(p.z)});
  const Quatd q = normalized(t.rotation);
  x_ = rotate(q, Vec3d{1, 0, 0});
  y_ = rotate(q, Vec3d{0, 1, 0});
  z_ = rotate(q, Vec3d{0, 0, 1});
}

Bounds Placement::outside(const Bounds& box) const {
  Bounds all;
  for (int corner = 0; corner < 8; ++corner)
    all.take(outside(Vec3d{(corner & 1 ? box.high : box.low).x, (corner & 2 ? box.high : box.low).y,
                           (corner & 4 ? box.high : box.low).z}));
  const auto most = [](const Vec3d& v) { return std::max({std::abs(v.x), std::abs(v.y), std::abs(v.z)}); };
  all.widen(16 * std::numeric_limits<double>::epsilon() * (most(all.low) + most(all.high)));
  return all;
}

namespace {

template <class Surface>
std::optional<NearPlace> nearest(const Surface& surface, const Vec3d& p, double& within) {
  if constexpr (requires { surface.nearest(p, within); }) {
    return surface.nearest(p, within);
  } else {
    const Nearest core = surface.nearest(p);
    const double distance = std::max(core.distance - surface.margin(), 0.0);
    if (distance > within) return std::nullopt;
    within = distance;
    return NearPlace{p - core.away * distance, distance > 0 ? core.away : Vec3d{}};
  }
}
std::optional<NearPlace> nearest(const Compound& compound, const Vec3d& p, double& within) {
  std::optional<NearPlace> found;
  for (std::uint32_t i = 0; i < compound.parts.size(); ++i) {
    const Compound::Part& part = compound.parts[i];
    double least = within / part.placement.scale();
    const auto near = nearest_of(*part.shape, part.placement.inside(p), least);
    if (!near || (found && least * part.placement.scale() >= within)) continue;
    found = {part.placement.outside(near->position), part.placement.turned(near->away), i, near->primitive};
    within = least * part.placement.scale();
  }
  return found;
}

template <class Surface>
double clearance(const Surface& surface, const Vec3d& p) {
  if constexpr (requires { surface.clearance(p); })
    return surface.clearance(p);
  else
    return std::max(surface.nearest(p).distance - surface.margin(), 0.0);
}
double clearance(const Compound& compound, const Vec3d& p) {
  double least = kFarthest;
  for (const Compound::Part& part : compound.parts) {
    const double beside = part.bounds.least_distance(p);
    if (beside >= least) continue;
    const double own = clearance_of(*part.shape, part.placement.inside(p)) * part.placement.scale();
    least = std::min(least, std::max(beside, own));
  }
  return least;
}

}  // namespace

Bounds Compound::bounds() const {
  Bounds all;
  for (const Part& part : parts) all.take(part.bounds);
  return all;
}
CompoundShape Compound::definition() const {
  CompoundShape shape;
  for (const Part& part : parts) shape.parts.push_back(part.definition);
  return shape;
}

Bounds bounds_of(const Shape& shape) {
  return std::visit([](const auto& one) -> Bounds { return one.bounds(); }, shape);
}
ShapeDef definition_of(const Shape& shape) {
  return std::visit([](const auto& one) -> ShapeDef { return one.definition(); }, shape);
}

std::optional<MaterialId> material_of(const Shape& shape, std::uint32_t primitive, std::uint32_t triangle) {
  if (const auto* mesh = std::get_if<Mesh>(&shape)) return mesh->material(primitive);
  const auto* compound = std::get_if<Compound>(&shape);
  if (!compound) return std::nullopt;
  PHYSIM_ASSERT(primitive < compound->parts.size());
  const Compound::Part& part = compound->parts[primitive];
  const auto* mesh = std::get_if<Mesh>(part.shape.get());
  const auto of_triangle = mesh ? mesh->material(triangle) : std::nullopt;
  return of_triangle ? of_triangle : part.definition.material;
}

double clearance_of(const Shape& shape, const Vec3d& p) {
  return std::visit([&](const auto& one) { return clearance(one, p); }, shape);
}

double clear_part_of(const Shape& shape, const Segment& s) {
  if (const auto* compound = std::get_if<Compound>(&shape)) {
    Segment within = s;
    for (const Compound::Part& part : compound->parts)
      if (BoxTest(within).enters(part.bounds, within.reach) <= within.reach)
        within.reach = clear_part_of(*part.shape, part.placement.inside(within));
    return within.reach;
  }
  return std::visit(
      [&](const auto& one) {
        if constexpr (requires { one.clear_part(s); }) {
          return one.clear_part(s);
        } else if constexpr (std::is_same_v<std::remove_cvref_t<decltype(one)>, Compound>) {
          return 0.0;
        } else {
          const Passage p = passage(s, one, false);
          return p.some ? std::min(s.reach, p.in.t) : s.reach;
        }
      },
      shape);
}

std::optional<NearPlace> nearest_of(const Shape& shape, const Vec3d& p, double& within) {
  return std::visit([&](const auto& one) { return nearest(one, p, within); }, shape);
}

}  // namespace physim::collide
