#include "app/plot/plot_legend.h"

#include <algorithm>
#include <cmath>
#include <sstream>

namespace quicksand {

namespace {

// Of the pictures [px].
constexpr double kLetter = 12;        // about its width, as gnuplot estimates it
constexpr double kNarrowLetter = 10;  // as it is on average
constexpr double kTics = 30;
constexpr double kSample = 5 * kLetter;
constexpr double kLegendRow = 27;
constexpr double kTitle = 38, kLineAbove = 26, kAboveGraph = 18, kAxis = 96, kBelowLegend = 12;

// Of a character of UTF-8 text the first byte.
bool begins_letter(char c) { return (static_cast<unsigned char>(c) & 0xC0U) != 0x80U; }

double length_of(const std::string& text) {
  return static_cast<double>(std::ranges::count_if(text, begins_letter));
}

std::string first_of(const std::string& text, double letters) {
  double count = 0;
  const auto beyond = [&](char c) { return begins_letter(c) && ++count > letters; };
  return {text.begin(), std::ranges::find_if(text, beyond)};
}

}  // namespace

std::string legend_name(const std::string& name, double width) {
  const double room = std::floor((width - kSample) / kLetter), letters = length_of(name);
  if (letters <= room) return name;
  const double end = std::floor(2 * room / 3);
  const std::string before_end = first_of(name, letters - end);
  return first_of(name, room - end - 1) + "…" + name.substr(before_end.size());
}

std::vector<std::string> label_lines(const std::string& label, double length) {
  const double room = std::floor(length / kNarrowLetter);
  std::vector<std::string> lines{""};
  std::istringstream words(label);
  for (std::string word; words >> word;) {
    std::string& line = lines.back();
    if (line.empty())
      line = word;
    else if (length_of(line) + 1 + length_of(word) <= room)
      line += " " + word;
    else
      lines.push_back(word);
  }
  return lines;
}

PlotLayout plot_layout(const Plot& plot, const std::vector<std::string>& names,
                       std::size_t lines_above) {
  PlotLayout layout;
  const auto is_paper = [](const auto& drawn) { return drawn.role == decltype(drawn.role)::paper; };
  // Where others have no values, its name tells which one has.
  const auto named =
      std::ranges::count_if(plot.curves, [](const Curve& c) { return !c.name.empty(); });
  layout.legend = named > 1 || std::ranges::any_of(plot.references, is_paper);
  layout.legend = layout.legend && !names.empty();
  if (layout.legend && plot.legend == LegendPlace::below) {
    double longest = 0;
    for (const std::string& name : names) longest = std::max(longest, length_of(name));
    const int columns = std::max(1, static_cast<int>(plot.width / (kSample + longest * kLetter)));
    const int n = static_cast<int>(names.size());
    layout.rows = (n + columns - 1) / columns;
  }
  const double top = kAboveGraph + (plot.title.empty() ? 0 : kTitle) +
                     kLineAbove * static_cast<double>(lines_above);
  const double below = layout.rows * kLegendRow + kBelowLegend;
  layout.height = top + plot.graph_height + kAxis + below;
  layout.top = 1 - top / layout.height;
  layout.bottom = (kAxis + below) / layout.height;
  layout.legend_top = below / layout.height;
  // gnuplot would leave more room for names.
  double longest_tic = 0;
  for (const auto& [place, name] : plot.y.names)
    longest_tic = std::max(longest_tic, length_of(name));
  if (longest_tic > 0) layout.left = (kTics + longest_tic * kNarrowLetter) / plot.width;
  return layout;
}

}  // namespace quicksand
