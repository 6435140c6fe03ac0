#include "app/export/formats.h"

#include "app/base/nearest_name.h"
#include "core/base/errors.h"

namespace quicksand {

namespace {

constexpr ExportFormat kFormats[] = {
    {"vtk", ".vtp", "VTK XML PolyData for ParaView and VTK", false, write_vtk, vtk_collection},
    {"xyz", ".xyz", "extended XYZ for OVITO and ASE: the disks of all states in one file", true,
     write_xyz},
    {"csv", ".csv", "comma-separated text", false, write_csv},
    {"npy", ".npy", "structured arrays for NumPy", false, write_npy},
};

}  // namespace

std::span<const ExportFormat> export_formats() { return kFormats; }

const ExportFormat& export_format(const std::string& word) {
  return named(kFormats, word, &ExportFormat::word, "--format " + word, "is not a format");
}

}  // namespace quicksand
