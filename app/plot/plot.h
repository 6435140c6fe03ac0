// A plot: what it shows, and its files.
//
// NAME.csv holds every number drawn, one row a point; NAME.gp is a gnuplot script that reads it and
// can be changed by hand; NAME.png and NAME.svg are what gnuplot makes of both. All text is plain
// (app/plot/report_text.h). Equal plots give equal bytes.
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "render/base/colour.h"

namespace quicksand {

struct Axis {
  std::string label{};
  std::string unit = "1";       // shown in brackets; "1" if none
  std::optional<double> low{};  // ends of the axis; chosen from the data if absent [unit]
  std::optional<double> high{};
  bool logarithmic = false;                             // what is not positive is left out
  std::vector<std::pair<double, std::string>> names{};  // at places, in lieu of numbers
};

struct Curve {
  enum class Kind : std::uint8_t {
    points,  // with error bars where errors are given, also with lines
    line,    // through the points
    line_points,
    steps,  // constant from a point to the next
    band,   // filled from y_low to y_high
    boxes,  // filled between the ends of bars, one a point
    dots    // small, without bars and under the rest: single values behind means
  };
  // Ours is drawn filled and in colour; the paper's black, open or dashed; a fit, and what else belongs to the curve
  // before it, in its colour, lines thin and dashed.
  enum class Role : std::uint8_t { ours, paper, fit };

  std::string name{};  // in the legend; empty: not in it
  Kind kind = Kind::points;
  Role role = Role::ours;
  // What is one thing in several plots has one look in all; else no two curves of a plot look alike.
  std::optional<std::size_t>
      style{};  // marker, dash and, of ours, colour, from 0; the next if absent, of a fit the first
  std::optional<Colour> colour{};  // in lieu of the style's, or of the paper's black
  bool open = false;               // and not filled
  bool second_axis = false;        // y belongs to the axis on the right
  std::vector<double> x{}, y{};    // (n); y is unused in a band. What is not finite is left out.
  std::vector<double> x_error{};   // (n) half lengths of error bars, or empty
  std::vector<double> y_error{};
  std::vector<double> x_low{}, x_high{};  // (n) ends of uneven error bars, or empty
  std::vector<double> y_low{}, y_high{};  // (n) the same, or of a band
  std::vector<std::size_t> begins{};      // points that no line joins to the one before, ascending
};

// A value or an interval that is given, over the whole width (of y) or height (of x).
struct Reference {
  // The paper's is black and dashed, and in the legend; a guide is thin and grey, its name beside it.
  enum class Role : std::uint8_t { paper, guide };

  std::string name{};  // may be empty
  double low = 0;
  double high = low;  // equal to `low`: a line, else a filled band
  bool of_x = false;
  Role role = Role::paper;
};

struct Annotation {
  double x = 0, y = 0;  // the text stands above and right of this, in the units of the axes
  std::string text{};
  bool below = false;  // and not above
  bool left = false;   // and not right
};

enum class LegendPlace : std::uint8_t { below, top_left, bottom_right };

struct Plot {
  std::string name{};  // of the files: a to z, 0 to 9 and underscores
  std::string title{};
  Axis x{}, y{};
  std::optional<Axis> y2{};  // on the right
  std::vector<Curve> curves{};
  std::vector<Reference> references{};
  std::vector<Annotation> annotations{};
  LegendPlace legend = LegendPlace::below;
  double width = 800;         // of the picture [px of the SVG, of which the PNG has twice as many]
  double graph_height = 330;  // without what stands above and below it [px]
};

// Whether there is anything to draw but what the paper has. A report leaves out a plot without.
bool has_values(const Plot& plot);

// Points that a logarithmic axis cannot show. Those of bands, which lie around a line, are not counted.
std::size_t left_out(const Plot& plot);

// What there is to see, for who does not see it: the kind of plot, its axes, its curves.
std::string description_of(const Plot& plot);

// Adds a line through means in a band of one standard error, in lieu of their bars: for what changes little
// from a point to the next. What jumps, or has a law drawn through it, stays points with bars.
void add_with_band(Plot& plot, Curve curve);

// Colours for the values of an ordered parameter, from the least to the largest.
std::vector<Colour> ordered_colours(std::size_t n);
// From pale to the whole colour.
std::vector<Colour> shades_of(Colour colour, std::size_t n);

struct PlotFiles {
  bool drawn = false;   // PNG and SVG are there; CSV and script always are
  std::string problem;  // why they are not; else empty
};

// id,x,y,x_low,x_high,y_low,y_high,name: a row a point; empty where there is no such number. Curves
// are numbered from 1, references from 101.
std::string plot_csv(const Plot& plot);

std::string plot_script(const Plot& plot);

// Writes the files into a folder that exists. Throws InputError if one cannot be written. Where
// gnuplot is missing or fails, the plot is not drawn, and `problem` says so.
PlotFiles write_plot(const Plot& plot, const std::filesystem::path& folder);

}  // namespace quicksand
