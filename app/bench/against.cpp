#include "app/bench/against.h"

#include <algorithm>
#include <map>

#include "app/bench/bench.h"
#include "app/bench/statistics.h"
#include "core/base/errors.h"

namespace quicksand::bench {

namespace {

// Shorter times are mostly those of the clock and of the caches.
constexpr double kShortest = 5e-5;  // [s]

struct Measured {
  std::vector<double> seconds;
  double residual = 0;
};

// By what was measured, in words.
std::map<std::string, Measured> measured_in(const Json& results) {
  std::map<std::string, Measured> all;
  for (const Json& row : results.at("rows")) {
    if (!row.at("cpu_seconds").is_number()) continue;
    std::string key;
    for (const char* field : {"part", "case", "what", "method", "size", "tolerance", "dt"}) {
      const Json& value = row.at(field);
      if (value.is_null()) continue;
      key += (key.empty() ? "" : " | ") + (value.is_string()
                                               ? value.get<std::string>()
                                               : format("%s %g", field, value.get<double>()));
    }
    Measured& measured = all[key];
    measured.seconds.push_back(row.at("cpu_seconds").get<double>());
    measured.residual = std::max(measured.residual, row.at("residual").get<double>());
  }
  return all;
}

}  // namespace

std::vector<Ratio> ratios(const Json& before, const Json& after) {
  const std::map<std::string, Measured> old = measured_in(before);
  std::vector<Ratio> all;
  for (const auto& [what, now] : measured_in(after)) {
    const auto found = old.find(what);
    if (found == old.end()) continue;
    const Ratio ratio{what, median(found->second.seconds), median(now.seconds),
                      found->second.residual, now.residual};
    if (std::max(ratio.before, ratio.after) >= kShortest) all.push_back(ratio);
  }
  std::ranges::stable_sort(all, std::greater{}, &Ratio::value);
  return all;
}

Json read_results(const std::filesystem::path& file) {
  Json results = read_json(file);
  if (!results.is_object() || !results.contains("rows") || !results["rows"].is_array())
    throw InputError(file.string(), "is not a results.json of `quicksand bench`: it has no rows");
  try {
    measured_in(results);
  } catch (const Json::exception& problem) {
    throw InputError(file.string(),
                     std::string("is not a results.json of `quicksand bench`: ") + problem.what());
  }
  return results;
}

std::string ratio_table(const Json& before, const Json& after) {
  std::string text;
  for (const char* field : {"processor", "compiler", "build_type", "quick"})
    if (before.value(field, Json()) != after.value(field, Json()))
      text +=
          std::string("the results differ in ") + field + ": ratios say little about the program\n";
  const std::vector<Ratio> all = ratios(before, after);
  int slower = 0, faster = 0;
  text += "  ratio    before [s]     after [s]  residual before   after    measured\n";
  for (const Ratio& ratio : all) {
    slower += ratio.regression() ? 1 : 0;
    faster += ratio.value() < 1 / kRegression ? 1 : 0;
    text += format("%7.3f  %12.4g  %12.4g          %8.1e %8.1e  %s %s\n", ratio.value(),
                   ratio.before, ratio.after, ratio.residual_before, ratio.residual_after,
                   ratio.regression() ? "!" : " ", ratio.what.c_str());
  }
  return text +
         format("%zu measurements in both, %d slower (ratio above %g, marked !), %d faster\n",
                all.size(), slower, kRegression, faster);
}

}  // namespace quicksand::bench
