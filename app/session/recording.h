// Frames and series of a part of a session: what `record` switches on and off.
#pragma once

#include <filesystem>
#include <functional>

#include "app/json/json_text.h"
#include "app/run_folder/run_folder.h"
#include "app/series/series.h"
#include "render/film/sequence.h"
#include "render/image/image.h"

namespace quicksand {

class Recording {
 public:
  // `draw` makes the picture of the present moment. Throws InputError if the folder cannot be written, or holds a run.
  Recording(const std::filesystem::path& folder, std::function<Image()> draw);

  // A row of series.csv and a frame.
  void add(const Row& row);
  // Waits for the frames, joins them to films, and tells what there is. Throws InputError.
  Json finish();

 private:
  RunFolder folder_;
  std::function<Image()> draw_;
  Series series_;
  Sequence sequence_;
};

}  // namespace quicksand
