// Pictures of the moments that a history holds.
#pragma once

#include "app/history/history.h"
#include "app/run_folder/run_folder.h"
#include "render/base/view.h"

namespace quicksand {

// The history in the folder of a run, with at least one moment. Throws InputError if there is none.
History history_of(const RunFolder& folder);

// The view with the range of colours and the scale of forces that fit the whole history, where the view takes them
// from the data. Reads every record if so. Throws as History::world does.
View fixed_over(const History& history, const View& view);

}  // namespace quicksand
