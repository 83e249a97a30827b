// Scenery: the things of a world's scene as triangles to be lit, and where their names stand.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "physim/scene.hpp"
#include "simclient/core/lit_vertex.hpp"

namespace physim::client {

/// Half of the height of a disc that is a target, in radii, at most [-].
inline constexpr double kFlatDisc = 0.35;

/// A thing with a name.
struct SceneryName {
  Vec3d at;  // above its middle
  std::string text;
};

/// Where two faces meet at an angle, or one ends.
struct SceneryEdge {
  Vec3d a, b;
  Colour colour = 0;
};

/// What of the scenery is one thing that moves.
struct SceneryPart {
  InstanceId thing;
  MotionState made;                                                                // where the thing was
  std::size_t vertex = 0, vertices = 0, edge = 0, edges = 0, name = 0, names = 0;  // the first of them; how many
};

struct Scenery {
  Vec3d origin;                     // of places of vertices
  std::vector<LitVertex> vertices;  // three for each triangle; those of sensors, which are seen through, come last
  std::size_t solid = 0;            // vertices before those of sensors
  std::vector<SceneryEdge> edges;   // not of sensors, nor of planes
  std::vector<SceneryName> names;
  bool has_size = false;      // something in it ends somewhere: it is no plane
  Vec3d low, high;            // of all that does
  std::uint64_t version = 0;  // rises where vertices change

  [[nodiscard]] bool is_empty() const { return vertices.empty(); }
};

/// Keeps the scenery of one scene up to date.
class SceneryMaker {
 public:
  /// As the scene stands at a time [s], planes about their origins as far as `reach` [m]; null: there is no scene.
  /// `version`: another one for another scene. `ground`: the height on which stands of targets end, beside things.
  /// Things that move take their triangles along; other changes make all of it anew.
  const Scenery& make(const physim::Scene* scene, std::uint64_t version, double time, double reach,
                      std::optional<double> ground = {});

 private:
  void move_things(const physim::Scene& scene, double time);

  Scenery scenery_, made_;  // as it is, and as it was when all of it was made
  std::vector<SceneryPart> parts_;
  bool is_made_ = false;
  std::uint64_t made_at_ = 0, changes_ = 0;
  double time_ = 0, reach_ = 0;
};

/// What a material looks like: published ones by their name, others each in a colour of its own.
[[nodiscard]] Colour colour_of_material(const std::string& name);

}  // namespace physim::client
