#include "app/slurm.h"

#include <fcntl.h>
#include <spawn.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <system_error>

#include "app/run_folder.h"
#include "app/shell_text.h"
#include "core/errors.h"

namespace quicksand {

namespace {

namespace fs = std::filesystem;

// Slurm reads a percent sign in a file name as the start of a number.
std::string escape_percent(const std::string& text) {
  std::string escaped;
  for (const char c : text) escaped += c == '%' ? std::string("%%") : std::string(1, c);
  return escaped;
}

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
      "--output=" + escape_percent((out / "slurm").string()) + "/%a.log"};
  if (wait) words.emplace_back("--wait");
  if (!slurm.partition.empty()) words.push_back("--partition=" + slurm.partition);
  if (!slurm.time.empty()) words.push_back("--time=" + slurm.time);
  if (!slurm.memory.empty()) words.push_back("--mem=" + slurm.memory);
  for (const Json& option : slurm.options) words.push_back(option.get<std::string>());
  words.push_back((out / "slurm.sh").string());
  return words;
}

// Runs a program from PATH, without a shell, and waits for it. Returns errno if it cannot be started.
int run(std::vector<std::string> words, const fs::path& answer, const fs::path& messages) {
  std::vector<char*> argv;
  argv.reserve(words.size() + 1);
  for (std::string& word : words) argv.push_back(word.data());
  argv.push_back(nullptr);
  constexpr int kWrite = O_WRONLY | O_CREAT | O_TRUNC;
  posix_spawn_file_actions_t files;
  posix_spawn_file_actions_init(&files);
  posix_spawn_file_actions_addopen(&files, STDIN_FILENO, "/dev/null", O_RDONLY, 0);
  posix_spawn_file_actions_addopen(&files, STDOUT_FILENO, answer.c_str(), kWrite, 0644);
  posix_spawn_file_actions_addopen(&files, STDERR_FILENO, messages.c_str(), kWrite, 0644);
  pid_t child = 0;
  const int error = posix_spawnp(&child, argv[0], &files, nullptr, argv.data(), environ);
  posix_spawn_file_actions_destroy(&files);
  if (error != 0) return error;
  int status = 0;
  while (waitpid(child, &status, 0) < 0) {
    if (errno != EINTR) return errno;
  }
  return 0;
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
  const fs::path answer = folder / "slurm" / "sbatch.out",
                 messages = folder / "slurm" / "sbatch.err";
  const int error = run(arguments(campaign, folder, tasks, wait), answer, messages);
  if (error == ENOENT) {
    throw InputError("--engine slurm",
                     "sbatch is not installed; submit from a machine of the cluster, or compute "
                     "here with --engine local");
  }
  if (error != 0) {
    throw InputError("--engine slurm", "sbatch: " + std::generic_category().message(error));
  }
  std::string job = read_text(answer);
  std::string problem = read_text(messages);
  fs::remove(answer);
  fs::remove(messages);
  // "job" or "job;cluster"
  job = job.substr(0, job.find_first_of(";\n"));
  if (!job.empty()) return job;
  while (!problem.empty() && problem.back() == '\n') problem.pop_back();
  if (problem.find("array") != std::string::npos) {
    problem += "\n  the cluster may limit the length of arrays: raise \"chunk\" in the campaign";
  }
  throw InputError("--engine slurm", "the job was not accepted: " + problem);
}

}  // namespace quicksand
