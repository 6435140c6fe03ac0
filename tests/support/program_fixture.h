// A test that runs the program in a folder of its own.
#pragma once

#include <gtest/gtest.h>

#include <filesystem>
#include <string>
#include <vector>

#include "tests/support/program.h"
#include "tests/support/temporary_folder.h"

namespace quicksand::test {

class ProgramFixture : public testing::Test {
 protected:
  Outcome quicksand(const std::vector<std::string>& arguments) const {
    return run_program(arguments, folder_.path());
  }
  std::filesystem::path at(const std::string& name) const { return folder_.path() / name; }

  TemporaryFolder folder_;
};

}  // namespace quicksand::test
