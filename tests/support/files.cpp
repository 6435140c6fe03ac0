#include "tests/support/files.h"

#include <fstream>
#include <iterator>

namespace quicksand::test {

namespace fs = std::filesystem;

std::string contents(const fs::path& file) {
  std::ifstream stream(file, std::ios::binary);
  return {std::istreambuf_iterator<char>(stream), {}};
}

}  // namespace quicksand::test
