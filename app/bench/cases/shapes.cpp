// What bodies of several parts cost: a vane against a disk of equal area, and a disk as a part against a disk, driven at
// the same speed to the same depth.
#include <cmath>
#include <numbers>

#include "app/bench/bench.h"
#include "app/bench/cases/window.h"
#include "app/bench/paper_states.h"
#include "app/bench/statistics.h"
#include "core/base/format.h"

namespace quicksand::bench {

namespace {

constexpr double kMostOfAVane = 1.15;  // time over that of the disk

struct Probe {
  const char* name;
  IntruderShape shape;
};

// The first is what the others are compared with.
const std::vector<Probe>& probes() {
  static const std::vector<Probe> all = [] {
    const VaneIntruder vane{.blades = 4, .radius = 3, .thickness = 0.3};
    const double radius = std::sqrt(mass_properties(parts_of(vane)).area / std::numbers::pi);
    return std::vector<Probe>{
        {"disk", DiskIntruder{.diameter = 2 * radius}},
        {"disk as a part", PartsIntruder{{{.corners = {{0, 0}}, .radius = radius}}}},
        {"vane of four blades", vane}};
  }();
  return all;
}

void measure_probe(const Probe& probe, const Options& options, std::vector<Row>& rows) {
  constexpr double kSpeed = 2, kDt = 5e-3;  // [sqrt(g d)], [sqrt(d/g)]
  Scenario scene = paper_scene(options);
  const World start = fresh_deposit(options, options.quick ? 400 : 5000);
  const std::int64_t steps = options.quick ? 100 : 300;
  scene.phases = {
      {.kind = PenetratePhase{.shape = probe.shape, .speed = kSpeed, .depth = start.box.height},
       .dt = kDt}};
  for (int repeat = 0; repeat < options.repeats_or(3); ++repeat) {
    Protocol protocol(scene, start);
    const Window window = measure_window(protocol, {.steps = steps}, options);
    Row row = window.run;
    row.name = probe.name;
    row.repeat = repeat;
    row.dt = kDt;
    row.found = window.failure;
    rows.push_back(row);
  }
}

std::vector<double> seconds_of(std::span<const Row> rows, const char* name) {
  std::vector<double> seconds;
  for (const Row& row : rows)
    if (row.name == name && row.steps > 0)
      seconds.push_back(row.seconds.cpu / static_cast<double>(row.steps));
  return seconds;
}

}  // namespace

std::vector<Task> shape_tasks(const Options& options) {
  return tasks_of(probes(), options, measure_probe);
}

void report_shapes(std::span<const Row> rows, const Options&, Section& section) {
  section.add(Paragraph{format(
      "Driven at 2 sqrt(g d) into %lld grains as they were deposited, the same number of steps; "
      "medians. A vane of four blades of 3 d takes at most %.2f times the time of a disk of equal "
      "area.",
      rows.empty() ? 0LL : static_cast<long long>(rows.front().size), kMostOfAVane)});
  Table table{.columns = {{"intruder"},
                          {"ms a step", true},
                          {"over the disk's", true},
                          {"factorisations a step", true},
                          {"unconverged", true}}};
  const double of_disk = median(seconds_of(rows, probes().front().name));
  for (const Probe& probe : probes()) {
    const std::vector<double> seconds = seconds_of(rows, probe.name);
    if (seconds.empty() || of_disk == 0) continue;
    const Row& any = *std::ranges::find(rows, std::string(probe.name), &Row::name);
    const double ratio = median(seconds) / of_disk;
    Cell over{format("%.3f", ratio)};
    if (std::holds_alternative<VaneIntruder>(probe.shape))
      over.mark = ratio <= kMostOfAVane ? Cell::Mark::inside : Cell::Mark::outside;
    table.rows.push_back(
        {{probe.name},
         {format("%.3g", 1e3 * median(seconds))},
         over,
         {format("%.2f", static_cast<double>(any.factorisations) / static_cast<double>(any.steps))},
         {std::to_string(any.unconverged)}});
  }
  section.add(std::move(table));
}

}  // namespace quicksand::bench
