#include "app/base/machine.h"

#include <cstdlib>
#include <fstream>
#include <thread>

namespace quicksand {

Machine machine() {
  Machine found{.processor = "unknown",
                .cores = static_cast<int>(std::thread::hardware_concurrency())};
  std::ifstream file("/proc/cpuinfo");
  for (std::string line; std::getline(file, line);) {
    const std::size_t colon = line.find(": ");
    if (!line.starts_with("model name") || colon == std::string::npos) continue;
    found.processor = line.substr(colon + 2);
    break;
  }
  double load[1] = {0};
  if (getloadavg(load, 1) == 1) found.load = load[0];
  return found;
}

}  // namespace quicksand
