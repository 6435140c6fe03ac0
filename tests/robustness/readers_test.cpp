// Readers read or refuse whatever they are given: the cases that searches found, and random damage.
#include "tests/robustness/readers.h"

#include <gtest/gtest.h>

#include "core/base/errors.h"
#include "core/base/memory.h"
#include "tests/robustness/mutation.h"
#include "tests/support/bounded_memory.h"
#include "tests/support/files.h"

namespace quicksand::test {
namespace {

namespace fs = std::filesystem;

constexpr rlim_t kMostMemory = rlim_t{2} << 30U;  // that any input may take [bytes]

class Readers : public testing::Test {
 protected:
  // Whatever else it throws fails the test.
  static bool reads(const Reader& reader, const std::string& input) {
    try {
      reader.read(input);
      return true;
    } catch (const InputError&) {
      return false;
    } catch (const NotEnoughMemory&) {
      return false;
    }
  }

  TemporaryFolder folder_;
  std::vector<Reader> all_ = readers(folder_.path());
  BoundedMemory bound_{kMostMemory};
};

TEST_F(Readers, ReadTheirExamples) {
  for (const Reader& reader : all_)
    for (const std::string& seed : reader.seeds) EXPECT_TRUE(reads(reader, seed)) << seed;
}

// Each file in cases/READER broke that reader once.
TEST_F(Readers, ReadOrRefuseWhatOnceBrokeThem) {
  for (const Reader& reader : all_) {
    const fs::path folder = kSource / "tests/robustness/cases" / reader.name;
    if (!fs::exists(folder)) continue;
    for (const auto& file : fs::directory_iterator(folder))
      EXPECT_NO_THROW(reads(reader, contents(file))) << file.path();
  }
}

TEST_F(Readers, ReadOrRefuseDamagedExamples) {
  constexpr int kInputs = 600;  // a reader
  for (const Reader& reader : all_) {
    Mutation mutation(1, reader.seeds);
    int refused = 0;
    for (int k = 0; k < kInputs; ++k) {
      const std::string input = mutation.next();
      EXPECT_NO_THROW(refused += reads(reader, input) ? 0 : 1) << reader.name << ": " << input;
    }
    EXPECT_GT(refused, kInputs / 4) << reader.name;
  }
}

}  // namespace
}  // namespace quicksand::test
