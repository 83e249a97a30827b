// Many segments on their way through trees of boxes at once: what the kernels of each instruction set offer.
//
// Pairs of a segment and a node wait in a list, and whichever children a segment enters go into lists in turn. Nothing
// is in order there, so there is nothing to guess: what a segment looks at next neither depends on what it has found
// nor has to be waited for, as nodes are asked for ahead.
#pragma once

#include <array>

#include "collide/bvh_node.hpp"

namespace physim::collide {

class Mesh;

/// A segment in a tree.
struct TreeRay : BoxRay {
  const BvhNode* nodes;
};

/// Pairs of a ray, by its number, and a child of a node.
struct BoxPairs {
  std::uint32_t* ray;
  std::uint32_t* child;  // bits of a BvhChild
  std::size_t count;
};

/// The nodes of `from` are compared with their rays; children that are entered are added to one of the others, which
/// have room for eight of each node, and for eight more, where anything may be written.
struct BoxJob {
  const TreeRay* rays;
  BoxPairs from, nodes, items;
};

/// A segment in the frame of a mesh.
struct MeshRay {
  Segment segment;
  const Vec3d* vertices;
  const std::array<std::uint32_t, 3>* corners;  // of triangles, by the places of the tree
  const Mesh* mesh;
  std::uint32_t question, thing;  // whose it is, and what it looks at
};

/// Where the line through a segment passes a triangle.
struct PassedTriangle {
  double t;
  std::uint32_t ray, place;
};

/// The triangles at `items` are compared with the lines through their rays; those that are passed between the ends of
/// the segment are written to `passed`, which has room for four of each, and one more.
struct TriangleJob {
  const MeshRay* rays;
  BoxPairs items;
  PassedTriangle* passed;
  std::size_t count;
};

/// The triangles at `items` are compared with the spheres about their segments: their reach becomes as short as nothing
/// is touched.
struct ClearJob {
  MeshRay* rays;
  BoxPairs items;
};

struct BoxKernel {
  const char* name;
  void (*enter)(BoxJob& job);
  void (*pass)(TriangleJob& job);
  void (*clear)(const ClearJob& job);
};

/// That of the instruction set in use. The same in the same order, whatever the kernel.
[[nodiscard]] const BoxKernel& box_kernel();

}  // namespace physim::collide
