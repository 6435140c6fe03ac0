// The manual page, in the macros of man(7).
#include <sstream>

#include "app/base/build_info.h"
#include "app/base/exit_code.h"
#include "app/cli/manual.h"

namespace quicksand {

namespace {

// Text as groff shows it unchanged: its escape character, hyphens that are no minus, its requests.
std::string plain(const std::string& text) {
  std::string safe;
  for (const char letter : text) {
    const bool begins = safe.empty() || safe.back() == '\n';
    if (begins && (letter == '.' || letter == '\'')) safe += "\\&";
    if (letter == '\\') {
      safe += "\\e";
    } else if (letter == '-') {
      safe += "\\-";
    } else {
      safe += letter;
    }
  }
  return safe;
}

std::string bold(const std::string& text) { return "\\fB" + plain(text) + "\\fR"; }

std::string italic(const std::string& text) { return "\\fI" + plain(text) + "\\fR"; }

// Lines that are not filled.
std::string verbatim(const std::string& text) { return ".nf\n" + plain(text) + "\n.fi\n"; }

// "-h, --help", "--seed N", "scene".
std::string head(const CLI::Option& option) {
  std::string text;
  const auto add = [&](const std::string& name) {
    text += (text.empty() ? "" : ", ") + bold(name);
  };
  for (const std::string& name : option.get_snames()) add("-" + name);
  for (const std::string& name : option.get_lnames()) add("--" + name);
  const std::string type = option.get_type_name();
  if (text.empty()) return italic(type);
  return type.empty() ? text : text + " " + italic(type);
}

std::string described(const CLI::Option& option) {
  std::string text = ".TP\n" + head(option) + "\n" + plain(option.get_description());
  if (!option.get_default_str().empty())
    text += " [default: " + plain(option.get_default_str()) + "]";
  return text + "\n";
}

std::string synopsis(const CLI::App& command) {
  std::string text = bold("quicksand " + command.get_name());
  for (const CLI::Option* option : command.get_options()) {
    const std::string more = option->get_expected_max() > 1 ? "..." : "";
    if (option->get_positional() && option->get_required()) {
      text += " " + italic(option->get_type_name() + more);
    } else if (option->get_positional()) {
      text += " [" + italic(option->get_type_name() + more) + "]";
    }
  }
  return text + " [" + italic("OPTION") + "...]\n";
}

std::string section(const CLI::App& command) {
  std::string text = ".SS " + plain(command.get_name()) + "\n" + synopsis(command) + ".PP\n" +
                     plain(command.get_description()) + "\n";
  for (const CLI::Option* option : command.get_options()) text += described(*option);
  return text + ".PP\n" + verbatim(command.get_footer());
}

std::string exit_codes() {
  const std::pair<int, const char*> meanings[] = {
      {kFine, "fine"},
      {kRunFailed, "the run failed; the message says how to go on"},
      {kBadInput, "bad input; the message says where and what is possible"},
      {kInterrupted, "interrupted, with complete results"}};
  std::string text;
  for (const auto& [code, meaning] : meanings)
    text += ".TP\n" + bold(std::to_string(code)) + "\n" + plain(meaning) + "\n";
  return text;
}

}  // namespace

std::string man_page(const CLI::App& program) {
  std::ostringstream page;
  page << ".TH QUICKSAND 1 \"\" \"quicksand " << plain(build_info().version) << "\"\n"
       << ".SH NAME\nquicksand \\- contact dynamics of cohesive granular packings\n"
       << ".SH SYNOPSIS\n"
       << bold("quicksand") << " " << italic("COMMAND") << " [" << italic("ARGUMENT") << "...]\n"
       << ".SH DESCRIPTION\n"
       << plain(program.get_description()) << "\n.SH OPTIONS\n";
  for (const CLI::Option* option : program.get_options()) page << described(*option);
  page << ".SH COMMANDS\n";
  for (const CLI::App* command : program.get_subcommands({})) page << section(*command);
  page << ".SH EXIT STATUS\n"
       << exit_codes() << ".SH ENVIRONMENT\n.TP\n"
       << bold("QUICKSAND_ASSETS")
       << "\nfolder of the scenes and other files that come with the program\n"
       << ".SH EXAMPLE\n"
       << verbatim(program.get_footer());
  return page.str();
}

}  // namespace quicksand
