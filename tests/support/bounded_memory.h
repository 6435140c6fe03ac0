// As long as it lives, this process may not take more address space than it has and so many bytes: what asks
// for more gets none. Under the address sanitizer, whose shadow is as large as all memory, it does nothing.
#pragma once

#include <sys/resource.h>
#include <unistd.h>

#include <fstream>

namespace quicksand::test {

#if defined(__SANITIZE_ADDRESS__)
constexpr bool kMemoryCanBeBounded = false;
#elif defined(__has_feature)
constexpr bool kMemoryCanBeBounded = !__has_feature(address_sanitizer);
#else
constexpr bool kMemoryCanBeBounded = true;
#endif

class BoundedMemory {
 public:
  explicit BoundedMemory(rlim_t bytes) {
    getrlimit(RLIMIT_AS, &before_);
    if (!kMemoryCanBeBounded) return;
    rlim_t pages = 0;
    std::ifstream("/proc/self/statm") >> pages;
    const rlimit bound{pages * static_cast<rlim_t>(sysconf(_SC_PAGESIZE)) + bytes,
                       before_.rlim_max};
    setrlimit(RLIMIT_AS, &bound);
  }
  ~BoundedMemory() { setrlimit(RLIMIT_AS, &before_); }
  BoundedMemory(const BoundedMemory&) = delete;
  BoundedMemory& operator=(const BoundedMemory&) = delete;

 private:
  rlimit before_{};
};

}  // namespace quicksand::test
