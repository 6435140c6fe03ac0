#include "tests/support/render/worlds.h"

#include <cmath>

namespace quicksand::worlds {
namespace {

constexpr double kCohesion = 100;  // [F_g]

void bond(World& world, int a, int b, BondState state = BondState::active) {
  world.bonds.list.push_back({.pair = {a, b}, .state = state, .initial = true});
  ++world.bonds.formed;
  ++world.bonds.initial;
  if (state == BondState::broken) ++world.bonds.broken;
  Contact contact;
  contact.pair = {a, b};
  contact.gap = world.gap(contact.pair, &contact.normal);
  contact.cohesion = state == BondState::active ? kCohesion : 0;
  // Every third one pulls.
  const auto n = static_cast<double>(world.contacts.size());
  const double force = world.contacts.size() % 3 == 2 && contact.cohesion > 0 ? -2 - n : 2 + n;
  contact.impulse = Vec3((force + contact.cohesion) * world.impulse_dt, 0, 0);
  world.contacts.push_back(contact);
}

}  // namespace

World arch() {
  World world;
  world.box = {.width = 8, .height = 6, .sides = Sides::periodic, .floor = true};
  world.gravity = Vec2(0, -1);
  world.grain_law.cohesion_force = kCohesion;
  world.walls.push_back({.point = Vec2(0, 0), .normal = Vec2(0, 1), .role = WallRole::floor});
  world.impulse_dt = 0.01;
  world.time = 12.5;
  const auto grain = [&](double x, double y, double speed) {
    return world.disks.add({.position = Vec2(x, y), .velocity = Vec2(0, -speed)});
  };
  for (int i = 0; i < 4; ++i) grain(2, 0.5 + i, 0.05 * i);  // 0 ... 3, left column
  for (int i = 0; i < 3; ++i) grain(5, 0.5 + i, 0.1 * i);   // 4 ... 6, right column
  grain(2 + std::sqrt(0.75), 4, 0.6);                       // 7, on the left column's shoulder
  grain(2 + std::sqrt(0.75) + 1, 4, 0.8);                   // 8
  grain(5, 3.52, 1.0);                                      // 9, off the right column by a crack
  grain(7.9, 0.5, 0);                                       // 10, across the side
  grain(0.9, 0.5, 0);                                       // 11, touches 10 across the side
  for (std::size_t i = 0; i < 12; ++i) world.disks.angle[i] = 0.5 * static_cast<double>(i);

  bond(world, 0, 1);
  bond(world, 0, kWallBase);
  bond(world, 1, 2);
  bond(world, 2, 3);
  bond(world, 3, 7);
  bond(world, 4, 5);
  bond(world, 4, kWallBase);
  bond(world, 5, 6, BondState::broken);
  bond(world, 6, 9, BondState::broken);
  bond(world, 7, 8);
  bond(world, 10, 11);
  bond(world, 10, kWallBase);
  return world;
}

World arch_with_intruder() {
  World world = arch();
  const int intruder = world.disks.add({.position = Vec2(6.5, 4.7),
                                        .radius = 1,
                                        .density = 0.5,
                                        .velocity = Vec2(0, -1),
                                        .role = DiskRole::intruder});
  world.disks.applied[static_cast<std::size_t>(intruder)] = Vec3(0, -50, 0);
  return world;
}

World between_walls() {
  World world;
  world.box = {.width = 8, .height = 6, .sides = Sides::walls, .floor = true};
  world.gravity = Vec2(0, -1);
  world.walls.push_back({.point = Vec2(0, 0), .normal = Vec2(0, 1), .role = WallRole::floor});
  world.walls.push_back({.point = Vec2(0, 0), .normal = Vec2(1, 0), .role = WallRole::side});
  world.walls.push_back({.point = Vec2(8, 0), .normal = Vec2(-1, 0), .role = WallRole::side});
  world.walls.push_back({.point = Vec2(0, 5), .normal = Vec2(0, -1), .role = WallRole::piston});
  world.disks.add({.position = Vec2(0.5, 0.5)});
  world.disks.add({.position = Vec2(4, 2.5), .radius = 2.5});
  world.disks.add({.position = Vec2(7.5, 0.5)});
  return world;
}

}  // namespace quicksand::worlds
