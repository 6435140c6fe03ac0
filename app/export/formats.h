// The formats of an export. Each writes a table of a world to a stream, exactly: all digits or all bits.
#pragma once

#include <ostream>
#include <span>
#include <string>
#include <string_view>

#include "app/export/tables.h"

namespace quicksand {

// Comma-separated text, a line of names first [RFC 4180].
void write_csv(std::ostream& out, const ExportedWorld& world, const DataTable& table);

// A NumPy array of structs, file format 1.0, little-endian; vectors are fields of two numbers.
void write_npy(std::ostream& out, const ExportedWorld& world, const DataTable& table);

// VTK XML PolyData: points or lines with all columns, as base64 in the XML; vectors have z = 0.
void write_vtk(std::ostream& out, const ExportedWorld& world, const DataTable& table);

// A frame of an extended XYZ file, with the lattice and the time; vectors have z = 0.
void write_xyz(std::ostream& out, const ExportedWorld& world, const DataTable& table);

// A file and the time that it shows [sqrt(d/g)].
struct TimedFile {
  std::string file;  // relative to the collection
  double time = 0;
};
// A ParaView collection of VTK files over time.
std::string vtk_collection(std::span<const TimedFile> files);

struct ExportFormat {
  std::string_view word;
  std::string_view extension;  // of its files
  std::string_view help;
  bool one_file;  // all states follow each other in it, disks only
  void (*write)(std::ostream& out, const ExportedWorld& world, const DataTable& table);
  std::string (*collection)(std::span<const TimedFile> files) = nullptr;  // text of NAME.pvd
};
std::span<const ExportFormat> export_formats();

// Throws InputError with the nearest word.
const ExportFormat& export_format(const std::string& word);

}  // namespace quicksand
