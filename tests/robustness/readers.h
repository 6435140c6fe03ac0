// All that reads what users write, to be fed with damaged files. Each reader must read or refuse them with an
// InputError (or NotEnoughMemory), within seconds and a bounded memory: readers_test.cpp, and fuzz_reader.cpp for long searches.
#pragma once

#include <filesystem>
#include <functional>
#include <string>
#include <string_view>
#include <vector>

namespace quicksand::test {

struct Reader {
  std::string_view name;
  std::vector<std::string> seeds;                // what it reads well
  std::function<void(const std::string&)> read;  // throws for what it refuses
};

// Those that read files find theirs in `folder`.
std::vector<Reader> readers(const std::filesystem::path& folder);

}  // namespace quicksand::test
