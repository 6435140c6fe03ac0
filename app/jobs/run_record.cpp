#include "app/jobs/run_record.h"

#include <array>

#include "app/scene_json/scenario_json.h"
#include "core/checkpoint/checkpoint.h"

namespace quicksand {

namespace {

namespace fs = std::filesystem;

// Empty if the file cannot be read.
std::string text_in(const fs::path& file) {
  try {
    return read_text(file);
  } catch (const InputError&) {
    return {};
  }
}

// Null if there is none or it is not whole: then there are no results that count.
Json json_in(const fs::path& file) {
  try {
    return parse_json(text_in(file));
  } catch (const InputError&) {
    return nullptr;
  }
}

// A state that is damaged, or that an earlier version of the format wrote, is none that other runs could start
// from: it is computed again.
bool is_usable(const fs::path& state) {
  try {
    read_checkpoint(state);
  } catch (const InputError&) {
    return false;
  }
  return true;
}

}  // namespace

std::string_view status_name(JobStatus status) {
  constexpr auto kNames =
      std::to_array<std::string_view>({"finished", "failed", "interrupted", "missing"});
  return kNames[static_cast<std::size_t>(status)];
}

RunRecord read_record(const Job& job) {
  RunRecord record;
  const std::string scene = text_in(job.folder.scene());
  if (scene.empty()) return record;
  if (scene != to_text(job.scenario)) {
    record.other_scene = true;
    return record;
  }
  std::error_code error;
  const bool has_state = fs::exists(job.folder.state(), error);
  if (has_state && !is_usable(job.folder.state())) return record;
  if (has_state) record.status = JobStatus::interrupted;
  record.summary = json_in(job.folder.summary());
  if (!record.summary.is_object()) {
    record.summary = nullptr;
    return record;
  }
  if (record.summary.value("finished", Json()) == true) {
    record.status = JobStatus::finished;
  } else if (record.summary.contains("failure") && record.summary["failure"].is_string()) {
    record.status = JobStatus::failed;
    record.failure = record.summary["failure"].get<std::string>();
  }
  return record;
}

void require_own_scene(const Job& job) {
  const std::string scene = text_in(job.folder.scene());
  if (scene.empty() || scene == to_text(job.scenario)) return;
  throw InputError(job.folder.scene().string(),
                   "is not the scene of run " + job_name(job) +
                       ": the folder holds the runs of something else, or of other settings; "
                       "choose another folder with --out, or remove it");
}

}  // namespace quicksand
