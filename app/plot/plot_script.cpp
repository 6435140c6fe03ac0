// The gnuplot script of a plot: first how it looks, then what is drawn, then both pictures. What it looks like is in
// assets/plots/plot.gp; here is what it shows.
#include <algorithm>
#include <cmath>
#include <string>
#include <utility>
#include <vector>

#include "app/json/json_reader.h"
#include "app/plot/plot.h"
#include "app/plot/plot_pieces.h"
#include "app/plot/plot_rows.h"
#include "app/plot/report_text.h"
#include "app/plot/typeset_number.h"
#include "core/base/format.h"
#include "render/base/palette.h"

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
  if (!(to > from) || (axis.logarithmic && from <= 0))
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

std::string style_sheet(Colour colour) {
  return format("#%02X%02X%02X", colour.r, colour.g, colour.b);
}

class Script {
 public:
  explicit Script(const Plot& plot) : plot_(plot) {
    std::size_t ours = 0, papers = 0;
    for (const Curve& curve : plot.curves) {
      const bool of_paper = curve.role == Curve::Role::paper;
      const bool fits = curve.role == Curve::Role::fit && ours > 0;  // the curve before it
      places_.push_back(of_paper ? papers++ : fits ? ours - 1 : ours++);
      rows_.push_back(rows_of(plot, curve));
      for (const PlotRow& row : rows_.back()) {
        for (const double value : {row.x, row.x_low, row.x_high}) x_.add(value, plot.x);
        const bool second = curve.second_axis && plot.y2;
        for (const double value : {row.y, row.y_low, row.y_high})
          second ? y2_.add(value, *plot.y2) : y_.add(value, plot.y);
      }
    }
    for (const Reference& reference : plot.references) {
      for (const double end : {reference.low, reference.high})
        reference.of_x ? x_.add(end, plot.x) : y_.add(end, plot.y);
    }
    make_room_for_labels();
  }

  std::string text() {
    PlotPieces::Values head{{"name", plot_.name}, {"borders", plot_.y2 ? "11" : "3"}};
    for (std::size_t i = 0; i < kStyles; ++i)
      head["colour_" + std::to_string(i + 1)] = style_sheet(kCurveColours[i]);
    add("head", head);
    if (!plot_.title.empty()) add("title", {{"title", gnuplot_text(plot_.title)}});
    constexpr std::string_view kPlaces[] = {"below", "top_left", "bottom_right"};
    add("legend_" + std::string(kPlaces[static_cast<int>(plot_.legend)]));
    axis("x", plot_.x, x_);
    add("x_axis");
    axis("y", plot_.y, y_);
    if (plot_.y2) {
      axis("y2", *plot_.y2, y2_);
      add("y2_axis");
    }
    for (const Reference& reference : plot_.references) given(reference);
    for (const Annotation& a : plot_.annotations)
      add("annotation", {{"text", gnuplot_text(a.text)},
                         {"x", number_text(a.x)},
                         {"y", number_text(a.y)},
                         {"up", a.below ? "-0.8" : "0.6"}});
    add("data", {{"name", plot_.name}, {"elements", elements()}});
    return script_;
  }

 private:
  // So that none of them lies on the axis below or above.
  void make_room_for_labels() {
    constexpr double kHeight = 0.12;  // of a label and its distance, of the extent
    const Extent points = y_;
    for (const Annotation& a : plot_.annotations) {
      const double up = a.below ? -kHeight : kHeight;
      y_.add(plot_.y.logarithmic ? a.y * std::pow(points.high / points.low, up)
                                 : a.y + up * (points.high - points.low),
             plot_.y);
    }
  }

  void add(const std::string& piece, const PlotPieces::Values& values = {}) {
    script_ += pieces_.fill(piece, values) + "\n";
  }

  void axis(const std::string& name, const Axis& axis, const Extent& extent) {
    PlotPieces::Values values{
        {"axis", name}, {"label", label_of(axis)}, {"range", range_of(axis, extent)}};
    add("axis", values);
    if (!axis.logarithmic) return;
    add("logarithmic", values);
    // Small tics between decades only where decades are few.
    constexpr double kManyDecades = 1e6;
    if (extent.high > kManyDecades * extent.low) add("many_decades", values);
    // Over one or two decades powers of ten would name a place or two.
    constexpr double kFewDecades = 100, kFewDigits = 1e-3, kManyDigits = 1e4;
    if (!extent.empty() && extent.high < kFewDecades * extent.low) {
      values["places"] = short_logarithmic(extent);
      add("places", values);
    } else if (extent.empty() || extent.low < kFewDigits || extent.high > kManyDigits) {
      add("powers", values);
    }
  }

  using Span = std::pair<double, double>;  // from and to, over the graph's width

  // The name of a guide stands above the graph, to the right of its line or, where it would leave the picture,
  // to the left; where others stand there already inside the graph, as many lines down as needed.
  void place_name(const Reference& reference, PlotPieces::Values& values) {
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
    values["side"] = to_the_left ? "right" : "left";
    values["up"] = number_text(down == 0 ? 0.7 : 0.3 - down);
  }

  static PlotPieces::Values values_of(const Reference& reference) {
    return {{"name", gnuplot_text(reference.name)},
            {"low", number_text(reference.low)},
            {"high", number_text(reference.high)},
            {"role", reference.role == Reference::Role::guide ? "guide" : "paper"}};
  }

  static std::string form_of(const Reference& reference) {
    return reference.low == reference.high ? "line" : "band";
  }

  void given(const Reference& reference) {
    PlotPieces::Values values = values_of(reference);
    const std::string axis = reference.of_x ? "x_" : "y_";
    add(axis + form_of(reference), values);
    if (reference.role != Reference::Role::guide || reference.name.empty()) return;
    if (reference.of_x) place_name(reference, values);
    add(axis + "name", values);
  }

  // Of the plot command.
  std::string elements() {
    // Bands lie under everything else.
    std::vector<std::string> all;
    for (const bool band : {true, false})
      for (std::size_t i = 0; i < plot_.curves.size(); ++i)
        if ((plot_.curves[i].kind == Curve::Kind::band) == band) add_curve(i, all);
    for (std::size_t i = 0; i < plot_.references.size(); ++i) add_reference(i, all);
    if (all.empty()) all.emplace_back("NaN notitle");
    return joined(all, ", \\\n     ");
  }

  static std::string title_of(const std::string& name) {
    return name.empty() ? " notitle" : " title " + gnuplot_text(name);
  }

  // How curve `i` is drawn, told from the others.
  std::string look_of(std::size_t i, const std::string& bars) const {
    const Curve& curve = plot_.curves[i];
    const bool of_paper = curve.role == Curve::Role::paper;
    const std::string number = "_" + std::to_string(places_[i] % kStyles + 1);
    constexpr std::string_view kKinds[] = {"points", "line", "line_points", "steps", "band"};
    return pieces_.fill(std::string(kKinds[static_cast<int>(curve.kind)]),
                        {{"colour", of_paper ? "paper" : "ours" + number},
                         {"marker", (of_paper ? "open" : "filled") + number},
                         {"dash", of_paper                         ? "paper_dash"
                                  : curve.role == Curve::Role::fit ? "fit_dash"
                                                                   : "dash" + number},
                         {"bars", bars}});
  }

  void add_curve(std::size_t i, std::vector<std::string>& all) const {
    const Curve& curve = plot_.curves[i];
    const bool lines = curve.kind == Curve::Kind::line_points;
    const bool of_points = curve.kind == Curve::Kind::points || lines;
    const std::string axes = curve.second_axis && plot_.y2 ? " axes x1y2 " : " ";
    const std::string alone = axes + look_of(i, lines ? "linespoints" : "points");
    if (rows_[i].empty()) {
      if (!curve.name.empty()) all.push_back("NaN" + alone + title_of(curve.name + " (no values)"));
      return;
    }
    const auto has = [&](double PlotRow::*end) {
      return std::ranges::any_of(rows_[i], [&](const PlotRow& r) { return std::isfinite(r.*end); });
    };
    // All values are picked: gnuplot would count others in its ranges.
    const auto picked = [&](const char* piece) {
      return pieces_.fill(piece, {{"id", std::to_string(kFirstCurve + static_cast<int>(i))}});
    };
    if (curve.kind == Curve::Kind::band) {
      all.push_back(picked("x") + picked("y_of_band") + alone + title_of(curve.name));
      return;
    }
    const bool x_bars = of_points && has(&PlotRow::x_low);
    if (!x_bars && !(of_points && has(&PlotRow::y_low))) {
      all.push_back(picked("x") + picked("y") + alone + title_of(curve.name));
      return;
    }
    // A point without a bar of its own gets one of no length, or it would not be drawn. In the legend stands the point
    // alone: with its bar it would look like a line.
    const std::string bars =
        std::string(x_bars ? "xyerror" : "yerror") + (lines ? "lines" : "bars");
    all.push_back(picked("x") + picked("y") + (x_bars ? picked("ends_x") : "") + picked("ends_y") +
                  axes + look_of(i, bars) + " notitle");
    if (!curve.name.empty()) all.push_back("NaN" + alone + title_of(curve.name));
  }

  // The line itself stands above; here are its place in the legend and its share in the range.
  void add_reference(std::size_t i, std::vector<std::string>& all) const {
    const Reference& reference = plot_.references[i];
    const Extent& other = reference.of_x ? y_ : x_;
    const Axis& other_axis = reference.of_x ? plot_.y : plot_.x;
    const double place =
        other.empty() ? other_axis.low.value_or(other_axis.logarithmic ? 1 : 0) : other.low;
    all.push_back(pieces_.fill(reference.of_x ? "share_x" : "share_y",
                               {{"id", std::to_string(kFirstReference + static_cast<int>(i))},
                                {"place", number_text(place)}}));
    if (reference.role != Reference::Role::guide && !reference.name.empty())
      all.push_back(pieces_.fill("key_" + form_of(reference), values_of(reference)));
  }

  static constexpr std::size_t kStyles = kCurveColours.size();

  const Plot& plot_;
  PlotPieces pieces_;
  std::vector<std::size_t> places_;         // of each curve, among those of its role
  std::vector<std::vector<PlotRow>> rows_;  // of each curve
  Extent x_, y_, y2_;
  std::vector<std::vector<Span>> names_;  // of guides, line by line
  std::string script_;
};

}  // namespace

std::string plot_script(const Plot& plot) { return Script(plot).text(); }

}  // namespace quicksand
