#include "collide/quickhull.hpp"

#include <algorithm>

#include "base/assert.hpp"

namespace physim::collide {
namespace {

using WideVector = std::array<Wide, 3>;
constexpr std::uint32_t kNobody = 0xffffffff;

WideVector difference(const GridPoint& a, const GridPoint& b) {
  return {Wide{a[0]} - b[0], Wide{a[1]} - b[1], Wide{a[2]} - b[2]};
}
WideVector wide_cross(const WideVector& a, const WideVector& b) {
  return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}
Wide wide_dot(const WideVector& a, const WideVector& b) { return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]; }

class Quickhull {
 public:
  explicit Quickhull(std::span<const GridPoint> points) : points_(points), face_from_(points.size(), kNobody) {}

  [[nodiscard]] bool build() {
    if (!begin()) return false;
    for (std::uint32_t face = 0; face < faces_.size(); ++face)
      while (faces_[face].alive && !faces_[face].outside.empty()) reach_out(face);
    return true;
  }
  /// The triangles that are left, numbered anew.
  [[nodiscard]] std::vector<HullTriangle> triangles() const {
    std::vector<std::uint32_t> number(faces_.size(), kNobody);
    std::uint32_t count = 0;
    for (std::size_t i = 0; i < faces_.size(); ++i)
      if (faces_[i].alive) number[i] = count++;
    std::vector<HullTriangle> list;
    for (const Face& face : faces_) {
      if (!face.alive) continue;
      list.push_back(face.triangle);
      for (std::uint32_t& neighbour : list.back().neighbour) {
        PHYSIM_ASSERT(faces_[neighbour].alive);
        neighbour = number[neighbour];
      }
    }
    return list;
  }

 private:
  struct Face {
    HullTriangle triangle;
    std::vector<std::uint32_t> outside;  // points above it
    bool alive = true;
    bool seen = false;  // from the point that is being taken in
  };
  /// An edge beyond which nothing is seen.
  struct Edge {
    std::uint32_t from, to, beyond;
  };

  [[nodiscard]] Wide height(const Face& face, std::uint32_t point) const {
    return height_above(face.triangle, points_, points_[point]);
  }
  /// The point for which `size` is largest; of several the first by coordinates, which is a corner of the hull.
  template <class Size>
  [[nodiscard]] std::uint32_t farthest(const Size& size) const {
    std::uint32_t best = 0;
    for (std::uint32_t i = 1; i < points_.size(); ++i)
      if (size(i) > size(best) || (size(i) == size(best) && points_[i] < points_[best])) best = i;
    return best;
  }

  /// A tetrahedron of points that are far apart; false where all lie in one plane.
  [[nodiscard]] bool begin() {
    if (points_.size() < 4) return false;
    const std::uint32_t a = farthest([](std::uint32_t) { return 0; });
    const std::uint32_t b = farthest([&](std::uint32_t i) {
      const WideVector d = difference(points_[i], points_[a]);
      return wide_dot(d, d);
    });
    const WideVector ab = difference(points_[b], points_[a]);
    const std::uint32_t c = farthest([&](std::uint32_t i) {
      double square = 0;
      for (const Wide x : wide_cross(ab, difference(points_[i], points_[a])))
        square += static_cast<double>(x) * static_cast<double>(x);
      return square;
    });
    Face base = make_face(a, b, c);
    const std::uint32_t d = farthest([&](std::uint32_t i) {
      const Wide h = height(base, i);
      return h < 0 ? -h : h;
    });
    const Wide above = height(base, d);
    if (above == 0) return false;
    const std::uint32_t one = above > 0 ? c : b, other = above > 0 ? b : c;  // so that d lies below the first triangle
    faces_ = {make_face(a, one, other), make_face(a, other, d), make_face(other, one, d), make_face(one, a, d)};
    const std::array<std::uint32_t, 3> neighbours[] = {{3, 2, 1}, {0, 2, 3}, {0, 3, 1}, {0, 1, 2}};
    for (std::size_t i = 0; i < 4; ++i) faces_[i].triangle.neighbour = neighbours[i];
    std::vector<std::uint32_t> all(points_.size());
    for (std::uint32_t i = 0; i < all.size(); ++i) all[i] = i;
    hand_out(all, 0);
    return true;
  }

  [[nodiscard]] Face make_face(std::uint32_t a, std::uint32_t b, std::uint32_t c) const {
    Face face;
    face.triangle = {{a, b, c},
                     {kNobody, kNobody, kNobody},
                     wide_cross(difference(points_[b], points_[a]), difference(points_[c], points_[a]))};
    return face;
  }

  /// Gives each point to the first face, from one on, that it lies above; those below all are in the hull.
  void hand_out(const std::vector<std::uint32_t>& list, std::size_t first) {
    for (const std::uint32_t point : list)
      for (std::size_t i = first; i < faces_.size(); ++i)
        if (height(faces_[i], point) > 0) {
          faces_[i].outside.push_back(point);
          break;
        }
  }

  /// Takes the farthest point above a face into the hull: what it sees goes, and a cone to its horizon comes.
  void reach_out(std::uint32_t start) {
    std::uint32_t apex = faces_[start].outside.front();
    Wide most = height(faces_[start], apex);
    for (const std::uint32_t point : faces_[start].outside) {
      const Wide h = height(faces_[start], point);
      if (h > most || (h == most && points_[point] < points_[apex])) apex = point, most = h;
    }
    PHYSIM_ASSERT(most > 0);
    std::vector<std::uint32_t> seen, above;
    std::vector<Edge> horizon;
    look_around(start, apex, seen, horizon);
    const auto first = static_cast<std::uint32_t>(faces_.size());
    for (const Edge& edge : horizon) {
      PHYSIM_ASSERT(face_from_[edge.from] == kNobody);
      face_from_[edge.from] = static_cast<std::uint32_t>(faces_.size());
      faces_.push_back(make_face(edge.from, edge.to, apex));
    }
    for (std::size_t i = 0; i < horizon.size(); ++i) join(first + static_cast<std::uint32_t>(i), horizon[i]);
    for (const Edge& edge : horizon) face_from_[edge.from] = kNobody;
    for (const std::uint32_t face : seen) {
      faces_[face].alive = false;
      above.insert(above.end(), faces_[face].outside.begin(), faces_[face].outside.end());
      faces_[face].outside = {};
    }
    hand_out(above, first);
  }

  /// The faces that a point sees, and the edges about them.
  void look_around(std::uint32_t start, std::uint32_t apex, std::vector<std::uint32_t>& seen,
                   std::vector<Edge>& horizon) {
    faces_[start].seen = true;
    seen.push_back(start);
    for (std::size_t i = 0; i < seen.size(); ++i)
      for (std::size_t edge = 0; edge < 3; ++edge) {
        const HullTriangle triangle = faces_[seen[i]].triangle;
        const std::uint32_t beyond = triangle.neighbour[edge];
        PHYSIM_ASSERT(faces_[beyond].alive);
        if (faces_[beyond].seen) continue;
        if (height(faces_[beyond], apex) > 0) {
          faces_[beyond].seen = true;
          seen.push_back(beyond);
        } else {
          horizon.push_back({triangle.corner[edge], triangle.corner[(edge + 1) % 3], beyond});
        }
      }
  }

  /// Joins a new face to what lies beyond its edge, and to the new face that follows it about the horizon.
  void join(std::uint32_t face, const Edge& edge) {
    const std::uint32_t next = face_from_[edge.to];
    PHYSIM_ASSERT(next != kNobody);
    faces_[face].triangle.neighbour[0] = edge.beyond;
    faces_[face].triangle.neighbour[1] = next;
    faces_[next].triangle.neighbour[2] = face;
    HullTriangle& beyond = faces_[edge.beyond].triangle;
    for (std::size_t i = 0; i < 3; ++i)
      if (beyond.corner[i] == edge.to && beyond.corner[(i + 1) % 3] == edge.from) beyond.neighbour[i] = face;
  }

  std::span<const GridPoint> points_;
  std::vector<Face> faces_;
  std::vector<std::uint32_t> face_from_;  // new faces by the first corner of their edge
};

}  // namespace

Wide height_above(const HullTriangle& triangle, std::span<const GridPoint> points, const GridPoint& p) {
  return wide_dot(triangle.normal, difference(p, points[triangle.corner[0]]));
}

std::optional<std::vector<HullTriangle>> quickhull(std::span<const GridPoint> points) {
  Quickhull hull(points);
  return hull.build() ? std::optional(hull.triangles()) : std::nullopt;
}

}  // namespace physim::collide
