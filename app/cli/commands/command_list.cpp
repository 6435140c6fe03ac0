// quicksand list: what there is to choose from.
#include <array>
#include <cstdio>
#include <memory>

#include "app/base/assets.h"
#include "app/base/exit_code.h"
#include "app/base/nearest_name.h"
#include "app/campaign/campaign.h"
#include "app/cli/commands.h"
#include "app/commands/command_table.h"
#include "app/export/tables.h"
#include "app/play/session_reference.h"
#include "app/scene/scene_file.h"
#include "app/scene_json/scenario_json.h"
#include "app/scene_json/scene_reference.h"
#include "app/series/quantities.h"
#include "core/base/errors.h"
#include "core/base/format.h"
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

Json about(std::string_view unit, std::string_view help) {
  return {{"unit", unit}, {"help", help}};
}

// {"series": {"depth": {"unit": "d", "help": "..."}, ...}, "disks": {...}, ...}: the columns of all CSV files.
Json units() {
  Json all;
  for (const Quantity& known : quantities())
    all["series"][std::string(known.name)] = about(known.unit, known.help);
  const auto add = [&all](const DataTable& table) {
    for (const DataColumn& column : table.columns)
      for (int i = 0; i < column.size; ++i)
        all[std::string(table.name)][component_name(column, i)] = about(column.unit, column.help);
  };
  for (const DataTable& table : tables()) add(table);
  add(state_table());
  return all;
}

template <auto make>
void list_text(const CLI::App&) {
  std::fputs(make().c_str(), stdout);
}

template <auto make>
void list_json(const CLI::App&) {
  std::puts(make().dump(2).c_str());
}

std::string options_of(const CLI::App& command) {
  std::string words;
  for (const CLI::Option* option : command.get_options())
    for (const std::string& name : option->get_lnames())
      words += (words.empty() ? "--" : " --") + name;
  return words;
}

// A script that lets bash complete commands, options and, where neither fits, files.
std::string bash_completion(const CLI::App& program) {
  std::string names;
  std::string cases;
  for (const CLI::App* command : program.get_subcommands({})) {
    names += command->get_name() + " ";
    cases += "    " + command->get_name() + ") words='" + options_of(*command) + "' ;;\n";
  }
  return "# Completion of quicksand for bash, written by `quicksand list completion`.\n"
         "_quicksand() {\n"
         "  local word=${COMP_WORDS[COMP_CWORD]} words=\n"
         "  case ${COMP_WORDS[1]} in\n" +
         cases +
         "  esac\n"
         "  if [ \"$COMP_CWORD\" -eq 1 ]; then\n"
         "    words='" +
         names + options_of(program) +
         "'\n"
         "  elif [[ $word != -* ]]; then\n"
         "    words=  # files are completed by default\n"
         "  fi\n"
         "  COMPREPLY=($(compgen -W \"$words\" -- \"$word\"))\n"
         "}\n"
         "complete -o bashdefault -o default -F _quicksand quicksand\n";
}

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
     {"colours", "quantities by which grains can be coloured", list_colours},
     {"quantities", "columns of series.csv, also available in sessions", list_quantities},
     {"columns", "columns of exported tables", list_columns},
     {"units", "units of both, as JSON", list_json<units>},
     {"commands", "commands of sessions, with their arguments", list_text<commands_text>},
     {"schema", "JSON schema of scenes", list_json<scene_schema>},
     {"campaign_schema", "JSON schema of campaigns", list_json<campaign_schema>},
     {"session_schema", "JSON schema of sessions", list_json<session_schema>},
     {"scene_reference", "every key of a scene, as Markdown", list_text<scene_reference>},
     {"session_reference", "every command of sessions, as Markdown", list_text<session_reference>},
     {"completion", "option completion for bash", list_completion}});

int list(const std::string& what, const CLI::App& program) {
  if (what.empty()) {
    for (const Listing& known : kListings) std::printf("%-18s %s\n", known.name, known.help);
    return kFine;
  }
  named(kListings, what, &Listing::name, "list " + what, "cannot be listed").print(program);
  return kFine;
}

}  // namespace

Command add_list(CLI::App& program) {
  CLI::App* command = program.add_subcommand(
      "list", "List the available scenes, colours, quantities, commands and references.");
  const auto what = std::make_shared<std::string>();
  command
      ->add_option(
          "what", *what,
          joined(kListings, ", ", &Listing::name) + "; without it: these names, one per line")
      ->type_name("WHAT");
  command->footer("Examples:\n  quicksand list\n  quicksand list quantities");
  return {command, [what, &program] { return list(*what, program); }};
}

}  // namespace quicksand
