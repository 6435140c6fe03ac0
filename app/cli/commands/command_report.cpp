// quicksand report: a readable page about finished runs.
#include <cstdio>
#include <limits>
#include <memory>
#include <optional>

#include "app/base/exit_code.h"
#include "app/campaign_report/campaign_report.h"
#include "app/cli/commands.h"
#include "app/report/provenance.h"
#include "app/run_folder/run_folder.h"
#include "app/run_report/run_report.h"
#include "app/serve/film_page.h"
#include "core/base/errors.h"

namespace quicksand {

namespace {

struct ReportArguments {
  std::vector<std::filesystem::path> folders;
  std::filesystem::path out;
  std::string from;
};

// A page beside the report in which the run plays, where it has a history; the report links to it.
void add_film_page(Report& page, const RunFolder& run, const std::filesystem::path& out) {
  if (!is_there(run.history())) return;
  const RunFolder folder{out};
  make_writable(folder);
  try {
    constexpr auto kEnd = std::numeric_limits<std::size_t>::max();
    if (write_film_page(folder.film_page(), run, View{}, 0, kEnd) == 0) return;
  } catch (const InputError& error) {
    std::fprintf(stderr, "quicksand: %s: %s\n", error.where().c_str(), error.what());
    return;
  }
  const std::string name = folder.film_page().filename().string();
  Cell cell{.text = "The run, to be walked through in a browser:", .links = {{name, name}}};
  page.lead.emplace_back(Table{.columns = {{.title = "Timeline"}}, .rows = {{std::move(cell)}}});
}

int write(Report page, const std::vector<std::string>& words, std::optional<double> seconds,
          const std::filesystem::path& out) {
  page.provenance = provenance(command_text(words), seconds);
  for (const std::string& problem : write_report(page, out)) {
    std::fprintf(stderr, "quicksand: %s\n", problem.c_str());
  }
  std::printf("%s\n%s\n", (out / "report.html").c_str(), (out / "report.md").c_str());
  return kFine;
}

int report_of_campaign(const ReportArguments& options) {
  const std::filesystem::path& folder = options.folders.front();
  if (options.folders.size() > 1)
    throw InputError(folder.string(), "is a campaign; give it on its own");
  if (!options.from.empty()) throw InputError("--from", "applies to runs, but this is a campaign");
  std::vector<std::string> words{"quicksand", "report", folder.string()};
  if (!options.out.empty()) words.insert(words.end(), {"--out", options.out.string()});
  double seconds = 0;
  Report page = campaign_report(folder, seconds);
  return write(std::move(page), words, seconds, options.out.empty() ? folder : options.out);
}

int report(const ReportArguments& options) {
  if (is_campaign(options.folders.front())) return report_of_campaign(options);
  std::vector<RunResults> runs;
  std::vector<std::string> words{"quicksand", "report"};
  std::optional<double> seconds;
  for (const std::filesystem::path& folder : options.folders) {
    runs.emplace_back(folder);
    words.push_back(folder.string());
    if (!runs.back().recorded())
      seconds = seconds.value_or(0) + runs.back().final_value("wall_seconds").value_or(0);
  }
  std::filesystem::path out = options.out;
  if (out.empty()) {
    out = runs.size() == 1 ? options.folders.front() : std::filesystem::path("out") / "report";
  } else {
    words.insert(words.end(), {"--out", out.string()});
  }
  if (!options.from.empty()) words.insert(words.end(), {"--from", options.from});
  Report page = run_report(runs, options.from);
  if (runs.size() == 1) add_film_page(page, runs.front().folder(), out);
  return write(std::move(page), words, seconds, out);
}

}  // namespace

Command add_report(CLI::App& program) {
  CLI::App* command = program.add_subcommand(
      "report",
      "Write a report on a finished run, on several runs side by side, or on a campaign.");
  const auto options = std::make_shared<ReportArguments>();
  command
      ->add_option("runs", options->folders,
                   "folders of runs or of session recordings, or the folder of a campaign")
      ->type_name("DIR")
      ->required();
  command
      ->add_option(
          "--out", options->out,
          "folder for the report [that of a single run or campaign; out/report for several runs]")
      ->type_name("DIR");
  command
      ->add_option("--from", options->from,
                   "name of the phase at whose start time histories begin, as time 0; this aligns "
                   "runs whose earlier phases took different times")
      ->type_name("PHASE");
  command->footer(
      "Writes report.html (a single file, easy to send), film.html beside it for a single run\n"
      "(at most 20 MB; plays the history of the run offline), report.md, plots/ (CSV, gnuplot\n"
      "script, PNG and SVG of each) and pictures/. Plots need gnuplot; without it, only their\n"
      "data and scripts are written.\n\n"
      "For a campaign it shows means over realizations with standard errors, as chosen under\n"
      "\"report\" in the campaign file.\n\n"
      "Examples:\n"
      "  quicksand report out/collapse\n"
      "  quicksand report out/collapse out/strong --from push --out out/comparison");
  return {command, [options] { return report(*options); }};
}

}  // namespace quicksand
