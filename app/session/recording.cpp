#include "app/session/recording.h"

#include "app/view/film.h"
#include "core/base/errors.h"

namespace quicksand {

namespace {

RunFolder fresh(const std::filesystem::path& path) {
  RunFolder folder{path};
  if (holds_run(folder))
    throw InputError(path.string(),
                     "holds a run, which the recording would replace; choose another folder");
  make_writable(folder);
  remove_earlier_results(folder);
  return folder;
}

}  // namespace

Recording::Recording(const std::filesystem::path& folder, std::function<Image()> draw)
    : folder_(fresh(folder)),
      draw_(std::move(draw)),
      series_(folder_.series()),
      sequence_(folder_.frames()) {}

void Recording::add(const Row& row) {
  series_.add(values_of(row));
  sequence_.add(draw_());
}

Json Recording::finish() {
  sequence_.finish();
  join_frames(folder_);
  return {{"folder", folder_.path.string()},
          {"frames", sequence_.next()},
          {"film", std::filesystem::exists(folder_.animation())}};
}

}  // namespace quicksand
