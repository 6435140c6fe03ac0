// Cost of the model's terms: the same heap of touching disks at rest, with all terms and with one left out.
//
// Instructions are those of whole processes under callgrind.
#include <cmath>
#include <fstream>

#include "app/bench/bench.h"
#include "app/bench/cases/window.h"
#include "app/bench/statistics.h"
#include "app/run_folder/run_folder.h"
#include "app/scene_json/scenario_json.h"
#include "core/base/whole_file.h"
#include "core/scene/make_world.h"
#include "core/scene/scenario.h"
#include "render/base/external_program.h"

namespace quicksand::bench {

namespace {

constexpr int kCountedSteps = 20;  // after the first, which takes up the weight

// Rows of touching disks between walls, bonded.
Scenario heap(const Options& options) {
  const int rows = options.quick ? 16 : 40;
  Scenario scene;
  scene.name = "terms";
  scene.gravity = Vec2(0, -1);
  scene.box = {.width = static_cast<double>(rows),
               .height = static_cast<double>(rows),
               .sides = Sides::walls,
               .floor = true};
  scene.grain_law = {.friction = 0.3, .rolling_friction = 0.1, .cohesion_force = 10.0};
  scene.drag = Drag{.linear = 0.1};
  scene.initial_bonds = InitialBonds::touching;
  const double rise = std::sqrt(3.0) / 2;
  for (int row = 0; row < rows; ++row)
    for (int k = 0; k < rows - row % 2; ++k)
      scene.disks.push_back({.position = {0.5 + 0.5 * (row % 2) + k, 0.5 + row * rise}});
  // One that passes by above: of a world at rest no further step would be computed.
  scene.disks.push_back({.position = {0.5, rows - 0.5}, .velocity = {1, 0}, .fixed = true});
  return scene;
}

Scenario with_steps(Scenario scene, int steps) {
  scene.phases = {{.kind = SettlePhase{.max_time = steps * scene.step.dt, .until_rest = false}}};
  return scene;
}

struct Variant {
  const char* name;
  void (*change)(Scenario& scene);
};
const std::vector<Variant>& variants() {
  static const std::vector<Variant> all{
      {"all terms", [](Scenario&) {}},
      {"no cohesion",
       [](Scenario& s) {
         s.grain_law.cohesion_force.reset();
         s.initial_bonds = InitialBonds::none;
       }},
      {"no rolling friction", [](Scenario& s) { s.grain_law.rolling_friction.reset(); }},
      {"no friction, no rolling friction",
       [](Scenario& s) {
         s.grain_law.friction.reset();
         s.grain_law.rolling_friction.reset();
       }},
      {"no drag", [](Scenario& s) { s.drag.reset(); }},
      {"no curvature term", [](Scenario& s) { s.step.curvature_term = false; }},
      {"linearised failure criterion",
       [](Scenario& s) { s.step.break_rule = FailureCriterion::linearised; }}};
  return all;
}

// Of the program running a scene; none where there is no valgrind.
std::optional<double> instructions(const Scenario& scene, const std::filesystem::path& folder) {
  write_whole(folder / "scene.json", to_text(scene));
  const std::string program = std::filesystem::read_symlink("/proc/self/exe").string();
  const ProgramEnd end =
      run_external({"valgrind", "--tool=callgrind", "--callgrind-out-file=counts", program, "run",
                    "scene.json", "--out", "run", "--overwrite", "--no-frames", "--quiet"},
                   folder);
  if (end.missing) return {};
  if (!end.fine()) throw std::runtime_error("callgrind: " + end.problem);
  std::ifstream counts(folder / "counts");
  for (std::string line; std::getline(counts, line);)
    if (line.starts_with("totals:")) return std::stod(line.substr(7));
  throw std::runtime_error("callgrind left no total");
}

void measure_variant(const Variant& variant, const Options& options, std::vector<Row>& rows) {
  Scenario scene = heap(options);
  variant.change(scene);
  const World start = make_world(scene);
  for (int repeat = 0; repeat < options.repeats_or(5); ++repeat) {
    Protocol protocol(with_steps(scene, kCountedSteps + 1), start);
    measure_window(protocol, {.steps = 1}, options);
    Row row = measure_window(protocol, {.steps = kCountedSteps}, options).run;
    row.name = variant.name;
    row.what = "steps";
    row.method = "auto";
    row.repeat = repeat;
    row.size = start.disks.size();
    rows.push_back(row);
  }
  // The sweeps of Gauss-Seidel read every row of the problem each time, whatever it holds.
  for (int repeat = 0; repeat < options.repeats_or(5); ++repeat) {
    World world = start;
    Scenario swept = scene;
    swept.solver = {.method = Method::gauss_seidel, .tolerance = 1e-300, .max_iterations = 500};
    swept.step.stop_if_unconverged = false;
    StepReport report;
    Row row = measure_step(world, swept, options, report);
    row.name = variant.name;
    row.what = "sweeps";
    row.method = "gauss_seidel";
    row.tolerance = 0;
    row.repeat = repeat;
    row.size = start.disks.size();
    rows.push_back(row);
  }
  const std::filesystem::path folder = std::filesystem::absolute(options.out / "counted");
  make_writable({folder});
  Row counted{.name = variant.name,
              .what = "instructions",
              .size = start.disks.size(),
              .unit = "instructions a step"};
  const std::optional<double> one = instructions(with_steps(scene, 1), folder);
  const std::optional<double> some =
      one ? instructions(with_steps(scene, kCountedSteps + 1), folder) : std::nullopt;
  if (some) {
    counted.value = (*some - *one) / kCountedSteps;
    counted.steps = kCountedSteps;
    rows.push_back(counted);
  }
  std::filesystem::remove_all(folder);
}

std::vector<double> of(std::span<const Row> rows, const std::string& name, const char* what) {
  std::vector<double> values;
  for (const Row& row : rows) {
    if (row.name != name || row.what != what) continue;
    const double count = std::string_view(what) == "sweeps" ? static_cast<double>(row.iterations)
                                                            : static_cast<double>(row.steps);
    values.push_back(row.value ? *row.value : row.seconds.cpu / std::max(1.0, count));
  }
  return values;
}

std::string with_saving(double value, double of_all, const char* pattern) {
  return format(pattern, value) + format(" (%+.0f %%)", 100 * (value / of_all - 1));
}

}  // namespace

std::vector<Task> term_tasks(const Options& options) {
  return tasks_of(variants(), options, measure_variant);
}

void report_terms(std::span<const Row> rows, const Options&, Section& section) {
  const std::string all = variants().front().name;
  section.add(Paragraph{format(
      "A heap of %lld disks at rest, so that leaving out a term changes the work and not the "
      "motion. A step is the program's default one (auto), the mean of %d after the first, which "
      "takes up the weight; a sweep is one of Gauss-Seidel over all contacts. Seconds are medians; "
      "in brackets the change against all terms. auto tries the local solver only where there is "
      "rolling friction, so a scene without it may pay more a step although each sweep is cheaper.",
      rows.empty() ? 0LL : static_cast<long long>(rows.front().size), kCountedSteps)});
  Table table{.columns = {{"scene"},
                          {"µs a step", true},
                          {"µs a sweep", true},
                          {"million instructions a step", true}}};
  bool counted = false;
  for (const Variant& variant : variants()) {
    const auto cell = [&](const char* what, double scale) -> Cell {
      const std::vector<double> values = of(rows, variant.name, what), whole = of(rows, all, what);
      if (values.empty() || whole.empty()) return {"-"};
      return {with_saving(scale * median(values), scale * median(whole), "%.4g")};
    };
    if (of(rows, variant.name, "steps").empty()) continue;
    counted = counted || !of(rows, variant.name, "instructions").empty();
    table.rows.push_back(
        {{variant.name}, cell("steps", 1e6), cell("sweeps", 1e6), cell("instructions", 1e-6)});
  }
  section.add(std::move(table));
  if (counted) {
    section.add(
        Paragraph{format("Instructions are counted by valgrind --tool=callgrind on `quicksand "
                         "run`: a run of %d steps less one of a single step, over %d.",
                         kCountedSteps + 1, kCountedSteps)});
  } else {
    section.add(
        Remark{Remark::Kind::note, "valgrind is not installed: no instructions were counted."});
  }
}

}  // namespace quicksand::bench
