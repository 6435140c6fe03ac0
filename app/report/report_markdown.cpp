#include <algorithm>
#include <string>

#include "app/plot/report_text.h"
#include "app/report/report.h"

namespace quicksand {

namespace {

// A link to a place in this file, as GitHub names headings.
std::string anchor(const std::string& title) {
  std::string name;
  for (const char c : title) {
    const auto byte = static_cast<unsigned char>(c);
    if (std::isalnum(byte) != 0 || c == '_' || c == '-' || byte >= 0x80) {
      name += byte < 0x80 ? static_cast<char>(std::tolower(byte)) : c;
    } else if (c == ' ') {
      name += '-';
    }
  }
  return name;
}

std::string table_row(const std::vector<std::string>& cells) {
  std::string row = "|";
  for (const std::string& cell : cells) row += " " + cell + " |";
  return row + "\n";
}

// Letter by letter, in a line or in a table, where a bar would end the cell.
std::string code(const std::string& text, bool in_table = false) {
  std::string inside;
  for (const char c : text) inside += (in_table && c == '|' ? "\\" : "") + std::string(1, c);
  return "`" + inside + "`";
}

std::string markdown_cell(const Cell& cell) {
  std::string text = symbol_of(cell.mark) + markdown_text(cell.text);
  for (const ReportLink& link : cell.links)
    text += " ([" + markdown_text(link.text) + "](" + link.address + "))";
  return text;
}

class MarkdownWriter {
 public:
  explicit MarkdownWriter(const ReportFiles& files) : files_(files) {}

  void operator()(const Paragraph& block) { add(markdown_text(block.text)); }

  void operator()(const Remark& block) {
    const bool warning = block.kind == Remark::Kind::warning;
    add((warning ? "> ⚠ **Warning:** " : "> **Note:** ") + markdown_text(block.text));
  }

  void operator()(const BulletList& block) {
    std::string list;
    for (const std::string& item : block.items) list += "- " + markdown_text(item) + "\n";
    if (!list.empty()) list.pop_back();
    add(list);
  }

  void operator()(const Verbatim& block) {
    // A fence longer than any inside.
    std::size_t longest = 2;
    std::size_t ticks = 0;
    for (const char c : block.text) {
      ticks = c == '`' ? ticks + 1 : 0;
      longest = std::max(longest, ticks);
    }
    const std::string fence(longest + 1, '`');
    add(fence + "text\n" + block.text + (block.text.ends_with('\n') ? "" : "\n") + fence);
  }

  void operator()(const Table& block) {
    std::vector<std::string> titles;
    std::vector<std::string> rules;
    for (const Column& column : block.columns) {
      titles.push_back(markdown_text(column.title));
      rules.emplace_back(column.number ? "---:" : "---");
    }
    std::string table = table_row(titles) + table_row(rules);
    for (const std::vector<Cell>& row : block.rows) {
      std::vector<std::string> cells;
      cells.reserve(row.size());
      for (const Cell& cell : row) cells.push_back(markdown_cell(cell));
      table += table_row(cells);
    }
    if (!block.caption.empty()) add("*" + markdown_text(block.caption) + "*");
    table.pop_back();
    add(table);
  }

  void operator()(const Figure& block) {
    const ReportFiles::Drawn& plot = files_.plots.at(next_plot_++);
    const std::string path = "plots/" + plot.name;
    const std::string caption = markdown_text(block.caption);
    if (plot.files.drawn) {
      add("![" + markdown_text(description_of(block.plot)) + "](" + path + ".png)");
    } else {
      add("> **Not drawn:** " + markdown_text(plot.files.problem));
    }
    add("*" + caption + "* (" + (plot.files.drawn ? "[SVG](" + path + ".svg), " : "") + "[data](" +
        path + ".csv), [gnuplot script](" + path + ".gp))");
    if (!block.command.empty()) add(code(block.command));
  }

  void operator()(const Gallery& block) {
    std::vector<std::string> pictures;
    std::vector<std::string> rules;
    std::vector<std::string> captions;
    for (const Gallery::Picture& picture : block.pictures) {
      const std::string caption = markdown_text(picture.caption);
      pictures.push_back("![" + caption + "](pictures/" + files_.pictures.at(next_picture_++) +
                         ")");
      rules.emplace_back(":---:");
      captions.push_back(caption +
                         (picture.command.empty() ? "" : "<br>" + code(picture.command, true)));
    }
    if (!pictures.empty()) {
      std::string table = table_row(pictures) + table_row(rules) + table_row(captions);
      table.pop_back();
      add(table);
    }
  }

  void add(const std::string& text) { text_ += text + "\n\n"; }

  // One newline at the end.
  std::string take() {
    text_.pop_back();
    return std::move(text_);
  }

 private:
  const ReportFiles& files_;
  std::size_t next_plot_ = 0;
  std::size_t next_picture_ = 0;
  std::string text_;
};

}  // namespace

std::string report_markdown(const Report& report, const ReportFiles& files) {
  MarkdownWriter writer(files);
  writer.add("# " + markdown_text(report.title));
  for (const std::string& paragraph : report.intro) writer.add(markdown_text(paragraph));
  for (const Block& block : report.lead) std::visit(writer, block);
  const std::vector<Section> sections = all_sections(report);
  std::string contents;
  for (const Section& section : sections) {
    contents += "- [" + markdown_text(section.title) + "](#" + anchor(section.title) + ")\n";
  }
  if (!contents.empty()) {
    contents.pop_back();
    writer.add(contents);
  }
  for (const Section& section : sections) {
    writer.add("## " + markdown_text(section.title));
    for (const Block& block : section.blocks) std::visit(writer, block);
  }
  return writer.take();
}

}  // namespace quicksand
