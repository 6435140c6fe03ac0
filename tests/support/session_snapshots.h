// A test that plays commands and compares their snapshots with stored pictures, by the rule of
// render/image_difference.h. QUICKSAND_UPDATE_GOLDEN=1 stores them instead.
#pragma once

#include <gtest/gtest.h>

#include <string>

#include "app/commands/console.h"
#include "render/image/png_reader.h"
#include "tests/support/files.h"
#include "tests/support/render/golden.h"
#include "tests/support/temporary_folder.h"

namespace quicksand::test {

class SessionSnapshots : public testing::Test {
 protected:
  // Files to read are looked for in tests/golden.
  Json perform(const Json& command) { return console_.perform(command, "command"); }
  // A snapshot of the present moment against tests/golden/NAME.png.
  void expect_snapshot(const std::string& name, const std::string& what = "view") {
    const Json told = perform({{"command", "snapshot"}, {"file", name + ".png"}, {"what", what}});
    golden::expect_same(read_png(told["file"].get<std::string>()), name);
  }

  TemporaryFolder folder_;
  Console console_{{folder_.path(), kSource / "tests/golden"}};
};

}  // namespace quicksand::test
