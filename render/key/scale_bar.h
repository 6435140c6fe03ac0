// How long something in the picture is: a bar of a round number of diameters.
#pragma once

#include <string>

#include "render/base/view.h"
#include "render/key/legend.h"

namespace quicksand {

// The largest nice number of diameters not longer than `most` [px].
double scale_bar_length(double pixels_per_diameter, double most);
// "10 d", or "10 d = 5 mm", in the markup of font.h.
std::string scale_bar_label(double length, const View& view);
// The bar and its label. The room that they take does not depend on the scale.
Legend::Word scale_bar_word(const Font& font, const View& view, double pixels_per_diameter);

}  // namespace quicksand
