// The gnuplot script of a plot: first how it looks, then what is drawn, then both pictures. What it looks like is in
// assets/plots/plot.gp; here is what it shows.
#include <algorithm>
#include <cmath>
#include <string>
#include <utility>
#include <vector>

#include "app/json/json_reader.h"
#include "app/plot/plot.h"
#include "app/plot/plot_axis.h"
#include "app/plot/plot_legend.h"
#include "app/plot/plot_pieces.h"
#include "app/plot/plot_rows.h"
#include "app/plot/report_text.h"
#include "core/base/format.h"
#include "render/base/palette.h"

namespace quicksand {

namespace {

std::string style_sheet(Colour colour) {
  return format("#%02X%02X%02X", colour.r, colour.g, colour.b);
}

class Script {
 public:
  explicit Script(const Plot& plot) : plot_(plot) {
    choose_looks();
    for (const Curve& curve : plot.curves) {
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
    place_names();
    layout_ = plot_layout(plot, legend_names(), lines_of_names_);
  }

  std::string text() {
    PlotPieces::Values head{{"name", plot_.name}, {"borders", plot_.y2 ? "11" : "3"}};
    for (std::size_t i = 0; i < kStyles; ++i)
      head["colour_" + std::to_string(i + 1)] = style_sheet(kCurveColours[i]);
    add("head", head);
    constexpr double kTitleDown = 0.4;  // from where it would stand [characters]
    if (!plot_.title.empty())
      add("title", {{"title", gnuplot_text(plot_.title)},
                    {"up", number_text(static_cast<double>(lines_of_names_) - kTitleDown)}});
    add("margins", {{"top", number_text(layout_.top)}, {"bottom", number_text(layout_.bottom)}});
    if (layout_.left > 0) add("left_margin", {{"left", number_text(layout_.left)}});
    constexpr std::string_view kPlaces[] = {"below", "top_left", "bottom_right"};
    add(layout_.legend ? "legend_" + std::string(kPlaces[static_cast<int>(plot_.legend)])
                       : "no_legend",
        {{"rows", std::to_string(layout_.rows)}, {"top", number_text(layout_.legend_top)}});
    axis("x", plot_.x, x_);
    add("x_axis");
    axis("y", plot_.y, y_);
    if (plot_.y2) {
      axis("y2", *plot_.y2, y2_);
      add("y2_axis");
    }
    for (std::size_t i = 0; i < plot_.references.size(); ++i) given(i);
    for (const Annotation& a : plot_.annotations)
      add("annotation", {{"text", gnuplot_text(a.text)},
                         {"x", number_text(a.x)},
                         {"y", number_text(a.y)},
                         {"side", a.left ? "right" : "left"},
                         {"aside", a.left ? "-0.6" : "0.6"},
                         {"up", a.below ? "-0.8" : "0.6"}});
    add("data", {{"name", plot_.name},
                 {"elements", elements()},
                 {"width", number_text(plot_.width)},
                 {"height", number_text(layout_.height)},
                 {"double_width", number_text(2 * plot_.width)},
                 {"double_height", number_text(2 * layout_.height)}});
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
    const bool upright = name != "x";
    const auto label = axis_label(axis, upright ? plot_.graph_height : plot_.width);
    // gnuplot reserves the room of all lines, but would centre them where one would stand.
    constexpr double kLine = 1.2;  // [widths of a character]
    const auto lines = static_cast<double>(label.size());
    const double aside = kLine * (name == "y2" ? lines - 1 : 1 - lines);
    PlotPieces::Values values{{"axis", name},
                              {"label", joined(label, " . \"\\n\" . ")},
                              {"aside", number_text(upright ? aside : 0)},
                              {"range", axis_range(axis, extent)}};
    add("axis", values);
    if (axis.logarithmic) add("logarithmic", values);
    switch (tics_of(axis, extent)) {
      case Tics::plain:
        return add("plain", values);
      case Tics::scientific:
        return add("scientific", values);
      case Tics::powers:
        return add("powers", values);
      case Tics::many_powers:
        add("powers", values);
        return add("many_decades", values);
      case Tics::listed:
        values["places"] = tic_list(axis, extent);
        return add("places", values);
    }
  }

  using Span = std::pair<double, double>;  // from and to, over the graph's width

  // Where the name of a guide stands above the graph.
  struct NamePlace {
    bool left = false;  // of its line, and not right
    std::size_t line = 0;
  };

  // Right of its line or, where it would leave the picture, left of it; where others stand already, in as many lines
  // above them as needed.
  void place_names() {
    constexpr double kCharacter = 0.015;  // about its width, over the graph's
    const auto at = [&](double x) { return plot_.x.logarithmic ? std::log(x) : x; };
    const double extent = at(x_.high) - at(x_.low);
    std::vector<std::vector<Span>> lines;
    for (const Reference& reference : plot_.references) {
      NamePlace& place = name_places_.emplace_back();
      if (!is_named_guide(reference) || !reference.of_x) continue;
      const double width = kCharacter * static_cast<double>(reference.name.size() + 1);
      const double from = extent > 0 ? (at(reference.low) - at(x_.low)) / extent : 0;
      place.left = from + width > 1;
      const Span taken = place.left ? Span(from - width, from) : Span(from, from + width);
      const auto fits = [&](const std::vector<Span>& line) {
        return std::ranges::none_of(line, [&](const Span& other) {
          return other.first < taken.second && taken.first < other.second;
        });
      };
      auto line = std::ranges::find_if(lines, fits);
      place.line = static_cast<std::size_t>(line - lines.begin());
      if (line == lines.end()) line = lines.emplace(lines.end());
      line->push_back(taken);
    }
    lines_of_names_ = lines.size();
  }

  static bool is_named_guide(const Reference& reference) {
    return reference.role == Reference::Role::guide && !reference.name.empty();
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

  void given(std::size_t i) {
    const Reference& reference = plot_.references[i];
    PlotPieces::Values values = values_of(reference);
    const std::string axis = reference.of_x ? "x_" : "y_";
    add(axis + form_of(reference), values);
    if (!is_named_guide(reference)) return;
    constexpr double kUp = 0.7;  // of the lowest line [characters]
    values["side"] = name_places_[i].left ? "right" : "left";
    values["up"] = number_text(kUp + static_cast<double>(name_places_[i].line));
    add(axis + "name", values);
  }

  static bool is_background(const Curve& curve) {
    return curve.kind == Curve::Kind::band || curve.kind == Curve::Kind::boxes ||
           curve.kind == Curve::Kind::dots;
  }

  // Of the plot command.
  std::string elements() {
    std::vector<std::string> all;
    for (const bool background : {true, false})
      for (std::size_t i = 0; i < plot_.curves.size(); ++i)
        if (is_background(plot_.curves[i]) == background) add_curve(i, all);
    for (std::size_t i = 0; i < plot_.references.size(); ++i) add_reference(i, all);
    if (all.empty()) all.emplace_back("NaN notitle");
    return joined(all, ", \\\n     ");
  }

  std::string title_of(const std::string& name) const {
    return name.empty() ? " notitle" : " title " + gnuplot_text(legend_name(name, plot_.width));
  }

  // What stands in the legend, in its order.
  std::vector<std::string> legend_names() const {
    std::vector<std::string> names;
    for (std::size_t i = 0; i < plot_.curves.size(); ++i)
      if (!plot_.curves[i].name.empty() && !rows_[i].empty())
        names.push_back(legend_name(plot_.curves[i].name, plot_.width));
    for (const Reference& reference : plot_.references)
      if (reference.role != Reference::Role::guide && !reference.name.empty())
        names.push_back(reference.name);
    return names;
  }

  // Place of each curve among those of its role. A fit has that of the curve before it, and its colour.
  void choose_looks() {
    std::size_t ours = 0, papers = 0;
    for (const Curve& curve : plot_.curves)
      if (curve.style && curve.role == Curve::Role::ours) ours = std::max(ours, *curve.style + 1);
    Look last;
    for (const Curve& curve : plot_.curves) {
      Look look{.colour = curve.colour};
      if (curve.role == Curve::Role::paper)
        look.place = curve.style ? *curve.style : papers++;
      else if (curve.role == Curve::Role::fit && any_of_ours_)
        look = last;
      else
        look.place = curve.style ? *curve.style : ours++;
      looks_.push_back(look);
      if (curve.role == Curve::Role::paper) continue;
      last = look;
      any_of_ours_ = true;
    }
  }

  // How curve `i` is drawn, told from the others: past the last colour with another dash, another marker, and open.
  std::string look_of(std::size_t i, const std::string& kind) const {
    const Curve& curve = plot_.curves[i];
    const bool of_paper = curve.role == Curve::Role::paper;
    const auto [place, own_colour] = looks_[i];
    const std::size_t round = place / kStyles;
    const auto nth = [](std::size_t n) { return "_" + std::to_string(n % kStyles + 1); };
    const std::string colour = own_colour ? "lc rgb '" + style_sheet(*own_colour) + "'"
                               : of_paper ? "@paper"
                                          : "@ours" + nth(place);
    const bool open = of_paper || curve.open || round % 2 == 1;
    constexpr std::size_t kPaperDashes = 3;
    constexpr std::size_t kFitDashes = 2;
    const std::string dash =
        of_paper ? "paper_dash_" + std::to_string(place % kPaperDashes + 1)
        : curve.role == Curve::Role::fit
            ? "fit_dash_" + std::to_string(curve.style.value_or(0) % kFitDashes + 1)
            : "dash" + nth(place + round);
    return pieces_.fill(kind, {{"colour", colour},
                               {"marker", (open ? "open" : "filled") + nth(place + round)},
                               {"dash", dash}});
  }

  void add_curve(std::size_t i, std::vector<std::string>& all) const {
    const Curve& curve = plot_.curves[i];
    if (rows_[i].empty()) return;
    const bool of_points =
        curve.kind == Curve::Kind::points || curve.kind == Curve::Kind::line_points;
    const std::string axes = curve.second_axis && plot_.y2 ? " axes x1y2 " : " ";
    constexpr std::string_view kKinds[] = {"points", "line",  "line_points", "steps",
                                           "band",   "boxes", "dots"};
    const std::string kind(kKinds[static_cast<int>(curve.kind)]);
    const auto has = [&](double PlotRow::*end) {
      return std::ranges::any_of(rows_[i], [&](const PlotRow& r) { return std::isfinite(r.*end); });
    };
    // All values are picked: gnuplot would count others in its ranges.
    const auto picked = [&](const char* piece) {
      return pieces_.fill(piece, {{"id", std::to_string(kFirstCurve + static_cast<int>(i))}});
    };
    const std::string place = picked("x") + picked("y");
    const std::string end = axes + look_of(i, kind) + title_of(curve.name);
    if (curve.kind == Curve::Kind::band) {
      all.push_back(picked("x") + picked("y_of_band") + end);
    } else if (curve.kind == Curve::Kind::boxes) {
      all.push_back(place + picked("ends_x") + picked("ends_y") + end);
    } else {
      // Bars lie under their points, and not in the legend, where they would look like lines.
      if (of_points && has(&PlotRow::x_low))
        all.push_back(place + picked("ends_x") + axes + look_of(i, "x_bars") + " notitle");
      if (of_points && has(&PlotRow::y_low))
        all.push_back(place + picked("ends_y") + axes + look_of(i, "y_bars") + " notitle");
      all.push_back(place + end);
    }
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
  struct Look {
    std::size_t place = 0;
    std::optional<Colour> colour{};  // in lieu of that of the place
  };
  std::vector<Look> looks_;  // of each curve
  bool any_of_ours_ = false;
  std::vector<std::vector<PlotRow>> rows_;  // of each curve
  Extent x_, y_, y2_;
  PlotLayout layout_;
  std::vector<NamePlace> name_places_;  // of each reference
  std::size_t lines_of_names_ = 0;
  std::string script_;
};

}  // namespace

std::string plot_script(const Plot& plot) { return Script(plot).text(); }

}  // namespace quicksand
