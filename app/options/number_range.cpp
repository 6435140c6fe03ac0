#include "app/options/number_range.h"

namespace quicksand {

CLI::Validator in_range(const Limits& limits) {
  const auto problem = [limits](const std::string& text) -> std::string {
    double value = 0;
    if (CLI::detail::lexical_cast(text, value) && value <= limits.high &&
        (limits.above ? value > limits.low : value >= limits.low))
      return {};
    return "is " + text + ", must be " + described(limits);
  };
  return {problem, ""};
}

}  // namespace quicksand
