// World::draw(): what a world holds, as lines, triangles, balls and texts.
#include <cmath>

#include "base/ieee_mode.hpp"
#include "base/restored.hpp"
#include "physim/world.hpp"
#include "world/couple/world_impl.hpp"

namespace physim {
namespace {

constexpr double kLongestDrawn = 1e9;  // of lengths and times that are drawn

[[nodiscard]] bool is_drawn(double size) { return size >= 0 && size <= kLongestDrawn; }

/// Projectiles by what moves them.
SceneInk ink_of(const ProjectileView& projectile) {
  if (projectile.is_kinematic() || projectile.inverse_mass() == 0) return SceneInk::held;
  return projectile.is_asleep() ? SceneInk::asleep : SceneInk::flying;
}

void draw_cross(SceneCanvas& canvas, const Vec3d& at, double size, SceneInk ink) {
  for (std::size_t axis = 0; axis < 3; ++axis) {
    Vec3d reach;
    reach[axis] = size;
    canvas.line(at - reach, at + reach, ink);
  }
}

void draw_body(SceneCanvas& canvas, const ProjectileView& projectile, const WorldDrawing& what) {
  const Vec3d at = projectile.render_position();
  const SceneInk ink = ink_of(projectile);
  const double radius = projectile.body().collision.radius;
  canvas.begin_projectile(projectile.id());
  if (radius > 0) canvas.ball(at, radius, ink);
  if (!(radius > 0) && what.point_size > 0) draw_cross(canvas, at, what.point_size, ink);
  if (what.ahead > 0) canvas.line(at, at + projectile.velocity() * what.ahead, SceneInk::velocity);
  if (what.labels && !projectile.label().empty()) canvas.text(at, projectile.label());
}

}  // namespace

void World::draw(SceneCanvas& canvas, const WorldDrawing& what) const {
  const IeeeMode mode;
  if (!is_drawn(what.point_size) || !is_drawn(what.ahead) || !is_drawn(what.normals)) return;
  const Restored<const Gate*> drawing(Gate::in_question, &impl());  // the canvas changes nothing meanwhile
  if (what.things && scene() != nullptr) {
    SceneDrawing things = what.scene;
    things.time = time();
    scene()->draw(canvas, things);
  }
  const World& self = *this;
  for (const ProjectileId id : ids())
    if (const ProjectileView projectile = self[id]; (projectile.layers() & what.layers) != 0)
      draw_body(canvas, projectile, what);
  if (what.joints)
    for (const JointId id : joints()) {
      const Joint& joint = *self.joint(id);
      canvas.begin_projectile(joint.a);
      const Vec3d point = frame_of(impl().state, joint, time(), 0).place;
      canvas.line(self[joint.a].render_position(), joint.b ? self[joint.b].render_position() : point, SceneInk::joint);
    }
  if (what.normals == 0) return;
  for (const Event& event : events())
    if (event.kind == EventKind::hit) {
      canvas.begin_projectile(event.id);
      canvas.line(event.position, event.position + event.normal * what.normals, SceneInk::contact);
    }
}

}  // namespace physim
