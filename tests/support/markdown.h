// What our pages are made of: links, sections, paragraphs, fenced blocks, command lines.
#pragma once

#include <filesystem>
#include <map>
#include <string>
#include <vector>

namespace quicksand::test {

// A piece of a page, and the line in which it begins.
struct Piece {
  std::filesystem::path file;
  int line = 0;
  std::string language;  // of a fenced block
  std::string text;

  // "README.md, line 12"
  std::string where() const;
};

struct Page {
  std::filesystem::path file;
  std::vector<Piece> links;   // their targets, images among them
  std::vector<Piece> blocks;  // fenced ones
  std::vector<Piece>
      paragraphs{};  // outside of these; an item of a list or a row of a table is one
  // By the anchor of the heading (GitHub's rules): all text up to the next heading of its level.
  std::map<std::string, std::string> sections{};
  int lines = 0;
};

Page read_page(const std::filesystem::path& file);

// README.md and all pages below assets/.
std::vector<Page> all_pages();

// Written by the program, or by the benchmark: theirs are links only.
bool is_report(const Page& page);

// The lines of a block for the shell, those that end in a backslash joined with the next.
std::vector<Piece> shell_lines(const Piece& block);

// The words of a command as the shell splits them, up to a comment, a pipe or the next command.
std::vector<std::string> shell_words(const std::string& line);

}  // namespace quicksand::test
