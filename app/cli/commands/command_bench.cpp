// quicksand bench: speed against error, hard cases, and costs, with a report.
#include <algorithm>
#include <chrono>
#include <cstdio>
#include <memory>

#include "app/base/exit_code.h"
#include "app/base/interrupt.h"
#include "app/base/machine.h"
#include "app/base/nearest_name.h"
#include "app/bench/against.h"
#include "app/bench/goals/goal_cases.h"
#include "app/bench/paper_states.h"
#include "app/bench/problems/record.h"
#include "app/bench/results.h"
#include "app/cli/commands.h"
#include "app/options/number_range.h"
#include "app/options/scene_options.h"
#include "app/report/provenance.h"
#include "app/run_folder/run_folder.h"
#include "core/base/errors.h"
#include "core/base/format.h"
#include "core/base/parallel.h"

namespace quicksand {

namespace {

using namespace bench;

struct Request {
  bench::Options options;
  std::vector<std::string> names;  // of parts, and of cases of the goals
  std::vector<std::filesystem::path> compare;
  std::filesystem::path against;
  bool with_peers = false;
  bool list = false;
  bool quiet = false;
};

struct Planned {
  const Part* part;
  Task task;
};

std::vector<Planned> planned(const Request& request) {
  std::vector<std::string> known;
  for (const Part& part : parts()) known.emplace_back(part.name);
  for (const Case& one : cases()) known.push_back(one.name);
  for (const std::string& name : request.names)
    if (std::ranges::find(known, name) == known.end())
      refuse_name("\"" + name + "\"", "is neither a part nor a goal", name, known);
  const auto named = [&](std::string_view name) {
    return std::ranges::find(request.names, name) != request.names.end();
  };
  const auto wanted = [&](const Part& part) {
    return named(part.name) || (request.names.empty() && part.by_default) ||
           (request.with_peers && part.name == "peers");
  };
  std::vector<Planned> all;
  for (const Part& part : parts()) {
    const bool whole = wanted(part);
    if (!whole && part.name != "goals") continue;
    for (Task& task : part.tasks(request.options))
      if (whole || named(task.name)) all.push_back({&part, std::move(task)});
  }
  return all;
}

std::string command_of(const Request& request) {
  std::vector<std::string> words{"quicksand", "bench"};
  words.insert(words.end(), request.names.begin(), request.names.end());
  if (request.options.quick) words.emplace_back("--quick");
  if (request.options.fresh) words.emplace_back("--fresh");
  if (request.with_peers) words.emplace_back("--peers");
  if (request.options.method != bench::Options{}.method)
    words.insert(words.end(), {"--method", request.options.method});
  if (!request.options.problems.empty())
    words.insert(words.end(), {"--problems", request.options.problems.string()});
  if (request.options.tuning) words.emplace_back("--tuning");
  if (request.options.repeats > 0)
    words.insert(words.end(), {"--repeats", std::to_string(request.options.repeats)});
  words.insert(words.end(), {"--out", request.options.out.string()});
  return command_text(words);
}

Report report_of(const Request& request, const std::vector<Row>& rows, double seconds,
                 std::size_t missing) {
  Report report{.title = "quicksand: speed against error"};
  report.intro = {
      "Times are CPU seconds of one thread. The residual is the program's own measure of a "
      "solution (core/problem/residual.h), over the force scale times dt; velocity errors are "
      "against a tight reference solution, the worst of a disk, in units of g dt, the velocity of "
      "free fall over a step."};
  if (request.options.quick)
    report.intro.emplace_back("A quick run: small systems, so that it ends within minutes.");
  if (missing > 0)
    report.intro.push_back("The run was interrupted: " + std::to_string(missing) +
                           " of its tasks are missing.");
  for (const Part& part : parts()) {
    std::vector<Row> own;
    for (const Row& row : rows)
      if (row.part == part.name) own.push_back(row);
    if (own.empty()) continue;
    Section section{.title = std::string(part.title)};
    part.report(own, request.options, section);
    BulletList failures;
    for (const Row& row : own)
      if (row.what == "failed") failures.items.push_back(row.name + ": " + row.found);
    if (!failures.items.empty()) section.add(std::move(failures));
    report.sections.push_back(std::move(section));
  }
  report.provenance = provenance(command_of(request), seconds);
  report.provenance.emplace_back("load of the machine at the end",
                                 format("%.1f running processes, ours included", machine().load));
  return report;
}

void run_task(const Planned& planned, std::vector<Row>& rows) {
  std::vector<Row> own;
  try {
    planned.task.run(own);
  } catch (const Interrupted&) {
    throw;
  } catch (const InputError& failure) {  // the other tasks are worth something without it
    own.push_back(
        {.what = "failed", .found = failure.where() + ": " + failure.what(), .passed = false});
  } catch (const std::exception& failure) {
    own.push_back({.what = "failed", .found = failure.what(), .passed = false});
  }
  for (Row& row : own) {
    row.part = planned.part->name;
    if (row.name.empty()) row.name = planned.task.name;
    rows.push_back(row);
  }
}

int run(const Request& request) {
  using Clock = std::chrono::steady_clock;
  const InterruptWatch watch;
  const std::vector<Planned> tasks = planned(request);
  make_writable({.path = request.options.out});
  const auto begin = Clock::now();
  const auto elapsed = [&] { return std::chrono::duration<double>(Clock::now() - begin).count(); };
  std::vector<Row> rows;
  std::size_t done = 0;
  for (const Planned& next : tasks) {
    if (watch.interrupted()) break;
    if (request.options.progress != StatusLine::Style::none)
      std::fprintf(stderr, "%3zu of %zu  %s: %s%s\n", done + 1, tasks.size(),
                   std::string(next.part->name).c_str(), next.task.name.c_str(),
                   done == 0 ? ""
                             : ("  (" + duration_text(elapsed()) + " so far, about " +
                                duration_text(elapsed() / static_cast<double>(done) *
                                              static_cast<double>(tasks.size() - done)) +
                                " left)")
                                   .c_str());
    try {
      with_threads(1, [&] { run_task(next, rows); });  // measures are of one core
    } catch (const Interrupted&) {
      break;
    }
    ++done;
    write_results(rows, request.options, command_of(request));  // what is measured is not lost
  }
  write_results(rows, request.options, command_of(request));
  const Report report = report_of(request, rows, elapsed(), tasks.size() - done);
  for (const std::string& problem : write_report(report, request.options.out))
    std::fprintf(stderr, "quicksand: %s\n", problem.c_str());
  int failed = 0;
  for (const Row& row : rows) {
    if (row.passed.value_or(true) || row.what == "peer") continue;
    ++failed;
    std::printf("not passed: %s, %s: %s\n", row.part.c_str(), row.name.c_str(), row.found.c_str());
  }
  std::printf("%zu of %zu tasks in %s, %d answers not passed\n%s\n%s\n", done, tasks.size(),
              duration_text(elapsed()).c_str(), failed,
              (request.options.out / "report.html").c_str(),
              (request.options.out / "results.json").c_str());
  if (!request.against.empty())
    std::fputs(
        ratio_table(read_results(request.against), json(rows, request.options, command_of(request)))
            .c_str(),
        stdout);
  if (done < tasks.size()) return kInterrupted;
  return failed == 0 ? kFine : kRunFailed;
}

int bench_command(Request& request) {
  if (request.list) {
    for (const Part& part : parts())
      std::printf("%-12s %s\n", std::string(part.name).c_str(), std::string(part.what).c_str());
    std::printf("cases of goals:\n");
    for (const Case& one : cases()) std::printf("  %-12s %s\n", one.name.c_str(), one.what.c_str());
    return kFine;
  }
  if (!request.compare.empty()) {
    const Json before = read_results(request.compare.at(0));
    std::fputs(ratio_table(before, read_results(request.compare.at(1))).c_str(), stdout);
    return kFine;
  }
  if (!request.against.empty()) read_results(request.against);  // refused before anything runs
  paper_scene(request.options, request.options.method);         // so is a method that there is not
  request.options.progress = StatusLine::style_of_stderr(request.quiet);
  return run(request);
}

int record_command(RecordRequest& request, bool quiet) {
  request.progress = StatusLine::style_of_stderr(quiet);
  const Recording recording = record_problems(request);
  std::printf(
      "%d problems in %s\n%s\n", recording.problems, request.out.c_str(),
      command_text({"quicksand", "bench", "problems", "--problems", request.out.string()}).c_str());
  if (!recording.failure.empty())
    std::fprintf(stderr, "quicksand: the run failed: %s\n", recording.failure.c_str());
  return recording.interrupted ? kInterrupted : !recording.failure.empty() ? kRunFailed : kFine;
}

// Adds `bench record`; what it returns runs it.
std::pair<CLI::App*, std::function<int()>> add_record(CLI::App& bench) {
  CLI::App* command =
      bench.add_subcommand("record", "Record the contact problems that a run meets.");
  const auto request = std::make_shared<RecordRequest>();
  const auto quiet = std::make_shared<bool>(false);
  add_scene_options(*command, request->scene);
  command->add_option("--out", request->out, "folder for the problems [out/problems]")
      ->type_name("DIR");
  command
      ->add_option("--count", request->count,
                   "problems from each phase, 3 to 1000, spread evenly over it [100]")
      ->type_name("N")
      ->check(whole_in_range(3, 1000));
  command->add_flag("--quiet", *quiet, "show no progress");
  command->footer(
      "Examples:\n"
      "  quicksand bench record assets/scenes/collapse.json --out out/problems\n"
      "  quicksand bench problems --problems out/problems --out out/solved");
  return {command, [request, quiet] { return record_command(*request, *quiet); }};
}

}  // namespace

Command add_bench(CLI::App& program) {
  CLI::App* command = program.add_subcommand(
      "bench", "Measure speed against error, hard cases and costs, and write a report.");
  const auto request = std::make_shared<Request>();
  command
      ->add_option(
          "parts", request->names,
          "one or more of the following, or all but problems, serve and peers if none is given: " +
              joined(parts(), ", ", &Part::name) + "; or a case of goals")
      ->type_name("PART");
  command->add_option("--out", request->options.out, "folder for results and states [out/bench]")
      ->type_name("DIR");
  command->add_flag("--list", request->list, "list the parts");
  command->add_flag("--quiet", request->quiet, "show no progress");
  command->option_defaults()->group("Measurements");
  command->add_flag("--quick", request->options.quick, "small systems; takes under three minutes");
  command
      ->add_option("--repeats", request->options.repeats,
                   "repeats of each measurement, 1 to 1000 [set by each case]")
      ->type_name("N")
      ->check(whole_in_range(1, 1000));
  command
      ->add_option("--method", request->options.method,
                   "contact solver of the goals and the recorded problems [auto]")
      ->type_name("NAME");
  command->add_flag("--fresh", request->options.fresh, "prepare the stored states again");
  command->add_flag("--peers", request->with_peers, "measure other programs too, where installed");
  command
      ->add_option("--problems", request->options.problems,
                   "folder of recorded problems [made from a standard scene]")
      ->type_name("DIR");
  command->add_flag("--tuning", request->options.tuning,
                    "measure the half of them used for tuning the solvers");
  command->option_defaults()->group("Comparison");
  command
      ->add_option("--against", request->against,
                   "results.json of an earlier run: show how the times have changed")
      ->type_name("FILE");
  command
      ->add_option("--compare", request->compare,
                   "measure nothing; show the second results.json relative to the first")
      ->type_name("FILE")
      ->expected(2);
  command->footer(
      "DIR receives results.csv, results.json, report.html, report.md and plots/.\n\n"
      "Examples:\n  quicksand bench --quick --out out/bench\n"
      "  quicksand bench precision --quick --against out/bench/results.json --out out/now");
  const auto [record, run_record] = add_record(*command);
  return {command, [request, record = record, run_record = run_record] {
            return record->parsed() ? run_record() : bench_command(*request);
          }};
}

}  // namespace quicksand
