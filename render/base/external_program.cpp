#include "render/base/external_program.h"

#include <fcntl.h>
#include <spawn.h>
#include <sys/mman.h>
#include <sys/wait.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <system_error>

namespace quicksand {
namespace {

// A nameless file for what the program writes.
class Output {
 public:
  Output() : descriptor_(memfd_create("output", MFD_CLOEXEC)) {}
  ~Output() {
    if (descriptor_ >= 0) close(descriptor_);
  }
  Output(const Output&) = delete;
  Output& operator=(const Output&) = delete;

  int descriptor() const { return descriptor_; }

  std::string text() const {
    constexpr std::size_t kMost = 4096;
    std::array<char, kMost> piece{};
    const ssize_t size = pread(descriptor_, piece.data(), piece.size(), 0);
    std::string text(piece.data(), size > 0 ? static_cast<std::size_t>(size) : 0);
    while (!text.empty() && (text.back() == '\n' || text.back() == ' ')) text.pop_back();
    return text;
  }

 private:
  int descriptor_;
};

}  // namespace

ProgramEnd run_external(std::vector<std::string> words, const std::filesystem::path& folder) {
  std::vector<char*> argv;
  argv.reserve(words.size() + 1);
  for (std::string& word : words) argv.push_back(word.data());
  argv.push_back(nullptr);

  const Output answer, messages;
  if (answer.descriptor() < 0 || messages.descriptor() < 0)
    return {-1, false, {}, std::generic_category().message(errno)};
  posix_spawn_file_actions_t files;
  posix_spawn_file_actions_init(&files);
  posix_spawn_file_actions_addopen(&files, STDIN_FILENO, "/dev/null", O_RDONLY, 0);
  posix_spawn_file_actions_adddup2(&files, answer.descriptor(), STDOUT_FILENO);
  posix_spawn_file_actions_adddup2(&files, messages.descriptor(), STDERR_FILENO);
  posix_spawn_file_actions_addchdir_np(&files, folder.c_str());
  pid_t child = 0;
  const int error = posix_spawnp(&child, argv[0], &files, nullptr, argv.data(), environ);
  posix_spawn_file_actions_destroy(&files);

  ProgramEnd end;
  if (error != 0) {
    end.missing = error == ENOENT && std::filesystem::is_directory(folder);
    end.problem = std::generic_category().message(error);
    return end;
  }
  int status = 0;
  while (waitpid(child, &status, 0) < 0) {
    if (errno != EINTR) return {-1, false, {}, std::generic_category().message(errno)};
  }
  constexpr int kSignalled = 128;
  end.code = WIFEXITED(status) ? WEXITSTATUS(status) : kSignalled + WTERMSIG(status);
  end.answer = answer.text();
  if (end.code != 0) {
    const std::string said = messages.text().empty() ? end.answer : messages.text();
    end.problem = "it ended with " + std::to_string(end.code) + (said.empty() ? "" : ": " + said);
  }
  return end;
}

std::string escaped_percent(const std::string& name) {
  std::string escaped;
  for (const char c : name) escaped += c == '%' ? "%%" : std::string(1, c);
  return escaped;
}

}  // namespace quicksand
