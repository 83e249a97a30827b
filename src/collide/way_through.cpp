#include "collide/way_through.hpp"

#include <algorithm>
#include <cmath>
#include <vector>

#include "base/assert.hpp"
#include "collide/path_cast.hpp"

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

}  // namespace physim::collide
