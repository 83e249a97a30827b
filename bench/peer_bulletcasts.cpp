// Bullet 3: rays into a collision world of static triangle meshes, in its tree of boxes for moving things.
#include <btBulletCollisionCommon.h>

#include "cast_peers.hpp"

namespace physim::bench {
namespace {

class BulletCasts final : public CastPeer {
 public:
  BulletCasts(const CastMesh& mesh, std::vector<CastPlace> places)
      : vertices_(mesh.vertices), dispatcher_(&configuration_), world_(&dispatcher_, &broadphase_, &configuration_) {
    for (const std::uint32_t corner : mesh.triangles) corners_.push_back(static_cast<int>(corner));
    btIndexedMesh part;
    part.m_numTriangles = static_cast<int>(corners_.size() / 3);
    part.m_triangleIndexBase = static_cast<const unsigned char*>(static_cast<const void*>(corners_.data()));
    part.m_triangleIndexStride = 3 * sizeof(int);
    part.m_numVertices = static_cast<int>(vertices_.size() / 3);
    part.m_vertexBase = static_cast<const unsigned char*>(static_cast<const void*>(vertices_.data()));
    part.m_vertexStride = 3 * sizeof(float);
    triangles_.addIndexedMesh(part);
    shape_ = std::make_unique<btBvhTriangleMeshShape>(&triangles_, true);
    if (places.empty()) places.push_back({{0, 0, 0}, 1, 0});
    for (const CastPlace& place : places) {
      auto& object = objects_.emplace_back(std::make_unique<btCollisionObject>());
      object->setCollisionShape(shape_.get());
      const btMatrix3x3 turn(place.cosine, 0, place.sine, 0, 1, 0, -place.sine, 0, place.cosine);
      object->setWorldTransform(btTransform(turn, btVector3(place.position[0], place.position[1], place.position[2])));
      world_.addCollisionObject(object.get(), btBroadphaseProxy::StaticFilter, btBroadphaseProxy::AllFilter);
    }
    world_.updateAabbs();
  }
  ~BulletCasts() override {
    for (auto& object : objects_) world_.removeCollisionObject(object.get());
  }
  BulletCasts(const BulletCasts&) = delete;
  BulletCasts& operator=(const BulletCasts&) = delete;

  void cast(const std::vector<CastSegment>& segments, std::vector<float>& parts) override {
    for (std::size_t i = 0; i < segments.size(); ++i) {
      const CastSegment& s = segments[i];
      const btVector3 from(s.from[0], s.from[1], s.from[2]), to(s.to[0], s.to[1], s.to[2]);
      btCollisionWorld::ClosestRayResultCallback result(from, to);
      world_.rayTest(from, to, result);
      parts[i] = result.hasHit() ? result.m_closestHitFraction : 2;
    }
  }

 private:
  std::vector<float> vertices_;
  std::vector<int> corners_;
  btTriangleIndexVertexArray triangles_;
  std::unique_ptr<btBvhTriangleMeshShape> shape_;
  btDefaultCollisionConfiguration configuration_;
  btCollisionDispatcher dispatcher_;
  btDbvtBroadphase broadphase_;
  btCollisionWorld world_;
  std::vector<std::unique_ptr<btCollisionObject>> objects_;
};

}  // namespace

std::unique_ptr<CastPeer> bullet_scene(const CastMesh& mesh, const std::vector<CastPlace>& places) {
  return std::make_unique<BulletCasts>(mesh, places);
}

}  // namespace physim::bench
