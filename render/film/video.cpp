#include "render/film/video.h"

#include <fcntl.h>
#include <unistd.h>

#include <string>
#include <system_error>
#include <vector>

#include "core/base/whole_file.h"
#include "render/base/external_program.h"
#include "render/film/frame_files.h"

namespace quicksand {
namespace {

// A file that is made anew and handed on to programs that are started while it is open. They know it by its
// descriptor: what outlives a killed run cannot write to a later file of that name, however late it begins.
class HandedOn {
 public:
  explicit HandedOn(const std::filesystem::path& path) {
    std::error_code ignored;
    std::filesystem::remove(path, ignored);
    constexpr mode_t kMode = 0666;
    descriptor_ = open(path.c_str(), O_RDWR | O_CREAT | O_EXCL, kMode);
  }
  ~HandedOn() {
    if (there()) close(descriptor_);
  }
  HandedOn(const HandedOn&) = delete;
  HandedOn& operator=(const HandedOn&) = delete;

  bool there() const { return descriptor_ >= 0; }
  std::string name_for_others() const { return "/proc/self/fd/" + std::to_string(descriptor_); }

 private:
  int descriptor_ = -1;
};

std::vector<std::string> arguments(const std::filesystem::path& frames, std::int64_t first,
                                   const std::string& out, double frames_per_second) {
  const std::string input = escaped_percent(frames.string()) + "/frame_%06d.png";
  return {"ffmpeg", "-nostdin", "-y", "-loglevel", "error", "-framerate",
          std::to_string(frames_per_second), "-start_number", std::to_string(first), "-i",
          "file:" + input,
          // yuv420p halves both directions: an odd row or column at the edge goes.
          "-vf", "crop=trunc(iw/2)*2:trunc(ih/2)*2", "-c:v", "libx264", "-preset", "veryfast",
          "-crf", "18", "-pix_fmt", "yuv420p", "-movflags", "+faststart", "-f", "mp4",
          "file:" + out};
}

}  // namespace

VideoReport write_video(const std::filesystem::path& frames, const std::filesystem::path& path,
                        double frames_per_second) {
  using enum VideoReport::Outcome;
  try {
    const auto files = frame_files(frames);
    if (files.empty()) return {no_frames, "no film: there are no frames in " + frames.string()};

    // Under another name until it is whole.
    const std::filesystem::path film_file = file_named(path), part = film_file.string() + ".part";
    const HandedOn film(part);
    // Whether the film can be written decides before the program starts.
    if (!film.there()) return {failed, "no film: " + path.string() + " cannot be written"};
    const ProgramEnd end = run_external(
        arguments(frames, files.begin()->first, film.name_for_others(), frames_per_second));
    if (end.fine()) {
      std::filesystem::rename(part, film_file);
      return {written, std::to_string(files.size()) + " frames in " + path.string()};
    }
    std::error_code ignored;
    std::filesystem::remove(part, ignored);
    if (end.missing) {
      return {no_ffmpeg, "no film: install the package ffmpeg to get one beside the frames"};
    }
    return {failed, "no film: ffmpeg failed, " + end.problem};
  } catch (const std::exception& error) {
    return {failed, std::string("no film: ") + error.what()};
  }
}

}  // namespace quicksand
