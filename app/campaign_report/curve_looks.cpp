#include "app/campaign_report/curve_looks.h"

#include <iterator>
#include <set>

namespace quicksand {

namespace {

template <class Value>
std::size_t place(const std::set<Value>& all, const Value& value) {
  return static_cast<std::size_t>(std::distance(all.begin(), all.find(value)));
}

}  // namespace

void colour_by(std::vector<Curve>& curves, const std::vector<double>& values) {
  const std::set<double> all(values.begin(), values.end());
  if (curves.size() < 3 || values.size() != curves.size() || all.size() != curves.size()) return;
  const std::vector<Colour> colours = ordered_colours(curves.size());
  for (std::size_t k = 0; k < curves.size(); ++k) curves[k].colour = colours[place(all, values[k])];
}

void style_by_two(std::vector<Curve>& curves, std::span<const CampaignPoint* const> points,
                  std::span<const std::string> paths) {
  if (paths.size() != 2) return;
  std::vector<double> numbers;
  std::vector<Json> others;
  for (const CampaignPoint* point : points) {
    const Json number = value_of(*point, paths[0]);
    if (!number.is_number()) return;
    numbers.push_back(number.get<double>());
    others.push_back(value_of(*point, paths[1]));
  }
  const std::set<double> each_number(numbers.begin(), numbers.end());
  const std::set<Json> each_other(others.begin(), others.end());
  const std::vector<Colour> colours = ordered_colours(each_number.size());
  for (std::size_t k = 0; k < curves.size(); ++k) {
    curves[k].colour = colours[place(each_number, numbers[k])];
    curves[k].style = place(each_other, others[k]);
  }
}

}  // namespace quicksand
