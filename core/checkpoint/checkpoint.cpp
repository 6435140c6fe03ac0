#include "core/checkpoint/checkpoint.h"

#include <array>
#include <bit>
#include <cstring>
#include <fstream>
#include <nlohmann/json.hpp>
#include <numeric>
#include <span>
#include <system_error>

#include "core/base/fnv.h"
#include "core/base/memory.h"
#include "core/base/whole_file.h"
#include "core/checkpoint/archive.h"
#include "core/checkpoint/cbor.h"
#include "core/checkpoint/check.h"
#include "core/checkpoint/search_archive.h"

namespace quicksand {

namespace {

using Json = nlohmann::json;
using Writer = CheckpointWriter;
using Reader = CheckpointReader;
static_assert(std::endian::native == std::endian::little, "arrays are stored little-endian");

constexpr const char* kFormat = "quicksand checkpoint";
constexpr int kVersion = 8, kOldestVersion = 4;
constexpr std::uintmax_t kLargestFile = std::uintmax_t{4} << 30U;  // [bytes]
// Memory that reading takes: the bytes are there as they are, as JSON and as a world.
constexpr double kBytesPerByte = 4;
constexpr double kBytesPerItem = 64;

template <class Archive, class Law>
void describe_law(Archive& archive, Law& law) {
  archive.optional("friction", law.friction);
  archive.optional("rolling_friction", law.rolling_friction);
  archive.optional("cohesion_force", law.cohesion_force);
  archive.value("cohesion_range", law.cohesion_range);
}

template <class Archive, class Disks>
void describe_disks(Archive& archive, Disks& disks) {
  archive.array("position", disks.position);
  archive.array("angle", disks.angle);
  archive.array("velocity", disks.velocity);
  archive.array("applied", disks.applied);
  archive.array("radius", disks.radius);
  archive.array("mass", disks.mass);
  archive.array("inverse_mass", disks.inverse_mass);
  archive.array("role", disks.role);
}

template <class Archive, class World>
void describe_lists(Archive& archive, World& world) {
  const auto first = [](auto& item) -> auto& { return item.pair.a; };
  const auto second = [](auto& item) -> auto& { return item.pair.b; };
  archive.columns("bonds", world.bonds.list, [&](auto column) {
    column("a", first);
    column("b", second);
    column("state", &Bond::state);
    column("initial", &Bond::initial);
  });
  archive.columns("contacts", world.contacts, [&](auto column) {
    column("a", first);
    column("b", second);
    column("normal", &Contact::normal);
    column("gap", &Contact::gap);
    column("impulse", &Contact::impulse);
    column("cohesion", &Contact::cohesion);
  });
  // Worlds without shaped bodies are written as if there were none to write.
  if (archive.has("corners", !world.shapes.empty())) {
    archive.columns("corners", world.shapes.corners, [](auto column) {
      column("place", &Corner::place);
      column("radius", &Corner::radius);
      column("body", &Corner::body);
      column("count", &Corner::count);
      column("shaft", &Corner::shaft);
    });
    archive.columns("shaped_bodies", world.shapes.bodies, [](auto column) {
      column("body", &ShapedBody::body);
      column("inertia", &ShapedBody::inertia);
      column("arm", &ShapedBody::arm);
      column("radius", &ShapedBody::radius);
    });
  }
  archive.columns("walls", world.walls, [](auto column) {
    column("point", &Wall::point);
    column("normal", &Wall::normal);
    column("velocity", &Wall::velocity);
    column("mass", &Wall::mass);
    column("force", &Wall::force);
    column("role", &Wall::role);
  });
}

template <class Archive, class World>
void describe_world(Archive& archive, World& world) {
  archive.value("width", world.box.width);
  archive.value("height", world.box.height);
  archive.word("sides", world.box.sides);
  archive.value("floor", world.box.floor);
  archive.object("grain_law", [&](auto& a) { describe_law(a, world.grain_law); });
  archive.object("wall_law", [&](auto& a) { describe_law(a, world.wall_law); });
  archive.object("intruder_law", [&](auto& a) { describe_law(a, world.intruder_law); });
  archive.object("disks", [&](auto& a) { describe_disks(a, world.disks); });
  archive.value("bonds_formed", world.bonds.formed);
  archive.value("bonds_broken", world.bonds.broken);
  archive.value("bonds_healed", world.bonds.healed);
  archive.value("bonds_initial", world.bonds.initial);
  archive.value("bonding", world.bonding);
  archive.value("impulse_dt", world.impulse_dt);
  archive.value("time", world.time);
  archive.value("step", world.step);
  archive.value("random", world.random.state);
  archive.added("rebonding", world.rebonding);
  archive.array("way", world.trajectory.places);
  archive.value("way_surface", world.trajectory.surface);
  archive.added("specimen", world.specimen);
  archive.optional_array("gravity", world.gravity);
  archive.optional_array("drag", world.drag);
  archive.optional_random("sweep_random", world.sweep_random);
  describe_lists(archive, world);
}

template <class Archive, class State>
void describe_protocol(Archive& archive, State& state) {
  archive.value("phase", state.phase);
  archive.value("entered", state.entered);
  archive.value("phase_start", state.phase_start);
  archive.added("memory", state.memory);
  archive.value("rest_since", state.rest_since);
  archive.value("unconverged_steps", state.unconverged_steps);
  archive.value("halved_steps", state.halved_steps);
  archive.value("broken_in_unconverged", state.broken_in_unconverged);
  archive.value("breaks_withheld", state.breaks_withheld);
  archive.value("iterations", state.iterations);
  archive.value("factorisations", state.factorisations);
  archive.value("worst_residual", state.worst_residual);
  archive.value("worst_overlap", state.worst_overlap);
  archive.added("worst_bond_gap", state.worst_bond_gap);
  archive.value("external_work", state.external_work);
  archive.value("energy_dissipated", state.energy_dissipated);
  archive.value("energy_gained", state.energy_gained);
  archive.value("trial_start", state.trial_start);
  const auto describe_errors = [&](const char* name, auto& histogram) {
    archive.added((std::string(name) + "_counts").c_str(), histogram.counts);
    archive.added((std::string(name) + "_largest").c_str(), histogram.largest);
  };
  describe_errors("sweep_residual", state.sweep_errors.residual);
  describe_errors("sweep_bond_gap", state.sweep_errors.bond_gap);
  describe_errors("sweep_penetration", state.sweep_errors.penetration);
}

// Before phases had a memory of their own, that of a deposit was part of the protocol's.
constexpr int kFirstWithMemory = 6;
void read_deposit(const Json& protocol, ProtocolState& state) {
  state.memory = {{"next_drop", protocol.at("next_drop").get<double>()},
                  {"dropped", protocol.at("dropped").get<double>()},
                  {"full", protocol.at("full").get<bool>() ? 1.0 : 0.0}};
}

Json to_json(const Checkpoint& checkpoint) {
  Json json = {{"format", kFormat}, {"version", kVersion}, {"scene", checkpoint.scene}};
  Writer writer(json);
  writer.object("world", [&](Writer& w) { describe_world(w, checkpoint.world); });
  writer.object("protocol", [&](Writer& w) { describe_protocol(w, checkpoint.protocol); });
  writer.object("search", [&](Writer& w) { describe_search(w, checkpoint.protocol); });
  writer.array("samples", checkpoint.samples);
  if (const auto& base = checkpoint.protocol.search.base)
    writer.object("base", [&](Writer& w) { describe_world(w, *base); });
  return json;
}

void require(bool condition, const char* problem) {
  if (!condition) throw std::runtime_error(problem);
}

template <class... Vectors>
bool same_size(std::size_t size, const Vectors&... vectors) {
  return ((vectors.size() == size) && ...);
}

World world_from(const Json& json) {
  World world;
  Reader reader(json);
  describe_world(reader, world);
  const Disks& d = world.disks;
  require(same_size(d.position.size(), d.angle, d.velocity, d.applied, d.radius, d.mass,
                    d.inverse_mass, d.role),
          "the arrays of the disks differ in length");
  return world;
}

// The file is a CBOR sequence [RFC 8742] of the checkpoint and a byte string of eight bytes: the
// FNV-1a hash of all bytes before it. It is checked first, so that damaged bytes are never parsed.
constexpr std::uint8_t kEightBytes = 0x48;
constexpr std::size_t kSealSize = 9;

std::uint64_t checksum(std::span<const std::uint8_t> bytes) {
  return std::accumulate(bytes.begin(), bytes.end(), kFnvStart, fnv1a);
}

void add_seal(std::vector<std::uint8_t>& bytes) {
  const auto hash = std::bit_cast<std::array<std::uint8_t, 8>>(checksum(bytes));
  bytes.push_back(kEightBytes);
  bytes.insert(bytes.end(), hash.begin(), hash.end());
}

// The bytes without their seal.
std::span<const std::uint8_t> sealed_content(std::span<const std::uint8_t> bytes) {
  require(bytes.size() > kSealSize, "it is too short");
  const auto content = bytes.first(bytes.size() - kSealSize), seal = bytes.last(kSealSize);
  std::uint64_t hash = 0;
  std::memcpy(&hash, seal.data() + 1, sizeof hash);
  require(seal[0] == kEightBytes && hash == checksum(content),
          "its checksum is wrong: it is cut short, damaged, or another kind of file");
  return content;
}

void require_memory(double bytes, const std::filesystem::path& path) {
  const std::string problem = memory_problem(bytes);
  if (!problem.empty()) throw NotEnoughMemory(path.string() + ": reading it " + problem);
}

std::vector<std::uint8_t> read_bytes_of(const std::filesystem::path& path) {
  std::error_code error;
  const std::uintmax_t size = std::filesystem::file_size(path, error);
  if (error) throw InputError(path.string(), "cannot be read: " + error.message());
  if (size > kLargestFile) throw InputError(path.string(), "is larger than 4 GiB");
  require_memory(kBytesPerByte * static_cast<double>(size), path);
  std::ifstream file(path, std::ios::binary);
  std::vector<std::uint8_t> bytes(size);
  file.read(reinterpret_cast<char*>(bytes.data()), static_cast<std::streamsize>(size));
  if (!file) throw InputError(path.string(), "cannot be read");
  return bytes;
}

}  // namespace

void write_checkpoint(const std::filesystem::path& path, const Checkpoint& checkpoint) {
  std::vector<std::uint8_t> bytes = Json::to_cbor(to_json(checkpoint));
  add_seal(bytes);
  WholeFile file(path);
  file.stream().write(reinterpret_cast<const char*>(bytes.data()),
                      static_cast<std::streamsize>(bytes.size()));
  file.finish();
}

Checkpoint read_checkpoint(const std::filesystem::path& path) {
  const std::vector<std::uint8_t> bytes = read_bytes_of(path);
  try {
    const auto content = sealed_content(bytes);
    require_memory(kBytesPerItem * static_cast<double>(count_cbor_items(content)), path);
    const Json json = Json::from_cbor(content);
    require(json.is_object() && json.value("format", "") == kFormat, "this is not a checkpoint");
    const int version = json.at("version").get<int>();
    if (version < kOldestVersion || version > kVersion)
      throw OtherVersion(path.string(), "its format version is " + std::to_string(version) +
                                            ", this program reads versions " +
                                            std::to_string(kOldestVersion) + " to " +
                                            std::to_string(kVersion));
    Checkpoint checkpoint;
    checkpoint.scene = json.at("scene").get<std::string>();
    checkpoint.world = world_from(json.at("world"));
    Reader reader(json.at("protocol"));
    describe_protocol(reader, checkpoint.protocol);
    if (version < kFirstWithMemory) read_deposit(json.at("protocol"), checkpoint.protocol);
    Reader searches(json.at("search"));
    describe_search(searches, checkpoint.protocol);
    Reader(json).array("samples", checkpoint.samples);
    if (json.contains("base"))
      checkpoint.protocol.search.base = std::make_shared<const World>(world_from(json.at("base")));
    if (const char* problem = inconsistency(checkpoint)) throw std::runtime_error(problem);
    return checkpoint;
  } catch (const OtherVersion&) {
    throw;
  } catch (const NotEnoughMemory&) {
    throw;  // it is whole all the same, and must not be taken for damaged
  } catch (const std::bad_alloc&) {
    throw NotEnoughMemory(path.string() + ": there is not enough memory to read it");
  } catch (const std::exception& problem) {
    throw InputError(path.string(),
                     std::string("is not a complete checkpoint of quicksand: ") + problem.what());
  }
}

}  // namespace quicksand
