#include "collide/way_through.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

#include "base/assert.hpp"
#include "base/isa.hpp"
#include "collide/contact_rules.hpp"
#include "collide/path_cast.hpp"
#include "math/vec3.hpp"

namespace physim::collide {
namespace {

/// What passing a surface does to who goes through the body that was hit.
enum class Passed { nothing, in, out, out_from_start };

/// Passes the surfaces of a thing one by one. Where parts of several materials overlap, the first one of them is there;
/// a part is what the surface is made of by which it was entered, as a mesh is.
class BodyPassed {
 public:
  BodyPassed(const Scene& scene, const SceneHit& hit) : has_parts_(scene.parts(hit.instance) > 0), hit_(hit) {}

  Passed pass(const SceneHit& surface) {
    PHYSIM_ASSERT(surface.instance);
    if (surface.instance != hit_.instance) return Passed::nothing;
    const bool was_inside = is_inside();
    const std::uint32_t part = has_parts_ ? surface.primitive : 0;
    const auto entered = std::ranges::find(inside_, part, &Part::number);
    if (surface.entering) {
      inside_.push_back({part, !has_parts_ || surface.material == hit_.material});
    } else if (entered != inside_.end()) {
      inside_.erase(entered);
    } else {
      const bool is_body = !has_parts_ || part == hit_.primitive;
      return is_body && !was_inside ? Passed::out_from_start : Passed::nothing;
    }
    if (was_inside == is_inside()) return Passed::nothing;
    return was_inside ? Passed::out : Passed::in;
  }
  [[nodiscard]] bool is_inside() const {
    const auto first = std::ranges::min_element(inside_, {}, &Part::number);
    return first != inside_.end() && first->is_body;
  }

 private:
  struct Part {
    std::uint32_t number;
    bool is_body;
  };
  bool has_parts_;
  const SceneHit& hit_;
  std::vector<Part> inside_;
};

}  // namespace

std::optional<WayThrough> way_through(const Scene& scene, const SceneFilter& solids, const SceneHit& hit,
                                      const WayIn& in) {
  PHYSIM_ASSERT(std::abs(length(in.direction) - 1) < 1e-6);
  constexpr double kDeepest = 1000;  // [m]
  constexpr double kOne = 1e-9;      // thinner is nothing, and nearer is one [m]
  const WayThrough endless{0, in.touched, -hit.normal};
  if (!hit.entering) return endless;  // the back of a sheet
  const double back = kOne + 8 * spacing_at<double>(in.touched), far = kDeepest + back;
  // Behind that it is another part that is met [m]. From a skin it is farther to the surface where the way is flat.
  const double flat = std::max(-dot(in.direction, hit.normal), 0.02);
  const double latest = 1e-5 + 2 * in.radius + 2 * scene.skin() / flat;
  std::optional<double> begin;
  WayThrough through;
  BodyPassed body(scene, hit);
  const SceneSegment line{in.touched - in.direction * back, in.touched + in.direction * kDeepest, 0, in.time, 0};
  for (const SceneHit& each : scene.all_hits(line, solids)) {
    PHYSIM_ASSERT(each.part >= 0 && each.part <= 1);
    const Passed passed = body.pass(each);
    if (passed == Passed::nothing) continue;
    const double at = std::max(each.part * far - back, 0.0);
    if (passed != Passed::out && !begin && at > latest) return std::nullopt;
    if (passed != Passed::out && begin && at > *begin + through.thickness + kOne) return through;
    if (passed == Passed::out_from_start && begin) continue;
    if (passed == Passed::out_from_start && in.radius > 0)
      return endless;  // a sheet's back that the ball's front passed
    if (!begin) begin = at;
    const Vec3d outwards = each.entering ? -each.normal : each.normal;  // into another part it comes out, too
    if (passed != Passed::in) through = {std::max(at - *begin, kOne), each.position, outwards};
  }
  if (!begin) return std::nullopt;
  PHYSIM_ASSERT(body.is_inside() || through.thickness >= kOne);
  return body.is_inside() ? endless : through;
}

// ------------------------------------------------------------------------------------------- what is passed
namespace {

/// The part of a chord by which its cast goes beyond both ends: places are rounded, and things may move.
PHYSIM_COLD double overhang(const SceneSegment& chord) {
  constexpr double kLeast = 1e-9, kMost = 1e-3;
  const double places = 16 * std::numeric_limits<double>::epsilon() * (length(chord.from) + length(chord.to)) + 1e-12;
  const double part = places / length(chord.to - chord.from);
  return part < kMost ? std::max(part, kLeast) : kMost;  // also where a length is no number
}

/// No surface, but where the point is when its way begins. By which surface it leaves, has the mark too.
bool begins_inside(const SceneHit& hit) { return hit.starts_inside && hit.entering; }

/// Whether a place is inside the body that the surface belongs to. The cast has one fixed direction, so that both
/// chords that end there get the same answer.
PHYSIM_COLD bool is_inside(const Scene& scene, const SceneFilter& filter, const SceneHit& surface, const Vec3d& place,
                           double time) {
  constexpr Vec3d kAside{1e-6, 6e-7, 3e-7};  // [m]
  const auto begins_there = [&](const SceneHit& hit) { return begins_inside(hit) && is_one_body(scene, hit, surface); };
  return std::ranges::any_of(scene.all_hits({place, place + kAside, 0, time, 0}, filter), begins_there);
}

/// Leaves out what lies inside of bodies that have several parts. `one`: surfaces no farther from each other than this
/// part of the way are one.
PHYSIM_COLD void join_parts(const Scene& scene, std::vector<SceneHit>& hits, double one) {
  struct Body {
    int depth = 0;                 // parts that the point is in
    SceneHit* last_out = nullptr;  // the surface by which it left the body last
  };
  constexpr double kInner = -1;           // a part of the way for what is left out
  std::vector<Body> bodies(hits.size());  // by the first of their surfaces
  for (SceneHit& hit : hits) {
    if (scene.parts(hit.instance) == 0) continue;
    std::size_t first = 0;
    while (!is_one_body(scene, hits[first], hit)) ++first;
    Body& body = bodies[first];
    if (begins_inside(hit)) {
      ++body.depth;
    } else if (hit.entering) {
      const bool goes_on = body.depth == 0 && body.last_out != nullptr && hit.part - body.last_out->part <= one;
      if (goes_on) body.last_out->part = kInner, body.last_out = nullptr;
      if (body.depth++ > 0 || goes_on) hit.part = kInner;
    } else if (--body.depth > 0) {
      hit.part = kInner;
    } else {
      body.depth = 0;
      body.last_out = &hit;
    }
  }
  std::erase_if(hits, [](const SceneHit& hit) { return hit.part == kInner; });
}

}  // namespace

PHYSIM_COLD std::vector<SceneHit> passages(const Scene& scene, const SceneFilter& filter, const SceneSegment& chord) {
  const double beyond = overhang(chord), whole = 1 + 2 * beyond;
  PHYSIM_ASSERT(beyond > 0 && beyond < 0.01);
  const Vec3d more = (chord.to - chord.from) * beyond;
  std::vector<SceneHit> hits = scene.all_hits(
      {chord.from - more, chord.to + more, 0, chord.time - chord.duration * beyond, chord.duration * whole}, filter);
  if (hits.empty()) return hits;
  join_parts(scene, hits, beyond);
  std::erase_if(hits, [&](SceneHit& hit) {
    if (begins_inside(hit)) return true;
    const double part = hit.part * whole - beyond;
    hit.part = std::clamp(part, 0.0, 1.0);
    // What lies on an end belongs to the chord before it if the place is behind the surface, and else to the next one.
    const bool at_start = part<0.5 * beyond, at_end = part> 1 - 0.5 * beyond;
    if (!at_start && !at_end) return false;
    const Vec3d& place = at_start ? chord.from : chord.to;
    const double time = at_start ? chord.time : chord.time + chord.duration;
    const bool is_behind = is_inside(scene, filter, hit, place, time) == hit.entering;
    return at_start ? is_behind : !is_behind;
  });
  return hits;
}

PHYSIM_COLD void each_passage(const Scene& scene, const SceneFilter& filter, const PassagesOfPath& of,
                              const PathTime& time, double end) {
  PHYSIM_ASSERT(end >= 0 && end <= 1);
  constexpr double kAside = 1e-6;  // [m]
  constexpr double kMostChords = 64;
  const double chords = std::clamp(std::ceil(end * std::sqrt(bend_of(of) / (8 * kAside))), 1.0, kMostChords);
  Vec3d from = of(0.0);
  for (double i = 0; i < chords; ++i) {
    const double begin = end * (i / chords);
    const double to = i + 1 == chords ? end : end * ((i + 1) / chords);
    const Vec3d there = of(to);
    for (const SceneHit& hit : passages(scene, filter, time.chord(from, there, 0, begin, to)))
      of.tell(of.both, begin + hit.part * (to - begin), hit);
    from = there;
  }
}

}  // namespace physim::collide
