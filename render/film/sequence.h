// The frames of a film as numbered pictures: FOLDER/frame_000000.png, frame_000001.png ...
//
// Pictures are packed and written on a thread of their own.
#pragma once

#include <cstdint>
#include <filesystem>
#include <utility>

#include "render/film/background.h"
#include "render/image/image.h"

namespace quicksand {

class Sequence {
 public:
  // Makes the folder. Frames of an earlier run with numbers from `first` on are removed, so that
  // they do not end up in this film. Throws InputError if the folder cannot be made or written.
  explicit Sequence(const std::filesystem::path& folder, std::int64_t first = 0);

  // Queues a picture; waits if the disk is far behind. Throws InputError if an earlier one could
  // not be written.
  void add(Image image) { writer_.add({next_++, std::move(image)}); }
  // Waits until all is written. Throws InputError if something could not be.
  void finish() { writer_.finish(); }

  std::int64_t next() const { return next_; }  // number of the next frame

 private:
  std::int64_t next_;
  Background<std::pair<std::int64_t, Image>> writer_;
};

// FOLDER/frame_000012.png
std::filesystem::path frame_path(const std::filesystem::path& folder, std::int64_t number);

}  // namespace quicksand
