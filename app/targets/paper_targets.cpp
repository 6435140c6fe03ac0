#include "app/targets/paper_targets.h"

#include <algorithm>
#include <cmath>
#include <set>

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
  std::optional<double> value, at_least, at_most;
  std::optional<Vec2> interval;
  std::optional<double> absolute, relative;
};

void describe_tolerance(Fields& f, Entry& e) {
  f.number({"absolute", "in the unit of the target"}, between(0, kHuge, "unit"), e.absolute);
  f.number({"relative", "over the value, or over the nearer end"}, between(0, 1, "1"), e.relative);
  f.exactly_one({"absolute", "relative"});
}

void describe(Fields& f, Entry& e) {
  f.text({"id", "stable name", Presence::required}, e.target.id);
  f.text({"quantity", "what it is", Presence::required}, e.target.quantity);
  f.text({"symbol", "its letter"}, e.target.symbol);
  f.text({"unit", "1 if none", Presence::required}, e.target.unit);
  f.number({"value", "a single value"}, between(-kHuge, kHuge, "unit"), e.value);
  f.vector({"interval", "[low, high]"}, between(-kHuge, kHuge, "unit"), e.interval);
  f.number({"at_least", "a lower bound"}, between(-kHuge, kHuge, "unit"), e.at_least);
  f.number({"at_most", "an upper bound"}, between(-kHuge, kHuge, "unit"), e.at_most);
  f.exactly_one({"value", "interval", "at_least", "at_most"});
  f.object({"tolerance", "how far beyond is still inside", Presence::required},
           [&](Fields& inner) { describe_tolerance(inner, e); });
  f.text({"words", "the paper's, where it gives no number"}, e.target.words);
  f.text({"source", "where it stands", Presence::required}, e.target.source);
  f.text({"because", "why this tolerance or bound"}, e.target.because);
  if (e.interval && e.interval->x() > e.interval->y()) {
    f.refuse("interval", "has its ends the wrong way round");
  }
}

Target worked_out(Entry entry) {
  Target target = std::move(entry.target);
  target.low = entry.value ? entry.value : entry.at_least;
  target.high = entry.value ? entry.value : entry.at_most;
  if (entry.interval) {
    target.low = entry.interval->x();
    target.high = entry.interval->y();
  }
  target.tolerance = entry.absolute.value_or(0);
  if (entry.relative) {
    double size = std::abs(target.low.value_or(0));
    size = std::max(size, std::abs(target.high.value_or(0)));
    target.tolerance = *entry.relative * size;
  }
  return target;
}

}  // namespace

const Target& PaperTargets::at(const std::string& id) const {
  return named(targets, id, &Target::id, id, "is no target of the paper");
}

PaperTargets read_targets(const std::filesystem::path& file) {
  try {
    PaperTargets read;
    std::vector<Entry> entries;
    read_fields(read_json(file), "the targets", [&](Fields& f) {
      f.text({"source", "the paper", Presence::required}, read.source);
      f.list({"targets", "its findings", Presence::required}, kMostTargets, entries, describe);
    });
    std::set<std::string> ids;
    for (Entry& entry : entries) {
      if (!ids.insert(entry.target.id).second) {
        throw InputError("targets", "has the id \"" + entry.target.id + "\" twice");
      }
      read.targets.push_back(worked_out(std::move(entry)));
    }
    return read;
  } catch (const InputError& error) {
    throw in_file(file, error);
  }
}

std::filesystem::path shipped_targets() { return assets_folder() / "paper" / "targets.json"; }

}  // namespace quicksand
