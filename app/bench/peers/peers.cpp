// Other programs on the same scenes, each in its own idiom: time and error side by side.
#include <set>

#include "app/bench/hard/hard_run.h"
#include "app/bench/peers/peer_program.h"
#include "app/plot/report_text.h"
#include "app/run_folder/run_folder.h"

namespace quicksand::bench {

namespace {

// Rows by `what`. Only ours count as passed or not: what a peer does is not for us to fail.
constexpr const char* kOurs = "ours";
constexpr const char* kPeer = "peer";
constexpr const char* kAbsent = "not installed";

struct OurSetting {
  std::string_view name;
  double dt, tolerance;
};
constexpr std::array kOurSettings{OurSetting{"defaults", 1e-2, 1e-6},
                                  OurSetting{"tuned", 2e-3, 1e-9}};

std::string words(std::string_view program, std::string_view setting) {
  return std::string(program) + ", " + std::string(setting);
}

void add_verdict(const PeerScene& scene, const PeerState& state, Row& row) {
  const Verdict verdict = verdict_on(scene, state);
  row.error = verdict.off;
  row.unit = scene.unit;
  row.found = verdict.found;
  row.passed = verdict.right;
}

Row our_run(const PeerScene& one, const OurSetting& setting) {
  Scenario scene = one.scene;
  scene.step.dt = setting.dt;
  scene.solver.tolerance = setting.tolerance;
  HardRun run(scene);
  run.run_for(one.time);
  Row row = run.answer({}, {}, 0, 0, {});
  PeerState state{.position = run.world().disks.position, .velocity = run.world().disks.velocity};
  for (const Bond& bond : run.world().bonds.list)
    if (bond.state == BondState::broken) state.broken.push_back(bond.pair);
  row.what = kOurs;
  row.method = words("quicksand", setting.name);
  row.expected = one.expected;
  add_verdict(one, state, row);
  return row;
}

Row peer_run(const Peer& peer, std::string_view setting, const PeerScene& scene,
             const Options& options) {
  const int limit = options.quick ? 60 : 600;  // [s]
  Row row{.what = kPeer, .method = words(peer.name, setting), .expected = scene.expected};
  row.size = static_cast<std::int64_t>(scene.scene.disks.size());
  const std::filesystem::path folder = std::filesystem::absolute(options.out / "peers");
  make_writable({.path = folder});
  const PeerAnswer answer = ask(peer, setting, scene, limit, folder);
  row.seconds = answer.seconds;
  switch (answer.end) {
    case PeerAnswer::End::answered:
      row.method = words(std::string(peer.name) + " " + answer.version, setting);
      row.dt = answer.dt;
      row.steps = answer.steps;
      add_verdict(scene, answer.state, row);
      break;
    case PeerAnswer::End::not_installed:
      row.found = kAbsent;
      break;
    case PeerAnswer::End::out_of_time:
      row.found = format("no answer within %d s", limit);
      break;
    case PeerAnswer::End::failed:
      row.found = "failed: " + answer.problem;
      break;
  }
  return row;
}

void measure_scene(const PeerScene& scene, const Options& options, std::vector<Row>& rows) {
  for (const OurSetting& setting : kOurSettings) rows.push_back(our_run(scene, setting));
  for (const Peer& peer : peers()) {
    if (scene.cohesive() && !peer.cohesion) {
      rows.push_back({.what = kPeer,
                      .method = std::string(peer.name),
                      .expected = scene.expected,
                      .found = "no bonds"});
      continue;
    }
    for (const std::string_view setting : kPeerSettings) {
      stop_if_interrupted();
      rows.push_back(peer_run(peer, setting, scene, options));
    }
  }
}

Cell verdict_cell(const Row& row) {
  if (!row.passed) return {"-"};
  return *row.passed ? Cell{"right", Cell::Mark::inside} : Cell{"WRONG", Cell::Mark::outside};
}

Table table_of(std::span<const Row> rows) {
  Table table{.columns = {{"scene"},
                          {"program, setting"},
                          {"found"},
                          {"off by", true},
                          {"verdict"},
                          {"dt", true},
                          {"steps", true},
                          {"seconds", true}}};
  std::string last;
  for (const Row& row : rows) {
    if (row.found == kAbsent) continue;
    table.rows.push_back({{row.name == last ? "" : row.name + ": " + row.expected},
                          {row.method},
                          {row.found},
                          {row.error ? format("%.1e %s", *row.error, row.unit.c_str()) : "-"},
                          verdict_cell(row),
                          {row.dt > 0 ? format("%.1e", row.dt) : "-"},
                          {row.steps > 0 ? std::to_string(row.steps) : "-"},
                          {row.seconds.cpu > 0 ? format("%.2g", row.seconds.cpu) : "-"}});
    last = row.name;
  }
  return table;
}

std::string program_of(const Row& row) { return row.method.substr(0, row.method.find(',')); }

// Time against error of a scene. Of each program an open marker and a filled one of the same form: its defaults, and
// its tuned setting.
Plot scene_plot(std::span<const Row> rows, const std::string& scene) {
  constexpr double kLeast = 1e-12;  // below it an error is drawn here [d]
  const bool of_heap = scene.starts_with("heap");
  Plot plot{.name = "peers_" + file_name_text(scene),
            .title = scene,
            .x = {.label = of_heap ? "largest overlap" : "largest displacement",
                  .unit = "d",
                  .logarithmic = true},
            .y = {.label = "CPU time", .unit = "s", .logarithmic = true}};
  std::string last;
  for (const Row& row : rows) {
    if (row.name != scene || !row.error || row.seconds.cpu <= 0) continue;
    const std::string program = program_of(row);
    if (program != last) {
      plot.curves.push_back({.role = Curve::Role::paper});  // which has open markers
      plot.curves.push_back({});
      last = program;
    }
    const bool tuned = row.method.ends_with("tuned");
    Curve& curve = plot.curves[plot.curves.size() - (tuned ? 1 : 2)];
    curve.x.push_back(std::max(kLeast, *row.error));
    curve.y.push_back(row.seconds.cpu);
    // In the legend stands the tuned one, where there is one.
    if (tuned) plot.curves[plot.curves.size() - 2].name.clear();
    if (tuned || plot.curves.back().x.empty()) curve.name = program;
  }
  return plot;
}

// Programs that are installed but have no point in a scene.
std::string missing_programs(std::span<const Row> rows, const std::string& scene) {
  std::string missing;
  for (const Peer& peer : peers()) {
    bool installed = false, drawn = false;
    for (const Row& row : rows) {
      if (row.name != scene || row.found == kAbsent || !row.method.starts_with(peer.name)) continue;
      installed = true;
      drawn = drawn || (row.error && row.seconds.cpu > 0);
    }
    if (installed && !drawn) missing += (missing.empty() ? "" : ", ") + std::string(peer.name);
  }
  return missing;
}

}  // namespace

std::vector<Task> peer_tasks(const Options& options) {
  return tasks_of(peer_scenes(options), options, measure_scene);
}

void report_peers(std::span<const Row> rows, const Options&, Section& section) {
  section.add(Paragraph{
      "The same starting states, under the same gravity for the same time (column dt: the step, in "
      "sqrt(d/g)), as each program would be set up by its users: by its defaults, and tuned by us; "
      "what that means and why stands in its driver in tests/bench/peers. Ours tuned is dt = 2e-3 "
      "and a tolerance of 1e-9. What is expected is the closed form; right is what has moved by "
      "less than 0.1 d; for heaps, overlaps by less than 0.01 d and has come down to a volume "
      "fraction of 0.7; for beams that yield, turns to 10 %. Seconds are of the CPU, one thread, "
      "in the time steps alone, and include those in which a driver lets gravity rise. A program "
      "without a law of bonds that break is not judged where there are bonds. Box2D is of single "
      "precision: it is off by the distance of neighbouring numbers at least."});
  std::set<std::string> absent, scenes;
  for (const Row& row : rows)
    if (row.found == kAbsent) absent.insert(program_of(row));
  for (const Peer& peer : peers())
    if (absent.contains(std::string(peer.name)))
      section.add(
          Remark{Remark::Kind::note, std::string(peer.name) +
                                         " was left out: it or its driver is not there (package " +
                                         std::string(peer.packages) + ")."});
  section.add(table_of(rows));
  for (const Row& row : rows) {
    if (row.unit != "d" || !row.error || !scenes.insert(row.name).second) continue;
    std::string caption = row.name +
                          ": open markers are defaults, filled ones tuned settings; further left "
                          "and lower is better. Errors below 1e-12 d are drawn there.";
    if (const std::string missing = missing_programs(rows, row.name); !missing.empty())
      caption += " Without a point, as they gave no answer or have no such bonds: " + missing + ".";
    section.add(quicksand::Figure{scene_plot(rows, row.name), caption});
  }
}

}  // namespace quicksand::bench
