// What the runs of the paper's experiments left, by group of realizations. Runs that did not finish are
// left out of every mean, and the mean says over how many runs it is.
#pragma once

#include <filesystem>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "app/paper/paper_jobs.h"
#include "app/run_report/run_results.h"
#include "app/targets/comparison.h"

namespace quicksand {

class PaperResults {
 public:
  // `pictures`: the folder of what reports draw of them.
  explicit PaperResults(std::span<const Job> jobs, std::filesystem::path pictures = {});

  const std::filesystem::path& pictures() const { return pictures_; }

  // Null if the run did not finish.
  const RunResults* run(std::size_t job) const;
  // The finished runs of a group.
  std::vector<const RunResults*> runs(const RunGroup& group) const;

  // Final values of a quantity, those that are there.
  std::vector<double> values(const RunGroup& group, const std::string& quantity) const;
  // Mean of the middles of the intervals in which searches found critical forces, without those that no force moved,
  // over `unit` [F_g]. Its error is that of the scatter and of the intervals, in each of which any force is as likely.
  std::optional<Measured> critical_force(const RunGroup& group, double unit,
                                         const std::string& note = {}) const;
  // How many of these have a lower end that only ran out of time (is_bracketed).
  int unbracketed(const RunGroup& group) const;
  // Mean of final values; absent if there are none.
  std::optional<Measured> mean(const RunGroup& group, const std::string& quantity) const;
  // Of final values, seed by seed, over the first group's. [1]
  std::optional<Measured> change(const RunGroup& from, const RunGroup& to,
                                 const std::string& quantity) const;

 private:
  std::filesystem::path pictures_;
  std::vector<std::optional<RunResults>> results_;  // (jobs)
};

// Notes a finding if there is one.
void note(Findings& findings, const std::string& id, const std::optional<Measured>& found);
// What the paper says of its specimens, as deposited and as they are before the piston: the same, so that a part of the
// programme with either has both.
void note_specimens(Findings& findings, const PaperResults& results, const RunGroup& specimens);

// Points with error bars: one x a group, y a final quantity. Groups without a value are left out.
Curve curve_over(const PaperResults& results, const std::string& name, std::span<const double> x,
                 std::span<const RunGroup> groups, const std::string& quantity);

}  // namespace quicksand
