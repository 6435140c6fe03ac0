#include "app/bench/problems/record.h"

#include <algorithm>
#include <cstdio>
#include <utility>
#include <vector>

#include "app/base/interrupt.h"
#include "app/bench/problems/recorded_problem.h"
#include "app/run_folder/run_folder.h"
#include "core/base/errors.h"
#include "core/base/format.h"
#include "core/protocol/protocol.h"

namespace quicksand::bench {

namespace {

constexpr const char* kProblem = ".problem";

bool is_problem(const std::filesystem::path& file) { return file.extension() == kProblem; }

// Keeps every stride-th problem of a phase; the stride doubles whenever there are twice as many as wanted.
class Sample {
 public:
  explicit Sample(std::size_t count) : count_(count) {}

  void offer(const PosedProblem& posed, double time) {
    if (seen_++ % stride_ != 0) return;
    RecordedProblem& kept = kept_.emplace_back();
    kept.step.problem = posed.problem;
    kept.step.start = posed.start;
    // What cohesion a row has is not told; the strongest bond's is near, and only the reference starts there.
    for (const ContactRow& row : posed.problem.contacts)
      kept.step.no_force.emplace_back(
          row.cohesive ? posed.problem.force_scale * posed.problem.dt : 0, 0, 0);
    kept.settings = posed.settings;
    kept.from = posed.from;
    kept.time = time;
    if (kept_.size() < 2 * count_) return;
    for (std::size_t k = 0; 2 * k < kept_.size(); ++k) std::swap(kept_[k], kept_[2 * k]);
    kept_.resize(kept_.size() / 2);
    stride_ *= 2;
  }

  // As many as wanted, evenly over what is kept; the sample is empty afterwards.
  std::vector<RecordedProblem> take() {
    std::vector<RecordedProblem> taken;
    const std::size_t count = std::min(count_, kept_.size());
    for (std::size_t k = 0; k < count; ++k)
      taken.push_back(std::move(kept_[k * kept_.size() / count]));
    kept_.clear();
    seen_ = 0;
    stride_ = 1;
    return taken;
  }

 private:
  std::size_t count_, seen_ = 0, stride_ = 1;
  std::vector<RecordedProblem> kept_;
};

int write_phase(Sample& sample, const std::string& phase, const RecordRequest& request) {
  std::vector<RecordedProblem> problems = sample.take();
  for (std::size_t k = 0; k < problems.size(); ++k) {
    RecordedProblem& problem = problems[k];
    static constexpr const char* kThirds[] = {"early", "middle", "late"};
    problem.group = phase + ", " + kThirds[3 * k / problems.size()];
    if (request.progress != ProgressLine::Style::none)
      std::fprintf(stderr, "reference %zu of %zu: %s\n", k + 1, problems.size(),
                   problem.group.c_str());
    problem.reference = solve_tightly(problem.step);
    std::string file = phase + format("_%03zu", k) + kProblem;
    std::ranges::replace(file, ' ', '_');
    write_problem(problem, request.out / file);
  }
  return static_cast<int>(problems.size());
}

}  // namespace

std::vector<std::filesystem::path> problems_in(const std::filesystem::path& folder) {
  std::vector<std::filesystem::path> files;
  if (std::filesystem::is_directory(folder))
    for (const auto& entry : std::filesystem::recursive_directory_iterator(folder))
      if (is_problem(entry)) files.push_back(entry.path());
  std::ranges::sort(files);
  return files;
}

Recording record_problems(const RecordRequest& request) {
  if (std::filesystem::is_directory(request.out) &&
      std::ranges::any_of(std::filesystem::directory_iterator(request.out), is_problem))
    throw InputError(request.out.string(),
                     "already holds recorded problems; choose another folder with --out");
  make_writable({.path = request.out});
  const InterruptWatch watch;
  const Scenario scene = read_scene(request.scene);
  Protocol protocol(scene, start_world(scene));
  Sample sample(static_cast<std::size_t>(request.count));
  protocol.watch_problems(
      [&](const PosedProblem& posed) { sample.offer(posed, protocol.world().time); });
  ProgressLine line(request.progress);
  Recording recording;
  while (const Phase* phase = protocol.phase()) {
    const std::string name =
        std::to_string(protocol.state().phase + 1) + " " + std::string(phase_name(*phase));
    Progress progress = Progress::running;
    while (progress == Progress::running && !watch.interrupted()) {
      progress = protocol.advance();
      line.show(protocol);
    }
    line.end();
    recording.problems += write_phase(sample, name, request);
    recording.interrupted = watch.interrupted();
    if (progress == Progress::failed) recording.failure = protocol.failure();
    if (progress != Progress::phase_ended || recording.interrupted) break;
  }
  return recording;
}

}  // namespace quicksand::bench
