// The scene format: every field of a scene file with its unit, range, default and meaning, once.
// Reader, writer and schema all come from this description.
#pragma once

#include "app/fields.h"
#include "core/scenario.h"

namespace quicksand {

// The most bodies that a scene may hold or deposit; larger numbers are taken for mistakes.
constexpr std::int64_t kMaxBodies = 5'000'000;

// The longest time that a scene may name [sqrt(d/g)].
constexpr double kMaxTime = 1e9;

void describe_scene(Fields& f, Scenario& scenario);

// One phase of the protocol. The scenario must hold box and contact law already: forces may be given
// relative to the cohesion force.
void describe_phase(Fields& f, Phase& phase, const Scenario& scenario);

// The kinds of phases that are described apart, and what several have in common. Refusals name the field.
void describe_rest(Fields& f, double& rest_speed, double& rest_time, double& max_time);
void describe_pull(Fields& f, PullPhase& pull, const ContactLaw& law);
void describe_shear(Fields& f, ShearPhase& shear, const ContactLaw& law);
void describe_adiabatic(Fields& f, DepositPhase& deposit);

// A pattern of explicitly listed bodies and their applied forces.
void describe_bodies(Fields& f, std::vector<Disk>& disks, std::vector<Vec3>& forces);

}  // namespace quicksand
