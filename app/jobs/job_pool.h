// Runs jobs over threads, each alone in its folder by run_scene, so that results do not depend on the number of
// threads. When at most half as many jobs as threads are left, the loops of their solutions share the threads.
// Runs that have finished are not repeated, interrupted ones go on from their state, failed ones are recorded and
// stop nothing but what starts from them. Those that another process computes are left to it.
#pragma once

#include <functional>
#include <span>
#include <string>
#include <vector>

#include "app/jobs/job.h"
#include "app/jobs/run_record.h"

namespace quicksand {

struct JobOutcome {
  JobStatus status = JobStatus::missing;
  std::string failure;    // a sentence, if failed
  bool computed = false;  // now, not found finished
};

struct PoolOptions {
  int threads = 1;
  bool frames = false;
  bool quiet = false;
  // Called for every job that has ended or was found finished, one at a time.
  std::function<void(std::size_t job, const JobOutcome& outcome)> ended = {};
};

struct PoolReport {
  std::vector<JobOutcome> outcomes;  // (jobs)
  bool interrupted = false;          // by a signal; what was running is saved
  std::size_t count(JobStatus status) const;
};

// Throws RenderError, before anything is computed, if frames are wanted and this system cannot draw.
// Ctrl-C ends the runs after their present steps. What goes wrong in a run, an InputError of its
// folder included, is its outcome; what `ended` throws leaves the pool after
// the present runs.
PoolReport run_jobs(std::span<const Job> jobs, const PoolOptions& options);

}  // namespace quicksand
