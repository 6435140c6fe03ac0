// The options that a run keeps for whoever resumes it.
#include "app/run/run_options.h"

#include <gtest/gtest.h>

#include "core/base/errors.h"
#include "tests/support/temporary_folder.h"

namespace quicksand::test {
namespace {

TEST(RunOptions, ReadBackAsTheyWereWritten) {
  const TemporaryFolder folder;
  RunOptions options;
  options.every = 0.1;
  options.frames = false;
  options.checkpoint_every = 7.5;
  options.history_limit = 12.5;
  options.strict = StrictBounds{1e-4};
  options.view.width = 320;
  options.view.theme = Theme::dark;
  options.view.colouring = Colouring::pressure;
  options.view.forces = true;
  options.view.colour_high = 30;
  options.view.force_scale = 1e4;
  write_options(folder.path() / "run.json", options);
  const RunOptions read = read_options(folder.path() / "run.json");
  EXPECT_EQ(read.every, options.every);
  EXPECT_EQ(read.frames, options.frames);
  EXPECT_EQ(read.checkpoint_every, options.checkpoint_every);
  EXPECT_EQ(read.history_limit, options.history_limit);
  ASSERT_TRUE(read.strict);
  EXPECT_EQ(read.strict->max_overlap, 1e-4);
  EXPECT_EQ(read.view, options.view);
}

TEST(RunOptions, ThatAreNoneAreRefused) {
  const TemporaryFolder folder;
  for (const char* text : {"", "[]", R"({"every": -1})", R"({"view": {"width": 1}})",
                           R"({"frame": true})", R"({"strict": {"max_overlap": 2}})"})
    EXPECT_THROW(read_options(folder.write("run.json", text)), InputError) << text;
}

}  // namespace
}  // namespace quicksand::test
