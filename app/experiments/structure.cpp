// What the specimens are like inside, before and after: profiles over height, angles of bonds, forces in contacts.
#include <algorithm>
#include <cmath>
#include <numbers>
#include <span>
#include <utility>

#include "app/experiments/experiments.h"
#include "app/run_folder/state_file.h"
#include "core/measures/distributions.h"
#include "core/measures/measures.h"

namespace quicksand {

namespace {

// Bins of about 5° from just below 60°, the smallest angle between equal grains: neither it nor a right angle or 120° is
// at an edge, where rounding would spread it over two bins. [rad]
std::vector<double> angle_edges() {
  constexpr double kDegree = std::numbers::pi / 180, kSmallest = 59;
  constexpr int kBins = 24;
  return even_edges(kSmallest * kDegree, std::numbers::pi, kBins);
}

// Of the states of all realizations of a group.
struct Structure {
  std::vector<std::vector<double>>
      fractions;  // volume fraction of each slice (slices, realizations) [1]
  Histogram angles, forces, tensions;
  std::vector<ContactCounts> counts;  // (realizations)
};

void pool(Histogram& sum, Histogram&& part) {
  if (sum.counts.empty()) {
    sum = std::move(part);
    return;
  }
  for (std::size_t k = 0; k < sum.counts.size(); ++k) sum.counts[k] += part.counts[k];
  sum.below += part.below;
  sum.above += part.above;
}

// The density at the middles of the bins, with counting errors; values and widths times `scale`. Empty bins interrupt
// the line; a bin between two of them is a level line.
Curve curve_of(const std::string& name, const Histogram& histogram, bool logarithmic,
               double scale) {
  Curve curve{.name = name, .kind = Curve::Kind::line};
  const std::vector<double> density = histogram.density();
  const auto is_empty = [&](std::size_t k) { return k >= density.size() || density[k] == 0; };
  for (std::size_t k = 0; k < density.size(); ++k) {
    if (is_empty(k)) continue;
    const bool first = k == 0 || is_empty(k - 1);
    if (first) curve.begins.push_back(curve.x.size());
    const double low = histogram.edges[k], high = histogram.edges[k + 1];
    const double middle = logarithmic ? std::sqrt(low * high) : (low + high) / 2;
    // A single count has an error that reaches zero, which a logarithmic axis has not.
    constexpr double kMost = 0.9;
    const double error = std::min(kMost, 1 / std::sqrt(static_cast<double>(histogram.counts[k])));
    const bool alone = first && is_empty(k + 1);
    for (const double x : alone ? std::vector{low, high} : std::vector{middle}) {
      curve.x.push_back(scale * x);
      curve.y.push_back(density[k] / scale);
      curve.y_error.push_back(error * curve.y.back());
    }
  }
  return curve;
}

class StructureOfSamples : public PaperExperiment {
 public:
  void ask_for_runs(PaperJobs& jobs) override {
    thickness_ = jobs.scale().height / kSlices;
    const RunGroup samples = jobs.samples();
    states_ = {{"specimen", samples},
               {"after a push with F_c", jobs.pushes(samples, 1)},
               {"after the piston", jobs.pistons(samples)}};
  }

  void report(const PaperResults& results, Section& section, Findings&) const override {
    Plot profile{.name = "structure_profile",
                 .x = {.label = "volume fraction", .low = 0},
                 .y = {.label = "height", .unit = "d", .low = 0}};
    Plot angles{.name = "structure_bond_angles",
                .x = {.label = "angle", .unit = "°", .low = 60, .high = 180},
                .y = {.label = "density", .unit = "1/°", .low = 0}};
    Plot forces{.name = "structure_contact_forces",
                .x = {.label = "force over its mean", .logarithmic = true},
                .y = {.label = "density", .logarithmic = true}};
    Plot tensions{.name = "structure_bond_tensions",
                  .x = {.label = "force", .unit = "F_c", .logarithmic = true},
                  .y = {.label = "density", .unit = "1/F_c", .logarithmic = true}};
    Table counts{
        .caption =
            "What counts as a contact: mean number of neighbours of a grain by the definition of a "
            "contact, and the ratio of active bonds to contacts (a contact between grains counts "
            "for both, one with a wall or the intruder once).",
        .columns = {{"state"},
                    {"touching (used here)", true},
                    {"touching, of grains with a contact", true},
                    {"share of grains without a contact", true},
                    {"loaded or bonded", true},
                    {"bonded", true},
                    {"active over touching", true},
                    {"active over loaded or bonded", true}}};
    for (const auto& [name, group] : states_) {
      const Structure s = structure_of(results, group);
      if (s.angles.counts.empty()) continue;
      counts.rows.push_back(row_of(name, s.counts));
      profile.curves.push_back(profile_curve(name, s));
      add_with_band(angles, curve_of(name, s.angles, false, 180 / std::numbers::pi));
      add_with_band(forces, curve_of(name, s.forces, true, 1));
      add_with_band(tensions, curve_of(name, s.tensions, true, 1));
    }
    if (profile.curves.empty()) return;
    section.add(std::move(counts));
    section.add(Figure{std::move(profile),
                       "Volume fraction over height in slices of " +
                           cell_of(Measured{.value = thickness_}, 1).text +
                           " d, mean and standard error over realizations. The slice at the "
                           "surface is only partly filled; slices below 0.01 are left out."});
    section.add(Figure{std::move(angles),
                       "Angles between neighbouring active bonds of a grain, with bands of one "
                       "standard error of the counts. Three grains that touch each other give 60°, "
                       "a grain in a straight chain gives 180°."});
    section.add(Figure{
        std::move(forces),
        "Compressive forces between grains and between grains and walls in the last step, without "
        "the intruder's contacts. Lines are interrupted where no contact has such a force."});
    section.add(Figure{std::move(tensions),
                       "Tensile forces in active bonds of grains. At rest the bonds carry only "
                       "weights, far below their strength."});
  }

 private:
  static constexpr double kSlices = 25;
  static constexpr double kEmpty =
      0.01;  // volume fraction of a slice that the surface hardly reaches

  Structure structure_of(const PaperResults& results, const RunGroup& group) const {
    Structure all;
    for (const RunResults* run : results.runs(group)) {
      const World world = read_state(run->folder().state()).checkpoint.world;
      pool(all.angles, bond_angles(world, angle_edges()));
      pool(all.forces, contact_forces(world));
      pool(all.tensions, bond_tensions(world));
      const std::vector<Pair> touching = touching_pairs(world);
      all.counts.push_back(contact_counts(world, count_neighbours(world, touching)));
      const std::vector<Slice> slices = height_profile(world, touching, thickness_);
      if (slices.size() > all.fractions.size()) all.fractions.resize(slices.size());
      for (std::size_t k = 0; k < slices.size(); ++k)
        if (slices[k].volume_fraction) all.fractions[k].push_back(*slices[k].volume_fraction);
    }
    // Above its surface a specimen is empty.
    for (std::vector<double>& slice : all.fractions) slice.resize(all.counts.size(), 0);
    return all;
  }

  std::vector<Cell> row_of(const std::string& name, std::span<const ContactCounts> counts) const {
    std::vector<Cell> row{{.text = name}};
    const auto add = [&](auto quantity) {
      std::vector<double> values;
      for (const ContactCounts& c : counts)
        if (c.loaded > 0) values.push_back(quantity(c));
      row.push_back(cell_of(mean_over(values), all_));
    };
    add([](const ContactCounts& c) { return c.touching; });
    add([](const ContactCounts& c) { return c.touching / (1 - c.without); });
    add([](const ContactCounts& c) { return c.without; });
    add([](const ContactCounts& c) { return c.loaded; });
    add([](const ContactCounts& c) { return c.bonded; });
    add([](const ContactCounts& c) { return c.bonded / c.touching; });
    add([](const ContactCounts& c) { return c.bonded / c.loaded; });
    return row;
  }

  Curve profile_curve(const std::string& name, const Structure& s) const {
    Curve curve{.name = name, .kind = Curve::Kind::line_points};
    for (std::size_t k = 0; k < s.fractions.size(); ++k) {
      const auto mean = mean_over(s.fractions[k]);
      if (!mean || mean->value < kEmpty) continue;
      curve.x.push_back(mean->value);
      curve.x_error.push_back(mean->standard_error.value_or(0));
      curve.y.push_back((static_cast<double>(k) + 0.5) * thickness_);
    }
    return curve;
  }

  double thickness_ = 1;  // of a slice [d]
  std::vector<std::pair<std::string, RunGroup>> states_;
};

}  // namespace

std::unique_ptr<PaperExperiment> make_structure_experiment() {
  return std::make_unique<StructureOfSamples>();
}

}  // namespace quicksand
