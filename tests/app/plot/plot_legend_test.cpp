// Names in the legend of a plot, and the labels of its axes.
#include "app/plot/plot_legend.h"

#include <gtest/gtest.h>

#include "app/plot/plot_axis.h"

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

TEST(AxisLabel, IsBrokenWhereItsAxisEnds) {
  using Lines = std::vector<std::string>;
  EXPECT_EQ(label_lines("shear strength [kPa]", 330), Lines{"shear strength [kPa]"});
  EXPECT_EQ(label_lines("slope of the pull-out force against the push force [√(d/g)]", 330),
            (Lines{"slope of the pull-out force", "against the push force [√(d/g)]"}));
  EXPECT_EQ(label_lines("a " + std::string(50, 'x'), 330), (Lines{"a", std::string(50, 'x')}));
  EXPECT_EQ(label_lines("", 330), Lines{""});
}

TEST(AxisLabel, OfSeveralLinesIsQuotedLineByLine) {
  const Axis axis{.label = "mean stress ratio of the specimens after the first slide", .unit = "1"};
  EXPECT_EQ(axis_label(axis, 330), (std::vector<std::string>{"'mean stress ratio of the'",
                                                             "'specimens after the first slide'"}));
}

}  // namespace
}  // namespace quicksand::test
