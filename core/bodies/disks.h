// The grains and intruders: rigid disks, as a structure of arrays of equal length (nd).
//
// Mass is measured so that a disk of diameter 1 and density 1 has mass 1: m = density * diameter^2;
// the moment of inertia is that of a homogeneous disk, I = m r^2 / 2.
#pragma once

#include <vector>

#include "core/base/types.h"

namespace quicksand {

enum class DiskRole : std::uint8_t { grain, intruder };

struct Disk {
  Vec2 position{0, 0};  // centre [d]
  double radius = 0.5;  // [d]
  double density = 1;   // over that of a grain [1]
  Vec2 velocity{0, 0};  // [sqrt(g d)]
  double spin = 0;      // counter-clockwise [sqrt(g/d)]
  DiskRole role = DiskRole::grain;
  bool fixed = false;  // moves with its given velocity, whatever acts on it
};

struct Disks {
  std::vector<Vec2> position;      // (nd) centre, not wrapped by periodic sides [d]
  std::vector<double> angle;       // (nd) [rad]
  std::vector<Vec3> velocity;      // (nd) (v_x, v_y, spin) [sqrt(g d)], [sqrt(g/d)]
  std::vector<Vec3> applied;       // (nd) force (F_x, F_y) [F_g] and torque [F_g d] besides gravity
  std::vector<double> radius;      // (nd) [d]
  std::vector<double> mass;        // (nd) [grain masses]
  std::vector<Vec3> inverse_mass;  // (nd) (1/m, 1/m, 1/I), zero if fixed
  std::vector<DiskRole> role;      // (nd)
  bool operator==(const Disks&) const = default;

  int size() const { return static_cast<int>(position.size()); }
  double inertia(int i) const { return mass[i] * radius[i] * radius[i] / 2; }
  bool fixed(int i) const { return inverse_mass[i].x() == 0; }
  // Appends a disk at rest angle 0 without applied force; returns its index.
  int add(const Disk& disk);
};

}  // namespace quicksand
