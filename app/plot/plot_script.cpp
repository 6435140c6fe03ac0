// The gnuplot script of a plot: first how it looks, then what is drawn, then both pictures.
#include <algorithm>
#include <cmath>
#include <string>
#include <utility>
#include <vector>

#include "app/json/json_reader.h"
#include "app/plot/plot.h"
#include "app/plot/plot_look.h"
#include "app/plot/plot_rows.h"
#include "app/plot/report_text.h"
#include "app/plot/typeset_number.h"

namespace quicksand {

namespace {

std::string label_of(const Axis& axis) {
  const std::string unit = typeset_unit(axis.unit);
  return gnuplot_text(axis.label + (unit.empty() ? "" : " " + unit));
}

// The ends of what is drawn along an axis.
struct Extent {
  double low = HUGE_VAL;
  double high = -HUGE_VAL;
  bool of_bars = false;  // gnuplot knows how wide and high they are

  bool empty() const { return low > high; }
  void add(double value, const Axis& axis) {
    if (!std::isfinite(value) || (axis.logarithmic && value <= 0)) return;
    low = std::min(low, value);
    high = std::max(high, value);
  }
};

// Ends that are not given lie a little outside of what is drawn, so that no point hides on a border.
std::string range_of(const Axis& axis, const Extent& extent) {
  constexpr double kMargin = 0.04;  // of the extent
  const auto range = [](const std::string& low, const std::string& high) {
    return "[" + low + ":" + high + "]";
  };
  const auto text = [](const std::optional<double>& end, const std::string& otherwise) {
    return end ? number_text(*end) : otherwise;
  };
  if (extent.empty()) {  // without values gnuplot would find no range
    constexpr double kLowest = 0.1;
    const double low = axis.low.value_or(axis.logarithmic ? kLowest : 0);
    return range(number_text(low),
                 text(axis.high, number_text(axis.logarithmic ? 10 * low : low + 1)));
  }
  const double from = axis.low.value_or(extent.low), to = axis.high.value_or(extent.high);
  if (extent.of_bars || !(to > from) || (axis.logarithmic && from <= 0))
    return range(text(axis.low, "*"), text(axis.high, "*"));
  if (axis.logarithmic) {
    const double factor = std::pow(to / from, kMargin);
    return range(text(axis.low, number_text(from / factor)),
                 text(axis.high, number_text(to * factor)));
  }
  const double margin = kMargin * (to - from);
  return range(text(axis.low, number_text(from - margin)),
               text(axis.high, number_text(to + margin)));
}

// Places 1, 2 and 5 of every decade around `extent`, as gnuplot lists them; within a decade 3 and 7, too.
std::string short_logarithmic(const Extent& extent) {
  const std::vector<const char*> digits = extent.high <= 10 * extent.low
                                              ? std::vector{"1", "2", "3", "5", "7"}
                                              : std::vector{"1", "2", "5"};
  std::string list;
  const int last = static_cast<int>(std::ceil(std::log10(extent.high)));
  for (int decade = static_cast<int>(std::floor(std::log10(extent.low))); decade <= last; ++decade)
    for (const char* digit : digits)
      list += (list.empty() ? "" : ", ") + std::string(digit) + "e" + std::to_string(decade);
  return list;
}

class Script {
 public:
  explicit Script(const Plot& plot) : plot_(plot), looks_(looks_of(plot.curves)) {
    for (const Curve& curve : plot.curves) {
      rows_.push_back(rows_of(plot, curve));
      for (const PlotRow& row : rows_.back()) {
        for (const double value : {row.x, row.x_low, row.x_high}) x_.add(value, plot.x);
        const bool second = curve.second_axis && plot.y2;
        for (const double value : {row.y, row.y_low, row.y_high})
          second ? y2_.add(value, *plot.y2) : y_.add(value, plot.y);
        if (curve.kind == Curve::Kind::histogram) x_.of_bars = y_.of_bars = true;
      }
    }
    for (const Reference& reference : plot.references) {
      for (const double end : {reference.low, reference.high})
        reference.of_x ? x_.add(end, plot.x) : y_.add(end, plot.y);
    }
  }

  std::string text() {
    appearance();
    axes();
    given_things();
    what_is_drawn();
    pictures();
    return script_;
  }

 private:
  void line(const std::string& text) { script_ += text + "\n"; }

  void appearance() {
    line("# Draws " + plot_.name + ".png and " + plot_.name + ".svg from " + plot_.name + ".csv:");
    line("#   gnuplot " + plot_.name + ".gp");
    line("# in this folder. Columns: 1 id of the curve, 2 x, 3 y, 4 and 5 ends of the bar in x,");
    line("# 6 and 7 ends of the bar in y or of the band, 8 name.");
    line("");
    line("# Appearance");
    if (!plot_.title.empty()) line("set title " + gnuplot_text(plot_.title) + " offset 0, 0.7");
    line(std::string("set border ") + (plot_.y2 ? "11" : "3") + " lw 0.8 lc rgb '#333333'");
    line("set tics nomirror out scale 0.6 textcolor rgb '#333333'");
    line("set grid lt 1 lw 0.4 lc rgb '#DDDDDD'");
    line("set bars small");
    const char* const places[] = {"inside top right", "inside top left", "inside bottom right",
                                  "inside bottom left", "below center horizontal"};
    line(plot_.legend == LegendPlace::none
             ? std::string("unset key")
             : std::string("set key ") + places[static_cast<int>(plot_.legend)] +
                   " Left reverse samplen 3 spacing 1.2" +
                   (plot_.legend == LegendPlace::below ? " height 1" : ""));
  }

  void axis(const std::string& name, const Axis& axis, const Extent& extent) {
    line("set " + name + "label " + label_of(axis) + (name == "x" ? " offset 0, 0.3" : ""));
    // Over one or two decades powers of ten would name a place or two.
    constexpr double kFewDecades = 100;
    const bool few_decades =
        axis.logarithmic && !extent.empty() && extent.high < kFewDecades * extent.low;
    if (axis.logarithmic) {
      // Small tics between decades only where decades are few.
      constexpr double kManyDecades = 1e6;
      line("set logscale " + name);
      if (extent.high > kManyDecades * extent.low) line("unset m" + name + "tics");
      if (few_decades) line("set " + name + "tics (" + short_logarithmic(extent) + ")");
    }
    constexpr double kFewDigits = 1e-3, kManyDigits = 1e4;
    const bool powers = axis.logarithmic && !few_decades &&
                        (extent.empty() || extent.low < kFewDigits || extent.high > kManyDigits);
    line("set format " + name + (powers ? " '10^{%T}'" : " '%h'"));
    line("set " + name + "range " + range_of(axis, extent));
  }

  void axes() {
    line("");
    line("# Axes");
    axis("x", plot_.x, x_);
    axis("y", plot_.y, y_);
    if (!plot_.y2) return;
    axis("y2", *plot_.y2, y2_);
    line("set y2tics");
  }

  // References and annotations.
  void given_things() {
    for (const Reference& reference : plot_.references) given(reference);
    for (const Annotation& a : plot_.annotations) {
      line("set label " + gnuplot_text(a.text) + " at " + number_text(a.x) + ", " +
           number_text(a.y) + (a.below ? " offset 0.6, -0.8" : " offset 0.6, 0.6") + " front" +
           kGreyText);
    }
  }

  using Span = std::pair<double, double>;  // from and to, over the graph's width

  // The name of a guide stands above the graph, to the right of its line or, where it would leave the picture,
  // to the left; where others stand there already inside the graph, as many lines down as needed.
  std::string place_of_name(const Reference& reference) {
    constexpr double kCharacter = 0.015;  // about its width, over the graph's
    const auto at = [&](double x) { return plot_.x.logarithmic ? std::log(x) : x; };
    const double width = kCharacter * static_cast<double>(reference.name.size() + 1);
    const double extent = at(x_.high) - at(x_.low);
    const double from = extent > 0 ? (at(reference.low) - at(x_.low)) / extent : 0;
    const bool to_the_left = from + width > 1;
    const Span taken = to_the_left ? Span(from - width, from) : Span(from, from + width);
    const auto fits = [&](const std::vector<Span>& line) {
      return std::ranges::none_of(line, [&](const Span& other) {
        return other.first < taken.second && taken.first < other.second;
      });
    };
    auto line = std::ranges::find_if(names_, fits);
    if (line == names_.end()) line = names_.emplace(names_.end());
    line->push_back(taken);
    const auto down = static_cast<double>(line - names_.begin());
    return "first " + number_text(reference.low) + ", graph 1 " + (to_the_left ? "right" : "left") +
           " offset character 0, " + number_text(down == 0 ? 0.7 : 0.3 - down);
  }

  void given(const Reference& reference) {
    const std::string low = number_text(reference.low);
    const std::string high = number_text(reference.high);
    const bool guide = reference.role == Reference::Role::guide;
    const std::string ends = reference.of_x
                                 ? " from first " + low + ", graph 0 to first " + high + ", graph 1"
                                 : " from graph 0, first " + low + " to graph 1, first " + high;
    if (reference.low == reference.high) {
      line("set arrow" + ends + " nohead" + line_of(reference));
    } else {
      line("set object rectangle" + ends + " behind" + filling_of(reference));
    }
    if (guide && !reference.name.empty()) {
      line("set label " + gnuplot_text(reference.name) + " at " +
           (reference.of_x ? place_of_name(reference)
                           : "graph 0.99, first " + high + " right offset character 0, 0.5") +
           kGreyText);
    }
  }

  void what_is_drawn() {
    line("");
    line("# What is drawn; pick(i, value) is the value in rows of curve i, and nothing elsewhere");
    line("set datafile separator comma");
    line("data = '" + plot_.name + ".csv'");
    line("pick(i, value) = column(1) == i ? value : NaN");
    // Bands lie under everything else.
    for (const bool band : {true, false}) {
      for (std::size_t i = 0; i < plot_.curves.size(); ++i) {
        if ((plot_.curves[i].kind == Curve::Kind::band) == band) add_curve(i);
      }
    }
    for (std::size_t i = 0; i < plot_.references.size(); ++i) add_reference(i);
    if (elements_.empty()) add("NaN notitle");
    std::string text = "plot ";
    for (std::size_t i = 0; i < elements_.size(); ++i) {
      text += (i > 0 ? ", \\\n     " : "") + elements_[i];
    }
    plot_command_ = text;
  }

  void add(const std::string& element) { elements_.push_back(element); }

  static std::string title_of(const std::string& name) {
    return name.empty() ? " notitle" : " title " + gnuplot_text(name);
  }

  void add_curve(std::size_t i) {
    const Curve& curve = plot_.curves[i];
    const std::vector<PlotRow>& rows = rows_[i];
    const auto has = [&](double PlotRow::*end) {
      return std::ranges::any_of(rows, [end](const PlotRow& r) { return std::isfinite(r.*end); });
    };
    const bool x_bars = has(&PlotRow::x_low);
    const bool y_bars = has(&PlotRow::y_low);
    const bool of_points =
        curve.kind == Curve::Kind::points || curve.kind == Curve::Kind::line_points;
    const std::string axes = curve.second_axis && plot_.y2 ? " axes x1y2 " : " ";
    if (rows.empty()) {
      if (curve.name.empty()) return;
      add("NaN" + axes + with(curve, looks_[i], false, false) +
          title_of(curve.name + " (no values)"));
      return;
    }
    // All values are picked: gnuplot would count others in its ranges.
    const std::string id = std::to_string(kFirstCurve + static_cast<int>(i));
    const auto picked = [&](const std::string& value) {
      return "(pick(" + id + ", " + value + "))";
    };
    const std::string x = "data using " + picked("column(2)");
    if (curve.kind == Curve::Kind::band) {
      add(x + ":" + picked("column(6)") + ":" + picked("column(7)") + axes +
          with(curve, looks_[i], false, false) + title_of(curve.name));
      return;
    }
    // A point without a bar of its own gets one of no length, or it would not be drawn.
    const std::string bars_x = ":" + picked("end(4, 2)") + ":" + picked("end(5, 2)");
    const std::string bars_y = ":" + picked("end(6, 3)") + ":" + picked("end(7, 3)");
    const std::string bars = !of_points ? "" : x_bars ? bars_x + bars_y : y_bars ? bars_y : "";
    if (!bars.empty()) uses_bars_ = true;
    // In the legend stands the point alone: with its bar it would look like a line.
    add(x + ":" + picked("column(3)") + bars + axes +
        with(curve, looks_[i], of_points && x_bars, of_points && y_bars) +
        title_of(bars.empty() ? curve.name : std::string()));
    if (!bars.empty() && !curve.name.empty())
      add("NaN" + axes + with(curve, looks_[i], false, false) + title_of(curve.name));
  }

  // The line itself stands above; here are its place in the legend and its share in the range.
  void add_reference(std::size_t i) {
    const Reference& reference = plot_.references[i];
    const bool is_line = reference.low == reference.high;
    const std::string id = std::to_string(kFirstReference + static_cast<int>(i));
    const Extent& other = reference.of_x ? y_ : x_;
    const Axis& other_axis = reference.of_x ? plot_.y : plot_.x;
    const std::string place = number_text(
        other.empty() ? other_axis.low.value_or(other_axis.logarithmic ? 1 : 0) : other.low);
    const auto picked = [&](const std::string& value) {
      return "(pick(" + id + ", " + value + "))";
    };
    add("data using " +
        (reference.of_x ? picked("column(2)") + ":" + picked(place)
                        : picked(place) + ":" + picked("column(3)")) +
        " with lines lt nodraw notitle");
    if (reference.name.empty() || reference.role == Reference::Role::guide) return;
    add(std::string("NaN with ") +
        (is_line ? "lines" + line_of(reference) : "filledcurves" + filling_of(reference)) +
        title_of(reference.name));
  }

  void pictures() {
    if (uses_bars_) {
      line("# The end of a bar, or the point itself where it has none");
      line("end(bar, point) = valid(bar) ? column(bar) : column(point)");
    }
    line("");
    line("# Pictures");
    line(
        "set terminal pngcairo size 1600,1000 font 'Roboto,14' fontscale 2 linewidth 2 pointscale "
        "2 "
        "enhanced");
    line("set output '" + plot_.name + ".png'");
    line(plot_command_);
    line(
        "set terminal svg size 800,500 font 'Roboto,Helvetica,Arial,sans-serif,14' enhanced "
        "background rgb 'white'");
    line("set output '" + plot_.name + ".svg'");
    line("replot");
  }

  const Plot& plot_;
  std::vector<Look> looks_;
  std::vector<std::vector<PlotRow>> rows_;  // of each curve
  Extent x_, y_, y2_;
  std::vector<std::vector<Span>> names_;  // of guides, line by line
  std::vector<std::string> elements_;     // of the plot command
  std::string plot_command_;
  bool uses_bars_ = false;
  std::string script_;
};

}  // namespace

std::string plot_script(const Plot& plot) { return Script(plot).text(); }

}  // namespace quicksand
