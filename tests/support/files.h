// Files of tests: a folder that disappears with the test, and what is in files.
#pragma once

#include <filesystem>
#include <string>
#include <string_view>

namespace quicksand::test {

// The source tree that is tested.
inline const std::filesystem::path kSource = QUICKSAND_SOURCE;

class TemporaryFolder {
 public:
  TemporaryFolder();
  ~TemporaryFolder();
  TemporaryFolder(const TemporaryFolder&) = delete;
  TemporaryFolder& operator=(const TemporaryFolder&) = delete;

  const std::filesystem::path& path() const { return path_; }
  // Writes a file in it and returns its path.
  std::filesystem::path write(const std::string& name, std::string_view text) const;

 private:
  std::filesystem::path path_;
};

// The whole file; empty if there is none.
std::string contents(const std::filesystem::path& file);

}  // namespace quicksand::test
