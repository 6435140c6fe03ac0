// Names in the legend of a plot.
#include "app/plot/plot_legend.h"

#include <gtest/gtest.h>

namespace quicksand::test {
namespace {

TEST(LegendName, KeepsTheEndsOfWhatIsTooLong) {
  EXPECT_EQ(legend_name("friction 0.3", 800), "friction 0.3");
  const std::string path = "a/folder/" + std::string(80, 'x') + "/µ = 0.3";
  const std::string shown = legend_name(path, 800);
  EXPECT_LT(shown.size(), 70U);
  EXPECT_TRUE(shown.starts_with("a/folder/")) << shown;
  EXPECT_TRUE(shown.ends_with("/µ = 0.3")) << shown;
}

}  // namespace
}  // namespace quicksand::test
