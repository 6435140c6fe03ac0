#include "app/bench/peers/peer_program.h"

#include <array>
#include <csignal>

#include "app/base/assets.h"
#include "core/base/errors.h"
#include "core/base/whole_file.h"
#include "render/base/external_program.h"

namespace quicksand::bench {

namespace {

constexpr int kNotInstalled = 127;
constexpr int kOutOfTime = 128 + SIGXCPU;

std::filesystem::path drivers() {
  return std::filesystem::absolute(assets_folder()).parent_path() / "tests/bench/peers";
}

std::vector<std::string> box2d() {
  const std::filesystem::path program = std::filesystem::read_symlink("/proc/self/exe");
  return {program.parent_path() / "peer_box2d"};
}

// One thread, as all others; no graphics, and an end where the script ends.
std::vector<std::string> yade() { return {"yade", "-j1", "-n", "-x", drivers() / "yade_peer.py"}; }

std::vector<std::string> siconos() { return {drivers() / "siconos_peer.py"}; }

void read_answer(const PeerScene& scene, const Json& found, PeerAnswer& answer) {
  answer.state = driver_state(scene, found);
  answer.version = found.at("version");
  answer.seconds.cpu = found.at("cpu_seconds");
  answer.dt = found.at("dt");
  answer.steps = found.at("steps");
}

}  // namespace

std::span<const Peer> peers() {
  static const std::array all{Peer{"Box2D", true, "libbox2d-dev", box2d},
                              Peer{"Yade", true, "yade", yade},
                              Peer{"Siconos", false, "python3-siconos python3-h5py", siconos}};
  return all;
}

PeerAnswer ask(const Peer& peer, std::string_view setting, const PeerScene& scene, int limit,
               const std::filesystem::path& folder) {
  const std::filesystem::path input = folder / "scene.json", output = folder / "answer.json";
  write_whole(input, driver_input(scene).dump());
  std::filesystem::remove(output);
  std::vector<std::string> words{"prlimit", format("--cpu=%d:%d", limit, limit + 1)};
  for (const std::string& word : peer.command()) words.push_back(word);
  words.insert(words.end(), {input, output, std::string(setting)});
  const Stopwatch watch;
  const ProgramEnd end = run_external(words, folder);
  PeerAnswer answer;
  answer.seconds.wall = watch.elapsed().wall;
  if (end.missing || end.code == kNotInstalled) {
    answer.end = PeerAnswer::End::not_installed;
  } else if (end.code == kOutOfTime) {
    answer.end = PeerAnswer::End::out_of_time;
  } else if (!std::filesystem::exists(output)) {
    answer.problem = end.fine() ? "it wrote no answer" : end.problem;
  } else {
    try {
      read_answer(scene, parse_json(read_text(output)), answer);
      answer.end = PeerAnswer::End::answered;
    } catch (const std::exception& error) {  // such as positions that are not finite
      answer.problem = std::string("its answer is malformed: ") + error.what();
    }
  }
  return answer;
}

}  // namespace quicksand::bench
