#include "app/build_info.h"

namespace quicksand {

const BuildInfo& build_info() {
  static const BuildInfo info{QUICKSAND_VERSION, QUICKSAND_COMMIT, QUICKSAND_COMPILER,
                              QUICKSAND_BUILD_TYPE};
  return info;
}

}  // namespace quicksand
