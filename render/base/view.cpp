#include "render/base/view.h"

#include <array>

namespace quicksand {
namespace {

constexpr std::array<ColouringInfo, 7> kColourings{{
    {Colouring::automatic, "automatic",
     "active bonds, or coordination where grains form no bonds with each other", "1"},
    {Colouring::active_bonds, "active_bonds", "number of active bonds of a grain: 0, 1, 2, 3, 4+",
     "1"},
    {Colouring::initial_bonds, "initial_bonds",
     "share of a grain's initial bonds that are still active", "1"},
    {Colouring::broken_bonds, "broken_bonds", "whether all bonds of a grain hold", "1"},
    {Colouring::speed, "speed", "speed of a grain's centre", "sqrt(g d)"},
    {Colouring::pressure, "pressure",
     "compressive contact forces on a grain over its circumference", "F_g/d"},
    {Colouring::coordination, "coordination", "number of bodies that a grain touches", "1"},
}};

}  // namespace

std::span<const ColouringInfo> colourings() { return kColourings; }

const ColouringInfo& info(Colouring colouring) {
  return kColourings[static_cast<std::size_t>(colouring)];
}

}  // namespace quicksand
