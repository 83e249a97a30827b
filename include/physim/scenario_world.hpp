// What a scenario with a [world] says beside its shots: the world, volleys and forces. Part of physim_scenario.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "physim/forces.hpp"
#include "physim/infinity.hpp"
#include "physim/world_def.hpp"

namespace physim {

/// The [world] of a scenario.
struct ScenarioWorld {
  bool given = false;            ///< the file has a [world]: its shots fly there instead of one by one [-]
  WorldDef def{};                ///< its environment and tolerance are those of the scenario [-]
  double duration = 10;          ///< of the run [s]
  std::optional<double> wall{};  ///< distance downrange of a wall that stops what reaches it; none: no wall [m]
  Vec3d observer{};              ///< of WorldDef::detail distances [m]
};

/// How the numbers of a spread are meant.
enum class SpreadShape {
  normal,   ///< they are standard deviations
  uniform,  ///< they are bounds, reached evenly (angles: within the ellipse)
};

/// How the launches of a volley scatter.
struct Spread {
  SpreadShape shape = SpreadShape::normal;  ///< [-]
  double horizontal = 0;                    ///< of the direction, to both sides [rad]
  double vertical = 0;                      ///< of the direction, up and down [rad]
  double speed = 0;                         ///< [m/s]
  Vec3d position{};                         ///< of the muzzle, by axis [m]

  bool operator==(const Spread&) const = default;
};

/// One [[volley]]: a shot fired many times.
struct Volley {
  std::string name{};      ///< in tables [-]
  std::string shot{};      ///< name of the shot [-]
  std::int64_t count = 1;  ///< launches [-]
  double interval = 0;     ///< between them; 0: all at once [s]
  double start = 0;        ///< of the first [s]
  Spread spread{};         ///< [-]
  std::int64_t seed = 1;   ///< of the spread; equal seeds scatter equally [-]
};

/// One [[force]]: a law, and what it acts on. Neither shots nor layers: everything.
struct ScenarioForce {
  std::string name{};                ///< in messages [-]
  std::vector<std::string> shots{};  ///< names of shots [-]
  std::uint32_t layers = 0;          ///< bits of BodyDef::layers [-]
  ForceLaw law{};                    ///< [-]
  std::string other{};               ///< of a spring or bungee: the shot at its other end, fired once [-]
  double delay = 0;                  ///< before it starts [s]
  double duration = kInfinity;       ///< then it ends [s]
};

}  // namespace physim
