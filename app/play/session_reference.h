// The page of all commands of a session: `quicksand list session_reference`,
// assets/doc/session_reference.md.
#pragma once

#include <string>

namespace quicksand {

// Markdown, made of the command table.
std::string session_reference();

}  // namespace quicksand
