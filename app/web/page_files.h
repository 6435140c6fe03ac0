// What the page consists of, by the address of each part: read once, so that no address leads to any other file.
#pragma once

#include <map>
#include <string>

#include "app/web/exchange.h"

namespace quicksand {

struct PagePart {
  std::string type;  // as Content-Type names it
  Payload bytes;
};
using PageParts = std::map<std::string, PagePart, std::less<>>;

// The files of assets/web by their names, and index.html as "/". Throws InputError if there is no page.
PageParts page_files();

// The type of a file by the end of its name; bytes if it is unknown.
std::string content_type(const std::string& name);

}  // namespace quicksand
