#include "app/base/shell_text.h"

#include <cstdlib>

namespace quicksand {

std::string shell_text(const std::filesystem::path& path) {
  std::string text = path.string();
  constexpr const char* kPlain =
      "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789/._-+=:,@%";
  if (!text.empty() && text.find_first_not_of(kPlain) == std::string::npos) return text;
  std::string result = "'";
  for (const char c : text) result += c == '\'' ? std::string("'\\''") : std::string(1, c);
  return result + "'";
}

std::string program_name() {
  const char* name = std::getenv("QUICKSAND_COMMAND");
  return name != nullptr && *name != '\0' ? shell_text(name) : "quicksand";
}

}  // namespace quicksand
