// The parts of a phase's fields: those that several kinds share, and kinds with a file of their own.
#pragma once

#include <span>
#include <string_view>

#include "app/json/fields.h"
#include "core/bodies/contact_law.h"
#include "core/scene/phases.h"
#include "core/scene/scenario.h"

namespace quicksand {

// A kind of phase, told in pages, lists and sessions.
struct PhaseKind {
  std::string_view name, sentence;
  std::string_view example;  // as a command of a session
};
// In the order of Phase::kind's alternatives.
std::span<const PhaseKind> phase_kinds();

constexpr double kMaxTime = 1e9;  // [sqrt(d/g)]

// When a phase ends; see SettlePhase. `who`: what must be slow, as in "no body is".
void describe_rest(Fields& f, double& rest_speed, double& rest_time, double& max_time,
                   const std::string& who = "no body is");

// Which touches form bonds, in a phase in which they do, and in one that says whether.
void describe_bonds(Fields& f, BondingTouch& bonds);
void describe_bonding(Fields& f, bool& bonding, BondingTouch& bonds);

// A force [F_g] that is given by itself, in `key` with these limits, or as `key`_over_cohesion over the cohesion force of
// `law`; 0 if neither is.
double given_force(Fields& f, const std::string& key, const Limits& limits,
                   std::optional<double> force, std::optional<double> over_cohesion,
                   const ContactLaw& law);
// A force [F_g], which may be given over the cohesion force of `law` instead. `least` is -1 where it
// may be negative, else 0.
void describe_force(Fields& f, const char* help, double least, double& force,
                    const ContactLaw& law);

// search_fields.cpp
void describe_fields(Fields& f, PullPhase& phase, const Scenario& scenario);
void describe_fields(Fields& f, ShearPhase& phase, const Scenario& scenario);
void describe_adiabatic(Fields& f, DepositPhase& deposit);
void describe_threshold(Fields& f, PushPhase& push);
// The same of a phase that drives an intruder; `first`: its force or torque.
void describe_critical_drive(Fields& f, const char* help, double first, bool at_given_speed,
                             double ramp_time, std::optional<CriticalDrive>& threshold);
// loading_fields.cpp
void describe_fields(Fields& f, HealPhase& phase, const Scenario& scenario);
void describe_fields(Fields& f, PistonPhase& phase, const Scenario& scenario);
void describe_fields(Fields& f, PenetratePhase& phase, const Scenario& scenario);
void describe_fields(Fields& f, VanePhase& phase, const Scenario& scenario);
void describe_fields(Fields& f, SlidePhase& phase, const Scenario& scenario);

}  // namespace quicksand
