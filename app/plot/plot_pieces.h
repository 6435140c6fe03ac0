// The pieces of gnuplot scripts in assets/plots/plot.gp: all that a plot looks like.
#pragma once

#include <map>
#include <string>

namespace quicksand {

class PlotPieces {
 public:
  // Throws InputError if the file is not there.
  PlotPieces();

  // The piece with the values in place of their names in braces, without a newline at its end.
  using Values = std::map<std::string, std::string>;
  std::string fill(const std::string& piece, const Values& values = {}) const;

 private:
  std::map<std::string, std::string> pieces_;
};

}  // namespace quicksand
