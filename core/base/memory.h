// The memory that is there to compute in. Who is about to allocate by a size that stands in a file asks first.
#pragma once

#include <algorithm>
#include <filesystem>
#include <stdexcept>
#include <string>
#include <vector>

namespace quicksand {

// The least of what the machine has free, what the container (cgroup 2) leaves and what the process may still
// take (ulimit -v) [bytes]. `root` is where the system's files are.
double available_memory(const std::filesystem::path& root = "/");

// Empty if so many bytes are there, else why not: "takes at least 2.5 GB of memory, but only 1.0 GB is available".
std::string memory_problem(double bytes);

// Vectors that grow by a sixteenth where they have to, and not to twice their size, as they do by themselves: then one body
// or contact more takes as much memory again.
template <class T>
void make_room(std::vector<T>& in, std::size_t size) {
  if (size > in.capacity()) in.reserve(std::max(size, in.capacity() + in.capacity() / 16));
}
template <class T>
void set_size(std::vector<T>& of, std::size_t size) {
  make_room(of, size);
  of.resize(size);
}
template <class T>
T& append(std::vector<T>& to, const T& item) {
  make_room(to, to.size() + 1);
  return to.emplace_back(item);
}

// Thrown before more is allocated than there is, where the input is not to blame.
class NotEnoughMemory : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

}  // namespace quicksand
