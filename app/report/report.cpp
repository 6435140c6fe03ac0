#include "app/report/report.h"

#include <algorithm>
#include <set>

#include "app/json/json_text.h"
#include "app/plot/report_text.h"
#include "app/run_folder/run_folder.h"
#include "core/base/errors.h"
#include "core/base/whole_file.h"

namespace quicksand {

namespace {

namespace fs = std::filesystem;

// A copy, so that the report stays whole when runs go.
std::string copy_picture(const fs::path& file, std::size_t number, const fs::path& folder) {
  constexpr std::string_view kSignature = "\x89PNG";
  const std::string bytes = read_text(file);
  if (!bytes.starts_with(kSignature)) throw InputError(file.string(), "is not a PNG picture");
  std::string name = std::to_string(number) + "_" + file_name_text(file.stem().string()) + ".png";
  write_whole(folder / name, bytes);
  return name;
}

// Draws and copies what the blocks show.
struct FileWriter {
  ReportFiles& files;
  std::set<std::string> names;

  template <class Other>
  void operator()(const Other& /*block*/) {}

  void operator()(const Figure& figure) {
    if (!names.insert(figure.plot.name).second) {
      throw InputError(figure.plot.name, "is the name of two plots of one report");
    }
    const fs::path folder = files.folder / "plots";
    make_writable({folder});
    files.plots.push_back({figure.plot.name, write_plot(figure.plot, folder)});
  }

  void operator()(const Gallery& gallery) {
    const fs::path folder = files.folder / "pictures";
    make_writable({folder});
    for (const Gallery::Picture& picture : gallery.pictures) {
      files.pictures.push_back(copy_picture(picture.file, files.pictures.size() + 1, folder));
    }
  }
};

std::string left_out_text(std::size_t count) {
  return count == 1 ? "1 point that is not positive is left out."
                    : std::to_string(count) + " points that are not positive are left out.";
}

}  // namespace

void Section::add(Block block) {
  if (auto* figure = std::get_if<Figure>(&block)) {
    const std::size_t count = left_out(figure->plot);
    const bool drawn = has_values(figure->plot);
    if (!drawn && count == 0) return;
    if (!drawn)
      block =
          Remark{Remark::Kind::note, "There is no plot of " + figure->plot.y.label + " against " +
                                         figure->plot.x.label +
                                         ": no point is positive, as a logarithmic axis needs."};
    else if (count > 0)
      figure->caption += (figure->caption.empty() ? "" : " ") + left_out_text(count);
  }
  blocks.push_back(std::move(block));
}

std::string symbol_of(Cell::Mark mark) {
  constexpr const char* kSymbols[] = {"", "✓ ", "✗ ", "? "};
  return kSymbols[static_cast<int>(mark)];
}

ReportLink link_from(const fs::path& report, const fs::path& file, std::string text) {
  const fs::path from = fs::absolute(report).lexically_normal();
  const fs::path to = fs::absolute(file).lexically_normal();
  return {.text = std::move(text), .address = to.lexically_proximate(from).generic_string()};
}

std::vector<Section> all_sections(const Report& report) {
  std::vector<Section> sections = report.sections;
  if (report.provenance.empty()) return sections;
  Table table{.columns = {{.title = "what"}, {.title = "value"}}};
  for (const auto& [what, value] : report.provenance) table.rows.push_back({{what}, {value}});
  sections.push_back({.title = "Provenance", .blocks = {table}});
  return sections;
}

std::vector<std::string> write_report(const Report& report, const fs::path& folder) {
  make_writable({folder});
  ReportFiles files{folder, {}, {}};
  FileWriter writer{files, {}};
  for (const Section& section : report.sections) {
    for (const Block& block : section.blocks) std::visit(writer, block);
  }
  write_whole(folder / "report.html", report_html(report, files));
  write_whole(folder / "report.md", report_markdown(report, files));
  std::vector<std::string> problems;
  for (const ReportFiles::Drawn& plot : files.plots) {
    const bool known = std::ranges::find(problems, plot.files.problem) != problems.end();
    if (!plot.files.drawn && !known) problems.push_back(plot.files.problem);
  }
  return problems;
}

}  // namespace quicksand
