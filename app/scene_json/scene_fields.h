// The scene format: every field of a scene file with its unit, range, default and meaning, once.
// Reader, writer and schema all come from this description.
#pragma once

#include "app/json/fields.h"
#include "core/scene/scenario.h"

namespace quicksand {

// The most bodies that a scene may hold or deposit; larger numbers are taken for mistakes.
constexpr std::int64_t kMaxBodies = 5'000'000;

// Times are compared to 1e-9: shorter steps would end before they begin. [sqrt(d/g)]
constexpr double kLeastStep = 1e-8;

void describe_scene(Fields& f, Scenario& scenario);

// Drag, which may be given by the properties of a fluid where the scene is `physical`.
void describe_drag(Fields& f, Drag& drag, const std::optional<PhysicalScale>& physical);

// One phase of the protocol. The scenario must hold box and contact law already: forces may be given
// relative to the cohesion force.
void describe_phase(Fields& f, Phase& phase, const Scenario& scenario);
// The same without the word that says which kind it is.
void describe_kind(Fields& f, Phase& phase, const Scenario& scenario);

// A pattern of explicitly listed bodies and their applied forces.
void describe_bodies(Fields& f, std::vector<Disk>& disks, std::vector<Vec3>& forces);

}  // namespace quicksand
