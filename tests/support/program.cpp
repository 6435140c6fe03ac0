#include "tests/support/program.h"

#include <fcntl.h>
#include <sys/wait.h>
#include <unistd.h>

#include <csignal>
#include <fstream>

#include "tests/support/files.h"

namespace quicksand::test {

namespace {

void redirect(int descriptor, const std::filesystem::path& file) {
  const int flags = descriptor == STDIN_FILENO ? O_RDONLY : O_WRONLY | O_CREAT | O_TRUNC;
  const int opened = open(file.c_str(), flags, 0600);
  if (opened < 0 || dup2(opened, descriptor) < 0) _exit(127);
}

}  // namespace

Program::Program(const std::vector<std::string>& arguments,
                 const std::filesystem::path& working_folder, const std::string& input)
    : out_(working_folder / ".stdout"), err_(working_folder / ".stderr") {
  std::vector<std::string> words{QUICKSAND_PROGRAM};
  words.insert(words.end(), arguments.begin(), arguments.end());
  std::vector<char*> argv;
  for (std::string& word : words) argv.push_back(word.data());
  argv.push_back(nullptr);
  const std::filesystem::path in = working_folder / ".stdin";
  std::ofstream(in) << input;
  process_ = fork();
  if (process_ != 0) return;
  if (chdir(working_folder.c_str()) != 0) _exit(127);
  redirect(STDIN_FILENO, in);
  redirect(STDOUT_FILENO, out_);
  redirect(STDERR_FILENO, err_);
  execv(QUICKSAND_PROGRAM, argv.data());
  _exit(127);
}

Program::~Program() {
  if (process_ <= 0) return;
  kill(process_, SIGKILL);
  waitpid(process_, nullptr, 0);
}

void Program::signal(int number) const { kill(process_, number); }

Outcome Program::wait() {
  int status = 0;
  waitpid(process_, &status, 0);
  process_ = -1;
  constexpr int kSignalled = 128;
  return {WIFEXITED(status) ? WEXITSTATUS(status) : kSignalled + WTERMSIG(status), contents(out_),
          contents(err_)};
}

Outcome run_program(const std::vector<std::string>& arguments,
                    const std::filesystem::path& working_folder, const std::string& input) {
  return Program(arguments, working_folder, input).wait();
}

}  // namespace quicksand::test
