// The table of emitter shapes: a row for each EmitShape. It gives the name of a shape, the members of EmitFrom that it
// reads, and what holds for all its particles.
#pragma once

#include <array>
#include <cstddef>
#include <string_view>

#include "base/enumerators.hpp"
#include "physim/emitter.hpp"
#include "physim/math.hpp"

namespace physim {

/// Members of EmitFrom that some shapes read.
enum FromMember : unsigned {
  kFromRadius = 1,
  kFromAngle = 2,
  kFromTube = 4,
  kFromSize = 8,
  kFromLength = 16,
  kFromThickness = 32,
  kFromArc = 64,
  kFromArcMode = 128,
  kFromSurface = 256,
  kFromPatch = 512,  // low_x, high_x, low_z, high_z of the surface
};

struct EmitShapeRow {
  EmitShape shape;
  std::string_view name;
  unsigned reads = 0;         // FromMembers
  bool is_straight = false;   // all leave along the axis
  bool draws_within = false;  // takes Draw::along, side and depth, too, which lie in a second block of random words
};

constexpr auto kEmitShapeTable = [] {
  using enum EmitShape;
  constexpr unsigned kRound = kFromRadius | kFromThickness | kFromArc | kFromArcMode;
  return std::array{
      EmitShapeRow{.shape = point, .name = "point", .is_straight = true},
      EmitShapeRow{.shape = cone, .name = "cone", .reads = kRound | kFromAngle},
      EmitShapeRow{.shape = sphere, .name = "sphere", .reads = kRound, .draws_within = true},
      EmitShapeRow{.shape = hemisphere, .name = "hemisphere", .reads = kRound, .draws_within = true},
      EmitShapeRow{
          .shape = box, .name = "box", .reads = kFromSize | kFromThickness, .is_straight = true, .draws_within = true},
      EmitShapeRow{.shape = circle, .name = "circle", .reads = kRound},
      EmitShapeRow{.shape = ring, .name = "ring", .reads = kRound | kFromTube, .draws_within = true},
      EmitShapeRow{.shape = line, .name = "line", .reads = kFromLength | kFromArcMode, .is_straight = true},
      EmitShapeRow{.shape = mesh, .name = "mesh", .reads = kFromSurface},
      EmitShapeRow{.shape = mesh_edges, .name = "mesh_edges", .reads = kFromSurface},
      EmitShapeRow{.shape = mesh_vertices, .name = "mesh_vertices", .reads = kFromSurface},
      EmitShapeRow{.shape = terrain, .name = "terrain", .reads = kFromSurface | kFromPatch},
  };
}();
static_assert(has_row_for_each(kEmitShapeTable, &EmitShapeRow::shape), "a shape has no row");

[[nodiscard]] PHYSIM_INLINE constexpr const EmitShapeRow& row_of(EmitShape shape) {
  return kEmitShapeTable[static_cast<std::size_t>(shape)];
}
/// True if a shape reads a member of EmitFrom.
[[nodiscard]] PHYSIM_INLINE constexpr bool reads(EmitShape shape, FromMember member) {
  return (row_of(shape).reads & member) != 0;
}

}  // namespace physim
