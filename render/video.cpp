#include "render/video.h"

#include <fcntl.h>
#include <spawn.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cerrno>
#include <cstdio>
#include <fstream>
#include <iterator>
#include <system_error>
#include <vector>

#include "render/frame_files.h"

namespace quicksand {
namespace {

// ffmpeg reads a percent sign in a file name as the start of a number.
std::string escape_percent(const std::string& text) {
  std::string escaped;
  for (const char c : text) escaped += c == '%' ? "%%" : std::string(1, c);
  return escaped;
}

std::vector<std::string> arguments(const std::filesystem::path& frames, std::int64_t first,
                                   const std::filesystem::path& out, double frames_per_second) {
  const std::string input = escape_percent(frames.string()) + "/frame_%06d.png";
  return {"ffmpeg", "-nostdin", "-y", "-loglevel", "error", "-framerate",
          std::to_string(frames_per_second), "-start_number", std::to_string(first), "-i",
          "file:" + input,
          // yuv420p halves both directions: an odd row or column at the edge goes.
          "-vf", "crop=trunc(iw/2)*2:trunc(ih/2)*2", "-c:v", "libx264", "-preset", "veryfast",
          "-crf", "18", "-pix_fmt", "yuv420p", "-movflags", "+faststart", "-f", "mp4",
          "file:" + out.string()};
}

// Runs a program from PATH with its messages in `log`. Returns 0, the exit code, or -errno if there
// is no such program.
int run(std::vector<std::string> words, const std::filesystem::path& log) {
  std::vector<char*> argv;
  argv.reserve(words.size() + 1);
  for (std::string& word : words) argv.push_back(word.data());
  argv.push_back(nullptr);
  posix_spawn_file_actions_t files;
  posix_spawn_file_actions_init(&files);
  posix_spawn_file_actions_addopen(&files, STDIN_FILENO, "/dev/null", O_RDONLY, 0);
  posix_spawn_file_actions_addopen(&files, STDOUT_FILENO, log.c_str(), O_WRONLY | O_CREAT | O_TRUNC,
                                   0644);
  posix_spawn_file_actions_adddup2(&files, STDOUT_FILENO, STDERR_FILENO);
  pid_t child = 0;
  const int error = posix_spawnp(&child, argv[0], &files, nullptr, argv.data(), environ);
  posix_spawn_file_actions_destroy(&files);
  if (error != 0) return -error;
  int status = 0;
  while (waitpid(child, &status, 0) < 0) {
    if (errno != EINTR) return -errno;
  }
  return WIFEXITED(status) ? WEXITSTATUS(status) : 128 + WTERMSIG(status);
}

std::string read_text(const std::filesystem::path& path) {
  std::ifstream file(path);
  std::string text{std::istreambuf_iterator<char>(file), std::istreambuf_iterator<char>()};
  while (!text.empty() && text.back() == '\n') text.pop_back();
  return text;
}

}  // namespace

VideoReport write_video(const std::filesystem::path& frames, const std::filesystem::path& path,
                        double frames_per_second) {
  using enum VideoReport::Outcome;
  try {
    const auto files = frame_files(frames);
    if (files.empty()) return {no_frames, "no film: there are no frames in " + frames.string()};

    // Under another name until it is whole.
    const std::filesystem::path part = path.string() + ".part";
    const std::filesystem::path log = path.string() + ".log";
    // Whether the messages can be written decides before the program starts.
    if (!std::ofstream(log)) return {failed, "no film: " + path.string() + " cannot be written"};
    const int result = run(arguments(frames, files.begin()->first, part, frames_per_second), log);
    const std::string messages = read_text(log);
    std::error_code ignored;
    std::filesystem::remove(log, ignored);
    if (result == 0) {
      std::filesystem::rename(part, path);
      return {written, std::to_string(files.size()) + " frames in " + path.string()};
    }
    std::filesystem::remove(part, ignored);
    if (result == -ENOENT) {
      return {no_ffmpeg, "no film: install the package ffmpeg to get one beside the frames"};
    }
    const std::string reason = result < 0 ? std::generic_category().message(-result)
                                          : "it ended with " + std::to_string(result) +
                                                (messages.empty() ? "" : ": " + messages);
    return {failed, "no film: ffmpeg failed, " + reason};
  } catch (const std::exception& error) {
    return {failed, std::string("no film: ") + error.what()};
  }
}

}  // namespace quicksand
