// Text of reports and plots for each language that it is written in.
//
// All text is plain: nothing in it is markup, whatever it holds. Bytes that are not UTF-8 become
// U+FFFD, control characters and line breaks become spaces. One thing is typeset: a letter with a
// short index, F_c, is a symbol where the language has subscripts.
#pragma once

#include <string>
#include <string_view>

namespace quicksand {

// Between tags and in quoted attributes.
std::string html_text(std::string_view text);

// The same without subscripts, where no tag may stand: attributes and titles.
std::string html_attribute(std::string_view text);

// In a line or a table cell of GitHub's Markdown.
std::string markdown_text(std::string_view text);

// A gnuplot string in quotes, in its enhanced mode; an ampersand becomes a plus sign, quotes become typographic.
// Quantities of one letter are italic: d, g, v, F, k, r, t, n, Z.
std::string gnuplot_text(std::string_view text);

// A field of a CSV file in quotes.
std::string csv_text(std::string_view text);

// A name that is safe in file names and links: a to z, 0 to 9 and underscores; never empty.
std::string file_name_text(std::string_view text);

}  // namespace quicksand
