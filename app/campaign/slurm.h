// Campaigns on a cluster: an array job of Slurm, each task of which computes a chunk of the runs with
// this program. What each run leaves in its folder is all that is passed on.
#pragma once

#include <cstdint>
#include <filesystem>
#include <span>
#include <string>
#include <vector>

#include "app/campaign/campaign.h"
#include "app/jobs/run_record.h"

namespace quicksand {

// The runs of a task, as a part of all.
std::span<const Job> task_jobs(std::span<const Job> jobs, std::int64_t chunk, std::int64_t task);

// Numbers of the tasks with a run that has not finished.
std::vector<std::int64_t> open_tasks(std::span<const RunRecord> records, std::int64_t chunk);

// Ascending numbers as sbatch takes them: "0-3,7".
std::string array_text(std::span<const std::int64_t> tasks);

// Writes OUT/slurm.sh, which computes a task of OUT/campaign.json, and submits it with sbatch; the
// tasks' messages go to OUT/slurm/TASK.log. With `wait` it returns when all tasks have ended. Returns
// the number of the job. Throws InputError if sbatch is not installed or refuses the job.
std::string submit_tasks(const Campaign& campaign, const std::filesystem::path& out,
                         std::span<const std::int64_t> tasks, bool wait);

}  // namespace quicksand
