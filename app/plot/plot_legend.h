// The words of a plot's script and the room that they take: legend, labels, and what the picture measures with them. The
// graph is as high with many names as with few.
#pragma once

#include <string>
#include <vector>

#include "app/plot/plot.h"

namespace quicksand {

struct PlotLayout {
  bool legend = false;
  int rows = 0;                                // of a legend below the graph
  double height = 0;                           // of the picture [px]
  double top = 0, bottom = 0, legend_top = 0;  // of graph and legend, over the picture's height [1]
  double left =
      0;  // of the graph, over the picture's width; 0: as the numbers of the axis need [1]
};

// A name as a legend of a picture this wide [px] has room for: where it is too long, without its middle, since runs and
// parameters differ at their ends.
std::string legend_name(const std::string& name, double width);

// The words of an axis's label in lines that are no longer than the axis [px]; a longer word has its own. At least one.
std::vector<std::string> label_lines(const std::string& label, double length);

// `names`: what stands in the legend. One that is of the only curve of ours says no more than the axis does.
// `lines_above`: of names above the graph.
PlotLayout plot_layout(const Plot& plot, const std::vector<std::string>& names,
                       std::size_t lines_above);

}  // namespace quicksand
