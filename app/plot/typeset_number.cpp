#include "app/plot/typeset_number.h"

#include <cmath>

#include "core/base/format.h"

namespace quicksand {

namespace {

// Beyond these powers of ten a number is written with one.
constexpr int kSmallestPlain = -4;
constexpr int kLargestPlain = 6;

std::string fixed(double value, int decimals) {
  return format("%.*f", std::max(0, decimals), value);
}

std::string power_of_ten(int exponent) {
  static constexpr const char* kDigits[] = {"⁰", "¹", "²", "³", "⁴", "⁵", "⁶", "⁷", "⁸", "⁹"};
  std::string text = " × 10";
  for (const char c : std::to_string(exponent)) text += c == '-' ? "⁻" : kDigits[c - '0'];
  return text;
}

// Power of ten of the first digit once rounded to so many digits.
int exponent_of(double value, int digits) {
  const std::string written = format("%.*e", digits - 1, value);
  return std::stoi(written.substr(written.find('e') + 1));
}

std::string without_trailing_zeros(std::string text) {
  if (text.find('.') == std::string::npos) return text;
  while (text.back() == '0') text.pop_back();
  if (text.back() == '.') text.pop_back();
  return text;
}

double rounded_to(double value, int place) {
  const double unit = std::pow(10.0, place);
  return place > 0 ? std::round(value / unit) * unit : value;
}

bool is_plain(int exponent) { return exponent >= kSmallestPlain && exponent < kLargestPlain; }

}  // namespace

std::string typeset(double value, int digits) {
  if (std::isnan(value)) return "not a number";
  if (std::isinf(value)) return value > 0 ? "infinite" : "-infinite";
  if (value == 0) return "0";
  const int exponent = exponent_of(value, digits);
  // Whole numbers keep their digits.
  if (is_plain(exponent)) return without_trailing_zeros(fixed(value, digits - 1 - exponent));
  return without_trailing_zeros(fixed(value / std::pow(10.0, exponent), digits - 1)) +
         power_of_ten(exponent);
}

std::string typeset_with_error(double value, std::optional<double> standard_error) {
  if (!standard_error || !std::isfinite(value)) return typeset(value);
  const double error = *standard_error;
  if (!std::isfinite(error)) return typeset(value) + " ± " + typeset(error);
  if (error <= 0) return typeset(value) + " ± 0";
  const int exponent = exponent_of(error, 2);
  constexpr double kTwoDigitsBelow = 1.95;
  const bool begins_with_one = error / std::pow(10.0, exponent) < kTwoDigitsBelow;
  const int place = begins_with_one ? exponent - 1 : exponent;
  const int top = exponent_of(std::max(std::abs(value), error), 4);
  if (is_plain(top)) {
    return fixed(rounded_to(value, place), -place) + " ± " +
           fixed(rounded_to(error, place), -place);
  }
  const double unit = std::pow(10.0, top);
  return "(" + fixed(value / unit, top - place) + " ± " + fixed(error / unit, top - place) + ")" +
         power_of_ten(top);
}

std::string typeset_unit(std::string_view unit) {
  if (unit == "1" || unit.empty()) return {};
  std::string text(unit);
  for (std::size_t at = text.find("sqrt("); at != text.npos; at = text.find("sqrt(", at)) {
    text.replace(at, 4, "√");
  }
  return "[" + text + "]";
}

}  // namespace quicksand
