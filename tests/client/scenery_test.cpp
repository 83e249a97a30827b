// What is drawn of things: each part in the colour of its own material.
#include "simclient/core/scenery.hpp"

#include <gtest/gtest.h>

#include <array>
#include <map>

namespace physim::client {
namespace {

TEST(Scenery, PartsHaveTheColoursOfTheirMaterials) {
  physim::Scene scene;
  const MaterialId oak = scene.add_material({.name = "oak"}).value(), ice = scene.add_material({.name = "ice"}).value();
  const ShapeId box = scene.add_shape(BoxShape{}).value();
  const ShapeId both = scene.add_shape(CompoundShape{{{box, {}}, {box, {.position = {2, 0, 0}}, ice}}}).value();
  ASSERT_TRUE(scene.add({.shape = both, .material = oak}));
  SceneryMaker maker;
  const Scenery& scenery = maker.make(&scene, 1, 0, 100);
  std::map<Colour, int> of;
  for (const LitVertex& v : scenery.vertices)
    ++of[static_cast<Colour>(v.colour[0]) << 24 | static_cast<Colour>(v.colour[1]) << 16 |
         static_cast<Colour>(v.colour[2]) << 8 | v.colour[3]];
  EXPECT_EQ(of, (std::map<Colour, int>{{colour_of_material("oak"), 36}, {colour_of_material("ice"), 36}}));
  std::map<Colour, int> edges;
  for (const SceneryEdge& edge : scenery.edges) ++edges[edge.colour];
  EXPECT_EQ(edges.size(), 2u);
}

/// The renderer draws the sceneries of the gallery's pictures, too, and tells them apart by their versions.
TEST(Scenery, HasAVersionThatNoOtherHas) {
  physim::Scene scene;
  ASSERT_TRUE(scene.add({.shape = scene.add_shape(BoxShape{}).value()}));
  SceneryMaker one, other;
  EXPECT_NE(one.make(&scene, 1, 0, 100).version, other.make(&scene, 1, 0, 100).version);
}

}  // namespace
}  // namespace physim::client
