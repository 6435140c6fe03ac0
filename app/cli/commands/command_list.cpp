// quicksand list: what there is to choose from.
#include <algorithm>
#include <array>
#include <cstdio>
#include <iterator>
#include <memory>

#include "app/base/assets.h"
#include "app/base/exit_code.h"
#include "app/base/nearest_name.h"
#include "app/campaign/campaign.h"
#include "app/cli/commands.h"
#include "app/cli/completion.h"
#include "app/commands/command_table.h"
#include "app/export/tables.h"
#include "app/play/session_reference.h"
#include "app/scene/scene_file.h"
#include "app/scene_json/scenario_json.h"
#include "app/scene_json/scene_reference.h"
#include "app/series/quantities.h"
#include "core/base/errors.h"
#include "render/base/view.h"

namespace quicksand {

namespace {

std::string first_sentence(const std::string& text) {
  const std::size_t end = text.find(". ");
  return end == std::string::npos ? text : text.substr(0, end + 1);
}

void print(std::string_view name, std::string_view unit, std::string_view help) {
  std::printf("%-24s %-13s %s\n", std::string(name).c_str(),
              ("[" + std::string(unit) + "]").c_str(), std::string(help).c_str());
}

void list_scenes(const CLI::App&) {
  const auto scenes = shipped_scenes();
  if (scenes.empty()) {
    throw InputError(assets_folder().string(), "has no scenes; QUICKSAND_ASSETS names the folder");
  }
  for (const auto& path : scenes) {
    std::string description;
    try {
      description = first_sentence(read_scene({path, {}, {}}).description);
    } catch (const InputError& error) {
      description = "cannot be read: " + error.where() + ": " + error.what();
    }
    std::printf("%s\n    %s\n", shipped_scene(path.stem().string()).c_str(), description.c_str());
  }
}

void list_colours(const CLI::App&) {
  for (const ColouringInfo& known : colourings()) print(known.name, known.unit, known.description);
}

void list_quantities(const CLI::App&) {
  for (const Quantity& known : quantities()) print(known.name, known.unit, known.help);
}

void list_columns(const CLI::App&) {
  const auto list = [](const DataTable& table) {
    std::printf("%s: %s\n", std::string(table.name).c_str(), std::string(table.help).c_str());
    for (const DataColumn& column : table.columns) {
      print("  " + std::string(column.name) + (column.size == 2 ? " (x, y)" : ""), column.unit,
            column.help);
    }
  };
  for (const DataTable& table : tables()) list(table);
  list(state_table());
}

void list_session_schema(const CLI::App&) { std::printf("%s\n", session_schema().dump(2).c_str()); }

void list_commands(const CLI::App&) { std::printf("%s", commands_text().c_str()); }

void list_schema(const CLI::App&) { std::printf("%s\n", scene_schema().dump(2).c_str()); }

void list_campaign_schema(const CLI::App&) {
  std::printf("%s\n", campaign_schema().dump(2).c_str());
}

void list_scene_reference(const CLI::App&) { std::fputs(scene_reference().c_str(), stdout); }

void list_session_reference(const CLI::App&) { std::fputs(session_reference().c_str(), stdout); }

void list_completion(const CLI::App& program) {
  std::fputs(bash_completion(program).c_str(), stdout);
}

struct Listing {
  const char* name;
  const char* help;
  void (*print)(const CLI::App& program);
};
constexpr auto kListings = std::to_array<Listing>(
    {{"scenes", "example scenes", list_scenes},
     {"colours", "what grains can be coloured by", list_colours},
     {"quantities", "columns of series.csv, which sessions can ask for", list_quantities},
     {"columns", "columns of exported tables", list_columns},
     {"commands", "commands of sessions, with their arguments", list_commands},
     {"schema", "JSON schema of scenes", list_schema},
     {"campaign_schema", "JSON schema of campaigns", list_campaign_schema},
     {"session_schema", "JSON schema of sessions", list_session_schema},
     {"scene_reference", "every key of a scene, as Markdown", list_scene_reference},
     {"session_reference", "every command of sessions, as Markdown", list_session_reference},
     {"completion", "completion of options for bash", list_completion}});

std::string listing_names() {
  std::string names;
  for (const Listing& known : kListings)
    names += (names.empty() ? "" : ", ") + std::string(known.name);
  return names;
}

int list(const std::string& what, const CLI::App& program) {
  if (what.empty()) {
    for (const Listing& known : kListings) std::printf("%-18s %s\n", known.name, known.help);
    return kFine;
  }
  const auto known = std::ranges::find(kListings, what, &Listing::name);
  if (known == kListings.end()) {
    std::vector<std::string> names;
    std::ranges::transform(kListings, std::back_inserter(names), &Listing::name);
    throw InputError("list " + what, "is nothing that can be listed" + suggestion(what, names));
  }
  known->print(program);
  return kFine;
}

}  // namespace

Command add_list(CLI::App& program) {
  CLI::App* command = program.add_subcommand(
      "list",
      "List what there is to choose from: scenes, colours, quantities, commands, references.");
  const auto what = std::make_shared<std::string>();
  command->add_option("what", *what, listing_names() + "; without it: all of them, in a line each")
      ->type_name("WHAT");
  command->footer("Examples:\n  quicksand list\n  quicksand list quantities");
  return {command, [what, &program] { return list(*what, program); }};
}

}  // namespace quicksand
