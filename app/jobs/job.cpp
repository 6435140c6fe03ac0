#include "app/jobs/job.h"

namespace quicksand {

std::string values_text(const ParameterValues& values) {
  constexpr std::size_t kLongest = 60;
  std::string text;
  for (const auto& [path, value] : values) {
    const std::string shown = value.dump();
    text += (text.empty() ? "" : ", ") + path + "=";
    text += shown.size() > kLongest ? shown.substr(0, kLongest) + "..." : shown;
  }
  return text;
}

std::string job_name(const Job& job) {
  const std::string values = values_text(job.values);
  return job.id + " (" + values + (values.empty() ? "" : ", ") +
         "seed=" + std::to_string(job.scenario.seed) + ")";
}

}  // namespace quicksand
