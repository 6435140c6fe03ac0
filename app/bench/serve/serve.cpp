// What a browser costs a run, and what the run leaves for the browser: the real server and its clients on this machine,
// a system at rest and one that an intruder ploughs.
#include <algorithm>
#include <atomic>
#include <map>
#include <memory>

#include "app/bench/bench.h"
#include "app/bench/paper_states.h"
#include "app/bench/serve/served.h"
#include "app/bench/serve/viewer.h"
#include "app/bench/statistics.h"

namespace quicksand::bench {

namespace {

using Clock = std::chrono::steady_clock;
using std::chrono::milliseconds;

struct Watched {
  double pictures = 0;  // a second, of each client
  double bytes = 0;     // of a picture
};

// So many clients look on until the end.
Watched look_on(const Served& served, int clients, double seconds, const std::atomic<bool>& ends) {
  std::vector<std::unique_ptr<Viewer>> viewers;
  viewers.reserve(static_cast<std::size_t>(clients));
  for (int i = 0; i < clients; ++i)
    viewers.push_back(std::make_unique<Viewer>(served.port(), served.token()));
  while (!ends)
    for (auto& viewer : viewers) viewer->picture(milliseconds(clients == 1 ? 50 : 2));
  Watched seen;
  for (const auto& viewer : viewers) {
    seen.pictures += viewer->pictures() / seconds / clients;
    seen.bytes += viewer->pictures() > 0
                      ? static_cast<double>(viewer->bytes()) / viewer->pictures() / clients
                      : 0;
  }
  return seen;
}

// From a command to the first picture that shows it [ms].
std::vector<double> delays(const Served& served, const std::atomic<bool>& ends) {
  std::vector<double> found;
  Viewer viewer(served.port(), served.token());
  constexpr const char* kColours[] = {"speed", "coordination"};
  constexpr const char* kTitles[] = {"\"Speed", "\"Contacts\""};
  constexpr milliseconds kPause{37};  // in which pictures go on
  for (std::size_t i = 0; !ends; ++i) {
    const auto rest = Clock::now() + kPause;
    while (Clock::now() < rest) viewer.picture(milliseconds(5));
    const auto begin = Clock::now();
    viewer.say({{"command", "view"}, {"colour", kColours[i % 2]}});
    while (!ends) {
      const auto head = viewer.picture(milliseconds(50));
      if (!head || head->find(kTitles[i % 2]) == std::string::npos) continue;
      found.push_back(1e3 * seconds_since(begin));
      break;
    }
  }
  return found;
}

void measure(const Options& options, const Checkpoint& state, const Scenario& scene,
             std::vector<Row>& rows) {
  const double seconds = options.quick ? 1 : 8;
  constexpr int kMostClients = 8;
  Served served(options, state, scene);
  const auto add = [&](const char* what, const std::string& method, double value,
                       const char* unit) {
    rows.push_back({.what = what,
                    .method = method,
                    .size = state.world.disks.size(),
                    .value = value,
                    .unit = unit});
  };
  std::map<int, std::vector<double>> rates;
  std::map<int, Watched> watched;
  for (int repeat = 0; repeat < options.repeats_or(options.quick ? 1 : 3); ++repeat) {
    for (const int clients : {0, 1, kMostClients}) {
      stop_if_interrupted();
      rates[clients].push_back(served.steps_per_second(seconds, [&](const std::atomic<bool>& ends) {
        if (clients > 0) watched[clients] = look_on(served, clients, seconds, ends);
      }));
    }
  }
  for (const auto& [clients, found] : rates)
    add("steps", std::to_string(clients), median(found), "1/s");
  for (const auto& [clients, seen] : watched) {
    add("pictures", std::to_string(clients), seen.pictures, "1/s");
    add("bytes", std::to_string(clients), seen.bytes, "B");
  }
  std::vector<double> waits;
  served.steps_per_second(seconds,
                          [&](const std::atomic<bool>& ends) { waits = delays(served, ends); });
  add("delay", "1", quantile(waits, 0.95), "ms");
}

double value_of(std::span<const Row> rows, const std::string& name, const char* what,
                const char* clients) {
  for (const Row& row : rows)
    if (row.name == name && row.what == what && row.method == clients) return row.value.value_or(0);
  return 0;
}

}  // namespace

std::vector<Task> serve_tasks(const Options& options) {
  const auto stays = [options](std::vector<Row>& rows) {
    Scenario scene = wide_scene(options);
    scene.phases = {{.kind = SettlePhase{.max_time = 1e6, .until_rest = false}, .dt = {}}};
    measure(options, {at_rest(options).world, {}, {}}, scene, rows);
  };
  const auto ploughs = [options](std::vector<Row>& rows) {
    measure(options, ploughing(options), paper_scene(options), rows);
  };
  return {{"at rest", stays}, {"pushing", ploughs}};
}

void report_serve(std::span<const Row> rows, const Options&, Section& section) {
  section.add(
      Paragraph{"`quicksand serve` and its clients on this machine: the step rate on one core "
                "without a client, with one and "
                "with eight; the pictures a second that each client gets, and their size; and the "
                "time from a command to the "
                "first picture that shows it, of which 95 in 100 are shorter."});
  Table table{.columns = {{"state"},
                          {"grains", true},
                          {"steps/s, no client", true},
                          {"one, over none", true},
                          {"eight, over none", true},
                          {"pictures/s, one", true},
                          {"pictures/s, each of eight", true},
                          {"bytes a picture", true},
                          {"input to picture [ms]", true}}};
  for (const Row& row : rows) {
    if (row.what != "steps" || row.method != "0") continue;
    const auto value = [&](const char* what, const char* clients) {
      return value_of(rows, row.name, what, clients);
    };
    const double alone = value("steps", "0");
    table.rows.push_back({{row.name},
                          {std::to_string(row.size)},
                          {format("%.3g", alone)},
                          {format("%.3f", value("steps", "1") / alone)},
                          {format("%.3f", value("steps", "8") / alone)},
                          {format("%.1f", value("pictures", "1"))},
                          {format("%.1f", value("pictures", "8"))},
                          {format("%.0f", value("bytes", "1"))},
                          {format("%.0f", value("delay", "1"))}});
  }
  section.add(std::move(table));
}

}  // namespace quicksand::bench
