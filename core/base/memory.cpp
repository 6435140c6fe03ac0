#include "core/base/memory.h"

#include <sys/resource.h>
#include <unistd.h>

#include <algorithm>
#include <fstream>
#include <limits>

#include "core/base/format.h"

namespace quicksand {

namespace {

namespace fs = std::filesystem;

constexpr double kNoLimit = std::numeric_limits<double>::infinity();

// The number after a word in a file of lines "word number ...".
double value_after(const fs::path& file, const std::string& wanted) {
  std::ifstream text(file);
  std::string line;
  for (std::string word; text >> word; std::getline(text, line)) {
    double value = 0;
    if (word == wanted && text >> value) return value;
  }
  return kNoLimit;
}

// A limit of "max" is none.
double first_number(const fs::path& file) {
  std::ifstream text(file);
  double value = 0;
  return text >> value ? value : kNoLimit;
}

// Cached files count as used there, but give way: only what no file stands for is taken.
double left_in_container(const fs::path& root) {
  const fs::path group = root / "sys/fs/cgroup";
  const double limit = first_number(group / "memory.max");
  return limit < kNoLimit ? limit - value_after(group / "memory.stat", "anon") : kNoLimit;
}

double left_to_process(const fs::path& root) {
  rlimit limit{};
  if (getrlimit(RLIMIT_AS, &limit) != 0 || limit.rlim_cur == RLIM_INFINITY) return kNoLimit;
  const double pages = first_number(root / "proc/self/statm");
  return static_cast<double>(limit.rlim_cur) - pages * static_cast<double>(sysconf(_SC_PAGESIZE));
}

}  // namespace

double available_memory(const fs::path& root) {
  constexpr double kKibibyte = 1024;
  const double free = kKibibyte * value_after(root / "proc/meminfo", "MemAvailable:");
  return std::max(0.0, std::min({free, left_in_container(root), left_to_process(root)}));
}

std::string memory_problem(double bytes) {
  // Less is not worth asking for.
  constexpr double kLittle = 1e8;
  if (bytes < kLittle) return {};
  const double available = available_memory();
  if (bytes <= available) return {};
  constexpr double kGigabyte = 1e9;
  return format("takes at least %.1f GB of memory, but only %.1f GB is available",
                bytes / kGigabyte, available / kGigabyte);
}

}  // namespace quicksand
