#include "app/plot/plot_pieces.h"

#include <sstream>
#include <string_view>

#include "app/base/assets.h"
#include "app/json/json_text.h"

namespace quicksand {

PlotPieces::PlotPieces() {
  constexpr std::string_view kMark = "#% ";
  std::istringstream file(read_text(assets_folder() / "plots" / "plot.gp"));
  std::string* piece = nullptr;
  for (std::string line; std::getline(file, line);) {
    if (line.starts_with(kMark))
      piece = &pieces_[line.substr(kMark.size())];
    else if (piece != nullptr)
      *piece += (piece->empty() ? "" : "\n") + line;
  }
}

std::string PlotPieces::fill(const std::string& piece, const Values& values) const {
  std::string_view rest = pieces_.at(piece);
  std::string text;
  for (std::size_t open = rest.find("{{"); open != rest.npos; open = rest.find("{{")) {
    const std::size_t close = rest.find("}}", open);
    text += rest.substr(0, open);
    text += values.at(std::string(rest.substr(open + 2, close - open - 2)));
    rest.remove_prefix(close + 2);
  }
  return text += rest;
}

}  // namespace quicksand
