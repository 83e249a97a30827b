// World::draw(): projectiles, joints, contacts and things on a canvas of the caller.
#include <gtest/gtest.h>

#include <map>

#include "math/vec3.hpp"
#include "physim/world.hpp"

namespace physim::world_world_draw_test {

/// What is drawn, by ink.
struct Sheet : SceneCanvas {
  std::map<SceneInk, std::vector<std::pair<Vec3d, Vec3d>>> lines;
  std::map<SceneInk, std::vector<std::pair<Vec3d, double>>> balls;
  std::vector<std::string> texts;
  std::vector<ProjectileId> projectiles;
  std::size_t triangles = 0;
  World* world = nullptr;  // that is tried to be changed inside

  void begin_projectile(ProjectileId projectile) override { projectiles.push_back(projectile); }
  void line(const Vec3d& a, const Vec3d& b, SceneInk ink) override { lines[ink].emplace_back(a, b); }
  void triangle(const Vec3d&, const Vec3d&, const Vec3d&, SceneInk) override { ++triangles; }
  void ball(const Vec3d& middle, double radius, SceneInk ink) override {
    balls[ink].emplace_back(middle, radius);
    if (world != nullptr) {
      EXPECT_FALSE(world->step(0.01));
    }
  }
  void text(const Vec3d&, std::string_view text) override { texts.emplace_back(text); }
};

/// Draws no balls of its own.
struct Lines : SceneCanvas {
  std::vector<std::pair<Vec3d, Vec3d>> all;
  void line(const Vec3d& a, const Vec3d& b, SceneInk) override { all.emplace_back(a, b); }
  void triangle(const Vec3d&, const Vec3d&, const Vec3d&, SceneInk) override {}
  void text(const Vec3d&, std::string_view) override {}
};

ProjectileDef stone() {
  ProjectileDef p;
  p.fidelity = Fidelity::game();
  p.fidelity.drag = DragModel::off;
  return p;
}

struct Drawn {
  World world = std::move(World::create({}).value());
  ProjectileId ball, point, still;

  Drawn() {
    BodyDef body{.collision = {.on_hit = OnHit::bounce, .radius = 0.25}, .label = "ball"};
    const KindId balls = world.add_kind(stone(), body).value();
    const KindId points = world.add_kind(stone(), {.layers = 2}).value();
    const KindId stills = world.add_kind(stone(), {.kinematic = true, .layers = 2}).value();
    ball = world.spawn(balls, Launch{.position = {0, 5, 0}, .velocity = Vec3d{10, 0, 0}}).value();
    point = world.spawn(points, Launch{.position = {0, 9, 0}, .velocity = Vec3d{0, 0, 3}}).value();
    still = world.spawn(stills, Launch{.position = {0, 7, 0}}).value();
    Scene scene;
    const ShapeId box = scene.add_shape(BoxShape{{0.5, 20, 20}}).value();
    EXPECT_TRUE(scene.add({.shape = box, .transform = {.position = {2, 0, 0}}}));
    EXPECT_TRUE(world.set_scene(scene));
    EXPECT_TRUE(world.add_joint({.kind = JointKind::cable, .a = point, .point = {0, 12, 0}}));
  }
};

TEST(WorldDraw, shows_what_a_world_holds) {
  Drawn d;
  ASSERT_TRUE(d.world.step(1.0 / 60));
  Sheet sheet;
  sheet.world = &d.world;
  d.world.draw(sheet, {.ahead = 0.5, .normals = 1, .labels = true});
  ASSERT_EQ(sheet.balls[SceneInk::flying].size(), 1u);
  EXPECT_EQ(sheet.balls[SceneInk::flying][0].first, d.world[d.ball].render_position());
  EXPECT_EQ(sheet.balls[SceneInk::flying][0].second, 0.25);
  ASSERT_EQ(sheet.lines[SceneInk::flying].size(), 3u) << "the cross of a point";
  EXPECT_EQ(length(sheet.lines[SceneInk::flying][0].second - sheet.lines[SceneInk::flying][0].first), 0.1);
  EXPECT_EQ(sheet.lines[SceneInk::held].size(), 3u);
  ASSERT_EQ(sheet.lines[SceneInk::velocity].size(), 3u);
  EXPECT_EQ(sheet.lines[SceneInk::velocity][0].second - sheet.lines[SceneInk::velocity][0].first,
            (d.world[d.ball].render_position() + d.world[d.ball].velocity() * 0.5) - d.world[d.ball].render_position());
  ASSERT_EQ(sheet.lines[SceneInk::joint].size(), 1u);
  EXPECT_EQ(sheet.lines[SceneInk::joint][0].second, (Vec3d{0, 12, 0}));
  EXPECT_EQ(sheet.texts, (std::vector<std::string>{"ball"}));
  EXPECT_EQ(sheet.triangles, 12u);
  EXPECT_EQ(sheet.lines.count(SceneInk::contact), 0u);
  EXPECT_EQ(sheet.projectiles, (std::vector<ProjectileId>{d.ball, d.point, d.still, d.point}));
}

TEST(WorldDraw, shows_contacts_of_the_last_step_where_they_were) {
  Drawn d;
  Sheet sheet;
  for (int i = 0; i < 60 && sheet.lines[SceneInk::contact].empty(); ++i) {
    ASSERT_TRUE(d.world.step(1.0 / 60));
    d.world.draw(sheet, {.normals = 2});
  }
  ASSERT_EQ(sheet.lines[SceneInk::contact].size(), 1u);
  const auto [from, to] = sheet.lines[SceneInk::contact][0];
  EXPECT_NEAR(from.x, 1.5 - 0.25, 1e-6);
  EXPECT_NEAR(length(to - from - Vec3d{-2, 0, 0}), 0, 1e-6);
}

TEST(WorldDraw, leaves_out_what_is_not_asked_for) {
  Drawn d;
  Sheet sheet;
  d.world.draw(sheet, {.things = false, .joints = false, .layers = 1});
  EXPECT_EQ(sheet.projectiles, (std::vector<ProjectileId>{d.ball}));
  EXPECT_EQ(sheet.triangles, 0u);
  EXPECT_TRUE(sheet.lines.empty());
  Sheet none;
  for (const double odd : {-1.0, 1e10, std::nan("")}) {
    d.world.draw(none, {.point_size = odd});
    d.world.draw(none, {.ahead = odd});
    d.world.draw(none, {.normals = odd});
  }
  EXPECT_TRUE(none.projectiles.empty());
}

TEST(WorldDraw, balls_are_circles_where_a_canvas_has_none) {
  Drawn d;
  Lines canvas;
  d.world.draw(canvas, {.things = false, .joints = false, .layers = 1});
  ASSERT_EQ(canvas.all.size(), 48u);
  const Vec3d middle = d.world[d.ball].render_position();
  for (const auto& [a, b] : canvas.all) {
    EXPECT_NEAR(length(a - middle), 0.25, 1e-12);
    EXPECT_NEAR(length(b - a), 2 * 0.25 * std::sin(std::acos(-1.0) / 16), 1e-12);
  }
}

}  // namespace physim::world_world_draw_test
