// Numbers as a reader wants them: as many digits as the error warrants.
#pragma once

#include <optional>
#include <string>
#include <string_view>

namespace quicksand {

// "0.3721", "12350", "1.2 × 10^-6" (with raised digits) to so many significant digits; trailing zeros
// are left out.
std::string typeset(double value, int digits = 4);

// "0.372 ± 0.004": the error to one significant digit, to two where it begins with 1, the value to the
// same place; "(1.32 ± 0.05) × 10^-6". Without an error as above.
std::string typeset_with_error(double value, std::optional<double> standard_error);

// "[F_g/d]"; empty for "1", the unit of plain numbers. Roots are typeset: "[√(d/g)]".
std::string typeset_unit(std::string_view unit);

}  // namespace quicksand
