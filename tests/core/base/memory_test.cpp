#include "core/base/memory.h"

#include <gtest/gtest.h>

#include <cmath>
#include <vector>

#include "tests/support/bounded_memory.h"
#include "tests/support/temporary_folder.h"

namespace quicksand {
namespace {

namespace fs = std::filesystem;

class Memory : public testing::Test {
 protected:
  Memory() {
    fs::create_directories(root_.path() / "proc/self");
    fs::create_directories(root_.path() / "sys/fs/cgroup");
    root_.write("proc/meminfo", "MemTotal: 9000000 kB\nMemAvailable:  4000000 kB\n");
  }
  double available() const { return available_memory(root_.path()); }

  test::TemporaryFolder root_;
};

TEST_F(Memory, IsWhatTheMachineHasFree) { EXPECT_EQ(available(), 4000000 * 1024.0); }

TEST_F(Memory, IsWhatTheContainerLeavesIfThatIsLess) {
  root_.write("sys/fs/cgroup/memory.stat", "anon 300000000\nfile 800000000\n");
  root_.write("sys/fs/cgroup/memory.max", "1000000000\n");
  EXPECT_EQ(available(), 700000000);
  root_.write("sys/fs/cgroup/memory.max", "max\n");
  EXPECT_EQ(available(), 4000000 * 1024.0);
  root_.write("sys/fs/cgroup/memory.max", "200000000\n");
  EXPECT_EQ(available(), 0);
}

TEST_F(Memory, IsWhatTheProcessMayStillTakeIfThatIsLess) {
  if (!test::kMemoryCanBeBounded) GTEST_SKIP() << "not under the address sanitizer";
  const test::BoundedMemory bound(500000000);
  EXPECT_NEAR(available_memory(), 500000000, 50000000);
  EXPECT_EQ(memory_problem(400000000), "");
  EXPECT_EQ(memory_problem(2500000000),
            "takes at least 2.5 GB of memory, but only 0.5 GB is available");
}

// One more body than a world was made for takes little more memory, and n of them a time in proportion to n.
TEST(VectorsThatGrow, HoldASixteenthMoreThanTheyNeedAndNoneAtFirst) {
  std::vector<int> numbers;
  set_size(numbers, 1600);
  EXPECT_EQ(numbers.capacity(), 1600);
  append(numbers, 7);
  EXPECT_EQ(numbers.back(), 7);
  EXPECT_EQ(numbers.capacity(), 1700);
  int grown = 0;
  while (numbers.size() < 100000) {
    const std::size_t before = numbers.capacity();
    append(numbers, 1);
    if (numbers.capacity() > before) ++grown;
  }
  EXPECT_LE(grown, 1 + std::log(100000.0 / 1700) / std::log(17.0 / 16));
}

}  // namespace
}  // namespace quicksand
