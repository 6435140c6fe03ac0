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

CLI::Validator whole_in_range(std::int64_t low, std::int64_t high) {
  const auto problem = [low, high](const std::string& text) -> std::string {
    std::int64_t value = 0;
    if (CLI::detail::lexical_cast(text, value) && low <= value && value <= high) return {};
    return "is " + text + ", must be a whole number from " + std::to_string(low) + " to " +
           std::to_string(high);
  };
  return {problem, ""};
}

}  // namespace quicksand
