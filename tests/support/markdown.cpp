#include "tests/support/markdown.h"

#include <algorithm>
#include <cctype>
#include <fstream>
#include <map>
#include <sstream>
#include <string_view>

#include "tests/support/files.h"

namespace quicksand::test {

namespace {

namespace fs = std::filesystem;

// The line with spaces for what stands in `code`, where nothing is a link.
std::string without_code(std::string line) {
  bool inside = false;
  for (char& c : line) {
    const bool mark = c == '`';
    if (mark) inside = !inside;
    if (inside || mark) c = ' ';
  }
  return line;
}

void add_links(const Page& page, int line, const std::string& text, std::vector<Piece>& links) {
  const auto add = [&](std::string_view opening, char closing) {
    for (std::size_t at = 0; (at = text.find(opening, at)) != std::string::npos;) {
      at += opening.size();
      const std::size_t end = std::min(text.find(closing, at), text.size());
      links.push_back({page.file, line, {}, text.substr(at, end - at)});
    }
  };
  add("](", ')');
  add("src=\"", '"');
}

// GitHub: lower case, no punctuation but - and _, spaces to -; of links the text.
std::string slug(const std::string& heading) {
  std::string text, slug;
  for (std::size_t i = 0; i < heading.size(); ++i) {
    if (heading.compare(i, 2, "](") == 0) i = std::min(heading.find(')', i), heading.size() - 1);
    text += heading[i];
  }
  for (const char c : text) {
    const auto byte = static_cast<unsigned char>(c);
    if (c == ' ') slug += '-';
    if (c == '-' || c == '_' || byte >= 0x80 || std::isalnum(byte) != 0)
      slug += static_cast<char>(byte < 0x80 ? std::tolower(byte) : byte);
  }
  return slug;
}

// The number of # that begin a heading.
std::size_t level_of(const std::string& line) {
  const std::size_t level = std::min(line.find_first_not_of('#'), line.size());
  return level > 0 && level < line.size() && line[level] == ' ' ? level : 0;
}

// A row of a table, or an item of a list: a paragraph of its own.
bool begins_item(const std::string& text) {
  const std::size_t number = std::min(text.find_first_not_of("0123456789"), text.size());
  return text.starts_with('|') || text.starts_with("- ") ||
         (number > 0 && text.compare(number, 2, ". ") == 0);
}

}  // namespace

std::string Piece::where() const {
  return fs::relative(file, kSource).string() + ", line " + std::to_string(line);
}

Page read_page(const fs::path& file) {
  Page page{.file = file};
  std::map<std::string, int> seen;
  struct Heading {
    std::size_t level;
    std::string anchor;
  };
  std::vector<Heading> open;  // of the sections that the line is in
  std::ifstream stream(file);
  bool fenced = false, goes_on = false;
  for (std::string line; std::getline(stream, line);) {
    ++page.lines;
    const std::size_t start = std::min(line.find_first_not_of(' '), line.size());
    const std::size_t level = fenced ? 0 : level_of(line);
    for (const Heading& heading : open) page.sections[heading.anchor] += line + "\n";
    if (line.compare(start, 3, "```") == 0) {
      fenced = !fenced;
      goes_on = false;
      if (fenced) page.blocks.push_back({file, page.lines + 1, line.substr(start + 3), {}});
      continue;
    }
    if (fenced) {
      page.blocks.back().text += line + "\n";
      continue;
    }
    add_links(page, page.lines, without_code(line), page.links);
    if (level > 0) {
      const std::string name = slug(line.substr(level + 1));
      const int before = seen[name]++;
      std::erase_if(open, [&](const Heading& heading) { return heading.level >= level; });
      open.push_back({level, before == 0 ? name : name + "-" + std::to_string(before)});
      page.sections[open.back().anchor];
    }
    const bool text = level == 0 && start < line.size();
    if (goes_on && text && !begins_item(line.substr(start)))
      page.paragraphs.back().text += "\n" + line;
    else if (text)
      page.paragraphs.push_back({file, page.lines, {}, line});
    goes_on = text;
  }
  return page;
}

std::vector<Page> all_pages() {
  std::vector<Page> pages{read_page(kSource / "README.md")};
  for (const auto& entry : fs::recursive_directory_iterator(kSource / "assets"))
    if (entry.path().extension() == ".md") pages.push_back(read_page(entry.path()));
  return pages;
}

bool is_report(const Page& page) { return page.file.filename() == "report.md"; }

std::vector<Piece> shell_lines(const Piece& block) {
  std::vector<Piece> lines;
  std::istringstream stream(block.text);
  bool joined = false;
  int number = block.line;
  for (std::string line; std::getline(stream, line); ++number) {
    const bool goes_on = line.ends_with('\\');
    if (goes_on) line.pop_back();
    if (joined)
      lines.back().text += line;
    else
      lines.push_back({block.file, number, {}, line});
    joined = goes_on;
  }
  return lines;
}

std::vector<std::string> shell_words(const std::string& line) {
  std::vector<std::string> words;
  std::string word;
  bool any = false;  // an empty pair of quotes is a word, too
  char quote = 0;
  const auto end_word = [&] {
    if (any) words.push_back(word);
    word.clear(), any = false;
  };
  for (std::size_t i = 0; i < line.size(); ++i) {
    const char c = line[i];
    if (quote == 0 && c == ' ') {
      end_word();
    } else if (quote == 0 &&
               ((c == '#' && !any) || std::string_view("|&;>").find(c) != std::string_view::npos)) {
      break;
    } else if (c == quote || (quote == 0 && (c == '"' || c == '\''))) {
      quote = quote == 0 ? c : '\0';
      any = true;
    } else {
      if (c == '\\' && quote == 0 && i + 1 < line.size()) ++i;
      word += line[i];
      any = true;
    }
  }
  end_word();
  for (std::string& one : words) {
    constexpr std::string_view kHere = "$PWD";
    const std::size_t at = one.find(kHere);
    if (at != std::string::npos) one.replace(at, kHere.size(), kSource.string());
  }
  return words;
}

}  // namespace quicksand::test
