#include "app/targets/comparison.h"

#include <cmath>

#include "app/plot/typeset_number.h"
#include "core/measures/linear_fit.h"

namespace quicksand {

namespace {

std::string with_unit(const std::string& number, const std::string& unit) {
  const std::string brackets = typeset_unit(unit);
  return brackets.empty() ? number : number + " " + brackets;
}

// Two runs give an error, but with one degree of freedom no measure of what is far.
bool has_scatter(const Measured& measured) {
  constexpr int kFewest = 3;
  return measured.standard_error && *measured.standard_error > 0 && measured.n >= kFewest;
}

std::string with_sign(double value) { return (value > 0 ? "+" : "") + typeset(value, 3); }

// From the paper's value or the nearest bound: "+0.08 (12 se), 0.06 beyond the tolerance".
std::string deviation_text(const Measured& measured, const Verdict& verdict) {
  if (verdict.deviation == 0) return "none";
  std::string text = with_sign(verdict.deviation);
  if (has_scatter(measured)) {
    text += " (" + typeset(std::abs(verdict.deviation) / *measured.standard_error, 2) + " se)";
  }
  if (!verdict.inside) text += ", " + typeset(verdict.beyond, 3) + " beyond the tolerance";
  return text;
}

std::string ours_text(const Measured& measured) {
  return typeset_with_error(measured.value, measured.standard_error) +
         " (n = " + std::to_string(measured.n) + ")";
}

std::string quantity_text(const Target& target) {
  std::string text = target.quantity;
  if (!target.symbol.empty()) text += ", " + target.symbol;
  return with_unit(text, target.unit);
}

std::string tolerance_text(const Target& target) {
  return target.tolerance == 0 ? "none" : "± " + typeset(target.tolerance, 3);
}

// What a reader needs besides: how words became a bound, what the measurement was, and where the paper
// says so.
std::string remarks(const Target& target, const std::string& note, bool close) {
  std::string text;
  for (const std::string& part :
       {target.because, note, std::string(close ? "less than 2 se from turning" : ""),
        target.source}) {
    if (!part.empty()) text += (text.empty() ? "" : "; ") + part;
  }
  return text;
}

}  // namespace

Measured measured_over(std::span<const double> values, std::string note) {
  const Mean mean = *mean_of(values);
  return {mean.value, mean.error, static_cast<int>(values.size()), std::move(note)};
}

Verdict verdict_on(const Target& target, const Measured& measured) {
  Verdict verdict;
  if (std::isnan(measured.value)) return verdict;
  if (target.low && measured.value < *target.low) verdict.deviation = measured.value - *target.low;
  if (target.high && measured.value > *target.high) {
    verdict.deviation = measured.value - *target.high;
  }
  // Sums of decimals: a value at the tolerance's end is inside.
  constexpr double kRounding = 1e-12;
  const double distance = std::abs(verdict.deviation);
  verdict.inside = distance <= target.tolerance + kRounding * std::abs(measured.value);
  if (!verdict.inside) verdict.beyond = distance - target.tolerance;
  // The nearest end of what is still inside.
  double to_turn = HUGE_VAL;
  if (target.low) {
    to_turn = std::min(to_turn, std::abs(measured.value - (*target.low - target.tolerance)));
  }
  if (target.high) {
    to_turn = std::min(to_turn, std::abs(measured.value - (*target.high + target.tolerance)));
  }
  verdict.close = has_scatter(measured) && to_turn < 2 * *measured.standard_error;
  return verdict;
}

std::string paper_text(const Target& target) {
  std::string text;
  if (target.low && target.high) {
    text = typeset(*target.low);
    if (*target.low != *target.high) text += " to " + typeset(*target.high);
  } else {
    text = target.low ? "at least " + typeset(*target.low) : "at most " + typeset(*target.high);
  }
  return target.words.empty() ? text : target.words + ": " + text;
}

Table comparison_table(const PaperTargets& targets,
                       const std::map<std::string, Measured>& measured) {
  for (const auto& [id, value] : measured) targets.at(id);
  Table table{.caption =
                  "se: standard error of the mean over n realizations. Inside means: within the "
                  "stated tolerance of what the paper admits, whatever the standard error. The "
                  "deviation is from the paper's value or nearest bound, in se from three runs on.",
              .columns = {{.title = "quantity"},
                          {.title = "paper"},
                          {.title = "tolerance", .number = true},
                          {.title = "ours ± standard error", .number = true},
                          {.title = "verdict"},
                          {.title = "deviation"},
                          {.title = "remarks"}}};
  for (const Target& target : targets.targets) {
    std::vector<Cell> row{{quantity_text(target)}, {paper_text(target)}, {tolerance_text(target)}};
    const auto found = measured.find(target.id);
    if (found == measured.end()) {
      row.insert(row.end(),
                 {{}, {"not measured", Cell::Mark::undecided}, {}, {remarks(target, {}, false)}});
    } else {
      const Verdict verdict = verdict_on(target, found->second);
      row.insert(row.end(), {{ours_text(found->second)},
                             {verdict.inside ? "inside" : "outside",
                              verdict.inside ? Cell::Mark::inside : Cell::Mark::outside},
                             {deviation_text(found->second, verdict)},
                             {remarks(target, found->second.note, verdict.close)}});
    }
    table.rows.push_back(std::move(row));
  }
  return table;
}

Tally tally(const PaperTargets& targets, const std::map<std::string, Measured>& measured) {
  Tally counts;
  for (const Target& target : targets.targets) {
    const auto found = measured.find(target.id);
    if (found == measured.end()) {
      ++counts.not_measured;
    } else {
      ++(verdict_on(target, found->second).inside ? counts.inside : counts.outside);
    }
  }
  return counts;
}

}  // namespace quicksand
