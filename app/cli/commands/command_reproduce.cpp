// quicksand reproduce: the paper's experiments and a report that sets its numbers beside ours.
#include <algorithm>
#include <cstdio>
#include <map>
#include <memory>

#include "app/base/exit_code.h"
#include "app/base/nearest_name.h"
#include "app/cli/commands.h"
#include "app/experiments/experiments.h"
#include "app/jobs/job_pool.h"
#include "app/jobs/run_record.h"
#include "app/json/json_reader.h"
#include "app/options/threads_option.h"
#include "app/paper/findings_file.h"
#include "app/report/provenance.h"
#include "core/base/errors.h"

namespace quicksand {

namespace {

namespace fs = std::filesystem;

constexpr std::string_view kNscd = "nscd";
constexpr int kMostRealizations = 1000, kMostGrains = 1000;

struct ReproduceArguments {
  std::vector<std::string> figures;
  std::optional<int> realizations;
  std::optional<double> width, height;
  std::vector<double> push_forces, time_steps;
  std::optional<double> push_step, plain;
  std::string method = "exact";
  std::optional<fs::path> beside;  // folder of another method's results
  std::optional<int> grains_per_depth;
  fs::path out = "out/paper";
  std::int64_t threads = 0;  // 0: all cores
  bool quick = false;
  bool dry_run = false;
  bool quiet = false;
};

struct Chosen {
  const PaperFigure* figure;
  std::unique_ptr<PaperExperiment> experiment;
};

std::vector<std::string> figure_names() {
  std::vector<std::string> names;
  for (const PaperFigure& figure : paper_figures()) names.emplace_back(figure.name);
  return names;
}

std::vector<Chosen> chosen(const ReproduceArguments& options) {
  const std::vector<std::string> names = figure_names();
  for (const std::string& word : options.figures)
    if (std::ranges::find(names, word) == names.end())
      throw InputError("figure \"" + word + "\"", "is not known" + suggestion(word, names));
  std::vector<Chosen> all;
  // It sets the failure criteria itself, the gap criterion among them, side by side.
  constexpr const char* kOfRules = "break_rule";
  const auto asked = [&](std::string_view name) {
    return std::ranges::find(options.figures, name) != options.figures.end();
  };
  if (options.plain && asked(kOfRules))
    throw InputError("--plain",
                     "leaves nothing to compare for the figure break_rule, which varies the "
                     "failure criterion itself");
  if (options.method == kNscd && asked(kOfRules))
    throw InputError("--method nscd",
                     "has one failure criterion; figure break_rule compares those "
                     "of exact steps");
  for (const PaperFigure& figure : paper_figures()) {
    // Unless it is asked for: what another method is about, or what none of them needs.
    if (options.figures.empty() &&
        (figure.name == "nscd_setting" ||
         (options.method == kNscd && (figure.name == kOfRules || figure.name == "choices"))))
      continue;
    if (options.figures.empty() ? options.plain && figure.name == kOfRules : !asked(figure.name))
      continue;
    all.push_back({&figure, figure.make()});
  }
  return all;
}

PaperScale scale_of(const ReproduceArguments& options) {
  PaperScale scale = options.quick ? quick_scale() : PaperScale{};
  const auto checked = [](const char* name, double value, double least, double most,
                          const char* unit) {
    if (value >= least && value <= most) return value;
    throw InputError(std::string(name) + " " + number_text(value),
                     "must be from " + number_text(least) + " to " + number_text(most) + unit);
  };
  constexpr double kLeastWidth = 12, kLeastHeight = 20, kMost = 1000;
  if (options.width) scale.width = checked("--width", *options.width, kLeastWidth, kMost, " d");
  if (options.height)
    scale.height = checked("--height", *options.height, kLeastHeight, kMost, " d");
  if (options.realizations)
    scale.realizations = static_cast<int>(
        checked("--realizations", *options.realizations, 1, kMostRealizations, ""));
  if (options.grains_per_depth)
    scale.grains_per_depth = static_cast<int>(
        checked("--grains-per-depth", *options.grains_per_depth, 1, kMostGrains, ""));
  const auto replace = [&](const char* name, const std::vector<double>& values, double least,
                           double most, const char* unit, std::vector<double>& by_default) {
    for (const double value : values) checked(name, value, least, most, unit);
    if (!values.empty()) by_default = values;
  };
  constexpr double kLeastStep = 1e-5, kMostStep = 0.1;
  if (options.plain && (options.push_step || !options.time_steps.empty()))
    throw InputError("--plain", std::string("sets the step of everything; leave out ") +
                                    (options.push_step ? "--push-step" : "--time-steps"));
  if (options.plain)
    make_plain(scale, checked("--plain", *options.plain, kLeastStep, kMostStep, " sqrt(d/g)"));
  if (options.method == kNscd) {
    if (options.plain || options.push_step)
      throw InputError("--method nscd", std::string("has time steps of its own; leave out ") +
                                            (options.plain ? "--plain" : "--push-step"));
    make_nscd(scale, NscdSetting{});
    if (!options.grains_per_depth) scale.grains_per_depth = 1;
  }
  if (options.push_step)
    scale.push_step =
        checked("--push-step", *options.push_step, kLeastStep, kMostStep, " sqrt(d/g)");
  replace("--push-forces", options.push_forces, 1e-3, 1e3, " F_c", scale.push_forces);
  replace("--time-steps", options.time_steps, kLeastStep, kMostStep, " sqrt(d/g)",
          scale.time_steps);
  return scale;
}

std::string command_of(const ReproduceArguments& options) {
  std::vector<std::string> words{"quicksand", "reproduce"};
  words.insert(words.end(), options.figures.begin(), options.figures.end());
  if (options.quick) words.emplace_back("--quick");
  const auto add = [&](const char* name, const std::string& value) {
    words.insert(words.end(), {name, value});
  };
  if (options.width) add("--width", number_text(*options.width));
  if (options.height) add("--height", number_text(*options.height));
  if (options.realizations) add("--realizations", std::to_string(*options.realizations));
  const auto add_list = [&](const char* name, const std::vector<double>& values) {
    std::string list;
    for (const double value : values) list += (list.empty() ? "" : ",") + number_text(value);
    if (!values.empty()) add(name, list);
  };
  if (options.method != "exact") add("--method", options.method);
  if (options.beside) add("--beside", options.beside->string());
  if (options.plain) add("--plain", number_text(*options.plain));
  if (options.push_step) add("--push-step", number_text(*options.push_step));
  add_list("--push-forces", options.push_forces);
  add_list("--time-steps", options.time_steps);
  if (options.grains_per_depth)
    add("--grains-per-depth", std::to_string(*options.grains_per_depth));
  add("--out", options.out.string());
  return command_text(words);
}

std::string method_name(const ReproduceArguments& options) {
  return options.plain ? "exact steps, gap criterion" : options.method;
}

double seconds_of(const PaperResults& results, std::size_t jobs) {
  double seconds = 0;
  for (std::size_t k = 0; k < jobs; ++k)
    if (const RunResults* run = results.run(k))
      seconds += run->final_value("wall_seconds").value_or(0);
  return seconds;
}

// "12 by commit 7fce0b8, 3 by commit b08931a": finished runs are not repeated by a later version.
std::string commits_of(const PaperResults& results, std::size_t jobs) {
  std::map<std::string, int> runs;
  for (std::size_t k = 0; k < jobs; ++k)
    if (const RunResults* run = results.run(k)) ++runs[run->summary().value("commit", "unknown")];
  std::string text;
  for (const auto& [commit, count] : runs)
    text += (text.empty() ? "" : ", ") + std::to_string(count) + " by commit " + commit;
  return text.empty() ? "none" : text;
}

// Runs that have no result, and those whose steps did not all converge.
Section section_on_runs(const PaperJobs& jobs, const PoolReport& pool,
                        const PaperResults& results) {
  Section section{.title = "Runs", .blocks = {}};
  BulletList failed, moving;
  double unconverged = 0, halved = 0, broken = 0;
  for (std::size_t k = 0; k < jobs.jobs().size(); ++k) {
    if (const RunResults* run = results.run(k)) {
      unconverged += run->final_value("unconverged_steps").value_or(0);
      halved += run->final_value("halved_steps").value_or(0);
      broken += run->final_value("bonds_broken_in_unconverged_steps").value_or(0);
      if (run->summary().value("missed_rest", false)) moving.items.push_back(jobs.jobs()[k].id);
    } else {
      failed.items.push_back(
          jobs.jobs()[k].id + ": " + std::string(status_name(pool.outcomes[k].status)) +
          (pool.outcomes[k].failure.empty() ? "" : ", ") + pool.outcomes[k].failure);
    }
  }
  section.blocks.emplace_back(Paragraph{
      std::to_string(jobs.jobs().size()) + " runs, " + std::to_string(failed.items.size()) +
      " of them without a result. Steps taken without convergence: " + number_text(unconverged) +
      "; steps taken as two halves: " + number_text(halved) +
      "; bonds broken in unconverged steps: " + number_text(broken) +
      ". Every run's folder holds its scene, series, summary and last state; `quicksand run "
      "scene.json` repeats it."});
  if (!moving.items.empty()) {
    section.blocks.emplace_back(Remark{Remark::Kind::note,
                                       "These runs ended at the longest time of their last phase, "
                                       "before all of it had come to rest."});
    section.blocks.emplace_back(std::move(moving));
  }
  if (!failed.items.empty()) {
    section.blocks.emplace_back(
        Remark{Remark::Kind::warning, "These runs are missing from every mean."});
    section.blocks.emplace_back(std::move(failed));
  }
  return section;
}

Report report_of(const ReproduceArguments& options, const PaperJobs& jobs, const PoolReport& pool,
                 const std::vector<Chosen>& all) {
  const PaperResults results(jobs.jobs());
  const PaperScale& scale = jobs.scale();
  Report report{
      .title = "Collapsing granular suspensions, reproduced",
      .intro = {"Every number of the paper beside ours, and how each was obtained. Boxes of " +
                number_text(scale.width) + " x " + number_text(scale.height) + " d, " +
                std::to_string(scale.realizations) +
                (scale.realizations == 1 ? " realization" : " realizations") +
                "; the paper has 51 x 199 d and 10."}};
  if (scale.width != PaperScale{}.width || scale.height != PaperScale{}.height)
    report.intro.emplace_back(
        "The box is smaller than the paper's: depths, heights and what depends on the weight above "
        "cannot agree, and walls and ground are nearer.");
  if (scale.nscd)
    report.intro.push_back(
        "By the paper's own method, standard nonsmooth contact dynamics (NSCD): " +
        std::to_string(scale.nscd->sweeps) +
        " sweeps of projected Gauss-Seidel a step in random order, taken as they are, in steps "
        "of " +
        number_text(scale.nscd->deposit_step) + " (deposition) and " +
        number_text(scale.nscd->fast_step) +
        " sqrt(d/g) (all else). A bond fails where the gap after the step is above d_c, whether "
        "the "
        "step converged or not; while grains are deposited every touch forms a bond. The numbers "
        "depend on sweeps and time step.");
  if (scale.plain_step)
    report.intro.push_back(
        "Exact steps with the gap criterion: everything in steps of " +
        number_text(*scale.plain_step) +
        " sqrt(d/g), halved only where one does not converge, a grain a step; a bond breaks when "
        "its gap after the step's straight move "
        "is above d_c, so that it also breaks where its pair turns by more than √(2 d_c/d) in a "
        "step. What breaks depends on the step.");
  Findings findings;
  std::vector<Section> figures;
  for (const Chosen& c : all) {
    Section section{.title = std::string(c.figure->title), .blocks = {}};
    c.experiment->report(results, options.out / "snapshots", section, findings);
    figures.push_back(std::move(section));
  }
  PaperTargets targets = read_targets(shipped_targets());
  const Tally count = tally(targets, findings);
  // Of a part of the programme, the table has what that part measures.
  const bool all_figures = options.figures.empty();
  if (!all_figures)
    std::erase_if(targets.targets, [&](const Target& t) { return !findings.contains(t.id); });
  Section comparison{.title = "The paper's numbers beside ours", .blocks = {}};
  comparison.blocks.emplace_back(
      Paragraph{std::to_string(count.inside) + " inside the stated tolerance, " +
                std::to_string(count.outside) + " outside, " + std::to_string(count.not_measured) +
                (all_figures ? " not measured." : " not measured and left out here.")});
  write_findings(options.out / "findings.json", method_name(options), findings);
  if (!targets.targets.empty()) {
    if (options.beside)
      comparison.blocks.emplace_back(comparison_of_methods(
          targets, {{method_name(options), findings}, read_findings(*options.beside)}));
    comparison.blocks.emplace_back(comparison_table(targets, findings));
  }
  report.sections.push_back(std::move(comparison));
  std::ranges::move(figures, std::back_inserter(report.sections));
  report.sections.push_back(section_on_runs(jobs, pool, results));
  report.provenance = provenance(
      {.command = command_of(options), .seconds = seconds_of(results, jobs.jobs().size())});
  report.provenance.emplace_back("runs", commits_of(results, jobs.jobs().size()));
  return report;
}

void list_failed(const PaperJobs& jobs, const PoolReport& pool) {
  for (std::size_t k = 0; k < pool.outcomes.size(); ++k)
    if (pool.outcomes[k].status == JobStatus::failed)
      std::fprintf(stderr, "failed: %s: %s\n", jobs.jobs()[k].id.c_str(),
                   pool.outcomes[k].failure.c_str());
}

int reproduce(const ReproduceArguments& options) {
  std::vector<Chosen> all = chosen(options);
  PaperJobs jobs(scale_of(options), options.out);
  for (Chosen& c : all) c.experiment->plan(jobs);
  std::ranges::for_each(jobs.jobs(), require_own_scene);
  if (options.dry_run) {
    for (const Job& job : jobs.jobs()) std::printf("%s\n", job.id.c_str());
    std::printf("%zu runs would go to %s\n", jobs.jobs().size(), (options.out / "runs").c_str());
    return kFine;
  }
  make_writable({options.out});
  const PoolReport pool =
      run_jobs(jobs.jobs(),
               {.threads = thread_count(options.threads), .frames = false, .quiet = options.quiet});
  const Report report = report_of(options, jobs, pool, all);
  for (const std::string& problem : write_report(report, options.out))
    std::fprintf(stderr, "quicksand: %s\n", problem.c_str());
  list_failed(jobs, pool);
  std::printf("%zu of %zu runs finished\n%s\n%s\n", pool.count(JobStatus::finished),
              jobs.jobs().size(), (options.out / "report.html").c_str(),
              (options.out / "report.md").c_str());
  if (pool.interrupted) {
    std::printf("interrupted; the same command goes on from there\n");
    return kInterrupted;
  }
  return pool.count(JobStatus::finished) == jobs.jobs().size() ? kFine : kRunFailed;
}

}  // namespace

Command add_reproduce(CLI::App& program) {
  CLI::App* command = program.add_subcommand(
      "reproduce",
      "Run the paper's experiments and write a report that sets its numbers beside ours.");
  const auto options = std::make_shared<ReproduceArguments>();
  std::string names;
  for (const std::string& name : figure_names()) names += (names.empty() ? "" : ", ") + name;
  command->add_option("figures", options->figures, "all if none is given; one or more of: " + names)
      ->type_name("FIGURE");
  command->add_option("--out", options->out, "folder of runs and report [out/paper]")
      ->type_name("DIR");
  add_threads_option(*command, options->threads, kThreadsOfRuns);
  command->add_flag("--quick", options->quick, "a small box and two realizations, in minutes");
  command->add_flag("--dry-run", options->dry_run, "list the runs");
  command->add_flag("--quiet", options->quiet, "no progress");
  command->option_defaults()->group("Size");
  command
      ->add_option("--realizations", options->realizations, "specimens of each kind [10; quick: 2]")
      ->type_name("N");
  command->add_option("--width", options->width, "of the box [51 d; quick: 24 d]")->type_name("W");
  command->add_option("--height", options->height, "of the box [199 d; quick: 50 d]")
      ->type_name("H");
  command
      ->add_option("--push-forces", options->push_forces,
                   "of the push curves [0.1,0.33,0.67,1,2,3 F_c; quick: 0.1,0.33,1,3]")
      ->type_name("F,...")
      ->delimiter(',')
      ->allow_extra_args(false);
  command
      ->add_option("--time-steps", options->time_steps,
                   "of break_rule [0.01,0.003,0.001 sqrt(d/g); quick: 0.01,0.003]")
      ->type_name("DT,...")
      ->delimiter(',')
      ->allow_extra_args(false);
  command
      ->add_option("--grains-per-depth", options->grains_per_depth,
                   "sheared at each depth [10; quick: 1]")
      ->type_name("N");
  command->option_defaults()->group("Method");
  command
      ->add_option("--method", options->method,
                   "exact: every step solved; nscd: the paper's own, standard nonsmooth contact "
                   "dynamics [exact]")
      ->check(CLI::IsMember({"exact", "nscd"}))
      ->type_name("METHOD");
  command
      ->add_option(
          "--plain", options->plain,
          "exact steps with the gap criterion: everything in steps of this, a grain a step; "
          "bonds break by their gap after a straight move")
      ->type_name("DT");
  command
      ->add_option("--push-step", options->push_step,
                   "time step of pushes [0.001 sqrt(d/g); quick: 0.01]")
      ->type_name("DT");
  command
      ->add_option("--beside", options->beside,
                   "findings.json of another method's report, for a column of its own")
      ->type_name("FILE");
  command->footer(
      "Runs that have finished are not repeated: the same command goes on after an interruption.\n"
      "DIR receives report.html, report.md, plots/ and a folder for each run; where it holds runs "
      "of\n"
      "other settings, they stay and nothing is computed.\n\n"
      "Examples:\n  quicksand reproduce --quick --out out/quick\n"
      "  quicksand reproduce penetration --method nscd --realizations 3 --out out/nscd");
  return {command, [options] { return reproduce(*options); }};
}

}  // namespace quicksand
