#include "core/checkpoint/checkpoint.h"

#include <bit>
#include <cstdio>
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
constexpr int kVersion = 6, kOldestVersion = 4;
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

// Lists of structs are stored as one array a field, without padding.
struct Columns {
  std::vector<int> a, b;
  std::vector<std::uint8_t> state, initial, role;
  std::vector<Vec2> normal, point, velocity;
  std::vector<Vec3> impulse;
  std::vector<double> gap, cohesion, mass, force;
};

template <class Archive>
void describe_bonds(Archive& archive, Columns& c) {
  archive.array("a", c.a);
  archive.array("b", c.b);
  archive.array("state", c.state);
  archive.array("initial", c.initial);
}

template <class Archive>
void describe_contacts(Archive& archive, Columns& c) {
  archive.array("a", c.a);
  archive.array("b", c.b);
  archive.array("normal", c.normal);
  archive.array("gap", c.gap);
  archive.array("impulse", c.impulse);
  archive.array("cohesion", c.cohesion);
}

template <class Archive>
void describe_walls(Archive& archive, Columns& c) {
  archive.array("point", c.point);
  archive.array("normal", c.normal);
  archive.array("velocity", c.velocity);
  archive.array("mass", c.mass);
  archive.array("force", c.force);
  archive.array("role", c.role);
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

void write_world(Writer& w, const World& world) {
  describe_world(w, world);
  const std::vector<double> gravity =
      world.gravity ? std::vector<double>{world.gravity->x(), world.gravity->y()}
                    : std::vector<double>{};
  w.array("gravity", gravity);
  const std::vector<double> drag =
      world.drag ? std::vector<double>{world.drag->linear, world.drag->quadratic}
                 : std::vector<double>{};
  w.array("drag", drag);
  if (world.sweep_random) w.value("sweep_random", world.sweep_random->state);
  Columns bonds, contacts, walls;
  for (const Bond& bond : world.bonds.list) {
    bonds.a.push_back(bond.pair.a), bonds.b.push_back(bond.pair.b);
    bonds.state.push_back(static_cast<std::uint8_t>(bond.state));
    bonds.initial.push_back(bond.initial ? 1 : 0);
  }
  for (const Contact& contact : world.contacts) {
    contacts.a.push_back(contact.pair.a), contacts.b.push_back(contact.pair.b);
    contacts.normal.push_back(contact.normal), contacts.gap.push_back(contact.gap);
    contacts.impulse.push_back(contact.impulse), contacts.cohesion.push_back(contact.cohesion);
  }
  for (const Wall& wall : world.walls) {
    walls.point.push_back(wall.point), walls.normal.push_back(wall.normal);
    walls.velocity.push_back(wall.velocity), walls.mass.push_back(wall.mass);
    walls.force.push_back(wall.force), walls.role.push_back(static_cast<std::uint8_t>(wall.role));
  }
  w.object("bonds", [&](Writer& a) { describe_bonds(a, bonds); });
  w.object("contacts", [&](Writer& a) { describe_contacts(a, contacts); });
  w.object("walls", [&](Writer& a) { describe_walls(a, walls); });
}

Json to_json(const Checkpoint& checkpoint) {
  Json json = {{"format", kFormat}, {"version", kVersion}, {"scene", checkpoint.scene}};
  Writer writer(json);
  writer.object("world", [&](Writer& w) { write_world(w, checkpoint.world); });
  writer.object("protocol", [&](Writer& w) { describe_protocol(w, checkpoint.protocol); });
  writer.object("search", [&](Writer& w) { write_search(w, checkpoint.protocol); });
  writer.array("samples", checkpoint.samples);
  if (const auto& base = checkpoint.protocol.search.base)
    writer.object("base", [&](Writer& w) { write_world(w, *base); });
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
  std::vector<double> gravity;
  reader.array("gravity", gravity);
  require(gravity.empty() || gravity.size() == 2, "gravity is no vector");
  if (gravity.size() == 2) world.gravity = Vec2(gravity[0], gravity[1]);
  std::vector<double> drag;
  reader.array("drag", drag);
  require(drag.empty() || drag.size() == 2, "drag is not two numbers");
  if (drag.size() == 2) world.drag = Drag{.linear = drag[0], .quadratic = drag[1]};

  if (json.contains("sweep_random")) {
    std::uint64_t state = 0;
    reader.value("sweep_random", state);
    world.sweep_random = Random{state};
  }

  Columns bonds, contacts, walls;
  reader.object("bonds", [&](Reader& a) { describe_bonds(a, bonds); });
  reader.object("contacts", [&](Reader& a) { describe_contacts(a, contacts); });
  reader.object("walls", [&](Reader& a) { describe_walls(a, walls); });

  const Disks& d = world.disks;
  const std::size_t nd = d.position.size();
  require(same_size(nd, d.angle, d.velocity, d.applied, d.radius, d.mass, d.inverse_mass, d.role),
          "the arrays of the disks differ in length");
  const std::size_t nw = walls.point.size();
  require(same_size(nw, walls.normal, walls.velocity, walls.mass, walls.force, walls.role),
          "the arrays of the walls differ in length");
  for (std::size_t k = 0; k < nw; ++k)
    world.walls.push_back({walls.point[k], walls.normal[k], walls.velocity[k], walls.mass[k],
                           walls.force[k], static_cast<WallRole>(walls.role[k])});

  require(same_size(bonds.a.size(), bonds.b, bonds.state, bonds.initial),
          "the arrays of the bonds differ in length");
  for (std::size_t k = 0; k < bonds.a.size(); ++k)
    world.bonds.list.push_back(
        {{bonds.a[k], bonds.b[k]}, static_cast<BondState>(bonds.state[k]), bonds.initial[k] != 0});
  require(same_size(contacts.a.size(), contacts.b, contacts.normal, contacts.gap, contacts.impulse,
                    contacts.cohesion),
          "the arrays of the contacts differ in length");
  for (std::size_t k = 0; k < contacts.a.size(); ++k)
    world.contacts.push_back({{contacts.a[k], contacts.b[k]},
                              contacts.normal[k],
                              contacts.gap[k],
                              contacts.impulse[k],
                              contacts.cohesion[k]});
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
  const std::uint64_t hash = checksum(bytes);
  bytes.push_back(kEightBytes);
  for (unsigned k = 0; k < 8; ++k) bytes.push_back(static_cast<std::uint8_t>(hash >> (8 * k)));
}

// The bytes without their seal.
std::span<const std::uint8_t> sealed_content(std::span<const std::uint8_t> bytes) {
  require(bytes.size() > kSealSize, "it is too short");
  const auto content = bytes.first(bytes.size() - kSealSize), seal = bytes.last(kSealSize);
  std::uint64_t hash = 0;
  for (unsigned k = 0; k < 8; ++k) hash |= std::uint64_t{seal[k + 1]} << (8 * k);
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
    require(json.is_object() && json.value("format", "") == kFormat, "this is no checkpoint");
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
    read_search(searches, checkpoint.protocol);
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
                     std::string("is not a whole checkpoint of quicksand: ") + problem.what());
  }
}

}  // namespace quicksand
