// What a scene says, in grain units: the physics and the protocol, nothing of pictures or output.
//
// Units: length d (mean grain diameter), mass of a grain, g = 1; hence force F_g (the weight of a
// grain), time sqrt(d/g). A term that is not engaged is not modelled.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "core/bodies/box.h"
#include "core/bodies/contact_law.h"
#include "core/bodies/disks.h"
#include "core/bodies/drag.h"
#include "core/bodies/walls.h"
#include "core/problem/solver_settings.h"
#include "core/scene/phases.h"
#include "core/step/step_settings.h"

namespace quicksand {

// For reading results in SI units; the computation does not use it.
struct PhysicalScale {
  double grain_diameter = 0;  // [m]
  double grain_density = 0;   // of the solid [kg/m^3]
  double gravity = 9.81;      // [m/s^2]
  bool operator==(const PhysicalScale&) const = default;
};

enum class InitialBonds : std::uint8_t { none, touching };

struct Scenario {
  std::string name;
  std::string description;
  std::uint64_t seed = 1;
  std::optional<PhysicalScale> physical;
  std::optional<Vec2> gravity;  // vector [g]; absent: no gravity
  std::optional<Drag> drag;     // of a fluid on every body
  Box box;
  ContactLaw grain_law;                    // grain on grain
  std::optional<ContactLaw> wall_law;      // grain on wall; as grain_law if absent
  std::optional<ContactLaw> intruder_law;  // intruder on anything; as grain_law if absent
  StepSettings step;
  SolverSettings solver;
  std::vector<Disk> disks;
  std::vector<Vec3> disk_forces;  // (disks) applied force [F_g] and torque [F_g d]
  std::vector<Wall> walls;        // besides floor and sides of the box
  InitialBonds initial_bonds = InitialBonds::none;
  std::string start_from;  // checkpoint whose world is taken; empty: none
  std::vector<Phase> phases;
};

// Names of the model terms in use ("gravity", "friction", ...), in a fixed order.
std::vector<std::string> model_terms(const Scenario& scenario);

}  // namespace quicksand
