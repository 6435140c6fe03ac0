// A report: what it says, independent of how it is written down.
//
// All text is plain and becomes markup only in the writers (app/plot/report_text.h), so nothing in a
// name or a message can break a page. write_report leaves, in one folder:
//   report.html   one file with everything in it, for reading and sending
//   report.md     for a repository, with links to the files below
//   plots/        each plot as CSV, gnuplot script, PNG and SVG
//   pictures/     each picture
#pragma once

#include <filesystem>
#include <string>
#include <utility>
#include <variant>
#include <vector>

#include "app/plot/plot.h"

namespace quicksand {

struct Paragraph {
  std::string text{};
};

// Set apart from the text: what a reader must not miss.
struct Remark {
  enum class Kind : std::uint8_t { note, warning };
  Kind kind = Kind::note;
  std::string text{};
};

struct BulletList {
  std::vector<std::string> items{};
};

// Shown letter by letter: commands, messages.
struct Verbatim {
  std::string text{};
};

// To a file beside the report, or to a page.
struct ReportLink {
  std::string text{};
  std::string address{};
};

// To a file, as seen from the folder of a report.
ReportLink link_from(const std::filesystem::path& report, const std::filesystem::path& file,
                     std::string text);

struct Cell {
  // What a cell is to the eye: besides its colour it has a symbol and says it in words.
  enum class Mark : std::uint8_t { none, inside, outside, undecided };
  std::string text{};
  Mark mark = Mark::none;
  std::vector<ReportLink> links{};  // behind the text
};

struct Column {
  std::string title{};
  bool number = false;  // set flush right
};

struct Table {
  std::string caption{};
  std::vector<Column> columns{};
  std::vector<std::vector<Cell>> rows{};  // each as long as `columns`
};

struct Figure {
  Plot plot{};
  std::string caption{};
  std::string command{};  // that makes it again; under it
};

// Pictures side by side.
struct Gallery {
  struct Picture {
    std::filesystem::path file{};  // a PNG
    std::string caption{};
    std::string command{};  // that makes it again; under it
  };
  std::vector<Picture> pictures{};
};

using Block = std::variant<Paragraph, Remark, BulletList, Verbatim, Table, Figure, Gallery>;

struct Section {
  std::string title{};
  std::vector<Block> blocks{};

  // Leaves out a plot without values. Points that a logarithmic axis cannot show are counted under it, or in its place.
  void add(Block block);
};

struct Report {
  std::string title{};
  std::vector<std::string> intro{};  // paragraphs
  std::vector<Block> lead{};         // before the contents: no pictures
  std::vector<std::pair<std::string, std::string>> provenance{};  // what, value
  std::vector<Section> sections{};
};

// The files of a report's figures and pictures, in the order in which they stand in it.
struct ReportFiles {
  struct Drawn {
    std::string name;  // of the plot
    PlotFiles files;
  };
  std::filesystem::path folder;
  std::vector<Drawn> plots;
  std::vector<std::string> pictures;  // names in pictures/, with extension
};

// The whole page. Reads the figures' files; throws InputError if one cannot be read.
std::string report_html(const Report& report, const ReportFiles& files);
std::string report_markdown(const Report& report, const ReportFiles& files);

// Draws, and writes everything into the folder, which is made if it is not there. Returns what went
// wrong without stopping it: plots that could not be drawn. Throws InputError if a picture cannot be
// read, a file cannot be written, or two plots have the same name.
std::vector<std::string> write_report(const Report& report, const std::filesystem::path& folder);

// The sections as written: those of the report, and its provenance as the last one.
std::vector<Section> all_sections(const Report& report);

// "✓ ", "✗ ", "? " or nothing, in front of a cell's text.
std::string symbol_of(Cell::Mark mark);

}  // namespace quicksand
