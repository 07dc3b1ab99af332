// Bullet 3: space, single precision, sequential impulses. Flat boxes that touch in the plane of the wall and
// may move only in it.
#include <BulletCollision/CollisionDispatch/btBox2dBox2dCollisionAlgorithm.h>
#include <BulletCollision/CollisionShapes/btBox2dShape.h>
#include <btBulletDynamicsCommon.h>

#include <cmath>

#include "tests/bench/peers/drivers.h"

namespace dougong::peers {
namespace {

btVector3 in_plane(engine::Vec2 p) {
  return {static_cast<btScalar>(p.x), static_cast<btScalar>(p.y), 0.0f};
}

btTransform place(engine::Vec2 p) {
  return btTransform(btQuaternion::getIdentity(), in_plane(p));
}

// What a world is made of; the world must go first.
struct Workings {
  btDefaultCollisionConfiguration configuration;
  btCollisionDispatcher dispatcher{&configuration};
  btBox2dBox2dCollisionAlgorithm::CreateFunc flat_boxes;
  btDbvtBroadphase broad_phase;
  btSequentialImpulseConstraintSolver solver;
};

class Bullet final : public Peer {
 public:
  explicit Bullet(const Wall& wall) {
    workings_.dispatcher.registerCollisionCreateFunc(BOX_2D_SHAPE_PROXYTYPE, BOX_2D_SHAPE_PROXYTYPE,
                                                     &workings_.flat_boxes);
    world_.setGravity(in_plane({0.0, -wall.gravity}));
    ground_place_ = wall.ground.centre;
    ground_ = add(wall, wall.ground, 0.0);
    ground_->setCollisionFlags(btCollisionObject::CF_KINEMATIC_OBJECT);
    for (const Box& brick : wall.bricks)
      bricks_.push_back(add(wall, brick, wall.density * brick.size.x * brick.size.y));
  }
  ~Bullet() override {
    for (const auto& body : bodies_) world_.removeRigidBody(body.get());
  }
  Bullet(const Bullet&) = delete;
  Bullet& operator=(const Bullet&) = delete;

  // A kinematic body is carried; the world finds its velocity from where it was.
  void step(double h, double ground_speed) override {
    ground_place_.x += ground_speed * h;
    ground_->setWorldTransform(place(ground_place_));
    world_.stepSimulation(static_cast<btScalar>(h), 0);
  }

  engine::Vec2 position(std::size_t brick) const override {
    const btVector3& p = bricks_[brick]->getWorldTransform().getOrigin();
    return {p.x(), p.y()};
  }

 private:
  // The friction of two is the product of theirs.
  btRigidBody* add(const Wall& wall, const Box& box, double mass) {
    const btVector3 half = in_plane(0.5 * box.size) + btVector3(0.0f, 0.0f, 0.5f);
    shapes_.push_back(std::make_unique<btBox2dShape>(half));
    const auto moment =
        static_cast<btScalar>(mass / 12.0 * (box.size.x * box.size.x + box.size.y * box.size.y));
    btRigidBody::btRigidBodyConstructionInfo info(static_cast<btScalar>(mass), nullptr, shapes_.back().get(),
                                                  {moment, moment, moment});
    info.m_startWorldTransform = place(box.centre);
    info.m_friction = static_cast<btScalar>(std::sqrt(wall.friction));
    bodies_.push_back(std::make_unique<btRigidBody>(info));
    bodies_.back()->setLinearFactor({1.0f, 1.0f, 0.0f});
    bodies_.back()->setAngularFactor({0.0f, 0.0f, 1.0f});
    bodies_.back()->setActivationState(DISABLE_DEACTIVATION);
    world_.addRigidBody(bodies_.back().get());
    return bodies_.back().get();
  }

  Workings workings_;
  std::vector<std::unique_ptr<btCollisionShape>> shapes_;
  std::vector<std::unique_ptr<btRigidBody>> bodies_;
  btDiscreteDynamicsWorld world_{&workings_.dispatcher, &workings_.broad_phase, &workings_.solver,
                                 &workings_.configuration};
  engine::Vec2 ground_place_;  // m
  btRigidBody* ground_ = nullptr;
  std::vector<btRigidBody*> bricks_;
};

}  // namespace

std::unique_ptr<Peer> bullet(const Wall& wall) {
  return std::make_unique<Bullet>(wall);
}

}  // namespace dougong::peers
