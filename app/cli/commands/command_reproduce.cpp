// quicksand reproduce: the paper's experiments and a report that sets its numbers beside ours.
#include <algorithm>
#include <cstdio>
#include <memory>

#include "app/base/exit_code.h"
#include "app/cli/commands.h"
#include "app/jobs/job_pool.h"
#include "app/jobs/run_record.h"
#include "app/json/json_reader.h"
#include "app/options/threads_option.h"
#include "app/paper/findings_file.h"
#include "app/paper_report/collected_report.h"
#include "app/paper_report/paper_report.h"
#include "app/report/provenance.h"
#include "core/base/errors.h"
#include "core/base/format.h"

namespace quicksand {

namespace {

namespace fs = std::filesystem;

constexpr std::string_view kBothMethods = "both";
constexpr int kMostRealizations = 1000, kMostGrains = 1000;

struct ReproduceArguments {
  std::vector<std::string> figures;
  std::optional<int> realizations;
  std::optional<double> width, height;
  std::vector<double> push_forces, time_steps;
  std::optional<double> push_step;
  std::optional<std::string> method;
  std::optional<fs::path> beside;  // another method's findings.json
  std::vector<fs::path> collect;   // findings.json of which a table is made, and nothing else
  std::optional<fs::path> report;  // only this is made, in this folder
  std::optional<int> grains_per_depth;
  fs::path out = "out/paper";
  std::int64_t threads = 0;  // 0: all cores
  bool quick = false;
  bool dry_run = false;
  bool quiet = false;

  std::string method_in_use() const {
    return method.value_or(std::string(quick ? kBothMethods : kExactMethod));
  }
  fs::path report_folder() const { return report.value_or(out); }
};

PaperScale scale_of(const ReproduceArguments& options, std::string_view method) {
  PaperScale scale = options.quick ? quick_scale() : PaperScale{};
  if (!options.figures.empty()) scale.studies = true;
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
  if (method == kNscdMethod) {
    make_nscd(scale, NscdSetting{});
    if (!options.grains_per_depth) scale.grains_per_depth = 1;
  }
  if (options.push_step && options.method_in_use() != kExactMethod)
    throw InputError("--push-step",
                     "applies to exact steps only, NSCD has its own time step; leave it out, or "
                     "add --method exact");
  if (options.push_step)
    scale.push_step =
        checked("--push-step", *options.push_step, kLeastStep, kMostStep, " sqrt(d/g)");
  replace("--push-forces", options.push_forces, 1e-3, 1e3, " F_c", scale.push_forces);
  // Curves over the forces join them in this order, and each has runs of its own.
  std::ranges::sort(scale.push_forces);
  scale.push_forces.erase(std::unique(scale.push_forces.begin(), scale.push_forces.end()),
                          scale.push_forces.end());
  replace("--time-steps", options.time_steps, kLeastStep, kMostStep, " sqrt(d/g)",
          scale.time_steps);
  return scale;
}

// From here, so that the line holds wherever the folder with both goes.
std::string from_here(const fs::path& path) {
  return fs::absolute(path).lexically_normal().lexically_proximate(fs::current_path()).string();
}

std::string command_of(const ReproduceArguments& options) {
  std::vector<std::string> words{"quicksand", "reproduce"};
  words.insert(words.end(), options.figures.begin(), options.figures.end());
  if (options.quick) words.emplace_back("--quick");
  const auto add = [&](const char* name, const std::string& value) {
    words.insert(words.end(), {name, value});
  };
  if (options.method) add("--method", *options.method);
  if (options.width) add("--width", number_text(*options.width));
  if (options.height) add("--height", number_text(*options.height));
  if (options.realizations) add("--realizations", std::to_string(*options.realizations));
  const auto add_list = [&](const char* name, const std::vector<double>& values) {
    if (!values.empty()) add(name, joined(values, ",", number_text));
  };
  if (options.push_step) add("--push-step", number_text(*options.push_step));
  add_list("--push-forces", options.push_forces);
  add_list("--time-steps", options.time_steps);
  if (options.grains_per_depth)
    add("--grains-per-depth", std::to_string(*options.grains_per_depth));
  if (options.beside) add("--beside", from_here(*options.beside));
  if (options.collect.empty()) {
    add("--out", from_here(options.out));
  } else {
    words.emplace_back("--collect");
    for (const fs::path& file : options.collect) words.push_back(from_here(file));
  }
  if (options.report) add("--report", from_here(*options.report));
  return command_text(words);
}

std::vector<Programme> planned(const ReproduceArguments& options) {
  const std::string method = options.method_in_use();
  if (method != kBothMethods) {
    std::vector<Programme> one;
    one.push_back(plan_programme(method, scale_of(options, method), options.out, options.figures));
    return one;
  }
  std::vector<Programme> both;
  for (const std::string_view by : {kNscdMethod, kExactMethod}) {
    std::vector<std::string> figures;
    for (const std::string& name : options.figures)
      if (is_figure_of(name, by)) figures.push_back(name);
    if (figures.empty() && !options.figures.empty()) continue;
    both.push_back(
        plan_programme(std::string(by), scale_of(options, by), options.out / by, figures));
  }
  return both;
}

std::optional<MethodFindings> beside(const ReproduceArguments& options,
                                     const std::vector<Programme>& programmes) {
  if (!options.beside) return std::nullopt;
  const PaperScale& scale = programmes.front().jobs.scale();
  MethodFindings other = read_findings(*options.beside, {scale.width, scale.height});
  for (const Programme& programme : programmes)
    if (programme.method == other.method)
      throw InputError(options.beside->string(),
                       "was made with the method " + other.method + ", which already has a column");
  return other;
}

// How the runs stand, without computing any.
std::vector<JobOutcome> outcomes_found(const std::vector<Job>& jobs) {
  std::vector<JobOutcome> outcomes;
  for (const Job& job : jobs) {
    const RunRecord record = read_record(job);
    outcomes.push_back({record.other_scene ? JobStatus::missing : record.status, record.failure});
  }
  return outcomes;
}

struct Counts {
  std::size_t finished = 0, all = 0;
};

Counts counted(const std::vector<std::vector<JobOutcome>>& outcomes) {
  Counts counts;
  for (const auto& of_programme : outcomes) {
    counts.all += of_programme.size();
    counts.finished += static_cast<std::size_t>(
        std::ranges::count(of_programme, JobStatus::finished, &JobOutcome::status));
  }
  return counts;
}

void list_unfinished(const std::vector<Job>& jobs, const std::vector<JobOutcome>& outcomes) {
  for (std::size_t k = 0; k < outcomes.size(); ++k) {
    if (outcomes[k].status == JobStatus::failed)
      std::fprintf(stderr, "failed: %s: %s\n", jobs[k].id.c_str(), outcomes[k].failure.c_str());
    else if (outcomes[k].status == JobStatus::elsewhere)
      std::fprintf(stderr, "another process is computing it: %s\n", jobs[k].id.c_str());
  }
}

void list_runs(const std::vector<Programme>& programmes) {
  for (const Programme& programme : programmes) {
    const std::vector<Job>& jobs = programme.jobs.jobs();
    for (const Job& job : jobs) std::printf("%s\n", job.id.c_str());
    std::printf("%s would go to %s\n", count_text(std::ssize(jobs), "run").c_str(),
                (programme.jobs.folder() / "runs").c_str());
  }
}

// What could not be drawn is told; the rest of the report is there.
void write(const Report& report, const fs::path& folder) {
  for (const std::string& problem : write_report(report, folder))
    std::fprintf(stderr, "quicksand: %s\n", problem.c_str());
}

void name_report(const fs::path& folder) {
  std::printf("%s\n%s\n", (folder / "report.html").c_str(), (folder / "report.md").c_str());
}

int collect(const ReproduceArguments& options) {
  const PaperScale scale = scale_of(options, kExactMethod);
  const fs::path folder = options.report_folder();
  const Report report =
      collected_report(options.collect, {scale.width, scale.height}, folder, command_of(options));
  if (options.dry_run) return kFine;
  write(report, folder);
  name_report(folder);
  return kFine;
}

int reproduce(const ReproduceArguments& options) {
  if (!options.collect.empty()) return collect(options);
  const std::vector<Programme> programmes = planned(options);
  const PaperReport made{.folder = options.report_folder(),
                         .beside = beside(options, programmes),
                         .all_figures = options.figures.empty(),
                         .command = [&options](std::string_view figure) {
                           if (figure.empty()) return command_of(options);
                           // Its runs, where they are missing, and itself.
                           ReproduceArguments one = options;
                           one.figures = {std::string(figure)};
                           one.beside.reset();
                           one.report.reset();
                           return command_of(one);
                         }};
  for (const Programme& programme : programmes)
    std::ranges::for_each(programme.jobs.jobs(), require_own_scene);
  if (options.dry_run) {
    list_runs(programmes);
    return kFine;
  }
  std::vector<std::vector<JobOutcome>> outcomes;
  if (options.report) {
    for (const Programme& programme : programmes)
      outcomes.push_back(outcomes_found(programme.jobs.jobs()));
    if (counted(outcomes).finished == 0)
      throw InputError(options.out.string(), "holds no finished run of these experiments");
  }
  make_writable({options.report_folder()});
  bool interrupted = false;
  while (outcomes.size() < programmes.size()) {
    const std::vector<Job>& jobs = programmes[outcomes.size()].jobs.jobs();
    if (interrupted) {
      outcomes.push_back(outcomes_found(jobs));
      continue;
    }
    PoolReport pool = run_jobs(
        jobs, {.threads = thread_count(options.threads), .frames = false, .quiet = options.quiet});
    interrupted = pool.interrupted;
    outcomes.push_back(std::move(pool.outcomes));
  }
  write(paper_report(made, programmes, outcomes), made.folder);
  for (std::size_t p = 0; p < programmes.size(); ++p)
    list_unfinished(programmes[p].jobs.jobs(), outcomes[p]);
  const Counts counts = counted(outcomes);
  std::printf("%zu of %zu runs finished\n", counts.finished, counts.all);
  name_report(made.folder);
  if (interrupted) {
    std::printf("interrupted; the same command continues from there\n");
    return kInterrupted;
  }
  return options.report || counts.finished == counts.all ? kFine : kRunFailed;
}

void add_size_options(CLI::App& command, ReproduceArguments& arguments) {
  command.option_defaults()->group("Size");
  command
      .add_option("--realizations", arguments.realizations,
                  "number of specimens of each kind [10; quick: 2]")
      ->type_name("N");
  command.add_option("--width", arguments.width, "width of the box [51 d; quick: 24 d]")
      ->type_name("W");
  command.add_option("--height", arguments.height, "height of the box [199 d; quick: 50 d]")
      ->type_name("H");
  command
      .add_option("--push-forces", arguments.push_forces,
                  "forces of the push curves [0.1,0.33,0.67,1,2,3 F_c; quick: 0.1,0.33,1,3]")
      ->type_name("F[,F]")
      ->delimiter(',')
      ->allow_extra_args(false);
  command
      .add_option("--time-steps", arguments.time_steps,
                  "time steps of break_rule [0.01,0.003,0.001 sqrt(d/g); quick: 0.01,0.003]")
      ->type_name("DT[,DT]")
      ->delimiter(',')
      ->allow_extra_args(false);
  command
      .add_option("--grains-per-depth", arguments.grains_per_depth,
                  "grains sheared at each depth [10, with NSCD 1; quick: 1]")
      ->type_name("N");
}

void add_method_options(CLI::App& command, ReproduceArguments& arguments, CLI::Option* collect) {
  command.option_defaults()->group("Method");
  command
      .add_option("--method", arguments.method,
                  "exact: every step is solved; nscd: the paper's own method, standard nonsmooth "
                  "contact dynamics; both: each in a folder of its name [exact; quick: both]")
      ->check(CLI::IsMember({"exact", "nscd", "both"}))
      ->type_name("METHOD");
  command
      .add_option("--push-step", arguments.push_step,
                  "time step of pushes with the exact method [0.001 sqrt(d/g); quick: 0.01]")
      ->type_name("DT");
  command
      .add_option("--beside", arguments.beside,
                  "findings.json of another method's report, to show in a column of its own")
      ->type_name("FILE")
      ->excludes(collect);
}

}  // namespace

Command add_reproduce(CLI::App& program) {
  CLI::App* command = program.add_subcommand(
      "reproduce",
      "Run the paper's experiments and write a report that compares its numbers with ours.");
  const auto options = std::make_shared<ReproduceArguments>();
  const std::string names = joined(paper_figures(), ", ", &PaperFigure::name);
  CLI::Option* const figures =
      command
          ->add_option("figures", options->figures,
                       "one or more of the following, or all if none is given: " + names)
          ->type_name("FIGURE");
  command->add_option("--out", options->out, "folder for the runs and the report [out/paper]")
      ->type_name("DIR");
  CLI::Option* const report =
      command
          ->add_option(
              "--report", options->report,
              "write the report of the runs finished in --out into this folder; compute nothing")
          ->type_name("DIR");
  CLI::Option* const collect =
      command
          ->add_option("--collect", options->collect,
                       "merge the findings.json of several reports into one table in --report; for "
                       "each number the first file that has it counts")
          ->type_name("FILE")
          ->needs(report)
          ->excludes(figures);
  add_threads_option(*command, options->threads, kThreadsOfRuns);
  command->add_flag(
      "--quick", options->quick,
      "a small box, two realizations and both methods, and without FIGURE only what the "
      "paper shows; about ten minutes on two cores");
  command->add_flag("--dry-run", options->dry_run, "list the runs");
  command->add_flag("--quiet", options->quiet, "show no progress");
  add_size_options(*command, *options);
  add_method_options(*command, *options, collect);
  command->footer(
      "Finished runs are not repeated: after an interruption, the same command continues.\n"
      "DIR receives report.html, report.md, plots/ and a folder for each run; if it holds runs\n"
      "with other settings, they are kept and nothing is computed.\n\n"
      "Examples:\n"
      "  quicksand reproduce --quick --out out/quick\n"
      "  quicksand reproduce --collect out/nscd/findings.json out/paper/findings.json --report "
      "out/all");
  return {command, [options] { return reproduce(*options); }};
}

}  // namespace quicksand
