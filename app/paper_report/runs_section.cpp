#include "app/paper_report/runs_section.h"

#include <map>

#include "app/base/build_info.h"
#include "app/json/json_reader.h"
#include "app/paper_report/programme.h"

namespace quicksand {

namespace {

std::string commit_of(const RunResults& run) { return run.summary().value("commit", "unknown"); }

// All runs by one method.
struct Totals {
  int wanted = 0, finished = 0;
  double unconverged = 0, halved = 0, broken = 0;
  std::string text() const {
    return std::to_string(finished) + " of " + std::to_string(wanted) +
           " runs finished. Steps accepted without convergence: " + number_text(unconverged) +
           "; steps repeated as two halves: " + number_text(halved) +
           "; bonds broken in unconverged steps: " + number_text(broken) + ".";
  }
};

// Realizations of one experiment.
struct Group {
  std::string name;
  int wanted = 0, finished = 0, moving = 0;
};

}  // namespace

double seconds_of(const PaperResults& results, std::size_t jobs) {
  double seconds = 0;
  for (std::size_t k = 0; k < jobs; ++k)
    if (const RunResults* run = results.run(k))
      seconds += run->final_value("wall_seconds").value_or(0);
  return seconds;
}

std::string commits_of(const PaperResults& results, std::size_t jobs) {
  std::map<std::string, int> runs;
  for (std::size_t k = 0; k < jobs; ++k)
    if (const RunResults* run = results.run(k)) ++runs[commit_of(*run)];
  std::string text;
  for (const auto& [commit, count] : runs)
    text += (text.empty() ? "" : ", ") + std::to_string(count) + " by commit " + commit;
  return text.empty() ? "none" : text;
}

void add_runs(Section& section, const std::string& method, std::span<const Job> jobs,
              std::span<const JobOutcome> outcomes, const PaperResults& results) {
  std::vector<Group> groups;
  BulletList failed;
  Totals exact, nscd;
  int of_others = 0;
  for (std::size_t k = 0; k < jobs.size(); ++k) {
    const std::string name = jobs[k].id.substr(0, jobs[k].id.rfind('/'));
    if (groups.empty() || groups.back().name != name) groups.push_back({.name = name});
    Group& group = groups.back();
    ++group.wanted;
    Totals& totals = jobs[k].scenario.step.nscd ? nscd : exact;
    ++totals.wanted;
    if (const RunResults* run = results.run(k)) {
      ++totals.finished;
      ++group.finished;
      group.moving += run->summary().value("missed_rest", false) ? 1 : 0;
      totals.unconverged += run->final_value("unconverged_steps").value_or(0);
      totals.halved += run->final_value("halved_steps").value_or(0);
      totals.broken += run->final_value("bonds_broken_in_unconverged_steps").value_or(0);
      of_others += commit_of(*run) != build_info().commit ? 1 : 0;
    } else if (outcomes[k].status == JobStatus::failed) {
      failed.items.push_back(jobs[k].id + ": " + outcomes[k].failure);
    }
  }
  // A part of the programme may push the same specimens by both methods.
  for (const auto& [totals, name] : {std::pair{&exact, kExactMethod}, {&nscd, kNscdMethod}})
    if (totals->wanted > 0)
      section.add(Paragraph{method_title(std::string(name)) + ": " + totals->text()});
  section.add(Paragraph{"Computed: " + commits_of(results, jobs.size()) +
                        ". Each run's folder holds its scene, series, summary and final state."});
  if (of_others > 0)
    section.add(Remark{Remark::Kind::note,
                       std::to_string(of_others) +
                           " of these runs were made by builds other than the one that wrote this "
                           "report; their scenes are identical to this build's."});
  Table table{
      .caption =
          "Runs by experiment. Moving: runs that reached the max_time of their last phase before "
          "everything had come to rest. Unfinished runs are missing from the means, as n shows.",
      .columns = {{.title = "runs of " + method},
                  {.title = "planned", .number = true},
                  {.title = "finished", .number = true},
                  {.title = "moving", .number = true}}};
  for (const Group& group : groups)
    table.rows.push_back({{group.name},
                          {std::to_string(group.wanted)},
                          {std::to_string(group.finished)},
                          {std::to_string(group.moving)}});
  section.add(std::move(table));
  if (failed.items.empty()) return;
  section.add(Remark{Remark::Kind::warning, "These runs failed."});
  section.add(std::move(failed));
}

}  // namespace quicksand
