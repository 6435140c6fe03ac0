#include "app/run/resumption.h"

#include "app/json/json_text.h"
#include "app/run_folder/summary.h"
#include "app/series/series.h"
#include "core/base/errors.h"
#include "core/checkpoint/checkpoint.h"
#include "render/film/sequence.h"
#include "render/image/png.h"

namespace quicksand {

std::optional<std::filesystem::path> missing_frame(const RunFolder& folder, std::int64_t rows) {
  for (std::int64_t k = 0; k < rows; ++k) {
    const auto frame = frame_path(folder.frames(), k);
    if (is_whole_png(frame)) continue;
    refuse_unreadable(frame);
    return frame;
  }
  return std::nullopt;
}

bool lacks_rows(const RunFolder& folder, const RunPosition& position) {
  if (has_rows(folder.series(), position.rows, position.checksum)) return false;
  refuse_unreadable(folder.series());
  return true;
}

Resumption resumption_of(const RunFolder& folder, bool frames) {
  using enum Resumption::How;
  std::optional<RunPosition> position;
  if (!is_there(folder.state())) {
    refuse_unreadable(folder.state());
    return {starts_again, "it has no state yet"};
  }
  try {
    position = position_from(read_checkpoint(folder.state()).samples);
  } catch (const OtherVersion&) {
    throw;
  } catch (const InputError& error) {
    refuse_unreadable(folder.state());
    return {starts_again, error.where() + " " + error.what()};
  }
  if (!position) return {starts_again, folder.state().string() + " was not written by a run"};
  if (lacks_rows(folder, *position))
    return {starts_again, folder.series().string() + " lacks rows written before, or has others"};
  if (frames)
    if (const auto missing = missing_frame(folder, position->rows))
      return {starts_again, missing->string() + " is missing or damaged"};
  return {has_finished(folder) ? finished : goes_on, {}};
}

}  // namespace quicksand
