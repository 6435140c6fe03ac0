// Runs the real program the way a shell does.
#pragma once

#include <sys/types.h>

#include <filesystem>
#include <string>
#include <vector>

namespace quicksand::test {

struct Outcome {
  int exit_code = -1;  // 128 + signal if it was killed
  std::string out;     // standard output
  std::string err;     // standard error
};

// A running quicksand, in a working folder of its own choice.
class Program {
 public:
  // `input` is its standard input.
  Program(const std::vector<std::string>& arguments, const std::filesystem::path& working_folder,
          const std::string& input = {});
  ~Program();
  Program(const Program&) = delete;
  Program& operator=(const Program&) = delete;

  void signal(int number) const;
  Outcome wait();

 private:
  std::filesystem::path out_;
  std::filesystem::path err_;
  pid_t process_ = -1;
};

Outcome run_program(const std::vector<std::string>& arguments,
                    const std::filesystem::path& working_folder, const std::string& input = {});

}  // namespace quicksand::test
