#include "app/jobs/job.h"

#include "core/base/format.h"

namespace quicksand {

std::string values_text(const ParameterValues& values) {
  constexpr std::size_t kLongest = 60;
  return joined(values, ", ", [](const auto& entry) {
    const std::string shown = entry.second.dump();
    return entry.first + "=" +
           (shown.size() > kLongest ? shown.substr(0, kLongest) + "..." : shown);
  });
}

std::string job_name(const Job& job) {
  const std::string values = values_text(job.values);
  return job.id + " (" + values + (values.empty() ? "" : ", ") +
         "seed=" + std::to_string(job.scenario.seed) + ")";
}

}  // namespace quicksand
