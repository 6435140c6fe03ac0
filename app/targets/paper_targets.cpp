#include "app/targets/paper_targets.h"

#include <algorithm>
#include <cctype>
#include <cmath>
#include <set>
#include <utility>

#include "app/base/assets.h"
#include "app/base/nearest_name.h"
#include "app/json/json_reader.h"
#include "core/base/errors.h"

namespace quicksand {

namespace {

constexpr double kHuge = 1e12;
constexpr std::size_t kMostTargets = 1000;

// What a file says of one target, before it is worked out.
struct Entry {
  Target target;
  std::optional<double> at_least, at_most;
  std::optional<Vec2> interval;
};

// "23.4": its value, and half a unit of its last digit; absent if it is no decimal number.
std::optional<std::pair<double, double>> printed_number(const std::string& text) {
  const std::size_t point = text.find('.');
  const bool decimal =
      !text.empty() && text.find_first_not_of("0123456789.", text[0] == '-') == std::string::npos &&
      point == text.rfind('.') && std::isdigit(static_cast<unsigned char>(text.back()));
  if (!decimal) return std::nullopt;
  const std::size_t places = point == std::string::npos ? 0 : text.size() - point - 1;
  return std::pair(std::stod(text), 0.5 * std::pow(10.0, -static_cast<double>(places)));
}

void describe(Fields& f, Entry& e) {
  f.text({"id", "stable name", Presence::required}, e.target.id);
  f.text({"quantity", "description of the quantity", Presence::required}, e.target.quantity);
  f.text({"group", "heading of its group in the plot of all targets"}, e.target.group);
  f.text({"short", "its label in that plot"}, e.target.short_name);
  f.text({"symbol", "its symbol"}, e.target.symbol);
  f.text({"unit", "unit, 1 if it has none", Presence::required}, e.target.unit);
  f.text({"printed", "a single value, with the digits that the paper prints"}, e.target.printed);
  f.vector({"interval", "[low, high]"}, between(-kHuge, kHuge, "unit"), e.interval);
  f.number({"at_least", "a lower bound"}, between(-kHuge, kHuge, "unit"), e.at_least);
  f.number({"at_most", "an upper bound"}, between(-kHuge, kHuge, "unit"), e.at_most);
  f.exactly_one({"printed", "interval", "at_least", "at_most"});
  f.text({"words", "the paper's words, where it gives no number"}, e.target.words);
  f.text({"counts", "objects that a measurement's n counts, if not realizations"}, e.target.counts);
  f.text({"chose", "what was chosen by it"}, e.target.chose);
  f.text({"chose_of", "the method of this choice; of each method if absent"}, e.target.chose_of);
  f.text({"source", "where it is printed", Presence::required}, e.target.source);
  f.text({"because", "how words were turned into this bound, or the origin of the interval"},
         e.target.because);
  if (e.interval && e.interval->x() > e.interval->y())
    f.refuse("interval", "has its ends the wrong way round");
  if (!e.target.printed.empty() && !printed_number(e.target.printed))
    f.refuse("printed", "is not a decimal number");
}

Target worked_out(Entry entry) {
  Target target = std::move(entry.target);
  target.low = entry.at_least;
  target.high = entry.at_most;
  if (entry.interval) {
    target.low = entry.interval->x();
    target.high = entry.interval->y();
  }
  if (const auto number = printed_number(target.printed)) {
    target.low = target.high = number->first;
    target.half_digit = number->second;
  }
  return target;
}

}  // namespace

const Target& PaperTargets::at(const std::string& id) const {
  return named(targets, id, &Target::id, id, "is not a target of the paper");
}

PaperTargets read_targets(const std::filesystem::path& file) {
  return in_file(file, [&] {
    PaperTargets read;
    std::vector<Entry> entries;
    read_fields(read_json(file), "the targets", [&](Fields& f) {
      f.text({"source", "reference of the paper", Presence::required}, read.source);
      f.list({"targets", "its results", Presence::required}, kMostTargets, entries, describe);
    });
    std::set<std::string> ids;
    for (Entry& entry : entries) {
      if (!ids.insert(entry.target.id).second) {
        throw InputError("targets", "has the id \"" + entry.target.id + "\" twice");
      }
      read.targets.push_back(worked_out(std::move(entry)));
    }
    return read;
  });
}

std::filesystem::path shipped_targets() { return assets_folder() / "paper" / "targets.json"; }

}  // namespace quicksand
