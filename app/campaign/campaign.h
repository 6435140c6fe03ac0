// A campaign: one scene, many runs. A file names the base scene, the parameters that vary as paths
// into it (those of `run --set`), and the number of realizations, which differ by their seed.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "app/campaign/report_choices.h"
#include "app/jobs/job.h"
#include "app/json/json_text.h"

namespace quicksand {

// More runs than this are taken for a mistake.
constexpr std::int64_t kMaxRuns = 100'000;

// What sbatch is told; empty texts are left to the cluster.
struct SlurmOptions {
  std::string partition;
  std::string time;    // limit of a task
  std::string memory;  // of a task
  Json options;        // further words for sbatch, a list of texts
};

struct Campaign {
  std::string name;
  std::string description;
  Json scene;  // an object; in a file also the path of one
  Json set;    // path -> value, for all runs
  Json grid;   // path -> list of values; all combinations
  Json list;   // list of path -> value; with a grid, each entry with each combination
  std::int64_t realizations = 1;
  bool frames = false;
  ReportChoices report;
  std::int64_t chunk = 1;  // runs that a Slurm task computes
  SlurmOptions slurm;
};

// Reads the file and the scene that it names. Afterwards campaign and scene have names, the scene is
// an object, and start_from is absolute wherever it stands: the campaign means the same in any
// folder. Throws InputError.
Campaign read_campaign(const std::filesystem::path& file);

// As text that read_campaign reads to the same campaign.
std::string to_text(const Campaign& campaign);

// The paths that vary from run to run, as written, those of the list first.
std::vector<std::string> parameter_paths(const Campaign& campaign);

// All runs, each validated: entries of the list, then the grid with its first path varying slowest,
// realizations fastest. The result of run k is in OUT/runs/k. Throws InputError, whose `where` names
// `file`, the path inside the scene and the run, if any scene is not valid, two runs are the same, a
// state to start from cannot be read, or there are more than kMaxRuns.
std::vector<Job> campaign_jobs(const Campaign& campaign, const std::filesystem::path& file,
                               const std::filesystem::path& out);

// What their scenes ask for and will not get, a sentence each, with the number of runs that it is of.
std::vector<std::string> warnings_of(std::span<const Job> jobs);

// JSON Schema, draft 07, of campaign files.
Json campaign_schema();

}  // namespace quicksand
