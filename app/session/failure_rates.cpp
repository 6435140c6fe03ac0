#include "app/session/failure_rates.h"

#include <algorithm>
#include <cstdint>

namespace quicksand {

std::vector<double> failure_rates(const std::vector<Moment>& moments) {
  std::vector<double> rates(moments.size(), 0);
  for (std::size_t k = 1; k < moments.size(); ++k) {
    const double lasted = moments[k].time - moments[k - 1].time;
    // A trial that returns to where it began takes its broken bonds back.
    const auto broken =
        std::max<std::int64_t>(0, moments[k].bonds_broken - moments[k - 1].bonds_broken);
    if (lasted > 0) rates[k] = static_cast<double>(broken) / lasted;
  }
  return rates;
}

}  // namespace quicksand
