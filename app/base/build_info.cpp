#include "app/base/build_info.h"

#include "quicksand_commit.h"  // generated, see write_commit.cmake

namespace quicksand {

const BuildInfo& build_info() {
  static const BuildInfo info{QUICKSAND_VERSION, QUICKSAND_COMMIT, QUICKSAND_COMPILER,
                              QUICKSAND_BUILD_TYPE};
  return info;
}

}  // namespace quicksand
