#include "app/plot/report_text.h"

#include <algorithm>
#include <cctype>
#include <cstddef>

#include "app/json/json_text.h"

namespace quicksand {

namespace {

bool is_letter(char c) { return std::isalpha(static_cast<unsigned char>(c)) != 0; }
bool is_word(char c) { return std::isalnum(static_cast<unsigned char>(c)) != 0 || c == '_'; }

// Valid UTF-8 without control characters. The JSON library knows both UTF-8 and what to put instead.
std::string clean(std::string_view text) {
  const std::string quoted =
      Json(std::string(text)).dump(-1, ' ', false, Json::error_handler_t::replace);
  std::string valid = Json::parse(quoted).get<std::string>();
  for (char& c : valid) {
    if (std::iscntrl(static_cast<unsigned char>(c)) != 0) c = ' ';
  }
  return valid;
}

// Characters of the letter at `i`, Latin or Greek; 0 if there is none.
std::size_t letter_size(std::string_view text, std::size_t i) {
  if (is_letter(text[i])) return 1;
  const auto lead = static_cast<unsigned char>(text[i]);
  return (lead == 0xCE || lead == 0xCF) && i + 1 < text.size() ? 2 : 0;
}

// Hands the text over in pieces: runs of plain text, and symbols as letter and index.
template <class OnPlain, class OnSymbol>
void for_pieces(std::string_view text, OnPlain on_plain, OnSymbol on_symbol) {
  constexpr std::size_t kLongestIndex = 3;
  std::size_t plain = 0;
  for (std::size_t i = 0; i < text.size(); ++i) {
    const std::size_t letter = letter_size(text, i);
    if (letter == 0 || (i > 0 && is_word(text[i - 1]))) continue;
    const std::size_t index = i + letter + 1;
    if (index >= text.size() || text[index - 1] != '_') continue;
    std::size_t end = index;
    while (end < text.size() && is_word(text[end])) ++end;
    const std::string_view word = text.substr(index, end - index);
    if (word.empty() || word.size() > kLongestIndex || word.find('_') != word.npos) continue;
    on_plain(text.substr(plain, i - plain));
    on_symbol(text.substr(i, letter), word);
    plain = end;
    i = end - 1;
  }
  on_plain(text.substr(plain));
}

// Letters that stand alone for a quantity: others may be articles, units of SI or the sign of a product.
bool is_quantity(std::string_view text, std::size_t i) {
  constexpr std::string_view kQuantities = "dgvFkrtnZ";
  if (kQuantities.find(text[i]) == kQuantities.npos) return false;
  const auto may_touch = [](char c) { return !is_word(c) && c != '.' && c != '\'' && c != '-'; };
  return (i == 0 || may_touch(text[i - 1])) && (i + 1 == text.size() || may_touch(text[i + 1]));
}

// Every character of `special` behind a backslash.
std::string with_backslashes(std::string_view text, std::string_view special) {
  std::string escaped;
  for (const char c : text) {
    if (special.find(c) != special.npos) escaped += '\\';
    escaped += c;
  }
  return escaped;
}

std::string doubled(std::string_view text, char quote) {
  std::string escaped;
  for (const char c : text) escaped.append(c == quote ? 2 : 1, c);
  return escaped;
}

std::string html_escape(std::string_view text) {
  static constexpr std::pair<char, std::string_view> kEntities[] = {
      {'&', "&amp;"}, {'<', "&lt;"}, {'>', "&gt;"}, {'"', "&quot;"}, {'\'', "&#39;"}};
  std::string escaped;
  for (const char c : text) {
    const auto* entity = std::ranges::find(kEntities, c, &std::pair<char, std::string_view>::first);
    if (entity == std::end(kEntities))
      escaped += c;
    else
      escaped += entity->second;
  }
  return escaped;
}

}  // namespace

std::string html_text(std::string_view text) {
  std::string html;
  for_pieces(
      clean(text), [&](std::string_view plain) { html += html_escape(plain); },
      [&](std::string_view letter, std::string_view index) {
        html.append("<i>").append(letter).append("</i><sub>").append(index).append("</sub>");
      });
  return html;
}

std::string html_attribute(std::string_view text) { return html_escape(clean(text)); }

std::string markdown_text(std::string_view text) {
  std::string markdown;
  for (const char c : clean(text)) {
    if (c == '&' || c == '<' || c == '>') {
      markdown += html_escape({&c, 1});
    } else {
      markdown += with_backslashes({&c, 1}, "\\`*_[]|~$");
    }
  }
  // What would begin a heading, a list, a rule or an underline.
  const std::size_t first = markdown.find_first_not_of(" 0123456789");
  if (first != markdown.npos && markdown.find_first_not_of("#+-=.)", first) != first) {
    const char after = first + 1 < markdown.size() ? markdown[first + 1] : ' ';
    if (after == ' ' || after == markdown[first]) markdown.insert(first, "\\");
  }
  return markdown;
}

std::string gnuplot_text(std::string_view text) {
  // In single quotes nothing is expanded; the enhanced mode has its own special characters.
  // gnuplot 5.4 reads no doubled quote at the beginning of a string, nor two of them, and expands no macro after a lone
  // quote of the other kind, so all are typographic.
  constexpr std::string_view kSpecial = "\\_^{}@~";
  std::string valid = clean(text);
  // gnuplot 5.4 writes an ampersand into SVG as it is, which breaks the file.
  std::ranges::replace(valid, '&', '+');
  std::string script;
  for_pieces(
      valid,
      [&](std::string_view plain) {
        for (std::size_t i = 0; i < plain.size(); ++i) {
          const std::string_view letter = plain.substr(i, 1);
          if (is_quantity(plain, i))
            script.append("{/:Italic ").append(letter).append("}");
          else if (letter == "'" || letter == "\"")
            script += letter == "'" ? "’" : "”";
          else
            script += with_backslashes(letter, kSpecial);
        }
      },
      [&](std::string_view letter, std::string_view index) {
        script.append("{/:Italic ").append(letter).append("}_{").append(index).append("}");
      });
  return "'" + script + "'";
}

std::string csv_text(std::string_view text) { return '"' + doubled(clean(text), '"') + '"'; }

std::string file_name_text(std::string_view text) {
  constexpr std::size_t kLongest = 60;
  std::string name;
  for (const char c : text) {
    const bool safe = c >= 0 && std::isalnum(static_cast<unsigned char>(c)) != 0;
    const char next = safe ? static_cast<char>(std::tolower(c)) : '_';
    if (next != '_' || (!name.empty() && name.back() != '_')) name += next;
  }
  name.resize(std::min(name.size(), kLongest));
  while (!name.empty() && name.back() == '_') name.pop_back();
  return name.empty() ? "unnamed" : name;
}

}  // namespace quicksand
