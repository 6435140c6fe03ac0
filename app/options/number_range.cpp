#include "app/options/number_range.h"

namespace quicksand {

namespace {

// CLI11 reads 010 as 8 and 0x10 as 16, which nobody means.
bool is_decimal(const std::string& text) {
  const std::size_t begin = text.find_first_not_of("+-");
  if (begin == std::string::npos || text[begin] != '0') return true;
  return begin + 1 == text.size() || text[begin + 1] == '.' || text[begin + 1] == 'e' ||
         text[begin + 1] == 'E';
}

}  // namespace

CLI::Validator in_range(const Limits& limits) {
  const auto problem = [limits](const std::string& text) -> std::string {
    double value = 0;
    if (is_decimal(text) && CLI::detail::lexical_cast(text, value) && value <= limits.high &&
        (limits.above ? value > limits.low : value >= limits.low))
      return {};
    return "is " + text + ", must be " + described(limits);
  };
  return {problem, ""};
}

CLI::Validator whole_in_range(std::int64_t low, std::int64_t high) {
  const auto problem = [low, high](const std::string& text) -> std::string {
    std::int64_t value = 0;
    if (is_decimal(text) && CLI::detail::lexical_cast(text, value) && low <= value && value <= high)
      return {};
    return "is " + text + ", must be a whole number from " + std::to_string(low) + " to " +
           std::to_string(high);
  };
  return {problem, ""};
}

}  // namespace quicksand
