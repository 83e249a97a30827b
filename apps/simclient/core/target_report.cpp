#include "simclient/core/target_report.hpp"

#include <algorithm>
#include <cmath>

#include "base/assert.hpp"
#include "base/text.hpp"
#include "math/angles.hpp"
#include "physim/solve.hpp"
#include "simclient/core/length_text.hpp"
#include "simclient/core/scenery.hpp"

namespace physim::client {
namespace {

/// "4 cm left, 2 cm high"; parts that are much smaller than the other are left out.
std::string offset_text(double right, double up) {
  constexpr double kSmall = 0.05;
  const double most = std::max(std::abs(right), std::abs(up));
  std::string text;
  if (std::abs(right) > kSmall * most) text = length_text(std::abs(right)) + (right > 0 ? " right" : " left");
  if (std::abs(up) > kSmall * most)
    text += (text.empty() ? "" : ", ") + length_text(std::abs(up)) + (up > 0 ? " high" : " low");
  return text;
}

/// ": aim 0.30° higher, 0.1° to the left".
std::string text_of(const AimChange& change) {
  constexpr double kLeast = 0.005;  // [deg]
  if (!change.is_in_reach) return ": out of reach at this speed";
  const double higher = change.up / kDegree, to_the_right = change.right / kDegree;
  std::string text;
  if (std::abs(higher) >= kLeast) text = formatted("%.2g\u00b0 ", std::abs(higher)) + (higher > 0 ? "higher" : "lower");
  if (std::abs(to_the_right) >= kLeast)
    text += (text.empty() ? "" : ", ") + formatted("%.2g\u00b0 to the ", std::abs(to_the_right)) +
            (to_the_right > 0 ? "right" : "left");
  return text.empty() ? "" : ": aim " + text;
}

struct Axes {
  Vec3d right, up;
};
/// The axes of a plane that is seen along a way.
Axes axes_of(const Vec3d& normal, const Vec3d& way) {
  const Vec3d along = dot(normal, way) < 0 ? -normal : normal;
  const Vec3d above = std::abs(along.y) < 0.9 ? Vec3d{0, 1, 0} : Vec3d{way.x, 0, way.z};
  const Vec3d right = normalized(cross(along, above));
  return {right, cross(right, along)};
}

}  // namespace

std::vector<TargetDisc> targets_of(const Scenario& scenario) {
  std::vector<TargetDisc> targets;
  for (const ScenarioThing& thing : scenario.things) {
    const auto shape = std::ranges::find(scenario.shapes, thing.shape, &ScenarioShape::name);
    if (shape == scenario.shapes.end() || !thing.keys.empty() || thing.velocity != Vec3d{}) continue;
    const auto* disc = std::get_if<CylinderShape>(&shape->shape);
    if (disc == nullptr || !(disc->half_height < kFlatDisc * disc->radius)) continue;
    const Vec3d normal = rotate(thing.rotation.quaternion(), Vec3d{0, 1, 0});
    targets.push_back({thing.name, thing.position, normal, disc->radius * thing.scale});
  }
  return targets;
}

std::string TargetReport::text(double radius) const {
  PHYSIM_ASSERT(radius > 0);
  constexpr double kMiddle = 0.02;  // of the radius
  if (short_by > 0) return length_text(short_by) + " short" + (change ? text_of(*change) : "");
  const double away = std::hypot(right, up);
  if (has_hit && away < kMiddle * radius) return "hit, in the middle";
  if (has_hit) return "hit, " + offset_text(right, up) + " of the middle";
  return "missed by " + length_text(std::max(away - radius, 0.0)) +
         text_of(change.value_or(AimChange{true, -std::atan2(up, distance), -std::atan2(right, distance)}));
}

std::optional<AimChange> aim_change(const TargetDisc& target, const Session& session, const Track& track) {
  if (!track.shot || !(length(target.middle - track.samples.front().position) > 0)) return std::nullopt;
  const Vec3d way = track.samples.front().velocity;
  const double speed = length(way);
  Launch launch = track.shot->launch;
  if (speed > 0) {
    launch.velocity.reset();
    launch.speed = speed, launch.elevation = std::asin(way.y / speed), launch.azimuth = std::atan2(way.z, way.x);
  }
  AimOptions options;
  options.tolerance = std::max(0.05 * target.radius, options.tolerance);
  options.ground = session.ground();
  options.flight = session.scenario().tolerance;
  if (!session.scenario().world.given && options.flight.step == 0) options.flight.step = session.step_length();
  const ProjectileDef& projectile = track.shot->projectile;
  const Result<Aim> found = aim(projectile, launch, session.scenario().environment, projectile.fidelity,
                                {.position = target.middle}, options);
  if (!found) return std::nullopt;
  if (!found->in_reach()) return AimChange{.is_in_reach = false};
  std::optional<AimChange> best;
  for (const auto& solution : {found->low, found->high}) {
    if (!solution) continue;
    const AimChange change{true, solution->launch.elevation - launch.elevation,
                           std::remainder(solution->launch.azimuth - launch.azimuth, 2 * kPi)};
    if (!best || std::abs(change.up) < std::abs(best->up)) best = change;
  }
  return best;
}

std::optional<TargetReport> report_of(const TargetDisc& target, const Session& session, const Track& track) {
  const Vec3d from = track.samples.front().position, way = target.middle - from;
  const Axes axes = axes_of(target.normal, way);
  TargetReport report;
  report.distance = length(way);
  const auto take = [&](const Vec3d& at) {
    report.right = dot(at - target.middle, axes.right), report.up = dot(at - target.middle, axes.up);
    return report;
  };
  for (const Hit& hit : session.hits().hits())
    if (hit.id == track.id && hit.thing == target.name && !is_passed(hit)) {
      report.has_hit = true;
      return take(hit.position);
    }
  const auto ahead = [&](const TrackSample& s) { return dot(s.position - target.middle, target.normal); };
  for (std::size_t i = 1; i < track.samples.size(); ++i) {
    const double a = ahead(track.samples[i - 1]), b = ahead(track.samples[i]);
    if (a == b || (a < 0) == (b < 0)) continue;
    return take(between(track.samples[i - 1], track.samples[i], a / (a - b)).position);
  }
  const bool is_over = !track.is_flying() || length(track.samples.back().velocity) == 0;
  if (!is_over) return std::nullopt;
  report.short_by = std::abs(ahead(track.samples.back()));
  return report;
}

}  // namespace physim::client
