#include "app/jobs/job_pool.h"

#include <algorithm>
#include <atomic>
#include <cassert>
#include <chrono>
#include <condition_variable>
#include <deque>
#include <mutex>
#include <new>
#include <optional>
#include <thread>

#include "app/base/interrupt.h"
#include "app/jobs/pool_progress.h"
#include "app/jobs/run_place.h"
#include "app/run/resumption.h"
#include "app/run/run_scene.h"
#include "app/run_folder/folder_lock.h"
#include "core/base/errors.h"
#include "core/base/parallel.h"
#include "render/picture/renderer.h"

namespace quicksand {

namespace {

JobOutcome failed(std::string why) { return {JobStatus::failed, std::move(why), true}; }

// One run, from where an earlier one of the same job stopped. `anew`: what is there does not count.
JobOutcome compute(const Job& job, bool anew, bool frames, RunPlace& place) {
  try {
    const FolderLock lock(job.folder.path);
    if (!lock.held()) return {JobStatus::elsewhere, {}, false};
    const RunRecord record = anew ? RunRecord{} : read_record(job);
    // By another process, since this one began.
    if (record.status == JobStatus::finished) return {JobStatus::finished, {}, false};
    RunOptions options;
    options.out = job.folder.path;
    options.frames = frames;
    // Hundreds of runs are looked at by their numbers.
    if (!frames) options.history_limit = 0;
    options.quiet = true;
    options.lock = false;
    options.watch = [&](const Protocol& protocol) { place.note(protocol); };
    if (record.status != JobStatus::missing &&
        resumption_of(job.folder, frames).how == Resumption::How::goes_on)
      options.continued_from = job.folder.state();
    const RunResult result = run_scene(job.scenario, options);
    switch (result.end.how) {
      case RunEnd::How::finished:
        return {JobStatus::finished, {}, true};
      case RunEnd::How::interrupted:
        return {JobStatus::interrupted, {}, true};
      case RunEnd::How::failed:
        return failed(result.end.failure);
    }
    return {};
  } catch (const InputError& error) {
    return failed(error.where() + ": " + error.what());
  } catch (const std::bad_alloc&) {
    return failed("there is not enough memory for it");
  } catch (const std::exception& error) {
    return failed(error.what());
  }
}

// False, too, where its folder cannot be read: who computes it says why.
bool is_finished(const Job& job) {
  try {
    return read_record(job).status == JobStatus::finished;
  } catch (const InputError&) {
    return false;
  }
}

class Pool {
 public:
  Pool(std::span<const Job> jobs, const PoolOptions& options)
      : jobs_(jobs),
        options_(options),
        states_(jobs.size(), State::waiting),
        places_(jobs.begin(), jobs.end()),
        progress_(jobs.size(), options.quiet) {
    report_.outcomes.resize(jobs.size());
    for (std::size_t i = 0; i < jobs.size(); ++i) {
      assert(!jobs[i].after || *jobs[i].after < i);
    }
    find_finished();
  }

  PoolReport complete() {
    const std::size_t most = std::max<std::size_t>(jobs_.size(), 1);
    const std::size_t threads = std::min(static_cast<std::size_t>(all_threads_), most);
    {
      std::vector<std::jthread> workers;
      workers.reserve(threads);
      // However this block is left, the workers end after their present runs.
      const Ending ending{*this};
      for (std::size_t i = 0; i < threads; ++i) workers.emplace_back([this] { work(); });
      watch_workers(threads);
    }
    progress_.end();
    report_.interrupted = watch_.interrupted();
    return std::move(report_);
  }

 private:
  enum class State : std::uint8_t { waiting, running, ended };

  // Tells the workers to take no further job.
  struct Ending {
    Pool& pool;
    ~Ending() {
      const std::lock_guard lock(pool.mutex_);
      pool.closing_ = true;
      pool.changed_.notify_all();
    }
  };

  // So that the progress counts them from the beginning.
  void find_finished() {
    for (std::size_t i = 0; i < jobs_.size(); ++i) {
      const std::optional<std::size_t> before = jobs_[i].after;
      if (before && states_[*before] != State::ended) continue;
      if (is_finished(jobs_[i])) end(i, {JobStatus::finished, {}, false});
    }
  }

  void work() {
    std::unique_lock lock(mutex_);
    while (const std::optional<std::size_t> next = wait_for_job(lock)) {
      const Job& job = jobs_[*next];
      begin(*next);
      // What started from a state that is computed again is computed again.
      const bool anew = job.after && report_.outcomes[*job.after].computed;
      lock.unlock();
      JobOutcome outcome;
      with_threads(all_threads_, threads_a_run_,
                   [&] { outcome = compute(job, anew, options_.frames, places_[*next]); });
      lock.lock();
      end(*next, std::move(outcome));
    }
    ++workers_gone_;
    changed_.notify_all();
  }

  // The first job that can be run; none when there is nothing left to do.
  std::optional<std::size_t> wait_for_job(std::unique_lock<std::mutex>& lock) {
    while (!closing_ && !watch_.interrupted()) {
      const std::optional<std::size_t> job = ready_job();
      if (job) return job;
      const bool later = std::ranges::find(states_, State::waiting) != states_.end();
      if (!later) break;
      changed_.wait_for(lock, kLook);
    }
    return std::nullopt;
  }

  std::optional<std::size_t> ready_job() {
    while (first_ < jobs_.size() && states_[first_] != State::waiting) ++first_;
    for (std::size_t i = first_; i < jobs_.size(); ++i) {
      if (states_[i] != State::waiting) continue;
      const std::optional<std::size_t> before = jobs_[i].after;
      if (!before) return i;
      if (states_[*before] != State::ended) continue;
      const JobOutcome& start = report_.outcomes[*before];
      if (start.status == JobStatus::finished) return i;
      JobOutcome outcome;
      if (start.status == JobStatus::failed) {
        outcome = failed("starts from run " + jobs_[*before].id + ", which failed");
        outcome.computed = false;
      }
      end(i, std::move(outcome));
    }
    return std::nullopt;
  }

  void begin(std::size_t job) {
    states_[job] = State::running;
    under_way_.push_back(job);
    share_threads();
  }

  void end(std::size_t job, JobOutcome outcome) {
    states_[job] = State::ended;
    std::erase(under_way_, job);
    share_threads();
    progress_.count(outcome.computed, outcome.status == JobStatus::failed);
    report_.outcomes[job] = std::move(outcome);
    news_.push_back(job);
    changed_.notify_all();
  }

  void share_threads() {
    threads_a_run_ = all_threads_ / std::max(1, static_cast<int>(under_way_.size()));
  }

  // Tells what has ended, until all workers have gone.
  void watch_workers(std::size_t threads) {
    std::unique_lock lock(mutex_);
    while (true) {
      while (!news_.empty()) {
        const std::size_t job = news_.front();
        news_.pop_front();
        const JobOutcome outcome = report_.outcomes[job];
        lock.unlock();
        if (options_.ended) options_.ended(job, outcome);
        lock.lock();
      }
      if (progress_.due()) {
        std::vector<RunUnderWay> seen;
        for (const std::size_t job : under_way_) seen.push_back(places_[job].seen());
        progress_.show(seen);
      }
      if (workers_gone_ == threads && news_.empty()) return;
      changed_.wait_for(lock, kLook);
    }
  }

  // How soon a signal is noticed, and the time between looks at the progress.
  static constexpr std::chrono::milliseconds kLook{100};

  InterruptWatch watch_;  // outlives those of the runs, so that none forgets a signal
  std::span<const Job> jobs_;
  const PoolOptions& options_;
  const int all_threads_ = std::max(options_.threads, 1);
  std::atomic<int> threads_a_run_ = 1;

  std::mutex mutex_;
  std::condition_variable changed_;
  // Shared by the threads.
  std::vector<State> states_;
  std::deque<RunPlace> places_;
  std::vector<std::size_t> under_way_;  // in the order in which they began
  std::size_t first_ = 0;               // no job before this one waits
  std::deque<std::size_t> news_;        // jobs that have ended and were not told yet
  std::size_t workers_gone_ = 0;
  bool closing_ = false;
  PoolReport report_;
  PoolProgress progress_;
};

}  // namespace

std::size_t PoolReport::count(JobStatus status) const {
  return static_cast<std::size_t>(std::ranges::count(outcomes, status, &JobOutcome::status));
}

PoolReport run_jobs(std::span<const Job> jobs, const PoolOptions& options) {
  // A system that cannot draw says so now; and the first renderer changes the environment, which must
  // not happen beside other threads.
  if (options.frames) const Renderer first;
  return Pool(jobs, options).complete();
}

}  // namespace quicksand
