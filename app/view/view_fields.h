// How the packing is drawn, described once: options of the command line, `run.json`, the session's command `view` and
// the panel follow from it.
#pragma once

#include <optional>
#include <span>
#include <string_view>
#include <vector>

#include "app/json/fields.h"
#include "render/base/view.h"

namespace quicksand {

// Who has it besides sessions: runs as an option that is kept in run.json, the panel under its label.
struct ViewField {
  const char* name;   // in JSON, and of the option
  const char* help;   // a phrase
  const char* label;  // in the panel; null: not there
  bool of_runs = false;
};

struct ViewFlag {
  ViewField field;
  bool View::*value;
};
std::span<const ViewFlag> view_flags();

struct ViewNumber {
  ViewField field;
  Limits limits;
  double View::*value;
  bool (*matters)(const View& view);  // where not, the panel leaves it out
};
std::span<const ViewNumber> view_numbers();

struct ViewWord {
  ViewField field;
  std::vector<std::string_view> words;
  int (*index)(const View& view);
  void (*choose)(View& view, int index);

  std::string_view word(const View& view) const;
};
std::span<const ViewWord> view_words();

void describe_size(Fields& f, int& width, int& height);
// The part of the world that is shown: its corners "low" and "high", both or neither.
void describe_window(Fields& f, std::optional<WorldRect>& window);
void describe_view(Fields& f, View& view);
// What runs keep, the window included.
void describe_view_of_run(Fields& f, View& view);

}  // namespace quicksand
