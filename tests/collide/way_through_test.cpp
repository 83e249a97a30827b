// What a point goes through on its way, step by step: each surface once, wherever steps end.
#include "collide/way_through.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "math/vec3.hpp"

namespace physim::collide_way_through_test {

struct Solid {
  const char* name;
  ShapeDef shape;
  double half = 1;  // of its extent along x, through its middle [m]
};

std::vector<Solid> solids(Scene& scene) {
  ConvexHullShape hull;
  for (const double x : {-1.0, 1.0})
    for (const double y : {-2.0, 2.0})
      for (const double z : {-2.0, 2.0}) hull.points.push_back({x, y, z});
  const ShapeId box = scene.add_shape(BoxShape{{0.5, 2, 2}}).value();
  const ShapeId ball = scene.add_shape(SphereShape{0.75}).value();
  return {{"sphere", SphereShape{1}},
          {"capsule", CapsuleShape{1, 2}},
          {"box", BoxShape{{1, 2, 2}}},
          {"cylinder", CylinderShape{1, 2}},
          {"hull", hull},
          {"boxes that touch", CompoundShape{{{.shape = box, .transform = {.position = {-0.5, 0, 0}}},
                                              {.shape = box, .transform = {.position = {0.5, 0, 0}}}}}},
          {"boxes that overlap", CompoundShape{{{.shape = box, .transform = {.position = {-0.5, 0, 0}}},
                                                {.shape = box, .transform = {.position = {0.25, 0, 0}}},
                                                {.shape = box, .transform = {.position = {0.5, 0, 0}}}}}},
          {"balls that overlap", CompoundShape{{{.shape = ball, .transform = {.position = {-0.25, 0, 0}}},
                                                {.shape = ball, .transform = {.position = {0.25, 0, 0}}}}}}};
}

/// In at from, out at to, both along x.
void expect_in_and_out(const Scene& scene, const std::vector<Vec3d>& places, double in, double out, double near,
                       const std::string& what, double seconds = 0) {
  std::vector<SceneHit> all;
  for (std::size_t i = 0; i + 1 < places.size(); ++i)
    for (const SceneHit& hit :
         collide::passages(scene, {}, {places[i], places[i + 1], 0, static_cast<double>(i) * seconds, seconds}))
      all.push_back(hit);
  ASSERT_EQ(all.size(), 2U) << what;
  EXPECT_TRUE(all[0].entering && !all[1].entering) << what;
  EXPECT_NEAR(all[0].position.x, in, near) << what;
  EXPECT_NEAR(all[1].position.x, out, near) << what;
}

TEST(Passages, are_each_reported_once_wherever_steps_end) {
  std::mt19937 random(11);  // NOLINT: the same every time
  std::uniform_real_distribution<double> any(-1, 1);
  Scene shapes;
  const std::size_t count = solids(shapes).size();
  for (std::size_t i = 0; i < count; ++i)
    for (const double middle : {10.0, 10.013, -3.0, 1000.0, 1e6})
      for (const double step : {0.1, 0.25, 1.0 / 3, 0.5, 1.0, 2.0, 7.0}) {
        Scene scene;
        const Solid solid = solids(scene)[i];
        const ShapeId shape = scene.add_shape(solid.shape).value();
        ASSERT_TRUE(scene.add({.shape = shape, .transform = {.position = {middle, 0, 0}}}));
        const std::string what =
            std::string(solid.name) + " at " + std::to_string(middle) + ", " + std::to_string(step);
        // Steps that end on both surfaces, counted up, added up, and a rounding away from there.
        for (int way = 0; way < 4; ++way) {
          std::vector<Vec3d> places;
          const double begin = middle - solid.half - 3 * step;
          double sum = begin;
          for (int k = 0; k < 6 + static_cast<int>(2 / step) + 8; ++k, sum += step) {
            double x = way == 1 ? sum : begin + k * step;
            if (way == 2) x = std::nextafter(x, -1e300);
            if (way == 3) x += any(random) * 4e-16 * std::abs(x);
            places.push_back({x, 0.01 * way, 0});
          }
          const double sag = way == 0 ? 0 : 1e-3;  // of round sides, 0.01 to 0.03 m beside the middle
          expect_in_and_out(scene, places, middle - solid.half, middle + solid.half,
                            1e-9 * std::abs(middle) + 1e-9 + sag, what + ", " + std::to_string(way));
        }
      }
}

/// The point rests, the thing moves past it: each is passed once, too.
TEST(Passages, of_things_that_move_past_are_reported_once) {
  Scene shapes;
  const std::size_t count = solids(shapes).size();
  for (std::size_t i = 0; i < count; ++i)
    for (const double step : {0.1, 0.25, 0.5, 1.0}) {
      Scene scene;
      const Solid solid = solids(scene)[i];
      const ShapeId shape = scene.add_shape(solid.shape).value();
      const SceneMotion motion = SteadyMotion{.velocity = {1, 0, 0}};
      ASSERT_TRUE(scene.add({.shape = shape, .transform = {.position = {-3, 0, 0}}, .motion = motion}));
      std::vector<SceneHit> all;
      for (int k = 0; k < static_cast<int>(6 / step); ++k)
        for (const SceneHit& hit : collide::passages(scene, {}, {{}, {}, 0, k * step, step})) all.push_back(hit);
      ASSERT_EQ(all.size(), 2U) << solid.name << ' ' << step;
      EXPECT_NEAR(all[0].time, 3 - solid.half, 2e-3 * step) << solid.name;
      EXPECT_NEAR(all[1].time, 3 + solid.half, 2e-3 * step) << solid.name;
    }
}

/// Parts of two materials are two bodies.
TEST(Passages, of_parts_of_two_materials_are_reported_of_each) {
  Scene scene;
  const MaterialId wood = scene.add_material({.name = "wood"}).value();
  const ShapeId box = scene.add_shape(BoxShape{{0.5, 2, 2}}).value();
  const ShapeId both =
      scene
          .add_shape(CompoundShape{{{.shape = box, .transform = {.position = {-0.5, 0, 0}}},
                                    {.shape = box, .transform = {.position = {0.5, 0, 0}}, .material = wood}}})
          .value();
  ASSERT_TRUE(scene.add({.shape = both}));
  EXPECT_EQ(collide::passages(scene, {}, {{-3, 0, 0}, {3, 0, 0}, 0, 0, 0}).size(), 4U);
}

}  // namespace physim::collide_way_through_test
