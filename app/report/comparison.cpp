#include "app/report/comparison.h"

#include <cmath>

#include "app/report/typeset_number.h"
#include "core/linear_fit.h"

namespace quicksand {

namespace {

std::string with_unit(const std::string& number, const std::string& unit) {
  const std::string brackets = typeset_unit(unit);
  return brackets.empty() ? number : number + " " + brackets;
}

std::string with_sign(double value) { return (value > 0 ? "+" : "") + typeset(value, 3); }

std::string verdict_text(const Target& target, const Measured& measured, const Verdict& verdict) {
  std::string text = verdict.inside ? "inside" : "outside";
  if (verdict.deviation != 0) {
    const bool value = target.low && target.high && *target.low == *target.high;
    text += ": " + with_sign(verdict.deviation) + (value ? " from the paper" : " past the bound");
    if (measured.standard_error && *measured.standard_error > 0) {
      text += ", " + typeset(std::abs(verdict.deviation) / *measured.standard_error, 2) + " se";
    }
  }
  if (!verdict.inside) text += "; " + typeset(verdict.beyond, 3) + " past the tolerance";
  if (verdict.close) text += " (less than 2 se from turning)";
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

// What a reader needs besides: how words became a bound, and what the measurement was.
std::string note_text(const Target& target, const std::string& note) {
  std::string text = target.because;
  if (!note.empty()) text += (text.empty() ? "" : ". ") + note;
  return text;
}

}  // namespace

Measured measured_over(std::span<const double> values, std::string note) {
  const Mean mean = *mean_of(values);
  return {mean.value, mean.error, static_cast<int>(values.size()), std::move(note)};
}

Verdict judge(const Target& target, const Measured& measured) {
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
  verdict.close = measured.standard_error && to_turn < 2 * *measured.standard_error;
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
                  "stated tolerance of what the paper admits, whatever the standard error.",
              .columns = {{.title = "quantity"},
                          {.title = "paper", .number = true},
                          {.title = "tolerance", .number = true},
                          {.title = "ours ± standard error", .number = true},
                          {.title = "verdict"},
                          {.title = "note"},
                          {.title = "source"}}};
  for (const Target& target : targets.targets) {
    std::vector<Cell> row{{quantity_text(target)}, {paper_text(target)}, {tolerance_text(target)}};
    const auto found = measured.find(target.id);
    if (found == measured.end()) {
      row.insert(row.end(), {{}, {"not measured", Cell::Mark::undecided}, {note_text(target, {})}});
    } else {
      const Verdict verdict = judge(target, found->second);
      row.insert(row.end(), {{ours_text(found->second)},
                             {verdict_text(target, found->second, verdict),
                              verdict.inside ? Cell::Mark::inside : Cell::Mark::outside},
                             {note_text(target, found->second.note)}});
    }
    row.push_back({target.source});
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
      ++(judge(target, found->second).inside ? counts.inside : counts.outside);
    }
  }
  return counts;
}

}  // namespace quicksand
