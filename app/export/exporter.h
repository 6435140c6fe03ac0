// Exports worlds into the files of a format, one after the other.
#pragma once

#include <filesystem>
#include <memory>
#include <string>
#include <vector>

#include "app/export/formats.h"
#include "core/base/whole_file.h"

namespace quicksand {

// `out` is the file of a format that has one, otherwise a folder, which receives a file a table
// (disks.csv, contacts.csv, walls.csv) and states.csv. The files of several states are numbered
// (disks_0000.csv), and VTK has a collection of them over time (disks.pvd). Such files of an earlier export in this format
// are removed.
class Exporter {
 public:
  // For `states` worlds. Throws InputError if `out` cannot be written.
  Exporter(const ExportFormat& format, std::filesystem::path out, std::size_t states);

  // Throws InputError if a file cannot be written.
  void add(const World& world);
  // After the last world. Throws InputError. What was written to a single file is dropped without it.
  void finish();

 private:
  void remove_earlier_tables() const;
  std::string file_name(const DataTable& table) const;

  const ExportFormat& format_;
  std::filesystem::path out_;
  std::size_t states_;
  std::unique_ptr<WholeFile> single_;
  std::size_t added_ = 0;
  std::string rows_;                           // states.csv
  std::vector<std::vector<TimedFile>> files_;  // (tables) written so far
};

// One world alone. Throws InputError.
void export_state(const World& world, const ExportFormat& format, const std::filesystem::path& out);

}  // namespace quicksand
