// Names, units, sample times and signals.
#include <gtest/gtest.h>

#include <csignal>

#include "app/base/interrupt.h"
#include "app/base/nearest_name.h"
#include "app/scene_json/si_scale.h"
#include "app/series/quantities.h"
#include "app/series/sample_times.h"

namespace quicksand::test {
namespace {

TEST(NearestName, CountsASwapAsOneEdit) {
  EXPECT_EQ(edit_distance("setp", "step"), 1);
  EXPECT_EQ(edit_distance("", "abc"), 3);
  EXPECT_EQ(edit_distance("kitten", "sitting"), 3);
}

TEST(NearestName, OffersWhatWasMeantAndNothingFarFetched) {
  const std::vector<std::string> names{"friction", "rolling_friction", "cohesion_force"};
  EXPECT_EQ(nearest_name("frction", names), "friction");
  EXPECT_EQ(nearest_name("Friction", names), "friction");
  EXPECT_EQ(nearest_name("rolling", names), "rolling_friction");
  EXPECT_EQ(nearest_name("rolling_friends", names), "rolling_friction") << "begins alike";
  EXPECT_EQ(nearest_name("temperature", names), "");
  EXPECT_EQ(suggestion("temperature", names),
            "; known: friction, rolling_friction, cohesion_force");
}

TEST(SiScale, AGrainOfThePaperWeighsAFractionOfAMicronewton) {
  const SiScale si = si_scale({.grain_diameter = 344e-6, .grain_density = 1000, .gravity = 9.81});
  EXPECT_NEAR(si.mass, 2.131e-8, 1e-11);
  EXPECT_NEAR(si.force, 2.091e-7, 1e-10);
  EXPECT_NEAR(si.time, 5.922e-3, 1e-6);
}

TEST(SiScale, PrefixesKeepNumbersShort) {
  EXPECT_EQ(with_prefix(5.92e-3, "s"), "5.92 ms");
  EXPECT_EQ(with_prefix(1.72e-8, "m"), "17.2 nm");
  EXPECT_EQ(with_prefix(0, "m"), "0 m");
  EXPECT_EQ(with_prefix(0.9996, "N"), "1 N");
  EXPECT_EQ(with_prefix(-2e3, "N"), "-2 kN");
}

TEST(SampleTimes, AreMultiplesOfTheIntervalWhereverARunGoesOn) {
  SampleTimes fresh(10, 0.5, 10);
  EXPECT_FALSE(fresh.due(10.49));
  EXPECT_TRUE(fresh.due(10.5 - 1e-9));  // steps add up with rounding
  EXPECT_FALSE(fresh.due(10.6));
  EXPECT_TRUE(fresh.due(12.7));  // one sample for a long step
  EXPECT_FALSE(fresh.due(12.9));
  EXPECT_TRUE(fresh.due(13.0));
  SampleTimes resumed(10, 0.5, 12.7);
  EXPECT_FALSE(resumed.due(12.9));
  EXPECT_TRUE(resumed.due(13.0));
}

TEST(Quantities, HaveNamesUnitsAndMeaning) {
  for (const Quantity& quantity : quantities()) {
    EXPECT_FALSE(quantity.name.empty());
    EXPECT_FALSE(quantity.unit.empty()) << quantity.name;
    EXPECT_FALSE(quantity.help.empty()) << quantity.name;
  }
}

TEST(Quantities, NumbersReadBackTheSame) {
  EXPECT_EQ(std::stod(text_of(Value(0.1 + 0.2))), 0.1 + 0.2);
  EXPECT_EQ(text_of(Value()), "");
}

TEST(InterruptWatch, SeesASignalUntilTheLastWatchHasGone) {
  {
    const InterruptWatch all;
    EXPECT_FALSE(all.interrupted());
    { const InterruptWatch first; }
    std::raise(SIGINT);  // the end of the first has not let go of it
    EXPECT_TRUE(all.interrupted());
    const InterruptWatch second;  // and the beginning of the second does not forget it
    EXPECT_TRUE(second.interrupted());
    EXPECT_TRUE(all.interrupted());
  }
  const InterruptWatch next;
  EXPECT_FALSE(next.interrupted());
}

}  // namespace
}  // namespace quicksand::test
