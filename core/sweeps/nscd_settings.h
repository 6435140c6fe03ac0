// How NSCD sweeps over the contacts.
#pragma once

#include <cstdint>
#include <optional>

namespace quicksand {

// The order of the contacts in a sweep: at random, drawn anew for each sweep; that of the pairs; that and its reverse in turns.
enum class SweepOrder : std::uint8_t { random, sorted, alternating };

// Standard nonsmooth contact dynamics (NSCD): a step is so many sweeps of projected Gauss-Seidel, taken as they are;
// see nscd.h. Its answer depends on sweeps and time step together.
struct Nscd {
  int sweeps = 100;  // in a step; again as many where these have missed contacts
  SweepOrder order = SweepOrder::random;
  // Engaged: a step ends early where its residual falls below this, looked at every tenth sweep. [1]
  std::optional<double> tolerance;
  bool operator==(const Nscd&) const = default;
};

}  // namespace quicksand
