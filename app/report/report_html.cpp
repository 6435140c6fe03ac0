// Plots are SVG pictures and frames PNG pictures, all inside the page; it asks for nothing from elsewhere and runs no
// script.
#include <string>

#include "app/base/assets.h"
#include "app/json/base64.h"
#include "app/json/json_text.h"
#include "app/plot/report_text.h"
#include "app/report/report.h"

namespace quicksand {

namespace {

std::string element(const std::string& tag, const std::string& inside) {
  return "<" + tag + ">" + inside + "</" + tag.substr(0, tag.find(' ')) + ">";
}

std::string data_address(const std::string& type, const std::string& bytes) {
  return "data:" + type + ";base64," + base64(bytes);
}

std::string image(const std::string& attributes, const std::string& alternative,
                  const std::string& address) {
  return "<img " + attributes + " alt=\"" + html_attribute(alternative) + "\" src=\"" + address +
         "\">";
}

std::string class_of(Cell::Mark mark) {
  constexpr const char* kClasses[] = {"", "inside", "outside", "undecided"};
  return kClasses[static_cast<int>(mark)];
}

std::string command_of(const std::string& command) {
  return command.empty() ? "" : "<br><code>" + html_attribute(command) + "</code>";
}

std::string links_of(const Cell& cell) {
  std::string links;
  for (const ReportLink& link : cell.links)
    links += " <a href=\"" + html_attribute(link.address) + "\">" + html_text(link.text) + "</a>";
  return links;
}

class HtmlWriter {
 public:
  explicit HtmlWriter(const ReportFiles& files) : files_(files) {}

  void operator()(const Paragraph& block) { add(element("p", html_text(block.text))); }

  void operator()(const Remark& block) {
    const bool warning = block.kind == Remark::Kind::warning;
    add(element(warning ? "p class=\"remark warning\"" : "p class=\"remark\"",
                std::string("<strong>") + (warning ? "⚠ Warning: " : "Note: ") + "</strong>" +
                    html_text(block.text)));
  }

  void operator()(const BulletList& block) {
    std::string items;
    for (const std::string& item : block.items) items += element("li", html_text(item)) + "\n";
    add(element("ul", "\n" + items));
  }

  void operator()(const Verbatim& block) {
    // Line by line, since line breaks are kept here.
    std::string lines;
    for (std::size_t begin = 0; begin < block.text.size();) {
      const std::size_t end = std::min(block.text.find('\n', begin), block.text.size());
      lines += html_attribute(block.text.substr(begin, end - begin)) + "\n";
      begin = end + 1;
    }
    add(element("pre", lines));
  }

  void operator()(const Table& block) {
    std::string head;
    for (const Column& column : block.columns) {
      head += element(column.number ? "th scope=\"col\" class=\"number\"" : "th scope=\"col\"",
                      html_text(column.title));
    }
    std::string body;
    for (const std::vector<Cell>& row : block.rows) {
      std::string cells;
      for (std::size_t i = 0; i < row.size(); ++i) {
        std::string kind = class_of(row[i].mark);
        if (block.columns.at(i).number) kind += kind.empty() ? "number" : " number";
        cells += element(kind.empty() ? "td" : "td class=\"" + kind + "\"",
                         symbol_of(row[i].mark) + html_text(row[i].text) + links_of(row[i]));
      }
      body += element("tr", cells) + "\n";
    }
    const std::string caption =
        block.caption.empty() ? "" : element("caption", html_text(block.caption)) + "\n";
    add(element("div class=\"wide\"",
                element("table", "\n" + caption + element("thead", element("tr", head)) + "\n" +
                                     element("tbody", "\n" + body) + "\n")));
  }

  void operator()(const Figure& block) {
    const ReportFiles::Drawn& plot = files_.plots.at(next_plot_++);
    const auto contents = [&](const char* extension) {
      return read_text(files_.folder / "plots" / (plot.name + extension));
    };
    const auto download = [&](const char* extension, const char* type, const char* words) {
      return "<a download=\"" + plot.name + extension + "\" href=\"" +
             data_address(type, contents(extension)) + "\">" + words + "</a>";
    };
    std::string inside;
    if (plot.files.drawn) {
      inside = image("class=\"plot\"", description_of(block.plot),
                     data_address("image/svg+xml", contents(".svg")));
    } else {
      inside = element("p class=\"remark warning\"",
                       "<strong>Not drawn: </strong>" + html_text(plot.files.problem));
    }
    add(element("figure",
                inside + "\n" +
                    element("figcaption", html_text(block.caption) + " <span class=\"files\">" +
                                              download(".csv", "text/csv", "data") + ", " +
                                              download(".gp", "text/plain", "gnuplot script") +
                                              "</span>" + command_of(block.command))));
  }

  void operator()(const Gallery& block) {
    std::string inside;
    for (const Gallery::Picture& picture : block.pictures) {
      const std::string bytes =
          read_text(files_.folder / "pictures" / files_.pictures.at(next_picture_++));
      inside +=
          element(
              "figure",
              image("class=\"frame\"", picture.caption, data_address("image/png", bytes)) +
                  element("figcaption", html_text(picture.caption) + command_of(picture.command))) +
          "\n";
    }
    add(element("div class=\"gallery\"", "\n" + inside));
  }

  void add(const std::string& text) { text_ += text + "\n"; }
  std::string take() { return std::move(text_); }

 private:
  const ReportFiles& files_;
  std::size_t next_plot_ = 0;
  std::size_t next_picture_ = 0;
  std::string text_;
};

std::string section_name(std::size_t i) { return "section" + std::to_string(i + 1); }

std::string contents_of(const std::vector<Section>& sections) {
  std::string items;
  for (std::size_t i = 0; i < sections.size(); ++i) {
    items += element("li", "<a href=\"#" + section_name(i) + "\">" + html_text(sections[i].title) +
                               "</a>") +
             "\n";
  }
  return element("nav aria-label=\"Contents\"", element("ul", "\n" + items));
}

}  // namespace

std::string report_html(const Report& report, const ReportFiles& files) {
  const std::vector<Section> sections = all_sections(report);
  HtmlWriter writer(files);
  writer.add("<!DOCTYPE html>\n<html lang=\"en\">\n<head>\n<meta charset=\"utf-8\">");
  writer.add("<meta name=\"viewport\" content=\"width=device-width, initial-scale=1\">");
  writer.add(element("title", html_attribute(report.title)));
  writer.add(element("style", "\n" + read_text(assets_folder() / "report" / "report.css")) +
             "\n</head>\n<body>");
  writer.add(element("h1", html_text(report.title)));
  for (const std::string& paragraph : report.intro) writer(Paragraph{paragraph});
  for (const Block& block : report.lead) std::visit(writer, block);
  writer.add(contents_of(sections));
  for (std::size_t i = 0; i < sections.size(); ++i) {
    writer.add("<section id=\"" + section_name(i) + "\">");
    writer.add(element("h2", html_text(sections[i].title)));
    for (const Block& block : sections[i].blocks) std::visit(writer, block);
    writer.add("</section>");
  }
  writer.add("</body>\n</html>");
  return writer.take();
}

}  // namespace quicksand
