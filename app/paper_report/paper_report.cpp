#include "app/paper_report/paper_report.h"

#include <algorithm>

#include "app/json/json_reader.h"
#include "app/paper/findings_file.h"
#include "app/paper_report/first_page.h"
#include "app/paper_report/merge_sections.h"
#include "app/paper_report/runs_section.h"
#include "app/report/provenance.h"
#include "core/base/format.h"

namespace quicksand {

namespace {

namespace fs = std::filesystem;

// What one programme's runs say.
struct Found {
  MethodFindings numbers;
  std::vector<std::pair<const PaperFigure*, Section>> sections;
};

Found found_by(const Programme& programme, const PaperResults& results) {
  Found found{.numbers = {.method = programme.method, .findings = {}}, .sections = {}};
  for (const PlannedFigure& planned : programme.figures) {
    Section section{.title = std::string(planned.figure->title), .blocks = {}};
    planned.experiment->report(results, section, found.numbers.findings);
    found.sections.emplace_back(planned.figure, std::move(section));
  }
  return found;
}

std::string method_paragraph(const PaperScale& scale) {
  if (!scale.nscd)
    return "exact: every step is solved to a tolerance, and bonds fail by the energy criterion. "
           "Pushes use time steps of at most " +
           number_text(scale.push_step) + " sqrt(d/g); a grain is deposited every " +
           number_text(scale.interval) + " sqrt(d/g).";
  return "NSCD, standard nonsmooth contact dynamics: " + count_text(scale.nscd->sweeps, "sweep") +
         " of projected Gauss-Seidel per step, in random order, whose result is accepted as it is. "
         "Time steps are " +
         number_text(scale.nscd->deposit_step) + " (deposition) and " +
         number_text(scale.nscd->fast_step) +
         " sqrt(d/g) (everything else). A bond fails if its gap after the step exceeds d_c, "
         "whether the step converged or not; during deposition every touch forms a bond. The "
         "numbers depend on the number of sweeps and on the time step.";
}

// The rows of the first page: of a part of the programme what that part measures.
std::vector<Target> rows_of(const PaperReport& made, const std::vector<Found>& found) {
  std::vector<Target> targets = read_targets(shipped_targets()).targets;
  if (!made.all_figures)
    std::erase_if(targets, [&](const Target& target) {
      return std::ranges::none_of(
          found, [&](const Found& by) { return by.numbers.findings.contains(target.id); });
    });
  return targets;
}

void add_commands(Section& section, const std::string& command) {
  for (Block& block : section.blocks) {
    if (auto* figure = std::get_if<Figure>(&block)) figure->command = command;
    if (auto* gallery = std::get_if<Gallery>(&block))
      for (Gallery::Picture& picture : gallery->pictures) picture.command = command;
  }
}

// Figure by figure, the pictures apart; names of figures without a result.
std::vector<std::string> add_figures(Report& report, const PaperReport& made,
                                     std::vector<Found>& found) {
  std::vector<std::string> missing;
  Section snapshots{.title = "Snapshots", .blocks = {}};
  snapshots.add(
      Paragraph{"Final states of the first realization. We do not have the paper's colours: each "
                "state is shown by the number of active bonds of each grain and, in two colours, "
                "by whether all bonds of a grain hold."});
  for (const PaperFigure& figure : paper_figures()) {
    std::vector<std::pair<std::string, Section>> parts;
    bool asked = false;
    for (Found& by : found)
      for (auto& [of, section] : by.sections)
        if (of == &figure) {
          asked = true;
          if (drop_empty_blocks(section))
            parts.emplace_back(method_title(by.numbers.method), std::move(section));
        }
    if (asked && parts.empty()) missing.emplace_back(figure.name);
    if (parts.empty()) continue;
    Section section = merge_sections(std::move(parts));
    add_commands(section, made.command(figure.name));
    const auto first = std::stable_partition(
        section.blocks.begin(), section.blocks.end(),
        [](const Block& block) { return !std::holds_alternative<Gallery>(block); });
    std::move(first, section.blocks.end(), std::back_inserter(snapshots.blocks));
    section.blocks.erase(first, section.blocks.end());
    report.sections.push_back(std::move(section));
  }
  if (snapshots.blocks.size() > 1) report.sections.push_back(std::move(snapshots));
  return missing;
}

void add_intro(Report& report, const std::vector<Programme>& programmes) {
  const PaperScale& scale = programmes.front().jobs.scale();
  report.intro = {"All numbers of the paper beside ours. Our boxes measure " +
                  box_text({scale.width, scale.height}) + ", with at most " +
                  count_text(scale.realizations, "realization") +
                  "; the paper uses 51 x 199 d and 10 realizations."};
  if (scale.width < PaperScale{}.width || scale.height < PaperScale{}.height)
    report.intro.emplace_back(
        "The box is smaller than the paper's: depths, heights and quantities that depend on the "
        "weight above cannot agree, and walls and floor are closer. Unless stated otherwise, the "
        "reasons for values outside were measured in the paper's box.");
}

}  // namespace

Report paper_report(const PaperReport& made, const std::vector<Programme>& programmes,
                    const std::vector<std::vector<JobOutcome>>& outcomes) {
  Report report{.title = "Collapsing granular suspensions, reproduced"};
  add_intro(report, programmes);
  std::vector<Found> found;
  std::vector<MethodFindings> methods;
  Section runs{.title = "Runs", .blocks = {}};
  double seconds = 0;
  std::string commits;
  for (std::size_t p = 0; p < programmes.size(); ++p) {
    const Programme& programme = programmes[p];
    const std::vector<Job>& jobs = programme.jobs.jobs();
    const PaperResults results(jobs, made.folder / "snapshots" / programme.method);
    found.push_back(found_by(programme, results));
    methods.push_back(found.back().numbers);
    const PaperScale& scale = programme.jobs.scale();
    const fs::path folder = programmes.size() > 1 ? made.folder / programme.method : made.folder;
    fs::create_directories(folder);
    write_findings(folder / "findings.json", methods.back(), {scale.width, scale.height});
    add_runs(runs, method_title(programme.method), jobs, outcomes[p], results);
    seconds += seconds_of(results, jobs.size());
    commits += (commits.empty() ? "" : "; ") + method_title(programme.method) + ": " +
               commits_of(results, jobs.size());
  }
  if (made.beside) methods.push_back(*made.beside);
  add_first_page(report, rows_of(made, found), methods, made.folder);
  const std::vector<std::string> missing = add_figures(report, made, found);

  Section free{.title = "What was free, and what each choice does", .blocks = {}};
  for (const Programme& programme : programmes)
    free.add(Paragraph{method_paragraph(programme.jobs.scale())});
  free.add(choices_table(read_evidence(shipped_evidence()), made.folder));
  report.sections.push_back(std::move(free));
  report.sections.push_back({.title = "How the paper is read",
                             .blocks = {reading_table(read_targets(shipped_targets()), methods)}});
  if (!missing.empty())
    runs.add(
        Remark{Remark::Kind::note, "Figures without a finished run: " + joined(missing, ", ")});
  report.sections.push_back(std::move(runs));
  report.provenance = provenance(made.command({}), seconds);
  report.provenance.emplace_back("runs", commits);
  return report;
}

}  // namespace quicksand
