#include "core/scene/phases.h"

namespace quicksand {

std::string_view phase_name(const Phase& phase) {
  struct Name {
    std::string_view operator()(const DepositPhase&) const { return "deposit"; }
    std::string_view operator()(const SettlePhase&) const { return "settle"; }
    std::string_view operator()(const PushPhase&) const { return "push"; }
    std::string_view operator()(const PullPhase&) const { return "pull"; }
    std::string_view operator()(const ShearPhase&) const { return "shear"; }
    std::string_view operator()(const HealPhase&) const { return "heal"; }
    std::string_view operator()(const PistonPhase&) const { return "piston"; }
  };
  return std::visit(Name{}, phase.kind);
}

}  // namespace quicksand
