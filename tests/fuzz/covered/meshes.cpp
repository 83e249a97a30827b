// Our own part of reading meshes: corners of text formats, nodes of glTF; and triangles and hulls as scenes take them.
#include <array>

#include "base/archive.hpp"
#include "fuzz/covered/target.hpp"
#include "physim/scene.hpp"
#include "scenario/gltf_nodes.hpp"
#include "scenario/mesh_text.hpp"

namespace physim::test {
namespace {

/// Corners of two bytes each or eight, and triangles of a byte for each corner.
void add_to_scene(std::span<const std::byte> bytes, bool is_hull) {
  const std::size_t corners = std::min<std::size_t>(bytes.empty() ? 0 : std::to_integer<unsigned>(bytes[0]), 64);
  bytes = bytes.subspan(bytes.empty() ? 0 : 1);
  Reader reader(bytes);
  MeshShape mesh;
  for (std::size_t i = 0; i < corners && bytes.size() >= 24; ++i, bytes = bytes.subspan(24)) {
    Vec3d& v = mesh.vertices.emplace_back();
    for (double* x : {&v.x, &v.y, &v.z}) std::memcpy(x, bytes.data() + 8 * (x - &v.x), 8);
  }
  for (; bytes.size() >= 3; bytes = bytes.subspan(3)) {
    const auto at = [&](std::size_t i) { return std::to_integer<std::uint32_t>(bytes[i]); };
    mesh.triangles.push_back({at(0), at(1), at(2)});
  }
  Scene scene;
  const auto shape = scene.add_shape(is_hull ? ShapeDef(ConvexHullShape{mesh.vertices}) : ShapeDef(mesh));
  if (!shape) {
    claim(!shape.error().message.empty(), "is refused with a reason");
    return;
  }
  const auto thing = scene.add({.shape = *shape});
  claim(thing || !thing.error().message.empty(), "a thing is added, or it is said why not");
  for (const Vec3d& to : {Vec3d{1, 2, 3}, Vec3d{0, -1, 0}, Vec3d{1e6, 0, 1}}) {
    const auto hit = scene.first_hit(SceneSegment{.from = to * -2.0, .to = to});
    claim(!hit || (hit.part >= 0 && hit.part <= 1), "what is hit lies on the way");
  }
}

void read_mesh(std::span<const std::byte> bytes) {
  if (bytes.empty()) return;
  const auto rest = bytes.subspan(1);
  switch (std::to_integer<unsigned>(bytes[0]) % 4) {
    case 0:
      if (const auto mesh = numbered_mesh(text_of(rest))) claim(!mesh->text.empty(), "a mesh has text");
      break;
    case 1:
      if (const auto nodes = gltf_nodes(text_of(rest))) claim(!nodes->text.empty(), "a file has text");
      break;
    default: add_to_scene(rest, (std::to_integer<unsigned>(bytes[0]) & 1) != 0);
  }
}

std::vector<Bytes> to_begin_with() {
  using namespace std::string_literals;
  std::vector<Bytes> seeds = {
      bytes_of("\0v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0.25 1e3 -7\nvt 0 0\nvn 0 1 0\nf 1 2 3\nf 1/1/1 2//1 -1\n"s),
      bytes_of("\0solid x\nfacet normal 0 0 1\nouter loop\nvertex 0 0 0\nvertex 1 0 0\nvertex 0 1.5 0\n"
               "endloop\nendfacet\nendsolid\n"s),
      bytes_of("\0ply\nformat ascii 1.0\nelement vertex 3\nproperty float x\nproperty float y\nproperty float "
               "z\nelement face 1\nproperty list uchar int vertex_indices\nend_header\n0 0 0\n1 0 0\n0 1 "
               "0.5\n3 0 1 2\n"s),
      bytes_of("\1{\"asset\":{\"version\":\"2.0\"},\"nodes\":[{\"mesh\":0,\"children\":[1],\"translation\":[1,2,3]},"
               "{\"rotation\":[0,0.6,0,0.8],\"scale\":[1,2,-1]}],\"scenes\":[{\"nodes\":[0]}]}")};
  Bytes mesh = bytes_of("\2\4");
  for (const double x : std::array<double, 12>{0, 0, 0, 1, 0, 0, 0, 1, 0, 0, 0, 1}) {
    Bytes eight(8);
    std::memcpy(eight.data(), &x, 8);
    mesh.insert(mesh.end(), eight.begin(), eight.end());
  }
  for (const int i : {0, 1, 2, 0, 2, 3, 0, 3, 1, 1, 3, 2}) mesh.push_back(static_cast<std::byte>(i));
  seeds.push_back(mesh);
  mesh[0] = std::byte{3};
  seeds.push_back(mesh);
  return seeds;
}

}  // namespace

const Target kMeshes{"meshes", read_mesh, to_begin_with};

}  // namespace physim::test
