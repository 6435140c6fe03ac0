// The table on standard output.
#include <algorithm>
#include <array>
#include <cstdio>

#include "tests/bench/results.h"
#include "tests/bench/statistics.h"

namespace quicksand::bench {

namespace {

constexpr const char* kColumns = "%-11s %-18s %-5s %7s %9s %9s %-4s %9s %9s %7s %8s %8s %8s %9s\n";

std::string number(const char* format, double value) {
  std::array<char, 32> text{};
  std::snprintf(text.data(), text.size(), format, value);
  return text.data();
}

std::string row(const std::array<std::string, 14>& c) {
  std::array<char, 320> text{};
  std::snprintf(text.data(), text.size(), kColumns, c[0].c_str(), c[1].c_str(), c[2].c_str(),
                c[3].c_str(), c[4].c_str(), c[5].c_str(), c[6].c_str(), c[7].c_str(), c[8].c_str(),
                c[9].c_str(), c[10].c_str(), c[11].c_str(), c[12].c_str(), c[13].c_str());
  return text.data();
}

double worst(const Figure& figure) {
  return figure.more_is_better ? std::ranges::min(figure.values) : std::ranges::max(figure.values);
}

// The velocity error that goes with a run: its own, or that of a problem of its state.
std::string velocity_error(const Outcome& outcome, const Run& run) {
  if (run.velocity_error) return number("%.1e", *run.velocity_error);
  for (const Run& solved : outcome.runs)
    if (solved.part == "solve") return number("%.1e", *solved.velocity_error);
  return "-";
}

}  // namespace

bool goal_met(const Figure& figure) {
  if (!figure.valid || figure.values.empty()) return false;
  const double middle = median(figure.values);
  return figure.more_is_better ? middle >= figure.goal : middle <= figure.goal;
}

std::string table_header() {
  return row({"case", "figure", "unit", "goal", "median", "worst", "met", "factoris.", "sweeps",
              "unconv.", "residual", "gap", "velocity", "over GS"}) +
         row({"", "", "", "", "", "", "", "per step", "per step", "", "[1]", "[d_c]", "[g dt]",
              "[times]"});
}

std::string table_rows(const Result& result, const Options& options) {
  if (!result.error.empty()) return row({result.name, "FAILED"});
  std::string text;
  const Outcome& outcome = result.outcome;
  for (const Figure& figure : outcome.figures) {
    const bool first = &figure == &outcome.figures.front();
    const std::string at_least = figure.at_least ? ">" : "";
    std::array<std::string, 14> c{first ? result.name : "",
                                  figure.what,
                                  figure.unit,
                                  number("%g", figure.goal),
                                  at_least + number("%.4g", median(figure.values)),
                                  at_least + number("%.4g", worst(figure)),
                                  options.quick      ? "-"
                                  : goal_met(figure) ? "yes"
                                                     : "no"};
    if (figure.run >= 0) {
      const Run& run = outcome.runs.at(static_cast<std::size_t>(figure.run));
      const auto steps = static_cast<double>(std::max<std::int64_t>(1, run.steps));
      c[7] = number("%.2f", static_cast<double>(run.factorisations) / steps);
      c[8] = number("%.4g", static_cast<double>(run.iterations) / steps);
      c[9] = std::to_string(run.unconverged);
      c[10] = number("%.1e", run.residual);
      c[11] = number("%.1e", run.gap_error);
      c[12] = velocity_error(outcome, run);
      if (outcome.over_gauss_seidel)
        c[13] = (outcome.over_gauss_seidel->at_least ? ">" : "") +
                number("%.4g", outcome.over_gauss_seidel->factor);
    }
    text += row(c);
  }
  return text;
}

std::string remarks(const Result& result) {
  std::string text;
  if (!result.error.empty()) text += result.name + ": " + result.error + "\n";
  for (const std::string& note : result.outcome.notes) text += result.name + ": " + note + "\n";
  return text;
}

}  // namespace quicksand::bench
