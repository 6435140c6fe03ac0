// The frames of a film as numbered pictures: FOLDER/frame_000000.png, frame_000001.png ...
//
// Pictures are packed and written on a second thread while the next step is computed.
#pragma once

#include <cstdint>
#include <filesystem>
#include <map>
#include <memory>

#include "render/image/image.h"

namespace quicksand {

class Sequence {
 public:
  // Makes the folder. Frames of an earlier run with numbers from `first` on are removed, so that
  // they do not end up in this film. Throws InputError if the folder cannot be made or written.
  explicit Sequence(std::filesystem::path folder, std::int64_t first = 0);
  // Writes what is queued; errors at this point are lost, so call finish() before.
  ~Sequence();
  Sequence(const Sequence&) = delete;
  Sequence& operator=(const Sequence&) = delete;

  // Queues a picture; waits if the disk is far behind. Throws InputError if an earlier one could
  // not be written.
  void add(Image image);
  // Waits until all is written. Throws InputError if something could not be.
  void finish();

  std::int64_t next() const;  // number of the next frame
  std::filesystem::path folder() const;

 private:
  struct Writer;
  std::unique_ptr<Writer> writer_;
};

// FOLDER/frame_000012.png
std::filesystem::path frame_path(const std::filesystem::path& folder, std::int64_t number);
// The frames in a folder by number; other files are passed over. Empty if there is no folder.
std::map<std::int64_t, std::filesystem::path> frame_files(const std::filesystem::path& folder);

}  // namespace quicksand
