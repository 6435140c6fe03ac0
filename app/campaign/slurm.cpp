#include "app/campaign/slurm.h"

#include <algorithm>

#include "app/base/shell_text.h"
#include "app/run_folder/run_folder.h"
#include "core/base/errors.h"
#include "core/base/whole_file.h"
#include "render/base/external_program.h"

namespace quicksand {

namespace {

namespace fs = std::filesystem;

std::string script(const fs::path& out) {
  return "#!/bin/sh\nexec " + shell_text(fs::read_symlink("/proc/self/exe")) + " campaign " +
         shell_text(out / "campaign.json") + " --out " + shell_text(out) +
         " --task \"$SLURM_ARRAY_TASK_ID\" --threads \"${SLURM_CPUS_PER_TASK:-1}\" --quiet\n";
}

std::vector<std::string> arguments(const Campaign& campaign, const fs::path& out,
                                   std::span<const std::int64_t> tasks, bool wait) {
  const SlurmOptions& slurm = campaign.slurm;
  std::vector<std::string> words{
      "sbatch", "--parsable", "--job-name=" + campaign.name, "--array=" + array_text(tasks),
      "--output=" + escaped_percent((out / "slurm").string()) + "/%a.log"};
  if (wait) words.emplace_back("--wait");
  if (!slurm.partition.empty()) words.push_back("--partition=" + slurm.partition);
  if (!slurm.time.empty()) words.push_back("--time=" + slurm.time);
  if (!slurm.memory.empty()) words.push_back("--mem=" + slurm.memory);
  for (const Json& option : slurm.options) words.push_back(option.get<std::string>());
  words.push_back((out / "slurm.sh").string());
  return words;
}

}  // namespace

std::span<const Job> task_jobs(std::span<const Job> jobs, std::int64_t chunk, std::int64_t task) {
  const auto size = static_cast<std::size_t>(chunk);
  const std::size_t tasks = (jobs.size() + size - 1) / size;
  if (task < 0 || static_cast<std::size_t>(task) >= tasks) {
    throw InputError("--task " + std::to_string(task),
                     "must be from 0 to " + std::to_string(tasks - 1) + " in this campaign");
  }
  const std::size_t first = static_cast<std::size_t>(task) * size;
  return jobs.subspan(first, std::min(size, jobs.size() - first));
}

std::vector<std::int64_t> open_tasks(std::span<const RunRecord> records, std::int64_t chunk) {
  std::vector<std::int64_t> tasks;
  for (std::size_t i = 0; i < records.size(); ++i) {
    if (records[i].status == JobStatus::finished) continue;
    const std::int64_t task = static_cast<std::int64_t>(i) / chunk;
    if (tasks.empty() || tasks.back() != task) tasks.push_back(task);
  }
  return tasks;
}

std::string array_text(std::span<const std::int64_t> tasks) {
  std::string text;
  for (std::size_t i = 0; i < tasks.size();) {
    std::size_t last = i;
    while (last + 1 < tasks.size() && tasks[last + 1] == tasks[last] + 1) ++last;
    text += (text.empty() ? "" : ",") + std::to_string(tasks[i]);
    if (last > i) text += "-" + std::to_string(tasks[last]);
    i = last + 1;
  }
  return text;
}

std::string submit_tasks(const Campaign& campaign, const fs::path& out,
                         std::span<const std::int64_t> tasks, bool wait) {
  const fs::path folder = fs::absolute(out).lexically_normal();
  make_writable({folder / "slurm"});
  write_whole(folder / "slurm.sh", script(folder));
  const ProgramEnd end = run_external(arguments(campaign, folder, tasks, wait));
  if (end.missing) {
    throw InputError("--engine slurm",
                     "sbatch is not installed; submit from a machine of the cluster, or compute "
                     "here with --engine local");
  }
  // "job" or "job;cluster". With --wait the exit code is that of the tasks.
  std::string job = end.answer.substr(0, end.answer.find_first_of(";\n"));
  if (!job.empty()) return job;
  std::string problem = end.problem;
  if (problem.find("array") != std::string::npos) {
    problem += "\n  the cluster may limit the length of arrays: raise \"chunk\" in the campaign";
  }
  throw InputError("--engine slurm", "the job was not accepted: " + problem);
}

}  // namespace quicksand
