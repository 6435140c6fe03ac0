#include "app/cli/command_line.h"

#include <algorithm>
#include <cstdio>
#include <exception>
#include <filesystem>
#include <iostream>
#include <new>
#include <utility>

#include "app/base/build_info.h"
#include "app/base/nearest_name.h"
#include "app/cli/commands.h"
#include "app/cli/error_message.h"
#include "core/base/errors.h"
#include "core/base/memory.h"
#include "core/base/whole_file.h"
#include "render/base/render_error.h"

namespace quicksand {

namespace {

std::vector<std::string> option_names(const CLI::App& app) {
  std::vector<std::string> names;
  for (const CLI::Option* option : app.get_options()) {
    for (const std::string& name : option->get_lnames()) names.push_back("--" + name);
  }
  return names;
}

// The message for what the library does not understand, with the nearest name.
InputError explain(const CLI::ParseError& error, const CLI::App& program,
                   const std::vector<Command>& commands) {
  const CLI::App* used = &program;
  std::vector<std::string> command_names;
  for (const Command& command : commands) {
    command_names.push_back(command.app->get_name());
    if (command.app->parsed()) used = command.app;
  }
  const std::string help = " (see `quicksand " +
                           (used == &program ? std::string() : used->get_name() + " ") + "--help`)";
  for (const std::string& word : program.remaining(true)) {
    if (word.starts_with("-")) {
      const std::string option = word.substr(0, word.find('='));
      const std::vector<std::string> known = option_names(*used);
      return {
          "",
          option + " is not an option of " + used->get_name() + suggestion(option, known) + help,
          nearest_name(option, known)};
    }
    if (used == &program) {
      return {"", "\"" + word + "\" is not a command" + suggestion(word, command_names) + help,
              nearest_name(word, command_names)};
    }
    return {"", "\"" + word + "\" is one argument too many for " + used->get_name() + help};
  }
  return {"", error.what() + help};
}

// Without it no relative name says where.
void require_current_folder() {
  std::error_code error;
  if (std::filesystem::current_path(error).empty())
    throw InputError(
        "", "the current folder: " + error.message() + "; was it removed? Change to another");
}

// An empty word is most often a variable of a shell that was not set, and no wish for the default.
void refuse_empty_values(const CLI::App& app) {
  for (const CLI::Option* option : app.get_options())
    if (!option->get_positional() &&
        std::ranges::find(option->results(), "") != option->results().end())
      throw InputError(option->get_name(), "is empty");
  for (const CLI::App* used : app.get_subcommands()) refuse_empty_values(*used);
}

std::vector<Command> add_commands(CLI::App& program) {
  program.set_help_flag("-h,--help", "print this help");
  program.set_version_flag("--version", std::string("quicksand ") + build_info().version,
                           "print the version");
  program.require_subcommand(1);
  program.footer(
      "`quicksand COMMAND --help` lists the options of a command, with examples.\n\n"
      "Exit status:\n"
      "  0    success\n"
      "  1    the run failed; the message says how to continue\n"
      "  2    bad input; the message says where it is and what is allowed\n"
      "  130  interrupted; the results so far are complete\n\n"
      "Environment:\n"
      "  QUICKSAND_ASSETS         folder of the scenes and other files shipped with the program\n"
      "  QUICKSAND_MESSAGES=json  for programs: errors as JSON lines, progress overwrites one "
      "line\n\n"
      "Examples:\n"
      "  quicksand run assets/scenes/collapse.json\n"
      "  quicksand run --help");
  return {add_run(program),       add_resume(program),  add_check(program),    add_render(program),
          add_measure(program),   add_export(program),  add_campaign(program), add_report(program),
          add_reproduce(program), add_bench(program),   add_session(program),  add_window(program),
          add_serve(program),     add_compare(program), add_list(program)};
}

constexpr const char* kPurpose = "Contact dynamics of cohesive grain packings.";

// Throws InputError for what is not understood, CLI::Success for --help and --version.
template <class... Words>
void parse(CLI::App& program, const std::vector<Command>& commands, Words&&... words) {
  try {
    program.parse(std::forward<Words>(words)...);
  } catch (const CLI::Success& request) {
    // The help of the program is no answer to a question about a command that does not exist.
    if (program.get_subcommands().empty() && !program.remaining().empty())
      throw explain(request, program, commands);
    throw;
  } catch (const CLI::ParseError& error) {
    throw explain(error, program, commands);
  }
}

}  // namespace

std::string command_line_problem(const std::vector<std::string>& words) {
  CLI::App program(kPurpose, "quicksand");
  const std::vector<Command> commands = add_commands(program);
  std::vector<std::string> reversed(words.rbegin(), words.rend());  // as the library takes them
  try {
    parse(program, commands, std::move(reversed));
  } catch (const CLI::Success&) {
    return {};  // --help, --version
  } catch (const InputError& error) {
    return error.what();
  }
  return {};
}

namespace {

// The exit code of a command that has told all: what a full disk has swallowed must not pass for a result.
int told(int code) {
  std::cout.flush();  // which the help is written to
  if (std::cout.fail() || std::fflush(stdout) != 0 || std::ferror(stdout) != 0)
    return tell_failed({"disk_full", "the standard output cannot be written; is the disk full?"});
  return code;
}

}  // namespace

int run_command_line(int argc, const char* const* argv) {
  CLI::App program(kPurpose, "quicksand");
  const std::vector<Command> commands = add_commands(program);
  try {
    require_current_folder();
    parse(program, commands, argc, argv);
  } catch (const CLI::Success& request) {
    return told(program.exit(request));  // --help, --version
  } catch (const InputError& error) {
    return tell_error(error);  // not understood, or a scene that is named and is not there
  }

  try {
    refuse_empty_values(program);
    const auto called =
        std::ranges::find_if(commands, [](const Command& c) { return c.app->parsed(); });
    return told(called->run());
  } catch (const DiskFull& error) {
    return tell_failed({"disk_full", error.where() + ": " + error.what() +
                                         " When there is space again, run the same command again"});
  } catch (const InputError& error) {
    return tell_error(error);
  } catch (const RenderError& error) {
    return tell_error(InputError(
        "", std::string("no pictures: ") + error.what() + "; `run --no-frames` needs none"));
  } catch (const NotEnoughMemory& error) {
    return tell_failed({"memory", error.what()});
  } catch (const std::bad_alloc&) {
    return tell_failed({"memory", "there is not enough memory for this"});
  } catch (const std::exception& error) {
    return tell_failed({"unexpected", std::string("an unexpected error: ") + error.what()});
  }
}

}  // namespace quicksand
