// Casts beside a reference that is other code: signed distances in long double, without a tree.
#include <cstdio>

#include "collide/reference.hpp"
#include "collide/scene_support.hpp"
#include "hits/hits.hpp"

namespace physim::test {
namespace {

constexpr int kMostTold = 20;

/// Outwards, by differences of a distance; nothing where it has an edge.
std::optional<Point> normal_of(const SignedDistance& distance, const Point& p) {
  const auto gradient = [&](Real h) {
    return Point{distance({p.x + h, p.y, p.z}) - distance({p.x - h, p.y, p.z}),
                 distance({p.x, p.y + h, p.z}) - distance({p.x, p.y - h, p.z}),
                 distance({p.x, p.y, p.z + h}) - distance({p.x, p.y, p.z - h})} *
           (1 / (2 * h));
  };
  const Point fine = gradient(1e-6L), coarse = gradient(1e-4L);
  if (norm(fine - coarse) > 1e-6L || std::fabs(norm(fine) - 1) > 1e-10L) return std::nullopt;
  return fine;
}

/// Corners, edges, middles of sides and poles: a random one of the places where a body of such half extents has them.
Vec3d odd_place(Random& r, const Vec3d& half) {
  const auto one_of = [&](double h) { return r.one_in(4) ? r.in(-h, h) : h * (r.below(3) - 1); };
  return {one_of(half.x), one_of(half.y), one_of(half.z)};
}

struct Casts {
  const char* name;
  Vec3d half;  // of the body
  SignedDistance distance;
  double curvature;  // the largest of its surface [1/m]
  Scene scene;
  Transform at;
  long wrong = 0, normals = 0;

  void tell(long i, const std::string& what) {
    if (++wrong <= kMostTold) std::printf("%s, cast %ld: %s\n", name, i, what.c_str());
  }

  /// Anywhere, through an odd place of the body, or along an edge of it.
  SceneSegment segment(Random& r) const {
    SceneSegment s = random_segment(r, at.position, at.scale);
    const int way = r.below(4);
    if (way < 2) return s;
    const auto in_world = [&](const Vec3d& p) { return at.position + rotate(normalized(at.rotation), p) * at.scale; };
    const Vec3d one = in_world(odd_place(r, half));
    if (way == 3) s.from = in_world(odd_place(r, half));
    s.to = s.from + (one - s.from) * r.in(0.9, 2);
    if (way == 3) s.from = s.from + (s.from - one) * r.in(0, 1);
    return s;
  }
  void cast(Random& r, long i) {
    SceneSegment s = segment(r);
    if (r.one_in(2)) s.radius = r.in(0.01, 1);
    const Point from = into_frame(at, point(s.from)), along = into_frame(at, point(s.to)) - from;
    const auto gap = [&](Real t) { return distance(from + along * t) * Real(at.scale) - Real(s.radius); };
    const Met met = first_zero(gap, norm(along) * Real(at.scale));
    const SceneHit hit = scene.first_hit(s);
    if (const std::string what = unlike(hit, s, met, gap); !what.empty()) return tell(i, what);
    if (scene.any_hit(s) != static_cast<bool>(hit)) return tell(i, "first_hit() and any_hit() are at odds");
    if (!hit || !met.hit || hit.starts_inside) return;
    const auto normal = normal_of(distance, from + along * Real(hit.part));
    if (!normal) return;
    ++normals;
    const Vec3d own = rotate(conjugate(normalized(at.rotation)), hit.normal);
    // Where the place is off by rounding, the normal of what is curved is off by so much times the curvature.
    const double bound =
        1e-9 + 1e-15 * largest(s) * curvature / at.scale / std::max(1e-6, std::fabs(double(met.slope)));
    const double off = std::min(static_cast<double>(norm(point(own) - *normal)),
                                s.radius == 0 ? static_cast<double>(norm(point(own) + *normal)) : 1.0);
    if (off > bound) tell(i, "its normal is off by " + std::to_string(off));
  }
};

template <class Shape>
long wrong_casts_of(const char* name, const Shape& shape, const Vec3d& half, double curvature, long count, long seed) {
  long wrong = 0;
  for (const double far : {0.0, 10.0, 1e6}) {
    Random r(static_cast<std::uint64_t>(seed) + static_cast<std::uint64_t>(far));
    Casts casts{name, half, distance_of(shape), curvature, {}, far == 0 ? Transform{} : random_transform(r, far)};
    const auto added = casts.scene.add_shape(shape);
    if (!added || !casts.scene.add({.shape = *added, .transform = casts.at})) return std::puts("no scene"), 1;
    for (long i = 0; i < count; ++i) casts.cast(r, i);
    std::printf("%-8s up to %7.0f m: %ld casts, %ld normals compared, %ld wrong\n", name, far, count, casts.normals,
                casts.wrong);
    wrong += casts.wrong;
  }
  return wrong;
}

/// Out of a closed body there is no way that meets nothing: through faces, edges and vertices.
long leaks(long rays, long seed) {
  Random r(static_cast<std::uint64_t>(seed));
  const MeshShape mesh = ball(10, 0.1);
  long wrong = 0;
  for (const double far : {0.0, 1e6}) {
    Scene scene;
    const Vec3d middle{far, -far, 0.5 * far};
    if (!scene.add({.shape = scene.add_shape(mesh).value(), .transform = {.position = middle}})) return 1;
    for (long i = 0; i < rays / 2; ++i) {
      const Vec3d from = middle + random_vector(r, 0.3);
      const auto& t = mesh.triangles[static_cast<std::size_t>(r.below(static_cast<int>(mesh.triangles.size())))];
      const Vec3d a = middle + mesh.vertices[t[0]], b = middle + mesh.vertices[t[1]];
      const Vec3d aim = i % 3 == 0 ? a : i % 3 == 1 ? a + (b - a) * r.unit() : middle + random_vector(r, 3);
      const Vec3d to = from + (aim - from) * (5 / std::max(1e-3, length(aim - from)));
      const SceneHit hit = scene.first_hit({from, to});
      if (hit && !hit.entering) continue;
      if (++wrong <= kMostTold) std::printf("a closed mesh leaks ray %ld at %g m\n", i, far);
    }
  }
  std::printf("closed meshes: %ld rays from inside, %ld wrong\n", rays, wrong);
  return wrong;
}

}  // namespace

long wrong_casts(long count, long seed) {
  long wrong = wrong_casts_of("sphere", SphereShape{0.8}, {0.8, 0.8, 0.8}, 1 / 0.8, count, seed);
  wrong += wrong_casts_of("capsule", CapsuleShape{0.3, 0.9}, {0.3, 0.9, 0.3}, 1 / 0.3, count, seed);
  wrong += wrong_casts_of("box", BoxShape{{0.2, 0.5, 1.1}}, {0.2, 0.5, 1.1}, 0, count, seed);
  wrong += wrong_casts_of("sheet", BoxShape{{1, 0.0005, 1}}, {1, 0.0005, 1}, 0, count, seed);
  wrong += wrong_casts_of("cylinder", CylinderShape{0.6, 0.4}, {0.6, 0.4, 0.6}, 1 / 0.6, count, seed);
  wrong += wrong_casts_of("plane", PlaneShape{}, {1, 0, 1}, 0, count, seed);
  return wrong + leaks(100 * count, seed);
}

}  // namespace physim::test
