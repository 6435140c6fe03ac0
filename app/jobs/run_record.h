// What the folder of a job says about its run.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>

#include "app/jobs/job.h"
#include "app/json/json_text.h"

namespace quicksand {

// interrupted: there is a state to go on from. missing: nothing that counts is there. elsewhere: another process computes
// it.
enum class JobStatus : std::uint8_t { finished, failed, interrupted, missing, elsewhere };

// "finished", "failed", "interrupted", "missing", "running elsewhere"
std::string_view status_name(JobStatus status);

struct RunRecord {
  JobStatus status = JobStatus::missing;
  std::string failure;       // a sentence, if failed
  Json summary;              // summary.json; null if there is none
  bool other_scene = false;  // the folder holds the run of another scene, which does not count
};

// Throws InputError if a file of the folder is there and cannot be read: it is no reason to compute it again.
RunRecord read_record(const Job& job);

// Throws InputError if the folder of the job holds the run of another scene, which would be lost.
void require_own_scene(const Job& job);

}  // namespace quicksand
