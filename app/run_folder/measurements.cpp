#include "app/run_folder/measurements.h"

#include <algorithm>

#include "app/base/build_info.h"
#include "app/json/json_reader.h"
#include "app/run_folder/run_folder.h"
#include "app/run_folder/summary.h"
#include "core/base/errors.h"
#include "core/base/format.h"
#include "core/base/whole_file.h"

namespace quicksand {

namespace {

// What is said of a region, in the words of the quantities.
struct RegionValue {
  std::string_view name;
  Value (*get)(const Region& region);
};
const RegionValue kRegionValues[] = {
    {"grains", [](const Region& r) -> Value { return r.grains; }},
    {"contacts", [](const Region& r) -> Value { return r.contacts; }},
    {"initial_bonds", [](const Region& r) -> Value { return r.initial_bonds; }},
    {"coordination", [](const Region& r) { return or_none(r.coordination); }},
    {"active_bond_fraction", [](const Region& r) { return or_none(r.active_bond_fraction); }},
    {"remaining_bond_fraction", [](const Region& r) { return or_none(r.remaining_bond_fraction); }},
};

struct StressValue {
  std::string_view name;
  double Stress::*value;
};
const StressValue kStressValues[] = {
    {"stress_xx", &Stress::xx}, {"stress_yy", &Stress::yy}, {"stress_xy", &Stress::xy}};

Value stress_of(const Slice& slice, const StressValue& known) {
  return slice.stress ? Value((*slice.stress).*known.value) : Value();
}

struct CountValue {
  std::string_view name, help;
  double ContactCounts::*value;
};
const CountValue kCountValues[] = {
    {"touching", "touching neighbours of a grain", &ContactCounts::touching},
    {"loaded", "... that are compressed or bonded", &ContactCounts::loaded},
    {"bonded", "... by an active bond", &ContactCounts::bonded},
    {"without", "share of grains that touch nothing", &ContactCounts::without},
};

struct ChangeValue {
  std::string_view name, unit;
  Value (*get)(const Changes& changes);
};
const ChangeValue kChangeValues[] = {
    {"duration", "sqrt(d/g)", [](const Changes& c) -> Value { return c.duration; }},
    {"grains", "1", [](const Changes& c) -> Value { return std::ssize(c.grains); }},
    {"mean_displacement", "d", [](const Changes& c) -> Value { return c.mean_displacement; }},
    {"largest_displacement", "d", [](const Changes& c) -> Value { return c.largest_displacement; }},
    {"mean_sinking", "d", [](const Changes& c) -> Value { return c.mean_sinking; }},
    {"displaced_grains", "1", [](const Changes& c) -> Value { return c.displaced; }},
    {"bonds_broken", "1", [](const Changes& c) -> Value { return c.bonds_broken; }},
    {"bonds_formed", "1", [](const Changes& c) -> Value { return c.bonds_formed; }},
    {"contacts_lost", "1", [](const Changes& c) -> Value { return c.contacts_lost; }},
    {"contacts_gained", "1", [](const Changes& c) -> Value { return c.contacts_gained; }},
};

std::string padded(std::string text, std::size_t width) {
  text.resize(std::max(width, text.size()), ' ');
  return text;
}

// Five digits are more than a table needs; the files have all.
std::string short_text(const Value& value) {
  if (std::holds_alternative<std::monostate>(value)) return "-";
  if (!std::holds_alternative<double>(value)) return text_of(value);
  return format("%.5g", std::get<double>(value));
}

std::string csv_line(const std::vector<std::string>& cells) { return joined(cells, ",") + "\n"; }

std::string profile_csv(const Measurements& m) {
  std::vector<std::string> header{"low", "high", "volume_fraction"};
  for (const RegionValue& known : kRegionValues) header.emplace_back(known.name);
  for (const StressValue& known : kStressValues) header.emplace_back(known.name);
  std::string csv = csv_line(header);
  for (const Slice& slice : m.profile) {
    std::vector<std::string> cells{number_text(slice.low), number_text(slice.high),
                                   text_of(or_none(slice.volume_fraction))};
    for (const RegionValue& known : kRegionValues)
      cells.push_back(text_of(known.get(slice.grains)));
    for (const StressValue& known : kStressValues)
      cells.push_back(text_of(stress_of(slice, known)));
    csv += csv_line(cells);
  }
  return csv;
}

std::string histogram_csv(const Histogram& h) {
  std::string csv = csv_line({"low", "high", "count", "density"});
  const std::vector<double> density = h.density();
  for (std::size_t k = 0; k < h.counts.size(); ++k)
    csv += csv_line({number_text(h.edges[k]), number_text(h.edges[k + 1]),
                     std::to_string(h.counts[k]), number_text(density[k])});
  return csv;
}

std::string displacements_csv(const Changes& changes) {
  std::string csv = csv_line({"grain", "dx", "dy", "rotation", "bonds_broken", "bonds_formed"});
  for (const GrainChange& g : changes.grains)
    csv += csv_line({std::to_string(g.grain), number_text(g.displacement.x()),
                     number_text(g.displacement.y()), number_text(g.rotation),
                     std::to_string(g.bonds_broken), std::to_string(g.bonds_formed)});
  return csv;
}

Json region_json(const Region& region) {
  Json json;
  for (const RegionValue& known : kRegionValues)
    json[std::string(known.name)] = json_of(known.get(region));
  return json;
}

Json slice_json(const Slice& slice) {
  Json json{{"low", slice.low},
            {"high", slice.high},
            {"volume_fraction", json_of(or_none(slice.volume_fraction))}};
  json.update(region_json(slice.grains));
  for (const StressValue& known : kStressValues)
    json[std::string(known.name)] = json_of(stress_of(slice, known));
  return json;
}

// Whether the table of regions says it already.
bool is_of_a_region(const Measurements& m, std::string_view quantity) {
  const auto names_it = [&](const RegionValue& value) {
    return quantity == value.name || std::ranges::any_of(m.regions, [&](const NamedRegion& known) {
             return quantity == std::string(known.name) + "_" + std::string(value.name);
           });
  };
  return std::ranges::any_of(kRegionValues, names_it);
}

}  // namespace

Measurements measure_state(const StateFile& state, const MeasureChoices& choices, double slice) {
  const World& world = state.checkpoint.world;
  // Else there were more active bonds than contacts.
  if (const double least = widest_touching_gap(world);
      choices.contact_gap && *choices.contact_gap < least)
    throw InputError("--contact-gap", "is " + number_text(*choices.contact_gap) +
                                          ", must be at least " + number_text(least) +
                                          " d, up to which grains touch in this state");
  Measurements m;
  m.scene = state.scenario.name;
  m.seed = state.scenario.seed;
  m.row.sample = measure(world, choices);
  m.row.phase = state.phase;
  m.choices = choices;
  m.slice = slice;
  const std::vector<Pair> touching = touching_pairs(world, choices.contact_gap);
  m.counts = contact_counts(world, count_neighbours(world, touching));
  const std::vector<int> everywhere(static_cast<std::size_t>(world.disks.size()), 0);
  m.regions.push_back({"whole", regions_of(world, touching, everywhere, 1)[0]});
  if (m.row.sample.has_intruder) {
    m.regions.push_back({"channel", m.row.sample.around_intruder.channel});
    m.regions.push_back({"intact", m.row.sample.around_intruder.intact});
    const auto [kept, lost] = by_bonds(world, touching);
    m.regions.push_back({"kept_bonds", kept});
    m.regions.push_back({"lost_bonds", lost});
  }
  try {
    m.profile = height_profile(world, touching, slice);
  } catch (const InputError& problem) {
    m.profile_left_out = problem.where() + " of " + number_text(slice) + " d " + problem.what();
  }
  m.histograms = {
      {"bond_angles", "rad", "angle between neighbouring active bonds of a grain",
       bond_angles(world)},
      {"contact_orientations", "rad", "angle of contacts between grains to the horizontal",
       contact_orientations(world, touching)},
      {"contact_forces", "1", "compressive normal forces over their mean", contact_forces(world)},
      {"bond_tensions", "1", "tensile normal forces of bonds over the cohesion force",
       bond_tensions(world)}};
  return m;
}

std::string text_of(const Measurements& m) {
  constexpr std::size_t kName = 25, kColumn = 12;
  std::string text = padded("", kName);
  for (const NamedRegion& known : m.regions) text += padded(std::string(known.name), kColumn);
  for (const RegionValue& value : kRegionValues) {
    text += "\n" + padded(std::string(value.name), kName);
    for (const NamedRegion& known : m.regions)
      text += padded(short_text(value.get(known.region)), kColumn);
  }
  text += "\n\n";
  for (const Quantity& quantity : quantities()) {
    const Value value = quantity.get(m.row);
    const bool in_table = is_of_a_region(m, quantity.name);
    if (quantity.of_steps || in_table || std::holds_alternative<std::monostate>(value)) continue;
    text += padded(std::string(quantity.name), kName) + padded(short_text(value), kColumn) + "[" +
            std::string(quantity.unit) + "]\n";
  }
  text += "\n";
  for (const CountValue& count : kCountValues)
    text += padded(std::string(count.name), kName) +
            padded(short_text(m.counts.*count.value), kColumn) + std::string(count.help) + "\n";
  if (!m.profile_left_out.empty())
    text += "\nno profile: " + m.profile_left_out + "; choose thicker ones with --slice\n";
  if (!m.changes) return text;
  text += "\nsince the earlier state\n";
  for (const ChangeValue& value : kChangeValues)
    text += padded(std::string(value.name), kName) +
            padded(short_text(value.get(*m.changes)), kColumn) + "[" + std::string(value.unit) +
            "]\n";
  return text;
}

Json to_json(const Measurements& m) {
  Json json{{"program", "quicksand"},
            {"version", build_info().version},
            {"scene", m.scene},
            {"seed", m.seed},
            {"choices",
             {{"channel_margin", m.choices.channel_margin},
              {"intact_distance", m.choices.intact_distance},
              {"above_begins", m.choices.above_begins},
              {"contact_gap", json_of(or_none(m.choices.contact_gap))},
              {"slice", m.slice}}}};
  for (const Quantity& quantity : quantities())
    if (!quantity.of_steps)
      json["quantities"][std::string(quantity.name)] = json_of(quantity.get(m.row));
  for (const NamedRegion& known : m.regions)
    json["regions"][std::string(known.name)] = region_json(known.region);
  for (const CountValue& count : kCountValues)
    json["contact_counts"][std::string(count.name)] = m.counts.*count.value;
  json["profile"] = Json::array();
  for (const Slice& slice : m.profile) json["profile"].push_back(slice_json(slice));
  if (!m.profile_left_out.empty()) json["profile_left_out"] = m.profile_left_out;
  for (const NamedHistogram& known : m.histograms)
    json["distributions"][std::string(known.name)] = {{"unit", known.unit},
                                                      {"help", known.help},
                                                      {"edges", known.histogram.edges},
                                                      {"counts", known.histogram.counts},
                                                      {"below", known.histogram.below},
                                                      {"above", known.histogram.above},
                                                      {"density", known.histogram.density()}};
  if (m.changes)
    for (const ChangeValue& value : kChangeValues)
      json["changes"][std::string(value.name)] = json_of(value.get(*m.changes));
  return json;
}

void write_measurements(const std::filesystem::path& folder, const Measurements& m) {
  make_writable({folder});
  write_whole(folder / "measures.json", to_json(m).dump(2) + "\n");
  const std::filesystem::path profile = folder / "profile.csv";
  if (m.profile_left_out.empty())
    write_whole(profile, profile_csv(m));
  else
    std::filesystem::remove(profile);  // of an earlier state
  for (const NamedHistogram& known : m.histograms)
    write_whole(folder / (std::string(known.name) + ".csv"), histogram_csv(known.histogram));
  const std::filesystem::path displacements = folder / "displacements.csv";
  if (m.changes)
    write_whole(displacements, displacements_csv(*m.changes));
  else
    std::filesystem::remove(displacements);  // of an earlier comparison
}

}  // namespace quicksand
