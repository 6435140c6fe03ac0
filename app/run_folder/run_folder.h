// The folder that receives what a run computes, and the names of the files in it.
#pragma once

#include <filesystem>
#include <system_error>

namespace quicksand {

struct RunFolder {
  std::filesystem::path path;

  std::filesystem::path options() const { return path / "run.json"; }
  std::filesystem::path scene() const { return path / "scene.json"; }
  std::filesystem::path frames() const { return path / "frames"; }
  std::filesystem::path film() const { return path / "film.mp4"; }
  std::filesystem::path animation() const { return path / "film.png"; }
  std::filesystem::path film_page() const { return path / "film.html"; }
  std::filesystem::path series() const { return path / "series.csv"; }
  std::filesystem::path history() const { return path / "history.qsh"; }
  std::filesystem::path critical_forces() const { return path / "critical_forces.csv"; }
  std::filesystem::path adiabatic() const { return path / "adiabatic.csv"; }
  std::filesystem::path summary() const { return path / "summary.json"; }
  std::filesystem::path computing_time() const { return path / "computing_time.json"; }
  std::filesystem::path state() const { return path / "state.cbor"; }
  std::filesystem::path report_page() const { return path / "report.html"; }
  std::filesystem::path report_text() const { return path / "report.md"; }
};

// False, too, where one may not look.
inline bool is_there(const std::filesystem::path& path) {
  std::error_code ignored;
  return std::filesystem::exists(path, ignored);
}
inline bool is_folder(const std::filesystem::path& path) {
  std::error_code ignored;
  return std::filesystem::is_directory(path, ignored);
}

// Throws InputError if a file cannot be opened or read, for another reason than that there is none: what is in it may be
// good, and must not be taken for damaged.
void refuse_unreadable(const std::filesystem::path& file);

// Throws InputError if the folder or its frames hold a pipe, a device or a socket: whoever reads one may wait for ever.
void refuse_special_files(const RunFolder& folder);

// Whether a run has begun here, which can be resumed.
bool holds_run(const RunFolder& folder);

// Makes the folder and tries to write in it, so that nothing is computed in vain. Throws InputError.
void make_writable(const RunFolder& folder);

// Removes what says that a run has ended, which now goes on.
void forget_end(const RunFolder& folder);

// Removes the files of an earlier run that this run may not write again: its films, summary, state,
// history, tables of searches, report and frames. Other files are left alone.
void remove_earlier_results(const RunFolder& folder);

// Whether the path leads to a place in the folder, or to the folder itself, once every link on the way has been followed.
// What it names need not be there yet, but no link may be in its place: writing would follow it.
bool leads_into(const std::filesystem::path& folder, const std::filesystem::path& path);

// The same of all links below the path, for what is written into a folder under names of its own.
bool all_lead_into(const std::filesystem::path& folder, const std::filesystem::path& path);

}  // namespace quicksand
