// How text and numbers are written in reports.
#include "app/plot/report_text.h"

#include <gtest/gtest.h>

#include "app/base/status_line.h"
#include "app/json/base64.h"
#include "app/plot/typeset_number.h"
#include "app/report/provenance.h"

namespace quicksand::test {
namespace {

TEST(ReportText, IsNeverMarkup) {
  EXPECT_EQ(html_text("<b>\"x\"_{}|&'"), "&lt;b&gt;&quot;x&quot;_{}|&amp;&#39;");
  EXPECT_EQ(markdown_text("<b>\"x\"_{}|&`*[a](b)$\\~"),
            "&lt;b&gt;\"x\"\\_{}\\|&amp;\\`\\*\\[a\\](b)\\$\\\\\\~");
  EXPECT_EQ(gnuplot_text("<b>\"x\"_{}|'@^~\\"), "'<b>”x”\\_\\{\\}|’\\@\\^\\~\\\\'");
  EXPECT_EQ(csv_text("a \"b\", c"), "\"a \"\"b\"\", c\"");
}

TEST(ReportText, BreaksNoLineAndHoldsNoBytesThatAreNoText) {
  for (const auto& write : {html_text, html_attribute, markdown_text, gnuplot_text, csv_text}) {
    const std::string text = write("a\nb\r\x01\tc\xff d");
    EXPECT_EQ(text.find_first_of("\n\r\x01\t\xff"), std::string::npos) << text;
    EXPECT_NE(text.find("\xEF\xBF\xBD"), std::string::npos) << text;
  }
}

TEST(ReportText, OfMarkdownBeginsNoHeadingListOrRule) {
  EXPECT_EQ(markdown_text("# a"), "\\# a");
  EXPECT_EQ(markdown_text("- a"), "\\- a");
  EXPECT_EQ(markdown_text("--- "), "\\--- ");
  EXPECT_EQ(markdown_text("12. a"), "12\\. a");
  EXPECT_EQ(markdown_text("-3.5"), "-3.5");
  EXPECT_EQ(markdown_text("0.5 of it"), "0.5 of it");
}

TEST(ReportText, ALetterWithAShortIndexIsASymbol) {
  EXPECT_EQ(html_text("F_c = 3 (mu_r, μ_r)"),
            "<i>F</i><sub>c</sub> = 3 (mu_r, <i>μ</i><sub>r</sub>)");
  EXPECT_EQ(html_text("intruder_y a_long_name F_c_2"), "intruder_y a_long_name F_c_2");
  EXPECT_EQ(gnuplot_text("F_c"), "'{/:Italic F}_{c}'");
  EXPECT_EQ(html_attribute("F_c"), "F_c");
}

TEST(ReportText, QuantitiesOfOneLetterAreItalicInPlots) {
  EXPECT_EQ(gnuplot_text("[√(d/g)]"), "'[√({/:Italic d}/{/:Italic g})]'");
  EXPECT_EQ(gnuplot_text("F/d²"), "'{/:Italic F}/{/:Italic d}²'");
  for (const char* plain : {"a grain", "'24 x 50'", "e.g. dt", "the grain's s"})
    EXPECT_EQ(gnuplot_text(plain).find("Italic"), std::string::npos) << plain;
}

TEST(ReportText, FileNamesAreSafe) {
  EXPECT_EQ(file_name_text("Push, 0.33 F_c"), "push_0_33_f_c");
  EXPECT_EQ(file_name_text("../../etc"), "etc");
  EXPECT_EQ(file_name_text("\xff/"), "unnamed");
}

TEST(Base64, IsThatOfTheStandard) {
  EXPECT_EQ(base64(""), "");
  EXPECT_EQ(base64("f"), "Zg==");
  EXPECT_EQ(base64("fo"), "Zm8=");
  EXPECT_EQ(base64("foobar"), "Zm9vYmFy");
  EXPECT_EQ(base64("\xff\xfe\xfd"), "//79");
}

TEST(TypesetNumber, HasTheDigitsThatItsErrorWarrants) {
  EXPECT_EQ(typeset_with_error(0.37214, 0.0043), "0.372 ± 0.004");
  EXPECT_EQ(typeset_with_error(0.37214, 0.0143), "0.372 ± 0.014");
  EXPECT_EQ(typeset_with_error(0.37214, 0.0097), "0.372 ± 0.010");
  EXPECT_EQ(typeset_with_error(23.44, 2.6), "23 ± 3");
  EXPECT_EQ(typeset_with_error(12345, 678), "12300 ± 700");
  EXPECT_EQ(typeset_with_error(-1.316e-6, 4.9e-8), "(-1.32 ± 0.05) × 10⁻⁶");
  EXPECT_EQ(typeset_with_error(1.3e7, 2.1e5), "(1.30 ± 0.02) × 10⁷");
  EXPECT_EQ(typeset_with_error(0.02, 3), "0 ± 3");
  EXPECT_EQ(typeset_with_error(1, 0.0), "1 ± 0");
  EXPECT_EQ(typeset_with_error(0.37214, std::nullopt), "0.3721");
}

TEST(TypesetNumber, IsShortWithoutAnError) {
  EXPECT_EQ(typeset(0), "0");
  EXPECT_EQ(typeset(0.400000), "0.4");
  EXPECT_EQ(typeset(123456), "123456");
  EXPECT_EQ(typeset(9999.96), "10000");
  EXPECT_EQ(typeset(1.2e-7), "1.2 × 10⁻⁷");
  EXPECT_EQ(typeset(-2.5e12), "-2.5 × 10¹²");
  EXPECT_EQ(typeset(std::stod("nan")), "not a number");
}

TEST(TypesetNumber, UnitsAreInBracketsAndDurationsInWords) {
  EXPECT_EQ(typeset_unit("1"), "");
  EXPECT_EQ(typeset_unit("sqrt(d/g)"), "[√(d/g)]");
  EXPECT_EQ(duration_text(0.312), "0.31 s");
  EXPECT_EQ(duration_text(12.34), "12 s");
  EXPECT_EQ(duration_text(200), "3 min 20 s");
  EXPECT_EQ(duration_text(7500), "2 h 5 min");
}

TEST(Provenance, CommandsCanBePastedIntoAShell) {
  EXPECT_EQ(command_text({"quicksand", "report", "my run", "it's", ""}),
            "quicksand report 'my run' 'it'\\''s' ''");
}

TEST(Provenance, NamesProgramCompilerAndMachineTheSameEachTime) {
  const auto rows = provenance("x", 61.0);
  EXPECT_EQ(rows, provenance("x", 61.0));
  EXPECT_EQ(rows.front().first, "program");
  EXPECT_EQ(rows.back().second, "1 min 1 s");
}

}  // namespace
}  // namespace quicksand::test
