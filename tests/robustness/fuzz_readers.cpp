// Feeds every reader with damaged files: each must read or refuse them with an InputError, within a second
// or two and a bounded memory. `quicksand_fuzz [--executions N] [--seconds S] [--seed N] [--save DIR]`.
//
// An input that is not dealt with so is saved, and the exit code is 1. The same seed makes the same inputs.
#include <sys/resource.h>
#include <sys/time.h>
#include <unistd.h>

#include <array>
#include <chrono>
#include <csignal>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <fstream>
#include <functional>
#include <string>
#include <string_view>
#include <vector>

#include "app/campaign/campaign.h"
#include "app/run/run_options.h"
#include "app/run/run_position.h"
#include "app/scene/scenario_json.h"
#include "app/scene/scene_file.h"
#include "app/session/command_table.h"
#include "app/session/session_file.h"
#include "core/checkpoint.h"
#include "core/errors.h"
#include "tests/robustness/mutation.h"
#include "tests/support/temporary_folder.h"

namespace quicksand::test {
namespace {

namespace fs = std::filesystem;

constexpr rlim_t kMostMemory = rlim_t{2} << 30U;  // [bytes]
constexpr int kLongestRead = 20;                  // of one input, computing time [s]

// What a signal handler saves when the program crashes or hangs.
struct Present {
  const char* data = nullptr;
  std::size_t size = 0;
  std::array<char, 512> path{};
};
Present present;

void save_and_leave(int signal) {
  std::FILE* file = std::fopen(present.path.data(), "wb");
  if (file != nullptr) {
    std::fwrite(present.data, 1, present.size, file);
    std::fclose(file);
  }
  std::fprintf(stderr, "signal %d; the input is in %s\n", signal, present.path.data());
  _exit(1);
}

std::string read_file(const fs::path& path) {
  std::ifstream file(path, std::ios::binary);
  return {std::istreambuf_iterator<char>(file), {}};
}

std::vector<std::string> files_in(const std::string& folder) {
  std::vector<std::string> texts;
  std::vector<fs::path> paths;
  for (const auto& entry : fs::directory_iterator(fs::path(QUICKSAND_SOURCE) / "assets" / folder))
    if (entry.path().extension() == ".json") paths.push_back(entry.path());
  std::ranges::sort(paths);
  for (const fs::path& path : paths) texts.push_back(read_file(path));
  return texts;
}

// A checkpoint of grains, walls, bonds and contacts, without its checksum.
std::string small_checkpoint(const fs::path& file) {
  const Scenario scenario = scenario_from_json(parse_json(R"({"gravity": {},
    "box": {"width": 6, "height": 8}, "contact": {"friction": 0.3, "cohesion_force": 100},
    "phases": [{"type": "deposit", "grains": 6, "interval": 0.02},
               {"type": "push", "diameter": 2, "force": 300, "max_time": 0.1}]})"));
  Protocol protocol(scenario, make_world(scenario));
  for (int k = 0; k < 40; ++k) protocol.advance();
  write_checkpoint(file, {protocol.world(), protocol.state(), to_text(scenario), to_bytes({})});
  const std::string bytes = read_file(file);
  return bytes.substr(0, bytes.size() - 9);
}

// With a checksum that fits: what is damaged gets to the parser.
std::string sealed(std::string bytes) {
  std::uint64_t hash = 0xCBF29CE484222325ULL;
  for (const char c : bytes) hash = (hash ^ static_cast<std::uint8_t>(c)) * 0x100000001B3ULL;
  bytes += '\x48';
  for (unsigned k = 0; k < 8; ++k) bytes += static_cast<char>(hash >> (8 * k));
  return bytes;
}

void write(const fs::path& file, const std::string& text) {
  std::ofstream(file, std::ios::binary | std::ios::trunc) << text;
}

struct Reader {
  std::string_view name;
  std::vector<std::string> seeds;
  std::function<void(const std::string&)> read;
};

void read_scene_of(const std::string& text) {
  const Scenario scenario = scenario_from_json(parse_json(text));
  validate(scenario);
  if (scenario.start_from.empty()) make_world(scenario);
  // What was accepted reads back as itself.
  const std::string resolved = to_text(scenario);
  if (to_text(scenario_from_json(parse_json(resolved))) != resolved)
    throw std::logic_error("the resolved scene reads back as another one");
}

void read_line_of(const std::string& text) {
  const Json command = parse_json(text);
  command_of(command, "line").check(command, "line");
}

// Campaigns name their scene relative to themselves.
std::vector<std::string> campaigns() {
  std::vector<std::string> texts = files_in("campaigns");
  for (std::string& text : texts) {
    const std::size_t at = text.find("../scenes");
    if (at != std::string::npos) text.replace(at, 2, QUICKSAND_SOURCE "/assets");
  }
  return texts;
}

std::vector<std::string> command_examples() {
  std::vector<std::string> lines;
  for (const SessionCommand& command : session_commands()) lines.emplace_back(command.example);
  return lines;
}

std::vector<Reader> readers(const fs::path& folder) {
  const fs::path json = folder / "input.json", cbor = folder / "input.cbor";
  std::vector<std::string> scenes = files_in("scenes");
  scenes.push_back(
      R"({"bodies": [{"position": [0, 1], "repeat": {"count": 9, "offset": [2, 0]}}]})");
  write(json, "");
  write_options(json, {});
  const std::string options = read_file(json);
  return {
      {"scene", std::move(scenes), read_scene_of},
      {"campaign", campaigns(),
       [=](const std::string& text) {
         write(json, text);
         const Campaign campaign = read_campaign(json);
         if (campaign.realizations <= 20) campaign_jobs(campaign, json, folder / "out");
       }},
      {"session", files_in("sessions"),
       [=](const std::string& text) {
         write(json, text);
         read_session_file(json);
       }},
      {"line", command_examples(), read_line_of},
      {"options",
       {options},
       [=](const std::string& text) {
         write(json, text);
         read_options(json);
       }},
      {"checkpoint",
       {small_checkpoint(cbor)},
       [=](const std::string& text) {
         write(cbor, sealed(text));
         const Checkpoint checkpoint = read_checkpoint(cbor);
         try {
           position_from(checkpoint.samples);
         } catch (const std::exception&) {
           // As whoever reads it does: it was not left by a run.
         }
       }},
  };
}

struct Options {
  std::int64_t executions = INT64_MAX;
  double seconds = 1e9;
  unsigned seed = 1;
  fs::path save = ".";
};

// A busy machine is no hang: computing time counts. 0: no more. [s]
void watch_for(int seconds) {
  const itimerval time{{0, 0}, {seconds, 0}};
  setitimer(ITIMER_PROF, &time, nullptr);
}

// False if the input was neither read nor refused.
bool survives(const Reader& reader, const std::string& input, std::int64_t& accepted) {
  present.data = input.data();
  present.size = input.size();
  watch_for(kLongestRead);
  try {
    reader.read(input);
    ++accepted;
  } catch (const InputError&) {
    // Refused, as it should be.
  } catch (const std::exception& error) {
    std::fprintf(stderr, "%.*s: %s\n", static_cast<int>(reader.name.size()), reader.name.data(),
                 error.what());
    watch_for(0);
    return false;
  }
  watch_for(0);
  return true;
}

int fuzz(const Options& options) {
  const TemporaryFolder folder;
  std::vector<Reader> all = readers(folder.path());
  std::vector<Mutation> mutations;
  for (const Reader& reader : all) mutations.emplace_back(options.seed, reader.seeds);
  const rlimit memory{kMostMemory, kMostMemory};
  setrlimit(RLIMIT_AS, &memory);
  for (const int signal : {SIGSEGV, SIGABRT, SIGFPE, SIGBUS, SIGPROF})
    std::signal(signal, save_and_leave);

  std::vector<std::int64_t> accepted(all.size(), 0);
  std::int64_t done = 0, findings = 0;
  const auto begin = std::chrono::steady_clock::now();
  const auto seconds = [&] {
    return std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
  };
  for (; done < options.executions && seconds() < options.seconds && findings < 20; ++done) {
    const std::size_t which = static_cast<std::size_t>(done) % all.size();
    const std::string input = mutations[which].next();
    const fs::path path =
        options.save / (std::string(all[which].name) + "_" + std::to_string(done));
    std::snprintf(present.path.data(), present.path.size(), "%s", path.c_str());
    if (survives(all[which], input, accepted[which])) continue;
    ++findings;
    write(path, input);
    std::fprintf(stderr, "the input is in %s\n", path.c_str());
  }
  std::printf("%lld executions in %.0f s, %lld findings; accepted:", static_cast<long long>(done),
              seconds(), static_cast<long long>(findings));
  for (std::size_t k = 0; k < all.size(); ++k)
    std::printf(" %.*s %lld", static_cast<int>(all[k].name.size()), all[k].name.data(),
                static_cast<long long>(accepted[k]));
  std::printf("\n");
  return findings > 0 ? 1 : 0;
}

}  // namespace
}  // namespace quicksand::test

int main(int argc, char** argv) {
  quicksand::test::Options options;
  for (int k = 1; k + 1 < argc; k += 2) {
    const std::string_view name = argv[k];
    if (name == "--executions") options.executions = std::strtoll(argv[k + 1], nullptr, 10);
    if (name == "--seconds") options.seconds = std::strtod(argv[k + 1], nullptr);
    if (name == "--seed")
      options.seed = static_cast<unsigned>(std::strtoul(argv[k + 1], nullptr, 10));
    if (name == "--save") options.save = argv[k + 1];
  }
  return quicksand::test::fuzz(options);
}
