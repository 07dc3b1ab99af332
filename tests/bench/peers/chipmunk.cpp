// Chipmunk 7: plane, double precision, sequential impulses; a contact may stay overlapped by the slop.
#include <chipmunk/chipmunk.h>

#include <cmath>

#include "tests/bench/peers/drivers.h"

namespace dougong::peers {
namespace {

constexpr double slop = 5e-5;  // m, that of Box2D at 100 units a metre; the default is 0.1 units

class Chipmunk final : public Peer {
 public:
  explicit Chipmunk(const Wall& wall) : space_(cpSpaceNew()) {
    cpSpaceSetGravity(space_, cpv(0.0, -wall.gravity));
    cpSpaceSetCollisionSlop(space_, slop);
    ground_ = add(wall, wall.ground, cpBodyNewKinematic());
    for (const Box& brick : wall.bricks) bricks_.push_back(add(wall, brick, free_body(wall, brick)));
  }
  ~Chipmunk() override {
    for (cpShape* shape : shapes_) cpSpaceRemoveShape(space_, shape), cpShapeFree(shape);
    for (cpBody* brick : bricks_) cpSpaceRemoveBody(space_, brick), cpBodyFree(brick);
    cpSpaceRemoveBody(space_, ground_), cpBodyFree(ground_);
    cpSpaceFree(space_);
  }
  Chipmunk(const Chipmunk&) = delete;
  Chipmunk& operator=(const Chipmunk&) = delete;

  void step(double h, double ground_speed) override {
    cpBodySetVelocity(ground_, cpv(ground_speed, 0.0));
    cpSpaceStep(space_, h);
  }

  engine::Vec2 position(std::size_t brick) const override {
    const cpVect p = cpBodyGetPosition(bricks_[brick]);
    return {p.x, p.y};
  }

 private:
  static cpBody* free_body(const Wall& wall, const Box& box) {
    const double mass = wall.density * box.size.x * box.size.y;
    return cpBodyNew(mass, cpMomentForBox(mass, box.size.x, box.size.y));
  }
  // The friction of two is the product of theirs.
  cpBody* add(const Wall& wall, const Box& box, cpBody* body) {
    cpSpaceAddBody(space_, body);
    cpBodySetPosition(body, cpv(box.centre.x, box.centre.y));
    shapes_.push_back(cpSpaceAddShape(space_, cpBoxShapeNew(body, box.size.x, box.size.y, 0.0)));
    cpShapeSetFriction(shapes_.back(), std::sqrt(wall.friction));
    return body;
  }

  cpSpace* space_;
  cpBody* ground_ = nullptr;
  std::vector<cpBody*> bricks_;
  std::vector<cpShape*> shapes_;
};

}  // namespace

std::unique_ptr<Peer> chipmunk(const Wall& wall) {
  return std::make_unique<Chipmunk>(wall);
}

}  // namespace dougong::peers
