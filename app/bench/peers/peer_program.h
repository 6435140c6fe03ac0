// The other programs: which there are, where their drivers are, and how one is run.
//
// A driver is called with the file to read, the file to write, and the name of its setting. It ends with
// 127, as a shell where there is no such program, if its library is not there.
// Drivers are looked for in tests/bench/peers beside the folder of assets, which an installed program
// does not have, and the compiled one beside the program.
#pragma once

#include <array>
#include <filesystem>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "app/bench/peers/peer_scene.h"
#include "app/bench/stopwatch.h"

namespace quicksand::bench {

struct Peer {
  std::string_view name;
  bool cohesion;  // whether it has a law of bonds that break
  std::string_view packages;
  // The command, to which the two files and the setting are added.
  std::vector<std::string> (*command)();
};
std::span<const Peer> peers();

// Every driver knows these: as the program comes, and as well as we could set it up.
inline constexpr std::array<std::string_view, 2> kPeerSettings{"defaults", "tuned"};

struct PeerAnswer {
  enum class End : std::uint8_t { answered, not_installed, out_of_time, failed };
  End end = End::failed;
  std::string problem{};  // of `failed`
  std::string version{};
  Seconds seconds{};  // in its time steps, as it has measured them itself, and in all
  double dt = 0;
  std::int64_t steps = 0;
  PeerState state{};
};

// Runs the driver in `folder`, for at most `limit` seconds of the CPU.
PeerAnswer ask(const Peer& peer, std::string_view setting, const PeerScene& scene, int limit,
               const std::filesystem::path& folder);

}  // namespace quicksand::bench
