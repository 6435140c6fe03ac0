#include "app/run/run_position.h"

#include <exception>
#include <new>

#include "app/json/json_text.h"
#include "core/checkpoint/archive.h"
#include "core/checkpoint/cbor.h"

namespace quicksand {

namespace {

constexpr std::size_t kMostItems = 1000;  // many more than a position has

using Writer = CheckpointArchive<Json>;
using Reader = CheckpointArchive<const Json>;

template <class Archive, class AnyRow>
void describe_row(Archive archive, AnyRow& row) {
  archive.value("phase", row.phase);
  archive.value("residual", row.residual);
  archive.value("gap_error", row.gap_error);
  archive.value("velocity_change", row.velocity_change);
  archive.value("iterations", row.iterations);
  archive.value("factorisations", row.factorisations);
  archive.value("unconverged", row.unconverged);
  archive.value("trial", row.trial);
  archive.value("trial_force", row.trial_force);
  archive.added("external_work", row.external_work);
  archive.added("energy_dissipated", row.energy_dissipated);
  archive.added("energy_gained", row.energy_gained);
  archive.added("shear_impulse", row.shear_impulse);
  archive.added("shear_time", row.shear_time);
}

template <class Archive, class Position>
void describe(Archive archive, Position& position) {
  archive.value("rows", position.rows);
  archive.added("checksum", position.checksum);
  archive.value("first_step", position.first_step);
  archive.value("step", position.samples.step);
  archive.value("bodies", position.samples.bodies);
  archive.value("healed", position.samples.healed);
  archive.value("phase", position.samples.phase);
}

}  // namespace

std::vector<std::uint8_t> to_bytes(const RunPosition& position) {
  Json json, last, pending;
  describe(Writer(json), position);
  describe_row(Writer(last), position.samples.last);
  describe_row(Writer(pending), position.samples.pending);
  json["last"] = std::move(last);
  json["pending"] = std::move(pending);
  return Json::to_cbor(json);  // keeps every bit of a number, and those that are not finite
}

std::optional<RunPosition> position_from(const std::vector<std::uint8_t>& bytes) {
  RunPosition position;
  try {
    if (count_cbor_items(bytes) > kMostItems) return std::nullopt;
    const Json json = Json::from_cbor(bytes);
    describe(Reader(json), position);
    describe_row(Reader(json.at("last")), position.samples.last);
    describe_row(Reader(json.at("pending")), position.samples.pending);
  } catch (const std::bad_alloc&) {
    throw;  // which says nothing of the bytes
  } catch (const std::exception&) {
    return std::nullopt;
  }
  return position.rows >= 0 ? std::optional(position) : std::nullopt;
}

}  // namespace quicksand
