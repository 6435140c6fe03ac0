// What this program was built from.
#pragma once

#include <string>

namespace quicksand {

struct BuildInfo {
  std::string version;
  std::string commit;      // of the sources as they were built; "unknown" outside a repository
  std::string compiler;    // "GNU 12.2.0"
  std::string build_type;  // "Release"
};
const BuildInfo& build_info();

}  // namespace quicksand
