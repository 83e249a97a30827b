#include "flight/ways.hpp"

#include "base/assert.hpp"
#include "base/ieee_mode.hpp"
#include "base/text.hpp"
#include "math/angles.hpp"
#include "math/vec3.hpp"
#include "physim/scene.hpp"

namespace physim {
namespace {

/// Flies ways to a target through a scene.
class Ways {
 public:
  Ways(const ProjectileDef& projectile, const Environment& environment, const Fidelity& fidelity, const Target& target,
       const AimOptions& options, Aim& answer)
      : projectile_(projectile),
        environment_(environment),
        fidelity_(fidelity),
        target_(target),
        options_(options),
        answer_(answer) {
    PHYSIM_ASSERT(options.scene != nullptr);
  }

  Status keep_open() {
    const bool same = answer_.low && answer_.high && answer_.low->time == answer_.high->time;
    answer_.sight_ends = end_of_sight(answer_.nearest);
    if (Status status = look_at(answer_.low); !status) return status;
    if (same && !answer_.low) return answer_.high.reset(), Status();
    return same ? Status() : look_at(answer_.high);
  }

 private:
  /// What is met next to the target is the target, or what it stands on.
  [[nodiscard]] bool is_target(InstanceId thing, const Vec3d& place, double time) const {
    if (options_.target_thing && thing == options_.target_thing) return true;
    return length(place - target_.at(time)) <= options_.tolerance + options_.contact.collision.radius;
  }

  /// Leaves it, where it gets there.
  Status look_at(std::optional<AimSolution>& way) {
    if (!way) return {};
    Until until{.ground = std::nullopt, .time = way->time};
    until.scene = options_.scene;
    until.contact = options_.contact;
    until.contact.collision.on_hit = OnHit::stop;
    const Flight flight = fly(projectile_, way->launch, environment_, fidelity_, options_.flight, until);
    if (flight.error()) return *flight.error();
    ++answer_.flights;
    if (flight.outcome() != Outcome::hit) return {};
    PHYSIM_ASSERT(!flight.events().empty());
    const Event& hit = flight.events().back();
    if (is_target(hit.instance, hit.position, hit.time)) return {};
    answer_.blocked.push_back({*way, hit});
    way.reset();
    return {};
  }

  /// Where the straight line to the target ends before it.
  [[nodiscard]] std::optional<Event> end_of_sight(const AimSolution& way) const {
    const double now = options_.contact.scene_time;
    const SceneFilter solids{.layers = options_.contact.collision.layers, .sensors = false};
    const SceneHit hit = options_.scene->first_hit({way.launch.position, target_.position, 0, now, 0}, solids);
    if (!hit || is_target(hit.instance, hit.position, 0)) return std::nullopt;
    return Event{.kind = EventKind::hit,
                 .position = hit.position,
                 .normal = hit.normal,
                 .instance = hit.instance,
                 .primitive = hit.primitive,
                 .material = hit.material};
  }

  const ProjectileDef& projectile_;
  const Environment& environment_;
  const Fidelity& fidelity_;
  const Target& target_;
  const AimOptions& options_;
  Aim& answer_;
};

std::string degrees(double angle) { return rounded_text(angle * (90 / kRightAngle)) + " deg"; }
std::string text_of(const AimSolution& s) {
  return "elevation " + degrees(s.launch.elevation) + ", hit after " + rounded_text(s.time) + " s";
}

}  // namespace

Status keep_open_ways(const ProjectileDef& projectile, const Environment& environment, const Fidelity& fidelity,
                      const Target& target, const AimOptions& options, Aim& answer) {
  if (options.scene == nullptr) return {};
  return Ways(projectile, environment, fidelity, target, options, answer).keep_open();
}

std::string Aim::explanation() const {
  const IeeeMode mode;
  std::string text;
  if (low && high && low->time != high->time)
    text = "low: " + text_of(*low) + "; high: " + text_of(*high);
  else if (low || high)
    text = text_of(low ? *low : *high);
  else if (blocked.empty() && nearest.time == 0)
    text = "out of reach: no path comes nearer than the muzzle, " + length_text(nearest.miss) + " from the target";
  else if (blocked.empty())
    text = (behind_ground ? "behind the ground" : "out of reach") +
           (": the nearest path passes " + length_text(nearest.miss) + " from the target");
  for (const BlockedWay& way : blocked)
    text += (text.empty() ? "" : "; ") + ("blocked at elevation " + degrees(way.solution.launch.elevation)) +
            ": hits " + length_text(length(way.hit.position - way.solution.launch.position)) + " away, after " +
            rounded_text(way.hit.time) + " s";
  return text;
}

}  // namespace physim
