// A run as one file that a browser opens by itself, without a server or a network: the timeline, and the frames of the
// samples as a served session sends them, drawn by the same modules.
#pragma once

#include <cstddef>
#include <filesystem>

#include "app/run_folder/run_folder.h"
#include "render/base/view.h"

namespace quicksand {

struct FilmPageChoices {
  std::size_t most = 20'000'000;  // size of the file [bytes]
  // Whether the scales that the view leaves to the data fit the whole history; else each moment by itself.
  bool scales_of_run = true;
};

// Writes the samples [first, end) of the history of a run as the view shows them, every second, fourth ... of them where
// all would make the file larger. Returns how many samples are in it; none, and then there is no file, if not even one
// fits. Throws InputError.
std::size_t write_film_page(const std::filesystem::path& file, const RunFolder& run,
                            const View& view, std::size_t first, std::size_t end,
                            const FilmPageChoices& choices = {});

}  // namespace quicksand
