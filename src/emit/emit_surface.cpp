// Equations, symbols and Source: emit/emit_surface.hpp.
#include "emit/emit_surface.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "base/emit_shape_table.hpp"
#include "math/elementary.hpp"
#include "math/vec3.hpp"

namespace physim {
namespace {

using collide::HeightField;
using collide::Mesh;
using collide::Triangle;

constexpr Vec3d kForwards{1, 0, 0};

/// A number between 0 and 1 of twice as many digits as one that is drawn.
double fine_chance(ParticleChance& chance) {
  return std::clamp(chance(Draw::along) + (chance(Draw::side) - 0.5) / 4294967296.0, 0.0, 1.0);
}

double area_of(const Triangle& t) { return length(cross(t.b - t.a, t.c - t.a)) / 2; }

/// Parts of the corners, which come to one.
using Parts = std::array<double, 3>;
Parts even_in_triangle(ParticleChance& chance) {
  const double s = std::sqrt(chance(Draw::arc)), v = chance(Draw::depth);
  return {1 - s, s * (1 - v), s * v};
}
Vec3d mixed(const Parts& parts, const Vec3d& a, const Vec3d& b, const Vec3d& c) {
  return a * parts[0] + b * parts[1] + c * parts[2];
}

/// A direction, of length one; where the sum has none, `otherwise`.
Vec3d direction_of(const Vec3d& sum, const Vec3d& otherwise) {
  constexpr double kNone = 1e-9;
  const double size = length(sum);
  return size > kNone ? sum * (1 / size) : otherwise;
}

// ------------------------------------------------------------------------------------------------- meshes
class MeshOutlets : public SurfaceOutlets {
 public:
  MeshOutlets(const EmitFrom& from, const Mesh& mesh)
      : shape_(from.surface.shape), mesh_(mesh), scale_(from.surface.scale), along_(from.surface.along) {}

 protected:
  /// The angle of a triangle at its first corner.
  static double angle(const Triangle& t) {
    const Vec3d b = t.b - t.a, c = t.c - t.a;
    return atan2(length(cross(b, c)), dot(b, c));
  }
  /// Those of all vertices that triangles have.
  [[nodiscard]] std::vector<Vec3d> vertex_normals() const {
    std::vector<Vec3d> sums, first;
    for (std::uint32_t i = 0; i < mesh_.size(); ++i) {
      const Triangle t = mesh_.triangle(i);
      const Vec3d normal = t.normal();
      const double angles[] = {angle(t), angle({t.b, t.c, t.a}), angle({t.c, t.a, t.b})};
      for (std::size_t k = 0; k < 3; ++k) {
        const std::uint32_t vertex = mesh_.corners(i)[k];
        if (vertex >= sums.size()) sums.resize(vertex + 1), first.resize(vertex + 1);
        sums[vertex] += normal * angles[k];
        if (first[vertex] == Vec3d{}) first[vertex] = normal;
      }
    }
    for (std::size_t v = 0; v < sums.size(); ++v) sums[v] = direction_of(sums[v], first[v]);
    return sums;
  }
  [[nodiscard]] Vec3d scaled(const Vec3d& place) const { return place * scale_; }

  SharedShape shape_;  // holds the mesh
  const Mesh& mesh_;
  double scale_;
  EmitAlong along_;
};

class MeshSurface final : public MeshOutlets {
 public:
  MeshSurface(const EmitFrom& from, const Mesh& mesh) : MeshOutlets(from, mesh) {
    std::vector<double> areas;
    for (std::uint32_t i = 0; i < mesh.size(); ++i) areas.push_back(area_of(mesh.triangle(i)));
    choice_ = WeightedChoice(areas);
    if (along_ == EmitAlong::smooth) normals_ = vertex_normals();
  }
  [[nodiscard]] Outlet at(ParticleChance& chance) const override {
    const std::uint32_t i = choice_(fine_chance(chance)).which;
    PHYSIM_ASSERT(i < mesh_.size());
    const Triangle t = mesh_.triangle(i);
    const Parts parts = even_in_triangle(chance);
    Outlet out{scaled(mixed(parts, t.a, t.b, t.c)), kForwards};
    if (along_ == EmitAlong::normal) out.direction = t.normal();
    if (along_ != EmitAlong::smooth) return out;
    const auto& corner = mesh_.corners(i);
    out.direction =
        direction_of(mixed(parts, normals_[corner[0]], normals_[corner[1]], normals_[corner[2]]), t.normal());
    return out;
  }

 private:
  WeightedChoice choice_;
  std::vector<Vec3d> normals_;  // of vertices
};

class MeshVertices final : public MeshOutlets {
 public:
  MeshVertices(const EmitFrom& from, const Mesh& mesh) : MeshOutlets(from, mesh), normals_(vertex_normals()) {
    places_.resize(normals_.size());  // triangles name the first vertices, all of them
    for (std::uint32_t i = 0; i < mesh.size(); ++i) {
      const Triangle t = mesh.triangle(i);
      const auto& corner = mesh.corners(i);
      places_[corner[0]] = t.a, places_[corner[1]] = t.b, places_[corner[2]] = t.c;
    }
    PHYSIM_ASSERT(!places_.empty());
  }
  [[nodiscard]] Outlet at(ParticleChance& chance) const override {
    const auto count = static_cast<double>(places_.size());
    const auto i = static_cast<std::size_t>(std::min(fine_chance(chance) * count, count - 1));
    return {scaled(places_[i]), along_ == EmitAlong::axis ? kForwards : normals_[i]};
  }

 private:
  std::vector<Vec3d> normals_, places_;
};

class MeshEdges final : public MeshOutlets {
 public:
  MeshEdges(const EmitFrom& from, const Mesh& mesh) : MeshOutlets(from, mesh) {
    std::vector<Side> sides;
    for (std::uint32_t i = 0; i < mesh.size(); ++i)
      for (std::uint32_t k = 0; k < 3; ++k) {
        const std::uint32_t a = mesh.corners(i)[k], b = mesh.corners(i)[(k + 1) % 3];
        sides.push_back({{std::min(a, b), std::max(a, b)}, i, k});
      }
    std::ranges::sort(sides);
    std::vector<double> lengths;
    for (auto side = sides.begin(); side != sides.end();) {
      const auto next = std::find_if(side, sides.end(), [&](const Side& s) { return s.ends != side->ends; });
      Vec3d sum;
      for (auto beside = side; beside != next; ++beside) sum += mesh.triangle(beside->triangle).normal();
      const Triangle t = mesh.triangle(side->triangle);
      const Vec3d corner[] = {t.a, t.b, t.c};
      edges_.push_back({corner[side->number], corner[(side->number + 1) % 3], direction_of(sum, t.normal())});
      lengths.push_back(length(edges_.back().to - edges_.back().from));
      side = next;
    }
    choice_ = WeightedChoice(lengths);
  }
  [[nodiscard]] Outlet at(ParticleChance& chance) const override {
    const Edge& edge = edges_[choice_(fine_chance(chance)).which];
    const Vec3d place = edge.from + (edge.to - edge.from) * chance(Draw::arc);
    return {scaled(place), along_ == EmitAlong::axis ? kForwards : edge.normal};
  }

 private:
  /// A side of a triangle.
  struct Side {
    std::pair<std::uint32_t, std::uint32_t> ends;
    std::uint32_t triangle, number;
    auto operator<=>(const Side&) const = default;
  };
  struct Edge {
    Vec3d from, to, normal;
  };
  WeightedChoice choice_;
  std::vector<Edge> edges_;
};

// ------------------------------------------------------------------------------------------------- terrain
/// Corners of a triangle after sides were cut away.
struct Polygon {
  std::array<Vec3d, 7> corner{};
  std::size_t size = 0;

  void add(const Vec3d& p) {
    PHYSIM_ASSERT(size < corner.size());
    corner[size++] = p;
  }
};
/// What is left on the side of a line where `axis` of the point, times `sign`, is not above a limit.
Polygon cut(const Polygon& whole, std::size_t axis, double sign, double limit) {
  Polygon left;
  for (std::size_t i = 0; i < whole.size; ++i) {
    const Vec3d &a = whole.corner[i], &b = whole.corner[(i + 1) % whole.size];
    const double over_a = sign * a[axis] - limit, over_b = sign * b[axis] - limit;
    if (over_a <= 0) left.add(a);
    if ((over_a < 0 && over_b > 0) || (over_a > 0 && over_b < 0)) left.add(a + (b - a) * (over_a / (over_a - over_b)));
  }
  return left;
}

class TerrainOutlets final : public SurfaceOutlets {
 public:
  TerrainOutlets(const EmitFrom& from, const HeightField& field)
      : shape_(from.surface.shape),
        field_(field),
        patch_(patch_of(from.surface, field)),
        scale_(from.surface.scale),
        along_(from.surface.along) {
    PHYSIM_ASSERT(patch_.low_x < patch_.high_x && patch_.low_z < patch_.high_z);
    const auto first = [](double low, double spacing, std::uint32_t points) {
      return std::min(static_cast<std::uint32_t>(low / spacing), points - 2);
    };
    const auto end = [](double high, double spacing, std::uint32_t points) {
      return static_cast<std::uint32_t>(std::min(std::ceil(high / spacing), points - 1.0));
    };
    column_ = first(patch_.low_x, field.spacing_x(), field.columns());
    row_ = first(patch_.low_z, field.spacing_z(), field.rows());
    columns_ = std::max(end(patch_.high_x, field.spacing_x(), field.columns()), column_ + 1) - column_;
    const std::uint32_t rows = std::max(end(patch_.high_z, field.spacing_z(), field.rows()), row_ + 1) - row_;
    std::vector<double> areas;
    areas.reserve(std::size_t{columns_} * rows);
    for (std::uint32_t row = 0; row < rows; ++row)
      for (std::uint32_t column = 0; column < columns_; ++column) {
        double area = 0;
        each_triangle(column_ + column, row_ + row, [&area](const Triangle& t, std::uint32_t) { area += area_of(t); });
        areas.push_back(area);
      }
    choice_ = WeightedChoice(areas);
  }

  [[nodiscard]] Outlet at(ParticleChance& chance) const override {
    const WeightedChoice::Chosen cell = choice_(fine_chance(chance));
    const std::uint32_t column = column_ + cell.which % columns_, row = row_ + cell.which / columns_;
    double area = 0;
    each_triangle(column, row, [&area](const Triangle& t, std::uint32_t) { area += area_of(t); });
    // The rest of the number chooses among the cell's triangles.
    double left = cell.rest * area;
    Triangle chosen{};
    std::uint32_t half = 0;
    bool is_found = false;
    each_triangle(column, row, [&](const Triangle& t, std::uint32_t of) {
      if (is_found) return;
      chosen = t, half = of;
      left -= area_of(t);
      is_found = left < 0;
    });
    const Parts parts = even_in_triangle(chance);
    const Vec3d place = mixed(parts, chosen.a, chosen.b, chosen.c);
    return {place * scale_, direction(column, row, half, place)};
  }

 private:
  /// Calls f with each triangle of a cell, or what the patch leaves of it, and the half that it belongs to.
  template <class F>
  void each_triangle(std::uint32_t column, std::uint32_t row, const F& f) const {
    const double x = column * field_.spacing_x(), z = row * field_.spacing_z();
    const bool is_whole = x >= patch_.low_x && x + field_.spacing_x() <= patch_.high_x && z >= patch_.low_z &&
                          z + field_.spacing_z() <= patch_.high_z;
    for (std::uint32_t half = 0; half < 2; ++half) {
      const Triangle t = field_.triangle(column, row, half);
      if (is_whole) {
        f(t, half);
        continue;
      }
      Polygon p;
      for (const Vec3d& corner : {t.a, t.b, t.c}) p.add(corner);
      p = cut(cut(p, 0, 1, patch_.high_x), 0, -1, -patch_.low_x);
      p = cut(cut(p, 2, 1, patch_.high_z), 2, -1, -patch_.low_z);
      for (std::size_t i = 2; i < p.size; ++i) f(Triangle{p.corner[0], p.corner[i - 1], p.corner[i]}, half);
    }
  }
  [[nodiscard]] Vec3d direction(std::uint32_t column, std::uint32_t row, std::uint32_t half, const Vec3d& at) const {
    if (along_ == EmitAlong::axis) return kForwards;
    const Triangle t = field_.triangle(column, row, half);
    if (along_ == EmitAlong::normal) return t.normal();
    const double x = std::clamp(at.x / field_.spacing_x() - column, 0.0, 1.0);
    const double z = std::clamp(at.z / field_.spacing_z() - row, 0.0, 1.0);
    const Vec3d right = normal_at(column + 1, row), far = normal_at(column, row + 1);
    const Vec3d sum = half == 0 ? normal_at(column, row) * (1 - x - z) + far * z + right * x
                                : right * (1 - z) + far * (1 - x) + normal_at(column + 1, row + 1) * (x + z - 1);
    return direction_of(sum, t.normal());
  }
  /// By the points beside it; at the border by the point and its one neighbour.
  [[nodiscard]] Vec3d normal_at(std::uint32_t column, std::uint32_t row) const {
    const std::uint32_t left = std::max(column, 1u) - 1, right = std::min(column + 1, field_.columns() - 1);
    const std::uint32_t near = std::max(row, 1u) - 1, far = std::min(row + 1, field_.rows() - 1);
    const double along_x =
        (field_.height(right, row) - field_.height(left, row)) / ((right - left) * field_.spacing_x());
    const double along_z =
        (field_.height(column, far) - field_.height(column, near)) / ((far - near) * field_.spacing_z());
    return normalized(Vec3d{-along_x, 1, -along_z});
  }

  SharedShape shape_;  // holds the field
  const HeightField& field_;
  EmitPatch patch_;
  double scale_;
  EmitAlong along_;
  std::uint32_t column_ = 0, row_ = 0;  // of the first cell
  std::uint32_t columns_ = 0;           // of cells
  WeightedChoice choice_;               // among these
};

}  // namespace

EmitPatch patch_of(const EmitSurface& surface, const HeightField& field) {
  return {std::max(surface.low_x, 0.0), std::min(surface.high_x, (field.columns() - 1) * field.spacing_x()),
          std::max(surface.low_z, 0.0), std::min(surface.high_z, (field.rows() - 1) * field.spacing_z())};
}

std::shared_ptr<const SurfaceOutlets> surface_outlets(const EmitFrom& from) {
  if (!reads(from.shape, kFromSurface)) return nullptr;
  const SharedShape::Content* content = from.surface.shape.content();
  PHYSIM_ASSERT(content && (from.shape == EmitShape::terrain) == (content->field() != nullptr));  // by check()
  if (from.shape == EmitShape::terrain) return std::make_shared<TerrainOutlets>(from, *content->field());
  if (from.shape == EmitShape::mesh_edges) return std::make_shared<MeshEdges>(from, *content->mesh());
  if (from.shape == EmitShape::mesh_vertices) return std::make_shared<MeshVertices>(from, *content->mesh());
  return std::make_shared<MeshSurface>(from, *content->mesh());
}

}  // namespace physim
