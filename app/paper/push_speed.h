// How fast pushed intruders plough.
#pragma once

#include <optional>
#include <string>

#include "app/paper/paper_results.h"

namespace quicksand {

// Where it is past the start and the velocity is taken first, over the box's height.
inline constexpr double kPloughsFrom = 0.15;

// Mean velocity between 15 and 60 % of the box's height [d], past the start and before the floor; absent
// if the intruder did not come that deep. [sqrt(g d)]
std::optional<double> ploughing_speed(const RunResults& push, double height);

// Over the realizations of each force; absent where no intruder came that deep.
std::optional<Measured> ploughing_speed(const PaperResults& results, const RunGroup& pushes,
                                        double height);

// Mean velocity over the push force, with standard errors.
Curve ploughing_speeds(const PaperResults& results, const std::string& name, const PushCurve& curve,
                       double height);

}  // namespace quicksand
