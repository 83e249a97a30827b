#include "cast_scenes.hpp"

namespace physim::bench {

float ground(std::uint32_t column, std::uint32_t row) {
  const double x = column * 0.09, z = row * 0.11;
  return static_cast<float>(18 * std::sin(x) * std::cos(z) + 5 * std::sin(3.1 * x + 1) * std::sin(2.7 * z) +
                            0.8 * std::sin(17 * x) * std::cos(19 * z));
}

CastMesh terrain(std::uint32_t points) {
  CastMesh mesh;
  for (std::uint32_t row = 0; row < points; ++row)
    for (std::uint32_t column = 0; column < points; ++column) {
      mesh.vertices.insert(mesh.vertices.end(), {column * kSpacing, ground(column, row), row * kSpacing});
      if (row + 1 == points || column + 1 == points) continue;
      const std::uint32_t a = row * points + column;
      mesh.triangles.insert(mesh.triangles.end(), {a, a + points, a + 1, a + 1, a + points, a + points + 1});
    }
  return mesh;
}

CastMesh house() {
  CastMesh mesh;
  for (const float y : {0.0f, 5.0f})
    for (const auto& [x, z] : {std::pair{-4.0f, -5.0f}, {4.0f, -5.0f}, {4.0f, 5.0f}, {-4.0f, 5.0f}})
      mesh.vertices.insert(mesh.vertices.end(), {x, y, z});
  mesh.vertices.insert(mesh.vertices.end(), {0, 8, -5, 0, 8, 5});
  mesh.triangles = {0, 4, 5, 0, 5, 1, 1, 5, 6, 1, 6, 2, 2, 6, 7, 2, 7, 3, 3, 7, 4, 3, 4, 0,
                    4, 8, 5, 7, 6, 9, 4, 7, 9, 4, 9, 8, 5, 8, 9, 5, 9, 6, 0, 1, 2, 0, 2, 3};
  return mesh;
}

std::vector<CastPlace> streets(int houses) {
  test::Random r(3);
  std::vector<CastPlace> places;
  for (int i = 0; i < houses; ++i) {
    const double angle = r.in(0, 6.28);
    places.push_back({{static_cast<float>(i % 32 * 22 + r.in(-3, 3)), 0, static_cast<float>(i / 32 * 24 + r.in(-3, 3))},
                      static_cast<float>(std::cos(angle)),
                      static_cast<float>(std::sin(angle))});
  }
  return places;
}

MeshShape as_shape(const CastMesh& mesh) {
  MeshShape shape;
  for (std::size_t i = 0; i < mesh.vertices.size(); i += 3)
    shape.vertices.push_back({mesh.vertices[i], mesh.vertices[i + 1], mesh.vertices[i + 2]});
  for (std::size_t i = 0; i < mesh.triangles.size(); i += 3)
    shape.triangles.push_back({mesh.triangles[i], mesh.triangles[i + 1], mesh.triangles[i + 2]});
  return shape;
}

Transform as_transform(const CastPlace& place) {
  // Half of the turn about y that takes x to (cosine, 0, -sine).
  const double angle = std::atan2(place.sine, place.cosine) / 2;
  return {.position = {place.position[0], place.position[1], place.position[2]},
          .rotation = {std::cos(angle), 0, std::sin(angle), 0}};
}

Scene scene_of(const CastMesh& mesh, const std::vector<CastPlace>& places) {
  Scene scene;
  const ShapeId shape = scene.add_shape(as_shape(mesh)).value();
  if (places.empty()) static_cast<void>(scene.add({.shape = shape}));
  for (const CastPlace& place : places)
    static_cast<void>(scene.add({.shape = shape, .transform = as_transform(place)}));
  return scene;
}

Scene field_scene() {
  HeightFieldShape field{
      .columns = kPoints, .rows = kPoints, .spacing_x = kSpacing, .spacing_z = kSpacing, .heights = {}};
  for (std::uint32_t row = 0; row < kPoints; ++row)
    for (std::uint32_t column = 0; column < kPoints; ++column) field.heights.push_back(ground(column, row));
  Scene scene;
  static_cast<void>(scene.add({.shape = scene.add_shape(field).value()}));
  return scene;
}

}  // namespace physim::bench
