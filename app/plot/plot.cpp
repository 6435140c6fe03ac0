#include "app/plot/plot.h"

#include <algorithm>
#include <cassert>
#include <cmath>

#include "app/json/json_reader.h"
#include "app/plot/plot_rows.h"
#include "app/plot/report_text.h"
#include "app/plot/typeset_number.h"
#include "core/base/whole_file.h"
#include "render/base/external_program.h"
#include "render/base/palette.h"

namespace quicksand {

namespace {

double at(const std::vector<double>& values, std::size_t i) {
  return i < values.size() ? values[i] : std::nan("");
}

// What a logarithmic axis cannot show is left out.
bool shown(double value, const Axis& axis) {
  return std::isfinite(value) && (!axis.logarithmic || value > 0);
}

const Axis& y_axis_of(const Plot& plot, const Curve& curve) {
  return curve.second_axis && plot.y2 ? *plot.y2 : plot.y;
}

// Of what is drawn along one of the plot's axes, lower ends of bars and bands included.
double lowest_shown(const Plot& plot, const Axis& axis) {
  double lowest = HUGE_VAL;
  const auto look_at = [&](double value) {
    if (shown(value, axis)) lowest = std::min(lowest, value);
  };
  const bool of_x = &axis == &plot.x;
  for (const Curve& curve : plot.curves) {
    if (!of_x && &axis != &y_axis_of(plot, curve)) continue;
    const std::vector<double>& values = of_x ? curve.x : curve.y;
    for (std::size_t i = 0; i < values.size(); ++i) {
      look_at(values[i]);
      look_at(values[i] - at(of_x ? curve.x_error : curve.y_error, i));
    }
    std::ranges::for_each(of_x ? curve.x_low : curve.y_low, look_at);
    std::ranges::for_each(of_x ? curve.x_high : curve.y_high, look_at);
  }
  return lowest;
}

// The lower end of a bar or a band that reaches down to zero goes down as far as anything, that of a bar so far beneath
// its point that one sees it.
double shown_end(double low, double value, const Plot& plot, const Axis& axis) {
  if (!std::isfinite(low) || shown(low, axis)) return low;
  constexpr double kSeen = 0.5;  // of the value
  const double lowest = lowest_shown(plot, axis);
  return shown(value, axis) ? std::min(lowest, kSeen * value) : lowest;
}

std::string cell(double value) { return std::isfinite(value) ? number_text(value) : ""; }

std::string csv_row(int id, const PlotRow& row, const std::string& name) {
  std::string text = std::to_string(id);
  for (const double value : {row.x, row.y, row.x_low, row.x_high, row.y_low, row.y_high}) {
    text += "," + cell(value);
  }
  // What is empty is passed over; a line stops where a point is no number.
  if (id < kFirstReference && !std::isfinite(row.x)) text = std::to_string(id) + ",nan,nan,,,,";
  return text + "," + csv_text(name) + "\n";
}

}  // namespace

std::vector<PlotRow> rows_of(const Plot& plot, const Curve& curve) {
  const bool band = curve.kind == Curve::Kind::band;
  assert(band || curve.y.size() == curve.x.size());
  const Axis& y_axis = y_axis_of(plot, curve);
  std::vector<PlotRow> rows;
  for (std::size_t i = 0; i < curve.x.size(); ++i) {
    if (!rows.empty() && std::ranges::binary_search(curve.begins, i)) rows.emplace_back();
    PlotRow row{.x = curve.x[i], .y = at(curve.y, i)};
    row.x_low = at(curve.x_low, i);
    row.x_high = at(curve.x_high, i);
    row.y_low = at(curve.y_low, i);
    row.y_high = at(curve.y_high, i);
    const double dy = at(curve.y_error, i);
    if (std::isfinite(dy)) {
      row.y_low = row.y - dy;
      row.y_high = row.y + dy;
    }
    const double dx = at(curve.x_error, i);
    if (std::isfinite(dx)) {
      row.x_low = row.x - dx;
      row.x_high = row.x + dx;
    }
    const bool has_y =
        band ? std::isfinite(row.y_low) && shown(row.y_high, y_axis) : shown(row.y, y_axis);
    if (!shown(row.x, plot.x) || !has_y) continue;
    row.x_low = shown_end(row.x_low, row.x, plot, plot.x);
    row.y_low = shown_end(row.y_low, band ? PlotRow::kNone : row.y, plot, y_axis);
    rows.push_back(row);
  }
  return rows;
}

std::string plot_csv(const Plot& plot) {
  std::string csv = "id,x,y,x_low,x_high,y_low,y_high,name\n";
  int id = kFirstCurve;
  for (const Curve& curve : plot.curves) {
    for (const PlotRow& row : rows_of(plot, curve)) csv += csv_row(id, row, curve.name);
    ++id;
  }
  id = kFirstReference;
  for (const Reference& reference : plot.references) {
    for (const double value : {reference.low, reference.high}) {
      PlotRow row;
      (reference.of_x ? row.x : row.y) = value;
      csv += csv_row(id, row, reference.name);
      if (reference.low == reference.high) break;
    }
    ++id;
  }
  return csv;
}

bool has_values(const Plot& plot) {
  return std::ranges::any_of(plot.curves, [&](const Curve& curve) {
    return curve.role != Curve::Role::paper && !rows_of(plot, curve).empty();
  });
}

std::size_t left_out(const Plot& plot) {
  std::size_t count = 0;
  for (const Curve& curve : plot.curves) {
    if (curve.kind == Curve::Kind::band) continue;
    const Axis& y_axis = y_axis_of(plot, curve);
    for (std::size_t i = 0; i < curve.x.size(); ++i)
      if (std::isfinite(curve.x[i]) && std::isfinite(curve.y[i]) &&
          !(shown(curve.x[i], plot.x) && shown(curve.y[i], y_axis)))
        ++count;
  }
  return count;
}

std::string description_of(const Plot& plot) {
  const auto axis = [](const Axis& a) {
    const std::string unit = typeset_unit(a.unit);
    return a.label + (unit.empty() ? "" : " " + unit) + (a.logarithmic ? " (logarithmic)" : "");
  };
  const bool lines = std::ranges::any_of(plot.curves, [](const Curve& curve) {
    return curve.role == Curve::Role::ours && curve.kind != Curve::Kind::points;
  });
  std::string text = lines ? "Lines" : "Points";
  if (!plot.y.names.empty()) {
    text += " in " + std::to_string(plot.y.names.size()) + " rows: " + axis(plot.x);
  } else {
    text += ": " + axis(plot.y) + (plot.y2 ? " and " + axis(*plot.y2) : "") + " against " +
            axis(plot.x);
  }
  std::string names;
  for (const Curve& curve : plot.curves)
    if (!curve.name.empty() && !rows_of(plot, curve).empty())
      names += (names.empty() ? "; " : ", ") + curve.name;
  return text + names;
}

void add_with_band(Plot& plot, Curve curve) {
  if (curve.kind == Curve::Kind::points) curve.kind = Curve::Kind::line_points;
  const bool scatters = std::ranges::any_of(curve.y_error, [](double error) { return error > 0; });
  if (curve.x.size() < 2 || !scatters) {
    plot.curves.push_back(std::move(curve));
    return;
  }
  std::vector<Curve> bands;  // one would cover where the line is interrupted
  for (std::size_t k = 0; k < curve.x.size(); ++k) {
    if (k == 0 || std::ranges::binary_search(curve.begins, k))
      bands.push_back(
          {.kind = Curve::Kind::band, .role = Curve::Role::fit, .second_axis = curve.second_axis});
    bands.back().x.push_back(curve.x[k]);
    bands.back().y_low.push_back(curve.y[k] - curve.y_error[k]);
    bands.back().y_high.push_back(curve.y[k] + curve.y_error[k]);
  }
  curve.y_error.clear();
  plot.curves.push_back(std::move(curve));
  std::ranges::move(bands, std::back_inserter(plot.curves));
}

std::vector<Colour> ordered_colours(std::size_t n) {
  constexpr double kPalest = 0.85;  // what is a line must be darker than what is an area
  std::vector<Colour> colours;
  for (std::size_t k = 0; k < n; ++k)
    colours.push_back(sequential_map(
        Theme::light, n > 1 ? kPalest * static_cast<double>(k) / static_cast<double>(n - 1) : 0));
  return colours;
}

std::vector<Colour> shades_of(Colour colour, std::size_t n) {
  constexpr double kPalest = 0.35;
  std::vector<Colour> shades;
  for (std::size_t k = 0; k < n; ++k)
    shades.push_back(
        mix(hex(0xFFFFFF), colour,
            kPalest + (1 - kPalest) * static_cast<double>(k + 1) / static_cast<double>(n)));
  return shades;
}

PlotFiles write_plot(const Plot& plot, const std::filesystem::path& folder) {
  assert(plot.name == file_name_text(plot.name));
  const auto file = [&](const char* extension) { return folder / (plot.name + extension); };
  write_whole(file(".csv"), plot_csv(plot));
  write_whole(file(".gp"), plot_script(plot));
  // No picture may stay that does not belong to this plot, nor half a one.
  const auto without_pictures = [&](const std::string& problem) {
    std::error_code ignored;
    for (const char* extension : {".png", ".svg"}) {
      std::filesystem::remove(file(extension), ignored);
    }
    return PlotFiles{false, problem};
  };
  without_pictures({});
  const ProgramEnd end = run_external({"gnuplot", plot.name + ".gp"}, folder);
  if (end.missing) {
    return without_pictures(
        "plots need gnuplot (package gnuplot-nox); their data and scripts have been written");
  }
  if (!end.fine()) {
    return without_pictures("gnuplot failed on " + plot.name + ".gp: " + end.problem);
  }
  for (const char* extension : {".png", ".svg"}) {
    if (!std::filesystem::exists(file(extension))) {
      return without_pictures("gnuplot wrote no " + plot.name + extension);
    }
  }
  return {true, {}};
}

}  // namespace quicksand
