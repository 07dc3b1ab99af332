// Box2D 2.4: plane, single precision, sequential impulses; a contact may stay overlapped by b2_linearSlop.
#include <box2d/box2d.h>

#include "tests/bench/peers/drivers.h"

namespace dougong::peers {
namespace {

constexpr double units = 100.0;  // a metre: bodies of 0.1 to 10 units are liked
constexpr int velocity_iterations = 8, position_iterations = 3;  // as its manual suggests

b2Vec2 scaled(engine::Vec2 p) {
  return {static_cast<float>(units * p.x), static_cast<float>(units * p.y)};
}

class Box2d final : public Peer {
 public:
  explicit Box2d(const Wall& wall) : world_(scaled({0.0, -wall.gravity})) {
    world_.SetAllowSleeping(false);
    ground_ = add(wall, wall.ground, b2_kinematicBody);
    for (const Box& brick : wall.bricks) bricks_.push_back(add(wall, brick, b2_dynamicBody));
  }

  void step(double h, double ground_speed) override {
    ground_->SetLinearVelocity(scaled({ground_speed, 0.0}));
    world_.Step(static_cast<float>(h), velocity_iterations, position_iterations);
  }

  engine::Vec2 position(std::size_t brick) const override {
    const b2Vec2 p = bricks_[brick]->GetPosition();
    return {p.x / units, p.y / units};
  }

 private:
  // Polygons keep their skins apart: the drawn box is smaller by the skin, and as heavy as the whole.
  b2Body* add(const Wall& wall, const Box& box, b2BodyType type) {
    b2BodyDef place;
    place.type = type;
    place.position = scaled(box.centre);
    b2Body* body = world_.CreateBody(&place);
    const b2Vec2 half = scaled(0.5 * box.size) - b2Vec2{b2_polygonRadius, b2_polygonRadius};
    b2PolygonShape shape;
    shape.SetAsBox(half.x, half.y);
    b2FixtureDef fixture;
    fixture.shape = &shape;
    fixture.friction = static_cast<float>(wall.friction);
    fixture.density = static_cast<float>(wall.density * box.size.x * box.size.y) / (4.0f * half.x * half.y);
    body->CreateFixture(&fixture);
    return body;
  }

  b2World world_;
  b2Body* ground_ = nullptr;
  std::vector<b2Body*> bricks_;
};

}  // namespace

std::unique_ptr<Peer> box2d(const Wall& wall) {
  return std::make_unique<Box2d>(wall);
}

}  // namespace dougong::peers
