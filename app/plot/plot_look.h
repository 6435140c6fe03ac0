// How the parts of a plot look, in gnuplot's words: colours, markers and dashes that differ for readers
// who see no colours, black for the paper.
#pragma once

#include <string>
#include <vector>

#include "app/plot/plot.h"

namespace quicksand {

constexpr const char* kGreyText = " textcolor rgb '#444444'";

// How a curve is told from the others.
struct Look {
  std::string colour;
  int marker = 0;
  std::string dash;
};

std::vector<Look> looks_of(const std::vector<Curve>& curves);

// What follows the data of a curve: "with points pt 7 ...".
std::string with(const Curve& curve, const Look& look, bool x_bars, bool y_bars);

std::string line_of(const Reference& reference);
std::string filling_of(const Reference& reference);

}  // namespace quicksand
