// quicksand campaign: many runs of one scene, here or on a cluster, and one table of their results.
#include <algorithm>
#include <chrono>
#include <cstdio>
#include <memory>

#include "app/base/exit_code.h"
#include "app/base/nearest_name.h"
#include "app/base/shell_text.h"
#include "app/campaign/campaign.h"
#include "app/campaign/results_table.h"
#include "app/campaign/slurm.h"
#include "app/campaign_report/campaign_remarks.h"
#include "app/cli/commands.h"
#include "app/cli/run_outcome.h"
#include "app/jobs/job_pool.h"
#include "app/options/threads_option.h"
#include "app/run_folder/folder_lock.h"
#include "core/base/errors.h"
#include "core/base/format.h"
#include "core/base/whole_file.h"

namespace quicksand {

namespace {

namespace fs = std::filesystem;
using Clock = std::chrono::steady_clock;

constexpr std::size_t kMostListed = 20;  // failed runs
constexpr double kTablePeriod = 10;      // between two writings of results.csv [s]

struct CampaignArguments {
  fs::path file;
  fs::path out;
  std::int64_t threads = 0;  // 0: all cores
  std::string engine = "local";
  std::optional<std::int64_t> task;
  bool dry_run = false;
  bool status = false;
  bool wait = false;
  bool quiet = false;
};

// A campaign, its runs and what their folders say.
class CampaignRun {
 public:
  explicit CampaignRun(const CampaignArguments& options)
      : options_(options),
        campaign_(read_campaign(options.file)),
        out_(options.out.empty() ? fs::path("out") / campaign_.name : options.out),
        jobs_(campaign_jobs(campaign_, options.file, out_)),
        records_(jobs_.size()) {}

  int dry_run() const {
    std::ranges::for_each(jobs_, require_own_scene);
    warn();
    for (const Job& job : jobs_) std::printf("%s\n", job_name(job).c_str());
    std::printf("%s would go to %s\n", count_text(std::ssize(jobs_), "run").c_str(),
                (out_ / "runs").c_str());
    return kFine;
  }

  int status() {
    look();
    for (std::size_t i = 0; i < jobs_.size(); ++i)
      if (records_[i].status != JobStatus::finished && is_computed_elsewhere(jobs_[i].folder.path))
        records_[i].status = JobStatus::elsewhere;
    return report(false);
  }

  int run_here() {
    look();
    prepare();
    ResultsTable table(jobs_, reported_paths(campaign_.report));
    for (std::size_t i = 0; i < jobs_.size(); ++i) table.set(i, records_[i]);
    auto written = Clock::now();
    const PoolReport pool =
        run_jobs(jobs_, {thread_count(options_.threads), campaign_.frames, options_.quiet,
                         [&](std::size_t job, const JobOutcome& outcome) {
                           note(job, outcome);
                           table.set(job, records_[job]);
                           const std::chrono::duration<double> since = Clock::now() - written;
                           if (since.count() < kTablePeriod) return;
                           write_whole(results(), table.text());
                           written = Clock::now();
                         }});
    // Another process may have ended them since.
    for (std::size_t i = 0; i < jobs_.size(); ++i)
      if (pool.outcomes[i].status == JobStatus::elsewhere)
        if (RunRecord now = read_record(jobs_[i]); now.status == JobStatus::finished)
          records_[i] = std::move(now);
    return report(pool.interrupted);
  }

  // A part of the campaign, whose table is somebody else's business.
  int run_task(std::int64_t task) {
    const std::span<const Job> jobs = task_jobs(jobs_, campaign_.chunk, task);
    std::ranges::for_each(jobs, require_own_scene);
    const PoolReport pool =
        run_jobs(jobs, {thread_count(options_.threads), campaign_.frames, options_.quiet, {}});
    for (std::size_t i = 0; i < jobs.size(); ++i) {
      const JobOutcome& outcome = pool.outcomes[i];
      std::printf("%s: %s%s%s\n", job_name(jobs[i]).c_str(),
                  std::string(status_name(outcome.status)).c_str(),
                  outcome.failure.empty() ? "" : ": ", outcome.failure.c_str());
    }
    if (pool.interrupted) return kInterrupted;
    return pool.count(JobStatus::finished) == jobs.size() ? kFine : kRunFailed;
  }

  int run_on_cluster() {
    look();
    const std::vector<std::int64_t> tasks = open_tasks(records_, campaign_.chunk);
    if (tasks.empty()) return report(false);
    prepare();
    const std::string job = submit_tasks(campaign_, out_, tasks, options_.wait);
    if (options_.wait) {
      look();
      return report(false);
    }
    std::printf(
        "job %s with %s is in the queue; messages go to %s\n"
        "  show the progress and merge results.csv with: %s campaign %s --out %s --status\n",
        job.c_str(), count_text(std::ssize(tasks), "task").c_str(), (out_ / "slurm").c_str(),
        program_name().c_str(), shell_text(options_.file).c_str(), shell_text(out_).c_str());
    return kFine;
  }

 private:
  fs::path results() const { return out_ / "results.csv"; }

  void look() {
    std::ranges::for_each(jobs_, require_own_scene);
    std::ranges::transform(jobs_, records_.begin(), read_record);
  }

  void prepare() const {
    if (holds_run({out_}))
      throw InputError(out_.string(),
                       "holds a run, whose report would be the campaign's; choose another folder "
                       "with --out");
    make_writable({out_});
    write_whole(out_ / "campaign.json", to_text(campaign_));
    warn();
  }

  void warn() const {
    for (const std::string& warning : warnings_of(jobs_))
      std::fprintf(stderr, "warning: %s\n", warning.c_str());
  }

  // What can only be known here: why a run did not even begin.
  void note(std::size_t job, const JobOutcome& outcome) {
    records_[job] = read_record(jobs_[job]);
    records_[job].status = outcome.status;
    records_[job].failure = outcome.failure;
  }

  std::size_t count(JobStatus status) const {
    return static_cast<std::size_t>(std::ranges::count(records_, status, &RunRecord::status));
  }

  // Only of a failure that its summary knows: others were none of a step or a scene.
  void tell_how_to_go_on(const Job& job, const RunRecord& record) const {
    const RunFolder& folder = job.folder;
    const std::string command = program_name() + " run " + shell_text(folder.scene()) +
                                " --continue " + shell_text(folder.state()) + " --out " +
                                shell_text(out_ / "repeats" / job.id) +
                                (campaign_.frames ? "" : " --no-frames");
    const bool known =
        record.summary.is_object() && record.summary.value("failure", Json()) == record.failure;
    const Json kind = known ? record.summary.value("failure_kind", Json()) : Json();
    std::string next;
    if (kind == "run_failed") {
      const auto [what, setting] = other_steps(job.scenario.step.max_halvings);
      next = "repeat its last part with" + what + ": " + command + setting;
    } else if (kind == "scene") {
      next = "change its scene, as in: " + command + " --set PATH=VALUE";
    } else if (kind == "disk_full") {
      next = "once it can be written again, the same command continues it";
    } else if (kind == "memory") {
      next = "where there is more memory, the same command continues it";
    }
    if (!next.empty()) std::fprintf(stderr, "  %s\n", next.c_str());
  }

  void list_failed() const {
    std::size_t listed = 0;
    for (std::size_t i = 0; i < jobs_.size(); ++i) {
      if (records_[i].status != JobStatus::failed) continue;
      if (++listed > kMostListed) continue;
      std::fprintf(stderr, "failed: %s: %s\n", job_name(jobs_[i]).c_str(),
                   records_[i].failure.c_str());
      if (is_there(jobs_[i].folder.state())) tell_how_to_go_on(jobs_[i], records_[i]);
    }
    if (listed > kMostListed) {
      std::fprintf(stderr, "... and %zu more, see %s\n", listed - kMostListed, results().c_str());
    }
  }

  // Writes the table, says what there is, and returns the exit code.
  int report(bool interrupted) const {
    ResultsTable table(jobs_, reported_paths(campaign_.report));
    for (std::size_t i = 0; i < jobs_.size(); ++i) table.set(i, records_[i]);
    make_writable({out_});
    write_whole(results(), table.text());
    list_failed();
    std::string counts;
    for (const JobStatus status : {JobStatus::finished, JobStatus::failed, JobStatus::interrupted,
                                   JobStatus::elsewhere, JobStatus::missing}) {
      if (count(status) == 0) continue;
      counts += (counts.empty() ? "" : ", ") + std::to_string(count(status)) + " " +
                std::string(status_name(status));
    }
    std::printf("%s: %s, %s; results are in %s\n", campaign_.name.c_str(),
                count_text(std::ssize(jobs_), "run").c_str(), counts.c_str(), results().c_str());
    for (const std::string& text : numbers_that_no_run_has(records_, campaign_.report))
      std::fprintf(stderr, "warning: %s\n", text.c_str());
    if (count(JobStatus::elsewhere) > 0)
      std::printf(
          "another process is computing the runs marked as running elsewhere; once it has ended, "
          "the same command computes the rest\n");
    if (interrupted) {
      std::printf("interrupted; the same command continues from there\n");
      return kInterrupted;
    }
    if (count(JobStatus::failed) > 0) return kRunFailed;
    return options_.status || count(JobStatus::finished) == jobs_.size() ? kFine : kRunFailed;
  }

  const CampaignArguments& options_;
  Campaign campaign_;
  fs::path out_;
  std::vector<Job> jobs_;
  std::vector<RunRecord> records_;
};

int run(const CampaignArguments& options) {
  constexpr std::string_view kEngines[] = {"local", "slurm"};
  const bool on_cluster = named(kEngines, options.engine, std::identity(),
                                "--engine " + options.engine, "is not an engine") == "slurm";
  if (options.wait && !on_cluster) throw InputError("--wait", "needs --engine slurm");
  CampaignRun session(options);
  if (options.dry_run) return session.dry_run();
  if (options.status) return session.status();
  if (options.task) return session.run_task(*options.task);
  return on_cluster ? session.run_on_cluster() : session.run_here();
}

}  // namespace

Command add_campaign(CLI::App& program) {
  CLI::App* command = program.add_subcommand(
      "campaign", "Run a scene many times, with different parameters and seeds.");
  const auto options = std::make_shared<CampaignArguments>();
  command->add_option("file", options->file, "campaign file")
      ->type_name("CAMPAIGN.json")
      ->required();
  command->add_option("--out", options->out, "folder for the results [out/<campaign name>]")
      ->type_name("DIR");
  add_threads_option(*command, options->threads, kThreadsOfRuns);
  command->add_flag("--quiet", options->quiet, "print only where the results are");
  command->option_defaults()->group("Cluster");
  command->add_option("--engine", options->engine, "local, or slurm for an array job [local]")
      ->type_name("ENGINE");
  command->add_flag("--wait", options->wait, "with slurm: return when all runs have ended");
  CLI::Option* task =
      command->add_option("--task", options->task, "compute only this chunk of the runs")
          ->type_name("N");
  command->option_defaults()->group("Instead of computing");
  CLI::Option* dry_run =
      command->add_flag("--dry-run", options->dry_run, "check all scenes and list the runs");
  CLI::Option* status =
      command->add_flag("--status", options->status, "print the progress and merge results.csv");
  task->excludes(dry_run)->excludes(status);
  dry_run->excludes(status);
  command->footer(
      "DIR receives one folder per run in runs/, results.csv (one row per run) and campaign.json.\n"
      "The same command, given again, repeats no finished run; with more realizations, a longer\n"
      "list or more values of the grid's first parameter it computes only the new runs. Ctrl-C\n"
      "ends all runs and abandons their current steps.\n\n"
      "Examples:\n"
      "  quicksand campaign assets/campaigns/packing.json --threads 2\n"
      "  quicksand campaign assets/campaigns/packing.json --engine slurm --wait");
  return {command, [options] { return run(*options); }};
}

}  // namespace quicksand
