#include "app/view/history_view.h"

#include "app/run_folder/summary.h"
#include "core/base/errors.h"
#include "render/layers/common_scales.h"

namespace quicksand {

History history_of(const RunFolder& folder) {
  refuse_special_files(folder);
  if (!is_there(folder.history()))
    throw InputError(folder.path.string(), "has no " + folder.history().filename().string() +
                                               ": it holds no run, or one with --history 0");
  History history(folder.history());
  if (history.moments().empty())
    throw InputError(folder.history().string(), "has no sample yet; the run has just begun");
  if (history.ends_within_record() && has_finished(folder))
    throw InputError(folder.history().string(),
                     "ends within a record, though the run has finished: the file was cut short; "
                     "copy it again, or compute the run again");
  return history;
}

View fixed_over(const History& history, const View& view) {
  CommonScales scales(view);
  if (scales.needed())
    for (std::size_t k = 0; k < history.moments().size(); ++k) scales.add(history.world(k));
  return scales.fixed(view);
}

}  // namespace quicksand
