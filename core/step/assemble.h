// From a world to the contact problem of one step: which pairs are contacts, with which impulses they start from
// the last step, and the rows that a solver reads.
#pragma once

#include <vector>

#include "core/problem/contact_problem.h"
#include "core/step/step_settings.h"
#include "core/world/world.h"

namespace quicksand {

// Velocities at the start of the step. Disks first, then walls (nd + nw).
void start_velocities(const World& world, std::vector<Vec3>& velocity);

// How fast the line of centres of two disks turns: u_ct^2/D with u_ct the tangential relative velocity
// of the centres, from `velocity` (at least nd), and D their distance; 0 at walls; of shaped bodies what
// shaped_turning_rate says. In a step the gap opens by dt^2/2
// times that of its end. [g]
double turning_rate(const World& world, const Contact& contact, const std::vector<Vec3>& velocity);

// How often a step from this state is halved so that no bonded pair turns farther in it than max_turn.
int halvings_by_turning(const World& world, const StepSettings& step);

// Of the fastest centre, or point of a shaped body [sqrt(g d)].
double fastest(const World& world, const std::vector<Vec3>& velocity);

// Velocities at the end of the step without contacts: gravity, applied and wall forces, cohesion not
// included. Disks first, then walls (nd + nw).
void free_velocities(const World& world, double dt, std::vector<Vec3>& velocity);

// Turns free velocities into what the loads alone add to those of now.
const std::vector<Vec3>& by_loads(const World& world, std::vector<Vec3>& free_velocity);

// The widest gap of a contact of the step: what two bodies can close in it, and at least the ranges of the
// bonds. [d]
double contact_reach(const World& world, const std::vector<Vec3>& free_velocity, double dt);

// The contacts of the step among sorted `candidates`, which must hold all pairs within the reach and may hold
// others: bonded pairs, and those that may touch within the step (by the free velocities). They depend
// on the world alone, not on how many pairs farther apart a list happens to hold. Impulses are warm-started from
// world.contacts by pair, as far as the law still has them, and scaled to the new step; bonds are taken to turn as
// they did before. A bonded pair that has none begins with the N = F_c dt that balances its cohesion: with N = 0 a grain
// between two bonds would slide without friction, which is a solution, too, but of bonds that pull with all their force
// at each other. Sorted by pair.
void find_contacts(const World& world, const std::vector<Pair>& candidates,
                   const std::vector<Vec3>& free_velocity, double dt,
                   std::vector<Contact>& contacts);

// Adds to `contacts` the candidates that are not contacts but would overlap by more than `tolerance`
// [d] after moving with `velocity` (nd + nw). Returns how many were added.
int add_missed_contacts(const World& world, const std::vector<Pair>& candidates,
                        const std::vector<Vec3>& velocity, double dt, double tolerance,
                        std::vector<Contact>& contacts);

// If some bond turns so differently with `velocity` (nd + nw) from what its step was solved with that its gap is off
// by more than `tolerance` [d], all take their turning from there, and the step is to be solved again.
bool correct_turning(const World& world, const std::vector<Vec3>& velocity, double dt,
                     double tolerance, std::vector<Contact>& contacts);

// The rows of the contacts, and free velocities that include the cohesion of active bonds.
void build_problem(const World& world, const std::vector<Contact>& contacts,
                   const std::vector<Vec3>& free_velocity, const StepSettings& step,
                   ContactProblem& problem);

}  // namespace quicksand
