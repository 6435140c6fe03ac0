// quicksand_bench: measures the solver against its goals. Time is measured here and nowhere asserted.
#include <CLI/CLI.hpp>
#include <algorithm>
#include <cstdio>
#include <exception>

#include "app/exit_code.h"
#include "app/nearest_name.h"
#include "app/run/run_folder.h"
#include "core/errors.h"
#include "tests/bench/cases.h"
#include "tests/bench/paper_states.h"
#include "tests/bench/results.h"

namespace quicksand::bench {

namespace {

int complain(const std::string& problem, int exit_code) {
  std::fprintf(stderr, "quicksand_bench: %s\n", problem.c_str());
  return exit_code;
}

// The named cases in the order of the table, all if none is named. Throws InputError for a name that
// there is not.
std::vector<Case> chosen(const std::vector<std::string>& names) {
  std::vector<std::string> known;
  for (const Case& one : cases()) known.push_back(one.name);
  for (const std::string& name : names)
    if (std::ranges::find(known, name) == known.end())
      throw InputError("\"" + name + "\"", "is no case" + suggestion(name, known));
  std::vector<Case> result;
  for (const Case& one : cases())
    if (names.empty() || std::ranges::find(names, one.name) != names.end()) result.push_back(one);
  return result;
}

Result run_case(const Case& one, const Options& options) {
  Result result{.name = one.name, .outcome = {}, .error = {}};
  try {
    result.outcome = one.run(options);
    for (Run& run : result.outcome.runs) run.name = one.name;
  } catch (const InputError&) {
    throw;
  } catch (const std::exception& failure) {  // the other cases are worth something without it
    result.error = failure.what();
  }
  return result;
}

int run_all(const std::vector<Case>& selected, const Options& options) {
  make_writable({.path = options.out});
  paper_scene(options, options.method);  // refuses a method that there is not before anything runs
  std::vector<Result> results;
  std::fputs(table_header().c_str(), stdout);
  for (const Case& one : selected) {
    if (options.progress != ProgressLine::Style::none)
      std::fprintf(stderr, "case %s (%zu of %zu)\n", one.name.c_str(), results.size() + 1,
                   selected.size());
    results.push_back(run_case(one, options));
    std::fputs(table_rows(results.back(), options).c_str(), stdout);
    std::fflush(stdout);
    write_results(results, options);  // what is measured is not lost
  }
  std::fputs("\n", stdout);
  for (const Result& result : results) std::fputs(remarks(result).c_str(), stdout);
  std::printf("%sresults are in %s\n",
              options.quick ? "small systems, not held to the goals; " : "",
              (options.out / "results.{csv,json}").c_str());
  const bool failed =
      std::ranges::any_of(results, [](const Result& r) { return !r.error.empty(); });
  return failed ? kRunFailed : kFine;
}

int run_command_line(int argc, const char* const* argv) {
  CLI::App program("Measures the solver against its goals, in CPU time of one core.",
                   "quicksand_bench");
  Options options;
  std::vector<std::string> names;
  bool list = false, quiet = false;
  program.add_option("case", names, "cases to run (default: all)");
  program.add_flag("--list", list, "list the cases");
  program.add_option("--out", options.out, "folder of the results and of the prepared states")
      ->capture_default_str();
  program.add_flag("--quick", options.quick, "small systems: shows that it works, takes seconds");
  program
      .add_option("--repeats", options.repeats, "of each measurement (default: each case's own)")
      ->check(CLI::Range(1, 1000));
  program.add_option("--method", options.method, "contact solver, a word of the scene format")
      ->capture_default_str();
  program.add_flag("--fresh", options.fresh, "prepare the states anew");
  program.add_flag("--quiet", quiet, "no progress on standard error");
  program.footer("Example:\n  quicksand_bench intact chain --quick");
  try {
    program.parse(argc, argv);
  } catch (const CLI::Success& request) {
    return program.exit(request);
  } catch (const CLI::ParseError& error) {
    return complain(std::string(error.what()) + " (see `quicksand_bench --help`)", kBadInput);
  }
  options.progress = StatusLine::style_of_stderr(quiet);
  try {
    if (list) {
      for (const Case& one : cases()) std::printf("%-11s %s\n", one.name.c_str(), one.what.c_str());
      return kFine;
    }
    return run_all(chosen(names), options);
  } catch (const InputError& error) {
    return complain(error.where() + ": " + error.what(), kBadInput);
  } catch (const std::exception& error) {
    return complain(std::string("an unexpected error: ") + error.what(), kRunFailed);
  }
}

}  // namespace

}  // namespace quicksand::bench

int main(int argc, char** argv) { return quicksand::bench::run_command_line(argc, argv); }
