#include "collide/tube_casts.hpp"

#include "collide/cast.hpp"
#include "collide/path_cast.hpp"
#include "collide/scene_by_motion.hpp"

namespace physim::collide {
namespace {

/// Calls visit(triangle, number) for the triangles of a shape that a segment may meet, until its reach is below 0.
/// False: it is not made of triangles.
template <class Visit>
bool triangles_along(const Shape& shape, Segment& s, const Visit& visit) {
  if (const auto* mesh = std::get_if<Mesh>(&shape)) return mesh->triangles_along(s, visit), true;
  if (const auto* field = std::get_if<HeightField>(&shape)) return field->triangles_along(s, visit), true;
  return false;
}

}  // namespace

TubeCasts::Near TubeCasts::near(const Triangle& triangle, std::uint32_t number) {
  constexpr double kNarrow = 1e-5;  // from there on rounding does not turn the normal by more than is allowed for
  const Vec3d ab = triangle.b - triangle.a, ac = triangle.c - triangle.a, across = cross(ab, ac);
  const double size = length(across);
  const bool is_wide = size > kNarrow * length(ab) * length(ac);
  return {triangle, is_wide ? across * (1 / size) : Vec3d{}, number};
}

namespace {

/// Whether a shape is a half-space that no sphere about a segment comes to.
bool is_below(const Shape& shape, const Segment& s) {
  const double least = std::min(s.from.y, s.from.y + s.along.y);
  return std::holds_alternative<HalfSpace>(shape) && least > s.radius + 1e-9 * s.extent();
}

}  // namespace

/// Adds a thing with what of it is near; false where that is too much.
bool TubeCasts::add(std::uint32_t index, const Segment& inside) {
  const Shape& shape = *SceneByMotion(*scene_).content().instances[index].shape;
  if (is_below(shape, inside)) return true;
  if (things_ == kMostThings) return false;
  Thing& thing = (*thing_)[things_];
  thing = {index, triangles_, triangles_, false};
  bool fits = true;
  Segment tube = inside;
  thing.is_whole = !triangles_along(shape, tube, [&](const Triangle& triangle, std::uint32_t number) {
    if (!fits) return;
    const Near one = near(triangle, number);
    if (one.is_apart(inside)) return;
    fits = triangles_ < kMostTriangles;
    if (fits)
      (*near_)[triangles_++] = one;
    else
      tube.reach = -1;
  });
  thing.end = triangles_;
  if (thing.is_whole || thing.begin < thing.end) ++things_;
  return fits;
}

bool TubeCasts::find(const SceneSegment& tube) {
  PHYSIM_ASSERT(scene_ != nullptr);
  const SceneContent& content = SceneByMotion(*scene_).content();
  found_ = false;
  if (content.engine || content.one_ways > 0 || !is_sound(tube)) return true;
  tube_ = tube;
  along_ = tube.to - tube.from;
  const double square = dot(along_, along_);
  per_square_along_ = square > 1e-200 ? 1 / square : 0;
  some_move_ = content.in_motion > 0;
  things_ = triangles_ = 0;
  Segment segment{tube.from, along_, tube.radius, 1};
  segment.radius += 1e-12 * segment.extent();  // what casts inside of it are rounded to
  bool fits = true;
  const auto look_at = [&](std::uint32_t index, Segment& s) {
    const SceneContent::InstanceSlot& slot = content.instances[index];
    if (!fits || !slot.is_asked(filter_)) return;
    fits = add(index, slot.placement.inside(segment));
    if (!fits) s.reach = -1;
  };
  const auto look_at_mover = [&](std::uint32_t index, Segment& s) {
    if (!content.instances[index].is_asked(filter_)) return;
    fits = false;  // it is asked where it is by the time
    s.reach = -1;
  };
  things_along(content, Which::all, segment, tube.time, tube.time + tube.duration, look_at, look_at_mover);
  found_ = fits;
  return !fits || things_ > 0;
}

bool TubeCasts::holds(const Vec3d& p, double radius) const {
  const Vec3d off = p - tube_.from;
  const double part = std::clamp(dot(off, along_) * per_square_along_, 0.0, 1.0);
  const double room = tube_.radius - radius;
  return room >= 0 && length_squared(off - along_ * part) <= room * room;
}

bool TubeCasts::holds(const SceneSegment& asked) const {
  const bool is_then =
      !some_move_ || (asked.time >= tube_.time && asked.time + asked.duration <= tube_.time + tube_.duration);
  return is_then && holds(asked.from, asked.radius) && holds(asked.to, asked.radius);
}

SceneHit TubeCasts::first_hit(const SceneSegment& asked, bool is_wider) const {
  if (!found_ || !is_sound(asked) || !holds(asked)) {
    SceneFilter filter = filter_;
    filter.from_front = filter.from_front && !is_wider;
    return scene_->first_hit(asked, filter);
  }
  PHYSIM_ASSERT(things_ <= kMostThings && triangles_ <= kMostTriangles);
  const SceneContent& content = SceneByMotion(*scene_).content();
  Segment segment{asked.from, asked.to - asked.from, asked.radius, 1};
  FirstCrossing first;
  for (std::uint32_t i = 0; i < things_; ++i) {
    const Thing& thing = (*thing_)[i];
    const SceneContent::InstanceSlot& slot = content.instances[thing.index];
    Segment inside = slot.placement.inside(segment);
    const auto take = [&](const Crossing& crossing, Segment& within) {
      first.take(thing.index, crossing, segment);
      within.reach = segment.reach;
    };
    if (thing.is_whole) {
      cross<false>(*slot.shape, inside, take);
      continue;
    }
    std::optional<Shear> shear;
    for (std::uint32_t k = thing.begin; k < thing.end; ++k) {
      const Near& near = (*near_)[k];
      if (near.is_apart(inside)) continue;
      if (!shear) shear.emplace(inside);
      auto crossing = meets(inside, *shear, near.triangle);
      if (!crossing) continue;
      crossing->primitive = near.number;
      take(*crossing, inside);
    }
  }
  return first.thing != 0 ? hit_of(content, first.thing, first.crossing, asked) : SceneHit{};
}

// ------------------------------------------------------------------------------------------- paths
double bend_of(const PathPlaces& path) {
  constexpr int kPlaces = 5;
  constexpr double kWidth = 1.0 / (kPlaces - 1);
  Vec3d x[kPlaces];
  for (int i = 0; i < kPlaces; ++i) x[i] = path(i * kWidth);
  Vec3d bend[kPlaces - 2];
  double most = 0, change = 0;
  for (int i = 0; i < kPlaces - 2; ++i) {
    bend[i] = (x[i] - x[i + 1] * 2.0 + x[i + 2]) * (1 / (kWidth * kWidth));
    most = std::max(most, length(bend[i]));
    if (i > 0) change = std::max(change, length(bend[i] - bend[i - 1]));
  }
  return 1.25 * (most + change);
}

std::optional<PathHit> first_meeting(TubeCasts& casts, double radius, const PathPlaces& path, const PathTime& time,
                                     double end, double rounding) {
  PHYSIM_ASSERT(end >= 0 && end <= 1 && radius >= 0 && rounding >= 0);
  constexpr int kMostCasts = 1000;
  const double bend = bend_of(path);
  const Scene& scene = casts.scene();
  Vec3d from = path(0.0);
  const Vec3d last = path(end);
  // Places have sixteen digits; a tenth of a nanometre is nothing, and half of a skin.
  const double fine = std::max({1e-10, 4e-16 * length(from), 0.5 * scene.skin(), rounding});
  // Engines need not tell what a sphere touches where it starts: theirs are no larger than what flies.
  const bool asks_engine = scene.skin() > 0;
  const double widest = asks_engine && bend > 0 ? std::max(std::sqrt(8 * fine / bend), 1.0 / kMostCasts) : 1;
  // The path is within `off` of its chord, and so is each chord that is cast.
  const double off = 0.125 * bend * end * end + rounding + fine;
  if (!casts.find(time.chord(from, last, radius + 2 * off, 0, end))) return std::nullopt;
  double at = 0, width = end;
  for (int cast = 0; at < end; ++cast) {
    width = std::min({width, end - at, widest});
    const double to = width == end - at ? end : at + width;
    const Vec3d there = to == end ? last : path(to);
    const double delta = 0.125 * bend * width * width;
    const bool is_fine = asks_engine || delta <= fine || cast >= kMostCasts;
    const double wide = is_fine ? radius : radius + delta + rounding;
    const SceneHit hit = casts.first_hit(time.chord(from, there, wide, at, to), !is_fine);
    if (!hit) {
      at = to;
      from = there;
      width *= 2;
      continue;
    }
    const double met = at + hit.part * (to - at);
    if (is_fine) return PathHit{std::min(met, end), hit};
    // The gap that is left is about 2 delta: as long as it takes to close it, and a quarter at most.
    const Vec3d towards = (there - from) - hit.velocity * ((to - at) * time.span);
    const double closing = std::abs(dot(hit.normal, towards)) / (to - at);
    if (met > at) {
      at = met;
      from = path(at);
    }
    width = std::min(0.25 * width, closing > 0 ? 4 * delta / closing : width);
    width = std::max(width, std::sqrt(8 * 0.5 * fine / bend));
  }
  return std::nullopt;
}

}  // namespace physim::collide
