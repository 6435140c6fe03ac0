// One reader under libFuzzer, which looks for inputs that reach new code; see fuzz.sh.
#include <algorithm>
#include <cstddef>
#include <cstdint>

#include "core/base/errors.h"
#include "core/base/memory.h"
#include "tests/robustness/readers.h"
#include "tests/support/temporary_folder.h"

namespace {

using quicksand::test::Reader;

Reader fuzzed_reader(const quicksand::test::TemporaryFolder& folder) {
  const std::vector<Reader> all = quicksand::test::readers(folder.path());
  return *std::ranges::find(all, QUICKSAND_READER, &Reader::name);
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* bytes, std::size_t size) {
  static const quicksand::test::TemporaryFolder folder;
  static const Reader reader = fuzzed_reader(folder);
  try {
    reader.read({bytes, bytes + size});
  } catch (const quicksand::InputError&) {
    // Refused, as it should be. What else is thrown is a finding.
  } catch (const quicksand::NotEnoughMemory&) {
    // Refused, too.
  }
  return 0;
}
