// Which deposition gives which density and coordination number.
#include <algorithm>
#include <cmath>
#include <limits>

#include "app/experiments/experiments.h"
#include "app/json/json_reader.h"
#include "app/plot/typeset_number.h"

namespace quicksand {

namespace {

struct Setting {
  const char* tag;
  std::string text;
  ParameterValues laws = {};
  ParameterValues set = {};
};

Setting denser(const PaperScale& scale) {
  if (!scale.nscd)
    return {kDenseDeposition, "a grain every 0.001, dt 0.001", {}, dense_deposition()};
  return {kHardDrop, "drop velocity higher by 5 √(gd)", {}, hard_drop(*scale.nscd)};
}

std::vector<Setting> settings(const PaperScale& scale) {
  const double interval = scale.interval;
  const auto every = [](double time) { return "a grain every " + typeset(time); };
  std::vector<Setting> all{
      {"", "reference: " + every(interval) + ", no drop velocity"},
      denser(scale),
      {"adiabatic",
       every(5 * interval) +
           (scale.nscd ? "" : ", or " + typeset(25 * interval) + " if that changes the density"),
       {},
       {{"phases[0].adiabatic",
         // By NSCD, a step of its one length after the other, the third would take hours.
         {{"factor", 5},
          {"tolerance", 1e-3},
          {"max_interval", (scale.nscd ? 5 : 25) * interval}}}}},
      {"ballistic", "no dynamics: grains stick where they touch", {}, {{"phases[0].interval", 0}}},
      {"cohesion_100", "cohesion force 100 F_g", {{"contact.cohesion_force", 100}}}};
  if (!scale.studies) return all;
  all.insert(
      all.end(),
      {{"drop_10", "drop velocity 10 √(gd)", {}, {{"phases[0].drop_velocity", 10}}},
       {"rolling_0.05", "half the rolling friction", {{"contact.rolling_friction", 0.05}}},
       {"rolling_0.02", "a fifth of the rolling friction", {{"contact.rolling_friction", 0.02}}},
       {"polydisperse",
        "diameters with 35 % standard deviation",
        {},
        {{"phases[0].polydispersity.deviation", 0.35}}},
       {"capture_0.5", "capture radius 0.5 d", {}, {{"phases[0].capture_radius", 0.5}}}});
  return all;
}

// Places in the list.
constexpr std::size_t kAdiabatic = 2, kSticking = 3, kWeakBonds = 4;

class Samples : public PaperExperiment {
 public:
  void ask_for_runs(PaperJobs& jobs) override {
    scale_ = jobs.scale();
    for (const Setting& s : settings(scale_)) groups_.push_back(jobs.samples(s.tag, s.laws, s.set));
  }

  void report(const PaperResults& results, Section& section, Findings& findings) const override {
    Table table{.caption =
                    "Specimens after deposition and settling. Volume fraction of the lower 70 %; "
                    "mean ± standard error over realizations.",
                .columns = {{"deposition"},
                            {"volume fraction", true},
                            {"coordination number", true},
                            {"active share", true}}};
    Plot plot{
        .name = "samples",
        .x = {.label = "volume fraction"},
        .y = {.label = "coordination number"},
        .references = {
            {.name = "paper: volume fraction (vertical)", .low = 0.40, .high = 0.43, .of_x = true},
            {.name = "paper: coordination number (horizontal)", .low = 2.05, .high = 2.06}}};
    std::vector<std::string> numbers;
    Curve points{.name = "depositions, numbered as in the table; " +
                         std::to_string(kWeakBonds + 1) + " lies far above"};
    const std::vector<Setting> all = settings(scale_);
    for (std::size_t k = 0; k < all.size(); ++k) {
      const auto density = results.mean(groups_[k], "volume_fraction");
      const auto coordination = results.mean(groups_[k], "coordination");
      table.rows.push_back({{.text = std::to_string(k + 1) + ". " + all[k].text},
                            cell_of(density, all_),
                            cell_of(coordination, all_),
                            cell_of(results.mean(groups_[k], "active_bond_fraction"), all_)});
      // Another material, far from the others.
      if (!density || k == kWeakBonds) continue;
      points.x.push_back(density->value);
      points.y.push_back(coordination->value);
      points.x_error.push_back(density->standard_error.value_or(0));
      points.y_error.push_back(coordination->standard_error.value_or(0));
      numbers.push_back(std::to_string(k + 1));
    }
    plot.annotations = numbered(points, numbers);
    plot.curves.push_back(std::move(points));
    section.add(std::move(table));
    section.add(
        Figure{std::move(plot),
               "Volume fraction and coordination number of the specimens of each deposition, "
               "with bars of one standard error. The paper's specimen lies where the two "
               "bands cross. Number " +
                   std::to_string(kWeakBonds + 1) + ", with weaker bonds, is left out."});
    const std::vector<SlowerDeposit> sequence =
        adiabatic_sequence(results.runs(groups_[kAdiabatic]));
    if (!sequence.empty()) section.add(table_of(sequence));
    if (sequence.size() > 1)
      note(findings, "unperturbed.interval_effect", mean_over(sequence[1].changes));
    const auto find = [&](const char* id, std::size_t setting, const char* quantity) {
      note(findings, id, results.mean(groups_[setting], quantity));
    };
    note_specimens(findings, results, groups_.front());
    find("unperturbed.cohesion_1e2.volume_fraction", kWeakBonds, "volume_fraction");
    find("unperturbed.cohesion_1e2.coordination", kWeakBonds, "coordination");
    // Before it is let go: in a high box it falls in.
    const RunGroup& sticking = groups_[kSticking];
    note(findings, "literature.ballistic.volume_fraction",
         when_deposited(results, sticking, "volume_fraction"));
    note(findings, "literature.ballistic.coordination",
         when_deposited(results, sticking, "coordination"));
  }

 private:
  // Whole specimens of one interval, of the realizations that got there.
  struct SlowerDeposit {
    double interval = 0;  // [sqrt(d/g)]
    std::vector<double> volume_fractions, coordinations, changes;
  };

  static std::vector<SlowerDeposit> adiabatic_sequence(const std::vector<const RunResults*>& runs) {
    std::vector<SlowerDeposit> sequence;
    for (const RunResults* run : runs) {
      const Json deposits = run->summary().value("adiabatic", Json::array());
      sequence.resize(std::max(sequence.size(), deposits.size()));
      for (std::size_t k = 0; k < deposits.size(); ++k) {
        const Json& deposit = deposits[k];
        sequence[k].interval = deposit.at("interval").get<double>();
        sequence[k].volume_fractions.push_back(deposit.at("volume_fraction").get<double>());
        sequence[k].coordinations.push_back(deposit.at("coordination").get<double>());
        if (const Json& change = deposit.at("change"); change.is_number())
          sequence[k].changes.push_back(change.get<double>());
      }
    }
    return sequence;
  }

  Table table_of(const std::vector<SlowerDeposit>& sequence) const {
    Table table{
        .caption =
            "Is a grain every " + number_text(scale_.interval) +
            " slow enough? Complete specimens from the same random numbers, each deposited more "
            "slowly than the last, until the volume fraction changes by less than 0.1 % or the "
            "longest interval here is reached; later rows have only the realizations that went on. "
            "Values are taken after the last grain, before the specimens settle.",
        .columns = {{"a grain every [sqrt(d/g)]", true},
                    {"volume fraction", true},
                    {"coordination number", true},
                    {"relative change of the volume fraction", true}}};
    for (const SlowerDeposit& slower : sequence)
      table.rows.push_back({{.text = typeset(slower.interval)},
                            cell_of(mean_over(slower.volume_fractions), all_),
                            cell_of(mean_over(slower.coordinations), all_),
                            cell_of(mean_over(slower.changes), all_)});
    return table;
  }

  // At the end of the deposit.
  static std::optional<Measured> when_deposited(const PaperResults& results, const RunGroup& group,
                                                const std::string& quantity) {
    std::vector<double> values;
    for (const RunResults* run : results.runs(group)) {
      const std::vector<std::string>& phases = run->phases();
      const auto end = std::find(phases.rbegin(), phases.rend(), "deposit").base();
      if (end != phases.begin())
        values.push_back(run->column(quantity)[static_cast<std::size_t>(end - phases.begin()) - 1]);
    }
    return mean_over(values);
  }

  // Points that lie together share a label, "1, 3, 5". It stands where it hits the fewest points and labels.
  static std::vector<Annotation> numbered(const Curve& points,
                                          const std::vector<std::string>& numbers) {
    constexpr double kNear = 0.04, kHeight = 0.1;  // and a label's height, of what all points span
    if (numbers.empty()) return {};
    const auto span = [](const std::vector<double>& x) {
      const auto [low, high] = std::ranges::minmax(x);
      return high > low ? high - low : 1;
    };
    const double wide = span(points.x), high = span(points.y);
    std::vector<Annotation> labels;
    for (std::size_t k = 0; k < numbers.size(); ++k) {
      const auto label = std::ranges::find_if(labels, [&](const Annotation& l) {
        return std::abs(l.x - points.x[k]) <= kNear * wide &&
               std::abs(l.y - points.y[k]) <= kHeight * high;
      });
      if (label == labels.end())
        labels.push_back({points.x[k], points.y[k], numbers[k]});
      else
        label->text += ", " + numbers[k];
    }
    // Of what all points span; a point is covered with its marker.
    constexpr double kCharacter = 0.02, kLine = 0.11, kMarker = 0.02;
    const auto covers = [&](const Annotation& label, double x, double y) {
      const double across = (x - label.x) / wide * (label.left ? -1 : 1);
      const double up = (y - label.y) / high * (label.below ? -1 : 1);
      const double width = kCharacter * static_cast<double>(label.text.size() + 1);
      return across > -kMarker && across < width + kMarker && up > kMarker && up < kLine + kMarker;
    };
    for (std::size_t l = 0; l < labels.size(); ++l) {
      Annotation best = labels[l];
      std::ptrdiff_t fewest = std::numeric_limits<std::ptrdiff_t>::max();
      for (const auto& [below, left] :
           {std::pair{false, false}, {true, false}, {false, true}, {true, true}}) {
        Annotation tried = labels[l];
        tried.below = below;
        tried.left = left;
        std::ptrdiff_t hits = 0;
        for (std::size_t k = 0; k < points.x.size(); ++k)
          hits += covers(tried, points.x[k], points.y[k]) ? 1 : 0;
        for (std::size_t before = 0; before < l; ++before)
          hits += covers(tried, labels[before].x, labels[before].y) ? 1 : 0;
        if (hits >= fewest) continue;
        fewest = hits;
        best = tried;
      }
      labels[l] = best;
    }
    return labels;
  }

  std::vector<RunGroup> groups_;
  PaperScale scale_;
};

}  // namespace

std::unique_ptr<PaperExperiment> make_samples_experiment() { return std::make_unique<Samples>(); }

}  // namespace quicksand
