// A scene of `quicksand bench peers` in Box2D: peer_box2d SCENE.json ANSWER.json SETTING
//
// Box2D wants bodies of 0.1 to 10 m under about 10 m/s^2. It solves a step's velocities by a number of
// Gauss-Seidel sweeps that the user chooses, and leaves overlaps of 5 mm (b2_linearSlop) as they are.
//
// It computes in single precision, and 2.4.1 calls itself 2.4.0.
//
// defaults: a disk is 1 m, 60 steps a second, 8 and 3 sweeps, as its manual says; bonds are its weld
//   joints, taken away where force or torque pass what the bond bears, again as its manual says.
// tuned: a disk is 10 m, so that the 5 mm count less; steps and sweeps with which chains hold; bonds are
//   revolute joints with a motor of speed 0 that gives in at mu_r N, which is rolling friction itself;
//   nothing sleeps; gravity rises over 1 sqrt(d/g), as a load that comes at once swings to twice its value.
#include <box2d/box2d.h>

#include <algorithm>
#include <cmath>
#include <fstream>
#include <limits>
#include <vector>

#include "app/bench/stopwatch.h"
#include "app/json/json_text.h"

namespace {

using quicksand::Json;

struct Setting {
  float metres = 1;  // of d
  double dt = 0;     // [sqrt(d/g)]
  int velocity_sweeps = 8, position_sweeps = 3;
  bool welded = true;
  double ramp = 0;  // [sqrt(d/g)]
};

constexpr float kGravity = 10;  // [m/s^2]

Setting setting_of(const std::string& name) {
  if (name == "defaults") return {.dt = 1 / 60.0 * std::sqrt(kGravity)};
  if (name == "tuned")
    return {.metres = 10,
            .dt = 1e-3,
            .velocity_sweeps = 100,
            .position_sweeps = 20,
            .welded = false,
            .ramp = 1};
  throw std::runtime_error("no such setting: " + name);
}

struct BondJoint {
  b2Joint* joint = nullptr;  // null: broken
  b2Vec2 normal;             // in the frame of `a`
  float rolling = 0;         // mu_r [m]
};

class Scene {
 public:
  Scene(const Json& input, const Setting& setting)
      : setting_(setting), world_({0, 0}), input_(input) {
    world_.SetAllowSleeping(setting.welded);
    const b2BodyDef still;
    ground_ = world_.CreateBody(&still);
    for (const Json& wall : input.at("walls")) add_wall(wall);
    for (const Json& disk : input.at("disks")) add_disk(disk);
    for (const Json& bond : input.at("bonds")) add_bond(bond.at(0), bond.at(1));
  }

  // One step under a share of gravity.
  void advance(double share) {
    const float dt = static_cast<float>(setting_.dt * std::sqrt(setting_.metres / kGravity));
    const float g = static_cast<float>(share) * kGravity;
    world_.SetGravity(
        {g * number(input_.at("gravity").at(0)), g * number(input_.at("gravity").at(1))});
    world_.Step(dt, setting_.velocity_sweeps, setting_.position_sweeps);
    const float strength = kGravity * number(input_.at("cohesion_force"));
    for (BondJoint& bond : bonds_)
      if (bond.joint != nullptr) break_if_overloaded(bond, strength, 1 / dt);
  }

  Json state() const {
    const double unit = std::sqrt(kGravity * setting_.metres);
    Json position = Json::array(), velocity = Json::array(), broken = Json::array();
    float farthest = 0;  // coordinate, which single precision resolves least [m]
    for (const b2Body* disk : disks_) {
      const b2Vec2 x = disk->GetPosition(), v = disk->GetLinearVelocity();
      farthest = std::max({farthest, std::abs(x.x), std::abs(x.y)});
      position.push_back({x.x / setting_.metres, x.y / setting_.metres});
      velocity.push_back({v.x / unit, v.y / unit,
                          disk->GetAngularVelocity() * std::sqrt(setting_.metres / kGravity)});
    }
    for (std::size_t k = 0; k < bonds_.size(); ++k)
      if (bonds_[k].joint == nullptr) broken.push_back(k);
    const float next = std::nextafter(farthest, std::numeric_limits<float>::infinity());
    return {{"position", position},
            {"velocity", velocity},
            {"broken", broken},
            {"resolution", (next - farthest) / setting_.metres}};
  }

 private:
  static float number(const Json& value) { return value.get<float>(); }
  b2Vec2 metres(const Json& v) const { return setting_.metres * direction(v); }
  static b2Vec2 direction(const Json& v) { return {number(v.at(0)), number(v.at(1))}; }

  void add_shape(b2Body* body, const b2Shape& shape, float density) {
    b2FixtureDef fixture;
    fixture.shape = &shape;
    fixture.density = density;
    fixture.friction = number(input_.at("friction"));
    body->CreateFixture(&fixture);
  }

  void add_wall(const Json& wall) {
    constexpr float kFar = 1e3;  // [d]
    const b2Vec2 point = metres(wall.at("point")), normal = direction(wall.at("normal"));
    const b2Vec2 along = kFar * setting_.metres * b2Vec2(-normal.y, normal.x);
    b2EdgeShape edge;
    edge.SetTwoSided(point - along, point + along);
    add_shape(ground_, edge, 0);
    walls_.push_back({point, normal});
  }

  void add_disk(const Json& disk) {
    b2BodyDef definition;
    definition.type = disk.at("fixed").get<bool>() ? b2_staticBody : b2_dynamicBody;
    definition.position = metres(disk.at("position"));
    b2CircleShape circle;
    circle.m_radius = setting_.metres * number(disk.at("radius"));
    disks_.push_back(world_.CreateBody(&definition));
    add_shape(disks_.back(), circle,
              number(disk.at("mass")) / (b2_pi * circle.m_radius * circle.m_radius));
  }

  // Of the disk `a` with the disk or the wall (-1, -2, ...) `b`.
  void add_bond(int a, int b) {
    b2Body* first = disks_.at(static_cast<std::size_t>(a));
    b2Body* second = b < 0 ? ground_ : disks_.at(static_cast<std::size_t>(b));
    b2Vec2 normal = b < 0 ? -walls_.at(static_cast<std::size_t>(-1 - b)).second
                          : second->GetPosition() - first->GetPosition();
    normal.Normalize();
    const float radius = first->GetFixtureList()->GetShape()->m_radius;
    const b2Vec2 anchor = first->GetPosition() + radius * normal;
    BondJoint bond{.normal = first->GetLocalVector(normal),
                   .rolling = number(input_.at("rolling_friction")) * radius};
    if (setting_.welded) {
      b2WeldJointDef weld;
      weld.Initialize(first, second, anchor);
      bond.joint = world_.CreateJoint(&weld);
    } else {
      b2RevoluteJointDef hinge;
      hinge.Initialize(first, second, anchor);
      hinge.enableMotor = true;
      hinge.maxMotorTorque = bond.rolling * kGravity * number(input_.at("cohesion_force"));
      bond.joint = world_.CreateJoint(&hinge);
    }
    bonds_.push_back(bond);
  }

  // Takes a bond away that bears no more, or adapts its rolling friction to its pressure.
  void break_if_overloaded(BondJoint& bond, float strength, float per_dt) {
    const b2Vec2 normal = bond.joint->GetBodyA()->GetWorldVector(bond.normal);
    const float pressure = strength + b2Dot(bond.joint->GetReactionForce(per_dt), normal);
    const float bound = bond.rolling * pressure;
    if (pressure < 0 ||
        (setting_.welded && std::abs(bond.joint->GetReactionTorque(per_dt)) > bound)) {
      world_.DestroyJoint(bond.joint);
      bond.joint = nullptr;
    } else if (!setting_.welded) {
      static_cast<b2RevoluteJoint*>(bond.joint)->SetMaxMotorTorque(bound);
    }
  }

  Setting setting_;
  b2World world_;
  const Json& input_;
  b2Body* ground_ = nullptr;
  std::vector<b2Body*> disks_;
  std::vector<std::pair<b2Vec2, b2Vec2>> walls_;  // point, normal
  std::vector<BondJoint> bonds_;
};

}  // namespace

int main(int count, char** words) {
  if (count != 4) return 2;
  const Json input = quicksand::parse_json(quicksand::read_text(words[1]));
  const Setting setting = setting_of(words[3]);
  Scene scene(input, setting);
  const double end = setting.ramp + input.at("time").get<double>();
  const auto steps = static_cast<int>(std::lround(end / setting.dt));
  const quicksand::bench::Stopwatch watch;
  for (int k = 1; k <= steps; ++k)
    scene.advance(setting.ramp > 0 ? std::min(1.0, k * setting.dt / setting.ramp) : 1);
  const double seconds = watch.elapsed().cpu;
  Json answer = scene.state();
  answer["cpu_seconds"] = seconds;
  answer["version"] = std::to_string(b2_version.major) + "." + std::to_string(b2_version.minor) +
                      "." + std::to_string(b2_version.revision);
  answer["dt"] = setting.dt;
  answer["ramp"] = setting.ramp;
  answer["steps"] = steps;
  std::ofstream(words[2]) << answer.dump();
}
