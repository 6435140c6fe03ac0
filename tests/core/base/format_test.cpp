#include "core/base/format.h"

#include <gtest/gtest.h>

namespace quicksand {
namespace {

TEST(Counts, TellOneFromMany) {
  EXPECT_EQ(count_text(1, "run"), "1 run");
  EXPECT_EQ(count_text(0, "run"), "0 runs");
  EXPECT_EQ(count_text(20, "body", "bodies"), "20 bodies");
  EXPECT_EQ(noun_for(1, "body", "bodies"), "body");
}

}  // namespace
}  // namespace quicksand
