#include "app/report/provenance.h"

#include <algorithm>
#include <cctype>

#include "app/base/build_info.h"
#include "app/base/machine.h"
#include "app/plot/typeset_number.h"

namespace quicksand {

std::vector<std::pair<std::string, std::string>> provenance(const ReportOrigin& origin) {
  const BuildInfo& build = build_info();
  const Machine computer = machine();
  std::vector<std::pair<std::string, std::string>> rows{
      {"program", "quicksand " + build.version +
                      (build.commit == "unknown" ? "" : ", commit " + build.commit)},
      {"compiler", build.compiler + ", " + build.build_type},
      {"machine", computer.processor + ", " + std::to_string(computer.cores) + " cores"}};
  if (!origin.command.empty()) rows.emplace_back("command", origin.command);
  if (!origin.date.empty()) rows.emplace_back("date", origin.date);
  if (origin.seconds) rows.emplace_back("computing time", typeset_duration(*origin.seconds));
  return rows;
}

std::string command_text(const std::vector<std::string>& words) {
  constexpr std::string_view kPlain = "_-./=:,+@%";
  std::string line;
  for (const std::string& word : words) {
    const bool plain = !word.empty() && std::ranges::all_of(word, [&](char c) {
      return std::isalnum(static_cast<unsigned char>(c)) != 0 || kPlain.find(c) != kPlain.npos;
    });
    if (!line.empty()) line += ' ';
    if (plain) {
      line += word;
      continue;
    }
    line += '\'';
    for (const char c : word) line += c == '\'' ? "'\\''" : std::string(1, c);
    line += '\'';
  }
  return line;
}

}  // namespace quicksand
