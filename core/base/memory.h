// The memory that is there to compute in. Who is about to allocate by a size that stands in a file asks first.
#pragma once

#include <filesystem>
#include <stdexcept>
#include <string>

namespace quicksand {

// The least of what the machine has free, what the container (cgroup 2) leaves and what the process may still
// take (ulimit -v) [bytes]. `root` is where the system's files are.
double available_memory(const std::filesystem::path& root = "/");

// Empty if so many bytes are there, else why not: "takes at least 2.5 GB of memory, and 1.0 GB is all there is".
std::string memory_problem(double bytes);

// Thrown before more is allocated than there is, where the input is not to blame.
class NotEnoughMemory : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

}  // namespace quicksand
