// The lengths that decide what touches, what was missed and what may be off, all in d. What is said of the paper's
// bonds is for their range d_c = 5e-5 d (ContactLaw::cohesion_range), at which a bond breaks.
#pragma once

namespace quicksand {

// Pairs farther apart than this are contacts only if their free velocities close the gap. A hundred ranges of the
// paper's bonds, and half a step of 1e-2 at unit speed: what a collision in the step may bring into touch.
constexpr double kAlwaysWithin = 5e-3;

// Admissible gap error of a loaded contact: a bond that the solver leaves open by a tenth of its range does not break
// for that. Plain contacts have no range; theirs is a thousandth of a grain.
constexpr double kBondGapShare = 0.1;        // over the cohesion range [1]
constexpr double kPlainGapTolerance = 1e-3;  // [d]

// Gaps below this, and this share of what is admissible, are taken for none. To close what rounding opens
// costs a packing at rest two solutions, one that moves and one that stops, whose impulses hand the
// same motion on; it would never come to rest exactly. At the paper's bonds both are the same.
constexpr double kLeastGapShare = 2e-5;  // over the admissible gap error [1]
constexpr double kLeastGap = 1e-10;      // [d]

// Overlap that a pair outside the problem may reach before the step is solved again with it: a fiftieth of the
// admissible gap error of the paper's bonds.
constexpr double kMissTolerance = 1e-7;

// By which a bond's gap may be off because it turns otherwise than foreseen, as when a collision stops it: what is too
// narrow overlaps, and is pushed apart in the next step. A tenth of this makes no run more accurate.
constexpr double kTurnTolerance = 1e-3;

}  // namespace quicksand
