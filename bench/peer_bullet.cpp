// Bullet 3 with everything off that a user can switch off for shots in free flight: no damping where none is asked for,
// no sleeping tests, no collision pairs (empty filter), no contact response, one shared shape, one undivided step a
// frame. Gravity only: drag, which a user would add in a callback, is left out.
#include <btBulletDynamicsCommon.h>

#include "world_peers.hpp"

namespace physim::bench {
namespace {

/// The engine's world; what it does about collisions can be taken out by overriding one function.
class Dynamics final : public btDiscreteDynamicsWorld {
 public:
  Dynamics(btDispatcher* dispatcher, btBroadphaseInterface* broadphase, btConstraintSolver* solver,
           btCollisionConfiguration* configuration, bool detection)
      : btDiscreteDynamicsWorld(dispatcher, broadphase, solver, configuration), detection_(detection) {}
  void performDiscreteCollisionDetection() override {
    if (detection_) btDiscreteDynamicsWorld::performDiscreteCollisionDetection();
  }

 private:
  bool detection_;
};

class BulletWorld final : public PeerWorld {
 public:
  BulletWorld(const PeerPhysics& physics, const std::vector<PeerProjectile>& projectiles, bool detection)
      : dispatcher_(&configuration_),
        shape_(physics.radius),
        world_(&dispatcher_, &broadphase_, &solver_, &configuration_, detection) {
    world_.setGravity(btVector3(0, -physics.gravity, 0));
    btVector3 inertia;
    shape_.calculateLocalInertia(physics.mass, inertia);
    for (const PeerProjectile& p : projectiles) {
      btRigidBody::btRigidBodyConstructionInfo info(physics.mass, nullptr, &shape_, inertia);
      info.m_startWorldTransform.setIdentity();
      info.m_startWorldTransform.setOrigin(btVector3(p.position[0], p.position[1], p.position[2]));
      info.m_linearDamping = 1 - physics.damping;
      info.m_angularDamping = 0;
      bodies_.push_back(std::make_unique<btRigidBody>(info));
      btRigidBody& body = *bodies_.back();
      body.setLinearVelocity(btVector3(p.velocity[0], p.velocity[1], p.velocity[2]));
      body.setActivationState(DISABLE_DEACTIVATION);
      body.setCollisionFlags(body.getCollisionFlags() | btCollisionObject::CF_NO_CONTACT_RESPONSE);
      world_.addRigidBody(&body, 0, 0);
    }
  }
  ~BulletWorld() override {
    for (auto body = bodies_.rbegin(); body != bodies_.rend(); ++body) world_.removeRigidBody(body->get());
  }
  BulletWorld(const BulletWorld&) = delete;
  BulletWorld& operator=(const BulletWorld&) = delete;

  void step(float dt) override { world_.stepSimulation(dt, 0); }
  void position(std::size_t index, float* into) const override {
    const btVector3& x = bodies_[index]->getWorldTransform().getOrigin();
    for (int axis = 0; axis < 3; ++axis) into[axis] = static_cast<float>(x[axis]);
  }

 private:
  btDefaultCollisionConfiguration configuration_;
  btCollisionDispatcher dispatcher_;
  btDbvtBroadphase broadphase_;
  btSequentialImpulseConstraintSolver solver_;
  btSphereShape shape_;
  Dynamics world_;
  std::vector<std::unique_ptr<btRigidBody>> bodies_;
};

}  // namespace

std::unique_ptr<PeerWorld> bullet_world(const PeerPhysics& physics, const std::vector<PeerProjectile>& projectiles,
                                        bool detection) {
  return std::make_unique<BulletWorld>(physics, projectiles, detection);
}

}  // namespace physim::bench
