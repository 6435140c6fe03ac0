#include "app/bench/problems/recorded_problem.h"

#include <libdeflate.h>

#include <array>
#include <cstring>
#include <memory>
#include <nlohmann/json.hpp>
#include <vector>

#include "app/json/json_text.h"
#include "core/base/errors.h"
#include "core/base/memory.h"
#include "core/base/whole_file.h"
#include "core/checkpoint/cbor.h"

namespace quicksand::bench {

namespace {

using Bytes = std::vector<std::uint8_t>;
using nlohmann::json;

constexpr double kBytesPerItem = 64;                      // that it takes to read
constexpr std::size_t kMostBytes = std::size_t{1} << 30;  // of one problem, unpacked

// The size goes first, little-endian, as the packed bytes do not tell it.
Bytes pack(const Bytes& bytes) {
  constexpr int kLevel = 6;
  const std::unique_ptr<libdeflate_compressor, decltype(&libdeflate_free_compressor)> compressor(
      libdeflate_alloc_compressor(kLevel), &libdeflate_free_compressor);
  if (!compressor) throw std::bad_alloc();
  Bytes out(8 + libdeflate_zlib_compress_bound(compressor.get(), bytes.size()));
  for (int k = 0; k < 8; ++k) out[k] = static_cast<std::uint8_t>(bytes.size() >> (8 * k));
  out.resize(8 + libdeflate_zlib_compress(compressor.get(), bytes.data(), bytes.size(),
                                          out.data() + 8, out.size() - 8));
  return out;
}

Bytes unpack(const std::string& packed) {
  std::size_t size = 0;
  if (packed.size() < 8) throw std::runtime_error("is cut short");
  for (std::size_t k = 0; k < 8; ++k)
    size |= static_cast<std::size_t>(static_cast<std::uint8_t>(packed[k])) << (8 * k);
  if (size > kMostBytes) throw std::runtime_error("is not a recorded problem");
  const std::unique_ptr<libdeflate_decompressor, decltype(&libdeflate_free_decompressor)>
      decompressor(libdeflate_alloc_decompressor(), &libdeflate_free_decompressor);
  if (!decompressor) throw std::bad_alloc();
  Bytes out(size);
  if (libdeflate_zlib_decompress(decompressor.get(), packed.data() + 8, packed.size() - 8,
                                 out.data(), out.size(), nullptr) != LIBDEFLATE_SUCCESS)
    throw std::runtime_error("is damaged");
  return out;
}

// A column of numbers: of(item, number) for each item and number.
template <class Items, class Of>
json column(const Items& items, std::size_t numbers, Of of) {
  std::vector<double> values;
  values.reserve(items.size() * numbers);
  for (const auto& item : items)
    for (std::size_t k = 0; k < numbers; ++k) values.push_back(of(item, k));
  Bytes bytes(values.size() * sizeof(double));
  if (!bytes.empty()) std::memcpy(bytes.data(), values.data(), bytes.size());
  return json::binary(std::move(bytes));
}

template <class Items, class To>
void read_column(const json& column, Items& items, std::size_t numbers, To to) {
  const auto& bytes = column.get_binary();
  if (bytes.size() != items.size() * numbers * sizeof(double))
    throw std::runtime_error("has columns of different lengths");
  std::vector<double> values(items.size() * numbers);
  if (!bytes.empty()) std::memcpy(values.data(), bytes.data(), bytes.size());
  std::size_t next = 0;
  for (auto& item : items)
    for (std::size_t k = 0; k < numbers; ++k) to(item, k) = values[next++];
}

json vectors(const std::vector<Vec3>& v) {
  return column(v, 3, [](const Vec3& x, std::size_t k) { return x[static_cast<int>(k)]; });
}
void read_vectors(const json& column, std::size_t count, std::vector<Vec3>& v) {
  v.resize(count);
  read_column(column, v, 3,
              [](Vec3& x, std::size_t k) -> double& { return x[static_cast<int>(k)]; });
}

// The numbers of a row, in the order of the file.
constexpr std::size_t kNumbers = 13;
template <class Row>
auto& number(Row& row, std::size_t k) {
  const std::array all{&row.normal[0],    &row.normal[1], &row.spin_a[0], &row.spin_a[1],
                       &row.spin_b[0],    &row.spin_b[1], &row.offset[0], &row.offset[1],
                       &row.offset[2],    &row.arm,       &row.friction,  &row.rolling,
                       &row.gap_tolerance};
  return *all[k];
}

json as_json(const RecordedProblem& recorded) {
  const ContactProblem& problem = recorded.step.problem;
  json pairs = json::array(), cohesive = json::array();
  for (const ContactRow& row : problem.contacts) {
    pairs.push_back(row.a);
    pairs.push_back(row.b);
    cohesive.push_back(row.cohesive);
  }
  return {{"quicksand_problem", 1},
          {"group", recorded.group},
          {"time", recorded.time},
          {"from", static_cast<int>(recorded.from)},
          {"tolerance", recorded.settings.tolerance},
          {"velocity_tolerance", recorded.settings.velocity_tolerance},
          {"max_iterations", recorded.settings.max_iterations},
          {"max_factorisations", recorded.settings.max_factorisations},
          {"patient", recorded.settings.patient},
          {"dt", problem.dt},
          {"force_scale", problem.force_scale},
          {"velocity_scale", problem.velocity_scale},
          {"components", problem.components},
          {"bodies", problem.inverse_mass.size()},
          {"inverse_mass", vectors(problem.inverse_mass)},
          {"free_velocity", vectors(problem.free_velocity)},
          {"pairs", std::move(pairs)},
          {"cohesive", std::move(cohesive)},
          {"rows", column(problem.contacts, kNumbers,
                          [](const ContactRow& row, std::size_t k) { return number(row, k); })},
          {"start", vectors(recorded.step.start)},
          {"velocity", vectors(recorded.reference.velocity)},
          {"residual", recorded.reference.residual.natural},
          {"doubt", recorded.reference.doubt}};
}

void read_json(const json& file, RecordedProblem& recorded) {
  if (file.at("quicksand_problem") != 1) throw std::runtime_error("has another format");
  recorded.group = file.at("group");
  recorded.time = file.at("time");
  const int from = file.at("from");
  if (from < 0 || from > static_cast<int>(SolverStage::sweeps))
    throw std::runtime_error("names no stage of the solver");
  recorded.from = static_cast<SolverStage>(from);
  recorded.settings.tolerance = file.at("tolerance");
  recorded.settings.velocity_tolerance = file.at("velocity_tolerance");
  recorded.settings.max_iterations = file.at("max_iterations");
  recorded.settings.max_factorisations = file.at("max_factorisations");
  recorded.settings.patient = file.at("patient");
  ContactProblem& problem = recorded.step.problem;
  problem.dt = file.at("dt");
  problem.force_scale = file.at("force_scale");
  problem.velocity_scale = file.at("velocity_scale");
  problem.components = file.at("components");
  if (problem.components < 1 || problem.components > 3 || !(problem.dt > 0))
    throw std::runtime_error("holds no contact problem");
  const std::vector<int> pairs = file.at("pairs");
  const std::vector<bool> cohesive = file.at("cohesive");
  const std::size_t bodies = file.at("bodies");
  if (bodies > kMostBytes / sizeof(Vec3) || pairs.size() != 2 * cohesive.size())
    throw std::runtime_error("has columns of different lengths");
  read_vectors(file.at("inverse_mass"), bodies, problem.inverse_mass);
  read_vectors(file.at("free_velocity"), bodies, problem.free_velocity);
  problem.contacts.resize(cohesive.size());
  read_column(file.at("rows"), problem.contacts, kNumbers,
              [](ContactRow& row, std::size_t k) -> double& { return number(row, k); });
  for (std::size_t c = 0; c < problem.contacts.size(); ++c) {
    ContactRow& row = problem.contacts[c];
    row.a = pairs[2 * c];
    row.b = pairs[2 * c + 1];
    row.cohesive = cohesive[c];
    for (const int body : {row.a, row.b})
      if (body < 0 || static_cast<std::size_t>(body) >= bodies)
        throw std::runtime_error("names bodies that do not exist");
  }
  read_vectors(file.at("start"), problem.contacts.size(), recorded.step.start);
  read_vectors(file.at("velocity"), bodies, recorded.reference.velocity);
  recorded.reference.residual.natural = file.at("residual");
  recorded.reference.doubt = file.at("doubt");
}

}  // namespace

void write_problem(const RecordedProblem& problem, const std::filesystem::path& file) {
  const Bytes bytes = pack(json::to_cbor(as_json(problem)));
  write_whole(file, std::string_view(reinterpret_cast<const char*>(bytes.data()), bytes.size()));
}

RecordedProblem read_problem(const std::filesystem::path& file) {
  const std::string packed = read_text(file);
  RecordedProblem recorded;
  try {
    const Bytes bytes = unpack(packed);
    const auto items = static_cast<double>(count_cbor_items(bytes));
    if (const std::string problem = memory_problem(kBytesPerItem * items); !problem.empty())
      throw NotEnoughMemory(file.string() + ": reading it " + problem);
    read_json(json::from_cbor(bytes), recorded);
  } catch (const json::exception& error) {
    throw InputError(file.string(),
                     "is not a recorded problem (" + std::string(error.what()) + ")");
  } catch (const NotEnoughMemory&) {
    throw;  // which says nothing of the file
  } catch (const std::runtime_error& error) {
    throw InputError(file.string(), error.what());
  }
  return recorded;
}

}  // namespace quicksand::bench
