#include "collide/mesh.hpp"

#include <algorithm>
#include <string>

#include "base/checker.hpp"

namespace physim::collide {
namespace {

std::string at(const char* list, std::size_t i) { return std::string("shape.") + list + '[' + std::to_string(i) + ']'; }

Status check(const MeshShape& shape, std::size_t materials) {
  for (std::size_t i = 0; i < shape.vertices.size(); ++i) {
    const Vec3d& v = shape.vertices[i];
    if (!(std::max({std::abs(v.x), std::abs(v.y), std::abs(v.z)}) <= kFarthest) || !finite(v))
      return Error{"must have three components within 1e15 m", at("vertices", i), ""};
  }
  for (std::size_t i = 0; i < shape.triangles.size(); ++i)
    for (const std::uint32_t corner : shape.triangles[i])
      if (corner >= shape.vertices.size())
        return Error{"names vertex " + std::to_string(corner) + " of " + std::to_string(shape.vertices.size()),
                     at("triangles", i), "vertices count from 0"};
  if (!shape.materials.empty() && shape.materials.size() != shape.triangles.size())
    return Error{"has another length than the triangles", "shape.materials", "one for each triangle, or none"};
  for (std::size_t i = 0; i < shape.materials.size(); ++i)
    if (shape.materials[i].index >= materials)
      return Error{"is no material of this scene", at("materials", i), "add_material() gives them"};
  return {};
}

}  // namespace

Result<Mesh> Mesh::make(const MeshShape& shape, std::size_t materials) {
  if (const Status status = check(shape, materials); !status) return status.error();
  Mesh mesh;
  mesh.vertices_ = shape.vertices;
  mesh.materials_ = shape.materials;
  std::vector<BvhItem> items;
  items.reserve(shape.triangles.size());
  for (std::uint32_t i = 0; i < shape.triangles.size(); ++i) {
    const auto& corners = shape.triangles[i];
    const Triangle triangle{mesh.vertices_[corners[0]], mesh.vertices_[corners[1]], mesh.vertices_[corners[2]]};
    if (!has_area(triangle)) {
      ++mesh.degenerate_;
      continue;
    }
    Bounds box;
    for (const Vec3d& corner : {triangle.a, triangle.b, triangle.c}) box.take(corner);
    mesh.bounds_.take(box);
    items.emplace_back(box, i);
  }
  if (items.empty()) return Error{"has no triangle with an area", "shape.triangles", "add some"};
  mesh.tree_ = Bvh(items);
  mesh.triangles_.reserve(items.size());
  mesh.numbers_.reserve(items.size());
  for (const BvhItem& item : items) {
    mesh.triangles_.push_back(shape.triangles[item.number()]);
    mesh.numbers_.push_back(item.number());
  }
  mesh.put_vertices_in_order();
  mesh.closed_ = mesh.is_closed();
  if (mesh.closed_ && mesh.volume() < 0)
    return Error{"close a body that is inside out", "shape.triangles", "give their corners the other way round"};
  return mesh;
}

/// As triangles name them, so that those of one leaf lie side by side; those that none names come last.
void Mesh::put_vertices_in_order() {
  constexpr std::uint32_t kNowhere = 0xffffffff;
  std::vector<std::uint32_t> place(vertices_.size(), kNowhere);
  std::vector<Vec3d> ordered;
  ordered.reserve(vertices_.size());
  const auto put = [&](std::uint32_t vertex) {
    if (place[vertex] != kNowhere) return;
    place[vertex] = static_cast<std::uint32_t>(ordered.size());
    ordered.push_back(vertices_[vertex]);
  };
  for (auto& triangle : triangles_)
    for (std::uint32_t& corner : triangle) {
      put(corner);
      corner = place[corner];
    }
  for (std::uint32_t vertex = 0; vertex < vertices_.size(); ++vertex) put(vertex);
  vertices_ = std::move(ordered);
}

/// Whether each edge is walked once in either direction: by the edges that begin at each vertex.
bool Mesh::is_closed() const {
  std::vector<std::uint32_t> begin(vertices_.size() + 1, 0), ends(3 * triangles_.size());
  for (const auto& t : triangles_)
    for (const std::uint32_t corner : t) ++begin[corner];
  std::uint32_t sum = 0;
  for (std::uint32_t& b : begin) sum += b, b = sum;
  for (const auto& t : triangles_)
    for (std::size_t i = 0; i < 3; ++i) ends[--begin[t[i]]] = t[(i + 1) % 3];
  const auto from = [&](std::size_t vertex) {
    return std::span(ends).subspan(begin[vertex], begin[vertex + 1] - begin[vertex]);
  };
  for (std::size_t vertex = 0; vertex < vertices_.size(); ++vertex) {
    const auto list = from(vertex);
    std::ranges::sort(list);
    if (std::ranges::adjacent_find(list) != list.end()) return false;
  }
  for (std::uint32_t vertex = 0; vertex < vertices_.size(); ++vertex)
    for (const std::uint32_t end : from(vertex))
      if (!std::ranges::binary_search(from(end), vertex)) return false;
  return true;
}

/// What is inside of a closed mesh, by tetrahedra from the middle of its box: below 0 where it is inside out.
double Mesh::volume() const {
  const Vec3d middle = bounds_.middle();
  double sum = 0;
  for (std::uint32_t i = 0; i < triangles_.size(); ++i) {
    const Triangle t = triangle(i);
    sum += dot(t.a - middle, cross(t.b - middle, t.c - middle));
  }
  return sum / 6;
}

MeshShape Mesh::definition() const {
  MeshShape shape{vertices_, {}, materials_};
  shape.triangles.resize(triangles_.size() + degenerate_);
  for (std::uint32_t i = 0; i < triangles_.size(); ++i) shape.triangles[number(i)] = triangles_[i];
  return shape;
}

ShapeInfo Mesh::info() const {
  return {.triangles = triangles_.size(),
          .degenerate = degenerate_,
          .closed = closed_,
          .bytes = vertices_.capacity() * sizeof(Vec3d) + triangles_.capacity() * sizeof(triangles_[0]) +
                   numbers_.capacity() * sizeof(std::uint32_t) + materials_.capacity() * sizeof(MaterialId) +
                   tree_.bytes()};
}

std::optional<NearPlace> Mesh::nearest(const Vec3d& p, double& within) const {
  std::optional<NearPlace> found;
  tree_.around(p, within, [&](std::uint32_t i, double& least) {
    const Nearest near = nearest_to(triangle(i), p);
    if (!(near.distance <= least)) return;
    least = near.distance;
    found = {p - near.away * least, least > 0 ? near.away : triangle(i).normal(), number(i)};
  });
  return found;
}

double Mesh::clearance(const Vec3d& p) const {
  double within = kFarthest;
  // Half of a distance that was found: what is not nearer than that need not be looked at.
  tree_.around<true>(p, within, [&](std::uint32_t i, double& least) {
    least = std::min(least, 0.5 * length(p - nearest_point(triangle(i), p)));
  });
  return within;
}

}  // namespace physim::collide
