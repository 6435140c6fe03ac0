// The axes of a plot's script: where they end, and which places are named.
#pragma once

#include <cmath>
#include <string>
#include <vector>

#include "app/plot/plot.h"

namespace quicksand {

// The ends of what is drawn along an axis.
struct Extent {
  double low = HUGE_VAL;
  double high = -HUGE_VAL;

  bool empty() const { return low > high; }
  // What the axis cannot show does not count.
  void add(double value, const Axis& axis);
};

// Label and unit as gnuplot reads them, in as many lines as an axis of this length needs [px].
std::vector<std::string> axis_label(const Axis& axis, double length);

// "[0.9:5.1]". Ends that are not given lie a little outside of what is drawn, so that no point hides on a border.
std::string axis_range(const Axis& axis, const Extent& extent);

// How the axis is to name its places.
enum class Tics : std::uint8_t {
  plain,        // as gnuplot chooses them, as decimal numbers
  scientific,   // the same, with powers of ten
  powers,       // of ten alone
  many_powers,  // the same, without tics between
  listed        // those of tic_list
};
Tics tics_of(const Axis& axis, const Extent& extent);

// The places of an axis whose tics are `listed`, as gnuplot takes them: "'0.5' 0.5, '' 0.6 1"; the last has no name.
std::string tic_list(const Axis& axis, const Extent& extent);

}  // namespace quicksand
