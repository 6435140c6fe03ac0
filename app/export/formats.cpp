#include "app/export/formats.h"

#include <algorithm>

#include "app/base/nearest_name.h"
#include "core/base/errors.h"

namespace quicksand {

namespace {

constexpr ExportFormat kFormats[] = {
    {"vtk", ".vtp", "VTK XML PolyData for ParaView and VTK", false, write_vtk, vtk_collection},
    {"xyz", ".xyz", "extended XYZ for OVITO and ASE: the disks, all states in one file", true,
     write_xyz},
    {"csv", ".csv", "comma-separated text", false, write_csv},
    {"npy", ".npy", "arrays of structs for NumPy", false, write_npy},
};

}  // namespace

std::span<const ExportFormat> export_formats() { return kFormats; }

const ExportFormat& export_format(const std::string& word) {
  const auto* const known = std::ranges::find(kFormats, word, &ExportFormat::word);
  if (known != std::end(kFormats)) return *known;
  std::vector<std::string> words;
  for (const ExportFormat& format : kFormats) words.emplace_back(format.word);
  throw InputError("--format " + word, "is no format" + suggestion(word, words));
}

}  // namespace quicksand
