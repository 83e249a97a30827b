// Compiled once per instruction set, in a namespace of its name.
#include "collide/box_job.hpp"
#include "collide/triangle.hpp"

PHYSIM_ISA_BEGIN

namespace {

using Words = Pack<std::uint32_t, 8>;

/// Writes eight words, those of some lanes first, in order. Returns how many these are.
PHYSIM_INLINE std::size_t put_first(const std::uint32_t* from, unsigned lanes, std::uint32_t* to) {
#if defined(__AVX512VL__)
  _mm256_storeu_si256((__m256i*)to,
                      _mm256_maskz_compress_epi32((__mmask8)lanes, _mm256_load_si256((const __m256i*)from)));
  return static_cast<std::size_t>(std::popcount(lanes));
#elif defined(__AVX2__) && defined(__BMI2__)
  const std::uint64_t bytes = _pdep_u64(lanes, 0x0101010101010101u) * 0xffu;  // of the lanes
  const __m128i places = _mm_cvtsi64_si128((long long)_pext_u64(0x0706050403020100u, bytes));
  _mm256_storeu_si256(
      (__m256i*)to, _mm256_permutevar8x32_epi32(_mm256_load_si256((const __m256i*)from), _mm256_cvtepu8_epi32(places)));
  return static_cast<std::size_t>(std::popcount(lanes));
#else
  std::size_t count = 0;
  for (unsigned lane = 0; lane < 8; ++lane) {
    to[count] = from[lane];
    count += lanes >> lane & 1u;
  }
  return count;
#endif
}
/// Adds pairs of a ray and some of the children of a node.
PHYSIM_INLINE void add(collide::BoxPairs& pairs, std::uint32_t ray, const std::uint32_t* children, unsigned lanes) {
  Words(ray).store(pairs.ray + pairs.count);
  pairs.count += put_first(children, lanes, pairs.child + pairs.count);
}

using Four = Pack<double, 4>;

/// A corner of four triangles.
PHYSIM_INLINE std::array<Four, 3> corners_of(const collide::MeshRay& ray, const std::uint32_t (&place)[4],
                                             std::size_t corner) {
  const Vec3d* at[4];
  for (std::size_t lane = 0; lane < 4; ++lane) at[lane] = &ray.vertices[ray.corners[place[lane]][corner]];
  const auto along = [&](double Vec3d::*axis) PHYSIM_INLINE_LAMBDA {
    return collide::four<Four>(at[0]->*axis, at[1]->*axis, at[2]->*axis, at[3]->*axis);
  };
  return {along(&Vec3d::x), along(&Vec3d::y), along(&Vec3d::z)};
}

/// The triangles of a child; where they are fewer than four the last one comes again.
struct FourPlaces {
  std::uint32_t place[4];
  unsigned lanes;  // a bit for each of them

  PHYSIM_INLINE explicit FourPlaces(const collide::BvhChild& child) {
    const std::uint32_t first = child.first(), last = child.end() - 1;
    for (std::uint32_t lane = 0; lane < 4; ++lane) place[lane] = min(first + lane, last);
    lanes = (2u << (last - first)) - 1;
  }
};

}  // namespace

void enter_boxes(collide::BoxJob& job) {
  constexpr std::size_t kAhead = 8;
  const collide::BoxPairs from = job.from;
  collide::BoxPairs nodes = job.nodes, items = job.items;
  for (std::size_t i = 0; i < from.count; ++i) {
    const std::size_t ahead = i + kAhead < from.count ? i + kAhead : i;
    job.rays[from.ray[ahead]].nodes[from.child[ahead]].prefetch();
    const std::uint32_t number = from.ray[i];
    const collide::TreeRay& ray = job.rays[number];
    const collide::BvhNode& node = ray.nodes[from.child[i]];
    collide::Octet in;
    const unsigned lanes = ray.enters(node, in);
    const unsigned with_items = lane_bits((Words::load(node.child) & Words(collide::BvhChild::kItems)) != Words(0));
    add(nodes, number, node.child, lanes & ~with_items);
    add(items, number, node.child, lanes & with_items);
  }
  job.nodes.count = nodes.count;
  job.items.count = items.count;
}

void pass_triangles(collide::TriangleJob& job) {
  std::size_t count = 0;
  for (std::size_t i = 0; i < job.items.count; ++i) {
    const collide::BvhChild child(job.items.child[i]);
    const collide::MeshRay& ray = job.rays[job.items.ray[i]];
    const FourPlaces of(child);
    const collide::Shear shear(ray.segment);
    Four t;
    const auto passed =
        shear.passes(shear.turned(corners_of(ray, of.place, 0)), shear.turned(corners_of(ray, of.place, 1)),
                     shear.turned(corners_of(ray, of.place, 2)), t);
    unsigned lanes = lane_bits(passed & (t >= Four(0.0)) & (t <= Four(1.0)));
    lanes &= shear.is_some() ? of.lanes : 0;
    double at[4];
    t.store(at);
    for (std::uint32_t lane = 0; lane < 4; ++lane) {
      job.passed[count] = {at[lane], job.items.ray[i], child.first() + lane};
      count += lanes >> lane & 1u;
    }
  }
  job.count = count;
}

void clear_triangles(const collide::ClearJob& job) {
  for (std::size_t i = 0; i < job.items.count; ++i) {
    collide::MeshRay& ray = job.rays[job.items.ray[i]];
    const FourPlaces of(collide::BvhChild(job.items.child[i]));
    const auto corner = [&](std::size_t which) PHYSIM_INLINE_LAMBDA {
      const std::array<Four, 3> at = corners_of(ray, of.place, which);
      return Vec3<Four>{at[0], at[1], at[2]};
    };
    Four part(0.0);
    const auto touched = collide::may_touch(ray.segment, corner(0), corner(1), corner(2), part);
    if (!any(touched)) continue;
    double reach[4];
    select(touched, part, Four(ray.segment.reach)).store(reach);
    for (const double each : reach) ray.segment.reach = min(ray.segment.reach, each);
  }
}

PHYSIM_ISA_END
