// Target report: how far a shot was from the middle of a target, in words, and what to aim at instead.
#pragma once

#include <optional>
#include <span>
#include <string>

#include "simclient/core/session.hpp"

namespace physim::client {

/// A round target: a flat disc.
struct TargetDisc {
  std::string name;
  Vec3d middle, normal;  // of length one
  double radius = 0;     // [m]
};

/// The targets among the things of a scenario that stand still: flat cylinders.
[[nodiscard]] std::vector<TargetDisc> targets_of(const Scenario& scenario);

/// The change of aim by which a shot hits the middle of a target.
struct AimChange {
  bool is_in_reach = true;   // else nothing does, at its speed
  double up = 0, right = 0;  // of the barrel [rad]
};
/// Found by flying the shot alone; nothing where that cannot be done. Of two ways to the target, the one nearer to the
/// aim that it had.
[[nodiscard]] std::optional<AimChange> aim_change(const TargetDisc& target, const Session& session, const Track& track);

/// The place where a path meets the plane of a target, seen from the launch.
struct TargetReport {
  bool has_hit = false;
  double right = 0, up = 0;  // of the middle [m]
  double short_by = 0;       // > 0: it ended so long before the plane [m]
  double distance = 0;       // of the target from the launch [m]
  std::optional<AimChange> change{};

  /// "hit, 4 cm left of the middle", "missed by 1.2 m: aim 0.3° higher", "12 m short: out of reach at this speed".
  [[nodiscard]] std::string text(double radius) const;
};
/// Nothing as long as it flies towards the target.
[[nodiscard]] std::optional<TargetReport> report_of(const TargetDisc& target, const Session& session,
                                                    const Track& track);

}  // namespace physim::client
