#include "app/report/provenance.h"

#include "app/base/build_info.h"
#include "app/base/machine.h"
#include "app/base/shell_text.h"
#include "app/base/status_line.h"
#include "core/base/format.h"

namespace quicksand {

std::vector<std::pair<std::string, std::string>> provenance(const std::string& command,
                                                            std::optional<double> seconds) {
  const BuildInfo& build = build_info();
  const Machine computer = machine();
  std::vector<std::pair<std::string, std::string>> rows{
      {"program", "quicksand " + build.version +
                      (build.commit == "unknown" ? "" : ", commit " + build.commit)},
      {"compiler", build.compiler + ", " + build.build_type},
      {"machine", computer.processor + ", " + std::to_string(computer.cores) + " cores"},
      {"command", command}};
  if (seconds) rows.emplace_back("computing time", duration_text(*seconds));
  return rows;
}

std::string command_text(const std::vector<std::string>& words) {
  return joined(words, " ", shell_text);
}

}  // namespace quicksand
