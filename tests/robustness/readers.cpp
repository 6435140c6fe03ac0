#include "tests/robustness/readers.h"

#include <algorithm>
#include <cstdint>
#include <fstream>
#include <stdexcept>

#include "app/campaign/campaign.h"
#include "app/commands/command_table.h"
#include "app/commands/session_file.h"
#include "app/history/snapshot.h"
#include "app/run/run_options.h"
#include "app/run/run_position.h"
#include "app/scene_json/scenario_json.h"
#include "app/serve/client_message.h"
#include "core/base/errors.h"
#include "core/checkpoint/checkpoint.h"
#include "core/scene/make_world.h"
#include "core/scene/scenario.h"
#include "core/scene/validate.h"
#include "tests/support/files.h"

namespace quicksand::test {

namespace {

namespace fs = std::filesystem;

std::vector<std::string> assets_in(const char* folder) {
  std::vector<fs::path> paths;
  for (const auto& entry : fs::directory_iterator(kSource / "assets" / folder))
    if (entry.path().extension() == ".json") paths.push_back(entry.path());
  std::ranges::sort(paths);
  std::vector<std::string> texts;
  for (const fs::path& path : paths) texts.push_back(contents(path));
  return texts;
}

std::vector<std::string> scenes() {
  std::vector<std::string> texts = assets_in("scenes");
  texts.emplace_back(
      R"({"box": {"width": 20}, "bodies": [{"position": [0, 1], "repeat": {"count": 9, "offset": [2, 0]}}]})");
  return texts;
}

// Campaigns name their scene relative to themselves.
std::vector<std::string> campaigns() {
  std::vector<std::string> texts = assets_in("campaigns");
  for (std::string& text : texts) {
    constexpr std::string_view kScene = "\"scene\": \"";
    const std::size_t at = text.find(std::string(kScene) + "../");
    if (at != std::string::npos) text.replace(at + kScene.size(), 2, (kSource / "assets").string());
  }
  texts.emplace_back(R"({"scene": {"box": {"width": 9}, "phases": [{"type": "settle"}]},
    "list": [{"box.width": 9, "contact.friction": 0.3}, {"phases[0].max_time": 1}],
    "grid": {"gravity.tilt": [1, 2], "seed": [3, 4]}, "chunk": 2,
    "slurm": {"partition": "small", "time": "1:00:00", "memory": "2G", "options": ["--a=b"]}})");
  return texts;
}

std::vector<std::string> command_examples() {
  std::vector<std::string> lines;
  for (const SessionCommand& command : session_commands()) lines.emplace_back(command.example);
  return lines;
}

void write(const fs::path& file, const std::string& text) {
  std::ofstream(file, std::ios::binary | std::ios::trunc) << text;
}

constexpr std::size_t kSealSize = 9;

std::string unsealed(const std::string& bytes) { return bytes.substr(0, bytes.size() - kSealSize); }

// With a checksum that fits: what is damaged gets to the parser.
std::string sealed(std::string bytes) {
  std::uint64_t hash = 0xCBF29CE484222325ULL;
  for (const char c : bytes) hash = (hash ^ static_cast<std::uint8_t>(c)) * 0x100000001B3ULL;
  bytes += '\x48';
  for (unsigned k = 0; k < 8; ++k) bytes += static_cast<char>(hash >> (8 * k));
  return bytes;
}

// A checkpoint after so many steps.
std::string checkpoint_of(const char* scene, int steps, const fs::path& file) {
  const Scenario scenario = scenario_from_json(parse_json(scene));
  Protocol protocol(scenario, make_world(scenario));
  for (int k = 0; k < steps; ++k) protocol.advance();
  write_checkpoint(file, {protocol.world(), protocol.state(), to_text(scenario), to_bytes({})});
  return unsealed(contents(file));
}

// Of grains, walls, bonds and contacts; in the middle of a search for a force; with a shaped body; and one of an older
// program.
std::vector<std::string> checkpoints(const fs::path& file) {
  return {checkpoint_of(R"({"gravity": {},
    "box": {"width": 6, "height": 8}, "contact": {"friction": 0.3, "cohesion_force": 100},
    "phases": [{"type": "deposit", "grains": 6, "interval": 0.02},
               {"type": "push", "diameter": 2, "force": 300, "max_time": 0.1}]})",
                        40, file),
          checkpoint_of(R"({"gravity": {},
    "box": {"width": 6, "height": 8, "sides": "walls"}, "contact": {"cohesion_force": 10},
    "drag": {"linear": 1}, "phases": [{"type": "deposit", "grains": 8, "interval": 0},
      {"type": "shear", "depths": [0, 1], "grains_per_depth": 2, "first_force": 3,
       "max_time": 0.1}]})",
                        30, file),
          checkpoint_of(R"({"gravity": {},
    "box": {"width": 8, "height": 8, "sides": "walls"}, "contact": {"friction": 0.3},
    "phases": [{"type": "deposit", "grains": 8, "interval": 0.02},
      {"type": "penetrate", "shape": {"type": "cone", "width": 2}, "force": 20, "depth": 3}]})",
                        60, file),
          unsealed(contents(kSource / "tests/golden/mid_way.cbor"))};
}

// Of the states of these checkpoints: a history says by checksums whether its bytes are whole, and only then reads them.
std::vector<std::string> snapshots(const fs::path& file) {
  std::vector<std::string> texts;
  for (const std::string& bytes : checkpoints(file)) {
    write(file, sealed(bytes));
    const Bytes snapshot = snapshot_of(read_checkpoint(file).world);
    texts.emplace_back(snapshot.begin(), snapshot.end());
  }
  return texts;
}

void read_snapshot_of(const std::string& text) {
  try {
    world_from_snapshot({reinterpret_cast<const std::uint8_t*>(text.data()), text.size()});
  } catch (const std::runtime_error& problem) {
    throw InputError("history.qsh", problem.what());
  }
}

std::string default_options(const fs::path& file) {
  write_options(file, {});
  return contents(file);
}

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

// What a browser sends.
std::vector<std::string> messages() {
  return {R"({"ask": "body", "at": [1.5, -2], "id": 3})",
          R"({"ask": "recording", "id": 5})",
          R"({"command": "load", "scene": "chain", "set": {"box.width": 9}, "id": 4})",
          R"({"command": "set", "path": "phases[1].force", "value": 1e3})",
          R"({"command": "camera", "low": [0, 0.5], "high": [20, 12]})",
          R"({"command": "push", "diameter": 3, "density": 0.5, "force": 1e4, "max_time": 20})",
          R"({"command": "apply", "body": 12, "force": [100, -0.25], "id": 6})",
          R"({"command": "save", "file": "film/state.cbor"})"};
}

void read_message_of(const std::string& text) {
  Json id;
  const ClientMessage message = read_message(text, id);
  if (message.command.is_null() == message.question.is_null())
    throw std::logic_error("a message is a command or a question");
}

void read_campaign_of(const std::string& text, const fs::path& file) {
  write(file, text);
  const Campaign campaign = read_campaign(file);
  if (campaign.realizations <= 20) campaign_jobs(campaign, file, file.parent_path() / "out");
}

void read_checkpoint_of(const std::string& text, const fs::path& file) {
  write(file, sealed(text));
  const Checkpoint checkpoint = read_checkpoint(file);
  position_from(checkpoint.samples);
}

}  // namespace

std::vector<Reader> readers(const fs::path& folder) {
  const fs::path json = folder / "input.json", cbor = folder / "input.cbor";
  return {{"scene", scenes(), read_scene_of},
          {"campaign", campaigns(), [=](const std::string& text) { read_campaign_of(text, json); }},
          {"session", assets_in("sessions"),
           [=](const std::string& text) {
             write(json, text);
             read_session_file(json);
           }},
          {"line", command_examples(), read_line_of},
          {"message", messages(), read_message_of},
          {"options",
           {default_options(json)},
           [=](const std::string& text) {
             write(json, text);
             read_options(json);
           }},
          {"checkpoint", checkpoints(cbor),
           [=](const std::string& text) { read_checkpoint_of(text, cbor); }},
          {"history", snapshots(cbor), read_snapshot_of}};
}

}  // namespace quicksand::test
