#include "app/targets/comparison.h"

#include <algorithm>
#include <cmath>

#include "app/json/fields.h"
#include "app/plot/typeset_number.h"
#include "core/base/format.h"
#include "core/measures/linear_fit.h"
#include "render/base/palette.h"

namespace quicksand {

namespace {

std::string with_unit(const std::string& text, const std::string& unit) {
  const std::string brackets = typeset_unit(unit);
  return brackets.empty() ? text : text + " " + brackets;
}

std::string quantity_text(const Target& target) {
  std::string text = target.quantity;
  if (!target.symbol.empty()) text += ", " + target.symbol;
  return with_unit(text, target.unit);
}

// "0.372 ± 0.004, n = 10", "0.372, n = 1 (error unknown)".
std::string ours_text(const Target& target, const Measured& measured) {
  std::string text = typeset_with_error(measured.value, measured.standard_error) +
                     ", n = " + std::to_string(measured.n);
  if (!target.counts.empty()) text += " " + target.counts;
  if (!measured.standard_error) text += " (error unknown)";
  return text + (measured.lower_box ? ", in a box of " + box_text(*measured.lower_box) : "");
}

// One method on one target.
struct ByMethod {
  std::string method;
  const Measured* measured = nullptr;  // null: not measured
  Verdict verdict{};

  std::string word() const {
    if (!measured) return "not measured";
    if (verdict.undecided) return "undecided";
    return !verdict.inside ? "outside" : verdict.by_error ? "inside by its error" : "inside";
  }
  bool outside() const { return measured && !verdict.inside && !verdict.undecided; }
};

std::vector<ByMethod> entries_of(const Target& target, const std::vector<MethodFindings>& methods) {
  std::vector<ByMethod> entries;
  for (const MethodFindings& method : methods) {
    ByMethod entry{.method = method.method};
    if (const auto found = method.findings.find(target.id); found != method.findings.end()) {
      entry.measured = &found->second;
      entry.verdict = verdict_on(target, found->second);
    }
    entries.push_back(entry);
  }
  return entries;
}

Cell number_cell(const Target& target, const ByMethod& entry, const std::filesystem::path& report) {
  if (!entry.measured) return {"not measured", Cell::Mark::undecided};
  Cell cell{ours_text(target, *entry.measured), entry.verdict.undecided ? Cell::Mark::undecided
                                                : entry.verdict.inside  ? Cell::Mark::inside
                                                                        : Cell::Mark::outside};
  if (const std::filesystem::path& from = entry.measured->report; !from.empty())
    cell.links.push_back(link_from(report, from, from.parent_path().filename().string()));
  return cell;
}

Cell inside_cell(const std::vector<ByMethod>& entries) {
  const bool alike = std::ranges::all_of(
      entries, [&](const ByMethod& e) { return e.word() == entries.front().word(); });
  if (alike)
    return {entries.size() == 2 && entries.front().measured ? "both " + entries.front().word()
                                                            : entries.front().word()};
  return {joined(entries, ", ", [](const ByMethod& entry) {
    return method_title(entry.method) + " " + entry.word();
  })};
}

Cell reason_cell(const Target& target, const std::vector<ByMethod>& entries,
                 const Evidence& evidence, const std::filesystem::path& report) {
  Cell cell;
  std::vector<const Reason*> given;
  for (const ByMethod& entry : entries) {
    if (!entry.outside()) continue;
    const Reason* reason = evidence.reason(target.id, entry.method);
    const std::string name = entries.size() > 1 ? method_title(entry.method) + ": " : "";
    if (reason && std::ranges::find(given, reason) != given.end()) continue;
    cell.text += (cell.text.empty() ? "" : " ") + (reason && reason->method.empty() ? "" : name) +
                 (reason ? reason->sentence : "No reason has been measured.");
    if (!reason) continue;
    if (std::ranges::find(given, reason->evidence, &Reason::evidence) == given.end())
      cell.links.push_back(evidence_link(reason->evidence, report));
    given.push_back(reason);
  }
  return cell;
}

}  // namespace

std::string box_text(const Vec2& size) {
  return number_text(size.x()) + " x " + number_text(size.y()) + " d";
}

Measured measured_over(std::span<const double> values, std::string note) {
  Mean mean = *mean_of(values);
  // Equal values scatter by no more than their rounding.
  constexpr double kRounding = 1e-14;
  if (mean.error && *mean.error <= kRounding * std::abs(mean.value))
    mean = {.value = values.front(), .error = 0};
  return {mean.value, mean.error, static_cast<int>(values.size()), std::move(note)};
}

std::optional<Measured> mean_over(std::span<const double> values, const std::string& note) {
  if (values.empty()) return std::nullopt;
  return measured_over(values, note);
}

void add_point(Curve& curve, double x, const std::optional<Measured>& y) {
  if (!y) return;
  curve.x.push_back(x);
  curve.y.push_back(y->value);
  curve.y_error.push_back(y->standard_error.value_or(0));
}

Cell cell_of(const std::optional<Measured>& measured, int all) {
  if (!measured) return {.text = "-"};
  const std::string runs = measured->n == all ? "" : " (" + std::to_string(measured->n) + ")";
  return {.text = typeset_with_error(measured->value, measured->standard_error) + runs};
}

std::string method_title(const std::string& method) { return method == "nscd" ? "NSCD" : method; }

Colour method_colour(const std::string& title) { return kCurveColours[title == "NSCD" ? 0 : 1]; }

Verdict verdict_on(const Target& target, const Measured& measured) {
  Verdict verdict;
  if (std::isnan(measured.value)) return verdict;
  if (target.low && measured.value < *target.low) verdict.deviation = measured.value - *target.low;
  if (target.high && measured.value > *target.high)
    verdict.deviation = measured.value - *target.high;
  const double error = measured.standard_error.value_or(0);
  // Sums of decimals: a value at the end is inside.
  constexpr double kRounding = 1e-12;
  const double off =
      std::abs(verdict.deviation) - target.half_digit - kRounding * std::abs(measured.value);
  if (off <= 0) {
    verdict.inside = true;
  } else if (off <= 2 * error) {
    constexpr double kLargestError = 0.25;  // relative
    const double number =
        std::max(std::abs(target.low.value_or(0)), std::abs(target.high.value_or(0)));
    verdict.undecided = error > kLargestError * number;
    verdict.inside = verdict.by_error = !verdict.undecided;
  }
  return verdict;
}

std::string paper_text(const Target& target) {
  std::string text = target.printed;
  if (text.empty() && target.low && target.high)
    text = typeset(*target.low) + " to " + typeset(*target.high);
  if (text.empty())
    text = target.low ? "at least " + typeset(*target.low) : "at most " + typeset(*target.high);
  return target.words.empty() ? text : target.words + " (read as " + text + ")";
}

Table comparison_table(const PaperTargets& targets, const std::vector<MethodFindings>& methods,
                       const Evidence& evidence, const std::filesystem::path& report) {
  const auto is_marked = [&](const Target& target) {
    return !target.chose.empty() &&
           (target.chose_of.empty() ||
            std::ranges::find(methods, target.chose_of, &MethodFindings::method) != methods.end());
  };
  std::string caption =
      "Mean ± standard error; n is the number of realizations unless stated otherwise. A value is "
      "inside if it lies within the paper's interval, or within half a unit of the last digit that "
      "the paper prints, widened by two of our standard errors. It is inside by its error if only "
      "this widening makes it so, and undecided if its error is then larger than a quarter of the "
      "paper's number. An unknown error widens nothing. Two standard errors on either side hold "
      "the true mean in 95 % of cases if n is large, in 92, 82 and 70 % if n is 10, 3 and 2.";
  std::vector<std::string> choices;
  for (const Target& target : targets.targets)
    if (is_marked(target) && std::ranges::find(choices, target.chose) == choices.end())
      choices.push_back(target.chose);
  if (!choices.empty())
    caption += " † This number was used to choose " + joined(choices, " or ") +
               ", so ours is not a prediction.";
  Table table{.caption = caption, .columns = {{.title = "experiment"}, {.title = "paper"}}};
  for (const MethodFindings& method : methods)
    table.columns.push_back({.title = method_title(method.method), .number = true});
  table.columns.insert(table.columns.end(),
                       {{.title = "inside or not"}, {.title = "if outside: what is known"}});
  for (const Target& target : targets.targets) {
    const std::vector<ByMethod> entries = entries_of(target, methods);
    std::vector<Cell> row{{quantity_text(target) + (is_marked(target) ? " †" : "")},
                          {paper_text(target)}};
    for (const ByMethod& entry : entries) row.push_back(number_cell(target, entry, report));
    row.push_back(inside_cell(entries));
    row.push_back(reason_cell(target, entries, evidence, report));
    table.rows.push_back(std::move(row));
  }
  return table;
}

Table reading_table(const PaperTargets& targets, const std::vector<MethodFindings>& methods) {
  Table table{.caption =
                  "How the paper's words were turned into bounds, where each of its numbers is "
                  "printed, and how our value was obtained.",
              .columns = {{.title = "experiment"},
                          {.title = "paper"},
                          {.title = "reading"},
                          {.title = "source"},
                          {.title = "ours"}}};
  for (const Target& target : targets.targets) {
    std::string notes;
    for (const ByMethod& entry : entries_of(target, methods))
      if (entry.measured && !entry.measured->note.empty())
        notes += (notes.empty() ? "" : "; ") +
                 (methods.size() > 1 ? method_title(entry.method) + ": " : "") +
                 entry.measured->note;
    if (target.because.empty() && notes.empty()) continue;
    table.rows.push_back({{quantity_text(target)},
                          {paper_text(target)},
                          {target.because},
                          {target.source},
                          {notes}});
  }
  return table;
}

Tally tally(const PaperTargets& targets, const Findings& findings) {
  for (const auto& [id, measured] : findings) targets.at(id);
  Tally counts;
  for (const Target& target : targets.targets) {
    const auto found = findings.find(target.id);
    if (found == findings.end()) {
      ++counts.not_measured;
      continue;
    }
    const Verdict verdict = verdict_on(target, found->second);
    ++(verdict.undecided ? counts.undecided : verdict.inside ? counts.inside : counts.outside);
  }
  return counts;
}

}  // namespace quicksand
