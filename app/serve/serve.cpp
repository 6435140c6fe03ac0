#include "app/serve/serve.h"

#include <cstdio>

#include "app/base/exit_code.h"
#include "app/base/interrupt.h"
#include "app/run_folder/folder_lock.h"
#include "app/run_folder/run_folder.h"
#include "app/scene/opening.h"
#include "app/serve/frame_message.h"
#include "app/serve/served_session.h"
#include "app/web/access.h"
#include "app/web/server.h"
#include "core/base/whole_file.h"
#include "render/base/external_program.h"
#include "render/base/render_error.h"
#include "render/draw/font.h"

namespace quicksand {

namespace {

// Besides the files of the page: the programs that draw, which are those of the pictures, and the letters.
PageParts all_parts() {
  PageParts parts = page_files();
  parts["/shaders.json"] = {"application/json",
                            std::make_shared<const std::string>(shaders_json().dump())};
  for (const char* name : {"Roboto-Regular.ttf", "Roboto-Medium.ttf"}) {
    try {
      const std::vector<unsigned char> font = read_font_file(name);
      parts[std::string("/") + name] = {
          "font/ttf", std::make_shared<const std::string>(font.begin(), font.end())};
    } catch (const RenderError&) {
      // The browser has other letters.
    }
  }
  return parts;
}

// Once, before there are threads: makes what draws, where this system can.
void prepare_drawing(Console& console) {
  try {
    console.draw_view(kSmallestPicture, kSmallestPicture);
  } catch (const RenderError&) {
    // The page draws without it.
  }
}

std::string address_of(const ServeOptions& options, int port, const std::string& token) {
  const bool v6 = options.address.find(':') != std::string::npos;
  const std::string host = !options.host.empty() ? options.host
                           : v6                  ? "[" + options.address + "]"
                                                 : options.address;
  return "http://" + host + ":" + std::to_string(port) + "/?token=" + token;
}

void write_recording(const std::filesystem::path& file, const ServedSession& live) {
  if (file.empty() || !live.console().session().loaded()) return;
  write_whole(file, live.recording());
  std::fprintf(stderr, "the recording is in %s; `quicksand session` replays it\n", file.c_str());
}

}  // namespace

void serve_until(const std::function<bool()>& ended, ServedSession& live,
                 const std::filesystem::path& record) {
  try {
    while (!ended()) live.take_turn();
  } catch (...) {
    write_recording(record, live);
    throw;
  }
  // First, since ending a film may fail.
  write_recording(record, live);
  live.console().finish_recording();
}

int run_serve(const ServeOptions& options) {
  const InterruptWatch watch;
  if (!options.record.empty()) try_to_write(options.record);
  const RunFolder folder{options.out.empty() ? std::filesystem::path("out") / "serve"
                                             : options.out};
  const FolderLock lock = lock_run(folder.path);
  const std::string token =
      options.token_file.empty() ? random_token() : token_of(options.token_file);
  Exchange exchange;
  ServedSession live({folder.path, options.pixels}, exchange);
  live.interrupted = [&watch] { return watch.interrupted(); };
  live.begin(opening_command(options.file));
  if (live.console().session().loaded()) prepare_drawing(live.console());
  {
    const std::string host = !options.host.empty() ? options.host : options.address;
    const Server server({.address = options.address,
                         .port = options.port,
                         .host = host,
                         .token = token,
                         .folder = folder.path},
                        all_parts(), exchange);
    const std::string address = address_of(options, server.port(), token);
    if (!is_loopback(options.address))
      std::fprintf(
          stderr,
          "quicksand: warning: other machines can reach %s, and the token travels unencrypted; "
          "an SSH tunnel to 127.0.0.1 or a proxy with TLS is safer (assets/doc/remote.md)\n",
          options.address.c_str());
    if (options.host.empty() && is_any_address(options.address))
      std::fprintf(
          stderr,
          "quicksand: warning: %s is not an address that a browser can open: browsers on other "
          "machines are refused until --host gives the name or address of this one\n",
          options.address.c_str());
    std::printf("%s\n", address.c_str());
    std::fflush(stdout);
    std::fprintf(stderr, "files are in %s; Ctrl-C stops the server\n", folder.path.c_str());
    if (options.open && !run_external({"xdg-open", address}).fine())
      std::fprintf(stderr,
                   "quicksand: xdg-open could not open a browser; open the address above in one\n");
    serve_until([&watch] { return watch.interrupted(); }, live, options.record);
  }
  return kInterrupted;
}

}  // namespace quicksand
