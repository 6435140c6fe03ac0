#include "app/jobs/run_record.h"

#include <array>

#include "app/run_folder/summary.h"
#include "app/scene_json/scenario_json.h"
#include "core/checkpoint/checkpoint.h"

namespace quicksand {

namespace {

namespace fs = std::filesystem;

// Empty if there is no such file, or one that no scene is. Throws InputError if it cannot be read.
std::string text_in(const fs::path& file) {
  try {
    return read_text(file);
  } catch (const InputError&) {
    refuse_unreadable(file);
    return {};
  }
}

// Whether a folder holds the scene of this job. Another build may have written it with other defaults left out or in, or
// with other words about its purpose, and the folder may have been moved with all its runs, so that only the end of
// start_from is the same.
bool is_scene_of(const Job& job, const std::string& text) {
  const std::string expected = to_text(job.scenario);
  if (text == expected) return true;
  try {
    Scenario found = scenario_from_json(parse_json(text));
    found.description = job.scenario.description;
    if (job.after) {
      // runs/NAME/NUMBER/state.cbor
      const auto end_of = [](const fs::path& path) {
        const fs::path number = path.parent_path(), name = number.parent_path();
        return name.filename() / number.filename() / path.filename();
      };
      if (end_of(found.start_from) != end_of(job.scenario.start_from)) return false;
      found.start_from = job.scenario.start_from;
    }
    return to_text(found) == expected;
  } catch (const InputError&) {
    return false;  // of a build with other keys
  }
}

// A state that is damaged, or that an earlier version of the format wrote, is none that other runs could start
// from: it is computed again. Throws InputError if it cannot be read.
bool is_usable(const fs::path& state) {
  try {
    read_checkpoint(state);
  } catch (const InputError&) {
    refuse_unreadable(state);
    return false;
  }
  return true;
}

}  // namespace

std::string_view status_name(JobStatus status) {
  constexpr auto kNames = std::to_array<std::string_view>(
      {"finished", "failed", "interrupted", "missing", "running elsewhere"});
  return kNames[static_cast<std::size_t>(status)];
}

RunRecord read_record(const Job& job) {
  RunRecord record;
  refuse_special_files(job.folder);
  const std::string scene = text_in(job.folder.scene());
  if (scene.empty()) return record;
  if (!is_scene_of(job, scene)) {
    record.other_scene = true;
    return record;
  }
  const bool has_state = is_there(job.folder.state());
  if (!has_state) refuse_unreadable(job.folder.state());
  if (has_state && !is_usable(job.folder.state())) return record;
  if (has_state) record.status = JobStatus::interrupted;
  record.summary = summary_in(job.folder);
  if (record.summary.is_null()) return record;
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
  if (scene.empty() || is_scene_of(job, scene)) return;
  throw InputError(job.folder.scene().string(),
                   "is not the scene of run " + job_name(job) +
                       ": the folder holds other runs, or runs with other settings; choose another "
                       "folder with --out, or remove this one");
}

}  // namespace quicksand
