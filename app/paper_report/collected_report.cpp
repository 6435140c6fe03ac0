#include "app/paper_report/collected_report.h"

#include <algorithm>
#include <cmath>

#include "app/json/json_reader.h"
#include "app/paper/findings_file.h"
#include "app/paper_report/first_page.h"
#include "app/report/provenance.h"
#include "app/targets/share_pairs.h"
#include "core/base/format.h"

namespace quicksand {

namespace {

std::vector<MethodFindings> merged(const std::vector<std::filesystem::path>& files,
                                   const Vec2& box) {
  std::vector<MethodFindings> methods;
  for (const std::filesystem::path& file : files) {
    MethodFindings read = read_findings(file, box, OtherBoxes::named_if_lower);
    const auto known = std::ranges::find(methods, read.method, &MethodFindings::method);
    if (known == methods.end())
      methods.push_back(std::move(read));
    else
      known->findings.merge(read.findings);
  }
  return methods;
}

// What the paper's number is drawn as: one, of an interval its geometric mean.
double middle_of(const Target& target) { return std::sqrt(*target.low * *target.high); }

bool is_drawn(const Target& target) {
  return !target.short_name.empty() && target.low && target.high && *target.low > 0;
}

// Ours over the paper's: a row a quantity, from the top in the order of the table, below the name of its group.
class Agreement {
 public:
  Agreement(const PaperTargets& targets, const std::vector<MethodFindings>& methods) {
    for (const Target& target : targets.targets)
      if (is_drawn(target)) add_row(target);
    plot_.y.low = next_ + kHalf;
    plot_.graph_height = kRowHeight * (*plot_.y.high - *plot_.y.low);
    plot_.curves.push_back(paper_);
    for (std::size_t m = 0; m < methods.size(); ++m) {
      const double aside = kAside * (1 - 2 * static_cast<double>(m));
      for (const bool inside : {true, false}) add_points(methods[m], m, aside, inside);
    }
  }

  Plot take() { return std::move(plot_); }

 private:
  static constexpr double kHalf = 0.5, kAside = 0.17, kBand = 0.42;  // rows
  static constexpr double kRowHeight = 23, kWidth = 1200;            // [px]

  void add_row(const Target& target) {
    if (target.group != group_) {
      group_ = target.group;
      plot_.references.push_back(
          {.name = group_, .low = next_ - kHalf, .role = Reference::Role::guide});
      next_ -= 1;
    }
    plot_.y.names.emplace_back(next_, target.short_name + (target.chose.empty() ? "" : " †"));
    rows_.emplace_back(target, next_);
    const double middle = middle_of(target);
    const double low = (*target.low - target.half_digit) / middle;
    const double high = (*target.high + target.half_digit) / middle;
    paper_.x.push_back(1);
    paper_.y.push_back(next_);
    paper_.x_low.push_back(low);
    paper_.x_high.push_back(high);
    paper_.y_low.push_back(next_ - kBand);
    paper_.y_high.push_back(next_ + kBand);
    next_ -= 1;
  }

  void add_points(const MethodFindings& method, std::size_t style, double aside, bool inside) {
    const std::string title = method_title(method.method);
    Curve curve{.name = title + (inside ? ", inside" : ", outside"),
                .style = style,
                .colour = method_colour(title),
                .open = !inside};
    for (const auto& [target, row] : rows_) {
      const auto found = method.findings.find(target.id);
      if (found == method.findings.end()) continue;
      if (inside != verdict_on(target, found->second).inside) continue;
      const double middle = middle_of(target);
      curve.x.push_back(found->second.value / middle);
      curve.x_error.push_back(found->second.standard_error.value_or(0) / middle);
      curve.y.push_back(row + aside);
    }
    plot_.curves.push_back(std::move(curve));
  }

  Plot plot_{.name = "agreement",
             .x = {.label = "our number over the paper's", .logarithmic = true},
             .y = {.high = kHalf},
             .references = {{.low = 1, .of_x = true, .role = Reference::Role::guide}},
             .width = kWidth};
  Curve paper_{.name = "paper: last digit or interval",
               .kind = Curve::Kind::boxes,
               .role = Curve::Role::paper};
  std::string group_;
  double next_ = 0;  // row
  std::vector<std::pair<Target, double>> rows_;
};

// Ours after the same three pushes as the paper's, a line a method.
Plot pairs_of_shares(const PaperTargets& targets, const std::vector<MethodFindings>& methods) {
  Plot plot = share_pairs(targets, "pairs");
  for (const MethodFindings& method : methods) {
    const std::string title = method_title(method.method);
    Curve curve{.name = title, .kind = Curve::Kind::line_points, .colour = method_colour(title)};
    for (const auto& [force, text] : kPaperPushes) {
      const auto active = method.findings.find(push_target(force, "active_of_contacts")),
                 remaining = method.findings.find(push_target(force, "remaining_of_initial"));
      if (active == method.findings.end() || remaining == method.findings.end()) continue;
      add_point(curve, active->second.value, remaining->second);
      curve.x_error.push_back(active->second.standard_error.value_or(0));
      // Ours after the strong push, chosen by its active share, stands beside the paper's.
      if (force == "strong") continue;
      plot.annotations.push_back(
          {.x = active->second.value, .y = remaining->second.value, .text = text, .left = true});
    }
    plot.curves.insert(plot.curves.end() - 1, std::move(curve));
  }
  return plot;
}

}  // namespace

Report collected_report(const std::vector<std::filesystem::path>& files, const Vec2& box,
                        const std::filesystem::path& folder, const std::string& command) {
  const PaperTargets targets = read_targets(shipped_targets());
  std::vector<MethodFindings> methods = merged(files, box);
  Report report{
      .title = "Collapsing granular suspensions, all numbers",
      .intro = {"All numbers of the paper beside ours. Each of ours links to the report "
                "that it is taken from, with figures and runs. Our boxes measure " +
                box_text(box) +
                " unless a lower one is named beside the number; the paper uses one of "
                "51 x 199 d and 10 realizations. What is known about a difference is said "
                "here; the linked reports say what was known when they were written."}};
  add_first_page(report, targets.targets, methods, folder);
  Section all{.title = "All numbers in one picture", .blocks = {}};
  all.add(Figure{.plot = Agreement(targets, methods).take(),
                 .caption =
                     "Our numbers divided by the paper's, with bars of one standard error. "
                     "Grey: the paper's last digit, or its interval, whose geometric mean "
                     "stands for its number. Filled: inside by the rule of the table; open: "
                     "not. †: used to make a choice, so no prediction. Bounds and numbers that may "
                     "be zero are left out. Numbers of lower boxes are among them.",
                 .command = command});
  all.add(Figure{
      .plot = pairs_of_shares(targets, methods),
      .caption = "Shares of bonds after the pushes with 0.33 F_c, F_c and a strong "
                 "force, against each other, with bars of one standard error. Numbers are "
                 "forces in F_c. A pair of the paper's on one of our lines would be left by that "
                 "method after another force, if its pairs follow the line.",
      .command = command});
  report.sections = {
      std::move(all),
      {.title = "What was free, and what each choice does",
       .blocks = {choices_table(read_evidence(shipped_evidence()), folder)}},
      {.title = "How the paper is read", .blocks = {reading_table(targets, methods)}}};
  report.provenance = provenance(command, {});
  return report;
}

}  // namespace quicksand
