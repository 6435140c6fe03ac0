// The figures of the pages are those of the generated reports that they link to: a paragraph that links to a
// report takes its figures from it, or from the section that the link names, and so does a table beneath it.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <regex>

#include "tests/support/files.h"
#include "tests/support/markdown.h"

namespace quicksand::test {
namespace {

namespace fs = std::filesystem;

// A figure as it is printed: 0.20 is anything from 0.195 to 0.205, 1200 anything from 1150 to 1250.
struct Printed {
  std::string text;
  double value = 0, half_unit = 0;
  int digits = 0;  // significant ones
};

Printed printed(const std::string& text) {
  const std::size_t exponent = std::min(text.find('e'), text.size());
  const std::string mantissa = text.substr(0, exponent);
  const std::size_t point = std::min(mantissa.find('.'), mantissa.size());
  int last = point < mantissa.size() ? -static_cast<int>(mantissa.size() - point - 1) : 0;
  std::string digits = mantissa;
  std::erase(digits, '.');
  digits.erase(0, std::min(digits.find_first_not_of('0'), digits.size()));
  if (last == 0 && exponent == text.size())
    for (; digits.ends_with('0'); digits.pop_back()) ++last;
  if (exponent < text.size()) last += std::stoi(text.substr(exponent + 1));
  return {text, std::stod(text), 0.5 * std::pow(10, last), static_cast<int>(digits.size())};
}

// All numbers of a text, without their signs; what stands in `code`, the years of sources and names of commits, as
// 83e3203, are none.
std::vector<Printed> figures_of(std::string text) {
  static const std::regex code("`[^`]*`"), commit("commit [0-9a-f]{7,40}"),
      target(R"(\]\([^)]*\))"), source_of(R"(\[[^\]]* \d{4}\])"), power(R"((\d) (?:×|x) 10⁻(\d))"),
      thousands(R"((\d) (\d{3})\b)"), number(R"((^|[^\w.])(\d+(?:\.\d+)?(?:e[+-]?\d+)?))");
  text = std::regex_replace(text, target, "]");
  text = std::regex_replace(text, commit, "");
  text = std::regex_replace(text, code, " ");
  text = std::regex_replace(text, source_of, " ");
  text = std::regex_replace(text, power, "$1e-$2");
  text = std::regex_replace(text, thousands, "$1$2");
  std::vector<Printed> found;
  for (std::sregex_iterator it(text.begin(), text.end(), number), end; it != end; ++it)
    found.push_back(printed((*it)[2]));
  return found;
}

// In a report it may be a share where the page says per cent, or the other way round.
bool stands_among(const Printed& figure, const std::vector<Printed>& reported) {
  constexpr double kRounding = 1 + 1e-9;
  return std::ranges::any_of(reported, [&](const Printed& one) {
    return std::ranges::any_of(std::array{1.0, 100.0, 0.01}, [&](double scale) {
      return std::abs(one.value * scale - figure.value) <= kRounding * figure.half_unit;
    });
  });
}

// The texts of the reports, or of their sections, that a paragraph links to.
std::string reported_in(const Piece& paragraph) {
  static const std::regex report(R"(\]\(([^)#]*report\.md)(?:#([^)]*))?\))");
  const std::string& text = paragraph.text;
  std::string all;
  for (std::sregex_iterator it(text.begin(), text.end(), report), end; it != end; ++it) {
    const fs::path file = paragraph.file.parent_path() / (*it)[1].str();
    if (!fs::exists(file)) continue;
    all += (*it)[2].matched ? read_page(file).sections[(*it)[2]] : contents(file);
  }
  return all;
}

// Calls `use` with each paragraph and the text of the reports that its figures are from.
template <class Use>
void for_each_reporting(const Page& page, Use use) {
  std::string above;  // what the paragraph above a table links to
  for (const Piece& paragraph : page.paragraphs) {
    const std::string reported = reported_in(paragraph);
    const bool row = paragraph.text.starts_with('|');
    if (!row) above = reported;
    const std::string from = row ? above + reported : reported;
    if (!from.empty()) use(paragraph, from);
  }
}

TEST(Figures, OfPagesStandInTheReportsThatTheyLinkTo) {
  int count = 0;
  for (const Page& page : all_pages()) {
    if (is_report(page)) continue;
    for_each_reporting(page, [&](const Piece& paragraph, const std::string& text) {
      const std::vector<Printed> reported = figures_of(text);
      for (const Printed& figure : figures_of(paragraph.text)) {
        if (figure.digits < 2) continue;  // one digit is found anywhere
        ++count;
        if (!stands_among(figure, reported))
          ADD_FAILURE() << paragraph.where() << ": " << figure.text
                        << " does not stand in the report that it links to";
      }
    });
  }
  EXPECT_GT(count, 300);
}

TEST(Figures, CountAsPrinted) {
  const auto found = [](const std::string& figure, const std::string& report) {
    return stands_among(printed(figure), figures_of(report));
  };
  EXPECT_TRUE(found("0.20", "| 0.196 ± 0.002 |"));
  EXPECT_FALSE(found("0.20", "| 0.19 |"));
  EXPECT_TRUE(found("1200", "1 184 steps"));
  EXPECT_FALSE(found("1200", "1 284 steps"));
  EXPECT_TRUE(found("34", "0.342 of it"));
  EXPECT_TRUE(found("2.4e-4", "2.39e-04"));
  EXPECT_FALSE(found("1996", "elimination [Amestoy 1996] of `1996`"));
}

}  // namespace
}  // namespace quicksand::test
