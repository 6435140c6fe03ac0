#include "app/commands/transcript.h"

#include <cerrno>
#include <chrono>
#include <filesystem>
#include <new>

#include "app/commands/command_table.h"
#include "app/run_folder/summary.h"
#include "core/base/errors.h"
#include "core/base/memory.h"
#include "core/base/whole_file.h"
#include "render/base/render_error.h"

namespace quicksand {

Answer answer_to(Console& console, const Json& command, const std::string& place) {
  Answer answer;
  const auto began = std::chrono::steady_clock::now();
  try {
    answer.result = console.perform(command, place);
    answer.ok = true;
  } catch (const InputError& error) {
    answer.malformed = true;
    // Who reads an answer tells wrong input from a failure by its place.
    answer.where = error.where().empty() ? place : error.where();
    answer.problem = error.what();
    answer.nearest = error.nearest();
    answer.file = error.file();
    if (!answer.file.empty()) answer.path = error.path();
  } catch (const CommandFailure& error) {
    answer.problem = error.what();
  } catch (const RenderError& error) {
    answer.problem = std::string("no pictures: ") + error.what();
  } catch (const NotEnoughMemory& error) {
    answer.problem = error.what();
  } catch (const std::bad_alloc&) {
    answer.problem = "there is not enough memory for this";
  } catch (const std::filesystem::filesystem_error& error) {
    answer.problem = error.what();
  }
  answer.seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - began).count();
  return answer;
}

Json to_json(const Answer& answer, const Console& console) {
  Json json = {{"ok", answer.ok}};
  if (answer.ok) {
    json["result"] = answer.result;
  } else {
    json["error"] = answer.problem;
    if (!answer.where.empty()) json["where"] = answer.where;
    if (!answer.file.empty()) json["file"] = answer.file;
    if (!answer.path.empty()) json["path"] = answer.path;
    if (!answer.nearest.empty()) json["nearest"] = answer.nearest;
  }
  if (console.session().loaded()) {
    const World& world = console.session().world();
    json["step"] = world.step;
    json["time"] = world.time;
    json["hash"] = world_hash_text(world);
  }
  return json;
}

Transcript::Transcript(std::filesystem::path path) : path_(std::move(path)), file_(path_) {
  if (!file_) refuse_to_write(path_, errno);
}

void Transcript::add(const Json& line) {
  file_ << line.dump(-1, ' ', false, Json::error_handler_t::replace) << '\n' << std::flush;
  if (!file_) throw DiskFull(path_.string(), "cannot be written; is the disk full?");
}

}  // namespace quicksand
