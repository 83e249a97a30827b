// What is drawn of a scene is its surface: closed, outwards, and where segments meet it.
#include "collide/scene_support.hpp"
#include "math/vec3.hpp"
#include "support.hpp"

namespace physim::collide_scene_draw_test {

using namespace test;

struct Sheet : SceneCanvas {
  struct Drawn {
    Vec3d a, b, c;
    SceneInk ink;
  };
  std::vector<Drawn> triangles;
  std::vector<std::pair<SceneInk, double>> lines;  // with their lengths
  std::vector<std::string> texts;
  std::vector<InstanceId> things;

  void begin(InstanceId thing) override { things.push_back(thing); }
  void line(const Vec3d& a, const Vec3d& b, SceneInk ink) override { lines.emplace_back(ink, length(b - a)); }
  void triangle(const Vec3d& a, const Vec3d& b, const Vec3d& c, SceneInk ink) override {
    triangles.push_back({a, b, c, ink});
  }
  void text(const Vec3d&, std::string_view text) override { texts.emplace_back(text); }
};

TEST(SceneDraw, triangles_lie_on_the_surface_and_hold_its_volume) {
  Scene scene;
  const Transform at{.position = {3, 4, 5}, .rotation = {1, 0.5, -0.3, 0.2}, .scale = 2};
  const double pi = std::acos(-1.0);
  ConvexHullShape hull;
  for (int i = 0; i < 8; ++i) hull.points.push_back({i & 1 ? 1.0 : -1.0, i & 2 ? 1.0 : -1.0, i & 4 ? 1.0 : -1.0});
  const ShapeId box = scene.add_shape(BoxShape{{0.5, 1, 1.5}}).value();
  const std::pair<ShapeId, double> shapes[] = {
      {box, 6},
      {scene.add_shape(SphereShape{1}).value(), 4 * pi / 3},
      {scene.add_shape(CapsuleShape{1, 0.5}).value(), 4 * pi / 3 + pi},
      {scene.add_shape(CylinderShape{1, 0.5}).value(), pi},
      {scene.add_shape(hull).value(), 8},
      {scene.add_shape(ball(16, 0)).value(), 4 * pi / 3},
      {scene.add_shape(CompoundShape{{{box, {.position = {1, 2, 3}}}, {box, {.position = {-3, 0, 0}}}}}).value(), 12}};
  for (const auto& [shape, volume] : shapes) {
    const InstanceId thing = scene.add({.shape = shape, .transform = at}).value();
    Sheet sheet;
    scene.draw(sheet, {});
    double drawn = 0;
    for (const auto& t : sheet.triangles) {
      drawn += dot(t.a - at.position, cross(t.b - at.position, t.c - at.position)) / 6;
      EXPECT_EQ(t.ink, SceneInk::solid);
      for (const Vec3d& corner : {t.a, t.b, t.c}) ASSERT_LT(scene.nearest(corner).distance, 1e-12);
    }
    EXPECT_LE(drawn, 8 * volume * (1 + 1e-12)) << shape.index;
    EXPECT_GE(drawn, 8 * volume * 0.93) << shape.index;
    EXPECT_TRUE(scene.remove(thing));
  }
}

TEST(SceneDraw, tells_of_which_thing_it_is_and_draws_planes_as_faces) {
  Scene scene;
  const ShapeId box = scene.add_shape(BoxShape{}).value(), plane = scene.add_shape(PlaneShape{}).value();
  const InstanceId first = scene.add({.shape = box}).value();
  const InstanceId sea =
      scene.add({.shape = plane, .transform = {.position = {0, 4, 0}, .rotation = {1, 0.5, 0, 0.2}}}).value();
  const InstanceId second = scene.add({.shape = box}).value();
  ASSERT_TRUE(scene.remove(sea));
  const InstanceId again =
      scene.add({.shape = plane, .transform = {.position = {0, 4, 0}, .rotation = {1, 0.5, 0, 0.2}}}).value();
  Sheet sheet;
  scene.draw(sheet, {.plane_faces = true, .plane_size = 10});
  EXPECT_EQ(sheet.things, (std::vector<InstanceId>{first, again, second}));
  EXPECT_TRUE(sheet.lines.empty());
  ASSERT_EQ(sheet.triangles.size(), 26u);
  double area = 0;
  for (std::size_t i = 12; i < 14; ++i) {
    const Sheet::Drawn& t = sheet.triangles[i];
    const Vec3d facing = cross(t.b - t.a, t.c - t.a);
    area += length(facing) / 2;
    for (const Vec3d& corner : {t.a, t.b, t.c}) {
      EXPECT_LT(std::abs(scene.nearest(corner).distance), 1e-12);
      EXPECT_LT(length(scene.first_hit({.from = corner + facing * 0.1, .to = corner - facing * 0.1}).position - corner),
                1e-12)
          << "from outside";
    }
  }
  EXPECT_NEAR(area, 400, 1e-10);
}

TEST(SceneDraw, what_is_asked_for_is_drawn) {
  Scene scene;
  const ShapeId box = scene.add_shape(BoxShape{}).value(), plane = scene.add_shape(PlaneShape{}).value();
  ASSERT_TRUE(scene.add({.shape = box, .sensor = true, .name = "gate"}));
  ASSERT_TRUE(scene.add({.shape = box, .layers = 2, .motion = SteadyMotion{.velocity = {3, 0, 0}}}));
  ASSERT_TRUE(scene.add({.shape = plane, .layers = 2}));
  Sheet sheet;
  scene.draw(sheet, {.names = true, .boxes = true, .time = 1, .ahead = 2, .plane_size = 10});
  EXPECT_EQ(sheet.triangles.size(), 24u);
  EXPECT_EQ(sheet.triangles[0].ink, SceneInk::sensor);
  EXPECT_NEAR(sheet.triangles[12].a.x, 3, 0.5 + 1e-12) << "where it is at that time";
  EXPECT_EQ(sheet.texts, std::vector<std::string>{"gate"});
  double path = 0;
  std::size_t boxes = 0;
  for (const auto& [ink, length] : sheet.lines) {
    if (ink == SceneInk::path) path += length;
    boxes += ink == SceneInk::box ? 1 : 0;
  }
  EXPECT_NEAR(path, 6, 1e-12);
  EXPECT_EQ(boxes, 24u) << "one box in each of the two trees";
  Sheet some;
  scene.draw(some, {.filter = {.sensors = false}});
  EXPECT_EQ(some.triangles.size(), 12u);
  EXPECT_TRUE(some.texts.empty());
  Sheet none;
  scene.draw(none, {.time = kNan});
  EXPECT_TRUE(none.triangles.empty());
}

}  // namespace physim::collide_scene_draw_test
