// What a scenario says of its scene: shapes, and things that have them. Part of physim_scenario.
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <variant>
#include <vector>

#include "physim/scenario_motion.hpp"
#include "physim/scene.hpp"
#include "physim/terrain_file.hpp"

namespace physim {

struct Scenario;

/// One of the shapes that a compound has.
struct ScenarioPart {
  std::string shape{};          ///< name of another [[shape]], no plane and no compound; it may come later [-]
  std::string material{};       ///< name of its material; empty: that of the thing [-]
  Vec3d position{};             ///< of its origin in the compound's frame [m]
  ScenarioRotation rotation{};  ///< from its own frame to the compound's [-]
  double scale = 1;             ///< along all axes, 1e-9 to 1e9 [-]
};

/// One [[shape]].
struct ScenarioShape {
  std::string name{};                    ///< [-]
  std::string file{};                    ///< that its mesh or heights were read from, as the scenario says it [-]
  double low = 0;                        ///< height of black in a file of heights [m]
  double high = 1;                       ///< height of white in a file of heights [m]
  std::string terrain{};                 ///< a file of terrain that its mesh was read from, as the scenario says it [-]
  TerrainCut cut{};                      ///< what of that, about the place of the environment [-]
  std::vector<ScenarioPart> parts{};     ///< of a compound [-]
  std::vector<std::string> materials{};  ///< names, of each triangle of a mesh or one of all; empty: of the thing [-]
  ShapeDef shape = CompoundShape{};      ///< a compound's parts are named by `parts`; without any it is none yet [-]

  /// Whether it is made of other shapes.
  [[nodiscard]] bool is_compound() const { return std::holds_alternative<CompoundShape>(shape) && !parts.empty(); }
};

/// One [[thing]] of the scene. It rests where nothing is said about its motion.
struct ScenarioThing {
  std::string name{};                         ///< in tables [-]
  std::string shape{};                        ///< name of its shape [-]
  std::string material{};                     ///< name of its material; empty: that of every scene [-]
  Vec3d position{};                           ///< [m]
  ScenarioRotation rotation{};                ///< [-]
  double scale = 1;                           ///< along all axes [-]
  std::uint32_t layers = 1;                   ///< bits [-]
  bool sensor = false;                        ///< told of, and passed [-]
  double start = 0;                           ///< at which a steady motion has it at its position [s]
  Vec3d velocity{};                           ///< steady [m/s]
  Vec3d angular_velocity{};                   ///< steady, in W [rad/s]
  std::vector<ScenarioKey> keys{};            ///< instead of a steady motion [-]
  MotionCurve curve = MotionCurve::straight;  ///< from key to key [-]
};

/// Triangles of its mesh that are left out, as they have no area [-].
[[nodiscard]] std::size_t degenerate_triangles(const ScenarioShape& shape);

/// The scene of a scenario, its things in their order, each with its index as InstanceDef::user_data. An error names
/// the shape, material or thing that is wrong.
[[nodiscard]] Result<Scene> scene_of(const Scenario& scenario);

}  // namespace physim
