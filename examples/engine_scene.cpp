// An engine's own physics answers: a bullet and a grenade meet the things of a Bullet 3 world, which PhySim never sees.
#include <BulletCollision/NarrowPhaseCollision/btRaycastCallback.h>
#include <btBulletCollisionCommon.h>

#include <cstdio>
#include <deque>
#include <physim/physim.hpp>

using namespace physim;
using namespace physim::units;

namespace {

btVector3 vector_of(const Vec3d& v) { return {btScalar(v.x), btScalar(v.y), btScalar(v.z)}; }
btTransform place_at(const Vec3d& x) { return btTransform(btQuaternion::getIdentity(), vector_of(x)); }

/// The level of a game: boxes and a mesh in Bullet's collision world.
class Level {
 public:
  Level() = default;
  Level(const Level&) = delete;
  Level& operator=(const Level&) = delete;
  ~Level() {
    for (btCollisionObject& thing : things_) world_.removeCollisionObject(&thing);
  }

  void add_box(const Vec3d& middle, const Vec3d& half, MaterialId material) {
    add(boxes_.emplace_back(vector_of(half)), middle, material);
  }
  /// A round hollow of triangles, 0.02 r^2 deep or high.
  void add_hollow(const Vec3d& middle, MaterialId material) {
    const int cells = 40;  // of half a metre, along each side
    const auto corner = [](int column, int row) {
      const double x = 0.5 * column - 10, z = 0.5 * row - 10;
      return vector_of({x, 0.02 * (x * x + z * z), z});
    };
    for (int row = 0; row < cells; ++row)
      for (int column = 0; column < cells; ++column) {
        const btVector3 a = corner(column, row), b = corner(column + 1, row), c = corner(column, row + 1);
        const btVector3 d = corner(column + 1, row + 1);
        triangles_.addTriangle(a, c, b);  // counterclockwise from above
        triangles_.addTriangle(b, c, d);
      }
    add(hollows_.emplace_back(&triangles_, true), middle, material);
  }

  /// What each segment meets first: rays for points, swept spheres for balls.
  void answer(const EngineBatch& batch) const {
    for (std::size_t i = 0; i < batch.segments.size(); ++i) {
      const SceneSegment& s = batch.segments[i];
      const btVector3 from = vector_of(s.from), to = vector_of(s.to);
      if (s.radius > 0) {
        const btSphereShape ball(btScalar(s.radius));
        btCollisionWorld::ClosestConvexResultCallback met(from, to);
        met.m_collisionFilterMask = static_cast<int>(batch.layers);
        world_.convexSweepTest(&ball, place_at(s.from), place_at(s.to), met);
        if (met.hasHit()) tell(met, *met.m_hitCollisionObject, batch.hits[i]);
      } else {
        btCollisionWorld::ClosestRayResultCallback met(from, to);
        met.m_collisionFilterMask = static_cast<int>(batch.layers);
        met.m_flags |= btTriangleRaycastCallback::kF_FilterBackfaces |  // meshes are met from outside, as boxes are
                       btTriangleRaycastCallback::kF_UseGjkConvexCastRaytest;  // the other one misses what is near
        world_.rayTest(from, to, met);
        if (met.hasHit()) tell(met, *met.m_collisionObject, batch.hits[i]);
      }
    }
  }

 private:
  void add(btCollisionShape& shape, const Vec3d& middle, MaterialId material) {
    btCollisionObject& thing = things_.emplace_back();
    thing.setCollisionShape(&shape);
    thing.setWorldTransform(place_at(middle));
    thing.setUserIndex(static_cast<int>(things_.size()));  // 1, 2, 3 ...: 0 is nothing to PhySim
    thing.setUserIndex2(static_cast<int>(material.index));
    world_.addCollisionObject(&thing, btBroadphaseProxy::StaticFilter, btBroadphaseProxy::AllFilter);
  }
  template <class Met>
  static void tell(const Met& met, const btCollisionObject& thing, SceneHit& hit) {
    const btVector3& n = met.m_hitNormalWorld;
    hit.part = met.m_closestHitFraction;
    hit.normal = {n.x(), n.y(), n.z()};
    hit.instance.index = static_cast<std::uint32_t>(thing.getUserIndex());
    hit.material.index = static_cast<std::uint32_t>(thing.getUserIndex2());
  }

  std::deque<btBoxShape> boxes_;
  btTriangleMesh triangles_;
  std::deque<btBvhTriangleMeshShape> hollows_;
  std::deque<btCollisionObject> things_;
  btDefaultCollisionConfiguration configuration_;
  btCollisionDispatcher dispatcher_{&configuration_};
  btDbvtBroadphase broadphase_;
  btCollisionWorld world_{&dispatcher_, &broadphase_, &configuration_};
};

}  // namespace

int main() {
  Scene scene;  // holds the materials, and may hold things of its own beside those of the engine
  const MaterialId fir = scene.add_material(materials::fir()).value();
  const MaterialId concrete = scene.add_material(materials::concrete(30e6)).value();
  const MaterialId grass = scene.add_material({.name = "grass", .restitution = 0.5, .friction = 0.8}).value();
  Level level;
  level.add_box({20, 0, 0}, {0.009, 1, 0.1}, fir);    // 1: a plank
  level.add_box({30, 0, 0}, {0.15, 2, 3}, concrete);  // 2: a wall
  level.add_hollow({0, 0, 40}, grass);                // 3
  const auto ask = [&level](const EngineBatch& batch) { level.answer(batch); };
  if (!scene.set_engine({.query = ask, .skin = 5_mm})) return 1;  // sweeps of Bullet are off by a millimetre

  World world = World::create({.ground = {.mode = GroundMode::none}}).value();
  if (!world.set_scene(scene)) return 1;
  const BodyDef shot{.collision = {.on_hit = OnHit::impact}};
  if (!world.spawn({.mass = 168_gr, .diameter = 0.308_in}, {.position = {0, 0.1, 0}, .speed = 780}, shot)) return 1;
  const BodyDef lob{.rolling_resistance = 0.1, .collision = {.on_hit = OnHit::bounce, .radius = 3_cm}};
  const auto thrown = world.spawn({.mass = 400_g, .diameter = 6_cm}, {.position = {-8, 4, 40}, .speed = 6}, lob);
  if (!thrown) return 1;

  const char* const names[] = {"", "plank", "wall", "hollow"};
  double depth = 0;  // in the wall [m]
  while (world.time() < 30) {
    world.single_step();
    for (const Event& event : world.events()) {
      if (event.kind != EventKind::penetrated && event.kind != EventKind::stopped) continue;
      depth = event.value;
      std::printf("%s by the %s at %.3f m, %.1f mm deep\n", name(event.kind).data(), names[event.instance.index],
                  event.position.x, event.value * 1000);
    }
  }
  const Vec3d lies = world[*thrown].position();
  const EngineCounters asked = world.scene()->engine_counters();
  std::printf("grenade: %s at (%.2f, %.2f, %.2f)\n", world[*thrown].is_asleep() ? "rests" : "moves", lies.x, lies.y,
              lies.z);
  std::printf("asked %llu times about %llu segments, %llu answers refused\n",
              static_cast<unsigned long long>(asked.calls), static_cast<unsigned long long>(asked.segments),
              static_cast<unsigned long long>(asked.refused));
  const double height = lies.y - 0.02 * (lies.x * lies.x + (lies.z - 40) * (lies.z - 40));  // above the hollow
  const bool is_right = depth > 102_mm && depth < 104_mm && height > 2_cm && height < 6_cm && asked.refused == 0;
  return is_right && world[*thrown].is_asleep() ? 0 : 1;
}
