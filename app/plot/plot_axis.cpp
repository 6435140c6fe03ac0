#include "app/plot/plot_axis.h"

#include <algorithm>
#include <string_view>

#include "app/json/json_reader.h"
#include "app/plot/plot_legend.h"
#include "app/plot/report_text.h"
#include "app/plot/typeset_number.h"
#include "core/base/format.h"

namespace quicksand {

namespace {

std::string range_text(const std::string& low, const std::string& high) {
  return "[" + low + ":" + high + "]";
}

// Digits of which a logarithmic axis names the places, by how many decades there are.
std::string_view named_digits(double decades) {
  if (decades < 1) return "12357";
  if (decades < 2) return decades < 1.5 ? "1235" : "125";
  return "13";
}

// Places of every decade that the extent touches.
std::string short_logarithmic(const Extent& extent) {
  const double margin = 1.1;  // of the range about the extent
  const std::string_view named = named_digits(std::log10(extent.high / extent.low));
  std::string list;
  const int last = static_cast<int>(std::floor(std::log10(extent.high * margin)));
  for (int decade = static_cast<int>(std::floor(std::log10(extent.low / margin))); decade <= last;
       ++decade)
    for (const char digit : std::string_view("123456789")) {
      const std::string place = std::string(1, digit) + "e" + std::to_string(decade);
      const bool is_named = named.find(digit) != named.npos;
      list +=
          (list.empty() ? "" : ", ") +
          (is_named ? gnuplot_text(typeset(std::stod(place))) + " " + place : "'' " + place + " 1");
    }
  return list;
}

}  // namespace

void Extent::add(double value, const Axis& axis) {
  if (!std::isfinite(value) || (axis.logarithmic && value <= 0)) return;
  low = std::min(low, value);
  high = std::max(high, value);
}

std::vector<std::string> axis_label(const Axis& axis, double length) {
  const std::string unit = typeset_unit(axis.unit);
  std::vector<std::string> lines =
      label_lines(axis.label + (unit.empty() ? "" : " " + unit), length);
  for (std::string& line : lines) line = gnuplot_text(line);
  return lines;
}

std::string axis_range(const Axis& axis, const Extent& extent) {
  constexpr double kMargin = 0.04;  // of the extent
  const auto text = [](const std::optional<double>& end, const std::string& otherwise) {
    return end ? number_text(*end) : otherwise;
  };
  if (extent.empty()) {  // without values gnuplot would find no range
    constexpr double kLowest = 0.1;
    const double low = axis.low.value_or(axis.logarithmic ? kLowest : 0);
    return range_text(number_text(low),
                      text(axis.high, number_text(axis.logarithmic ? 10 * low : low + 1)));
  }
  const double from = axis.low.value_or(extent.low), to = axis.high.value_or(extent.high);
  if (!(to > from) || (axis.logarithmic && from <= 0))
    return range_text(text(axis.low, "*"), text(axis.high, "*"));
  if (axis.logarithmic) {
    const double factor = std::pow(to / from, kMargin);
    return range_text(text(axis.low, number_text(from / factor)),
                      text(axis.high, number_text(to * factor)));
  }
  const double margin = kMargin * (to - from);
  return range_text(text(axis.low, number_text(from - margin)),
                    text(axis.high, number_text(to + margin)));
}

Tics tics_of(const Axis& axis, const Extent& extent) {
  if (!axis.names.empty()) return Tics::listed;
  // Of one axis all places have a power of ten, or none.
  constexpr double kFewDigits = 1e-3, kManyDigits = 1e4, kLargestPlain = 1e5;
  const double largest = extent.empty() ? 0 : std::max(std::abs(extent.low), std::abs(extent.high));
  if (!axis.logarithmic) return largest < kLargestPlain ? Tics::plain : Tics::scientific;
  // Over few decades powers of ten would name a place or two.
  constexpr double kTwoDecades = 1e2, kThreeDecades = 2e3, kManyDecades = 1e6;
  const bool long_numbers = extent.low < kFewDigits || extent.high > kManyDigits;
  const double ratio = extent.empty() ? kManyDecades : extent.high / extent.low;
  if (ratio < (long_numbers ? kTwoDecades : kThreeDecades)) return Tics::listed;
  if (ratio > kManyDecades) return Tics::many_powers;
  return long_numbers ? Tics::powers : Tics::plain;
}

std::string tic_list(const Axis& axis, const Extent& extent) {
  if (axis.names.empty()) return short_logarithmic(extent);
  std::string list;
  for (const auto& [place, name] : axis.names)
    list += (list.empty() ? "" : ", ") + gnuplot_text(name) + " " + number_text(place);
  return list;
}

}  // namespace quicksand
