// A film from a sequence of frames, where the user has ffmpeg: MP4, x264, crf 18, yuv420p.
#pragma once

#include <cstdint>
#include <filesystem>
#include <string>

namespace quicksand {

struct VideoReport {
  enum class Outcome : std::uint8_t { written, no_ffmpeg, no_frames, failed };
  Outcome outcome = Outcome::no_ffmpeg;
  std::string message;  // a sentence for the user
};

// Encodes FOLDER/frame_000000.png ... into `path` by running `ffmpeg` from PATH, without a shell.
// Never throws: a film is a bonus, the frames are there in any case.
VideoReport write_video(const std::filesystem::path& frames, const std::filesystem::path& path,
                        double frames_per_second = 30);

}  // namespace quicksand
