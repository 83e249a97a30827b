// What a scenario with a [world] says beside its shots: the world, volleys, forces, joints and emitters.
// Part of
// physim_scenario.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "physim/emitter.hpp"
#include "physim/forces.hpp"
#include "physim/infinity.hpp"
#include "physim/joint.hpp"
#include "physim/scenario_motion.hpp"
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

/// One [[joint]], there from the start.
struct ScenarioJoint {
  std::string name{};  ///< in messages [-]
  std::string a{};     ///< name of the shot at one end, fired once [-]
  std::string b{};     ///< name of the shot at the other end, fired once; empty: a point [-]
  Joint def{};         ///< but for its ends [-]
};

/// One of the `sub` of an [[emitter]].
struct ScenarioSub {
  std::string emitter{};  ///< name of the emitter that fires; another one or itself [-]
  SubEmitter def{};       ///< but for the emitter [-]
};

/// One [[emitter]].
struct ScenarioEmitter {
  EmitterDef def{};                 ///< but for what the members below say, and for kind, launch and subs [-]
  std::string shot{};               ///< name of the shot whose projectile, body, rail, attitude and spin it fires [-]
  std::string tracer{};             ///< of a gun: name of the shot that every tracer_every-th round is; empty: none [-]
  std::string surface_of{};         ///< name of the [[shape]] that its particles come out of; empty: none [-]
  std::string surface_file{};       ///< file of the mesh instead, as the scenario says it [-]
  std::string follows{};            ///< name of a shot, fired once, that it sits on; empty: none [-]
  ScenarioRotation rotation{};      ///< from its frame (x forward, y up, z right) to W [-]
  ScenarioMotion motion{};          ///< [-]
  std::vector<ScenarioSub> subs{};  ///< [-]
};

}  // namespace physim
