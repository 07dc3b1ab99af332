// ODE 0.16: space, double precision, an iterative solver of the linear complementarity problem of a step
// (quick step). Boxes one metre deep, held in the plane by plane2d joints.
#include <ode/ode.h>

#include <array>

#include "tests/bench/peers/drivers.h"

namespace dougong::peers {
namespace {

// The library is set up by the first wall and left so: it has one for the whole process.
void set_up_library() {
  static const bool done = dInitODE2(0) != 0;
  static_cast<void>(done);
}

class Ode final : public Peer {
 public:
  explicit Ode(const Wall& wall) : friction_(wall.friction) {
    set_up_library();
    world_ = dWorldCreate();
    space_ = dSweepAndPruneSpaceCreate(nullptr, dSAP_AXES_XYZ);
    touches_ = dJointGroupCreate(0);
    dWorldSetGravity(world_, 0.0, -wall.gravity, 0.0);
    dWorldSetAutoDisableFlag(world_, 0);
    ground_ = add(wall, wall.ground);
    dBodySetKinematic(ground_);
    for (const Box& brick : wall.bricks) {
      bricks_.push_back(add(wall, brick));
      dJointAttach(dJointCreatePlane2D(world_, nullptr), bricks_.back(), nullptr);
    }
  }
  ~Ode() override {
    dJointGroupDestroy(touches_);
    dSpaceDestroy(space_);
    dWorldDestroy(world_);
  }
  Ode(const Ode&) = delete;
  Ode& operator=(const Ode&) = delete;

  void step(double h, double ground_speed) override {
    dBodySetLinearVel(ground_, ground_speed, 0.0, 0.0);
    dSpaceCollide(space_, this,
                  [](void* self, dGeomID a, dGeomID b) { static_cast<Ode*>(self)->touch(a, b); });
    dWorldQuickStep(world_, h);
    dJointGroupEmpty(touches_);
  }

  engine::Vec2 position(std::size_t brick) const override {
    const dReal* p = dBodyGetPosition(bricks_[brick]);
    return {p[0], p[1]};
  }

 private:
  dBodyID add(const Wall& wall, const Box& box) {
    constexpr double depth = 1.0;  // m
    const dBodyID body = dBodyCreate(world_);
    dMass mass;
    dMassSetBox(&mass, wall.density, box.size.x, box.size.y, depth);
    dBodySetMass(body, &mass);
    dBodySetPosition(body, box.centre.x, box.centre.y, 0.0);
    dGeomSetBody(dCreateBox(space_, box.size.x, box.size.y, depth), body);
    return body;
  }

  // Two faces touch at four corners, two and two at the same place of the plane: those in front will do, and
  // friction along the plane.
  void touch(dGeomID a, dGeomID b) {
    std::array<dContact, 4> contacts{};
    const int count = dCollide(a, b, static_cast<int>(contacts.size()), &contacts[0].geom, sizeof(dContact));
    for (dContact& contact : std::span(contacts).first(static_cast<std::size_t>(count))) {
      if (contact.geom.pos[2] < 0.0) continue;
      contact.geom.pos[2] = 0.0;
      contact.surface.mode = dContactApprox1 | dContactFDir1 | dContactMu2;
      contact.surface.mu = friction_, contact.surface.mu2 = 0.0;
      contact.fdir1[0] = -contact.geom.normal[1], contact.fdir1[1] = contact.geom.normal[0];
      dJointAttach(dJointCreateContact(world_, touches_, &contact), dGeomGetBody(a), dGeomGetBody(b));
    }
  }

  double friction_;
  dWorldID world_;
  dSpaceID space_;
  dJointGroupID touches_;  // of one step
  dBodyID ground_ = nullptr;
  std::vector<dBodyID> bricks_;
};

}  // namespace

std::unique_ptr<Peer> ode(const Wall& wall) {
  return std::make_unique<Ode>(wall);
}

}  // namespace dougong::peers
