#include "render/base/nice_numbers.h"

#include <array>
#include <cassert>
#include <cmath>

#include "core/base/format.h"

namespace quicksand {
namespace {

constexpr double kRounding = 1e-9;  // relative, of a number meant to be nice

// With a true minus.
std::string print(std::string number) {
  if (number.starts_with('-')) number.replace(0, 1, "−");
  return number;
}

}  // namespace

double nice_below(double x) {
  assert(x > 0);
  const double decade = std::pow(10.0, std::floor(std::log10(x)));
  const double digits = x / decade * (1 + kRounding);
  // log10 may round up to the next decade.
  if (digits < 1) return decade / 2;
  return digits >= 10 ? 10 * decade : digits >= 5 ? 5 * decade : digits >= 2 ? 2 * decade : decade;
}

double nice_above(double x) {
  const double below = nice_below(x);
  if (below * (1 + 2 * kRounding) >= x) return below;
  const double decade = std::pow(10.0, std::round(std::log10(below) - 0.35));
  const double digit = std::round(below / decade);
  return digit >= 5 ? 10 * decade : digit >= 2 ? 5 * decade : 2 * decade;
}

std::vector<double> nice_ticks(const Range& range, int most) {
  const double span = range.high - range.low;
  if (!(span > 0)) return {range.low};
  double step = nice_above(span / most);
  const auto count = [&] {
    return std::floor(range.high / step + kRounding) - std::ceil(range.low / step - kRounding) + 1;
  };
  while (count() > most) step = nice_above(step * 1.5);
  std::vector<double> ticks;
  const double first = std::ceil(range.low / step - kRounding);
  const auto number = static_cast<std::size_t>(count());
  ticks.reserve(number);
  for (std::size_t i = 0; i < number; ++i) ticks.push_back((first + static_cast<double>(i)) * step);
  return ticks;
}

std::string short_number(double x) {
  if (std::abs(x) >= 1e5 || (x != 0 && std::abs(x) < 1e-3)) {
    const double exponent = std::floor(std::log10(std::abs(x)) + kRounding);
    return print(format("%.*g", 3, x / std::pow(10.0, exponent))) + "e" +
           print(format("%.*f", 0, exponent));
  }
  // From where three digits would be rounded to a power of ten.
  return std::abs(x) >= 999.5 ? print(format("%.*f", 0, x)) : print(format("%.*g", 3, x));
}

std::string fixed_number(double x, int decimals) {
  const double smallest = std::pow(10.0, -decimals) / 2;
  return print(format("%.*f", decimals, std::abs(x) < smallest ? 0 : x));
}

std::string si_number(double x, const std::string& unit) {
  struct Prefix {
    double factor;
    const char* text;
  };
  constexpr std::array<Prefix, 6> kPrefixes{
      {{1e-9, "n"}, {1e-6, "µ"}, {1e-3, "m"}, {1, ""}, {1e3, "k"}, {1e6, "M"}}};
  Prefix best = kPrefixes[3];
  if (x != 0) {
    best = kPrefixes[0];
    for (const Prefix& prefix : kPrefixes) {
      if (std::abs(x) >= prefix.factor * (1 - kRounding)) best = prefix;
    }
  }
  // A thousand seconds stay a thousand seconds.
  if (best.factor > 1 && unit == "s") best = kPrefixes[3];
  const double value = x / best.factor;
  const std::string number =
      std::abs(value) >= 1000 ? fixed_number(value, 0) : print(format("%.*g", 3, value));
  return number + " " + best.text + unit;
}

}  // namespace quicksand
