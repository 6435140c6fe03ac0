#include "app/view/history_view.h"

#include "app/json/fields.h"
#include "app/json/json_text.h"
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
  // Of a run that goes on the last record may not be written to its end; of one that has finished it is.
  if (is_there(folder.summary())) {
    const Json summary = read_json(folder.summary());
    const double last = history.moments().back().time, end = summary.value("time", last);
    if (summary.value("finished", false) && last < end)
      throw InputError(folder.history().string(),
                       "ends at t = " + number_text(last) + ", the run at t = " + number_text(end) +
                           ": it is cut short; copy it again, or compute the run again");
  }
  return history;
}

View fixed_over(const History& history, const View& view) {
  CommonScales scales(view);
  if (scales.needed())
    for (std::size_t k = 0; k < history.moments().size(); ++k) scales.add(history.world(k));
  return scales.fixed(view);
}

}  // namespace quicksand
